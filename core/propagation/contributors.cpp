// Results with everything of one contributor held, and of it alone ("ideal robot", "ideal instrument").
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/propagation/contributions.h"
#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

constexpr std::size_t nobody = static_cast<std::size_t>(-1);
constexpr double not_known_to_first_order = std::numeric_limits<double>::quiet_NaN();

/// Rounding makes a variance of nothing negative.
double uncertainty_of(double variance) {
    return variance < 0.0 ? 0.0 : std::sqrt(variance);
}

/// Variances of one output without each contributor, and of each alone.
class Variances {
public:
    explicit Variances(std::size_t contributors) : without(contributors), alone(contributors) {}
    void clear() {
        std::fill(without.begin(), without.end(), 0.0);
        std::fill(alone.begin(), alone.end(), 0.0);
    }
    /// Adds the variance that components of contributors a and b (which may be the same) bring in together.
    void add(std::size_t a, std::size_t b, double variance) {
        for (std::size_t k = 0; k < without.size(); ++k)
            if (k != a && k != b) without[k] += variance;
        if (a == b && a != nobody) alone[a] += variance;
    }

    std::vector<double> without, alone;
};

/// u of the outputs without, and of, each contributor.
void add_first_order(const LawOfPropagation& law, const Correlations& correlations,
                     const std::vector<std::size_t>& who, std::vector<ContributorResult>& results) {
    std::vector<double> part(who.size(), 0.0);
    Variances variances(results.size());
    for (std::size_t j = 0; j < law.terms.size(); ++j) {
        const std::vector<PropagationTerm>& terms = law.terms[j];
        variances.clear();
        for (const PropagationTerm& term : terms) {
            part[term.component] = term.contribution;
            const std::size_t by = who[term.component];
            variances.add(by, by, term.contribution * term.contribution);
        }
        for (const ComponentCorrelation& r : correlations)
            variances.add(who[r.first], who[r.second], 2.0 * r.coefficient * part[r.first] * part[r.second]);
        for (const PropagationTerm& term : terms) part[term.component] = 0.0;
        if (!law.differentiable[j]) {
            std::fill(variances.without.begin(), variances.without.end(), not_known_to_first_order);
            std::fill(variances.alone.begin(), variances.alone.end(), not_known_to_first_order);
        }
        for (std::size_t k = 0; k < results.size(); ++k) {
            results[k].without.first_order.push_back(uncertainty_of(variances.without[k]));
            results[k].alone.first_order.push_back(uncertainty_of(variances.alone[k]));
        }
    }
}

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

}  // namespace

std::vector<ContributorResult> contributors_of(const InputSet& inputs, const LawOfPropagation& law,
                                               const Correlations& correlations) {
    const std::vector<Contributor> contributors = contributors_in(inputs, law);
    if (contributors.size() < 2) return {};
    std::vector<ContributorResult> results;
    std::unordered_map<std::string, std::size_t> numbers;
    for (const Contributor& c : contributors) {
        numbers.emplace(c.id, results.size());
        results.push_back({title_of(c, contributors), c.components, {}, {}});
    }
    std::vector<std::size_t> who;
    for (const UncertaintyComponent& c : inputs.components) {
        const auto number = numbers.find(c.contributor);
        who.push_back(number == numbers.end() ? nobody : number->second);
    }
    add_first_order(law, correlations, who, results);
    return results;
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
