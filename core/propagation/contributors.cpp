// Results with everything of one contributor held, and of it alone ("ideal robot", "ideal instrument").
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/propagation/condensed_law.h"
#include "core/propagation/contributions.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

std::vector<bool> brought_in_by(const InputSet& inputs, const std::string& contributor, bool by_it) {
    std::vector<bool> counts;
    for (const UncertaintyComponent& c : inputs.components)
        counts.push_back((c.contributor == contributor) == by_it);
    return counts;
}

struct Contributor {
    std::string id;
    Name name;
    std::size_t components = 0;  ///< number of those that have an uncertainty
};

std::vector<Contributor> contributors_in(const InputSet& inputs, const LawOfPropagation& law) {
    std::vector<Contributor> found;
    for (std::size_t i = 0; i < inputs.components.size(); ++i) {
        if (!(law.u(static_cast<Eigen::Index>(i)) > 0.0)) continue;
        const UncertaintyComponent& c = inputs.components[i];
        auto place = std::find_if(found.begin(), found.end(),
                                  [&](const Contributor& known) { return known.id == c.contributor; });
        if (place == found.end())
            place = found.insert(
                found.end(),
                {c.contributor, c.contributor_name.empty() ? c.contributor : c.contributor_name});
        ++place->components;
    }
    return found;
}

/// Two assets may have one name: their ids tell them apart.
Name title_of(const Contributor& contributor, const std::vector<Contributor>& all) {
    const bool alone = std::count_if(all.begin(), all.end(), [&](const Contributor& other) {
                           return other.name == contributor.name;
                       }) == 1;
    return alone ? contributor.name : Name(contributor.name + " (" + contributor.id + ")");
}

InputSet with_held(InputSet inputs, const std::vector<bool>& counts) {
    for (std::size_t c = 0; c < counts.size(); ++c)
        inputs.components[c].held = inputs.components[c].held || !counts[c];
    return inputs;
}

/// Rounding makes a variance of nothing negative.
double uncertainty_of(double variance) {
    return variance < 0.0 ? 0.0 : std::sqrt(variance);
}

}  // namespace

ContributorSums::ContributorSums(const InputSet& inputs, const LawOfPropagation& law,
                                 const Correlations& correlations)
    : correlations_(correlations), part_(inputs.components.size(), 0.0) {
    const std::vector<Contributor> contributors = contributors_in(inputs, law);
    std::unordered_map<std::string, std::size_t> numbers;
    for (const Contributor& c : contributors) {
        numbers.emplace(c.id, results_.size());
        results_.push_back({title_of(c, contributors), c.components, {}, {}});
        for (auto* both : {&results_.back().without, &results_.back().alone})
            both->first_order.resize(static_cast<std::size_t>(law.estimate.size()));
    }
    for (const UncertaintyComponent& c : inputs.components) {
        const auto number = numbers.find(c.contributor);
        who_.push_back(number == numbers.end() ? nobody : number->second);
    }
}

void ContributorSums::take(std::size_t output, const std::vector<PropagationTerm>& terms, bool is_known) {
    without_.assign(results_.size(), 0.0);
    alone_.assign(results_.size(), 0.0);
    for (const PropagationTerm& term : terms) {
        part_[term.component] = term.contribution;
        const std::size_t by = who_[term.component];
        add(by, by, term.contribution * term.contribution);
    }
    for (const ComponentCorrelation& r : correlations_)
        add(who_[r.first], who_[r.second], 2.0 * r.coefficient * part_[r.first] * part_[r.second]);
    for (const PropagationTerm& term : terms) part_[term.component] = 0.0;
    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < results_.size(); ++k) {
        results_[k].without.first_order[output] = is_known ? uncertainty_of(without_[k]) : not_known;
        results_[k].alone.first_order[output] = is_known ? uncertainty_of(alone_[k]) : not_known;
    }
}

void ContributorSums::add(std::size_t a, std::size_t b, double variance) {
    for (std::size_t k = 0; k < without_.size(); ++k)
        if (k != a && k != b) without_[k] += variance;
    if (a == b && a != nobody) alone_[a] += variance;
}

std::vector<ContributorResult> contributors_of(const InputSet& inputs, const LawOfPropagation& law,
                                               const Correlations& correlations) {
    if (law.condensed) return law.condensed->contributors;
    ContributorSums sums(inputs, law, correlations);
    if (!sums.are_several()) return {};
    for (std::size_t j = 0; j < law.terms.size(); ++j) sums.take(j, law.terms[j], law.differentiable[j]);
    return sums.take_results();
}

Result<void> add_contributor_trials(std::vector<ContributorResult>& contributors, const RunContext& context,
                                    const InputSet& inputs, const LawOfPropagation& law,
                                    const Correlations& correlations, std::uint64_t trials) {
    const std::vector<Contributor> who = contributors_in(inputs, law);
    // With two contributors, what one gives alone is what remains without the other.
    const bool two = contributors.size() == 2;
    const std::size_t cases = two ? 2 : 2 * contributors.size();
    const WorkEnd end = run_each(cases, context.monitor, [&](std::uint64_t number) {
        const std::size_t i = number % contributors.size();
        const bool alone = number >= contributors.size();
        const InputSet part = with_held(inputs, brought_in_by(inputs, who[i].id, alone));
        const DrawPlan plan(part, correlations);
        TrialSource source = context.source;
        source.plan = &plan;
        auto& uncertainties = alone ? contributors[i].alone : contributors[i].without;
        uncertainties.monte_carlo =
            trial_uncertainties(source, trials, context.monitor, &uncertainties.failed_trials);
    });
    if (end == WorkEnd::cancelled || context.monitor.stopped())
        return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    for (std::size_t i = 0; two && i < 2; ++i) {
        contributors[i].alone.monte_carlo = contributors[1 - i].without.monte_carlo;
        contributors[i].alone.failed_trials = contributors[1 - i].without.failed_trials;
    }
    return {};
}

}  // namespace covaria::detail
