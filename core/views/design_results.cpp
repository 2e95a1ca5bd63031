#include "core/views/design_results.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/name.h"
#include "core/text/cell.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

std::string name_of(const OutputQuantity& output) {
    return output.group.empty() ? output.symbol : output.group + ": " + output.symbol;
}

Cell said_name_of(const OutputQuantity& output) {
    if (output.group.empty()) return output.symbol;
    return tell<"%1: %2">(said_name(output.group), output.symbol);
}

Message yes_or_no(bool yes) {
    return yes ? tell<"yes">() : tell<"no">();
}

Cell interval_cell(const std::optional<double>& si, const Unit& unit) {
    if (!si) return {};
    return Quantity{unit.interval_from_si(*si), unit};
}

Cell number_cell(const std::optional<double>& number) {
    return number ? Cell(*number) : Cell();
}

/// The cost of a unit less of the target.
std::optional<double> price_in(const Unit& unit, const DesignGoal& goal) {
    if (!goal.price_of_target) return {};
    return *goal.price_of_target * unit.interval_to_si(1.0);
}

Table table_of(const std::string& id, const std::string& title, const std::vector<std::string>& heads) {
    Table table{id, title};
    for (const std::string& head : heads) table.add(head).figure(4);
    return table;
}

Table outputs_table(const DesignResult& result) {
    Table table{"outputs", "Uncertainties"};
    table.add("output");
    table.add("unit").hide();                                   // each number has its own unit
    table.add("target").print("target uncertainty").figure(4);  // the other targets are points
    for (const char* head : {"U before", "U", "U by Monte Carlo"}) table.add(head).figure(4);
    table.add("validated (clause 8)");
    table.add("met");
    const bool priced = result.cost.has_value();
    if (priced) table.add("cost per unit of target").figure(4);
    for (const DesignGoal& goal : result.goals) {
        const Unit& unit = goal.output.unit;
        std::vector<Cell> row{said_name_of(goal.output), unit.text(), interval_cell(goal.target, unit),
                              interval_cell(goal.before, unit)};
        row.push_back(result.found ? interval_cell(goal.after, unit) : Cell());
        row.push_back(interval_cell(goal.monte_carlo, unit));
        row.push_back(!goal.validated ? Cell()
                      : goal.is_close ? Cell(tell<"undecided">())
                                      : Cell(yes_or_no(*goal.validated)));
        row.push_back(goal.target && result.found ? Cell(yes_or_no(goal.met())) : Cell());
        if (priced) row.push_back(number_cell(price_in(unit, goal)));
        table.row(std::move(row));
    }
    return table;
}

Message at_end_words(const DesignValue& value) {
    return tell<"%1: chosen at an end of its range; a wider one can give a better design.">(
        value.title.message());
}

Table values_table(const DesignResult& result) {
    Table table =
        table_of("values", "Values", {"variable", "unit", "from", "to", "before", "chosen", "tolerance"});
    const bool priced = result.cost.has_value();
    if (priced) table.add("cost").figure(4);
    for (const DesignValue& value : result.values) {
        table.row({value.title.message(), value.unit.text(), value.from, value.to, value.before, value.chosen,
                   value.tolerance, number_cell(value.cost)});
        if (value.is_at_end()) table.notes.push_back(at_end_words(value));
    }
    return table;
}

Table rows_table(const DesignResult& result) {
    Table table = table_of("rows", "Rows that are kept",
                           {"row", "name", "fixed", "of the candidates' file", "objective without it"});
    table.columns.front().hide();  // the name stands beside it
    if (result.cost) table.add("price").figure(4);
    for (const DesignRow& row : result.rows)
        table.row({static_cast<double>(row.row), row.name, Answer{row.fixed}, Answer{row.added},
                   number_cell(row.without), number_cell(row.price)});
    return table;
}

Table gains_table(const DesignResult& result) {
    Table table = table_of("gains", "Candidates and what they gain", {"row", "name", "chosen"});
    table.columns.front().hide();  // the name stands beside it
    table.add("gain").in(Unit::of("%")).figure(4);
    for (const char* axis : {"x", "y", "z"}) table.add(axis).in(Unit::of("mm")).symbol().figure(4);
    for (const DesignGain& gain : result.gains) {
        std::vector<Cell> row{static_cast<double>(gain.row), gain.name, Answer{gain.kept},
                              number_cell(gain.gain)};
        for (Eigen::Index axis = 0; gain.place && axis < 3; ++axis) row.push_back((*gain.place)[axis]);
        table.row(std::move(row));
    }
    return table;
}

Table sources_table(const DesignResult& result) {
    Table table{"sources", "What would be gained without the uncertainty of"};
    table.add("origin");
    table.add("gain").in(Unit::of("%")).figure(4);
    for (const DesignSource& source : result.sources) table.row({source.origin, source.gain});
    return table;
}

Table curve_table(const DesignResult& result) {
    Table table{"curve", "Objective and number of rows"};
    table.add("rows");
    table.add("objective").figure(4);
    table.add("change").percent(1);
    for (std::size_t i = 0; i < result.curve.size(); ++i) {
        const DesignCount& count = result.curve[i];
        const bool next = i > 0 && result.curve[i - 1].rows + 1 == count.rows;
        table.row({static_cast<double>(count.rows), count.objective,
                   next ? Cell(count.objective / result.curve[i - 1].objective - 1.0) : Cell()});
    }
    return table;
}

Table front_table(const DesignResult& result) {
    Table table = table_of("front", "Cost and uncertainty", {"largest U/target", "cost"});
    for (const DesignCost& cost : result.front) table.row({cost.largest_ratio, cost.cost});
    return table;
}

Table path_table(const DesignResult& result) {
    Table table = table_of("path", "Improvements", {"evaluation", "search", "objective"});
    for (const DesignStep& step : result.path)
        table.row({static_cast<double>(step.evaluation), step.search, step.objective});
    return table;
}

Table reasons_table(const DesignResult& result) {
    Table table{"reasons", "Candidates without result"};
    table.add("count");
    table.add("reason");
    for (const DesignReason& reason : result.reasons)
        table.row({static_cast<double>(reason.count), reason.reason});
    return table;
}

/// Whether a column says something: it is neither empty throughout, nor "no", nor zero, nor the unit one.
bool says_something(const Table& table, const Column& column) {
    for (std::size_t row = 0; row < table.rows; ++row) {
        const Cell cell = column.cell(row);
        const auto* text = std::get_if<std::string>(&cell);
        const auto* answer = std::get_if<Answer>(&cell);
        const auto* number = std::get_if<Measured>(&cell);
        if (text     ? !text->empty() && *text != "1"
            : answer ? answer->is
            : number ? number->si != 0.0
                     : !std::holds_alternative<std::monostate>(cell))
            return true;
    }
    return false;
}

/// Writes cells as people read them, with columns flush.
void write_table(std::ostringstream& out, const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    const auto width = [](const std::string& text) {  // width of a text in UTF-8
        return static_cast<std::size_t>(
            std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    };
    for (const auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (c == widths.size()) widths.push_back(0);
            widths[c] = std::max(widths[c], width(row[c]));
        }
    for (const auto& row : rows) {
        std::string line = " ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string gap(widths[c] - width(row[c]), ' ');
            line += " " + (c == 0 ? row[c] + gap : gap + row[c]) + (c + 1 < row.size() ? " " : "");
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << '\n';
    }
}

std::string percent(double part) {
    return (part > 0 ? "+" : "") + format_significant(100.0 * part, 3) + " %";
}

void write_outputs(std::ostringstream& out, const DesignResult& result) {
    std::vector<std::vector<std::string>> rows{
        {"", "before", "designed", "change", "target", "Monte Carlo", ""}};
    for (const DesignGoal& goal : result.goals) {
        const Unit& unit = goal.output.unit;
        const auto text = [&](const std::optional<double>& si) {
            return si ? format_significant(unit.interval_from_si(*si), 4) + " " + unit.text()
                      : std::string("-");
        };
        std::string verdict = !goal.target ? "" : goal.met() ? "met" : "NOT MET";
        if (goal.validated && !*goal.validated)
            verdict += std::string(verdict.empty() ? "" : "; ") + "first order is not validated (clause 8)";
        rows.push_back({"U(" + name_of(goal.output) + ")", text(goal.before), text(goal.after),
                        goal.before ? percent(goal.after / *goal.before - 1.0) : "", text(goal.target),
                        text(goal.monte_carlo), verdict});
    }
    write_table(out, rows);
}

void write_values(std::ostringstream& out, const DesignResult& result) {
    if (result.values.empty()) return;
    out << "\nValues\n";
    std::vector<std::vector<std::string>> rows{{"", "before", "chosen", "", "allowed"}};
    if (result.cost) rows.front().push_back("cost");
    for (const DesignValue& value : result.values) {
        rows.push_back({value.title.message().english(), format_significant(value.before, 6),
                        format_significant(value.chosen, 6), value.unit == Unit{} ? "" : value.unit.text(),
                        format_short(value.from, 6) + " to " + format_short(value.to, 6)});
        if (value.cost) rows.back().push_back(format_significant(*value.cost, 4));
    }
    write_table(out, rows);
    for (const DesignValue& value : result.values)
        if (value.is_at_end()) out << "  " << at_end_words(value).english() << '\n';
}

void write_cost(std::ostringstream& out, const DesignResult& result) {
    if (!result.cost) return;
    out << "\nThe cheapest " << (result.rows.empty() ? "reductions" : "rows") << " cost "
        << format_significant(*result.cost, 6) << '\n';
    for (const DesignGoal& goal : result.goals)
        if (const auto price = price_in(goal.output.unit, goal))
            out << "  the target of U(" << name_of(goal.output) << ") costs " << format_significant(*price, 4)
                << " for every " << (goal.output.unit == Unit{} ? "unit" : goal.output.unit.text())
                << " less\n";
    if (result.front.empty()) return;
    out << (result.rows.empty() ? "\nCost with other targets, all by the same factor\n"
                                : "\nLargest U/target and cost: the best that was tried\n");
    std::vector<std::vector<std::string>> rows;
    for (const DesignCost& cost : result.front)
        rows.push_back({format_significant(cost.largest_ratio, 4), format_significant(cost.cost, 4)});
    write_table(out, rows);
}

void write_rows(std::ostringstream& out, const DesignResult& result) {
    if (result.rows.empty()) return;
    out << "\nRows kept: " << result.rows.size() << " of " << result.candidates
        << (result.proved ? " (all choices were evaluated: this is the best)" : "") << '\n';
    std::vector<std::vector<std::string>> rows{
        {"", "row", "objective without it", "", result.cost ? "price" : ""}};
    for (const DesignRow& row : result.rows)
        rows.push_back({row.name.english(), std::to_string(row.row),
                        row.without ? format_significant(*row.without, 4) + " (" +
                                          percent(*row.without / result.objective - 1.0) + ")"
                                    : "no result",
                        row.fixed ? "fixed" : "", row.price ? format_significant(*row.price, 4) : ""});
    write_table(out, rows);
}

void write_sources(std::ostringstream& out, const DesignResult& result) {
    constexpr std::size_t most = 8;
    if (result.sources.empty()) return;
    out << "\nThe objective would be smaller without the uncertainty of\n";
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < std::min(most, result.sources.size()); ++i)
        rows.push_back({result.sources[i].origin.english(), percent(-result.sources[i].gain)});
    write_table(out, rows);
}

void write_curve(std::ostringstream& out, const DesignResult& result) {
    if (result.curve.empty()) return;
    out << "\nBest objective found with so many rows\n";
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < result.curve.size(); ++i) {
        const DesignCount& count = result.curve[i];
        const bool next = i > 0 && result.curve[i - 1].rows + 1 == count.rows;
        rows.push_back({std::to_string(count.rows), format_significant(count.objective, 4),
                        next ? percent(count.objective / result.curve[i - 1].objective - 1.0) : "",
                        count.rows == result.rows.size() ? "chosen" : ""});
    }
    write_table(out, rows);
}

void write_end(std::ostringstream& out, const DesignResult& result) {
    out << '\n' << result.evaluations << " evaluations";
    std::uint64_t without = 0;
    for (const DesignReason& reason : result.reasons) without += reason.count;
    if (without > 0) out << ", " << without << " of them without result:";
    out << '\n';
    for (const DesignReason& reason : result.reasons)
        out << "  " << reason.count << "  " << reason.reason << '\n';
    if (result.trials > 0)
        out << "verified with " << result.trials << " trials, " << result.failed_trials
            << " without a value\n";
    else if (result.found)
        out << "not verified by Monte Carlo: " << result.not_verified << '\n';
    for (const DesignGoal& goal : result.goals)
        if (result.found && !goal.met())
            out << "the target of U(" << name_of(goal.output)
                << ") is not met: the best design found reaches "
                << format_significant(goal.output.unit.interval_from_si(goal.after), 4) << ' '
                << goal.output.unit.text() << '\n';
}

}  // namespace

std::vector<Table> design_tables(const DesignResult& result) {
    std::vector<Table> tables{outputs_table(result)};
    for (Table table : {values_table(result), rows_table(result), gains_table(result), sources_table(result),
                        curve_table(result), front_table(result), path_table(result), reasons_table(result)})
        if (table.rows > 0) tables.push_back(std::move(table));
    return tables;
}

std::vector<Table> readable_design_tables(const DesignResult& result) {
    constexpr std::size_t most_readable = 30;
    std::vector<Table> tables;
    for (Table& table : design_tables(result)) {
        if (table.id == "path") continue;
        if (table.id == "front" && table.rows > most_readable) continue;  // the chart shows it
        std::erase_if(table.columns,
                      [&](const Column& column) { return column.hidden || !says_something(table, column); });
        tables.push_back(std::move(table));
    }
    return tables;
}

std::string design_text(const DesignResult& result) {
    std::ostringstream out;
    out << result.name << " (" << result.analysis << "/" << result.id << ")\n";
    out << result.objective_words << ": ";
    if (result.found) {
        out << format_significant(result.objective, 6);
        if (result.before) out << ", before " << format_significant(*result.before, 6);
    } else {
        out << "no candidate has a result";
    }
    out << '\n';
    if (!result.why_not_before.empty())
        out << "the present design is not allowed: " << result.why_not_before << '\n';
    if (result.found) {
        out << '\n';
        write_outputs(out, result);
        write_values(out, result);
        write_cost(out, result);
        write_rows(out, result);
        write_sources(out, result);
        write_curve(out, result);
    }
    write_end(out, result);
    return out.str();
}

}  // namespace covaria
