// Joint coverage regions of several outputs.
#include "core/propagation/coverage_regions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"
#include "core/propagation/order_statistics.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

CoverageRegion region_of(const Name& group, std::vector<std::size_t> outputs, const LawOfPropagation& law,
                         double probability) {
    CoverageRegion region;
    region.group = group;
    const auto m = static_cast<double>(outputs.size());
    double nu = infinity;
    for (const std::size_t j : outputs)  // infinite where an output has no uncertainty
        if (const double own = law.degrees_of_freedom(static_cast<Eigen::Index>(j)); own < nu) nu = own;
    region.outputs = std::move(outputs);
    region.ellipsoid_first_order = std::sqrt(m * f_quantile(probability, m, nu));
    region.rectangle_first_order = -t_quantile((1.0 - probability) / (2.0 * m), nu);
    region.singular = is_singular(law.covariance, region.outputs);
    return region;
}

}  // namespace

std::vector<CoverageRegion> declare_regions(const std::vector<OutputQuantity>& outputs,
                                            const LawOfPropagation& law, double probability) {
    std::vector<CoverageRegion> regions;
    for (const Name& group : groups_of(outputs)) {
        std::vector<std::size_t> members = outputs_of_group(outputs, group);
        std::erase_if(members, [&](std::size_t j) { return outputs[j].role != OutputRole::measurand; });
        if (members.size() < 2) continue;
        regions.push_back(region_of(group, members, law, probability));
        const auto dimension = [&](std::size_t k) { return outputs[members[k]].unit.dimension(); };
        for (std::size_t k = 0; members.size() > 3 && k + 3 <= members.size();) {
            const bool triple = dimension(k) == dimension(k + 1) && dimension(k) == dimension(k + 2);
            if (triple)
                regions.push_back(
                    region_of(group, {members[k], members[k + 1], members[k + 2]}, law, probability));
            k += triple ? 3 : 1;
        }
    }
    return regions;
}

bool is_singular(const OutputCovariance& covariance, const std::vector<std::size_t>& outputs) {
    const Eigen::MatrixXd part = covariance.among(outputs);
    if (!part.allFinite() || !(part.diagonal().minCoeff() > 0)) return true;
    // The correlation matrix is judged, because units of the outputs differ.
    const auto solver = eigen_decomposition(correlation_of(part), Eigen::EigenvaluesOnly);
    return solver.eigenvalues().minCoeff() < 1e-10 * solver.eigenvalues().maxCoeff();
}

RegionDistances::RegionDistances(const std::vector<std::size_t>& outputs, const Eigen::VectorXd& mean,
                                 const OutputCovariance& covariance)
    : outputs_(outputs) {
    const std::vector<Eigen::Index> index(outputs.begin(), outputs.end());
    mean_ = mean(index);
    const Eigen::MatrixXd part = covariance.among(outputs);
    inverse_u_ = part.diagonal().unaryExpr([](double v) { return v > 0 ? 1.0 / std::sqrt(v) : 0.0; });
    if (is_singular(covariance, outputs)) return;
    // U = D R D with the standard uncertainties in D: R is factored, whatever the units are.
    const auto llt = cholesky(correlation_of(part));
    inverse_factor_ = llt.matrixL().solve(Eigen::MatrixXd(inverse_u_.asDiagonal()));
}

void RegionDistances::ellipsoid_squared(const double* first_row, std::size_t count, double* distances) const {
    std::fill_n(distances, count, 0.0);
    double z[block_trials];
    for (Eigen::Index a = 0; a < mean_.size(); ++a) {
        std::fill_n(z, count, 0.0);
        for (Eigen::Index b = 0; b <= a; ++b) {
            const double factor = inverse_factor_(a, b), mean = mean_(b);
            const double* y = first_row + outputs_[static_cast<std::size_t>(b)] * block_trials;
            for (std::size_t t = 0; t < count; ++t) z[t] += factor * (y[t] - mean);
        }
        for (std::size_t t = 0; t < count; ++t) distances[t] += z[t] * z[t];
    }
}

void RegionDistances::rectangle(const double* first_row, std::size_t count, double* distances) const {
    std::fill_n(distances, count, 0.0);
    for (Eigen::Index a = 0; a < mean_.size(); ++a) {
        const double* y = first_row + outputs_[static_cast<std::size_t>(a)] * block_trials;
        const double factor = inverse_u_(a), mean = mean_(a);
        for (std::size_t t = 0; t < count; ++t) {
            const double distance = std::abs(y[t] - mean) * factor;
            distances[t] = distance > distances[t] ? distance : distances[t];
        }
    }
}

double factor_of(std::vector<double>& distances, double probability) {
    const CoverageRanks ranks = coverage_ranks(distances.size(), probability);
    const auto nth = distances.begin() + static_cast<std::ptrdiff_t>(std::max<std::uint64_t>(ranks.q, 1) - 1);
    std::nth_element(distances.begin(), nth, distances.end());
    return *nth;
}

namespace {

struct Distances {
    std::vector<double> ellipsoid, rectangle;  ///< distances of the regions in turn, for one block
    std::size_t valid = 0;
};

using Columns = std::vector<std::vector<double>>;

WorkEnd measure_trials(const std::vector<CoverageRegion>& regions,
                       const std::vector<RegionDistances>& measures, const RunContext& context,
                       std::uint64_t trials, std::array<Columns, 2>& distances) {
    OrderedWork<Distances> work;
    work.units = (trials + block_trials - 1) / block_trials;
    work.make_partial = [&] {
        return Distances{std::vector<double>(regions.size() * block_trials),
                         std::vector<double>(regions.size() * block_trials), 0};
    };
    work.make_worker = [&] {
        return [&, runner = std::make_shared<TrialBlockRunner>(context.source)](std::uint64_t block,
                                                                                Distances& part) {
            const std::uint64_t first = block * block_trials;
            runner->run(first, std::min<std::uint64_t>(block_trials, trials - first));
            part.valid = runner->valid();
            for (std::size_t i = 0; i < regions.size(); ++i) {
                double* place = part.ellipsoid.data() + i * block_trials;
                if (measures[i].has_ellipsoid())
                    measures[i].ellipsoid_squared(runner->output(0), part.valid, place);
                measures[i].rectangle(runner->output(0), part.valid,
                                      part.rectangle.data() + i * block_trials);
            }
            return context.monitor.advance(0);
        };
    };
    work.merge = [&](std::uint64_t, Distances& part) {
        for (std::size_t i = 0; i < regions.size(); ++i) {
            const double* e = part.ellipsoid.data() + i * block_trials;
            const double* r = part.rectangle.data() + i * block_trials;
            if (measures[i].has_ellipsoid()) distances[0][i].insert(distances[0][i].end(), e, e + part.valid);
            distances[1][i].insert(distances[1][i].end(), r, r + part.valid);
        }
        return true;
    };
    return run_in_order(work, context.monitor);
}

}  // namespace

Result<void> fill_monte_carlo_factors(std::vector<CoverageRegion>& regions, const RunContext& context,
                                      const Eigen::VectorXd& mean, const OutputCovariance& covariance,
                                      std::uint64_t trials) {
    if (regions.empty()) return {};
    std::vector<RegionDistances> measures;
    for (const CoverageRegion& region : regions) measures.emplace_back(region.outputs, mean, covariance);
    std::array<Columns, 2> distances{Columns(regions.size()), Columns(regions.size())};
    WorkEnd end = measure_trials(regions, measures, context, std::min(trials, context.settings.region_trials),
                                 distances);
    if (end != WorkEnd::cancelled)
        end = run_each(regions.size(), context.monitor, [&](std::uint64_t i) {
            CoverageRegion& region = regions[i];
            if (distances[1][i].size() < 2) return;
            region.trials = distances[1][i].size();
            region.rectangle_monte_carlo = factor_of(distances[1][i], context.probability);
            if (measures[i].has_ellipsoid() && !region.singular)
                region.ellipsoid_monte_carlo = std::sqrt(factor_of(distances[0][i], context.probability));
        });
    if (end == WorkEnd::cancelled) return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    return {};
}

}  // namespace covaria::detail
