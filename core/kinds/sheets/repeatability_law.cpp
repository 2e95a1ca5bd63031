#include "core/kinds/sheets/repeatability_law.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/math/normal_quantile.h"
#include "core/math/special_quantiles.h"

namespace covaria::sheets {

namespace {

constexpr std::size_t cells_of_a_law = 100;
constexpr std::uint64_t seed_of_campaigns = 9283;
constexpr int most_simulated_cycles = 300;

/// Cells of equal probability between rising edges; those of no width are given one.
Distribution between(std::vector<double> edges) {
    for (std::size_t k = 1; k < edges.size(); ++k)
        edges[k] = std::max(edges[k], edges[k - 1] + 1e-9 * edges.front());
    const double share = 1.0 / double(edges.size() - 1);
    std::vector<double> probabilities(edges.size() - 1, share);
    return Distribution::of(StatedHistogram{std::move(edges), std::move(probabilities)});
}

/// RP of one campaign after the other: the standard normal coordinates of all cycles times the deviations.
class Campaigns {
public:
    Campaigns(const Eigen::Vector3d& deviations, int cycles)
        : deviations_(deviations), points_(cycles, 3), draws_(std::size_t(cycles)) {}

    double next() {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            for (double& u : draws_) u = (double(generator_() >> 11) + 0.5) * 0x1p-53;
            normal_quantiles(draws_, draws_);
            for (Eigen::Index i = 0; i < points_.rows(); ++i)
                points_(i, axis) = deviations_[axis] * draws_[std::size_t(i)];
        }
        return repeatability(points_);
    }

private:
    Eigen::Vector3d deviations_;
    Eigen::MatrixX3d points_;
    std::vector<double> draws_;
    std::mt19937_64 generator_{seed_of_campaigns};  ///< the same numbers on every machine
};

}  // namespace

double repeatability(const Eigen::MatrixX3d& points) {
    const Eigen::RowVector3d barycentre = points.colwise().mean();
    const Eigen::ArrayXd lengths = (points.rowwise() - barycentre).rowwise().norm().array();
    const double mean = lengths.mean();
    return mean + 3.0 * std::sqrt((lengths - mean).square().sum() / double(points.rows() - 1));
}

double mean_length(const Eigen::Vector3d& deviations) {
    const double size = deviations.norm();
    if (!(size > 0.0)) return 0.0;
    const Eigen::Array3d squares = (deviations / size).array().square();
    constexpr int steps = 800;  // t = tan^2(theta), midpoints
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
        const double theta = (k + 0.5) * std::numbers::pi / (2.0 * steps);
        const double t = std::tan(theta) * std::tan(theta), sine = std::sin(theta);
        sum += (1.0 - 1.0 / std::sqrt((1.0 + 2.0 * t * squares).prod())) / (sine * sine);
    }
    return size * sum * std::sqrt(std::numbers::pi) / (2.0 * steps);
}

double repeatability_of_scatter(const Eigen::Vector3d& deviations) {
    const double mean = mean_length(deviations);
    return mean + 3.0 * std::sqrt(std::max(0.0, deviations.squaredNorm() - mean * mean));
}

RepeatabilityLaw repeatability_law(const Eigen::Vector3d& deviations, int cycles, int campaigns) {
    RepeatabilityLaw law;
    const double size = deviations.norm();
    if (!(size > 0.0)) return law;
    const Eigen::Vector3d shape = deviations / size;
    law.of_infinite = size * repeatability_of_scatter(shape);
    const int drawn = std::min(cycles, most_simulated_cycles);
    const double fewer = double(drawn) / double(cycles);
    Campaigns simulated(shape, drawn);
    std::vector<double> ratios;
    for (int k = 0; k < campaigns; ++k) ratios.push_back(simulated.next() * size / law.of_infinite);
    const Eigen::Map<const Eigen::ArrayXd> all(ratios.data(), Eigen::Index(ratios.size()));
    const double mean = all.mean();
    law.bias = 1.0 + (mean - 1.0) * fewer;
    for (double& ratio : ratios) ratio = law.bias + (ratio - mean) * std::sqrt(fewer);
    law.relative_u = std::sqrt((all - law.bias).square().sum() / double(campaigns - 1)) / law.bias;
    std::ranges::sort(ratios, std::greater<>());
    for (std::size_t k = 0; k <= cells_of_a_law; ++k) {
        const double place = double(k) * double(ratios.size() - 1) / double(cells_of_a_law);
        const auto below = std::min(std::size_t(place), ratios.size() - 2);
        const double part = place - double(below);
        law.quantiles.push_back((1.0 - part) / ratios[below] + part / ratios[below + 1]);
    }
    return law;
}

Distribution RepeatabilityLaw::factor() const {
    return quantiles.empty() ? Distribution() : between(quantiles);
}

double RepeatabilityLaw::mean_factor() const {
    return quantiles.empty() ? 1.0 : factor().mean();
}

double RepeatabilityLaw::u_factor() const {
    return quantiles.empty() ? 0.0 : factor().standard_deviation();
}

double RepeatabilityLaw::probability_below(double factor) const {
    if (quantiles.empty() || factor >= quantiles.back()) return 1.0;
    if (!(factor > quantiles.front())) return 0.0;
    const auto above = std::ranges::upper_bound(quantiles, factor);
    const double low = *(above - 1), high = *above;
    return (double(above - quantiles.begin()) - 1.0 + (factor - low) / (high - low)) /
           double(quantiles.size() - 1);
}

Distribution deviation_factor(double degrees_of_freedom) {
    std::vector<double> edges;
    for (std::size_t k = 0; k <= cells_of_a_law; ++k) {
        const double p = std::clamp(1.0 - double(k) / double(cells_of_a_law), 2e-4, 1.0 - 2e-4);
        edges.push_back(std::sqrt(degrees_of_freedom / chi_squared_quantile(p, degrees_of_freedom)));
    }
    return between(std::move(edges));
}

Eigen::Matrix3d covariance_of(const Eigen::MatrixX3d& points) {
    const Eigen::MatrixX3d deviations = points.rowwise() - points.colwise().mean();
    return deviations.transpose() * deviations / double(points.rows() - 1);
}

Eigen::Vector3d principal_deviations(const Eigen::MatrixX3d& points) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance_of(points),
                                                                Eigen::EigenvaluesOnly);
    return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

}  // namespace covaria::sheets
