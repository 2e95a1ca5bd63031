#include "core/report/csv_text.h"

#include <charconv>

namespace covaria {

namespace {

bool is_number(const std::string& text) {
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, status] = std::from_chars(begin, text.data() + text.size(), value);
    return status == std::errc{} && end == text.data() + text.size();
}

bool would_be_computed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first != std::string::npos &&
           std::string_view("=+-@\t\r\n").find(text[first]) != std::string_view::npos;
}

}  // namespace

std::string csv_text(const std::string& text) {
    const std::string inert = would_be_computed(text) && !is_number(text) ? "'" + text : text;
    if (inert.find_first_of(",\"\r\n") == std::string::npos) return inert;
    std::string out = "\"";
    for (const char c : inert) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string csv_head(const std::string& name, const std::string& unit) {
    return unit.empty() || unit == "1" ? name : name + " (" + unit + ")";
}

}  // namespace covaria
