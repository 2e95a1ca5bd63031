// Sobol indices: shares of the variance by each independent factor, alone and with its interactions.
#pragma once

#include "core/propagation/first_order.h"
#include "core/propagation/run_context.h"
#include "core/propagation/trial_block_runner.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// Components that are drawn together and so can only have an index together: correlated ones, the
/// coordinates of a vector of random direction.
struct SobolFactor {
    std::string name;
    std::vector<std::size_t> components;
};
/// Factors by falling share of the first-order variances; those after the first `most - 1` become one.
std::vector<SobolFactor> sobol_factors(const InputSet& inputs, const LawOfPropagation& law,
                                       const Correlations& correlations, std::size_t most = 40);

/// Total index of a component that counts, though the law of propagation may not see it.
inline constexpr double least_total_index = 1e-3;
/// Rows with c = 0 for components that count and have none: what they do, they do with others.
void add_rows_of_interactions(UncertaintyBudget& budget, const std::vector<std::vector<SobolIndex>>& indices);

/// Indices of every output from `trials` pairs of trials: first order after Saltelli et al. (Comput. Phys.
/// Commun. 181 (2010) 259, Table 2 b), total after Jansen (Comput. Phys. Commun. 117 (1999) 35), with
/// standard errors from the scatter of the terms. Trials without a value are left out. Error: cancelled.
Result<std::vector<std::vector<SobolIndex>>> sobol_indices(const RunContext& context, const InputSet& inputs,
                                                           const Correlations& correlations,
                                                           const std::vector<SobolFactor>& factors,
                                                           std::uint64_t trials);

}  // namespace covaria::detail
