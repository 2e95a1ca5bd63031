// Sensitivity coefficients computed row by row, for models with too many quantities for a matrix.
#pragma once

#include <algorithm>

#include "core/math/dual.h"
#include "core/model/measurement_model.h"

namespace covaria {

/// Takes y.set(j, dual) of equations in which the inputs first ... first + count - 1 (at most Dual::size) are
/// the variables, and adds what is not zero to the rows.
class DualRows {
public:
    DualRows(SensitivityRows& rows, std::size_t first, std::size_t count)
        : rows_(&rows), first_(first), count_(count) {}
    void set(std::size_t j, const Dual& value) {
        residue_ += value.value() - value.value();
        for (std::size_t k = 0; k < count_; ++k) {
            const double partial = value.partials()[k];
            residue_ += partial - partial;
            if (partial != 0.0) (*rows_)[j].push_back({first_ + k, partial});
        }
    }
    bool finite() const { return residue_ == 0.0; }

private:
    SensitivityRows* rows_;
    std::size_t first_, count_;
    double residue_ = 0.0;
};

/// sum of factor * row, by rising input.
class RowSum {
public:
    explicit RowSum(std::size_t inputs) : sum_(inputs, 0.0) {}
    void add(const std::vector<Sensitivity>& row, double factor) {
        for (const Sensitivity& s : row) add(s.input, factor * s.coefficient);
    }
    void add(std::size_t input, double value) {
        if (sum_[input] == 0.0) touched_.push_back(input);
        sum_[input] += value;
    }
    /// The sum so far; begins again from zero.
    std::vector<Sensitivity> take() {
        std::sort(touched_.begin(), touched_.end());
        touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
        std::vector<Sensitivity> row;
        for (const std::size_t input : touched_) {
            if (sum_[input] != 0.0) row.push_back({input, sum_[input]});
            sum_[input] = 0.0;
        }
        touched_.clear();
        return row;
    }

private:
    std::vector<double> sum_;
    std::vector<std::size_t> touched_;
};

}  // namespace covaria
