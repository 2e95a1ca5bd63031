#include "core/project/linked_files.h"

#include <set>

#include "core/project/certificate.h"
#include "core/project/kind_lookup.h"

namespace covaria {

namespace {

template <class Entry, class Visit>
void for_linked_in(std::vector<Entry>& entries, const Visit& visit) {
    for (Entry& entry : entries) {
        const SetupSchema* schema = schema_of(entry);
        for (auto& [key, value] : entry.setup.values)
            if (auto* table = std::get_if<SetupTable>(&value); schema && table && !table->csv_file.empty())
                if (const FieldSpec* field = schema->find(key)) visit(*table, *field);
    }
}

}  // namespace

void for_linked_tables(Project& project, const std::function<void(SetupTable&, const FieldSpec&)>& visit) {
    for_linked_in(project.assets, visit);
    for_linked_in(project.analyses, visit);
}

std::vector<std::string> linked_files(const Project& project) {
    std::set<std::string> names;
    const auto collect = [&](const Setup& setup) {
        for (const auto& [key, value] : setup.values)
            if (const auto* table = std::get_if<SetupTable>(&value); table && !table->csv_file.empty())
                names.insert(table->csv_file);
    };
    for (const AssetEntry& asset : project.assets) collect(asset.setup);
    for (const AnalysisEntry& analysis : project.analyses) collect(analysis.setup);
    return {names.begin(), names.end()};
}

std::vector<NamedFile> named_files(const Project& project, const SetupSchema& schema, const Setup& setup) {
    std::vector<NamedFile> files;
    for (const FieldSpec& field : schema.fields()) {
        if (field.file_ending.empty()) continue;
        const auto* name = std::get_if<std::string>(&value_of(field, setup));
        if (name && !is_blank(*name)) files.push_back({*name, project.directory / *name});
    }
    return files;
}

std::vector<std::string> context_files(const Project& project) {
    std::set<std::string> names;
    const auto collect = [&](const auto& entry) {
        if (const SetupSchema* schema = schema_of(entry))
            for (const NamedFile& file : named_files(project, *schema, entry.setup)) names.insert(file.name);
    };
    for (const AssetEntry& asset : project.assets) collect(asset);
    for (const AnalysisEntry& analysis : project.analyses) collect(analysis);
    if (!is_blank(project.certificate.logo)) names.insert(project.certificate.logo);
    return {names.begin(), names.end()};
}

void unlink_tables(Project& project) {
    for_linked_tables(project, [](SetupTable& table, const FieldSpec&) {
        table.csv_file.clear();
        table.csv_columns.clear();
    });
}

}  // namespace covaria
