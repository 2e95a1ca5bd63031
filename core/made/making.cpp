#include "core/made/making.h"

#include <string_view>

#include "core/setup/message_text.h"

namespace covaria::making {

namespace {

constexpr std::string_view setup = "/setup";

std::string path_in_setup(const EntryReference& reference) {
    return reference.path.substr(setup.size());
}

std::string words_of(const EntryReference& reference) {
    return "'" + reference.title + "' refers to the asset '" + reference.id + "'";
}

void check_use(const EntryReference& reference, const AssetLibrary::Entry& used, Problems& problems) {
    if (!used.asset)
        return problems.error(path_in_setup(reference),
                              words_of(reference) + ", which has errors of its own");
    const auto& offered = used.descriptor->capabilities;
    const auto& wanted = reference.capabilities;
    const bool fits =
        wanted.empty() || std::any_of(offered.begin(), offered.end(), [&](const auto& capability) {
            return std::find(wanted.begin(), wanted.end(), capability) != wanted.end();
        });
    if (!fits)
        problems.error(path_in_setup(reference), words_of(reference) + ", which is of the kind '" +
                                                     used.descriptor->title + "' and does not offer " +
                                                     listed(wanted));
}

}  // namespace

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
        std::vector<std::string> ids;
        for (const AssetEntry& asset : project.assets) ids.push_back(asset.id);
        problems.error(path_in_setup(references[i]), words_of(references[i]) + ", which does not exist" +
                                                         did_you_mean(references[i].id, ids));
    }
}

}  // namespace covaria::making
