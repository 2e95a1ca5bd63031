// Set-ups as the schema lists them: fields with titles and units, tables as tables.
#include <algorithm>
#include <sstream>

#include "core/report/report_parts.h"
#include "core/setup/shared_decimals.h"
#include "core/setup/text_columns.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t most_setup_rows = 60;  // rows of a set-up table; the file has them all

std::string quantity_text(double value, const Unit& unit, const DocumentLanguage& in) {
    return grouped_digits(format_typed(without_residue(value, unit)), in.numbers()) + unit_after_number(unit);
}

std::string triple_text(const std::array<double, 3>& values, const Unit& unit, const DocumentLanguage& in) {
    const auto number = [&in](double value) { return grouped_digits(format_typed(value), in.numbers()); };
    const char* between = in.numbers().decimal == "," ? "; " : ", ";
    return "(" + number(values[0]) + between + number(values[1]) + between + number(values[2]) + ")\u00a0" +
           unit.display();
}

std::string choice_title(const std::vector<Choice>& choices, const std::string& key,
                         const DocumentLanguage& in) {
    for (const Choice& choice : choices)
        if (choice.key == key) return in.say_declared(choice.title);
    return key;
}

std::string yes_or_no(bool yes, const DocumentLanguage& in) {
    return in.say(yes ? tell<"yes">() : tell<"no">());
}

std::string name_of_asset(const std::string& id, const ReportSource& source) {
    const AssetLibrary::Entry* entry = source.made.assets().find(id);
    if (entry && !entry->name.empty()) return entry->name;
    // The id may be of an analysis that gives such an asset.
    const AnalysisEntry* analysis = source.made.project().find_analysis(id);
    return analysis && !analysis->name.empty() ? analysis->name : id;
}

Cell cell_of(const ColumnSpec& spec, const Unit& unit, const SetupCell& cell, const ReportSource& source) {
    if (const auto* number = std::get_if<double>(&cell)) return Quantity{*number, unit};
    if (const auto* flag = std::get_if<bool>(&cell)) return yes_or_no(*flag, source.in);
    if (const auto* text = std::get_if<std::string>(&cell))
        return spec.kind == FieldKind::reference
                   ? name_of_asset(*text, source)
                   : choice_title(spec.choices, shown_text(spec.key, *text), source.in);
    return std::monostate{};
}

bool is_used(const SetupTable& table, std::size_t column) {
    return std::any_of(table.rows.begin(), table.rows.end(), [column](const auto& row) {
        return column < row.size() && !std::holds_alternative<std::monostate>(row[column]);
    });
}

}  // namespace

std::string setup_text(const FieldSpec& field, const SetupValue& value, const ReportSource& source) {
    if (const auto* quantity = std::get_if<Quantity>(&value))
        return quantity_text(quantity->value, quantity->unit, source.in);
    if (const auto* flag = std::get_if<bool>(&value)) return yes_or_no(*flag, source.in);
    if (const auto* pose = std::get_if<PoseValue>(&value))
        return source.in.say(tell<"position %1, rotations about x, y, z: %2">(
            triple_text(pose->position, pose->length_unit, source.in),
            triple_text(pose->angles, pose->angle_unit, source.in)));
    const auto* text = std::get_if<std::string>(&value);
    if (!text) return {};
    if (field.kind == FieldKind::reference) return name_of_asset(*text, source);
    return choice_title(field.choices, shown_text(field.key, *text), source.in);
}

TableBlock setup_table(const FieldSpec& field, const SetupTable& table, const ReportSource& source) {
    const DocumentLanguage& in = source.in;
    TableBuilder block("setup-" + id_part(field.key), Message::declared(field.title), in);
    const std::size_t rows = std::min(table.rows.size(), most_setup_rows);
    std::vector<std::vector<Cell>> cells(rows);
    for (std::size_t c = 0; c < field.columns.size(); ++c) {
        if (!is_used(table, c)) continue;
        const ColumnSpec& spec = field.columns[c];
        const Unit unit = c < table.units.size() ? table.units[c] : spec.unit;
        Column& column = looks_like_symbol(spec.title) ? block.symbol(spec.title)
                                                       : block.text(Message::declared(spec.title));
        column.in(unit).symbols = names_quantities(spec);
        column.rule.by_row = shared_decimals(field, table, c);
        for (std::size_t r = 0; r < rows; ++r)
            cells[r].push_back(c < table.rows[r].size() ? cell_of(spec, unit, table.rows[r][c], source)
                                                        : Cell{});
    }
    for (std::vector<Cell>& row : cells) block.row(std::move(row));
    if (!table.csv_file.empty()) block.note(tell<"Read from %1.">(table.csv_file));
    if (rows < table.rows.size())
        block.note(tell<"The first %1 of %2 rows; the project file has them all.">(rows, table.rows.size()));
    return block.take();
}

void add_paragraphs(Blocks& blocks, const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) blocks.push_back(ParagraphBlock{line});
}

void add_setup_fields(Blocks& blocks, const SetupSchema& schema, const Setup& setup,
                      const ReportSource& source, const Blocks& equations) {
    const bool are_typed =
        std::any_of(schema.fields().begin(), schema.fields().end(),
                    [&](const FieldSpec& f) { return f.several_lines && is_shown(schema, f, setup); });
    if (!are_typed) blocks.insert(blocks.end(), equations.begin(), equations.end());
    FactsBlock facts;
    Blocks tables;
    std::string section, heading;
    const auto flush = [&] {
        if (!heading.empty() && !(facts.facts.empty() && tables.empty()))
            blocks.push_back(HeadingBlock{4, heading});
        heading.clear();
        if (!facts.facts.empty()) blocks.push_back(std::move(facts));
        blocks.insert(blocks.end(), tables.begin(), tables.end());
        facts = {};
        tables.clear();
    };
    for (const FieldSpec& field : schema.fields()) {
        if (!is_shown(schema, field, setup)) continue;
        if (field.section != section) flush();
        if (field.section != section && !field.section.empty())
            heading = source.in.say_declared(field.section);
        section = field.section;
        if (field.several_lines) {  // the equations stand as the model sets them
            tables.insert(tables.end(), equations.begin(), equations.end());
            continue;
        }
        const SetupValue& value = value_of(field, setup);
        if (const auto* table = std::get_if<SetupTable>(&value)) {
            if (!table->rows.empty()) tables.push_back(setup_table(field, *table, source));
        } else if (const std::string text = setup_text(field, value, source); !text.empty()) {
            facts.facts.emplace_back(source.in.say_declared(field.title), text);
        }
    }
    flush();
}

void add_setup(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated) {
    const AnalysisEntry* entry = source.made.project().find_analysis(evaluated.analysis->id);
    if (!entry) return;
    blocks.push_back(HeadingBlock{2, source.in.say(tell<"Set-up">())});
    add_paragraphs(blocks, entry->notes);
    Blocks equations;
    if (evaluated.analysis->model)
        for (const ModelEquation& equation : evaluated.analysis->model->formulas())
            equations.push_back(EquationBlock{source.in.say(equation.text), source.in.say(equation.source),
                                              with_numbers(equation.formula, source.in.numbers())});
    add_setup_fields(blocks, evaluated.analysis->descriptor->schema, entry->setup, source, equations);
}

}  // namespace covaria::report_parts
