#include "core/project/references.h"

namespace covaria {

namespace {

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

}  // namespace covaria
