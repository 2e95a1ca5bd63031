// One block of trials: draw the inputs, evaluate the model, put angles on the branch of the estimate.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/model/measurement_model.h"
#include "core/propagation/draw_plan.h"
#include "core/propagation/linear_rows.h"
#include "core/propagation/trial_rows.h"

namespace covaria::detail {

/// Everything that the trials of a run need; immutable, shared by all threads.
struct TrialSource {
    const MeasurementModel* model = nullptr;
    const DrawPlan* plan = nullptr;
    std::uint64_t seed = 0;
    Eigen::VectorXd estimate = {};  ///< first-order estimate of each: periodic outputs are unwrapped to it
    const LinearRows* linear = nullptr;  ///< linear parts of some outputs, to be evaluated too
    std::size_t outputs() const { return static_cast<std::size_t>(estimate.size()); }
    /// Number of rows: outputs, then their linear parts.
    std::size_t rows() const { return outputs() + (linear ? linear->size() : 0); }
};

/// Working memory of one thread; `run` does not allocate.
class TrialBlockRunner {
public:
    explicit TrialBlockRunner(const TrialSource& source);

    /// Trials first ... first + count - 1. Trials without a value are taken out: the rows then hold the
    /// `valid()` others in their order.
    void run(std::uint64_t first, std::size_t count);
    std::size_t trials() const { return trials_; }
    std::size_t valid() const { return valid_; }
    const double* output(std::size_t j) const { return outputs_.row(j); }  ///< j < rows of the source
    const double* input(std::size_t i) const { return inputs_.row(i); }
    const std::vector<std::uint8_t>& flags() const { return flags_; }  ///< 1 for trials with a value

private:
    void mark_not_finite();
    void compact();
    void unwrap();

    const TrialSource* source_;
    std::vector<std::size_t> periodic_;
    TrialRows inputs_;
    TrialRows outputs_;
    DrawWorkspace workspace_;
    std::vector<std::uint8_t> flags_;
    std::size_t trials_ = 0;
    std::size_t valid_ = 0;
};

}  // namespace covaria::detail
