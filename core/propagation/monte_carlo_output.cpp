// Statistics of each output of a finished run.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/propagation/kept_distribution.h"
#include "core/propagation/monte_carlo.h"
#include "core/propagation/normality.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

constexpr std::size_t quantile_count = 199;

/// The exponent by which the greatest deviations from the median fall with their rank (Hill, The Annals of
/// Statistics 3 (1975) 1163).
double exponent_of_tail(const Tail& tail, std::uint64_t ranks, double median) {
    const double last = std::abs(tail.value(ranks + 1) - median);
    double sum = 0.0;
    for (std::uint64_t r = 1; last > 0.0 && r <= ranks; ++r)
        sum += std::log(std::abs(tail.value(r) - median) / last);
    return sum > 0.0 ? static_cast<double>(ranks) / sum : infinity;
}

/// Whether the tail falls with an exponent below two: then there is no variance, or these trials do not know
/// it. Some values far out have such a tail too, but no longer when only they are asked.
bool has_heavy_tail(const Tail& tail, std::uint64_t trials, double median) {
    constexpr std::uint64_t fewest = 100, most = 10'000;
    const std::uint64_t ranks = std::clamp(trials / 1000, fewest, most);
    if (trials < 20 * fewest || tail.count() <= ranks) return false;
    const double scatter = 2.0 / std::sqrt(static_cast<double>(ranks));
    return exponent_of_tail(tail, ranks, median) * (1.0 + scatter) < 2.0 &&
           exponent_of_tail(tail, ranks / 5, median) < 2.0;
}

MonteCarloOutput output_of(MonteCarloRun& run, std::size_t j, double probability) {
    const auto index = static_cast<Eigen::Index>(j);
    const std::uint64_t n = run.moments.count();
    Tails& tails = run.tails[j];
    tails.low.finish();
    tails.high.finish();
    MonteCarloOutput output;
    output.mean = run.moments.mean(index);
    output.standard_uncertainty = std::sqrt(run.moments.variance(index));
    output.skewness = run.moments.skewness(index);
    output.kurtosis = run.moments.kurtosis(index);
    const double u = output.standard_uncertainty;
    output.standard_error_of_mean = u / std::sqrt(static_cast<double>(n));
    output.standard_error_of_uncertainty =
        u * std::sqrt(std::max(0.0, output.kurtosis + 2.0) / (4.0 * static_cast<double>(n)));
    const double median = run.pilot.outputs[j].median;
    if (has_heavy_tail(tails.low, n, median) || has_heavy_tail(tails.high, n, median))
        output.standard_error_of_uncertainty = std::numeric_limits<double>::quiet_NaN();
    const CoverageRanks ranks = coverage_ranks(n, probability);
    output.symmetric = symmetric_interval(tails, ranks);
    output.shortest = shortest_interval(tails, ranks);
    output.minimum = tails.low.value(1);
    output.maximum = tails.high.value(1);
    output.histogram = histogram_of(run.pilot.outputs[j].grid, run.cells[j]);
    output.quantiles = quantile_list(run.pilot.outputs[j].grid, run.cells[j], tails, quantile_count);
    output.distribution = kept_distribution(run.pilot.outputs[j], run.cells[j], run.parts[j], tails);
    output.normality = normality_of(output, n, probability);
    return output;
}

}  // namespace

Result<std::vector<MonteCarloOutput>> outputs_of(MonteCarloRun& run, double probability,
                                                 RunMonitor& monitor) {
    std::vector<MonteCarloOutput> outputs(run.tails.size());
    const WorkEnd end = run_each(outputs.size(), monitor,
                                 [&](std::uint64_t j) { outputs[j] = output_of(run, j, probability); });
    if (end == WorkEnd::cancelled) return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    return outputs;
}

}  // namespace covaria::detail
