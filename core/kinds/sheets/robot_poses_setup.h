// The set-up of "accuracy and repeatability of poses": attained poses of a robot, cycle by cycle.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/setup/fields.h"

namespace covaria::sheets {

using OptionalAngles = std::array<std::optional<double>, 3>;

struct AttainedPose {
    std::string pose;
    std::string direction;       ///< direction of approach; empty: one for all
    std::optional<double> time;  ///< since warm-up began, for drift
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    OptionalAngles angles = {};
};

struct CommandedPose {
    std::string pose;
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    OptionalAngles angles = {};
};

struct PosePair {
    std::string from, to;
};

struct FixedTarget {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

enum class InstrumentScatter { none, stated, readings };

/// Cycles of one pose, from one direction, at one time.
struct PoseSeries {
    std::string pose, direction;
    std::optional<double> time;
    Eigen::MatrixX3d points;
    Eigen::MatrixX3d angles;  ///< less the commanded ones, in (-pi, pi]; no rows: not measured
    Eigen::Vector3d commanded = Eigen::Vector3d::Zero();
    int cycles() const { return int(points.rows()); }
};

struct RobotPosesSetup {
    std::vector<CommandedPose> commanded;
    std::vector<AttainedPose> attained;
    std::vector<PosePair> pairs;  ///< distances between poses
    double u_place = 0.0;         ///< u of a measured coordinate, shared by the cycles of a pose
    InstrumentScatter instrument = InstrumentScatter::none;
    double instrument_rp = 0.0;
    int instrument_cycles = 0;
    std::vector<FixedTarget> fixed_target;
    std::optional<double> expanded_u;     ///< U of the instrument, for the rule of the largest ratio
    std::optional<double> largest_ratio;  ///< largest ratio of it to AP or RP
    std::optional<double> rated_ap, rated_rp;
    double probability = 0.95;  ///< probability of a decision, and the quantile of AP over the poses

    std::vector<PoseSeries> series;
    bool has_angles() const { return !series.empty() && series.front().angles.rows() > 0; }
};

const Fields<RobotPosesSetup>& robot_poses_fields();
std::optional<RobotPosesSetup> read_robot_poses_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                      Problems& problems);
/// "P1", "P1, from above", "P1, from above, 2 h".
std::string label_of(const PoseSeries& series);

}  // namespace covaria::sheets
