// Covariances of outputs as the result has them, of inputs through the components they share.
#include "core/result/joint_covariance.h"

#include <algorithm>
#include <utility>

namespace covaria {

JointCovariance::JointCovariance(const UncertaintyResult& result) : result_(result) {
    for (const UncertaintyComponent& component : result.inputs->components)
        u_.push_back(component.held ? 0.0 : component.distribution.standard_uncertainty());
    if (auto correlations = resolved_correlations(result.inputs)) correlations_ = std::move(*correlations);
}

bool JointCovariance::has(const PointCoordinates& point) const {
    const std::size_t count = point.kind == PointCoordinates::Kind::outputs
                                  ? result_.outputs.size()
                                  : result_.inputs->quantities.size();
    return std::all_of(point.index.begin(), point.index.end(), [&](std::size_t i) { return i < count; });
}

std::optional<Eigen::MatrixXd> JointCovariance::of(const std::vector<PointCoordinates>& points) const {
    if (!std::all_of(points.begin(), points.end(), [this](const auto& point) { return has(point); }))
        return std::nullopt;
    const bool outputs_alone = std::all_of(points.begin(), points.end(), [](const PointCoordinates& point) {
        return point.kind == PointCoordinates::Kind::outputs;
    });
    auto covariance = outputs_alone ? of_outputs(points) : of_components(points);
    if (!covariance) return std::nullopt;
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(covariance->rows(), covariance->cols());
    for (std::size_t i = 0; i < points.size(); ++i)
        R.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * i)) = points[i].R_WQ;
    Eigen::MatrixXd turned = R * *covariance * R.transpose();
    if (!turned.allFinite()) return std::nullopt;
    return turned;
}

std::optional<Eigen::MatrixXd> JointCovariance::of_outputs(
    const std::vector<PointCoordinates>& points) const {
    const OutputCovariance& all = result_.covariance;
    if (all.rows() != static_cast<Eigen::Index>(result_.outputs.size())) return std::nullopt;
    std::vector<std::size_t> rows;
    for (const PointCoordinates& point : points)
        rows.insert(rows.end(), point.index.begin(), point.index.end());
    // The trials of thousands of outputs keep no pair of two groups: the law of propagation has all.
    const auto block_of = [&](std::size_t row) {
        return all.blocks().block_of(static_cast<Eigen::Index>(row));
    };
    const bool in_one_block = std::all_of(
        rows.begin(), rows.end(), [&](std::size_t row) { return block_of(row) == block_of(rows.front()); });
    return in_one_block ? all.among(rows) : of_components(points);
}

Eigen::RowVectorXd JointCovariance::sensitivities(PointCoordinates::Kind kind, std::size_t quantity) const {
    Eigen::RowVectorXd c = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(u_.size()));
    const auto add = [&](std::size_t component, double factor) {
        if (component < u_.size()) c[static_cast<Eigen::Index>(component)] += factor;
    };
    if (kind == PointCoordinates::Kind::inputs)
        for (const Share& share : result_.inputs->quantities[quantity].shares)
            add(share.component, share.factor);
    else
        for (const BudgetRow& row : result_.budget.rows[quantity]) add(row.component, row.sensitivity);
    return c;
}

std::optional<Eigen::MatrixXd> JointCovariance::of_components(
    const std::vector<PointCoordinates>& points) const {
    Eigen::MatrixXd c(static_cast<Eigen::Index>(3 * points.size()), static_cast<Eigen::Index>(u_.size()));
    Eigen::Index next = 0;
    for (const PointCoordinates& point : points)
        for (const std::size_t i : point.index) {
            if (point.kind == PointCoordinates::Kind::outputs && i >= result_.budget.rows.size())
                return std::nullopt;
            c.row(next++) = sensitivities(point.kind, i);
        }
    for (Eigen::Index j = 0; j < c.cols(); ++j)  // an infinite u elsewhere must not give NaN here
        c.col(j) *= c.col(j).isZero(0) ? 0.0 : u_[static_cast<std::size_t>(j)];
    Eigen::MatrixXd covariance = c * c.transpose();
    for (const ComponentCorrelation& r : correlations_) {
        const auto first = static_cast<Eigen::Index>(r.first), second = static_cast<Eigen::Index>(r.second);
        if (std::max(first, second) >= c.cols()) continue;
        const Eigen::MatrixXd cross = r.coefficient * c.col(first) * c.col(second).transpose();
        covariance += cross + cross.transpose();
    }
    return covariance;
}

}  // namespace covaria
