// First-order sensitivity of anything computed from input quantities, at their estimates, by dual numbers.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "core/math/dual.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// The estimates of all input quantities; eight of them, from `first` on, as variables.
class EstimatedInputs {
public:
    EstimatedInputs(const InputSet& inputs, std::size_t first) : first_(first) {
        for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x_.push_back(estimate_of(inputs, i));
    }
    void move_to(std::size_t first) { first_ = first; }
    std::size_t size() const { return x_.size(); }
    Dual operator[](std::size_t i) const {
        return i >= first_ && i < first_ + Dual::size ? Dual::variable(x_[i], i - first_) : Dual(x_[i]);
    }

private:
    std::vector<double> x_;
    std::size_t first_;
};

/// Rows: what `evaluate(x, set)` sets, from 0 to `rows` − 1; it may set more. Columns: the components, each
/// times its standard uncertainty, so that the product with its transpose is the covariance.
template <class Evaluate>
Eigen::MatrixXd scaled_sensitivity(const InputSet& inputs, std::size_t rows, const Evaluate& evaluate) {
    const auto count = static_cast<Eigen::Index>(inputs.components.size());
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows), count);
    EstimatedInputs x(inputs, 0);
    std::vector<Dual> y(rows);
    for (std::size_t first = 0; first < x.size(); first += Dual::size) {
        x.move_to(first);
        evaluate(x, [&](std::size_t j, const Dual& value) {
            if (j < rows) y[j] = value;
        });
        for (std::size_t i = first; i < std::min(first + Dual::size, x.size()); ++i)
            for (const Share& share : inputs.quantities[i].shares)
                for (std::size_t j = 0; j < rows; ++j)
                    S(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(share.component)) +=
                        y[j].partials()[i - first] * share.factor;
    }
    for (Eigen::Index c = 0; c < count; ++c)
        S.col(c) *= inputs.components[static_cast<std::size_t>(c)].distribution.standard_uncertainty();
    return S;
}

}  // namespace covaria
