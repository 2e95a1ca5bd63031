// The reverse budget: which figure of a component makes the expanded uncertainty meet a target.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/run_control.h"
#include "core/model/measurement_model.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

struct ReverseBudget {
    struct Reduction {
        std::size_t component = 0;          ///< its index in the result's inputs and budget
        double now = 0.0;                   ///< its standard uncertainty
        std::optional<double> needed = {};  ///< the largest that suffices; empty: not even zero does
        bool rises_again = false;  ///< U exceeds the target where it vanishes: what is left has few nu
        std::optional<double> factor() const;  ///< needed/now
    };
    std::vector<Reduction> reductions;  ///< those of the largest contributors, in their order
    /// Factor of all standard uncertainties, where no component suffices alone.
    std::optional<double> common_factor = {};
    std::uint64_t trials = 0;  ///< trials that found U again; 0: law of propagation
};

/// Reductions for a target below the expanded uncertainty of the result's `output`; else none. With a figure,
/// U of the same method is the target: by the law of propagation k follows nu_eff, and by Monte Carlo the
/// model is evaluated again with the same draws (at most 100 000 trials, whose U is taken relative to
/// theirs without a change). The other figures, degrees of freedom and kinds of distributions stay. `model`
/// is that of the result; the law of propagation does without (null). Error: cancelled, numeric.
Result<ReverseBudget> reverse_budget(const MeasurementModel* model, const UncertaintyResult& result,
                                     std::size_t output, double target, const RunControl& control = {});

/// Multiplies what a component does to a quantity, about its mean: the estimate stays where it is.
void scale_share(const InputSet& inputs, InputQuantity& quantity, Share& share, double factor);
/// Scales a component in all quantities: its standard uncertainty is then `factor` times as large.
void scale_component(InputSet& inputs, std::size_t component, double factor);

}  // namespace covaria
