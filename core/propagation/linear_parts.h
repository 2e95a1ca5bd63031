// The linear part of each output, y0 + sum c_j (e_j - m_j), and its distribution, which is known exactly.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/propagation/first_order.h"
#include "core/propagation/linear_distribution.h"

namespace covaria::detail {

/// Makes independent terms of the components that reach an output, as Monte Carlo draws them: components that
/// are jointly normal become one normal term, members of one estimate of variance one Student t term (a sum
/// of multivariate t is t), the coordinates of a vector of random direction one coordinate along its
/// sensitivities.
class LinearTermMaker {
public:
    LinearTermMaker(const InputSet& inputs, const Correlations& correlations);
    /// Error: why the sum has no such form (components correlated by a copula that are not normal).
    Result<std::vector<LinearTerm>> make(const std::vector<PropagationTerm>& terms);

private:
    using Active = std::vector<PropagationTerm>;  ///< components of one dependent set that are drawn
    const Distribution& drawn(std::size_t component) const { return drawn_[component]; }
    LinearTerm term(double factor, std::size_t component);
    Result<LinearTerm> joint_term(const Active& active);
    double joint_variance(const Active& active) const;
    bool is_nearly_normal(std::size_t component) const;

    const InputSet& inputs_;
    std::vector<Distribution> drawn_;
    std::vector<std::shared_ptr<const CharacteristicFunction>> characteristic_;
    std::vector<std::size_t> set_of_, estimate_of_, vector_of_;
    std::vector<std::map<std::size_t, double>> partners_;  ///< coefficients of correlation
};

}  // namespace covaria::detail
