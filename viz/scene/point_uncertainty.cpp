// Covariance matrices of points and their coverage ellipsoids.
#include "viz/scene/point_uncertainty.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/math/special_quantiles.h"

namespace covaria {
namespace {

template <class Range>
bool in_range(const std::array<std::size_t, 3>& index, const Range& range) {
    return std::all_of(index.begin(), index.end(), [&](std::size_t i) { return i < range.size(); });
}

}  // namespace

PointUncertainties::PointUncertainties(const UncertaintyResult* result,
                                       const std::vector<LinkedPoint>* linked)
    : result_(result), linked_(linked) {
    if (result_) joint_.emplace(*result_);
}

std::optional<PointUncertainty> PointUncertainties::of(const LayoutPoint& point) const {
    if (!result_) return std::nullopt;
    std::optional<PointUncertainty> found;
    if (point.outputs && in_range(*point.outputs, result_->outputs))
        found = of_outputs(*point.outputs);
    else if (point.inputs && in_range(*point.inputs, result_->inputs->quantities))
        found = of_inputs(*point.inputs);
    else if (point.links)
        found = of_links(*point.links);
    if (found && !found->covariance.allFinite()) return std::nullopt;
    return found;
}

std::optional<Eigen::Vector3d> PointUncertainties::estimates_of(const LayoutPoint& point) const {
    if (!result_) return std::nullopt;
    Eigen::Vector3d estimates;
    if (point.outputs && in_range(*point.outputs, result_->outputs)) {
        for (std::size_t i = 0; i < 3; ++i)
            estimates[static_cast<Eigen::Index>(i)] =
                result_->outputs[(*point.outputs)[i]].first_order.estimate;
        return estimates;
    }
    if (point.inputs && in_range(*point.inputs, result_->inputs->quantities)) {
        for (std::size_t i = 0; i < 3; ++i)
            estimates[static_cast<Eigen::Index>(i)] = estimate_of(result_->inputs, (*point.inputs)[i]);
        return estimates;
    }
    return std::nullopt;
}

std::optional<PointUncertainty> PointUncertainties::of_outputs(
    const std::array<std::size_t, 3>& index) const {
    PointUncertainty found;
    found.of_outputs = true;
    const OutputCovariance& covariance = result_->covariance;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(index[i]);
        if (row >= covariance.rows()) return std::nullopt;
        const auto at = static_cast<Eigen::Index>(i);
        for (std::size_t j = 0; j < 3; ++j)
            found.covariance(at, static_cast<Eigen::Index>(j)) =
                covariance(row, static_cast<Eigen::Index>(index[j]));
        found.u[at] = result_->outputs[index[i]].standard_uncertainty;
        found.U[at] = result_->outputs[index[i]].expanded_uncertainty;
    }
    return found;
}

std::optional<PointUncertainty> PointUncertainties::of_inputs(const std::array<std::size_t, 3>& index) const {
    const auto covariance = joint_->of({{PointCoordinates::Kind::inputs, index}});
    if (!covariance) return std::nullopt;
    return of_covariance(*covariance);
}

std::optional<PointUncertainty> PointUncertainties::of_links(const std::array<std::size_t, 3>& links) const {
    if (!linked_) return std::nullopt;
    const auto point = std::ranges::find(*linked_, links, &LinkedPoint::links);
    if (point == linked_->end()) return std::nullopt;
    return of_covariance(point->covariance);
}

PointUncertainty PointUncertainties::of_covariance(const Eigen::Matrix3d& covariance) const {
    PointUncertainty found;
    found.covariance = covariance;
    found.u = found.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const double p = std::clamp(result_->coverage_probability, 0.01, 0.999999);
    found.U = found.u * t_quantile((1 + p) / 2, infinity);
    return found;
}

LayoutPoint point_before(const LayoutPoint& point, const ResultComparison& compared) {
    LayoutPoint earlier = point;
    const auto outputs_before = [&](std::size_t& index) {
        const auto same = std::find_if(compared.outputs.begin(), compared.outputs.end(),
                                       [&](const ComparedOutput& o) { return o.after == index; });
        if (same == compared.outputs.end() || !same->before) return false;
        index = *same->before;
        return true;
    };
    const auto input_before = [&](std::size_t& index) {
        const auto& quantities = compared.after->inputs->quantities;
        index = index < quantities.size() ? compared.before->inputs->find(quantities[index].symbol)
                                          : InputSet::npos;
        return index != InputSet::npos;
    };
    if (earlier.outputs && !std::ranges::all_of(*earlier.outputs, outputs_before)) earlier.outputs.reset();
    if (earlier.inputs && !std::ranges::all_of(*earlier.inputs, input_before)) earlier.inputs.reset();
    return earlier;
}

std::optional<PointCoordinates> coordinates_of(const LayoutPoint& point) {
    using Kind = PointCoordinates::Kind;
    if (point.outputs) return PointCoordinates{Kind::outputs, *point.outputs, point.R_WQ};
    if (point.inputs) return PointCoordinates{Kind::inputs, *point.inputs, point.R_WQ};
    return std::nullopt;
}

CoverageEllipsoid coverage_ellipsoid(const Eigen::Matrix3d& covariance, double probability) {
    CoverageEllipsoid ellipsoid;
    if (!covariance.allFinite()) return ellipsoid;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver((covariance + covariance.transpose()) / 2);
    if (solver.info() != Eigen::Success) return ellipsoid;
    const double largest = solver.eigenvalues()[2];
    if (!(largest > 0)) return ellipsoid;
    // A ratio of semi-axes below 1e-5 cannot be seen, and is rounding where the true value is zero.
    while (ellipsoid.rank < 3 && solver.eigenvalues()[2 - ellipsoid.rank] > 1e-10 * largest) ++ellipsoid.rank;
    const double p = std::clamp(probability, 1e-6, 1 - 1e-12);
    ellipsoid.coverage_factor = std::sqrt(chi_squared_quantile(p, ellipsoid.rank));
    for (int i = 0; i < ellipsoid.rank; ++i) {
        Eigen::Vector3d direction = solver.eigenvectors().col(2 - i);
        Eigen::Index longest = 0;
        direction.cwiseAbs().maxCoeff(&longest);
        if (direction[longest] < 0) direction = -direction;
        ellipsoid.axes.col(i) =
            ellipsoid.coverage_factor * std::sqrt(solver.eigenvalues()[2 - i]) * direction;
    }
    return ellipsoid;
}

}  // namespace covaria
