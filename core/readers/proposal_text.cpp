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

class ProposalText {
public:
    ProposalText(const Proposals& proposals, const DocumentLanguage& in) : proposals_(proposals), in_(in) {}

    void write_head(const Reader& reader) {
        line("", tell<"read as %1 (%2)">(Message::declared(reader.title), reader.name));
        for (const Message& found : proposals_.found) line("  ", found);
        for (const UnstatedUnit& unit : proposals_.unstated) {
            const bool titled = !unit.title.empty() && unit.title != unit.key;
            line("  ", tell<"%1: the file states no unit, %2 is taken">(
                           unit.key + (titled ? " (" + unit.title + ")" : ""), unit.taken.display()));
        }
    }

    void write_tables() {
        for (const AssetEntry& asset : proposals_.assets)
            if (const AssetDescriptor* kind = find_asset_kind(asset.kind)) {
                out_ << "\n  " << in_.say_declared(kind->title) << " \"" << asset.name << "\"\n";
                write_setup(kind->schema, asset.setup);
            }
        for (const AnalysisEntry& analysis : proposals_.analyses)
            if (const ModelDescriptor* model = find_model(analysis.model)) {
                line("\n  ", tell<"Analysis \"%1\" (%2)">(analysis.name, Message::declared(model->title)));
                write_setup(model->schema, analysis.setup);
            }
    }

    void write_left_out() {
        if (proposals_.left_out.empty()) return;
        line("\n", tell<"not taken over">());
        std::vector<LeftOut> all = proposals_.left_out;
        std::stable_sort(all.begin(), all.end(),
                         [](const LeftOut& a, const LeftOut& b) { return a.line < b.line; });
        const std::size_t shown = std::min(all.size(), shown_left_out);
        for (std::size_t i = 0; i < shown; ++i)
            line("  ", all[i].line > 0 ? tell<"line %1: %2">(all[i].line, all[i].what) : all[i].what);
        const std::size_t more = all.size() - shown + proposals_.left_out_beyond;
        if (more > 0) line("  ", tell<"and %1 more">(more));
    }

    std::string text() const { return out_.str(); }

private:
    void line(const char* indent, const Message& message) { out_ << indent << in_.say(message) << "\n"; }

    /// Writes the columns in which any of the rows has something, padded.
    void write_table(const FieldSpec& field, const SetupTable& table) {
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
        for (std::string& text : lines) {
            text.erase(text.find_last_not_of(' ') + 1);
            out_ << text << "\n";
        }
        if (table.rows.size() > rows) line("      ", tell<"and %1 more rows">(table.rows.size() - rows));
    }

    void write_setup(const SetupSchema& schema, const Setup& setup) {
        for (const FieldSpec& field : schema.fields()) {
            const auto value = setup.values.find(field.key);
            if (value == setup.values.end()) continue;
            const Message title = Message::declared(field.title);
            if (const auto* table = std::get_if<SetupTable>(&value->second)) {
                if (table->rows.empty()) continue;
                line("    ", title);
                write_table(field, *table);
            } else if (const auto* number = std::get_if<Quantity>(&value->second)) {
                line("    ", title + ": " + quantity_words(number->value, number->unit));
            }
        }
    }

    const Proposals& proposals_;
    const DocumentLanguage& in_;
    std::ostringstream out_;
};

}  // namespace

std::string text_of(const Reader& reader, const Proposals& proposals, bool with_tables,
                    const DocumentLanguage& in) {
    ProposalText text(proposals, in);
    text.write_head(reader);
    if (with_tables) text.write_tables();
    text.write_left_out();
    return text.text();
}

std::string list_of_readers() {
    std::ostringstream out;
    for (const Reader& reader : reader_registry())
        out << reader.name << std::string(18 - std::min<std::size_t>(reader.name.size(), 17), ' ')
            << reader.title << ", " << reader.pattern << "\n                  " << reader.takes << "\n";
    return out.str();
}

}  // namespace covaria
