// The set-up of "TCP from ballbars", read and checked: where the ball is at each point, and how the tool
// follows.
//
// Frames: R the robot's, B the ballbars', F the flange's at zero rotation. Points are in B.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evidence/as_seen.h"
#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/ballbar/repeatability.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria::tcp {

/// Enough for any procedure that a robot is put through, and for arrays on the stack of the inner loop.
inline constexpr std::size_t most_points = 200;

enum class Task {
    plan,      ///< the tool from a planned procedure
    measured,  ///< the tool from given points
    points,    ///< no tool: the points alone
    lengths,   ///< no tool: the points alone, by measured lengths
};

/// Rule for which axes of the flange are taken as measured; the others complete a right-handed frame.
struct FrameRule {
    const char* key;
    const char* title;
    int first;   ///< axis taken as measured, -1: all alike (nearest orthogonal axes)
    int second;  ///< preferred axis that, with it, spans a plane of the frame
    bool operator==(const FrameRule& other) const { return key == other.key; }
};
inline constexpr FrameRule frame_rules[] = {{"y-first", "y as measured, x nearest to measured", 1, 0},
                                            {"x-first", "x as measured, y nearest to measured", 0, 1},
                                            {"z-first", "z as measured, x nearest to measured", 2, 0},
                                            {"symmetric", "nearest to all measured axes", -1, -1}};

struct Point {
    std::string name;    ///< "x 3"; also the group of its outputs
    std::string label;   ///< part of a symbol
    std::string source;  ///< place in the set-up
    Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
    double angle = 0.0;  ///< commanded rotation from the zero pose
    double cosine = 1.0, sine = 0.0;
    std::array<double, most_supports> length{};       ///< lengths to the supports, at the estimates
    std::array<double, most_supports> misfit{};       ///< measured lengths less these; 0 where none are given
    std::array<double, most_supports> weights{};      ///< set when there are more than three
    Eigen::Matrix3d lever = Eigen::Matrix3d::Zero();  ///< displacement by small rotations of the flange
};

/// Points of one rotation about an axis of the flange (0, 1, 2 = x, y, z).
struct Sequence {
    int axis = 0;
    std::size_t first = 0, count = 0;
    double sum_cosine = 0.0, sum_sine = 0.0;
    double span = 0.0;
    double radius = 0.0;
    std::string source;
};

/// The set-up as typed, SI. Axes 0, 1, 2 are x, y, z of the flange.
struct StatedTcp {
    struct Rotation {
        int axis = 0;
        double start = 0.0, span = 0.0;
        int points = 0;
    };
    struct Measured {
        int axis = 0;
        double angle = 0.0;
        Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
    };
    struct Place {
        std::string name;
        Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
    };
    struct Length {
        std::string point;
        int bar = 0;  ///< counted from 1
        double length = 0.0;
    };
    Offered<BallbarSource> ballbars;
    Offered<RepeatabilitySource> robot;  ///< may be empty
    Task task = Task::plan;
    Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();
    double tool_x = 0.0, tool_y = 0.0, tool_z = 0.0;
    std::vector<Rotation> rotations;
    std::vector<Measured> measured;
    std::vector<Place> places;
    std::vector<Length> lengths;
    evidence::UncertaintiesFrom uncertainties = evidence::UncertaintiesFrom::stated;
    FrameRule frame = frame_rules[0];
    bool geometric_sphere = true;
};
const Fields<StatedTcp>& tcp_fields();

struct TcpSetup : StatedTcp {
    explicit TcpSetup(StatedTcp stated) : StatedTcp(std::move(stated)) {}
    std::vector<Point> points;
    std::vector<Sequence> sequences;
    std::vector<Eigen::Vector3d> supports;                   ///< places in B
    int first_axis = 1, second_axis = 0;                     ///< of the frame rule, among the measured axes
    Eigen::Isometry3d X_BF = Eigen::Isometry3d::Identity();  ///< flange at zero rotation
    Eigen::Vector3d tool_F = Eigen::Vector3d::Zero();
    bool turns = false;  ///< the robot's orientation scatters too

    bool finds_tool() const { return task == Task::plan || task == Task::measured; }
    bool has_lengths() const { return task == Task::lengths; }
    bool measures(int axis) const;
};

/// Empty if `problems` got an error.
std::optional<TcpSetup> read_tcp_setup(const SetupReader& setup, const AssetLibrary& assets,
                                       Problems& problems);
/// Refuses what cannot work (one arc, no circle, wrong side), warns of what works badly (short arcs).
void check_tcp_setup(const TcpSetup& setup, Problems& problems);

/// Points where their measured lengths meet, by least squares with the weights of these.
void take_lengths(TcpSetup& setup, Problems& problems);
/// Lengths of a point at its place, and their weights 1/u² as they are read there; no uncertainty at all
/// counts as the limit of a small one.
void weigh(const TcpSetup& setup, Point& point);

/// Flange, tool and circles from given points.
void fit_measured_points(TcpSetup& setup, Problems& problems);

/// First input quantity of each kind that a point has.
struct PointInputs {
    std::size_t reading = 0, position = 0, orientation = 0;
};
struct TcpInputs {
    InputSet set;
    std::vector<PointInputs> of_points;
};
TcpInputs tcp_inputs(const TcpSetup& setup);

std::vector<Table> tcp_evaluation(const TcpSetup& setup);
Layout tcp_layout(const TcpSetup& setup);

inline constexpr char axis_letters[] = "xyz";

/// First indices of the outputs. With a tool: x, y, z of it; two angles for each measured axis; the flange's
/// centre; then the points. Without: the points.
struct OutputPlaces {
    std::size_t angles = 3, centre = 3, points = 0;
    explicit OutputPlaces(const TcpSetup& setup) {
        if (!setup.finds_tool()) return;
        centre = angles + 2 * setup.sequences.size();
        points = centre + 3;
    }
};

}  // namespace covaria::tcp
