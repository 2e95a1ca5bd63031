// Figures of the cycles of a robot: barycentres, RP and its law, distances, and which series belong together.
#pragma once

#include <string>
#include <vector>

#include "core/kinds/sheets/repeatability_law.h"
#include "core/kinds/sheets/robot_poses_setup.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria::sheets {

/// RP as ISO 9283 defines it, with its law for these cycles and this scatter.
struct SeenRepeatability {
    double rp = 0.0;
    RepeatabilityLaw law;
    double best_rp() const { return rp * law.mean_factor(); }  ///< RP with few cycles allowed for
    double u_rp() const { return rp * law.u_factor(); }
};

struct SeriesFigures : SeenRepeatability {
    Eigen::Vector3d barycentre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< covariance of a single cycle
    Eigen::Vector3d angles = Eigen::Vector3d::Zero();      ///< mean deviation
    Eigen::Vector3d s_angles = Eigen::Vector3d::Zero();
    std::size_t pose = 0;  ///< index of its commanded pose
    double ap(const PoseSeries& series) const { return (barycentre - series.commanded).norm(); }
    /// Standard uncertainty of AP along its direction, from the scatter of the cycles.
    double u_ap(const PoseSeries& series) const;
    /// Mean AP of a robot whose barycentre would be right with infinitely many cycles.
    double floor_of_ap(const PoseSeries& series) const;
};

struct DistanceFigures {
    std::string label;
    double commanded = 0.0, mean = 0.0, s = 0.0;
    int cycles = 0;
};

struct RobotPosesFigures {
    std::vector<SeriesFigures> series;
    std::vector<DistanceFigures> distances;
    std::optional<SeenRepeatability> instrument;  ///< of a target that does not move
    /// Whether RP of each series leaves something for the robot when that of the instrument is taken out.
    std::vector<bool> is_split;
    std::vector<std::vector<std::size_t>>
        directions;                                ///< series of one pose and time from several directions
    std::vector<std::vector<std::size_t>> drifts;  ///< series of one pose and direction, by rising time
};

RobotPosesFigures figures_of(const RobotPosesSetup& setup);

std::vector<Table> robot_poses_tables(const RobotPosesSetup& setup, const RobotPosesFigures& figures);
std::vector<PlotSpecification> robot_poses_plots(const RobotPosesSetup& setup,
                                                 const RobotPosesFigures& figures);

}  // namespace covaria::sheets
