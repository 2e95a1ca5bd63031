// Cells and heads of a report's tables as text; shared by all writers so that they agree.
#include "core/report/table_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "core/base/symbol.h"
#include "core/report/number_format.h"

namespace covaria {
namespace {

bool is_word_character(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '^' || c == '\'';
}

/// Applies `convert` to each identifier of `text` and `rest` to what is between them.
template <class Convert, class Rest>
std::string by_identifier(std::string_view text, Convert convert, Rest rest) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const bool word = is_word_character(text[i]);
        std::size_t end = i;
        while (end < text.size() && is_word_character(text[end]) == word) ++end;
        const std::string_view part = text.substr(i, end - i);
        const bool identifier = word && std::isalpha(static_cast<unsigned char>(part.front()));
        out += identifier ? convert(part) : rest(part);
        i = end;
    }
    return out;
}

bool is_letter(std::string_view word) {
    return word.size() == 1 || symbol_to_unicode(word) != word;
}

/// "u_by", "alpha_7", but not "file_name": a letter with subscripts.
bool is_subscripted_letter(std::string_view identifier) {
    const std::size_t end = identifier.find_first_of("_^");
    return end != std::string_view::npos && end + 1 < identifier.size() &&
           is_letter(identifier.substr(0, end));
}

std::string unit_suffix(const TableColumn& column) {
    return column.unit.text() == "1" ? "" : " (" + column.unit.display() + ")";
}

/// "-05" -> "⁻⁵"
std::string superscript(int exponent) {
    static const std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        out += digits[static_cast<std::size_t>(digit - '0')];
    return out;
}

}  // namespace

ColumnStyle style_of(const TableBlock& block, std::size_t column) {
    return column < block.styles.size() ? block.styles[column] : ColumnStyle{};
}

bool is_subhead(const TableBlock& block, std::size_t row) {
    const auto& cells = block.table.rows[row];
    return cells.size() == 1 && block.table.columns.size() > 1 &&
           std::holds_alternative<std::string>(cells.front());
}

std::optional<double> shown_number(const TableCell& cell, const TableColumn& column) {
    if (const auto* value = std::get_if<double>(&cell)) return column.unit.from_si(*value);
    if (const auto* quantity = std::get_if<Quantity>(&cell)) return quantity->value;
    return std::nullopt;
}

std::string cell_text(const TableBlock& block, std::size_t row, std::size_t column) {
    const auto& cells = block.table.rows[row];
    if (column >= cells.size()) return {};
    const TableCell& cell = cells[column];
    const TableColumn& head = block.table.columns[column];
    const auto number = shown_number(cell, head);
    const ColumnStyle style = style_of(block, column);
    if (!number) return format_cell(cell, head);
    if (style.decimals >= 0) return format_decimals(*number, style.decimals);
    if (style.match >= 0) {
        const auto other = static_cast<std::size_t>(style.match);
        if (const auto u = shown_number(cells[other], block.table.columns[other]))
            return style.input ? format_estimate(*number, *u) : format_to_match(*number, *u);
    }
    if (style.bare) {
        TableColumn plain = head;
        plain.unit = Unit{};
        return format_cell(*number, plain);
    }
    return format_cell(cell, head);
}

bool is_numeric_column(const TableBlock& block, std::size_t column) {
    bool any = false;
    for (std::size_t r = 0; r < block.table.rows.size(); ++r) {
        if (is_subhead(block, r) || column >= block.table.rows[r].size()) continue;
        const TableCell& cell = block.table.rows[r][column];
        if (std::holds_alternative<std::monostate>(cell)) continue;
        // A number with a unit of its own is a text.
        if (std::holds_alternative<std::string>(cell) && style_of(block, column).match < 0) return false;
        any = true;
    }
    return any;
}

std::string head_text(const TableColumn& column) {
    return (column.is_symbol ? symbols_to_unicode(column.header) : column.header) + unit_suffix(column);
}

std::string head_html(const TableColumn& column) {
    return (column.is_symbol ? symbols_to_html(column.header) : escape_html(column.header)) +
           escape_html(unit_suffix(column));
}

std::string cell_html(const TableBlock& block, std::size_t row, std::size_t column) {
    const std::string text = cell_text(block, row, column);
    if (style_of(block, column).symbol && !is_subhead(block, row)) return symbols_to_html(text);
    const auto& cells = block.table.rows[row];
    const bool number = column < cells.size() && shown_number(cells[column], block.table.columns[column]);
    return number ? escape_html(typeset_number(text)) : text_to_html(text);
}

std::string symbols_to_html(std::string_view text) {
    return by_identifier(
        text, [](std::string_view symbol) { return symbol_to_html(symbol); },
        [](std::string_view rest) { return escape_html(rest); });
}

std::string symbols_to_unicode(std::string_view text) {
    return by_identifier(
        text, [](std::string_view symbol) { return symbol_to_unicode(symbol); },
        [](std::string_view rest) { return std::string(rest); });
}

std::string text_to_html(std::string_view text) {
    return by_identifier(
        text,
        [](std::string_view word) {
            return is_subscripted_letter(word) ? symbol_to_html(word) : escape_html(word);
        },
        [](std::string_view rest) { return escape_html(rest); });
}

std::string equation_to_html(std::string_view text) {
    return by_identifier(
        text,
        [](std::string_view word) {
            return is_letter(word) || is_subscripted_letter(word) ? symbol_to_html(word) : escape_html(word);
        },
        [](std::string_view rest) { return escape_html(rest); });
}

std::string typeset_number(std::string text) {
    const std::size_t e = text.find('e');
    if (e != std::string::npos && e > 0 && e + 1 < text.size() &&
        (text[e + 1] == '-' || text[e + 1] == '+')) {
        const std::size_t end = std::min(text.find_first_not_of("0123456789", e + 2), text.size());
        text.replace(e, end - e, "×10" + superscript(std::atoi(text.c_str() + e + 1)));
    }
    if (!text.empty() && text.front() == '-') text.replace(0, 1, "−");
    return text;
}

std::string escape_html(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

bool looks_like_symbol(std::string_view title) {
    if (title.empty() || !std::all_of(title.begin(), title.end(), is_word_character)) return false;
    return title.size() == 1 || title.find('_') != std::string_view::npos ||
           symbol_to_unicode(title) != std::string(title);
}

}  // namespace covaria
