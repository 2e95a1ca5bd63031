#include "core/project/references.h"

#include <algorithm>
#include <set>

#include "core/kinds/models.h"
#include "core/project/kind_lookup.h"
#include "core/project/links.h"
#include "core/project/workspace.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

bool fits(const std::vector<std::string>& offered, const std::vector<std::string>& wanted) {
    return wanted.empty() ||
           std::find_first_of(offered.begin(), offered.end(), wanted.begin(), wanted.end()) != offered.end();
}

void check_offer(const AssetReference& reference, const AnalysisEntry& analysis, Problems& problems) {
    const ModelDescriptor* model = find_model(analysis.model);
    if (!model || model->capabilities.empty() || !fits(model->capabilities, reference.capabilities))
        problems.error(reference.path, "'" + reference.title + "' refers to the analysis '" + reference.id +
                                           "', which does not offer " + listed(reference.capabilities));
}

void check_reference(const AssetReference& reference, const Project& project, const AssetLibrary& assets,
                     Problems& problems) {
    const std::string whole = "'" + reference.title + "' refers to the asset '" + reference.id + "'";
    if (const AnalysisEntry* analysis = project.find_analysis(reference.id);
        analysis && !project.find_asset(reference.id))
        return check_offer(reference, *analysis, problems);
    if (!project.find_asset(reference.id)) {
        std::vector<std::string> ids;
        for (const AssetEntry& asset : project.assets) ids.push_back(asset.id);
        problems.error(reference.path, whole + ", which does not exist" + did_you_mean(reference.id, ids));
        return;
    }
    const AssetLibrary::Entry* entry = assets.find(reference.id);
    if (!entry) {
        problems.error(reference.path, whole + ", which has errors of its own");
        return;
    }
    const auto& offered = entry->descriptor->capabilities;
    if (!fits(offered, reference.capabilities))
        problems.error(reference.path, whole + ", which is of the kind '" + entry->descriptor->title +
                                           "' and does not offer " + listed(reference.capabilities));
}

// Adds the ids that the set-up refers to, and what those assets refer to in turn.
void collect(const Project& project, const SetupSchema* schema, const Setup& setup,
             std::set<std::string>& ids) {
    if (!schema) return;
    for (const AssetReference& reference : references_of(*schema, setup)) {
        const AssetEntry* asset = project.find_asset(reference.id);
        if (asset && ids.insert(asset->id).second) collect(project, schema_of(*asset), asset->setup, ids);
    }
}

void collect_cells(const FieldSpec& field, const Setup& setup, std::vector<AssetReference>& references) {
    const auto* table = std::get_if<SetupTable>(&value_of(field, setup));
    if (!table) return;
    for (std::size_t column = 0; column < field.columns.size(); ++column) {
        const ColumnSpec& spec = field.columns[column];
        if (spec.kind != FieldKind::reference) continue;
        for (std::size_t row = 0; row < table->rows.size(); ++row) {
            const auto& cells = table->rows[row];
            const auto* id = column < cells.size() ? std::get_if<std::string>(&cells[column]) : nullptr;
            if (id && !id->empty())
                references.push_back({"/" + field.key + "/rows/" + std::to_string(row) + "/" + spec.key,
                                      spec.title, *id, spec.capabilities});
        }
    }
}

}  // namespace

std::vector<AssetReference> references_of(const SetupSchema& schema, const Setup& setup) {
    std::vector<AssetReference> references;
    for (const FieldSpec& field : schema.fields()) {
        if (!is_shown(schema, field, setup)) continue;
        if (field.kind == FieldKind::table) collect_cells(field, setup, references);
        if (field.kind != FieldKind::reference) continue;
        const std::string* id = std::get_if<std::string>(&value_of(field, setup));
        if (id && !id->empty()) references.push_back({"/" + field.key, field.title, *id, field.capabilities});
    }
    return references;
}

void check_references(const Project& project, const AssetLibrary& assets, const SetupSchema& schema,
                      const Setup& setup, Problems& problems) {
    for (const AssetReference& reference : references_of(schema, setup))
        check_reference(reference, project, assets, problems);
}

std::vector<std::string> assets_used_by(const Project& project, const AnalysisEntry& analysis) {
    std::set<std::string> ids;
    collect(project, schema_of(analysis), analysis.setup, ids);
    for (const std::string& id : analyses_used_by(project, analysis))
        if (const AnalysisEntry* upstream = project.find_analysis(id))
            collect(project, schema_of(*upstream), upstream->setup, ids);
    std::vector<std::string> ordered;
    for (const AssetEntry& asset : project.assets)
        if (ids.count(asset.id)) ordered.push_back(asset.id);
    return ordered;
}

std::vector<std::string> analyses_using(const Project& project, const std::string& asset_id) {
    std::vector<std::string> users;
    for (const AnalysisEntry& analysis : project.analyses) {
        const auto used = assets_used_by(project, analysis);
        if (std::find(used.begin(), used.end(), asset_id) != used.end()) users.push_back(analysis.id);
    }
    return users;
}

std::vector<std::size_t> assets_affected_by(const Project& project, const std::set<std::string>& ids) {
    std::vector<std::set<std::string>> refers_to(project.assets.size());
    for (std::size_t i = 0; i < project.assets.size(); ++i)
        collect(project, schema_of(project.assets[i]), project.assets[i].setup, refers_to[i]);
    std::set<std::string> waiting;
    for (std::size_t i = 0; i < project.assets.size(); ++i) {
        const auto is_changed = [&](const std::string& id) { return ids.count(id) > 0; };
        if (is_changed(project.assets[i].id) ||
            std::any_of(refers_to[i].begin(), refers_to[i].end(), is_changed))
            waiting.insert(project.assets[i].id);
    }
    std::vector<std::size_t> ordered;
    for (bool found = true; found;) {
        found = false;
        for (std::size_t i = 0; i < project.assets.size(); ++i) {
            const auto waits = [&](const std::string& id) { return waiting.count(id) > 0; };
            if (!waits(project.assets[i].id) || std::any_of(refers_to[i].begin(), refers_to[i].end(), waits))
                continue;
            ordered.push_back(i);
            waiting.erase(project.assets[i].id);
            found = true;
        }
    }
    return ordered;
}

}  // namespace covaria
