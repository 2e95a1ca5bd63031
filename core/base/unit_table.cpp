// The units Covaria knows, and the search for the name somebody may have meant.
#include "core/base/unit_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <utility>
#include <vector>

namespace covaria::detail {

namespace {

constexpr double pi = std::numbers::pi;

// Exponents of length, mass, time, current, temperature, amount, luminous intensity, plane angle.
constexpr Dimension one{};
constexpr Dimension length{{1}};
constexpr Dimension mass{{0, 1}};
constexpr Dimension duration{{0, 0, 1}};
constexpr Dimension frequency{{0, 0, -1}};
constexpr Dimension current{{0, 0, 0, 1}};
constexpr Dimension temperature{{0, 0, 0, 0, 1}};
constexpr Dimension angle{{0, 0, 0, 0, 0, 0, 0, 1}};
constexpr Dimension force{{1, 1, -2}};
constexpr Dimension pressure{{-1, 1, -2}};
constexpr Dimension energy{{2, 1, -2}};
constexpr Dimension power{{2, 1, -3}};
constexpr Dimension voltage{{2, 1, -3, -1}};
constexpr Dimension resistance{{2, 1, -3, -2}};

constexpr std::array units{
    UnitEntry{"1", "1", 1, 1, one},
    UnitEntry{"%", "%", 1, 100, one},
    UnitEntry{"ppm", "ppm", 1, 1e6, one},
    UnitEntry{"m", "m", 1, 1, length},
    UnitEntry{"km", "km", 1000, 1, length},
    UnitEntry{"cm", "cm", 1, 100, length},
    UnitEntry{"mm", "mm", 1, 1000, length},
    UnitEntry{"um", "µm", 1, 1e6, length},
    UnitEntry{"nm", "nm", 1, 1e9, length},
    UnitEntry{"rad", "rad", 1, 1, angle},
    UnitEntry{"mrad", "mrad", 1, 1000, angle},
    UnitEntry{"urad", "µrad", 1, 1e6, angle},
    UnitEntry{"deg", "°", pi, 180, angle},
    UnitEntry{"arcmin", "′", pi, 10800, angle},
    UnitEntry{"arcsec", "″", pi, 648000, angle},
    UnitEntry{"gon", "gon", pi, 200, angle},
    UnitEntry{"mgon", "mgon", pi, 200000, angle},
    UnitEntry{"K", "K", 1, 1, temperature},
    UnitEntry{"mK", "mK", 1, 1000, temperature},
    UnitEntry{"degC", "°C", 1, 1, temperature, 273.15},
    UnitEntry{"s", "s", 1, 1, duration},
    UnitEntry{"ms", "ms", 1, 1000, duration},
    UnitEntry{"min", "min", 60, 1, duration},
    UnitEntry{"h", "h", 3600, 1, duration},
    UnitEntry{"kg", "kg", 1, 1, mass},
    UnitEntry{"g", "g", 1, 1000, mass},
    UnitEntry{"mg", "mg", 1, 1e6, mass},
    UnitEntry{"N", "N", 1, 1, force},
    UnitEntry{"mN", "mN", 1, 1000, force},
    UnitEntry{"kN", "kN", 1000, 1, force},
    UnitEntry{"Pa", "Pa", 1, 1, pressure},
    UnitEntry{"hPa", "hPa", 100, 1, pressure},
    UnitEntry{"kPa", "kPa", 1000, 1, pressure},
    UnitEntry{"MPa", "MPa", 1e6, 1, pressure},
    UnitEntry{"bar", "bar", 1e5, 1, pressure},
    UnitEntry{"V", "V", 1, 1, voltage},
    UnitEntry{"mV", "mV", 1, 1000, voltage},
    UnitEntry{"uV", "µV", 1, 1e6, voltage},
    UnitEntry{"A", "A", 1, 1, current},
    UnitEntry{"mA", "mA", 1, 1000, current},
    UnitEntry{"ohm", "Ω", 1, 1, resistance},
    UnitEntry{"Hz", "Hz", 1, 1, frequency},
    UnitEntry{"W", "W", 1, 1, power},
    UnitEntry{"J", "J", 1, 1, energy},
};

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// Number of single letters to insert, delete or replace; letters that differ in case only count as equal.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replace, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

std::vector<std::string_view> similar_units(std::string_view unknown) {
    const std::size_t tolerated = unknown.size() <= 1 ? 0 : unknown.size() <= 3 ? 1 : 2;
    std::vector<std::pair<std::size_t, std::string_view>> found;
    for (const UnitEntry& unit : units) {
        const std::size_t distance = edit_distance(unknown, unit.name);
        if (distance <= tolerated && distance < unit.name.size()) found.emplace_back(distance, unit.name);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string_view> names;
    for (const auto& [distance, name] : found)
        if (names.size() < 4 && distance <= found.front().first + 1) names.push_back(name);
    return names;
}

}  // namespace

std::span<const UnitEntry> unit_table() {
    return units;
}

const UnitEntry* find_unit(std::string_view name) {
    const auto it =
        std::find_if(units.begin(), units.end(), [&](const UnitEntry& u) { return u.name == name; });
    return it == units.end() ? nullptr : &*it;
}

std::string unit_suggestion(std::string_view unknown) {
    const std::vector<std::string_view> names = similar_units(unknown);
    std::string text = names.empty() ? " Known units:" : " Did you mean ";
    if (names.empty()) {
        for (const UnitEntry& unit : units) text += " " + std::string(unit.name);
        return text + ".";
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += '"' + std::string(names[i]) + '"';
    }
    return text + "?";
}

}  // namespace covaria::detail
