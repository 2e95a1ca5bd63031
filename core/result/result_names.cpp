#include "core/result/result_names.h"

#include <algorithm>
#include <map>

namespace covaria {

namespace {

Name name_of_contributor(const UncertaintyComponent& c) {
    return c.contributor_name.empty() ? c.contributor : c.contributor_name;
}

}  // namespace

void take_names(UncertaintyResult& result, const std::vector<OutputQuantity>& outputs,
                const InputSet& inputs) {
    const auto& before = result.inputs->components;
    const bool same = result.outputs.size() == outputs.size() && before.size() == inputs.components.size() &&
                      result.budget.components.size() == before.size();
    if (!same) return;
    std::map<std::string, Name> contributors;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const UncertaintyComponent& now = inputs.components[i];
        const Name was = name_of_contributor(before[i]), is = name_of_contributor(now);
        const std::string id = " (" + now.contributor + ")";  // added where two have one name
        contributors[was] = is;
        contributors[was + id] = is + id;
        BudgetComponent& row = result.budget.components[i];
        row.name = now.name;
        row.origin = now.origin;
        row.owner = now.contributor_name;
        std::copy_n(now.tags.begin(), std::min(now.tags.size(), row.tags.size()), row.tags.begin());
    }
    for (ContributorResult& known : result.contributors)
        if (const auto now = contributors.find(known.contributor); now != contributors.end())
            known.contributor = now->second;
    for (std::size_t j = 0; j < outputs.size(); ++j) result.outputs[j].quantity = outputs[j];
    result.inputs = inputs;
}

}  // namespace covaria
