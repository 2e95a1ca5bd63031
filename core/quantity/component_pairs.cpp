// Gathers the correlations between components and checks that they can all hold at once.
#include "core/quantity/component_pairs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/quantity/isotropic_vector.h"

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

std::optional<double> factor_of(const InputQuantity& quantity, std::size_t component) {
    std::optional<double> factor;
    for (const Share& share : quantity.shares)
        if (share.component == component) factor = factor.value_or(0.0) + share.factor;
    return factor;
}

/// So that |factor| u of all components add: components with factors of opposite sign get -1.
double coefficient_of_signs(double a, double b) {
    return (a < 0.0) == (b < 0.0) ? 1.0 : -1.0;
}

/// Components as sets of connected ones.
class Groups {
public:
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

private:
    std::vector<std::size_t> parent_;
};

tl::unexpected<Error> contradiction(const InputSet& inputs, const Pair& pair) {
    return fail(ErrorCode::bad_input,
                "the components " + quoted(inputs, pair.first) + " and " + quoted(inputs, pair.second) +
                    " are given two different correlations; a quantity that combines its "
                    "components arithmetically needs +1 or -1.");
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
            return fail(ErrorCode::bad_input, "a correlation refers to component number " +
                                                  std::to_string(std::max(c.first, c.second)) + " of " +
                                                  std::to_string(count) + ".");
        if (c.first == c.second)
            return fail(ErrorCode::bad_input, "a correlation is given between the component " +
                                                  quoted(inputs, c.first) + " and itself.");
        if (!(std::abs(c.coefficient) <= 1.0))
            return fail(ErrorCode::bad_input, "the correlation of the components " + quoted(inputs, c.first) +
                                                  " and " + quoted(inputs, c.second) +
                                                  " must lie between -1 and 1.");
        const Pair pair = ordered(c.first, c.second);
        if (!insert(coefficients, pair, c.coefficient)) return contradiction(inputs, pair);
    }
    return coefficients;
}

Result<Coefficients> with_arithmetic(const InputSet& inputs, Coefficients coefficients) {
    for (const InputQuantity& quantity : inputs.quantities) {
        for (const Share& share : quantity.shares)
            if (share.component >= inputs.components.size())
                return fail(ErrorCode::bad_input, "the quantity \"" + quantity.symbol +
                                                      "\" refers to component number " +
                                                      std::to_string(share.component) + " of " +
                                                      std::to_string(inputs.components.size()) + ".");
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
    const double smallest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
    if (smallest >= smallest_eigenvalue_allowed) return std::nullopt;
    std::ostringstream message;
    message << "the correlations of the components ";
    for (std::size_t i = 0; i < group.size(); ++i)
        message << (i == 0 ? "" : ", ") << quoted(inputs, group[i]);
    message.precision(3);
    message << " contradict each other: the smallest eigenvalue of their correlation matrix is " << smallest
            << ", it must not be negative.";
    return Error{ErrorCode::bad_input, message.str()};
}

/// Error if a coordinate of a vector of random direction is correlated: its draws come with the others'.
std::optional<Error> vector_problem(const InputSet& inputs, const Coefficients& coefficients) {
    for (const DrawnVector& vector : vectors_of_random_direction(inputs))
        for (const std::size_t member : vector.components)
            for (const auto& [pair, coefficient] : coefficients)
                if (coefficient != 0.0 && (pair.first == member || pair.second == member))
                    return Error{
                        ErrorCode::bad_input,
                        "the component " + quoted(inputs, member) +
                            " is a coordinate of a vector of random direction and cannot be "
                            "correlated with another component; give it a normal distribution first."};
    return std::nullopt;
}

}  // namespace

double detail::correlation_between(const InputSet& inputs, std::size_t first, std::size_t second) {
    for (const ComponentCorrelation& c : inputs.correlations)
        if (ordered(c.first, c.second) == ordered(first, second)) return c.coefficient;
    for (const InputQuantity& quantity : inputs.quantities) {
        if (quantity.combination != Combination::arithmetic) continue;
        const std::optional<double> a = factor_of(quantity, first);
        const std::optional<double> b = factor_of(quantity, second);
        if (a && b) return coefficient_of_signs(*a, *b);
    }
    return 0.0;
}

Result<std::vector<ComponentCorrelation>> resolved_correlations(const InputSet& inputs) {
    const Result<Coefficients> coefficients =
        declared(inputs).and_then([&](const Coefficients& c) { return with_arithmetic(inputs, c); });
    if (!coefficients) return fail(coefficients.error());
    if (std::optional<Error> problem = vector_problem(inputs, *coefficients)) return fail(*problem);
    Groups groups(inputs.components.size());
    std::vector<ComponentCorrelation> resolved;
    for (const auto& [pair, coefficient] : *coefficients) {
        groups.join(pair.first, pair.second);
        resolved.push_back({pair.first, pair.second, coefficient});
    }
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < inputs.components.size(); ++i) members[groups.root(i)].push_back(i);
    for (const auto& [root, group] : members) {
        if (group.size() < 2) continue;
        if (std::optional<Error> problem = group_problem(inputs, group, *coefficients)) return fail(*problem);
    }
    return resolved;
}

}  // namespace covaria
