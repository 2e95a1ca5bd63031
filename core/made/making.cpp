#include "core/made/making.h"

#include <algorithm>
#include <string_view>

#include "core/kinds/registries.h"
#include "core/made/made_project.h"
#include "core/setup/message_text.h"

namespace covaria::making {

namespace {

constexpr std::string_view setup = "/setup";

std::string path_in_setup(const EntryReference& reference) {
    return reference.path.substr(setup.size());
}

std::string words_of(const EntryReference& reference) {
    return "'" + reference.title + "' refers to the " + (reference.to_analysis ? "analysis" : "asset") +
           " '" + reference.id + "'";
}

bool fits(const std::vector<std::string>& offered, const std::vector<std::string>& wanted) {
    return wanted.empty() ||
           std::find_first_of(offered.begin(), offered.end(), wanted.begin(), wanted.end()) != offered.end();
}

// For an analysis its model stands, with its edits: the rest of it influences nobody else.
bool is_same(const std::shared_ptr<const MadeEntry>& use, const std::shared_ptr<const MadeEntry>& before) {
    if (!use || use == before) return use != nullptr;
    const auto* now = dynamic_cast<const MadeAnalysis*>(use.get());
    const auto* then = dynamic_cast<const MadeAnalysis*>(before.get());
    return now && then && now->model && now->model == then->model && now->inputs == then->inputs &&
           now->name == then->name;
}

void check_use(const EntryReference& reference, const AnalysisEntry& entry, const MadeAnalysis& used,
               Problems& problems) {
    const ModelDescriptor* model = find_model(entry.model);
    if (!model || model->capabilities.empty() || !fits(model->capabilities, reference.capabilities))
        return problems.error(path_in_setup(reference), words_of(reference) + ", which does not offer " +
                                                            listed(reference.capabilities));
    if (!used.model)
        problems.error(path_in_setup(reference),
                       "the analysis '" + reference.id +
                           "' has errors of its own: " + first_error(used.of_own, "it cannot be made"));
}

void check_use(const EntryReference& reference, const AssetLibrary::Entry& used, Problems& problems) {
    if (!used.asset)
        return problems.error(path_in_setup(reference),
                              words_of(reference) + ", which has errors of its own");
    if (!fits(used.descriptor->capabilities, reference.capabilities))
        problems.error(path_in_setup(reference), words_of(reference) + ", which is of the kind '" +
                                                     used.descriptor->title + "' and does not offer " +
                                                     listed(reference.capabilities));
}

}  // namespace

bool stay(const Uses& uses, const Uses& before) {
    return std::equal(uses.begin(), uses.end(), before.begin(), before.end(), is_same);
}

void refuse_circles(const std::vector<EntryReference>& references, Problems& problems) {
    for (const EntryReference& reference : references) {
        if (reference.circle.empty()) continue;
        std::string way;
        for (const std::string& id : reference.circle) way += id + " → ";
        problems.error(path_in_setup(reference), words_of(reference) + ", which refers back to this one: " +
                                                     way + reference.circle.front());
    }
}

void check_uses(const Project& project, const std::vector<EntryReference>& references, const Uses& uses,
                Problems& problems) {
    for (std::size_t i = 0; i < references.size(); ++i) {
        if (!references[i].circle.empty()) continue;
        if (const auto* used = dynamic_cast<const MadeAsset*>(uses[i].get())) {
            check_use(references[i], used->made, problems);
            continue;
        }
        if (const auto* used = dynamic_cast<const MadeAnalysis*>(uses[i].get())) {
            check_use(references[i], *project.find_analysis(references[i].id), *used, problems);
            continue;
        }
        if (references[i].to_analysis) {
            problems.error(path_in_setup(references[i]),
                           words_of(references[i]) + ": only analyses take something from analyses");
            continue;
        }
        std::vector<std::string> ids;
        for (const AssetEntry& asset : project.assets) ids.push_back(asset.id);
        problems.error(path_in_setup(references[i]), words_of(references[i]) + ", which does not exist" +
                                                         did_you_mean(references[i].id, ids));
    }
}

}  // namespace covaria::making
