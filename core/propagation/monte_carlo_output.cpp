// Statistics of each output of a finished run.
#include <algorithm>
#include <cmath>

#include "core/propagation/kept_distribution.h"
#include "core/propagation/monte_carlo.h"
#include "core/propagation/normality.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

constexpr std::size_t quantile_count = 199;

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
