// Ways out where a temperature in degC stands for what it is not (core/base/temperature.h).
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "core/base/in_quotes.h"
#include "core/base/temperature.h"
#include "core/kinds/equation/setup.h"
#include "core/quantity/statement.h"
#include "core/setup/message_text.h"
#include "core/text/symbol.h"

namespace covaria::equation_model {

namespace {

/// Without the tail of a conversion: 0.4.
double without_tail(double figure) {
    const std::string text = readable_number(figure);
    double read = figure;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return read;
}

/// Byte at which the character with this number (from 0) begins; a line is UTF-8.
std::size_t byte_of(const std::string& line, std::size_t character) {
    std::size_t at = 0;
    for (; at < line.size(); ++at)
        if ((static_cast<unsigned char>(line[at]) & 0xC0) != 0x80 && character-- == 0) break;
    return at;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char c : text)
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    return lines;
}

/// The lines of the equations in which each of the places has become what `made` makes of it.
template <class Made>
std::vector<Remedy::Value> rewritten(const StatedEquations& stated, std::vector<equation::Place> places,
                                     const Made& made) {
    std::vector<std::string> lines = lines_of(stated.text);
    std::map<std::size_t, std::string> changed;
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
        return std::pair(a.line, a.column) > std::pair(b.line, b.column);
    });
    for (const equation::Place& place : places) {
        if (place.line < 1 || place.line > lines.size()) continue;
        std::string& line = lines[place.line - 1];
        const std::size_t begin = byte_of(line, place.column - 1);
        const std::size_t end = byte_of(line, place.column - 1 + place.length);
        line.replace(begin, end - begin, made(line.substr(begin, end - begin)));
        changed[place.line - 1] = line;
    }
    std::vector<Remedy::Value> values;
    for (const auto& [index, line] : changed)
        values.push_back(
            {equation_fields().place(&StatedEquations::text) + "/" + std::to_string(index), line});
    return values;
}

template <class M>
Remedy::Value cell(std::size_t row, M StatedComponent::*column, decltype(Remedy::Value::value) value) {
    return {equation_fields().place(&StatedEquations::components, row, column), std::move(value)};
}

/// The row that gives the quantity its value and unit.
const StatedComponent* first_row(const StatedEquations& stated, const std::string& symbol) {
    const auto found =
        std::find_if(stated.components.begin(), stated.components.end(),
                     [&](const StatedComponent& row) { return plain_symbol(row.symbol) == symbol; });
    return found == stated.components.end() ? nullptr : &*found;
}

/// Adds two ways out: a difference, and a thermodynamic temperature, with all rows of the quantity in K (in
/// degR, where they are in degF).
void add_remedies_of_quantity(const StatedEquations& stated, const std::string& symbol, const Unit& unit,
                              std::vector<Remedy>& remedies) {
    const Unit interval = unit.interval();
    Remedy difference{tell<"a difference: %1 in %2">(symbol, interval.display()), {}};
    Remedy thermodynamic{tell<"a thermodynamic temperature: %1 in %2">(symbol, interval.display()), {}};
    bool has_limits = false;
    for (std::size_t row = 0; row < stated.components.size(); ++row) {
        const StatedComponent& component = stated.components[row];
        if (plain_symbol(component.symbol) != symbol) continue;
        has_limits = has_limits || component.statement == "limits";
        const auto take_zero_away = [&](std::string StatedComponent::*column) {
            const Result<Unit> typed = Unit::parse(component.*column);
            if (!typed || !typed->has_offset()) return;
            for (Remedy* remedy : {&difference, &thermodynamic})
                remedy->values.push_back(cell(row, column, typed->interval().text()));
        };
        take_zero_away(&StatedComponent::unit);
        take_zero_away(&StatedComponent::stated_unit);
        const double from_zero = interval.from_si(unit.to_si(component.value.value_or(0.0)));
        if (component.value)
            thermodynamic.values.push_back(cell(row, &StatedComponent::value, without_tail(from_zero)));
    }
    remedies.push_back(std::move(difference));
    const bool is_observed =
        std::any_of(stated.observations.begin(), stated.observations.end(),
                    [&](const Observation& row) { return plain_symbol(row.quantity) == symbol; });
    if (!has_limits && !is_observed) remedies.push_back(std::move(thermodynamic));
}

std::vector<Remedy> remedies_of(const equation::TextProblem& problem, const StatedEquations& stated) {
    std::vector<Remedy> remedies;
    if (problem.reading.empty()) return remedies;
    const std::string& reading = problem.reading;
    if (reading.ends_with(']')) {  // a number with its unit, which is written as a difference instead
        const std::size_t behind = reading.find(" [");
        const std::string typed = reading.substr(behind + 2, reading.size() - behind - 3);
        const Unit interval = Unit::parse(typed).value_or(Unit::of("K")).interval();
        const std::string difference = reading.substr(0, behind) + " [" + interval.text() + "]";
        remedies.push_back({tell<"a difference: %1">(difference),
                            rewritten(stated, problem.readings, [&](const auto&) { return difference; })});
        return remedies;
    }
    const StatedComponent* row = first_row(stated, reading);
    const Result<Unit> unit = row ? Unit::parse(row->unit) : Result<Unit>(Unit());
    const bool is_stated = row && unit && unit->has_offset();
    if (is_stated) add_remedies_of_quantity(stated, reading, *unit, remedies);
    const std::string scale = is_stated ? unit->text() : "degC";
    const auto shift = [&](const std::string& text) { return "(" + text + " - 0 [" + scale + "])"; };
    Remedy on_scale{tell<"its reading in %2: %1 - 0 [%2]">(reading, scale),
                    rewritten(stated, problem.readings, shift)};
    remedies.insert(remedies.begin() + (remedies.empty() ? 0 : 1), std::move(on_scale));
    return remedies;
}

}  // namespace

void report(const equation::TextProblems& found, const StatedEquations& stated, Problems& problems) {
    report(found, problems);
    for (std::size_t i = 0; i < found.size(); ++i)
        problems.items()[problems.items().size() - found.size() + i].remedies = remedies_of(found[i], stated);
}

std::vector<Remedy> remedies_for_part(const StatedEquations& stated, std::size_t row, const Unit& unit,
                                      double estimate) {
    const StatedComponent& component = stated.components[row];
    const StatementKind* kind = find_statement(component.statement);
    const Result<Unit> typed =
        Unit::parse(component.stated_unit.empty() ? component.unit : component.stated_unit);
    if (!kind || !component.a || !typed || component.statement == "limits") return {};
    const bool is_part = is_part_of_estimate(*typed, unit);
    const double further = component.statement == "mpe" ? component.b.value_or(0.0) / 100.0 : 0.0;
    if (!is_part && further == 0.0) return {};
    const double reading = std::abs(unit.from_si(estimate));
    const Unit interval = unit.interval();
    const auto figure = [&](double part) {  // in K, or in the unit in which it is typed
        return without_tail(is_part ? reading * typed->interval_to_si(part)
                                    : part + typed->interval_from_si(interval.to_si(reading * further)));
    };
    const double a = without_tail(figure(*component.a) + (is_part ? reading * further : 0.0));
    const double in_interval = without_tail(is_part ? a : interval.from_si(typed->interval_to_si(a)));
    Remedy remedy{tell<"a part of its reading in %1: %2">(unit.text(), quantity_words(in_interval, interval)),
                  {cell(row, &StatedComponent::a, a)}};
    if (further != 0.0) remedy.values.push_back(cell(row, &StatedComponent::b, std::monostate()));
    if (!is_part) return {remedy};
    remedy.values.push_back(cell(row, &StatedComponent::stated_unit, interval.text()));
    if (kind->b_has_unit && !kind->b.empty() && component.b)
        remedy.values.push_back(cell(row, &StatedComponent::b, figure(*component.b)));
    return {remedy};
}

std::vector<Remedy> remedies_for_statement(const StatedEquations& stated, std::size_t row, const Unit& unit,
                                           const std::optional<double>& estimate) {
    if (is_reading(unit))
        return estimate ? remedies_for_part(stated, row, unit, *estimate) : std::vector<Remedy>();
    const StatedComponent& component = stated.components[row];
    const Result<Unit> typed = Unit::parse(component.stated_unit);
    if (component.statement != "limits" || !typed || typed->dimension() != unit.dimension() ||
        !is_reading_for_difference(*typed, unit))
        return {};
    const std::string symbol = plain_symbol(component.symbol);
    const Unit interval = typed->interval();
    std::vector<Remedy> remedies{{tell<"a difference: %1 in %2">(symbol, interval.display()),
                                  {cell(row, &StatedComponent::stated_unit, interval.text())}}};
    if (first_row(stated, symbol) == &component)
        remedies.push_back({tell<"a temperature: %1 in %2">(symbol, typed->text()),
                            {cell(row, &StatedComponent::unit, typed->text())}});
    return remedies;
}

}  // namespace covaria::equation_model
