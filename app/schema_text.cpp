#include "app/schema_text.h"

#include <sstream>

#include "core/setup/field_words.h"

namespace covaria {
namespace {

void write_choices(std::ostringstream& out, const std::vector<Choice>& choices, const std::string& indent) {
    for (const Choice& choice : choices) out << indent << choice.key << ": " << choice.title << '\n';
}

void write_column(std::ostringstream& out, const ColumnSpec& column) {
    out << "        " << column.key;
    if (column.kind == FieldKind::number && !(column.unit == Unit()))
        out << " [" << column.unit.text() << "]";
    out << " (" << kind_words(column.kind) << (column.optional ? ", optional" : "") << ")";
    const std::string range = range_words(column.range, column.unit);
    if (!range.empty()) out << ' ' << range;
    out << (column.help.empty() ? "" : ": " + column.help) << '\n';
    write_choices(out, column.choices, "            ");
}

void write_field(std::ostringstream& out, const FieldSpec& field) {
    out << "  " << field.key << " (" << kind_words(field.kind);
    if (field.kind == FieldKind::number && !(field.unit == Unit())) out << ", " << field.unit.text();
    if (field.optional) out << ", optional";
    out << ")";
    const std::string default_text = value_words(field.default_value);
    if (!default_text.empty()) out << "  default " << default_text;
    const std::string range = range_words(field.range, field.unit);
    if (!range.empty()) out << "  range " << range;
    out << '\n';
    write_wrapped(out, field.title + ". " + field.help, "      ");
    if (field.shown_if) {
        out << "      used if " << field.shown_if->key << " is";
        for (std::size_t i = 0; i < field.shown_if->values.size(); ++i)
            out << (i ? " or " : " ") << field.shown_if->values[i];
        out << '\n';
    }
    write_choices(out, field.choices, "        ");
    for (const ColumnSpec& column : field.columns) write_column(out, column);
}

void write_schema(std::ostringstream& out, const SetupSchema& schema) {
    out << "\nFields of the set-up\n";
    std::string section;
    for (const FieldSpec& field : schema.fields()) {
        if (field.section != section) out << "\n  -- " << (section = field.section) << " --\n";
        write_field(out, field);
    }
}

void write_list(std::ostringstream& out, const std::string& title, const std::vector<std::string>& items) {
    if (items.empty()) return;
    out << '\n' << title << '\n';
    for (const std::string& item : items) write_wrapped(out, "- " + item, "  ");
}

std::vector<std::string> texts_of(const std::vector<Reference>& references) {
    std::vector<std::string> texts;
    for (const Reference& reference : references) texts.push_back(reference.text);
    return texts;
}

}  // namespace

void write_wrapped(std::ostringstream& out, const std::string& text, const std::string& indent) {
    std::istringstream words(text);
    std::string word, line;
    while (words >> word) {
        if (!line.empty() && indent.size() + line.size() + 1 + word.size() > 100) {
            out << indent << line << '\n';
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    if (!line.empty()) out << indent << line << '\n';
}

std::string description_of(const ModelDescriptor& model) {
    std::ostringstream out;
    out << model.id << ": " << model.title << '\n';
    write_wrapped(out, model.summary, "  ");
    std::vector<std::string> equations;
    for (const ModelEquation& equation : model.equations)
        equations.push_back(equation.text.english() + "   (" + equation.source.english() + ")");
    write_list(out, "Equations", equations);
    write_schema(out, model.schema);
    write_list(out, "Notes", model.notes);
    write_list(out, "References", texts_of(model.references));
    return out.str();
}

std::string description_of(const AssetDescriptor& asset) {
    std::ostringstream out;
    out << asset.kind << ": " << asset.title << '\n';
    write_wrapped(out, asset.summary, "  ");
    write_schema(out, asset.schema);
    write_list(out, "Notes", asset.notes);
    write_list(out, "References", texts_of(asset.references));
    return out.str();
}

std::string study_targets_text() {
    static const char* const lines[][2] = {
        {"/setup/KEY", "a number of the set-up, of the analysis or of an asset"},
        {"/setup/KEY/position/0", "a coordinate of a pose; /setup/KEY/angles/0 an angle of it"},
        {"/setup/KEY/rows/0/COLUMN", "a cell of a table"},
        {"/setup/KEY/columns/COLUMN", "a column of a table, all rows"},
        {"/inputs/SYMBOL/estimate", "the estimate of an input quantity"},
        {"/inputs/SYMBOL/components", "the uncertainty of an input quantity, by a factor"},
        {"/components/ID", "one component of uncertainty wherever it contributes, by a factor"}};
    std::ostringstream out;
    for (const auto& [target, words] : lines)
        out << "  " << target << std::string(28 - std::string(target).size(), ' ') << words << '\n';
    return out.str();
}

}  // namespace covaria
