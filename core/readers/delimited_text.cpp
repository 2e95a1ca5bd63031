#include "core/readers/delimited_text.h"

#include <algorithm>

#include "core/base/text_places.h"
#include "core/base/utf8.h"

namespace covaria {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

bool is_comment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos) return false;
    line.remove_prefix(first);
    // The text "sep=;" tells Excel the separator.
    return line[0] == '#' || line[0] == '!' || line.starts_with("//") ||
           (line.starts_with("sep=") && line.find_last_not_of(blanks) <= 4);
}

std::string_view next_line(std::string_view& rest) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return line;
}

std::string_view first_line(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = next_line(text);
        if (line.find_first_not_of(blanks) != std::string_view::npos && !is_comment(line)) return line;
    }
    return {};
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Whether all commas stand between digits, one in a word, in at least three words.
bool has_decimal_commas(std::string_view line) {
    for (std::size_t at = line.find(','); at != std::string_view::npos; at = line.find(',', at + 1))
        if (at == 0 || at + 1 >= line.size() || !is_digit(line[at - 1]) || !is_digit(line[at + 1]))
            return false;
    const std::vector<std::string> words = blank_separated(line);
    const auto has_one_at_most = [](const std::string& word) {
        return std::count(word.begin(), word.end(), ',') <= 1;
    };
    return words.size() >= 3 && std::all_of(words.begin(), words.end(), has_one_at_most);
}

/// Whether tabs stand between words, not behind blanks that align them: where there are both, at least two
/// tabs, none beside a blank.
bool has_tabs(std::string_view line) {
    line = line.substr(std::min(line.find_first_not_of(blanks), line.size()));
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    const auto tabs = std::count(line.begin(), line.end(), '\t');
    if (line.find(' ') == std::string_view::npos) return tabs > 0;
    return tabs > 1 && line.find(" \t") == std::string_view::npos &&
           line.find("\t ") == std::string_view::npos;
}

Result<void> scan_blank_separated(std::string_view text, const TakeCsvRow& take) {
    int number = 0;
    while (!text.empty()) {
        const std::string_view line = next_line(text);
        ++number;
        if (is_comment(line)) continue;
        if (valid_utf8(line) < line.size())
            return refused_at(number, static_cast<int>(valid_utf8(line)) + 1,
                              tell<"the text is not encoded as UTF-8; save it as UTF-8">());
        std::vector<std::string> cells = blank_separated(line);
        if (cells.size() > most_csv_columns)
            return refused_at(number, tell<"more than %1 columns are not read">(most_csv_columns));
        if (!cells.empty() && !take({number, std::move(cells)})) break;
    }
    return {};
}

}  // namespace

Message DelimitedText::words() const {
    switch (separator) {
        case '\t':
            return tell<"columns between tabs">();
        case ';':
            return tell<"columns between semicolons">();
        case ',':
            return tell<"columns between commas">();
        default:
            return decimal_comma ? tell<"columns between blanks, decimal commas">()
                                 : tell<"columns between blanks">();
    }
}

std::vector<std::string> blank_separated(std::string_view line) {
    std::vector<std::string> cells;
    std::size_t at = 0;
    while ((at = std::min(line.find_first_not_of(blanks, at), line.size())) < line.size()) {
        const bool quoted = line[at] == '"' && line.find('"', at + 1) != std::string_view::npos;
        const std::size_t begin = quoted ? at + 1 : at;
        const std::size_t end =
            std::min(quoted ? line.find('"', begin) : line.find_first_of(blanks, begin), line.size());
        if (cells.size() > most_csv_columns) break;  // the caller that scans refuses them
        cells.emplace_back(line.substr(begin, end - begin));
        at = quoted ? end + 1 : end;
    }
    return cells;
}

DelimitedText delimited_text_of(std::string_view text) {
    const std::string_view line = first_line(without_byte_order_mark(text));
    if (has_tabs(line)) return {'\t', true};
    if (line.find(';') != std::string_view::npos) return {';', true};
    if (line.find(',') == std::string_view::npos) return {' ', false};
    return has_decimal_commas(line) ? DelimitedText{' ', true} : DelimitedText{',', false};
}

Result<void> scan_table(std::string_view text, const DelimitedText& format, std::size_t& comments,
                        const TakeCsvRow& take) {
    text = without_byte_order_mark(text);
    for (std::string_view rest = text; !rest.empty();) comments += is_comment(next_line(rest));
    if (format.separator == ' ') return scan_blank_separated(text, take);
    return scan_csv(text, format.separator,
                    [&](CsvRow&& row) { return is_comment(row.cells.front()) || take(std::move(row)); });
}

std::vector<std::string> first_cells(std::string_view text, const DelimitedText& format) {
    std::vector<std::string> cells;
    std::size_t comments = 0;
    // Problems of the text are reported when the whole file is read.
    static_cast<void>(scan_table(text, format, comments, [&](CsvRow&& row) {
        cells = std::move(row.cells);
        return false;
    }));
    return cells;
}

}  // namespace covaria
