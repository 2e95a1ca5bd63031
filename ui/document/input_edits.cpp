// Conversion between components of the core and what is typed.
#include "ui/document/input_edits.h"

#include <algorithm>
#include <cmath>

#include "ui/document/setup_address.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

const DistributionKindInfo* find_kind(std::string_view key) {
    const auto& kinds = distribution_kinds();
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.key == key; });
    return found == kinds.end() ? nullptr : &*found;
}

bool is_empty(const InputEdit& edit) {
    return edit == InputEdit{.symbol = edit.symbol};
}

/// Parameters without a description of their own are the list of a discrete distribution: values, then
/// probabilities.
DistributionParameterInfo info_at(const DistributionKindInfo& kind, std::size_t index, std::size_t count) {
    if (index < kind.parameters.size()) return kind.parameters[index];
    return {"", "", index < count / 2, false};
}

template <class Convert>
std::vector<double> convert_all(std::string_view kind_key, std::vector<double> parameters,
                                Convert&& convert) {
    const DistributionKindInfo* kind = find_kind(kind_key);
    if (!kind) return parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const DistributionParameterInfo info = info_at(*kind, i, parameters.size());
        if (info.has_unit) parameters[i] = convert(parameters[i], info.is_interval);
    }
    return parameters;
}

double clean(double value) {
    return QString::number(value, 'g', 15).toDouble();
}

}  // namespace

InputEdit find_input_edit(const Project& project, const std::string& analysis, const std::string& symbol) {
    if (const AnalysisEntry* entry = project.find_analysis(analysis))
        for (const InputEdit& edit : entry->inputs)
            if (edit.symbol == symbol) return edit;
    return {.symbol = symbol};
}

void change_input(Document& document, const std::string& analysis, const std::string& symbol,
                  const QString& text, const std::function<void(InputEdit&)>& change,
                  const QString& merge_key) {
    const auto edit_project = [&](Project& project) {
        AnalysisEntry* entry = find_analysis_entry(project, analysis);
        if (!entry) return;
        auto& edits = entry->inputs;
        auto edit =
            std::find_if(edits.begin(), edits.end(), [&](const auto& e) { return e.symbol == symbol; });
        if (edit == edits.end()) edit = edits.insert(edits.end(), {.symbol = symbol});
        change(*edit);
        if (is_empty(*edit)) edits.erase(edit);
    };
    document.apply(text, edit_project, merge_key);
}

void set_distribution(ComponentEdit& edit, const Distribution& distribution) {
    edit.distribution = distribution.kind();
    edit.parameters = convert_all(
        edit.distribution, distribution_parameters(distribution), [&](double value, bool interval) {
            return clean(interval ? edit.unit.interval_from_si(value) : edit.unit.from_si(value));
        });
}

ComponentEdit to_edit(const UncertaintyComponent& component) {
    ComponentEdit edit;
    edit.name = component.name;
    edit.unit = component.unit;
    edit.type = component.type;
    edit.origin = component.origin;
    if (std::isfinite(component.degrees_of_freedom)) edit.degrees_of_freedom = component.degrees_of_freedom;
    set_distribution(edit, component.distribution);
    return edit;
}

Result<Distribution> distribution_of(const ComponentEdit& edit) {
    return distribution_from(
        edit.distribution, convert_all(edit.distribution, edit.parameters, [&](double value, bool interval) {
            return interval ? edit.unit.interval_to_si(value) : edit.unit.to_si(value);
        }));
}

ComponentEdit in_unit(ComponentEdit edit, const Unit& unit) {
    edit.parameters = convert_all(edit.distribution, edit.parameters, [&](double value, bool interval) {
        return clean(interval ? unit.interval_from_si(edit.unit.interval_to_si(value))
                              : unit.from_si(edit.unit.to_si(value)));
    });
    edit.unit = unit;
    return edit;
}

}  // namespace covaria::ui
