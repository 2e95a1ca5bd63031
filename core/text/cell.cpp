#include "core/text/cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/head_with_unit.h"
#include "core/text/numbers.h"
#include "core/text/written_out.h"

namespace covaria {
namespace {

/// Number in the view's units; nothing for cells without a number.
std::optional<Quantity> shown_number(const Cell& cell, const DisplayUnits& units) {
    if (const auto* number = std::get_if<Measured>(&cell)) return number->in(units);
    const auto* quantity = std::get_if<Quantity>(&cell);
    if (!quantity) return std::nullopt;
    const Unit& unit = units.of(quantity->unit);
    return unit == quantity->unit ? *quantity : Quantity{unit.from_si(quantity->si()), unit};
}

double as_headed(const NumberRule& rule, double value) {
    return rule.percent ? 100.0 * value : value;
}

/// Significant digits of a column of uncertainties or of figures.
int digits_of(const NumberRule& rule, const TableView& view) {
    const bool of_view = rule.role == NumberRole::uncertainty || rule.no_fewer;
    return of_view ? std::max(rule.digits, view.digits) : rule.digits;
}

/// A cell whose number is being rounded.
struct Place {
    const Table& table;
    const Column& column;
    const std::size_t row;
    const TableView& view;

    /// The largest size among the numbers of the row that are in this unit; nothing where the column shares
    /// no power of ten.
    std::optional<double> largest_of_row(const Unit& unit) const {
        if (column.rule.row.empty()) return std::nullopt;
        double largest = 0.0;
        for (const std::string& key : column.rule.row) {
            const Column* other = table.find(key);
            const auto number = other ? shown_number(other->cell(row), view.units) : std::nullopt;
            if (number && number->unit == unit && std::isfinite(number->value))
                largest = std::max(largest, std::abs(number->value));
        }
        return largest;
    }

    std::string significant(double value, const Unit& unit) const {
        const int digits = digits_of(column.rule, view);
        if (const auto largest = largest_of_row(unit); largest && std::isfinite(value) && value != 0.0)
            return format_in_row(value, decimals_for(value, digits), *largest);
        return format_significant(value, digits, form_of(table, column, unit, view));
    }

    std::string estimate(double value, const Unit& unit) const {
        const Column* of = table.find(column.rule.of);
        const auto u = of ? shown_number(of->cell(row), view.units) : std::nullopt;
        if (!u) return format_typed(value);
        const bool has_digits = of->rule.role == NumberRole::uncertainty || of->rule.digits > 0;
        const int digits = has_digits ? digits_of(of->rule, view) : view.digits;
        // Two digits of it leave the decimals that `digits` of u leave.
        if (column.rule.keeps_typed) return format_estimate(value, u->value * std::pow(10.0, 2 - digits));
        const auto largest = largest_of_row(unit);
        if (!largest || !std::isfinite(u->value) || u->value == 0.0)
            return format_to_match(value, u->value, digits);
        return format_in_row(value, decimals_for(u->value, digits), *largest);
    }

    std::string number(double value, const Unit& unit) const {
        const NumberRule& rule = column.rule;
        if (row < rule.by_row.size() && rule.by_row[row] >= 0)
            return format_decimals(value, rule.by_row[row]);
        switch (rule.role) {
            case NumberRole::uncertainty:
            case NumberRole::figure:
                return significant(value, unit);
            case NumberRole::estimate:
                return estimate(value, unit);
            case NumberRole::fixed:
                return format_decimals(value, rule.decimals);
            case NumberRole::part_of_limit:
                return format_part_of_limit(value, rule.decimals);
            case NumberRole::degrees_of_freedom:
                return format_degrees_of_freedom(value);
            case NumberRole::typed:
                break;
        }
        return format_typed(value);
    }
};

std::string rounded_number(const Place& place, const Cell& cell, const Quantity& shown) {
    const Column& column = place.column;
    const auto* measured = std::get_if<Measured>(&cell);
    const bool is_quotient = measured && !(measured->per == Unit{});
    const double value = is_quotient ? shown.value : without_residue(shown.value, shown.unit);
    const bool in_head = column.unit && shown.unit == place.view.units.of(*column.unit);
    return place.number(as_headed(column.rule, value), shown.unit) +
           (column.says_unit && !in_head ? unit_after_number(shown.unit) : std::string());
}

/// Decimals shared by a column of one kind of quantity to which no rule gives any; nothing: each by itself.
/// Numbers that were computed are read against the largest one; uncertainties have digits of their own.
std::optional<int> decimals_of_all(const Table& table, const Column& column) {
    const NumberRule& rule = column.rule;
    const bool of_figures = rule.role == NumberRole::figure;
    if (!column.unit || *column.unit == Unit{} || (!of_figures && rule.role != NumberRole::typed)) return {};
    std::vector<double> numbers;
    double smallest = 0.0, largest = 0.0;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const auto number = shown_number(column.cell(row), {});
        if (!number) continue;
        if (!(number->unit == *column.unit) || !std::isfinite(number->value)) return {};
        numbers.push_back(without_residue(number->value, *column.unit));
        smallest = std::min(smallest, numbers.back());
        largest = std::max(largest, std::abs(numbers.back()));
    }
    const bool are_deviations = of_figures && smallest < 0.0;
    if (numbers.empty() || (of_figures && !are_deviations)) return {};
    int decimals = are_deviations ? -1 : common_decimals(numbers);
    if (decimals < 0 && largest > 0.0) {
        decimals = std::max(0, decimals_for(largest, are_deviations ? rule.digits : computed_digits));
        // 21.521 degC is computed, too: in K it is another number.
        const auto has_no_more = [&](int fewer) {
            return std::ranges::all_of(numbers, [fewer, step = std::pow(10.0, -decimals)](double number) {
                const double part = number * std::pow(10.0, fewer);
                return std::abs(part - std::round(part)) < 0.5 * step * std::pow(10.0, fewer);
            });
        };
        while (!are_deviations && decimals > 0 && has_no_more(decimals - 1)) --decimals;
    }
    const bool is_lost = std::ranges::any_of(numbers, [step = std::pow(10.0, -decimals)](double number) {
        return number != 0.0 && std::abs(number) < 0.5 * step;
    });
    const bool shared = decimals >= 0 && decimals <= most_shared_decimals && !is_lost;
    return shared ? std::optional(decimals) : std::nullopt;
}

/// The cells of a column in which a number that is smaller than rounding of a sum beside the largest is zero.
Cells without_rounding(const Table& table, const Column& column) {
    constexpr double rounding = 1e-14;
    if (!column.unit || *column.unit == Unit{}) return column.cell;
    double largest = 0.0;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const Cell cell = column.cell(row);
        if (const auto* number = std::get_if<Measured>(&cell))
            largest = std::max(largest, std::abs(number->si));
    }
    return Cells([cells = column.cell, least = rounding * largest](std::size_t row) {
        Cell cell = cells(row);
        if (auto* number = std::get_if<Measured>(&cell); number && std::abs(number->si) < least)
            number->si = 0.0;
        return cell;
    });
}

/// The head says the per cent.
void say_in_percent(Column& column) {
    const Unit percent = Unit::of("%");
    column.rule.percent = false;
    column.unit = percent;
    column.cell = Cells([cells = column.cell, percent](std::size_t row) -> Cell {
        const Cell cell = cells(row);
        const auto* number = std::get_if<Measured>(&cell);
        return number ? Measured(number->si, Measured::Scale::interval, percent) : cell;
    });
}

/// The unit of all numbers of a column, where each has it by itself, moves into its head.
void head_with_common_unit(const Table& table, Column& column) {
    const Unit of_head = column.unit.value_or(Unit{});
    std::optional<Unit> common;
    bool is_common = true, any_other = false;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const Cell cell = column.cell(row);
        if (std::holds_alternative<std::monostate>(cell)) continue;
        const auto* quantity = std::get_if<Quantity>(&cell);
        is_common = is_common && quantity && (!common || quantity->unit == *common);
        if (is_common) common = quantity->unit;
        any_other = any_other || (quantity && !(quantity->unit == of_head));
    }
    const bool moves = is_common && common && of_head == Unit{};
    column.unit = moves ? *common : of_head;
    column.says_unit = any_other && !moves;
}

}  // namespace

Text written(const Table& table, const Column& column, std::size_t row, const TableView& view) {
    const auto subhead = table.subheads.find(row);
    if (subhead != table.subheads.end())
        return &column == &table.columns.front() ? running_text(subhead->second) : Text();
    const Cell cell = column.cell(row);
    const DocumentLanguage& in = view.language;
    if (const auto number = shown_number(cell, view.units))
        return grouped_digits(rounded_number({table, column, row, view}, cell, *number), in.numbers());
    if (const auto* unit = std::get_if<Unit>(&cell)) return view.units.of(*unit).display();
    if (const auto* symbols = std::get_if<Symbols>(&cell)) return symbols_text(short_list(*symbols));
    if (const auto* answer = std::get_if<Answer>(&cell))
        return answer->is_open ? in.say(tell<"undecided">()) : in.say_declared(answer->is ? "yes" : "no");
    if (const auto* message = std::get_if<Message>(&cell)) return running_text(in.say(*message));
    if (const auto* verdict = std::get_if<TestVerdict>(&cell)) return running_text(in.say(verdict->words));
    if (const auto* text = std::get_if<Text>(&cell)) return *text;
    const auto* words = std::get_if<std::string>(&cell);
    if (!words) return {};
    if (column.symbols) return symbols_text(*words);
    return running_text(column.own_words ? in.say_declared(*words) : *words);
}

std::optional<std::string> rounded(const Table& table, const Column& column, std::size_t row,
                                   const TableView& view) {
    const Cell cell = column.cell(row);
    const auto number = shown_number(cell, view.units);
    if (!number) return std::nullopt;
    return rounded_number({table, column, row, view}, cell, *number);
}

NumberForm form_of(const Table& table, const Column& column, const Unit& unit, const TableView& view) {
    constexpr std::size_t most_rows = 1000;  // nobody sees the whole of a longer table
    if (column.rule.form) return *column.rule.form;
    if (table.rows > most_rows || column.says_unit) return NumberForm::each;
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const auto number = shown_number(column.cell(row), view.units);
        const double size = number ? std::abs(as_headed(column.rule, number->value)) : 0.0;
        if (!(size > 0.0) || !std::isfinite(size) || !(number->unit == unit)) continue;
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    return largest > 0.0 ? form_of_column(smallest, largest) : NumberForm::each;
}

Text head_written(const Column& column, const TableView& view) {
    return head_written(column.title, column, view);
}

Text head_written(const Text& title, const Column& column, const TableView& view) {
    return column.unit ? head_with_unit(title, view.units.of(*column.unit)) : title;
}

std::optional<double> number_in(const Cell& cell, const DisplayUnits& units) {
    const auto number = shown_number(cell, units);
    return number ? std::optional(number->value) : std::nullopt;
}

std::optional<double> exact_number(const Column& column, std::size_t row, const DisplayUnits& units) {
    std::optional<double> number = number_in(column.cell(row), units);
    if (number) *number = as_headed(column.rule, *number);
    return number;
}

bool has_only_numbers(const Table& table, const Column& column) {
    bool any = false;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const Cell cell = column.cell(row);
        if (std::holds_alternative<std::monostate>(cell)) continue;
        const bool is_number =
            std::holds_alternative<Measured>(cell) || std::holds_alternative<Quantity>(cell);
        // An estimate may have a unit of its own, as words.
        if (!is_number && column.rule.role != NumberRole::estimate) return false;
        any = true;
    }
    return any;
}

std::string short_list(const std::vector<std::string>& items, std::size_t most) {
    std::string out;
    const bool whole = items.size() <= most;
    const std::size_t shown = whole ? items.size() : most - 1;
    for (std::size_t i = 0; i < shown; ++i) out += (i ? ", " : "") + items[i];
    return whole ? out : out + " … " + items.back() + " (" + std::to_string(items.size()) + ")";
}

Table evaluation_table(Table table, const DocumentLanguage& in) {
    table.title = in.say_declared(table.title);
    for (Message& note : table.notes) note = in.say(note);
    for (Column& column : table.columns) {
        if (column.hidden) continue;
        const std::string& head = column.head.empty() ? column.key : column.head;
        if (column.title.empty())
            column.title = column.is_symbol ? symbols_text(head) : running_text(in.say_declared(head));
        if (column.rule.percent) say_in_percent(column);
        column.cell = without_rounding(table, column);
        head_with_common_unit(table, column);
    }
    for (Column& column : table.columns)
        if (const auto decimals = decimals_of_all(table, column)) column.fixed(*decimals);
    return table;
}

}  // namespace covaria
