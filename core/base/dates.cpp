#include "core/base/dates.h"

#include <algorithm>
#include <charconv>

namespace covaria {

namespace {

std::optional<int> number_of_digits(std::string_view text) {
    int number = 0;
    const bool all = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    std::from_chars(text.data(), text.data() + text.size(), number);
    return all ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<Days> date_of(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
    const auto year = number_of_digits(text.substr(0, 4)), month = number_of_digits(text.substr(5, 2)),
               day = number_of_digits(text.substr(8, 2));
    if (!year || !month || !day) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(unsigned(*month)),
                                           std::chrono::day(unsigned(*day))};
    return date.ok() ? std::optional(Days(date)) : std::nullopt;
}

std::optional<Period> period_of(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto first = date_of(text.substr(0, slash));
    const auto last = slash == std::string_view::npos ? first : date_of(text.substr(slash + 1));
    if (!first || !last || *last < *first) return std::nullopt;
    return Period{*first, *last};
}

}  // namespace covaria
