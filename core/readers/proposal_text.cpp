#include "core/readers/proposal_text.h"

#include <algorithm>
#include <sstream>

#include "core/kinds/registries.h"
#include "core/readers/readers.h"
#include "core/setup/message_text.h"

namespace covaria {
namespace {

constexpr std::size_t shown_rows = 8, shown_left_out = 20;

std::string text_of_cell(const SetupCell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) return shortest_number(*number);
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    if (const auto* flag = std::get_if<bool>(&cell)) return *flag ? "yes" : "no";
    return "";
}

/// Columns that any of the rows has something in, padded.
void write_table(std::ostringstream& out, const FieldSpec& field, const SetupTable& table) {
    const std::size_t rows = std::min(table.rows.size(), shown_rows);
    std::vector<std::string> lines(rows + 1, "     ");
    for (std::size_t column = 0; column < field.columns.size(); ++column) {
        std::vector<std::string> cells{field.columns[column].key};
        if (!(table.units[column] == Unit{})) cells[0] += " [" + table.units[column].display() + "]";
        bool any = false;
        for (std::size_t row = 0; row < rows; ++row) {
            cells.push_back(column < table.rows[row].size() ? text_of_cell(table.rows[row][column]) : "");
            any = any || !cells.back().empty();
        }
        if (!any) continue;
        std::size_t width = 0;
        for (const std::string& cell : cells) width = std::max(width, cell.size());
        for (std::size_t i = 0; i < lines.size(); ++i)
            lines[i] += " " + cells[i] + std::string(width - cells[i].size() + 1, ' ');
    }
    for (std::string& line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << "\n";
    }
    if (table.rows.size() > rows) out << "      and " << table.rows.size() - rows << " more rows\n";
}

void write_setup(std::ostringstream& out, const SetupSchema& schema, const Setup& setup) {
    for (const FieldSpec& field : schema.fields()) {
        const auto value = setup.values.find(field.key);
        if (value == setup.values.end()) continue;
        if (const auto* table = std::get_if<SetupTable>(&value->second)) {
            if (table->rows.empty()) continue;
            out << "    " << field.title << "\n";
            write_table(out, field, *table);
        } else if (const auto* number = std::get_if<Quantity>(&value->second)) {
            out << "    " << field.title << ": " << quantity_words(number->value, number->unit) << "\n";
        }
    }
}

void write_tables(std::ostringstream& out, const Proposals& proposals) {
    for (const AssetEntry& asset : proposals.assets)
        if (const AssetDescriptor* kind = find_asset_kind(asset.kind)) {
            out << "\n  " << kind->title << " \"" << asset.name << "\"\n";
            write_setup(out, kind->schema, asset.setup);
        }
    for (const AnalysisEntry& analysis : proposals.analyses)
        if (const ModelDescriptor* model = find_model(analysis.model)) {
            out << "\n  Analysis \"" << analysis.name << "\" (" << model->title << ")\n";
            write_setup(out, model->schema, analysis.setup);
        }
}

}  // namespace

std::string text_of(const Reader& reader, const Proposals& proposals, bool with_tables) {
    std::ostringstream out;
    out << "read as " << reader.title << " (" << reader.name << ")\n";
    for (const std::string& line : proposals.found) out << "  " << line << "\n";
    for (const UnstatedUnit& unit : proposals.unstated)
        out << "  " << unit.key
            << (unit.title.empty() || unit.title == unit.key ? "" : " (" + unit.title + ")")
            << ": the file states no unit, " << unit.taken.display() << " is taken\n";
    if (with_tables) write_tables(out, proposals);
    if (proposals.left_out.empty()) return out.str();
    out << "\nnot taken over\n";
    std::vector<LeftOut> all = proposals.left_out;
    std::stable_sort(all.begin(), all.end(),
                     [](const LeftOut& a, const LeftOut& b) { return a.line < b.line; });
    const std::size_t shown = std::min(all.size(), shown_left_out);
    for (std::size_t i = 0; i < shown; ++i) {
        const LeftOut& left = all[i];
        out << "  " << (left.line > 0 ? "line " + std::to_string(left.line) + ": " : "") << left.what << "\n";
    }
    const std::size_t more = proposals.left_out.size() - shown + proposals.left_out_beyond;
    if (more > 0) out << "  and " << more << " more\n";
    return out.str();
}

std::string list_of_readers() {
    std::ostringstream out;
    for (const Reader& reader : reader_registry())
        out << reader.name << std::string(18 - std::min<std::size_t>(reader.name.size(), 17), ' ')
            << reader.title << ", " << reader.pattern << "\n                  " << reader.takes << "\n";
    return out.str();
}

}  // namespace covaria
