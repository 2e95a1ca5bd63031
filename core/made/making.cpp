#include "core/made/making.h"

#include <algorithm>
#include <string_view>

#include "core/kinds/registries.h"
#include "core/made/made_project.h"
#include "core/project/entry_names.h"
#include "core/setup/message_text.h"

namespace covaria::making {

namespace {

constexpr std::string_view setup = "/setup";

std::string path_in_setup(const EntryReference& reference) {
    return reference.path.substr(setup.size());
}

Message words_of(const EntryReference& reference, const Project& project) {
    const Message title = Message::declared(reference.title);
    const std::string name = shown_name(project, reference.id, reference.to_analysis);
    return reference.to_analysis ? tell<"'%1' refers to the analysis '%2'">(title, name)
                                 : tell<"'%1' refers to the asset '%2'">(title, name);
}

bool fits(const std::vector<std::string>& offered, const std::vector<std::string>& wanted) {
    return wanted.empty() ||
           std::find_first_of(offered.begin(), offered.end(), wanted.begin(), wanted.end()) != offered.end();
}

// Whether an entry is as before: of an analysis the model with its edits, as the rest influences nobody else.
bool is_same(const std::shared_ptr<const MadeEntry>& use, const std::shared_ptr<const MadeEntry>& before) {
    if (!use || use == before) return use != nullptr;
    const auto* now = dynamic_cast<const MadeAnalysis*>(use.get());
    const auto* then = dynamic_cast<const MadeAnalysis*>(before.get());
    return now && then && now->model && now->model == then->model && now->inputs == then->inputs &&
           now->name == then->name;
}

void check_use(const EntryReference& reference, const AnalysisEntry& entry, const MadeAnalysis& used,
               const Project& project, Problems& problems) {
    const ModelDescriptor* model = find_model(entry.model);
    if (!model || model->capabilities.empty() || !fits(model->capabilities, reference.capabilities))
        return problems.error(path_in_setup(reference),
                              tell<"%1, which does not offer %2">(words_of(reference, project),
                                                                  listed(reference.capabilities)));
    if (!used.model)
        problems.error(path_in_setup(reference), tell<"the analysis '%1' has errors of its own: %2">(
                                                     shown_name(project, reference.id, true),
                                                     first_error(used.of_own, tell<"it cannot be made">())));
}

void check_use(const EntryReference& reference, const AssetLibrary::Entry& used, const Project& project,
               Problems& problems) {
    if (!used.asset)
        return problems.error(path_in_setup(reference),
                              tell<"%1, which has errors of its own">(words_of(reference, project)));
    if (!fits(used.descriptor->capabilities, reference.capabilities))
        problems.error(path_in_setup(reference), tell<"%1, which is of the kind '%2' and does not offer %3">(
                                                     words_of(reference, project), used.descriptor->title,
                                                     listed(reference.capabilities)));
}

}  // namespace

bool stay(const Uses& uses, const Uses& before) {
    return std::equal(uses.begin(), uses.end(), before.begin(), before.end(), is_same);
}

void refuse_circles(const Project& project, const std::vector<EntryReference>& references,
                    Problems& problems) {
    const auto name = [&](const std::string& id) {
        return in_quotes(shown_name(project, id, !project.find_asset(id)));
    };
    for (const EntryReference& reference : references) {
        if (reference.circle.empty()) continue;
        std::string way;
        for (const std::string& id : reference.circle) way += name(id) + " → ";
        problems.error(path_in_setup(reference),
                       tell<"%1, which refers back to this one: %2%3">(words_of(reference, project), way,
                                                                       name(reference.circle.front())));
    }
}

void check_uses(const Project& project, const std::vector<EntryReference>& references, const Uses& uses,
                Problems& problems) {
    for (std::size_t i = 0; i < references.size(); ++i) {
        if (!references[i].circle.empty()) continue;
        if (const auto* used = dynamic_cast<const MadeAsset*>(uses[i].get())) {
            check_use(references[i], used->made, project, problems);
            continue;
        }
        if (const auto* used = dynamic_cast<const MadeAnalysis*>(uses[i].get())) {
            check_use(references[i], *project.find_analysis(references[i].id), *used, project, problems);
            continue;
        }
        if (references[i].to_analysis) {
            problems.error(
                path_in_setup(references[i]),
                tell<"%1: only analyses take something from analyses">(words_of(references[i], project)));
            continue;
        }
        problems.error(
            path_in_setup(references[i]),
            tell<"%1, which does not exist%2">(words_of(references[i], project),
                                               did_you_mean_entry(references[i].id, project.assets)));
    }
}

}  // namespace covaria::making
