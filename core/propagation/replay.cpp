// Trials of a run made again.
#include <algorithm>
#include <limits>

#include "core/propagation/engine_parts.h"
#include "core/propagation/trial_block_runner.h"

namespace covaria {
namespace {

/// Puts the wanted trials of the runner's block (which begins at trial `begin`) into their columns.
void copy_block(const detail::TrialBlockRunner& runner, std::uint64_t begin, std::uint64_t first,
                ReplayedTrials& result) {
    std::size_t kept = 0;  // rows of outputs hold only trials with a value
    for (std::size_t t = 0; t < runner.trials(); ++t) {
        const bool valid = runner.flags()[t] != 0;
        if (begin + t >= first) {
            const auto column = static_cast<Eigen::Index>(begin + t - first);
            for (Eigen::Index i = 0; i < result.inputs.rows(); ++i)
                result.inputs(i, column) = runner.input(static_cast<std::size_t>(i))[t];
            for (Eigen::Index j = 0; valid && j < result.outputs.rows(); ++j)
                result.outputs(j, column) = runner.output(static_cast<std::size_t>(j))[kept];
        }
        kept += valid;
    }
}

}  // namespace

Result<ReplayedTrials> replay_trials(const MeasurementModel& model, const InputSet& inputs,
                                     std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
    using namespace detail;
    const auto correlations = checked_correlations(model, inputs);
    if (!correlations) return fail(correlations.error());
    const auto law = law_of_propagation(model, inputs, *correlations);
    if (!law) return fail(law.error());
    const DrawPlan plan(inputs, *correlations);
    const TrialSource source{&model, &plan, seed, law->estimate};
    TrialBlockRunner runner(source);

    const auto columns = static_cast<Eigen::Index>(count);
    ReplayedTrials result;
    result.inputs.resize(law->inputs.size(), columns);
    result.outputs.setConstant(law->estimate.size(), columns, std::numeric_limits<double>::quiet_NaN());
    // Blocks as the run had them: vector code then sees the same neighbours.
    for (std::uint64_t begin = first / block_trials * block_trials; begin < first + count;
         begin += block_trials) {
        runner.run(begin, std::min<std::uint64_t>(block_trials, first + count - begin));
        copy_block(runner, begin, first, result);
    }
    return result;
}

}  // namespace covaria
