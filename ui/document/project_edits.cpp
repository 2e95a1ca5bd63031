// Edits of the lists of assets and analyses.
#include "ui/document/project_edits.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/kinds/registries.h"
#include "core/project/entry_graph.h"
#include "core/project/links.h"
#include "core/project/project_id.h"
#include "core/project/references.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

template <class Function>
void visit_entry(Project& project, const SetupAddress& address, Function&& function) {
    if (address.owner == SetupOwner::asset) {
        if (AssetEntry* entry = find_asset_entry(project, address.id)) function(*entry, project.assets);
    } else if (AnalysisEntry* entry = find_analysis_entry(project, address.id)) {
        function(*entry, project.analyses);
    }
}

QString add_words(const QString& name) {
    return tr("Add %1").arg(name);
}

QString duplicate_words(const QString& name) {
    return tr("Duplicate %1").arg(name);
}

QString name_of(const Project& project, const SetupAddress& address) {
    if (address.owner == SetupOwner::project) return Document::tr("the project");
    std::string name;
    Project copy = project;
    visit_entry(copy, address, [&](auto& entry, auto&) { name = entry.name; });
    return to_qt(name);
}

std::string file_safe(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
        safe += plain ? c : '-';
    }
    return safe.empty() ? "item" : safe;
}

bool refers_to(const AssetEntry& entry, const std::string& id) {
    const AssetDescriptor* kind = find_asset_kind(entry.kind);
    if (!kind) return false;
    const std::vector<AssetReference> references = references_of(kind->schema, entry.setup);
    return std::any_of(references.begin(), references.end(),
                       [&](const AssetReference& reference) { return reference.id == id; });
}

}  // namespace

std::string unique_id(const Project& project, const std::string& wanted) {
    std::set<std::string> taken;
    for (const AssetEntry& asset : project.assets) taken.insert(asset.id);
    for (const AnalysisEntry& analysis : project.analyses) taken.insert(analysis.id);
    return free_id(file_safe(wanted), [&](const std::string& id) { return taken.contains(id); });
}

std::string unique_name(const Project& project, const std::string& wanted) {
    std::set<std::string> taken;
    for (const AssetEntry& asset : project.assets) taken.insert(asset.name);
    for (const AnalysisEntry& analysis : project.analyses) taken.insert(analysis.name);
    std::string name = wanted;
    for (int number = 2; taken.count(name) > 0; ++number) name = wanted + " (" + std::to_string(number) + ')';
    return name;
}

std::string add_asset(Document& document, const std::string& kind) {
    const AssetDescriptor* descriptor = find_asset_kind(kind);
    if (!descriptor) return {};
    const std::string id = unique_id(document.project(), kind);
    const std::string name = unique_name(document.project(), core_words(descriptor->title));
    document.apply(add_words(core_text(descriptor->title)), [&](Project& project) {
        project.assets.push_back({id, kind, name, {}, {}});
    });
    return id;
}

std::string add_copy(Document& document, const AssetEntry& asset) {
    AssetEntry copy = asset;
    copy.id = unique_id(document.project(), asset.id);
    copy.name = unique_name(document.project(), asset.name);
    document.apply(add_words(to_qt(asset.name)), [&](Project& project) { project.assets.push_back(copy); });
    return copy.id;
}

std::string add_analysis(Document& document, const std::string& model, const EvaluationOptions& options) {
    const ModelDescriptor* descriptor = find_model(model);
    if (!descriptor) return {};
    AnalysisEntry entry;
    entry.id = unique_id(document.project(), model);
    entry.model = model;
    entry.name = unique_name(document.project(), core_words(descriptor->title));
    entry.options = options;
    document.apply(add_words(core_text(descriptor->title)),
                   [&](Project& project) { project.analyses.push_back(entry); });
    return entry.id;
}

std::string add_from_template(Document& document, const AnalysisTemplate& wanted, QString& why) {
    Project with = document.project();
    const Result<std::string> id = add_template(with, wanted, language_of_window());
    if (!id) {
        why = to_qt(id.error().message);
        return {};
    }
    document.apply(add_words(core_text(wanted.title)), [&](Project& project) { project = with; });
    return *id;
}

std::string duplicate(Document& document, const SetupAddress& address) {
    std::string id;
    document.apply(duplicate_words(name_of(document.project(), address)), [&](Project& project) {
        visit_entry(project, address, [&](auto& entry, auto& entries) {
            auto copy = entry;
            copy.id = id = unique_id(project, entry.id);
            copy.name = unique_name(project, entry.name);
            entries.insert(entries.begin() + (&entry - entries.data()) + 1, std::move(copy));
        });
    });
    return id;
}

void rename(Document& document, const SetupAddress& address, const QString& name) {
    document.apply(Document::tr("Rename %1").arg(name_of(document.project(), address)),
                   [&](Project& project) {
                       if (address.owner == SetupOwner::project) project.title = to_std(name);
                       visit_entry(project, address, [&](auto& entry, auto&) { entry.name = to_std(name); });
                   });
}

void set_notes(Document& document, const SetupAddress& address, const QString& notes) {
    document.apply(
        Document::tr("Change notes of %1").arg(name_of(document.project(), address)),
        [&](Project& project) {
            if (address.owner == SetupOwner::project) project.notes = to_std(notes);
            visit_entry(project, address, [&](auto& entry, auto&) { entry.notes = to_std(notes); });
        },
        "notes:" + to_qt(address.id));
}

void remove(Document& document, const SetupAddress& address) {
    document.apply(Document::tr("Delete %1").arg(name_of(document.project(), address)),
                   [&](Project& project) {
                       visit_entry(project, address, [](auto& entry, auto& entries) {
                           entries.erase(entries.begin() + (&entry - entries.data()));
                       });
                       if (address.owner != SetupOwner::analysis) return;
                       choose(project.report.without_analyses, address.id, true);
                       discard_kept(project.kept, address.id);
                   });
}

void move_entry(Document& document, const SetupAddress& address, std::size_t position) {
    document.apply(Document::tr("Move %1").arg(name_of(document.project(), address)), [&](Project& project) {
        visit_entry(project, address, [&](auto& entry, auto& entries) {
            auto moved = entry;
            entries.erase(entries.begin() + (&entry - entries.data()));
            entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(std::min(position, entries.size())),
                           std::move(moved));
        });
    });
}

QStringList dependants(const Project& project, const SetupAddress& address) {
    QStringList names;
    if (address.owner == SetupOwner::analysis) {
        for (const std::string& id : analyses_taking_from(project, address.id))
            if (const AnalysisEntry* analysis = project.find_analysis(id)) names << to_qt(analysis->name);
        return names;
    }
    for (const AssetEntry& asset : project.assets)
        if (refers_to(asset, address.id)) names << to_qt(asset.name);
    for (const std::string& id : analyses_using(project, address.id))
        if (const AnalysisEntry* analysis = project.find_analysis(id)) names << to_qt(analysis->name);
    return names;
}

namespace {

bool offers_one(const std::vector<std::string>& offered, const std::vector<std::string>& wanted) {
    return std::find_first_of(wanted.begin(), wanted.end(), offered.begin(), offered.end()) != wanted.end();
}

}  // namespace

std::vector<Choice> fitting_assets(const Project& project, const std::vector<std::string>& capabilities,
                                   const SetupAddress& itself) {
    std::vector<Choice> found;
    for (const AssetEntry& asset : project.assets) {
        const AssetDescriptor* kind = find_asset_kind(asset.kind);
        if (!kind || (itself.owner == SetupOwner::asset && itself.id == asset.id)) continue;
        if (capabilities.empty() || offers_one(kind->capabilities, capabilities))
            found.push_back({asset.id, asset.name});
    }
    if (itself.owner == SetupOwner::asset) return found;
    const auto takers = analyses_taking_from(project, itself.id);
    for (const AnalysisEntry& analysis : project.analyses) {
        const ModelDescriptor* model = find_model(analysis.model);
        const bool circle =
            analysis.id == itself.id || std::find(takers.begin(), takers.end(), analysis.id) != takers.end();
        if (model && !circle && offers_one(model->capabilities, capabilities))
            found.push_back({analysis.id, analysis.name});
    }
    return found;
}

}  // namespace covaria::ui
