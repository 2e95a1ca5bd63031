// The first trials of a run, looked at beforehand to know where the outputs lie.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/propagation/cell_counts.h"
#include "core/propagation/moments.h"
#include "core/propagation/run_context.h"

#include "core/propagation/tail.h"
#include "core/propagation/trial_block_runner.h"

namespace covaria::detail {

/// A value that recurs: the output has a discrete part.
struct RepeatedValue {
    double value = 0.0;
    double share = 0.0;  ///< share of the pilot's trials
};

/// Pilot of one output. Decides about memory and speed, never about a result: what is kept by these
/// thresholds is checked afterwards, and kept again if it was too little.
struct OutputPilot {
    double median =
        0.0;  ///< a value that occurred: the shift of the moments, so that no spread gives exactly 0
    double minimum = 0.0;
    double maximum = 0.0;
    TailShape low, high;
    CellGrid grid;
    std::vector<RepeatedValue> repeated;  ///< rising
};

/// Pilot from these values, which are sorted; `tail_fraction` of them in each tail.
OutputPilot look_at(std::vector<double>& values, double tail_fraction);
/// The pilot with thresholds that keep (almost) every value, where tails proved too short.
OutputPilot widened(const OutputPilot& pilot);
/// 1 - probability, and `margin` standard errors from so many values more.
double tail_fraction_of(std::size_t values, double probability, double margin);

struct Pilot {
    std::vector<OutputPilot> outputs;
    double tail_fraction = 1.0;  ///< approximate part of the trials in each tail
    std::size_t own = 0;         ///< outputs of the model; those after them are linear parts
    /// Squared correlation of each linear part with its output.
    std::vector<double> explained = {};
    OutputBlocks blocks = {};         ///< blocks of the outputs of the model
    OutputBlocks linear_blocks = {};  ///< blocks of the linear parts, as of their outputs
    Eigen::VectorXd shift() const;
    /// Statistics of no trials yet.
    Moments moments() const { return Moments(shift(), blocks, linear_blocks); }
    /// Takes the linear parts out for which `dropped` says so.
    void drop_linear_parts(const std::vector<bool>& dropped);
};

/// Always the first 10,000 trials (more only if fewer than 1,000 of them have a value), whatever the number
/// of threads. `limit`: trials of the run. Error: cancelled, or no trial has a value.
Result<Pilot> run_pilot(const RunContext& context, std::uint64_t limit);

}  // namespace covaria::detail
