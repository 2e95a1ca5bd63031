// Estimates, standard uncertainties and effective degrees of freedom of input quantities.
#include "core/quantity/input_quantity.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <variant>

#include "core/quantity/component_pairs.h"
#include "core/quantity/effective_degrees.h"

namespace covaria {

namespace {

/// Contributions a_j = factor_j u_j of the components of one quantity, and those that are correlated by their
/// places among them: of hundreds of components few are.
struct Contributions {
    std::vector<std::size_t> components;
    std::vector<double> a;
    std::vector<ComponentCorrelation> pairs;

    /// R a.
    std::vector<double> correlated() const {
        std::vector<double> sums = a;
        for (const ComponentCorrelation& pair : pairs) {
            sums[pair.first] += pair.coefficient * a[pair.second];
            sums[pair.second] += pair.coefficient * a[pair.first];
        }
        return sums;
    }
    double variance() const {
        const std::vector<double> sums = correlated();
        return std::max(0.0, std::inner_product(a.begin(), a.end(), sums.begin(), 0.0));
    }
};

/// A component named twice counts once, with the sum of its factors; held ones contribute nothing.
Contributions contributions(const InputSet& inputs, const InputQuantity& quantity) {
    Contributions c;
    std::unordered_map<std::size_t, std::size_t> places;
    for (const Share& share : quantity.shares) {
        const UncertaintyComponent& component = inputs.components.at(share.component);
        if (component.held) continue;
        const auto [known, is_new] = places.try_emplace(share.component, c.components.size());
        if (is_new) {
            c.components.push_back(share.component);
            c.a.push_back(0.0);
        }
        c.a[known->second] += share.factor * component.distribution.standard_uncertainty();
    }
    if (c.components.size() > 1) c.pairs = detail::correlations_among(inputs, c.components);
    return c;
}

}  // namespace

std::vector<Share> detail::correlations_with_total(const InputSet& inputs, std::size_t quantity) {
    const Contributions c = contributions(inputs, inputs.quantities.at(quantity));
    const double u = std::sqrt(c.variance());
    const std::vector<double> covariances = c.correlated();
    std::vector<Share> result;
    for (std::size_t j = 0; j < c.components.size() && u > 0.0; ++j)
        result.push_back({c.components[j], covariances[j] / u});
    return result;
}

std::size_t InputSet::add(UncertaintyComponent component) {
    components.push_back(std::move(component));
    return components.size() - 1;
}

std::size_t InputSet::add(InputQuantity quantity, std::vector<UncertaintyComponent> own_components) {
    for (UncertaintyComponent& component : own_components)
        quantity.shares.push_back({add(std::move(component)), 1.0});
    quantities.push_back(std::move(quantity));
    return quantities.size() - 1;
}

std::size_t InputSet::find(const std::string& symbol) const {
    const auto it = std::find_if(quantities.begin(), quantities.end(),
                                 [&](const InputQuantity& q) { return q.symbol == symbol; });
    return it == quantities.end() ? npos : static_cast<std::size_t>(it - quantities.begin());
}

double estimate_of(const InputSet& inputs, std::size_t quantity) {
    const InputQuantity& q = inputs.quantities.at(quantity);
    double estimate = q.offset;
    for (const Share& share : q.shares)
        estimate += share.factor * inputs.components.at(share.component).distribution.mean();
    return estimate;
}

double standard_uncertainty_of(const InputSet& inputs, std::size_t quantity) {
    return std::sqrt(contributions(inputs, inputs.quantities.at(quantity)).variance());
}

void InputSet::rest_on_estimate(const std::string& id, std::size_t component, bool of_asset) {
    auto known = std::find_if(variance_estimates.begin(), variance_estimates.end(),
                              [&](const VarianceEstimate& estimate) { return estimate.id == id; });
    if (known == variance_estimates.end())
        known = variance_estimates.insert(known, VarianceEstimate{id, {}, of_asset});
    known->components.push_back(component);
}

std::vector<std::size_t> InputSet::estimates_of_components() const {
    std::vector<std::size_t> estimates(components.size(), npos);
    for (std::size_t e = 0; e < variance_estimates.size(); ++e)
        for (const std::size_t member : variance_estimates[e].components) estimates.at(member) = e;
    return estimates;
}

std::string symbol_of_component(const InputSet& inputs, std::size_t component) {
    const InputQuantity* found = nullptr;
    for (const InputQuantity& quantity : inputs.quantities) {
        const auto has_it = [component](const Share& share) { return share.component == component; };
        if (std::none_of(quantity.shares.begin(), quantity.shares.end(), has_it)) continue;
        if (found || quantity.shares.size() > 1) return inputs.components[component].id;
        found = &quantity;
    }
    return found ? found->symbol : inputs.components[component].id;
}

double degrees_of_freedom_of(const UncertaintyComponent& component) {
    return std::min(component.degrees_of_freedom, component.distribution.degrees_of_freedom());
}

Distribution drawn_distribution(const UncertaintyComponent& component) {
    const DistributionParameters& parameters = component.distribution.parameters();
    const bool is_t = std::holds_alternative<StudentT>(parameters);
    const double nu = degrees_of_freedom_of(component);
    if (std::isinf(nu) || (!is_t && (component.normal_draws || !std::holds_alternative<Normal>(parameters))))
        return component.distribution;
    // Checked where inputs are; what has too few is refused there.
    return Distribution::make(
               StudentT{component.distribution.mean(), component.distribution.standard_uncertainty(), nu})
        .value_or(component.distribution);
}

double degrees_of_freedom_of(const InputSet& inputs, std::size_t quantity) {
    const Contributions c = contributions(inputs, inputs.quantities.at(quantity));
    const std::vector<std::size_t> estimates = inputs.estimates_of_components();
    std::vector<detail::WelchSatterthwaite::Source> sources;
    std::vector<detail::WelchSatterthwaite::Part> parts;
    const std::vector<double> correlated = c.correlated();
    for (std::size_t j = 0; j < c.components.size(); ++j) {
        sources.push_back(
            {degrees_of_freedom_of(inputs.components[c.components[j]]), estimates[c.components[j]]});
        parts.push_back({j, c.a[j] * correlated[j]});
    }
    return detail::WelchSatterthwaite(std::move(sources), c.pairs)
        .effective(parts, c.variance())
        .degrees_of_freedom;
}

}  // namespace covaria
