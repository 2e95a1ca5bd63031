// Covariance matrix of a point from a result: of output quantities, or of input quantities.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "core/model/layout.h"
#include "core/project/links.h"
#include "core/result/comparison.h"
#include "core/result/joint_covariance.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

struct PointUncertainty {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< along the axes of the quantities, m^2
    Eigen::Vector3d u = Eigen::Vector3d::Zero();
    Eigen::Vector3d U = Eigen::Vector3d::Zero();
    bool of_outputs = false;
};

/// Reads many points of one result.
class PointUncertainties {
public:
    /// Both may be null. `linked`: points whose coordinates the analysis takes from others.
    explicit PointUncertainties(const UncertaintyResult* result,
                                const std::vector<LinkedPoint>* linked = nullptr);
    /// Empty where the point has no quantities, or their uncertainty is unknown or not finite.
    std::optional<PointUncertainty> of(const LayoutPoint& point) const;
    /// Estimates of the point's three quantities.
    std::optional<Eigen::Vector3d> estimates_of(const LayoutPoint& point) const;

private:
    std::optional<PointUncertainty> of_outputs(const std::array<std::size_t, 3>& index) const;
    std::optional<PointUncertainty> of_inputs(const std::array<std::size_t, 3>& index) const;
    std::optional<PointUncertainty> of_links(const std::array<std::size_t, 3>& links) const;
    PointUncertainty of_covariance(const Eigen::Matrix3d& covariance) const;
    const UncertaintyResult* result_;
    const std::vector<LinkedPoint>* linked_;
    std::optional<JointCovariance> joint_;
};

/// The point with the quantities of `compared.before` that are those of `compared.after`; without quantities
/// where one of them was not there.
LayoutPoint point_before(const LayoutPoint& point, const ResultComparison& compared);

/// The quantities that are a point's coordinates; empty: it has none.
std::optional<PointCoordinates> coordinates_of(const LayoutPoint& point);

/// Ellipsoid { axes * s, |s| <= 1 } that holds a normal vector with this covariance with probability p
/// (JCGM 102 7.7.2, k_p^2 = quantile of chi-squared with as many degrees of freedom as the rank).
struct CoverageEllipsoid {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  ///< columns, longest first
    int rank = 0;
    double coverage_factor = 0.0;
};
CoverageEllipsoid coverage_ellipsoid(const Eigen::Matrix3d& covariance, double probability);

}  // namespace covaria
