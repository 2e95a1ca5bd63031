#include "core/quantity/effective_degrees.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/quantity/component_pairs.h"

namespace covaria::detail {

WelchSatterthwaite::WelchSatterthwaite(std::vector<Source> sources,
                                       const std::vector<ComponentCorrelation>& correlations)
    : sources_(std::move(sources)),
      partners_(sources_.size()),
      set_of_(sources_.size(), InputSet::npos),
      terms_(sources_.size(), 0.0) {
    std::vector<ComponentCorrelation> links = correlations;
    std::vector<std::size_t> member;  // last member met of each estimate
    for (std::size_t c = 0; c < sources_.size(); ++c) {
        const std::size_t estimate = sources_[c].estimate;
        if (estimate == InputSet::npos) continue;
        if (estimate >= member.size()) member.resize(estimate + 1, c);
        links.push_back({member[estimate], c, 1.0});
        member[estimate] = c;
    }
    of_estimate_.assign(member.size(), 0.0);
    for (const auto& set : correlated_sets(sources_.size(), links)) {
        for (const std::size_t c : set) set_of_[c] = sets_.size();
        sets_.emplace_back();
    }
    for (const ComponentCorrelation& c : correlations) {
        const Source &a = sources_[c.first], &b = sources_[c.second];
        const bool finite = std::isfinite(a.degrees_of_freedom) && std::isfinite(b.degrees_of_freedom);
        const bool same = a.estimate != InputSet::npos && a.estimate == b.estimate;
        if (finite && !same && c.coefficient != 0.0)
            partners_[c.first].push_back(
                {c.second,
                 c.coefficient * c.coefficient / std::sqrt(a.degrees_of_freedom * b.degrees_of_freedom)});
    }
}

WelchSatterthwaite::Effective WelchSatterthwaite::effective(std::span<const Part> parts, double variance) {
    Effective result;
    if (!(variance > 0.0)) return result;
    for (const Part& part : parts) terms_[part.component] = part.variance / variance;
    double sum = 0.0;
    for (const Part& part : parts) {
        if (set_of_[part.component] == InputSet::npos)
            sum +=
                terms_[part.component] * terms_[part.component] / sources_[part.component].degrees_of_freedom;
        else
            add(part, result);
    }
    for (const Part& part : parts)
        if (set_of_[part.component] != InputSet::npos) sum += take(part);
    for (const Part& part : parts) terms_[part.component] = 0.0;
    if (sum > 0.0) result.degrees_of_freedom = 1.0 / sum;
    return result;
}

void WelchSatterthwaite::add(const Part& part, Effective& result) {
    const Source& source = sources_[part.component];
    const double term = terms_[part.component];
    Set& set = sets_[set_of_[part.component]];
    set.variance += term;
    if (term != 0.0) set.least = std::min(set.least, source.degrees_of_freedom);
    if (source.estimate == InputSet::npos) {
        set.terms += term * term / source.degrees_of_freedom;
    } else {  // (sum + term)^2 - sum^2, so that the set has the square of the whole at the end
        double& sum = of_estimate_[source.estimate];
        set.terms += term * (term + 2.0 * sum) / source.degrees_of_freedom;
        sum += term;
    }
    for (const Partner& partner : partners_[part.component]) {
        const double product = term * terms_[partner.component];
        result.approximate = result.approximate || product != 0.0;
        set.terms += 2.0 * partner.weight * std::max(0.0, product);
    }
}

/// Adds the part of a set to 1/nu_eff when one of its members is first met; afterwards the set is empty.
double WelchSatterthwaite::take(const Part& part) {
    const std::size_t estimate = sources_[part.component].estimate;
    if (estimate != InputSet::npos) of_estimate_[estimate] = 0.0;
    const Set set = std::exchange(sets_[set_of_[part.component]], {});
    return std::clamp(set.terms, 0.0, set.variance * set.variance / set.least);
}

}  // namespace covaria::detail
