#include "app/whole_number.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "core/base/in_quotes.h"

namespace covaria {
namespace {

constexpr const char* digit_characters = "0123456789";

/// Exponents beyond this are no number of 64 bits, whatever stands before them.
constexpr int largest_exponent = 40;

/// Takes the digits at `at` away; empty where there are none.
std::string digits_from(const std::string& text, std::size_t& at) {
    const std::size_t end = std::min(text.find_first_not_of(digit_characters, at), text.size());
    std::string digits = text.substr(at, end - at);
    at = end;
    return digits;
}

std::optional<std::uint64_t> number_of(const std::string& digits) {
    std::uint64_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return value;
}

}  // namespace

std::optional<std::uint64_t> whole_number(const std::string& text) {
    std::size_t at = 0;
    std::string digits = digits_from(text, at), decimals;
    if (at < text.size() && text[at] == '.') decimals = digits_from(text, ++at);
    if (digits.empty() && decimals.empty()) return std::nullopt;
    int exponent = 0;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        if (++at < text.size() && text[at] == '+') ++at;
        const auto read = number_of(digits_from(text, at));
        if (!read || *read > largest_exponent) return std::nullopt;
        exponent = static_cast<int>(*read);
    }
    if (at != text.size()) return std::nullopt;
    decimals.erase(decimals.find_last_not_of('0') + 1);
    const int zeros = exponent - static_cast<int>(decimals.size());
    if (zeros < 0) return std::nullopt;
    digits += decimals;
    digits.erase(0, digits.find_first_not_of('0'));
    if (digits.empty()) return 0;
    return number_of(digits + std::string(static_cast<std::size_t>(zeros), '0'));
}

CLI::Option* takes_whole_number(CLI::Option* option) {
    const auto as_digits = [](std::string& text) -> std::string {
        const auto value = whole_number(text);
        if (!value) return in_quotes(text) + " is not a whole number (1000000 and 1e6 are)";
        text = std::to_string(*value);
        return {};
    };
    return option->transform(CLI::Validator(as_digits, ""));
}

}  // namespace covaria
