#include "core/report/component_labels.h"

#include <algorithm>
#include <map>
#include <string>

#include "core/text/symbol.h"

namespace covaria {
namespace {

enum class IdPart { first, all_but_last };

/// Labels that several rows have get what their component is of, from its id: "b_1.tracker.azimuth".
void tell_apart(std::vector<Text>& labels, const UncertaintyBudget& budget,
                const std::vector<BudgetRow>& rows, IdPart part) {
    std::map<Text, int> uses;
    for (const Text& label : labels) ++uses[label];
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (uses[labels[i]] < 2) continue;
        const std::string& id = budget.components[rows[i].component].id;
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
    return alone || component.name.empty() ? symbol : symbol + ", " + name;
}

}  // namespace

std::vector<Text> component_labels(const UncertaintyBudget& budget, const std::vector<BudgetRow>& rows,
                                   const DocumentLanguage& in) {
    std::map<std::vector<std::string>, int> uses;
    for (const BudgetRow& row : rows) ++uses[budget.components[row.component].quantities];
    std::vector<Text> labels;
    for (const BudgetRow& row : rows) {
        const BudgetComponent& component = budget.components[row.component];
        labels.push_back(label_of(component, uses[component.quantities] == 1, in));
    }
    std::vector<Text> shorter = labels;
    tell_apart(shorter, budget, rows, IdPart::first);
    if (are_different(shorter)) return shorter;
    tell_apart(labels, budget, rows, IdPart::all_but_last);
    return labels;
}

}  // namespace covaria
