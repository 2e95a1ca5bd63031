#include "ui/document/component_source.h"

#include <algorithm>

#include "ui/document/setup_address.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

QString place_of_component(const Project& project, const PreparedAnalysis& analysis,
                           const BudgetComponent& component) {
    const SetupAddress own{SetupOwner::analysis, analysis.id};
    if (!exists(project, own)) return {};
    const auto& all = analysis.inputs.components;
    const auto stated =
        std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.id == component.id; });
    if (stated != all.end())
        for (const SetupAddress& from : {SetupAddress{SetupOwner::asset, stated->stated_by},
                                         SetupAddress{SetupOwner::asset, stated->contributor},
                                         SetupAddress{SetupOwner::analysis, stated->contributor}})
            if (!from.id.empty() && exists(project, from)) return to_qt(entry_path(project, from));
    if (stated != all.end() && !stated->source.empty())
        return to_qt(setup_path(project, own) + stated->source);
    if (component.quantities.empty()) return {};
    const std::string& symbol = component.quantities.front();
    for (const InputQuantity& input : analysis.inputs.quantities)
        if (input.symbol == symbol && input.group == component.group && !input.source.empty())
            return to_qt(setup_path(project, own) + input.source);
    return to_qt(entry_path(project, own) + "/inputs/" + symbol);
}

}  // namespace covaria::ui
