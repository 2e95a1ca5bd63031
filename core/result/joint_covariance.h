// Joint covariance matrix of points whose coordinates are quantities of one result.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "core/result/uncertainty_result.h"

namespace covaria {

/// Three quantities of a result that are the coordinates of a point, along axes of their own.
struct PointCoordinates {
    enum class Kind { inputs, outputs };
    Kind kind = Kind::outputs;
    std::array<std::size_t, 3> index = {};  ///< indices of the result's input or output quantities
    Eigen::Matrix3d R_WQ = Eigen::Matrix3d::Identity();
    bool operator==(const PointCoordinates&) const = default;
};

/// Reads many points of one result, which must stay; correlations between components are resolved once.
class JointCovariance {
public:
    explicit JointCovariance(const UncertaintyResult& result);
    /// 3n x 3n along the axes of W, in the square of the quantities' SI unit (JCGM 102 6.2: U_y = C U_x C^T).
    /// Of output quantities alone it is the covariance of the result (Monte Carlo where it ran); where input
    /// quantities are among them it is that of the law of propagation, through the components that they
    /// share. Empty where an index is out of range or an entry is not finite.
    std::optional<Eigen::MatrixXd> of(const std::vector<PointCoordinates>& points) const;

private:
    bool has(const PointCoordinates& point) const;
    std::optional<Eigen::MatrixXd> of_outputs(const std::vector<PointCoordinates>& points) const;
    std::optional<Eigen::MatrixXd> of_components(const std::vector<PointCoordinates>& points) const;
    /// dq/d epsilon_j of one quantity.
    Eigen::RowVectorXd sensitivities(PointCoordinates::Kind kind, std::size_t quantity) const;

    const UncertaintyResult& result_;
    std::vector<double> u_;  ///< u of the components; 0 where held
    std::vector<ComponentCorrelation> correlations_;
};

}  // namespace covaria
