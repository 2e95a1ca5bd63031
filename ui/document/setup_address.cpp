// Finding entries by id and by JSON pointer.
#include "ui/document/setup_address.h"

#include <charconv>

#include "core/kinds/registries.h"
#include "core/manual/help_page.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

template <class Entries>
auto find_by_id(Entries& entries, const std::string& id) -> decltype(entries.data()) {
    for (auto& entry : entries)
        if (entry.id == id) return &entry;
    return nullptr;
}

template <class Entries>
std::string id_at(const Entries& entries, const std::string& path, std::size_t start) {
    std::size_t index = 0;
    const auto parsed = std::from_chars(path.data() + start, path.data() + path.size(), index);
    return parsed.ec == std::errc{} && index < entries.size() ? entries[index].id : std::string{};
}

constexpr const char* assets_prefix = "/assets/";
constexpr const char* analyses_prefix = "/analyses/";

}  // namespace

AssetEntry* find_asset_entry(Project& project, const std::string& id) {
    return find_by_id(project.assets, id);
}

AnalysisEntry* find_analysis_entry(Project& project, const std::string& id) {
    return find_by_id(project.analyses, id);
}

Setup* find_setup(Project& project, const SetupAddress& address) {
    if (address.owner == SetupOwner::asset) {
        AssetEntry* entry = find_asset_entry(project, address.id);
        return entry ? &entry->setup : nullptr;
    }
    AnalysisEntry* entry = find_analysis_entry(project, address.id);
    return entry ? &entry->setup : nullptr;
}

const Setup* find_setup(const Project& project, const SetupAddress& address) {
    if (address.owner == SetupOwner::asset) {
        const AssetEntry* entry = find_by_id(project.assets, address.id);
        return entry ? &entry->setup : nullptr;
    }
    const AnalysisEntry* entry = find_by_id(project.analyses, address.id);
    return entry ? &entry->setup : nullptr;
}

const SetupSchema* find_schema(const Project& project, const SetupAddress& address) {
    if (address.owner == SetupOwner::asset) {
        const AssetEntry* entry = find_by_id(project.assets, address.id);
        const AssetDescriptor* kind = entry ? find_asset_kind(entry->kind) : nullptr;
        return kind ? &kind->schema : nullptr;
    }
    const AnalysisEntry* entry = find_by_id(project.analyses, address.id);
    const ModelDescriptor* model = entry ? find_model(entry->model) : nullptr;
    return model ? &model->schema : nullptr;
}

std::optional<Setup> completed_setup(const Project& project, const SetupAddress& address) {
    const AnalysisEntry* entry =
        address.owner == SetupOwner::analysis ? find_by_id(project.analyses, address.id) : nullptr;
    const ModelDescriptor* model = entry ? find_model(entry->model) : nullptr;
    if (!model || !model->completed) return std::nullopt;
    return model->completed(entry->setup);
}

std::string entry_path(const Project& project, const SetupAddress& address) {
    if (address.owner == SetupOwner::asset) {
        const AssetEntry* entry = find_by_id(project.assets, address.id);
        return entry ? assets_prefix + std::to_string(entry - project.assets.data()) : std::string{};
    }
    const AnalysisEntry* entry = find_by_id(project.analyses, address.id);
    return entry ? analyses_prefix + std::to_string(entry - project.analyses.data()) : std::string{};
}

std::string setup_path(const Project& project, const SetupAddress& address) {
    const std::string path = entry_path(project, address);
    return path.empty() ? path : path + "/setup";
}

SetupAddress address_of_path(const Project& project, const std::string& path) {
    if (path.starts_with(assets_prefix))
        return {SetupOwner::asset, id_at(project.assets, path, std::string_view(assets_prefix).size())};
    if (path.starts_with(analyses_prefix))
        return {SetupOwner::analysis,
                id_at(project.analyses, path, std::string_view(analyses_prefix).size())};
    return path.empty() ? SetupAddress{} : project_address;
}

bool exists(const Project& project, const SetupAddress& address) {
    return address.owner == SetupOwner::project || !entry_path(project, address).empty();
}

QString help_anchor(const Project& project, const SetupAddress& address, const std::string& field,
                    const std::string& column) {
    std::string page;
    if (address.owner == SetupOwner::asset) {
        if (const AssetEntry* asset = project.find_asset(address.id)) page = "asset-" + asset->kind;
    } else if (const AnalysisEntry* analysis = project.find_analysis(address.id)) {
        page = "model-" + analysis->model;
    }
    if (page.empty()) return {};
    return to_qt(field.empty() ? page : field_anchor(page, field, column));
}

}  // namespace covaria::ui
