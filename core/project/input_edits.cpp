#include "core/project/input_edits.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/in_quotes.h"
#include "core/project/analysis_fields.h"
#include "core/project/component_edit.h"
#include "core/project/edit_fields.h"
#include "core/quantity/component_pairs.h"
#include "core/setup/difference_remedy.h"
#include "core/setup/message_text.h"
#include "core/setup/setup_schema.h"
#include "core/text/symbol.h"

namespace covaria {

namespace {

std::size_t find_component(const InputSet& inputs, const std::string& id) {
    for (std::size_t i = 0; i < inputs.components.size(); ++i)
        if (inputs.components[i].id == id) return i;
    return InputSet::npos;
}

std::vector<std::string> component_ids(const InputSet& inputs) {
    std::vector<std::string> ids;
    for (const UncertaintyComponent& component : inputs.components) ids.push_back(component.id);
    return ids;
}

bool is_own(const InputSet& inputs, std::size_t component) {
    const auto uses = [&](const InputQuantity& quantity) {
        return std::any_of(quantity.shares.begin(), quantity.shares.end(),
                           [&](const Share& share) { return share.component == component; });
    };
    return std::count_if(inputs.quantities.begin(), inputs.quantities.end(), uses) == 1;
}

class QuantityEdit {
public:
    QuantityEdit(InputSet& inputs, std::size_t index, const InputEdit& edit, std::string path,
                 Problems& problems)
        : inputs_(inputs),
          quantity_(inputs.quantities[index]),
          index_(index),
          edit_(edit),
          path_(std::move(path)),
          problems_(problems) {}

    void apply() {
        if (edit_.components) replace_components();
        if (edit_.combination) quantity_.combination = *edit_.combination;
        if (edit_.estimate) set_estimate();
        if (edit_.held) hold();
    }

private:
    void set_estimate() {
        const Message objection = unit_objection(edit_.symbol, *edit_.estimate, quantity_.unit);
        if (!objection.empty()) {
            const std::string place = path_ + input_edit_fields().place(&InputEdit::estimate);
            problems_.error(place, objection);
            problems_.items().back().remedies =
                remedies_as_difference(*edit_.estimate, quantity_.unit, place);
            return;
        }
        quantity_.offset += edit_.estimate->si() - estimate_of(inputs_, index_);
    }

    void replace_components() {
        const std::size_t before = problems_.items().size();
        std::vector<UncertaintyComponent> components;
        for (std::size_t i = 0; i < edit_.components->size(); ++i)
            components.push_back(component((*edit_.components)[i], i));
        if (problems_.items().size() == before) put_in_place(components);
    }

    UncertaintyComponent component(const ComponentEdit& edit, std::size_t i) {
        const std::string place =
            path_ + input_edit_fields().place(&InputEdit::components) + "/" + std::to_string(i);
        const Message shown = edit.name.empty() ? tell<"component %1">(i + 1) : Message(edit.name);
        const Message what = tell<"%1 of %2">(in_quotes(shown), in_quotes(edit_.symbol));
        if (edit.unit.dimension() != quantity_.unit.dimension())
            problems_.error(place + component_fields().place(&ComponentEdit::unit),
                            tell<"%1 is %2; the unit %3 of %4 is the unit of %5">(
                                in_quotes(edit_.symbol), dimension_words(quantity_.unit),
                                in_quotes(edit.unit.text()), in_quotes(shown), dimension_words(edit.unit)));
        const auto distribution = distribution_of(edit);
        if (!distribution)
            problems_.error(place + component_fields().place(&ComponentEdit::parameters),
                            what + ": " + distribution.error().message);
        UncertaintyComponent made{edit_.symbol + ".edit" + std::to_string(i + 1), shown, edit.unit};
        if (distribution) made.distribution = *distribution;
        made.type = edit.type;
        made.degrees_of_freedom = degrees_of_freedom_of(edit, made.distribution);
        if (!(made.degrees_of_freedom > 0))
            problems_.error(place + component_fields().place(&ComponentEdit::degrees_of_freedom),
                            tell<"%1: the degrees of freedom must be greater than zero">(what));
        made.origin = edit.origin;
        return made;
    }

    void put_in_place(const std::vector<UncertaintyComponent>& components) {
        const std::vector<std::size_t> places = give_up_own();
        const UncertaintyComponent before =
            places.empty() ? UncertaintyComponent{} : inputs_.components[places[0]];
        for (std::size_t i = 0; i < components.size(); ++i) {
            std::size_t place = i < places.size() ? places[i] : InputSet::npos;
            if (place == InputSet::npos)
                place = inputs_.add(components[i]);
            else
                inputs_.components[place] = components[i];
            inputs_.components[place].contributor = before.contributor;
            inputs_.components[place].contributor_name = before.contributor_name;
            quantity_.shares.push_back({place, 1.0});
        }
    }

    // Takes the quantity's own components out of it, with their correlations; their places stay. Components
    // of its point are given up too, and stay in the other coordinates.
    std::vector<std::size_t> give_up_own() {
        std::vector<std::size_t> places;
        for (const Share& share : quantity_.shares)
            if (is_own(inputs_, share.component)) places.push_back(share.component);
        const auto given_up = [&](std::size_t component) {
            return std::find(places.begin(), places.end(), component) != places.end();
        };
        std::erase_if(quantity_.shares, [&](const Share& share) {
            return given_up(share.component) || inputs_.components[share.component].local;
        });
        std::erase_if(inputs_.correlations, [&](const ComponentCorrelation& correlation) {
            return given_up(correlation.first) || given_up(correlation.second);
        });
        for (VarianceEstimate& estimate : inputs_.variance_estimates)
            std::erase_if(estimate.components, given_up);
        for (const std::size_t place : places) inputs_.components[place].held = true;
        return places;
    }

    void hold() {
        std::erase_if(quantity_.shares, [&](const Share& share) {
            UncertaintyComponent& component = inputs_.components[share.component];
            if (is_own(inputs_, share.component)) {
                component.held = true;
                return false;
            }
            quantity_.offset += share.factor * component.distribution.mean();
            return true;
        });
    }

    InputSet& inputs_;
    InputQuantity& quantity_;
    std::size_t index_;
    const InputEdit& edit_;
    std::string path_;
    Problems& problems_;
};

void hold_component(InputSet& inputs, const InputEdit& edit, const std::string& path, Problems& problems) {
    const std::size_t component = find_component(inputs, edit.symbol);
    if (component == InputSet::npos) {
        std::vector<std::string> known;
        for (const InputQuantity& quantity : inputs.quantities) known.push_back(quantity.symbol);
        if (edit.held) {
            const auto ids = component_ids(inputs);
            known.insert(known.end(), ids.begin(), ids.end());
        }
        problems.error(path + input_edit_fields().place(&InputEdit::symbol),
                       tell<"the model has no input quantity %1%2">(
                           in_quotes(edit.symbol), did_you_mean(plain_symbol(edit.symbol), known)));
        return;
    }
    if (edit.estimate || edit.components || edit.combination)
        problems.error(
            path + input_edit_fields().place(&InputEdit::symbol),
            tell<"%1 is a component, not an input quantity: it can be held, but not be edited otherwise">(
                in_quotes(edit.symbol)));
    else
        inputs.components[component].held = edit.held;
}

/// The parts that a correlation is stated for: one component, or a quantity as a whole, which is its
/// components by their correlation with its total deviation.
std::vector<Share> correlated_parts(const InputSet& inputs, const std::string& name, const std::string& path,
                                    Problems& problems) {
    if (const std::size_t found = find_component(inputs, name); found != InputSet::npos)
        return {{found, 1.0}};
    if (const std::size_t found = inputs.find(name); found != InputSet::npos) {
        std::vector<Share> parts = detail::correlations_with_total(inputs, found);
        if (parts.empty())
            problems.error(path, tell<"%1 has no uncertainty to be correlated">(in_quotes(name)));
        return parts;
    }
    std::vector<std::string> known = component_ids(inputs);
    for (const InputQuantity& quantity : inputs.quantities) known.push_back(quantity.symbol);
    problems.error(
        path, tell<"there is no component or quantity %1%2">(in_quotes(name), did_you_mean(name, known)));
    return {};
}

/// Sets a correlation in place of the one that the model declares between the same two, if there is one.
void set_correlation(InputSet& inputs, std::size_t first, std::size_t second, double coefficient) {
    std::erase_if(inputs.correlations, [&](const ComponentCorrelation& other) {
        return std::minmax(other.first, other.second) == std::minmax(first, second);
    });
    inputs.correlations.push_back({first, second, coefficient});
}

void apply_correlation(InputSet& inputs, const CorrelationEdit& edit, const std::string& path,
                       Problems& problems) {
    const std::size_t before = problems.items().size();
    const std::vector<Share> first = correlated_parts(
        inputs, edit.first, path + correlation_fields().place(&CorrelationEdit::first), problems);
    const std::vector<Share> second = correlated_parts(
        inputs, edit.second, path + correlation_fields().place(&CorrelationEdit::second), problems);
    if (problems.items().size() > before) return;
    if (edit.first == edit.second)
        return problems.error(path + correlation_fields().place(&CorrelationEdit::second),
                              tell<"%1 cannot be correlated with itself">(in_quotes(edit.first)));
    if (!(std::abs(edit.coefficient) <= 1.0))
        return problems.error(
            path + correlation_fields().place(&CorrelationEdit::coefficient),
            tell<"the correlation coefficient of %1 and %2 must lie between -1 and 1; it is %3">(
                in_quotes(edit.first), in_quotes(edit.second), readable_number(edit.coefficient)));
    for (const Share& a : first)
        for (const Share& b : second)
            if (a.component == b.component)
                return problems.error(path,
                                      tell<"%1 and %2 have the component %3 in common, which correlates "
                                           "them; state the correlation of other components instead">(
                                          in_quotes(edit.first), in_quotes(edit.second),
                                          in_quotes(inputs.components[a.component].name)));
    // The covariance of the totals is then the coefficient times their standard uncertainties.
    for (const Share& a : first)
        for (const Share& b : second)
            set_correlation(inputs, a.component, b.component, edit.coefficient * a.factor * b.factor);
}

void apply_inputs(InputSet& inputs, const AnalysisEntry& analysis, Problems& problems) {
    std::set<std::string> edited;
    for (std::size_t i = 0; i < analysis.inputs.size(); ++i) {
        const InputEdit& edit = analysis.inputs[i];
        const std::string path = analysis_fields().place(&AnalysisEntry::inputs, i);
        if (!edited.insert(edit.symbol).second)
            problems.error(path + input_edit_fields().place(&InputEdit::symbol),
                           tell<"%1 is edited twice">(in_quotes(edit.symbol)));
        else if (const std::size_t quantity = inputs.find(edit.symbol); quantity != InputSet::npos)
            QuantityEdit(inputs, quantity, edit, path, problems).apply();
        else
            hold_component(inputs, edit, path, problems);
    }
}

}  // namespace

void apply_correlations(InputSet& inputs, const std::vector<CorrelationEdit>& edits, Problems& problems) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const std::string path = analysis_fields().place(&AnalysisEntry::correlations, i);
        if (pairs.insert(std::minmax(edits[i].first, edits[i].second)).second)
            apply_correlation(inputs, edits[i], path, problems);
        else
            problems.error(path, tell<"the correlation of %1 and %2 is given twice">(
                                     in_quotes(edits[i].first), in_quotes(edits[i].second)));
    }
}

InputSet apply_edits(InputSet inputs, const AnalysisEntry& analysis, Problems& problems) {
    const std::size_t before = problems.items().size();
    apply_inputs(inputs, analysis, problems);
    apply_correlations(inputs, analysis.correlations, problems);
    if (problems.items().size() > before) return inputs;
    if (const auto resolved = resolved_correlations(inputs); !resolved)
        problems.error(
            analysis.correlations.empty() ? "/setup" : analysis_fields().place(&AnalysisEntry::correlations),
            resolved.error().message);
    return inputs;
}

}  // namespace covaria
