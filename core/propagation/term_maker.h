// Terms of the law of propagation: the effect of each component on an output, from the sensitivities of the
// output to the input quantities.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/propagation/first_order.h"

namespace covaria::detail {

/// Numbers by component, of which only some are not zero.
class Scratch {
public:
    explicit Scratch(std::size_t components) : values_(components, 0.0), used_(components, 0) {}
    double& operator[](std::size_t component) {
        if (used_[component] == 0) touched_.push_back(component);
        used_[component] = 1;
        return values_[component];
    }
    double value(std::size_t component) const { return values_[component]; }
    /// Components that were written to, rising.
    const std::vector<std::size_t>& touched();
    void clear();

private:
    std::vector<double> values_;
    std::vector<char> used_;
    std::vector<std::size_t> touched_;
};

/// Not for two threads at a time. `u` outlives it.
class TermMaker {
public:
    TermMaker(const InputSet& inputs, const Correlations& correlations, const Eigen::VectorXd& u);

    /// Writes the terms of an output by rising component, in place of what `terms` holds.
    void make(const std::vector<Sensitivity>& row, std::vector<PropagationTerm>& terms);

private:
    struct Partner {
        std::size_t component;
        double coefficient;
    };
    double contribution(std::size_t c) const {
        return sensitivity_.value(c) * u_(static_cast<Eigen::Index>(c));
    }

    const Eigen::VectorXd& u_;
    /// Shares of all quantities one after the other, of quantity i from `begins_[i]` on: quantities
    /// themselves are large, and a network has a hundred thousand of them for each of thousands of outputs.
    std::vector<Share> shares_;
    std::vector<std::size_t> begins_;
    std::vector<std::vector<Partner>> partners_;  ///< of each component; empty: no two are correlated
    Scratch sensitivity_, correlated_;
};

/// Covariance of two outputs.
double covariance_of_pair(const std::vector<PropagationTerm>& a, const std::vector<PropagationTerm>& b);

}  // namespace covaria::detail
