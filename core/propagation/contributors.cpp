// Results with everything of one contributor held, and of it alone ("ideal robot", "ideal instrument").
#include <algorithm>
#include <cmath>

#include "core/propagation/contributions.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

/// u of the outputs when the components for which `counts` is false are held.
std::vector<double> first_order_of(const LawOfPropagation& law, const Correlations& correlations,
                                   const std::vector<bool>& counts) {
    std::vector<double> u, part(counts.size(), 0.0);
    for (const std::vector<PropagationTerm>& terms : law.terms) {
        double variance = 0.0;
        for (const PropagationTerm& term : terms) {
            if (!counts[term.component]) continue;
            part[term.component] = term.contribution;
            variance += term.contribution * term.contribution;
        }
        for (const ComponentCorrelation& r : correlations)
            variance += 2.0 * r.coefficient * part[r.first] * part[r.second];
        for (const PropagationTerm& term : terms) part[term.component] = 0.0;
        u.push_back(std::sqrt(std::max(0.0, variance)));
    }
    return u;
}

std::vector<bool> brought_in_by(const InputSet& inputs, const std::string& contributor, bool by_it) {
    std::vector<bool> counts;
    for (const UncertaintyComponent& c : inputs.components)
        counts.push_back((c.contributor == contributor) == by_it);
    return counts;
}

struct Contributor {
    std::string id, name;
    std::size_t components = 0;  ///< that have an uncertainty
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
std::string title_of(const Contributor& contributor, const std::vector<Contributor>& all) {
    const bool alone = std::count_if(all.begin(), all.end(), [&](const Contributor& other) {
                           return other.name == contributor.name;
                       }) == 1;
    return alone ? contributor.name : contributor.name + " (" + contributor.id + ")";
}

InputSet with_held(InputSet inputs, const std::vector<bool>& counts) {
    for (std::size_t c = 0; c < counts.size(); ++c)
        inputs.components[c].held = inputs.components[c].held || !counts[c];
    return inputs;
}

}  // namespace

std::vector<ContributorResult> contributors_of(const InputSet& inputs, const LawOfPropagation& law,
                                               const Correlations& correlations) {
    const std::vector<Contributor> contributors = contributors_in(inputs, law);
    if (contributors.size() < 2) return {};
    std::vector<ContributorResult> results;
    for (const Contributor& c : contributors) {
        ContributorResult result{title_of(c, contributors), c.components, {}, {}};
        result.without.first_order = first_order_of(law, correlations, brought_in_by(inputs, c.id, false));
        result.alone.first_order = first_order_of(law, correlations, brought_in_by(inputs, c.id, true));
        results.push_back(std::move(result));
    }
    return results;
}

Result<void> add_contributor_trials(std::vector<ContributorResult>& contributors, const RunContext& context,
                                    const InputSet& inputs, const LawOfPropagation& law,
                                    const Correlations& correlations, std::uint64_t trials) {
    const std::vector<Contributor> who = contributors_in(inputs, law);
    // Of two, what one gives alone is what remains without the other.
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
        return fail(ErrorCode::cancelled, "the evaluation was stopped");
    for (std::size_t i = 0; two && i < 2; ++i) {
        contributors[i].alone.monte_carlo = contributors[1 - i].without.monte_carlo;
        contributors[i].alone.failed_trials = contributors[1 - i].without.failed_trials;
    }
    return {};
}

}  // namespace covaria::detail
