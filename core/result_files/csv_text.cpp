#include "core/result_files/csv_text.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/base/printable.h"

namespace covaria {

namespace {

bool is_number(const std::string& text) {
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, status] = std::from_chars(begin, text.data() + text.size(), value);
    return status == std::errc{} && end == text.data() + text.size();
}

bool would_be_computed(const std::string& cell) {
    const std::size_t first = cell.find_first_not_of(' ');
    return first != std::string::npos && !is_number(cell) &&
           std::string_view("=+-@\t\r\n").find(cell[first]) != std::string_view::npos;
}

/// Text that no spreadsheet takes for a formula: where lists are parted by semicolons (a German Excel), or by
/// tabs, it is several cells.
std::string inert(const std::string& text) {
    std::string out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(";\t\n", begin), text.size());
        const std::string cell = text.substr(begin, end - begin);
        out += (would_be_computed(cell) ? "'" : "") + cell;
        if (end < text.size()) out += text[end];
        begin = end + 1;
    }
    return out;
}

}  // namespace

std::string csv_text(const std::string& text) {
    const bool begins_blank = text.find_first_of("\t\r\n") == 0;
    const std::string cell = (begins_blank ? "'" : "") + inert(printable(text));
    if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
    std::string out = "\"";
    for (const char c : cell) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string csv_head(const std::string& name, const std::string& unit) {
    return unit.empty() || unit == "1" ? name : name + " (" + unit + ")";
}

}  // namespace covaria
