#include "core/views/design_results.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "core/base/name.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

std::string name_of(const OutputQuantity& output) {
    return output.group.empty() ? output.symbol : output.group + ": " + output.symbol;
}

TableCell said_name_of(const OutputQuantity& output) {
    if (output.group.empty()) return output.symbol;
    return tell<"%1: %2">(said_name(output.group), output.symbol);
}

const char* const undecided = "undecided";

const char* yes_or_no(bool yes) {
    return yes ? "yes" : "no";
}

TableCell interval_cell(const std::optional<double>& si, const Unit& unit) {
    if (!si) return {};
    return Quantity{unit.interval_from_si(*si), unit};
}

TableCell number_cell(const std::optional<double>& number) {
    return number ? TableCell(*number) : TableCell();
}

/// Cost of a unit less of the target.
std::optional<double> price_in(const Unit& unit, const DesignGoal& goal) {
    if (!goal.price_of_target) return {};
    return *goal.price_of_target * unit.interval_to_si(1.0);
}

DataTable table_of(const std::string& id, const std::string& title, const std::vector<std::string>& heads) {
    DataTable table;
    table.id = id;
    table.title = title;
    for (const std::string& head : heads) table.columns.push_back({head, {}, false, 0});
    return table;
}

DataTable outputs_table(const DesignResult& result) {
    DataTable table = table_of(
        "outputs", "Uncertainties",
        {"output", "unit", "target", "U before", "U", "U by Monte Carlo", "validated (clause 8)", "met"});
    const bool priced = result.cost.has_value();
    if (priced) table.columns.push_back({"cost per unit of target", {}, false, 0});
    for (const DesignGoal& goal : result.goals) {
        const Unit& unit = goal.output.unit;
        std::vector<TableCell> row{said_name_of(goal.output), unit.text(), interval_cell(goal.target, unit),
                                   interval_cell(goal.before, unit)};
        row.push_back(result.found ? interval_cell(goal.after, unit) : TableCell());
        row.push_back(interval_cell(goal.monte_carlo, unit));
        row.push_back(goal.validated
                          ? TableCell(std::string(goal.is_close ? undecided : yes_or_no(*goal.validated)))
                          : TableCell());
        row.push_back(goal.target && result.found ? TableCell(std::string(yes_or_no(goal.met())))
                                                  : TableCell());
        if (priced) row.push_back(number_cell(price_in(unit, goal)));
        table.rows.push_back(std::move(row));
    }
    return table;
}

Message at_end_words(const DesignValue& value) {
    return tell<"%1: chosen at an end of its range; a wider one can give a better design.">(
        value.title.message());
}

DataTable values_table(const DesignResult& result) {
    DataTable table =
        table_of("values", "Values", {"variable", "unit", "from", "to", "before", "chosen", "tolerance"});
    const bool priced = result.cost.has_value();
    if (priced) table.columns.push_back({"cost", {}, false, 0});
    for (const DesignValue& value : result.values) {
        table.rows.push_back({value.title.message(), value.unit.text(), value.from, value.to, value.before,
                              value.chosen, value.tolerance});
        if (priced) table.rows.back().push_back(number_cell(value.cost));
        if (value.is_at_end()) table.notes.push_back(at_end_words(value));
    }
    return table;
}

DataTable rows_table(const DesignResult& result) {
    DataTable table = table_of("rows", "Rows that are kept",
                               {"row", "name", "fixed", "of the candidates' file", "objective without it"});
    if (result.cost) table.columns.push_back({"price", {}, false, 0});
    for (const DesignRow& row : result.rows) {
        table.rows.push_back({static_cast<double>(row.row), row.name, std::string(yes_or_no(row.fixed)),
                              std::string(yes_or_no(row.added)), number_cell(row.without)});
        if (result.cost) table.rows.back().push_back(number_cell(row.price));
    }
    return table;
}

DataTable gains_table(const DesignResult& result) {
    DataTable table = table_of("gains", "Candidates and what they gain", {"row", "name", "chosen", "gain"});
    table.columns.back().unit = Unit::of("%");
    for (const char* axis : {"x", "y", "z"}) table.columns.push_back({axis, Unit::of("mm"), true});
    for (const DesignGain& gain : result.gains) {
        table.rows.push_back({static_cast<double>(gain.row), gain.name, std::string(yes_or_no(gain.kept)),
                              number_cell(gain.gain)});
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            table.rows.back().push_back(gain.place ? TableCell((*gain.place)[axis]) : TableCell());
    }
    return table;
}

DataTable sources_table(const DesignResult& result) {
    DataTable table =
        table_of("sources", "What would be gained without the uncertainty of", {"origin", "gain"});
    table.columns.back().unit = Unit::of("%");
    for (const DesignSource& source : result.sources) table.rows.push_back({source.origin, source.gain});
    return table;
}

DataTable curve_table(const DesignResult& result) {
    DataTable table = table_of("curve", "Objective and number of rows", {"rows", "objective", "change"});
    for (std::size_t i = 0; i < result.curve.size(); ++i) {
        const DesignCount& count = result.curve[i];
        const bool next = i > 0 && result.curve[i - 1].rows + 1 == count.rows;
        table.rows.push_back(
            {static_cast<double>(count.rows), count.objective,
             next ? TableCell(count.objective / result.curve[i - 1].objective - 1.0) : TableCell()});
    }
    return table;
}

DataTable front_table(const DesignResult& result) {
    DataTable table = table_of("front", "Cost and uncertainty", {"largest U/target", "cost"});
    for (const DesignCost& cost : result.front) table.rows.push_back({cost.largest_ratio, cost.cost});
    return table;
}

DataTable path_table(const DesignResult& result) {
    DataTable table = table_of("path", "Improvements", {"evaluation", "search", "objective"});
    for (const DesignStep& step : result.path)
        table.rows.push_back({static_cast<double>(step.evaluation), step.search, step.objective});
    return table;
}

DataTable reasons_table(const DesignResult& result) {
    DataTable table = table_of("reasons", "Candidates without result", {"count", "reason"});
    for (const DesignReason& reason : result.reasons)
        table.rows.push_back({static_cast<double>(reason.count), reason.reason});
    return table;
}

/// Neither empty throughout, nor "no", nor zero; nor what the cells beside it say: unit, number of a row.
bool says_something(const DataTable& table, std::size_t column) {
    if (table.id == "outputs" && table.columns[column].header == "unit") return false;
    if (table.columns[column].header == "row") return false;  // its name stands beside it
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<TableCell>& row) {
        const TableCell& cell = row[column];
        if (const auto* text = std::get_if<std::string>(&cell))
            return (*text != "no" || table.id == "outputs") && !text->empty() && *text != "1";
        if (const auto* number = std::get_if<double>(&cell)) return *number != 0.0;
        return std::holds_alternative<Quantity>(cell) || std::holds_alternative<Message>(cell);
    });
}

/// A column of nothing but "yes" and "no" is in the program's words.
void say_yes_and_no(DataTable& table, std::size_t column) {
    const auto is_answer = [](const TableCell& cell) {
        const auto* text = std::get_if<std::string>(&cell);
        return std::holds_alternative<std::monostate>(cell) ||
               (text && (*text == "yes" || *text == "no" || *text == undecided));
    };
    if (!std::ranges::all_of(table.rows, [&](const auto& row) { return is_answer(row[column]); })) return;
    for (std::vector<TableCell>& row : table.rows)
        if (const auto* text = std::get_if<std::string>(&row[column]))
            row[column] = *text == "yes"       ? tell<"yes">()
                          : *text == undecided ? tell<"undecided">()
                                               : tell<"no">();
}

/// Cells as people read them, columns flush.
void write_table(std::ostringstream& out, const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    const auto width = [](const std::string& text) {  // of UTF-8
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

std::vector<DataTable> design_tables(const DesignResult& result) {
    std::vector<DataTable> tables{outputs_table(result)};
    for (DataTable table :
         {values_table(result), rows_table(result), gains_table(result), sources_table(result),
          curve_table(result), front_table(result), path_table(result), reasons_table(result)})
        if (!table.rows.empty()) tables.push_back(std::move(table));
    return tables;
}

std::vector<DataTable> readable_design_tables(const DesignResult& result) {
    constexpr std::size_t most_readable = 30;
    static const std::set<std::string> counts{"rows", "count"};
    std::vector<DataTable> tables;
    for (const DataTable& table : design_tables(result)) {
        if (table.id == "path") continue;
        if (table.id == "front" && table.rows.size() > most_readable) continue;  // the chart shows it
        DataTable readable{
            table.id, table.title, {}, std::vector<std::vector<TableCell>>(table.rows.size()), table.notes};
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            if (!says_something(table, c)) continue;
            readable.columns.push_back(table.columns[c]);
            // The other targets are points.
            if (table.columns[c].header == "target") readable.columns.back().header = "target uncertainty";
            if (!counts.contains(table.columns[c].header)) readable.columns.back().digits = 4;
            if (table.columns[c].header == "change") {  // a part of one in files
                readable.columns.back().unit = Unit::of("%");
                readable.columns.back().decimals = 1;
            }
            for (std::size_t r = 0; r < table.rows.size(); ++r) readable.rows[r].push_back(table.rows[r][c]);
        }
        for (std::size_t c = 0; c < readable.columns.size(); ++c) say_yes_and_no(readable, c);
        tables.push_back(std::move(readable));
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
