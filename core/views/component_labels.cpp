#include "core/views/component_labels.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "core/text/symbol.h"

namespace covaria {
namespace {

enum class Of { owner, first_of_id, all_but_last_of_id };

Text owner_of(const BudgetComponent& component, Of part) {
    if (part == Of::owner && !component.owner.empty()) return running_text(component.owner);
    const std::string& id = component.id;
    const std::size_t end = part == Of::all_but_last_of_id ? id.rfind('.') : id.find('.');
    return symbols_text(id.substr(0, end));
}

/// The labels, of which those that several rows have get the owner of their component before them: by its
/// name ("Tracker 2"), or from its id: "b_1.tracker.azimuth".
std::vector<Text> told_apart(std::vector<Text> labels, const std::vector<const BudgetComponent*>& components,
                             Of part) {
    std::map<Text, int> uses;
    for (const Text& label : labels) ++uses[label];
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (uses[labels[i]] > 1) labels[i] = owner_of(*components[i], part) + ": " + labels[i];
    return labels;
}

bool are_different(std::vector<Text> labels) {
    std::sort(labels.begin(), labels.end());
    return std::adjacent_find(labels.begin(), labels.end()) == labels.end();
}

Text label_of(const BudgetComponent& component, bool alone, const DocumentLanguage& in) {
    const Text name = running_text(in.say(component.name));
    if (component.quantities.size() != 1) return component.name.empty() ? symbols_text(component.id) : name;
    const Text symbol = symbol_text(component.quantities.front());
    if (alone || component.name.empty()) return symbol;
    const bool says_it = name.letters().starts_with(symbol.letters() + ", ");  // a name such as "d_4, range"
    return says_it ? name : symbol + ", " + name;
}

}  // namespace

std::vector<Text> component_labels(const std::vector<const BudgetComponent*>& components,
                                   const DocumentLanguage& in) {
    std::map<std::vector<std::string>, int> uses;
    for (const BudgetComponent* component : components) ++uses[component->quantities];
    std::vector<Text> labels;
    for (const BudgetComponent* component : components)
        labels.push_back(label_of(*component, uses[component->quantities] == 1, in));
    for (const Of part : {Of::owner, Of::first_of_id})
        if (std::vector<Text> told = told_apart(labels, components, part); are_different(told)) return told;
    return told_apart(std::move(labels), components, Of::all_but_last_of_id);
}

std::vector<Text> component_labels(const UncertaintyBudget& budget, const std::vector<BudgetRow>& rows,
                                   const DocumentLanguage& in) {
    std::vector<const BudgetComponent*> components;
    for (const BudgetRow& row : rows) components.push_back(&budget.components[row.component]);
    return component_labels(components, in);
}

void add_label_column(Table& table, std::function<std::vector<Text>()> labels) {
    const auto made = std::make_shared<std::vector<Text>>();
    table
        .add("label",
             [made, labels = std::move(labels)](std::size_t row) -> Cell {
                 if (made->empty()) *made = labels();
                 return (*made)[row];
             })
        .window("Input quantity", "Quantity or component of uncertainty, as at the bars of the chart")
        .not_in_files();
}

}  // namespace covaria
