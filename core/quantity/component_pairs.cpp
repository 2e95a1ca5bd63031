// Gathers the correlations between components and checks that they can all hold at once.
#include "core/quantity/component_pairs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/math/decompositions.h"
#include "core/quantity/copula.h"
#include "core/quantity/isotropic_vector.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;
using Coefficients = std::map<Pair, double>;

constexpr double smallest_eigenvalue_allowed = -1e-10;

Pair ordered(std::size_t a, std::size_t b) {
    return a < b ? Pair{a, b} : Pair{b, a};
}

std::string quoted(const InputSet& inputs, std::size_t component) {
    return '"' + inputs.components[component].id + '"';
}

/// Coefficient with which |factor| u of all components add: factors of opposite sign need -1.
double coefficient_of_signs(double a, double b) {
    return (a < 0.0) == (b < 0.0) ? 1.0 : -1.0;
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

tl::unexpected<Error> contradiction(const InputSet& inputs, const Pair& pair) {
    return fail(ErrorCode::bad_input,
                tell<"the components %1 and %2 are given two different correlations; a quantity that "
                     "combines its components arithmetically needs +1 or -1.">(quoted(inputs, pair.first),
                                                                               quoted(inputs, pair.second)));
}

/// False if the pair is known with another coefficient.
bool insert(Coefficients& coefficients, const Pair& pair, double coefficient) {
    return coefficients.try_emplace(pair, coefficient).first->second == coefficient;
}

Result<Coefficients> declared(const InputSet& inputs) {
    Coefficients coefficients;
    for (const ComponentCorrelation& c : inputs.correlations) {
        const std::size_t count = inputs.components.size();
        if (c.first >= count || c.second >= count)
            return fail(ErrorCode::bad_input, tell<"a correlation refers to component number %1 of %2.">(
                                                  std::max(c.first, c.second), count));
        if (c.first == c.second)
            return fail(
                ErrorCode::bad_input,
                tell<"a correlation is given between the component %1 and itself.">(quoted(inputs, c.first)));
        if (!(std::abs(c.coefficient) <= 1.0))
            return fail(ErrorCode::bad_input,
                        tell<"the correlation of the components %1 and %2 must lie between -1 and 1.">(
                            quoted(inputs, c.first), quoted(inputs, c.second)));
        const Pair pair = ordered(c.first, c.second);
        if (!insert(coefficients, pair, c.coefficient)) return contradiction(inputs, pair);
    }
    return coefficients;
}

Result<Coefficients> with_arithmetic(const InputSet& inputs, Coefficients coefficients) {
    for (const InputQuantity& quantity : inputs.quantities) {
        for (const Share& share : quantity.shares)
            if (share.component >= inputs.components.size())
                return fail(ErrorCode::bad_input,
                            tell<"the quantity \"%1\" refers to component number %2 of %3.">(
                                quantity.symbol, share.component, inputs.components.size()));
        if (quantity.combination != Combination::arithmetic) continue;
        std::map<std::size_t, double> factors;
        for (const Share& share : quantity.shares) factors[share.component] += share.factor;
        for (auto a = factors.begin(); a != factors.end(); ++a)
            for (auto b = std::next(a); b != factors.end(); ++b)
                if (!insert(coefficients, {a->first, b->first}, coefficient_of_signs(a->second, b->second)))
                    return contradiction(inputs, {a->first, b->first});
    }
    return coefficients;
}

/// Error if the correlation matrix of these components is not positive semi-definite.
std::optional<Error> group_problem(const InputSet& inputs, const std::vector<std::size_t>& group,
                                   const Coefficients& coefficients) {
    const auto n = static_cast<Eigen::Index>(group.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = i + 1; j < n; ++j) {
            const Pair pair{group[static_cast<std::size_t>(i)], group[static_cast<std::size_t>(j)]};
            const auto known = coefficients.find(pair);
            if (known != coefficients.end()) matrix(i, j) = matrix(j, i) = known->second;
        }
    const double smallest = eigen_decomposition(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
    if (smallest >= smallest_eigenvalue_allowed) return std::nullopt;
    std::string components;
    for (const std::size_t member : group)
        components += (components.empty() ? "" : ", ") + quoted(inputs, member);
    return Error{
        ErrorCode::bad_input,
        tell<"the correlations of the components %1 contradict each other: the smallest eigenvalue of "
             "their correlation matrix is %2, it must not be negative.">(components, format_short(smallest))};
}

/// Error if a coordinate of a vector of random direction is correlated: its draws come with the others'.
std::optional<Error> vector_problem(const InputSet& inputs, const Coefficients& coefficients) {
    for (const DrawnVector& vector : vectors_of_random_direction(inputs))
        for (const std::size_t member : vector.components)
            for (const auto& [pair, coefficient] : coefficients)
                if (coefficient != 0.0 && (pair.first == member || pair.second == member))
                    return Error{
                        ErrorCode::bad_input,
                        tell<"the component %1 is a coordinate of a vector of random direction and cannot be "
                             "correlated with another component; give it a normal distribution first.">(
                            quoted(inputs, member))};
    return std::nullopt;
}

bool may_share(const UncertaintyComponent& component) {
    const std::string_view kind = component.distribution.kind();
    return (kind == "normal" || kind == "student-t") && std::isfinite(degrees_of_freedom_of(component));
}

/// Error if components that rest on one estimate of variance are not what such components can be.
std::optional<Error> estimate_problem(const InputSet& inputs) {
    std::vector<bool> known(inputs.components.size(), false);
    for (const VarianceEstimate& estimate : inputs.variance_estimates)
        for (const std::size_t member : estimate.components) {
            if (member >= inputs.components.size() || known[member])
                return Error{ErrorCode::bad_input,
                             tell<"the estimate of variance \"%1\" has component number %2, "
                                  "which does not exist or rests on two estimates.">(estimate.id, member)};
            known[member] = true;
            const double nu = degrees_of_freedom_of(inputs.components[estimate.components.front()]);
            if (!may_share(inputs.components[member]) ||
                degrees_of_freedom_of(inputs.components[member]) != nu)
                return Error{
                    ErrorCode::bad_input,
                    tell<"the component %1 rests on the estimate of variance \"%2\" with others: it needs a "
                         "normal or Student t distribution and their finite degrees of freedom.">(
                        quoted(inputs, member), estimate.id)};
        }
    return std::nullopt;
}

}  // namespace

std::vector<ComponentCorrelation> detail::correlations_among(const InputSet& inputs,
                                                             const std::vector<std::size_t>& components) {
    const bool some =
        !inputs.correlations.empty() ||
        std::any_of(inputs.quantities.begin(), inputs.quantities.end(),
                    [](const auto& quantity) { return quantity.combination == Combination::arithmetic; });
    if (!some) return {};
    std::map<std::size_t, std::size_t> places;
    for (std::size_t i = 0; i < components.size(); ++i) places.emplace(components[i], i);
    Coefficients found;
    const auto insert_known = [&](std::size_t first, std::size_t second, double coefficient) {
        const auto a = places.find(first), b = places.find(second);
        if (a != places.end() && b != places.end()) insert(found, ordered(a->second, b->second), coefficient);
    };
    for (const ComponentCorrelation& c : inputs.correlations) insert_known(c.first, c.second, c.coefficient);
    for (const InputQuantity& quantity : inputs.quantities) {
        if (quantity.combination != Combination::arithmetic) continue;
        std::map<std::size_t, double> factors;
        for (const Share& share : quantity.shares)
            if (places.contains(share.component)) factors[share.component] += share.factor;
        for (auto a = factors.begin(); a != factors.end(); ++a)
            for (auto b = std::next(a); b != factors.end(); ++b)
                insert_known(a->first, b->first, coefficient_of_signs(a->second, b->second));
    }
    std::vector<ComponentCorrelation> pairs;
    for (const auto& [pair, coefficient] : found) pairs.push_back({pair.first, pair.second, coefficient});
    return pairs;
}

std::vector<std::vector<std::size_t>> detail::correlated_sets(
    std::size_t components, const std::vector<ComponentCorrelation>& correlations) {
    std::vector<std::size_t> parent(components);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    for (const ComponentCorrelation& c : correlations)
        if (c.coefficient != 0.0) parent[root_of(parent, c.second)] = root_of(parent, c.first);
    std::vector<std::vector<std::size_t>> by_root(components);
    for (std::size_t i = 0; i < components; ++i) by_root[root_of(parent, i)].push_back(i);
    std::vector<std::vector<std::size_t>> sets;
    for (auto& set : by_root)
        if (set.size() > 1) sets.push_back(std::move(set));
    return sets;
}

std::vector<std::vector<std::size_t>> detail::dependent_sets(
    const InputSet& inputs, const std::vector<ComponentCorrelation>& correlations) {
    std::vector<ComponentCorrelation> links = correlations;
    const auto link = [&links](const auto& members) {
        for (std::size_t k = 1; k < members.size(); ++k) links.push_back({members[k - 1], members[k], 1.0});
    };
    for (const VarianceEstimate& estimate : inputs.variance_estimates) link(estimate.components);
    for (const DrawnVector& vector : vectors_of_random_direction(inputs)) link(vector.components);
    return correlated_sets(inputs.components.size(), links);
}

Result<std::vector<ComponentCorrelation>> resolved_correlations(const InputSet& inputs) {
    const Result<Coefficients> coefficients =
        declared(inputs).and_then([&](const Coefficients& c) { return with_arithmetic(inputs, c); });
    if (!coefficients) return fail(coefficients.error());
    if (std::optional<Error> problem = vector_problem(inputs, *coefficients)) return fail(*problem);
    if (std::optional<Error> problem = estimate_problem(inputs)) return fail(*problem);
    std::vector<ComponentCorrelation> resolved;
    for (const auto& [pair, coefficient] : *coefficients)
        resolved.push_back({pair.first, pair.second, coefficient});
    for (const auto& group : detail::correlated_sets(inputs.components.size(), resolved))
        if (std::optional<Error> problem = group_problem(inputs, group, *coefficients)) return fail(*problem);
    if (const auto possible = detail::copula_coefficients(inputs, resolved); !possible)
        return fail(possible.error());
    return resolved;
}

}  // namespace covaria
