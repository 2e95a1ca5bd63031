// The linear parts of outputs over a block of trials.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/propagation/trial_rows.h"

namespace covaria::detail {

/// sum of s_i (x_i - x0_i): how far the linear part of one output lies from its value at the estimates.
struct LinearRow {
    struct Term {
        std::size_t quantity = 0;
        double sensitivity = 0.0;
        double estimate = 0.0;  ///< x0_i
    };
    std::size_t output = 0;
    std::vector<Term> terms = {};
};

class LinearRows {
public:
    explicit LinearRows(std::vector<LinearRow> rows) : rows_(std::move(rows)) {}
    std::size_t size() const { return rows_.size(); }
    const LinearRow& operator[](std::size_t k) const { return rows_[k]; }
    /// Row k begins at `first_row + k * block_trials`. No allocation.
    void evaluate(const TrialRows& inputs, std::size_t count, double* first_row) const;

private:
    std::vector<LinearRow> rows_;
};

}  // namespace covaria::detail
