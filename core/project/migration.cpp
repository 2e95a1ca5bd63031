// Migration of project files. To change the file format: raise project_schema_version, append a step here,
// put a sample file of the version before it into tests/data/projects. A step changes the assets and analyses
// of kept states ("kept", since version 2) as it does those of the project.
#include "core/project/migration.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "core/kinds/registries.h"
#include "core/project/project_file.h"
#include "core/project/project_id.h"

namespace covaria {

namespace {

using Document = nlohmann::ordered_json;

// The analyses were called evaluations before the first release.
MigratedProject from_0_to_1(Document document) {
    MigratedProject migrated{Document::object()};
    for (auto& [key, value] : document.items())
        migrated.document[key == "evaluations" ? "analyses" : key] = value;
    if (document.contains("evaluations")) migrated.moved.moves = {{"/analyses", "/evaluations"}};
    return migrated;
}

std::string text_of(const Document& entry, const char* key) {
    const auto found = entry.find(key);
    return found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The change of the assets that identify a robot. Such an asset stood beside an analysis that does the same,
/// each with the data; now the analysis alone is left: one with the same set-up where there is one, else one
/// of its own.
class AssetsToAnalyses {
public:
    explicit AssetsToAnalyses(Document document) : migrated_{std::move(document)} {}

    MigratedProject migrated() {
        Document& document = migrated_.document;
        const auto assets = document.find("assets");
        if (!is_list_of_objects(document, "assets") || !is_list_of_objects(document, "analyses", true))
            return std::move(migrated_);
        Document kept = Document::array();
        for (std::size_t i = 0; i < assets->size(); ++i) {
            Document& asset = (*assets)[i];
            const std::string from = "/assets/" + std::to_string(i);
            if (const ModelDescriptor* model = model_of(text_of(asset, "kind"))) {
                move(asset, *model, from);
                continue;
            }
            add_move("/assets/" + std::to_string(kept.size()), from);
            kept.push_back(std::move(asset));
        }
        *assets = std::move(kept);
        for (Document& asset : *assets)
            if (const auto* kind = find_asset_kind(text_of(asset, "kind"))) rename_in(asset, kind->schema);
        for (Document& analysis : document["analyses"])
            if (const auto* model = find_model(text_of(analysis, "model")))
                rename_in(analysis, model->schema);
        return std::move(migrated_);
    }

private:
    static bool is_list_of_objects(const Document& document, const char* key, bool may_be_missing = false) {
        const auto list = document.find(key);
        if (list == document.end()) return may_be_missing;
        return list->is_array() &&
               std::ranges::all_of(*list, [](const Document& d) { return d.is_object(); });
    }

    static const ModelDescriptor* model_of(const std::string& kind) {
        const auto found = std::ranges::find_if(
            model_registry(), [&](const ModelDescriptor& m) { return !kind.empty() && m.was_asset == kind; });
        return found == model_registry().end() ? nullptr : &*found;
    }

    void add_move(const std::string& to, const std::string& from) {
        if (to != from) migrated_.moved.moves.push_back({to, from});
    }

    void move(const Document& asset, const ModelDescriptor& model, const std::string& from) {
        Document& analyses = migrated_.document["analyses"];
        if (analyses.is_null()) analyses = Document::array();
        const std::string id = text_of(asset, "id");
        std::set<std::string> taken;
        for (const Document& analysis : analyses) {
            taken.insert(text_of(analysis, "id"));
            const bool same = text_of(analysis, "model") == model.id && analysis.contains("setup") &&
                              asset.contains("setup") && analysis["setup"] == asset["setup"];
            const bool edited = analysis.contains("inputs") || analysis.contains("correlations") ||
                                analysis.contains("links");
            if (!same || edited) continue;
            renamed_[id] = text_of(analysis, "id");
            return;
        }
        const std::string own = free_id(id, [&](const std::string& free) { return taken.contains(free); });
        if (own != id) renamed_[id] = own;
        Document analysis = Document::object();
        for (const auto& [key, value] : asset.items())
            analysis[key == "kind" ? "model" : key] = key == "kind" ? Document(model.id)
                                                      : key == "id" ? Document(own)
                                                                    : value;
        add_move("/analyses/" + std::to_string(analyses.size()), from);
        analyses.push_back(std::move(analysis));
    }

    void rename(Document& reference) const {
        if (!reference.is_string()) return;
        const auto found = renamed_.find(reference.get<std::string>());
        if (found != renamed_.end()) reference = found->second;
    }

    void rename_in(Document& entry, const SetupSchema& schema) const {
        const auto setup = entry.find("setup");
        if (renamed_.empty() || setup == entry.end() || !setup->is_object()) return;
        for (const FieldSpec& field : schema.fields()) {
            const auto value = setup->find(field.key);
            if (value == setup->end()) continue;
            if (field.kind == FieldKind::reference) rename(*value);
            if (field.kind == FieldKind::table && value->is_object()) rename_in_table(*value, field);
        }
    }

    void rename_in_table(Document& table, const FieldSpec& field) const {
        const auto columns = table.find("columns"), rows = table.find("rows");
        if (columns == table.end() || rows == table.end() || !columns->is_array() || !rows->is_array())
            return;
        for (std::size_t c = 0; c < columns->size(); ++c) {
            if (!(*columns)[c].is_string()) continue;
            const std::size_t column = SetupSchema::column(field, (*columns)[c].get<std::string>());
            if (column == SetupSchema::npos || field.columns[column].kind != FieldKind::reference) continue;
            for (Document& row : *rows)
                if (row.is_array() && c < row.size()) rename(row[c]);
        }
    }

    MigratedProject migrated_;
    std::map<std::string, std::string> renamed_;  ///< ids of the analyses by those of the assets
};

MigratedProject from_1_to_2(Document document) {
    return AssetsToAnalyses(std::move(document)).migrated();
}

using Step = MigratedProject (*)(Document);
// The step steps[v] leads from version v to v + 1.
constexpr std::array<Step, project_schema_version> steps{from_0_to_1, from_1_to_2};

}  // namespace

std::string MovedEntries::place_in_file(const std::string& place) const {
    for (const Move& move : moves)
        if (place.starts_with(move.to) && (place.size() == move.to.size() || place[move.to.size()] == '/'))
            return move.from + place.substr(move.to.size());
    return place;
}

Result<MigratedProject> migrate_project(Document document) {
    const auto version = document.find("schemaVersion");
    if (version == document.end()) return fail(ErrorCode::bad_input, tell<"'schemaVersion' is missing">());
    if (!version->is_number_unsigned())
        return fail(ErrorCode::bad_input, tell<"'schemaVersion' must be a whole number">(), "/schemaVersion");
    const std::uint64_t number = version->get<std::uint64_t>();
    if (number > steps.size())
        return fail(ErrorCode::bad_input,
                    tell<"written by a newer version of Covaria (schema %1, this program reads up to %2); "
                         "nothing was changed">(number, project_schema_version),
                    "/schemaVersion");
    MigratedProject migrated{std::move(document)};
    for (std::size_t v = number; v < steps.size(); ++v) {
        MigratedProject next = steps[v](std::move(migrated.document));
        auto& moves = next.moved.moves;
        for (MovedEntries::Move& move : moves) move.from = migrated.moved.place_in_file(move.from);
        moves.insert(moves.end(), migrated.moved.moves.begin(), migrated.moved.moves.end());
        migrated = std::move(next);
    }
    migrated.document["schemaVersion"] = project_schema_version;
    return migrated;
}

}  // namespace covaria
