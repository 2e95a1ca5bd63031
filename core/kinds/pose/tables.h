// Fit of measured points to the nominal coordinates of a least-squares frame: residuals, redundancy,
// tests.
#pragma once

#include <optional>

#include "core/kinds/pose/setup.h"
#include "core/quantity/input_quantity.h"
#include "core/text/table.h"

namespace covaria::pose {

/// The points of one frame in one set ("base" or a pose) against their nominal coordinates. Vectors lie along
/// the axes of the frame.
struct FrameFit {
    std::string set;
    std::vector<std::string> names;
    std::vector<Eigen::Vector3d> residual;    ///< measured less nominal, m
    std::vector<Eigen::Vector3d> u_residual;  ///< u of the residuals as stated; 0: not tested
    std::vector<Eigen::Vector3d> redundancy;  ///< share of an error of the coordinate that stays visible
    double rms = 0.0;                         ///< root mean square of the distances, m
    double chi_square = 0.0;
    int degrees_of_freedom = 0;  ///< 0: nothing to test (no stated uncertainty, or too many points)

    /// Another reason that would make the points fit, where it leaves a third of the residuals or less.
    struct Explanation {
        double rms = 0.0;
        std::optional<std::pair<std::size_t, std::size_t>> exchanged;  ///< empty: frame 0 mirrored
    };
    std::optional<Explanation> explanation;

    double probability() const;  ///< of a larger chi-square, if all is as stated
    double normalised(std::size_t point, int axis) const;
};

/// The fits of every least-squares frame of an evaluation of measured points; none a priori.
std::vector<FrameFit> frame_fits(const PoseSetup& setup, const InputSet& inputs);

/// The fits, and their residuals point by point.
std::vector<Table> fit_tables(const std::vector<FrameFit>& fits);

/// Warns of every set whose residuals are larger than the stated uncertainties allow (1 % for all sets
/// together), and of what would explain them: two names exchanged, frame 0 left-handed. `can_be_seen`: where
/// nothing explains them, the way out is uncertainties as seen.
void warn_of_misfits(const std::vector<FrameFit>& fits, Problems& problems, bool can_be_seen);

}  // namespace covaria::pose
