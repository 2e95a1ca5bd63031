// Independent terms of the linear parts of outputs, from correlated components.
#include "core/propagation/linear_parts.h"

#include <algorithm>
#include <cmath>

#include "core/quantity/component_pairs.h"
#include "core/quantity/isotropic_vector.h"

namespace covaria::detail {

LinearTermMaker::LinearTermMaker(const InputSet& inputs, const Correlations& correlations)
    : inputs_(inputs),
      characteristic_(inputs.components.size()),
      set_of_(inputs.components.size(), InputSet::npos),
      estimate_of_(inputs.estimates_of_components()),
      vector_of_(inputs.components.size(), InputSet::npos),
      partners_(inputs.components.size()) {
    for (const UncertaintyComponent& component : inputs.components)
        drawn_.push_back(drawn_distribution(component));
    const auto sets = dependent_sets(inputs, correlations);
    for (std::size_t s = 0; s < sets.size(); ++s)
        for (const std::size_t c : sets[s]) set_of_[c] = s;
    const auto vectors = vectors_of_random_direction(inputs);
    for (std::size_t v = 0; v < vectors.size(); ++v)
        for (const std::size_t c : vectors[v].components) vector_of_[c] = v;
    for (const ComponentCorrelation& r : correlations)
        partners_[r.first][r.second] = partners_[r.second][r.first] = r.coefficient;
}

LinearTerm LinearTermMaker::term(double factor, std::size_t component) {
    auto& characteristic = characteristic_[component];
    if (!characteristic) characteristic = std::make_shared<const CharacteristicFunction>(drawn(component));
    return {factor, drawn(component), characteristic};
}

bool LinearTermMaker::is_nearly_normal(std::size_t component) const {
    constexpr double as_good_as_known = 1e6;  // degrees of freedom, as DrawPlan has it
    const Distribution& distribution = drawn(component);
    return distribution.kind() == "normal" ||
           (distribution.kind() == "student-t" && distribution.degrees_of_freedom() >= as_good_as_known);
}

double LinearTermMaker::joint_variance(const Active& active) const {
    double variance = 0.0;
    for (const PropagationTerm& a : active)
        for (const PropagationTerm& b : active) {
            const auto r = partners_[a.component].find(b.component);
            if (a.component == b.component)
                variance += a.contribution * a.contribution;
            else if (r != partners_[a.component].end())
                variance += r->second * a.contribution * b.contribution;
        }
    return std::max(0.0, variance);
}

Result<LinearTerm> LinearTermMaker::joint_term(const Active& active) {
    const std::size_t first = active.front().component;
    if (active.size() == 1) return term(active.front().sensitivity, first);
    const auto all = [&](auto same) {
        return std::all_of(active.begin(), active.end(),
                           [&](const PropagationTerm& t) { return same(t.component); });
    };
    if (vector_of_[first] != InputSet::npos &&
        all([&](std::size_t c) { return vector_of_[c] == vector_of_[first]; })) {
        double squares = 0.0;
        for (const PropagationTerm& t : active) squares += t.sensitivity * t.sensitivity;
        return term(std::sqrt(squares), first);
    }
    const double u = std::sqrt(joint_variance(active));
    if (all([&](std::size_t c) { return is_nearly_normal(c); })) {
        const Distribution normal = Distribution::normal(u);
        return LinearTerm{1.0, normal, std::make_shared<const CharacteristicFunction>(normal)};
    }
    const std::size_t estimate = estimate_of_[first];
    if (estimate == InputSet::npos || !all([&](std::size_t c) { return estimate_of_[c] == estimate; }))
        return fail(ErrorCode::numeric, tell<"its correlated components are not normally distributed">());
    const Distribution t = Distribution::of(StudentT{0.0, u, drawn(first).degrees_of_freedom()});
    return LinearTerm{1.0, t, std::make_shared<const CharacteristicFunction>(t)};
}

Result<std::vector<LinearTerm>> LinearTermMaker::make(const std::vector<PropagationTerm>& terms) {
    std::vector<LinearTerm> made;
    std::map<std::size_t, Active> sets;
    for (const PropagationTerm& t : terms) {
        if (t.contribution == 0.0) continue;
        if (set_of_[t.component] == InputSet::npos)
            made.push_back(term(t.sensitivity, t.component));
        else
            sets[set_of_[t.component]].push_back(t);
    }
    for (const auto& [set, active] : sets) {
        auto joint = joint_term(active);
        if (!joint) return fail(joint.error());
        made.push_back(std::move(*joint));
    }
    if (made.empty())
        return fail(ErrorCode::numeric, tell<"its sensitivity coefficients are zero, or there are none">());
    return made;
}

}  // namespace covaria::detail
