// The list of readers: one line for each.
#include "core/readers/readers.h"

#include <algorithm>
#include <map>

#include "core/base/utf8.h"
#include "core/kinds/registries.h"
#include "core/project/project_id.h"
#include "core/readers/formats.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using Renamed = std::map<std::string, std::string>;

void rename_cells(const FieldSpec& field, SetupTable& table, const Renamed& renamed) {
    for (std::size_t column = 0; column < field.columns.size(); ++column) {
        if (field.columns[column].kind != FieldKind::reference) continue;
        for (auto& row : table.rows)
            if (auto* id = column < row.size() ? std::get_if<std::string>(&row[column]) : nullptr)
                if (const auto found = renamed.find(*id); found != renamed.end()) *id = found->second;
    }
}

void rename_references(const SetupSchema& schema, Setup& setup, const Renamed& renamed) {
    for (const FieldSpec& field : schema.fields()) {
        const auto value = setup.values.find(field.key);
        if (value == setup.values.end()) continue;
        if (auto* table = std::get_if<SetupTable>(&value->second)) rename_cells(field, *table, renamed);
        auto* id = field.kind == FieldKind::reference ? std::get_if<std::string>(&value->second) : nullptr;
        if (!id) continue;
        if (const auto found = renamed.find(*id); found != renamed.end()) *id = found->second;
    }
}

std::string names_of(const std::vector<const Reader*>& readers) {
    std::vector<std::string> names;
    for (const Reader* reader : readers) names.push_back(reader->name);
    return listed(names);
}

}  // namespace

const std::vector<Reader>& reader_registry() {
    static const std::vector<Reader> readers{spatial_analyzer_reader(),
                                             point_table_reader(),
                                             coordinate_list_reader(),
                                             dcc_reader(),
                                             gsi_reader(),
                                             gama_reader(),
                                             comp3d_reader(),
                                             comp3d_observations_reader(),
                                             comp3d_project_reader(),
                                             excel_budget_reader(),
                                             gum_workbench_reader(),
                                             suncal_reader(),
                                             motive_reader(),
                                             robot_calibration_reader(),
                                             urdf_reader()};
    return readers;
}

const Reader* find_reader(const std::string& name) {
    for (const Reader& reader : reader_registry())
        if (reader.name == name) return &reader;
    return nullptr;
}

RecognisedReaders recognise_reader(std::string_view text, const std::string& file_name) {
    const std::string_view beginning = without_byte_order_mark(text.substr(0, recognised_by));
    RecognisedReaders found;
    std::vector<const Reader*> possible;
    for (const Reader& reader : reader_registry()) {
        const Recognition recognition = reader.recognise(beginning, file_name);
        if (recognition == Recognition::certain) found.readers.push_back(&reader);
        if (recognition == Recognition::possible) possible.push_back(&reader);
    }
    (found.readers.empty() ? found.readers : found.others) = std::move(possible);
    return found;
}

Result<const Reader*> reader_for(std::string_view text, const std::string& file_name) {
    const RecognisedReaders found = recognise_reader(text, file_name);
    if (found.readers.size() == 1) return found.readers.front();
    if (found.readers.empty())
        return fail(ErrorCode::usage, tell<"no reader recognises the file; name the one to read it with">());
    return fail(ErrorCode::usage,
                tell<"several readers recognise the file: %1; name one of them">(names_of(found.readers)));
}

void add_to_project(Project& project, Proposals proposals) {
    Renamed renamed;
    for (AssetEntry& asset : proposals.assets) {
        const std::string id =
            free_id(asset.id, [&](const std::string& i) { return project.find_asset(i) != nullptr; });
        renamed[asset.id] = id;
        asset.id = id;
        if (const AssetDescriptor* kind = find_asset_kind(asset.kind))
            rename_references(kind->schema, asset.setup, renamed);
        project.assets.push_back(std::move(asset));
    }
    for (AnalysisEntry& analysis : proposals.analyses) {
        analysis.id =
            free_id(analysis.id, [&](const std::string& i) { return project.find_analysis(i) != nullptr; });
        if (const ModelDescriptor* model = find_model(analysis.model))
            rename_references(model->schema, analysis.setup, renamed);
        project.analyses.push_back(std::move(analysis));
    }
}

}  // namespace covaria
