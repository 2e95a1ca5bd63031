// Days as certificates state them: ISO 8601, "2026-04-17", and intervals of two, "2026-04-17/2026-04-18".
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace covaria {

using Days = std::chrono::sys_days;

/// The day of a text; nothing where it is no date of the calendar.
std::optional<Days> date_of(std::string_view text);

/// A period by its first and its last day.
struct Period {
    Days first, last;
    bool operator==(const Period&) const = default;
};
/// The period of a date, or of two dates in their order with '/' between them; nothing for another text.
std::optional<Period> period_of(std::string_view text);

}  // namespace covaria
