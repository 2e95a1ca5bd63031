#include "core/report/component_labels.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "core/text/symbol.h"

namespace covaria {
namespace {

enum class IdPart { first, all_but_last };

/// Labels that several rows have get what their component is of, from its id: "b_1.tracker.azimuth".
void tell_apart(std::vector<Text>& labels, const std::vector<const BudgetComponent*>& components,
                IdPart part) {
    std::map<Text, int> uses;
    for (const Text& label : labels) ++uses[label];
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (uses[labels[i]] < 2) continue;
        const std::string& id = components[i]->id;
        const std::size_t end = part == IdPart::first ? id.find('.') : id.rfind('.');
        labels[i] = symbols_text(id.substr(0, end)) + ": " + labels[i];
    }
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
    const bool says_it = name.letters().starts_with(symbol.letters() + ", ");  // "d_4, range"
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
    std::vector<Text> shorter = labels;
    tell_apart(shorter, components, IdPart::first);
    if (are_different(shorter)) return shorter;
    tell_apart(labels, components, IdPart::all_but_last);
    return labels;
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
