#include "core/project/csv_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/utf8.h"

namespace covaria {

namespace {

Error error_at(int line, Message message) {
    return {ErrorCode::bad_input, std::move(message), {}, {}, line};
}

std::string trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r");
    const auto end = text.find_last_not_of(" \t\r");
    return begin == std::string_view::npos ? std::string{} : std::string(text.substr(begin, end - begin + 1));
}

class CsvScanner {
public:
    CsvScanner(std::string_view text, char separator, const TakeCsvRow& take)
        : text_(text), separator_(separator), take_(take) {}

    Result<void> run() {
        while (at_ < text_.size()) {
            if (skip_comment()) continue;
            CsvRow row{line_, {}};
            if (auto read = read_row(row); !read) return fail(read.error());
            const bool empty = std::all_of(row.cells.begin(), row.cells.end(),
                                           [](const std::string& cell) { return cell.empty(); });
            if (!empty && !take_(std::move(row))) break;
        }
        return {};
    }

private:
    bool skip_comment() {
        const auto first = text_.find_first_not_of(" \t", at_);
        if (first == std::string_view::npos || text_[first] != '#') return false;
        const auto end = text_.find('\n', at_);
        at_ = end == std::string_view::npos ? text_.size() : end + 1;
        ++line_;
        return true;
    }

    Result<void> read_row(CsvRow& row) {
        for (;;) {
            auto cell = read_cell();
            if (!cell) return fail(cell.error());
            if (row.cells.size() == most_csv_columns)
                return fail(error_at(row.line, tell<"more than %1 columns are not read">(most_csv_columns)));
            row.cells.push_back(std::move(*cell));
            if (at_ >= text_.size()) return {};
            const char stop = text_[at_++];
            if (stop == separator_) continue;
            ++line_;
            return {};
        }
    }

    // A cell ends at a separator, a line feed or the end of the text.
    Result<std::string> read_cell() {
        const std::size_t begin = text_.find_first_not_of(separator_ == '\t' ? " " : " \t", at_);
        if (begin != std::string_view::npos && text_[begin] == '"') {
            at_ = begin;
            return read_quoted();
        }
        const char stops[] = {separator_, '\n'};
        const std::size_t end = std::min(text_.find_first_of({stops, 2}, at_), text_.size());
        std::string cell = trimmed(text_.substr(at_, end - at_));
        at_ = end;
        return cell;
    }

    Result<std::string> read_quoted() {
        const int begin_line = line_;
        std::string cell;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\n') ++line_;
            if (text_[at_] != '"')
                cell += text_[at_];
            else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"')
                cell += text_[++at_];
            else
                break;
        }
        if (at_ >= text_.size())
            return fail(error_at(begin_line, tell<"the quote that begins here is not closed">()));
        ++at_;
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\r')) ++at_;
        if (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n')
            return fail(error_at(
                line_,
                tell<
                    "text follows the closing quote of a cell; write a quote inside a quoted cell twice">()));
        return cell;
    }

    std::string_view text_;
    char separator_;
    const TakeCsvRow& take_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

char csv_separator(std::string_view text) {
    bool quoted = false, comment = false, content = false, semicolon = false;
    for (const char c : text) {
        if (c == '\n' && !quoted) {
            if (content) break;
            comment = false;
            continue;
        }
        if (c == '#' && !content) comment = true;
        if (comment) continue;
        if (c == '"') quoted = !quoted;
        if (c != ' ' && c != '\r' && c != '\t') content = true;
        if (quoted) continue;
        if (c == '\t' && content) return '\t';
        semicolon = semicolon || c == ';';
    }
    return semicolon ? ';' : ',';
}

Result<void> scan_csv(std::string_view text, char separator, const TakeCsvRow& take) {
    if (text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF")
        return fail(error_at(1, tell<"the text is encoded as UTF-16; save it as UTF-8">()));
    text = without_byte_order_mark(text);
    if (const std::size_t valid = valid_utf8(text); valid < text.size()) {
        const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(valid), '\n');
        return fail(error_at(1 + static_cast<int>(lines),
                             tell<"the text is not encoded as UTF-8; save it as UTF-8">()));
    }
    return CsvScanner(text, separator, take).run();
}

Result<CsvText> read_csv(std::string_view text, std::optional<char> separator) {
    CsvText csv;
    csv.separator = separator ? *separator : csv_separator(text);
    auto scanned = scan_csv(text, csv.separator, [&](CsvRow&& row) {
        csv.rows.push_back(std::move(row));
        return true;
    });
    if (!scanned) return fail(scanned.error());
    return csv;
}

std::optional<double> csv_number(std::string text, bool decimal_comma) {
    constexpr std::string_view minus = "\xE2\x88\x92";  // U+2212
    if (text.compare(0, minus.size(), minus) == 0) text.replace(0, minus.size(), "-");
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.erase(0, 1);
    const auto comma = text.find(',');
    if (decimal_comma && comma != std::string::npos && text.find('.') == std::string::npos) text[comma] = '.';
    const std::size_t first = !text.empty() && text[0] == '-' ? 1 : 0;
    if (first >= text.size() || text.find_first_of("0123456789.", first) != first) return std::nullopt;
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

}  // namespace covaria
