// Options of an evaluation, which users choose. Options validate themselves and name the wrong field.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/error.h"
#include "core/base/unit.h"
#include "core/result/variance_reduction.h"

namespace covaria {

enum class Method { first_order, monte_carlo, adaptive };

struct EvaluationOptions {
    Method method = Method::monte_carlo;
    std::uint64_t trials = 1'000'000;  ///< fixed M
    std::uint64_t seed = 1;
    VarianceReduction variance_reduction = VarianceReduction::none;
    double coverage_probability = 0.95;
    std::optional<double> coverage_factor = {};  ///< fixed k; empty: from t and nu_eff
    bool second_order = false;                   ///< second-order terms of the law of propagation
    std::uint64_t one_at_a_time_trials = 0;      ///< 0 = no one-at-a-time Monte Carlo
    std::uint64_t contributor_trials = 0;  ///< 0 = no Monte Carlo without, and of, each contributor alone
    std::uint64_t sobol_trials = 0;        ///< 0 = no Sobol indices
    // adaptive procedure (JCGM 101 7.9, JCGM 102 7.8)
    int significant_digits = 2;  ///< n_dig of the numerical tolerance, also of clause 8
    /// delta instead of n_dig, for the outputs of its dimension; with the unit one for every output, in SI
    std::optional<Quantity> tolerance = {};
    std::uint64_t minimum_batches = 10;
    std::uint64_t maximum_trials = 100'000'000;
    bool operator==(const EvaluationOptions&) const = default;

    /// Paths are field names: "/coverage_probability".
    void check(Problems& problems) const;
    /// The given tolerance as it applies to an output in `unit` (SI); empty: by n_dig.
    std::optional<double> tolerance_for(const Unit& unit) const;
};

}  // namespace covaria
