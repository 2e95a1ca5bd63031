// Comparison of two results: which outputs are the same quantity, and what of their budgets changed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"

namespace covaria {

/// Indices among the outputs of either result; at least one is there.
struct ComparedOutput {
    std::optional<std::size_t> before = {}, after = {};
    bool in_both() const { return before && after; }
};

/// A component of the budget of one output.
struct ComparedComponent {
    std::optional<std::size_t> before = {}, after = {};  ///< rows of the output's budget
    /// Parts of u_c^2 of the law of propagation, with the component's part of the covariances (may be
    /// negative); 0 where it is not.
    double variance_before = 0.0, variance_after = 0.0;
    double change() const { return variance_after - variance_before; }
};

struct ResultComparison {
    using Pointer = std::shared_ptr<const UncertaintyResult>;
    Pointer before, after;  ///< never null
    /// Outputs in the order of `after`; then those that only `before` has.
    std::vector<ComparedOutput> outputs;

    const OutputResult* output_before(const ComparedOutput& output) const {
        return output.before ? &before->outputs[*output.before] : nullptr;
    }
    const OutputResult* output_after(const ComparedOutput& output) const {
        return output.after ? &after->outputs[*output.after] : nullptr;
    }
};

/// Outputs are the same quantity where group, symbol and dimension agree.
ResultComparison compare_results(ResultComparison::Pointer before, ResultComparison::Pointer after);

/// The components of an output's budgets by falling size of the change; empty for an output that is not in
/// both. A component is the same where its id is, else where its name and its quantities are. The changes add
/// up to the change of u_c^2.
std::vector<ComparedComponent> compare_budgets(const ResultComparison& comparison,
                                               const ComparedOutput& output);

/// (b - a)/a; nothing where that says nothing.
std::optional<double> relative_change(double a, double b);

}  // namespace covaria
