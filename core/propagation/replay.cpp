// Trials of a run made again.
#include <algorithm>
#include <limits>

#include "core/propagation/engine.h"
#include "core/propagation/propagated.h"
#include "core/propagation/trial_block_runner.h"

namespace covaria {
namespace {

struct TrialRange {
    std::uint64_t first, count;
};

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

Result<ReplayedTrials> replay(const MeasurementModel& model, const InputSet& inputs,
                              const Propagation& propagation, std::uint64_t seed, TrialRange wanted) {
    using namespace detail;
    const DrawPlan plan(inputs, propagation.correlations);
    const TrialSource source{&model, &plan, seed, propagation.law.estimate};
    TrialBlockRunner runner(source);

    const auto columns = static_cast<Eigen::Index>(wanted.count);
    ReplayedTrials result;
    result.inputs.resize(propagation.law.inputs.size(), columns);
    result.outputs.setConstant(propagation.law.estimate.size(), columns,
                               std::numeric_limits<double>::quiet_NaN());
    // Blocks as the run had them: vector code then sees the same neighbours.
    const std::uint64_t end = wanted.first + wanted.count;
    for (std::uint64_t begin = wanted.first / block_trials * block_trials; begin < end;
         begin += block_trials) {
        runner.run(begin, std::min<std::uint64_t>(block_trials, end - begin));
        copy_block(runner, begin, wanted.first, result);
    }
    return result;
}

}  // namespace

Result<ReplayedTrials> replay_trials(const MeasurementModel& model, const InputSet& inputs,
                                     std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
    const auto propagation = propagate(model, inputs);
    if (!propagation) return fail(propagation.error());
    return replay(model, inputs, *propagation, seed, {first, count});
}

Result<ReplayedTrials> replay_trials(const PropagatedModel& model, std::uint64_t seed, std::uint64_t first,
                                     std::uint64_t count) {
    const auto& propagation = model.propagation();
    if (!propagation) return fail(propagation.error());
    return replay(*model.model(), model.inputs(), *propagation, seed, {first, count});
}

}  // namespace covaria
