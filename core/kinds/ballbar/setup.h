// The set-up of "TCP from ballbars", read and checked: where the ball is at each point, and how the tool
// follows.
//
// Frames: R the robot's, B the ballbars', F the flange's at zero rotation. Points are in B.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/ballbar/repeatability.h"
#include "core/model/asset.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/setup_schema.h"

namespace covaria::tcp {

/// Enough for any procedure that a robot is put through, and for arrays on the stack of the inner loop.
inline constexpr std::size_t most_points = 200;

enum class Task {
    plan,      ///< the tool from a planned procedure
    measured,  ///< the tool from given points
    points,    ///< no tool: the points alone
};

/// Which axes of the flange are taken as measured; the others complete a right-handed frame.
struct FrameRule {
    const char* key;
    const char* title;
    int first;   ///< axis taken as measured, -1: all alike (nearest orthogonal axes)
    int second;  ///< preferred axis that, with it, spans a plane of the frame
};
inline constexpr FrameRule frame_rules[] = {{"y-first", "y as measured, x nearest to measured", 1, 0},
                                            {"x-first", "x as measured, y nearest to measured", 0, 1},
                                            {"z-first", "z as measured, x nearest to measured", 2, 0},
                                            {"symmetric", "nearest to all measured axes", -1, -1}};

struct Point {
    std::string name;    ///< "x 3"; also the group of its outputs
    std::string label;   ///< as part of a symbol
    std::string source;  ///< place in the set-up
    Eigen::Vector3d p_B = Eigen::Vector3d::Zero();
    double angle = 0.0;  ///< commanded rotation from the zero pose
    double cosine = 1.0, sine = 0.0;
    std::array<double, most_supports> length{};       ///< to the supports, at the estimates
    std::array<double, most_supports> weights{};      ///< of them, when there are more than three
    Eigen::Matrix3d lever = Eigen::Matrix3d::Zero();  ///< displacement by small rotations of the flange
    std::size_t reading = 0, position = 0, orientation = 0;  ///< first input quantity of each
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

struct TcpSetup {
    Task task = Task::plan;
    std::shared_ptr<const Asset> instrument, robot;  ///< robot may be null
    std::string instrument_id, instrument_name, robot_id, robot_name;
    std::vector<Point> points;
    std::vector<Sequence> sequences;
    std::vector<Eigen::Vector3d> supports;  ///< in B
    FrameRule frame = frame_rules[0];
    int first_axis = 1, second_axis = 0;  ///< of the frame rule, among the measured ones
    bool geometric_sphere = true;
    Eigen::Isometry3d X_BF = Eigen::Isometry3d::Identity();  ///< flange at zero rotation
    Eigen::Vector3d tool_F = Eigen::Vector3d::Zero();
    bool turns = false;  ///< the robot's orientation scatters too

    const BallbarSource& ballbars() const { return *offers<BallbarSource>(instrument); }
    const RepeatabilitySource* repeatability() const {
        return robot ? offers<RepeatabilitySource>(robot) : nullptr;
    }
    bool finds_tool() const { return task != Task::points; }
    bool measures(int axis) const;
};

SetupSchema tcp_schema();

/// Empty if `problems` got an error.
std::optional<TcpSetup> read_tcp_setup(const SetupReader& setup, const AssetLibrary& assets,
                                       Problems& problems);
/// Refuses what cannot work (one arc, no circle, wrong side), warns of what works badly (short arcs).
void check_tcp_setup(const TcpSetup& setup, Problems& problems);

/// Flange, tool and circles from given points.
void fit_measured_points(TcpSetup& setup, Problems& problems);

/// Gives every point the places of its input quantities.
InputSet tcp_inputs(TcpSetup& setup);

std::vector<DataTable> tcp_evaluation(const TcpSetup& setup);
Layout tcp_layout(const TcpSetup& setup);

inline constexpr char axis_letters[] = "xyz";

/// Where outputs begin. With a tool: x, y, z of it; two angles for each measured axis; the flange's centre;
/// then the points. Without: the points.
struct OutputPlaces {
    std::size_t angles = 3, centre = 3, points = 0;
    explicit OutputPlaces(const TcpSetup& setup) {
        if (!setup.finds_tool()) return;
        centre = angles + 2 * setup.sequences.size();
        points = centre + 3;
    }
};

}  // namespace covaria::tcp
