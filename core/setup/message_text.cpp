#include "core/setup/message_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace covaria {

namespace {

// Levenshtein distance, one row at a time; a swap of neighbours counts as two edits.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

struct NamedDimension {
    Dimension dimension;
    Message (*words)();
};

// Exponents: length, mass, time, current, temperature, amount, luminous intensity, plane angle.
constexpr NamedDimension named_dimensions[] = {
    {{{0, 0, 0, 0, 0, 0, 0, 0}}, tell<"a pure number">},
    {{{1, 0, 0, 0, 0, 0, 0, 0}}, tell<"a length">},
    {{{2, 0, 0, 0, 0, 0, 0, 0}}, tell<"an area">},
    {{{3, 0, 0, 0, 0, 0, 0, 0}}, tell<"a volume">},
    {{{0, 1, 0, 0, 0, 0, 0, 0}}, tell<"a mass">},
    {{{0, 0, 1, 0, 0, 0, 0, 0}}, tell<"a time">},
    {{{0, 0, -1, 0, 0, 0, 0, 0}}, tell<"a frequency">},
    {{{0, 0, 0, 1, 0, 0, 0, 0}}, tell<"an electric current">},
    {{{0, 0, 0, 0, 1, 0, 0, 0}}, tell<"a temperature">},
    {{{0, 0, 0, 0, -1, 0, 0, 0}}, tell<"an expansion coefficient">},
    {{{0, 0, 0, 0, 0, 0, 0, 1}}, tell<"an angle">},
    {{{1, 0, -1, 0, 0, 0, 0, 0}}, tell<"a velocity">},
    {{{1, 0, -2, 0, 0, 0, 0, 0}}, tell<"an acceleration">},
    {{{1, 1, -2, 0, 0, 0, 0, 0}}, tell<"a force">},
    {{{2, 1, -2, 0, 0, 0, 0, 0}}, tell<"a moment">},
    {{{-1, 1, -2, 0, 0, 0, 0, 0}}, tell<"a pressure">},
    {{{0, 1, -2, 0, 0, 0, 0, 0}}, tell<"a stiffness">},
    {{{2, 1, -3, -1, 0, 0, 0, 0}}, tell<"a voltage">},
    {{{2, 1, -3, -2, 0, 0, 0, 0}}, tell<"an electric resistance">},
    {{{0, 0, 1, 1, 0, 0, 0, 0}}, tell<"an electric charge">},
    {{{-2, -1, 4, 2, 0, 0, 0, 0}}, tell<"a capacitance">},
    {{{2, 1, -2, -2, 0, 0, 0, 0}}, tell<"an inductance">},
    {{{0, 1, -2, -1, 0, 0, 0, 0}}, tell<"a magnetic flux density">},
    {{{2, 1, -2, -1, 0, 0, 0, 0}}, tell<"a magnetic flux">},
    {{{2, 1, -3, 0, 0, 0, 0, 0}}, tell<"a power">},
    {{{0, 0, 0, 0, 0, 1, 0, 0}}, tell<"an amount of substance">},
    {{{0, 0, 0, 0, 0, 0, 1, 0}}, tell<"a luminous intensity">},
    {{{0, 0, -1, 0, 0, 0, 0, 1}}, tell<"an angular velocity">},
    {{{-3, 1, 0, 0, 0, 0, 0, 0}}, tell<"a density">},
};

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance >= best_distance || distance >= std::max(name.size(), candidate.size())) continue;
        best = candidate;
        best_distance = distance;
    }
    return best;
}

Message did_you_mean(const std::string& name, const std::vector<std::string>& candidates) {
    const std::string nearest = nearest_name(name, candidates);
    return nearest.empty() ? Message{} : tell<" (did you mean '%1'?)">(nearest);
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
        text += "'" + names[i] + "'";
    }
    return text;
}

Message dimension_words(const Unit& unit) {
    for (const NamedDimension& named : named_dimensions)
        if (named.dimension == unit.dimension()) return named.words();
    return tell<"measured in %1">(unit.display());
}

std::string shortest_number(double value) {
    if (value == 0.0) return "0";  // no "-0"
    const double magnitude = std::abs(value);
    const bool plain = magnitude >= 1e-5 && magnitude < 1e15;
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value,
                                   plain ? std::chars_format::fixed : std::chars_format::scientific);
    return {text, end.ptr};
}

std::string readable_number(double value) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "infinity" : "minus infinity";
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 12);
    return {text, end.ptr};
}

std::string quantity_words(double value, const Unit& unit) {
    return unit == Unit{} ? readable_number(value) : readable_number(value) + " " + unit.text();
}

}  // namespace covaria
