// The units Covaria knows, and the search for the name somebody may have meant.
#include "core/base/unit_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace covaria::detail {

namespace {

constexpr double pi = std::numbers::pi;

// Exponents of length, mass, time, current, temperature, amount, luminous intensity, plane angle.
constexpr Dimension one{};
constexpr Dimension length{{1}};
constexpr Dimension area{{2}};
constexpr Dimension volume{{3}};
constexpr Dimension mass{{0, 1}};
constexpr Dimension duration{{0, 0, 1}};
constexpr Dimension frequency{{0, 0, -1}};
constexpr Dimension current{{0, 0, 0, 1}};
constexpr Dimension charge{{0, 0, 1, 1}};
constexpr Dimension temperature{{0, 0, 0, 0, 1}};
constexpr Dimension amount{{0, 0, 0, 0, 0, 1}};
constexpr Dimension catalytic_activity{{0, 0, -1, 0, 0, 1}};
constexpr Dimension luminous_intensity{{0, 0, 0, 0, 0, 0, 1}};
constexpr Dimension luminous_flux{{0, 0, 0, 0, 0, 0, 1, 2}};
constexpr Dimension illuminance{{-2, 0, 0, 0, 0, 0, 1, 2}};
constexpr Dimension angle{{0, 0, 0, 0, 0, 0, 0, 1}};
constexpr Dimension solid_angle{{0, 0, 0, 0, 0, 0, 0, 2}};
constexpr Dimension angular_velocity{{0, 0, -1, 0, 0, 0, 0, 1}};
constexpr Dimension force{{1, 1, -2}};
constexpr Dimension pressure{{-1, 1, -2}};
constexpr Dimension energy{{2, 1, -2}};
constexpr Dimension power{{2, 1, -3}};
constexpr Dimension dose{{2, 0, -2}};
constexpr Dimension voltage{{2, 1, -3, -1}};
constexpr Dimension resistance{{2, 1, -3, -2}};
constexpr Dimension conductance{{-2, -1, 3, 2}};
constexpr Dimension capacitance{{-2, -1, 4, 2}};
constexpr Dimension magnetic_flux{{2, 1, -2, -1}};
constexpr Dimension flux_density{{0, 1, -2, -1}};
constexpr Dimension inductance{{2, 1, -2, -2}};

constexpr Prefixes none = Prefixes::none;
constexpr Prefixes all = Prefixes::all;

// SI brochure (9th edition): tables 2 to 4 (base and derived units), table 8 (non-SI units accepted), and
// units of workshops. Levels in neper, bel and decibel are left out: a level is a logarithm, not a multiple
// of a unit.
constexpr std::array units{
    UnitEntry{"1", "1", 1, 1, one},
    UnitEntry{"%", "%", 1, 100, one, none, {"percent"}},
    UnitEntry{"ppm", "ppm", 1, 1e6, one},
    UnitEntry{"ppb", "ppb", 1, 1e9, one},
    UnitEntry{"m", "m", 1, 1, length, all, {"metre", "meter"}},
    UnitEntry{"in", "in", 254, 10000, length, none, {"inch", "inches"}},
    UnitEntry{"ft", "ft", 3048, 10000, length, none, {"foot", "feet"}},
    UnitEntry{"yd", "yd", 9144, 10000, length, none, {"yard"}},
    UnitEntry{"thou", "thou", 254, 1e7, length, none, {"mil"}},
    UnitEntry{"uin", "µin", 254, 1e10, length, none, {"microinch", "microinches"}},
    UnitEntry{"au", "au", 149597870700, 1, length},
    UnitEntry{"ha", "ha", 1e4, 1, area, none, {"hectare"}},
    UnitEntry{"L", "L", 1, 1000, volume, all, {"litre", "liter", "l"}},
    UnitEntry{"rad", "rad", 1, 1, angle, all, {"radian"}},
    UnitEntry{"deg", "°", pi, 180, angle, none, {"degree"}},
    UnitEntry{"arcmin", "′", pi, 10800, angle, none, {"arcminute"}},
    UnitEntry{"arcsec", "″", pi, 648000, angle, none, {"arcsecond"}},
    UnitEntry{"mas", "mas", pi, 648000000, angle},
    UnitEntry{"gon", "gon", pi, 200, angle, all, {"grad", "grade"}},
    UnitEntry{"rev", "rev", 2 * pi, 1, angle, none, {"revolution", "turn"}},
    UnitEntry{"sr", "sr", 1, 1, solid_angle, all, {"steradian"}, 0.0, true},
    UnitEntry{"rpm", "rpm", pi, 30, angular_velocity},
    UnitEntry{"K", "K", 1, 1, temperature, all, {"kelvin"}},
    UnitEntry{"degC", "°C", 1, 1, temperature, none, {"celsius"}, 273.15},
    UnitEntry{"degF", "°F", 5, 9, temperature, none, {"fahrenheit"}, 459.67 * 5.0 / 9.0},
    UnitEntry{"degR", "°R", 5, 9, temperature, none, {"rankine"}},
    UnitEntry{"s", "s", 1, 1, duration, all, {"second", "sec"}},
    UnitEntry{"min", "min", 60, 1, duration, none, {"minute"}},
    UnitEntry{"h", "h", 3600, 1, duration, none, {"hour"}},
    UnitEntry{"d", "d", 86400, 1, duration, none, {"day"}},
    UnitEntry{"Hz", "Hz", 1, 1, frequency, all, {"hertz"}},
    UnitEntry{"Bq", "Bq", 1, 1, frequency, all, {"becquerel"}, 0.0, true},
    UnitEntry{"kg", "kg", 1, 1, mass, none, {"kilogram"}},
    UnitEntry{"g", "g", 1, 1000, mass, all, {"gram", "gramme"}},
    UnitEntry{"t", "t", 1000, 1, mass, Prefixes::large, {"tonne"}},
    UnitEntry{"Da", "Da", 1.66053906660e-27, 1, mass, all, {"dalton"}},
    UnitEntry{"lb", "lb", 45359237, 1e8, mass, none, {"pound"}},
    UnitEntry{"N", "N", 1, 1, force, all, {"newton"}},
    UnitEntry{"lbf", "lbf", 44482216152605, 1e13, force},
    UnitEntry{"Pa", "Pa", 1, 1, pressure, all, {"pascal"}},
    UnitEntry{"bar", "bar", 1e5, 1, pressure, all},
    UnitEntry{"psi", "psi", 44482216152605, 64516e5, pressure},
    UnitEntry{"V", "V", 1, 1, voltage, all, {"volt"}},
    UnitEntry{"A", "A", 1, 1, current, all, {"ampere", "amp"}},
    UnitEntry{"C", "C", 1, 1, charge, all, {"coulomb"}},
    UnitEntry{"ohm", "Ω", 1, 1, resistance, all},
    UnitEntry{"S", "S", 1, 1, conductance, all, {"siemens"}},
    UnitEntry{"F", "F", 1, 1, capacitance, all, {"farad"}},
    UnitEntry{"Wb", "Wb", 1, 1, magnetic_flux, all, {"weber"}},
    UnitEntry{"T", "T", 1, 1, flux_density, all, {"tesla"}},
    UnitEntry{"H", "H", 1, 1, inductance, all, {"henry"}},
    UnitEntry{"W", "W", 1, 1, power, all, {"watt"}},
    UnitEntry{"J", "J", 1, 1, energy, all, {"joule"}},
    UnitEntry{"eV", "eV", 1602176634, 1e28, energy, all, {"electronvolt"}},
    UnitEntry{"mol", "mol", 1, 1, amount, all, {"mole"}},
    UnitEntry{"kat", "kat", 1, 1, catalytic_activity, all, {"katal"}, 0.0, true},
    UnitEntry{"cd", "cd", 1, 1, luminous_intensity, all, {"candela"}},
    UnitEntry{"lm", "lm", 1, 1, luminous_flux, all, {"lumen"}, 0.0, true},
    UnitEntry{"lx", "lx", 1, 1, illuminance, all, {"lux"}, 0.0, true},
    UnitEntry{"Gy", "Gy", 1, 1, dose, all, {"gray"}, 0.0, true},
    UnitEntry{"Sv", "Sv", 1, 1, dose, all, {"sievert"}, 0.0, true},
};

/// SI brochure, table 7.
struct Prefix {
    std::string_view letter, word;
    int power;
};
constexpr std::array prefixes{
    Prefix{"da", "deca", 1},   Prefix{"h", "hecto", 2},   Prefix{"k", "kilo", 3},
    Prefix{"M", "mega", 6},    Prefix{"G", "giga", 9},    Prefix{"T", "tera", 12},
    Prefix{"P", "peta", 15},   Prefix{"E", "exa", 18},    Prefix{"Z", "zetta", 21},
    Prefix{"Y", "yotta", 24},  Prefix{"R", "ronna", 27},  Prefix{"Q", "quetta", 30},
    Prefix{"d", "deci", -1},   Prefix{"c", "centi", -2},  Prefix{"m", "milli", -3},
    Prefix{"u", "micro", -6},  Prefix{"n", "nano", -9},   Prefix{"p", "pico", -12},
    Prefix{"f", "femto", -15}, Prefix{"a", "atto", -18},  Prefix{"z", "zepto", -21},
    Prefix{"y", "yocto", -24}, Prefix{"r", "ronto", -27}, Prefix{"q", "quecto", -30}};

bool takes(const UnitEntry& unit, const Prefix& prefix) {
    return unit.prefixes == Prefixes::all || (unit.prefixes == Prefixes::large && prefix.power > 0);
}

KnownUnit without_prefix(const UnitEntry& unit) {
    return {std::string(unit.name), std::string(unit.display),
            unit.numerator,         unit.denominator,
            unit.dimension,         unit.offset};
}

/// "Mg" is 1000/1, not 1000000/1000: short fractions of whole numbers convert without rounding.
void shorten(KnownUnit& unit) {
    while (unit.numerator >= 10.0 && unit.denominator >= 10.0 && std::fmod(unit.numerator, 10.0) == 0.0 &&
           std::fmod(unit.denominator, 10.0) == 0.0) {
        unit.numerator /= 10.0;
        unit.denominator /= 10.0;
    }
}

KnownUnit with_prefix(const UnitEntry& unit, const Prefix& prefix) {
    KnownUnit known = without_prefix(unit);
    known.name = std::string(prefix.letter) + known.name;
    known.display = (prefix.letter == "u" ? "µ" : std::string(prefix.letter)) + known.display;
    (prefix.power > 0 ? known.numerator : known.denominator) *= std::pow(10.0, std::abs(prefix.power));
    shorten(known);
    return known;
}

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

std::string lowered(std::string_view text) {
    std::string low;
    for (const char c : text) low += lower(c);
    return low;
}

bool is_called(const UnitEntry& unit, std::string_view word) {
    return !word.empty() && std::find(unit.words.begin(), unit.words.end(), word) != unit.words.end();
}

/// "mm" for "Millimetres".
std::vector<std::string> named_in_words(std::string_view unknown) {
    std::string word = lowered(unknown);
    for (int plural = 0; plural < 2; ++plural) {
        for (const UnitEntry& unit : units) {
            if (is_called(unit, word)) return {std::string(unit.name)};
            for (const Prefix& prefix : prefixes)
                if (takes(unit, prefix) && word.starts_with(prefix.word) &&
                    is_called(unit, std::string_view(word).substr(prefix.word.size())))
                    return {with_prefix(unit, prefix).name};
        }
        if (!word.ends_with('s')) return {};
        word.pop_back();
    }
    return {};
}

/// Names worth suggesting: with the prefixes that are usual.
std::vector<std::string> usual_names() {
    std::vector<std::string> names;
    for (const UnitEntry& unit : units) {
        names.emplace_back(unit.name);
        for (const Prefix& prefix : prefixes)
            if (takes(unit, prefix) &&
                std::string_view("kMGcmun").find(prefix.letter) != std::string_view::npos)
                names.push_back(with_prefix(unit, prefix).name);
    }
    return names;
}

/// Where two have one name, the one without a prefix comes first: "min", "Pa".
std::map<std::string, KnownUnit, std::less<>> units_by_name() {
    std::map<std::string, KnownUnit, std::less<>> known;
    for (const UnitEntry& unit : units) known.emplace(unit.name, without_prefix(unit));
    for (const UnitEntry& unit : units)
        for (const Prefix& prefix : prefixes)
            if (takes(unit, prefix))
                known.emplace(std::string(prefix.letter) + std::string(unit.name), with_prefix(unit, prefix));
    return known;
}

std::vector<std::string> similar_units(std::string_view unknown) {
    if (std::vector<std::string> named = named_in_words(unknown); !named.empty()) return named;
    const std::size_t tolerated = unknown.size() <= 1 ? 0 : unknown.size() <= 3 ? 1 : 2;
    std::vector<std::pair<std::size_t, std::string>> found;
    for (std::string& name : usual_names()) {
        const std::size_t distance = edit_distance(unknown, name);
        if (distance <= tolerated && distance < name.size()) found.emplace_back(distance, std::move(name));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (const auto& [distance, name] : found)
        if (names.size() < 4 && distance == found.front().first) names.push_back(name);
    return names;
}

}  // namespace

std::span<const UnitEntry> unit_table() {
    return units;
}

std::vector<KnownUnit> all_units() {
    std::vector<KnownUnit> known;
    for (const UnitEntry& unit : units) {
        known.push_back(without_prefix(unit));
        for (const Prefix& prefix : prefixes)
            if (takes(unit, prefix)) known.push_back(*find_unit(with_prefix(unit, prefix).name));
    }
    return known;
}

std::optional<KnownUnit> find_unit(std::string_view name) {
    static const std::map<std::string, KnownUnit, std::less<>> known = units_by_name();
    if (const auto found = known.find(name); found != known.end()) return found->second;
    // Symbols beside the usual one: both letters for the litre, two words for a thousandth of an inch.
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> further{
        {{"mil", "thou"}, {"inch", "in"}, {"foot", "ft"}, {"day", "d"}}};
    for (const auto& [other, unit] : further)
        if (name == other) return find_unit(unit);
    if (name.ends_with('l') && name.size() <= 3)
        return find_unit(std::string(name.substr(0, name.size() - 1)) + "L");
    return std::nullopt;
}

Message unit_suggestion(std::string_view unknown) {
    const std::vector<std::string> names = similar_units(unknown);
    if (names.empty()) {
        std::string all;
        for (const UnitEntry& unit : units) all += (all.empty() ? "" : " ") + std::string(unit.name);
        return tell<" Known units, most of them with the prefixes of the SI: %1.">(all);
    }
    const auto quoted = [](const std::string& name) { return '"' + name + '"'; };
    std::string first = quoted(names.front());
    for (std::size_t i = 1; i + 1 < names.size(); ++i) first += ", " + quoted(names[i]);
    return names.size() == 1 ? tell<" Did you mean %1?">(first)
                             : tell<" Did you mean %1 or %2?">(first, quoted(names.back()));
}

}  // namespace covaria::detail
