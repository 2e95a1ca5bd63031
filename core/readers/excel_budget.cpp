// Uncertainty budgets in Excel workbooks: the columns of EA-4/02, as a linear measurement equation.
#include <algorithm>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/readers/budget_cells.h"
#include "core/readers/budget_columns.h"
#include "core/readers/budget_figures.h"
#include "core/readers/budget_place.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/linear_budget.h"
#include "core/readers/sheet_result.h"
#include "core/readers/stated_budget.h"
#include "core/readers/unstated_units.h"
#include "core/readers/workbook.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr int most_shown_columns = 40;
constexpr double no_constant = 1e-13;

/// Says which meaning is read from which column, and which columns are left out.
void say_columns(const SheetBudget& place, Proposals& proposals) {
    std::string words;
    for (std::size_t i = 0; i < place.heads.size(); ++i) {
        const BudgetHead& head = place.heads[i];
        if (head.column == BudgetColumn::unread && head.word.empty()) continue;
        if (head.column == BudgetColumn::unread) {
            proposals.leave_out(place.head_row,
                                tell<"column %1%2">(column_letters(place.columns[i]),
                                                    (head.word == "-" ? "" : " " + in_quotes(head.word))));
            continue;
        }
        for (const BudgetColumnWord& word : budget_column_words())
            if (word.column == head.column)
                words += (words.empty() ? "" : ", ") + column_letters(place.columns[i]) + " " + word.title +
                         (head.unit ? " [" + head.unit->display() + "]" : "");
    }
    proposals.found.push_back(tell<"sheet %1, columns: %2">(in_quotes(place.sheet->name), words));
}

class BudgetReader {
public:
    BudgetReader(SheetBudget place, const ReadChoice& choice) : cells_(std::move(place)), choice_(choice) {
        proposals_.title = without_ending(choice.file_name);
    }

    Result<Proposals> read() {
        if (auto checked = check_budget_columns(place().heads); !checked) return fail(checked.error());
        if (auto whole = check_no_column_is_dropped(cells_); !whole) return fail(whole.error());
        say_columns(place(), proposals_);
        for (const auto& [row, cells] : place().sheet->rows) {
            if (row <= place().head_row) continue;
            if (choice_.rows_left_out.contains(row)) {
                proposals_.leave_out(row, tell<"row %1 was left out">(row));
                continue;
            }
            if (ended_) {
                own_.take_sums(row);
                last_below_ = row;
                if (first_below_ == 0) first_below_ = row;
                continue;
            }
            if (auto done = read_row(row); !done) return fail(done.error());
        }
        if (first_below_ > 0)
            proposals_.leave_out(first_below_, tell<"what stands below the budget, to row %1">(last_below_));
        if (budget_.quantities.empty())
            return place().sheet->refused(std::max(place().head_row, 1), place().columns.front(),
                                          tell<"there is no quantity with an uncertainty below">());
        return propose();
    }

private:
    using Column = BudgetColumn;

    const SheetBudget& place() const { return cells_.place(); }

    Result<void> read_row(int row) {
        const std::string symbol = cells_.text(row, Column::quantity), name = cells_.text(row, Column::name);
        const std::string label = symbol.empty() ? name : symbol;
        const bool uncertain = cells_.is_uncertain(row), described = cells_.is_described(row);
        const bool valued = cells_.cell(row, Column::value) != nullptr, first = budget_.quantities.empty();
        const bool contributes = cells_.has_figure(row, Column::contribution);
        if (!first && is_row_of_sums(name.empty() ? label : name)) return end_with(row, false);
        if (!first && !described && (is_sum_label(label) || is_sum_label(name))) return end_with(row, false);
        if (!first && !described && (contributes || uncertain) && valued && !label.empty() &&
            (contributes || cells_.column(Column::contribution) == 0) &&
            (cells_.column(Column::distribution) > 0 || cells_.column(Column::divisor) > 0 ||
             cells_.column(Column::c) > 0))
            return end_with(row, true);
        if (label.empty() && !uncertain && !valued) {
            if (!first) ended_ = true;
            proposals_.leave_out(row, tell<"row without a quantity">());
            return {};
        }
        if (!uncertain && !valued) {
            proposals_.leave_out(row, own_.take_sums(row) ? tell<"row %1: computed anew">(in_quotes(label))
                                                          : tell<"row %1 without figures">(in_quotes(label)));
            return {};
        }
        if (label.empty() && first)
            return cells_.refused(row, Column::name, tell<"the quantity has no name">());
        return add(row, symbol, name, uncertain, valued);
    }

    /// Ends the budget with the row of the result, or of sums.
    Result<void> end_with(int row, bool result) {
        ended_ = true;
        if (!result) {
            const std::string name = cells_.text(row, Column::name);
            const std::string words = name.empty() ? cells_.text(row, Column::quantity) : name;
            own_.take_sums(row);
            proposals_.leave_out(row, tell<"row %1: computed anew">(in_quotes(words)));
            return {};
        }
        result_name_ = cells_.text(row, Column::name);
        result_symbol_ = cells_.text(row, Column::quantity);
        const auto value = cells_.figure(row, Column::value);
        if (!value) return fail(value.error());
        const std::string label = result_symbol_.empty() ? result_name_ : result_symbol_;
        const auto unit = unit_of_row(row, *value, label);
        if (!unit) return fail(unit.error());
        result_unit_ = *unit;
        if (*value) result_value_ = unit->interval_to_si((*value)->value);
        own_.take_result(row, *unit, *value);
        return {};
    }

    /// The unit of a row: in its own column, behind the value, or in the head; else the unit one.
    Result<Unit> unit_of_row(int row, const std::optional<CellFigure>& value, const std::string& label) {
        const std::string words = cells_.text(row, Column::unit);
        if (!words.empty() && words != "-") {
            const auto unit = Unit::parse(words);
            if (!unit) return cells_.refused(row, Column::unit, unit.error().message);
            return *unit;
        }
        if (value && value->unit) return *value->unit;
        for (const Column wanted : {Column::value, Column::standard, Column::expanded, Column::limits})
            if (const auto unit = cells_.unit_in_head(wanted)) return *unit;
        if (label.empty() || words == "-") return Unit();
        return unstated_unit(choice_, label, cells_.text(row, Column::name), Unit(), proposals_);
    }

    /// The unit of a value that a sensitivity coefficient multiplies, which is a difference or a reading: a
    /// value of t in degC is no product of kelvin that starts at 0 K (SI Brochure 2.3.1).
    Unit as_difference(int row, const std::string& label, const Unit& unit) {
        if (!unit.has_offset()) return unit;
        proposals_.found.push_back(
            tell<"row %1: %2 in %3 beside a sensitivity coefficient is taken as a difference or reading, in "
                 "%4">(row, in_quotes(label), unit.display(), unit.interval().display()));
        return unit.interval();
    }

    Result<void> add(int row, const std::string& symbol, const std::string& name, bool uncertain,
                     bool valued) {
        if (budget_.quantities.size() == most_stated_quantities)
            return cells_.refused(row, Column::name,
                                  tell<"more than %1 quantities are not read">(most_stated_quantities));
        const auto value = cells_.figure(row, Column::value);
        if (!value) return fail(value.error());
        const std::string label = symbol.empty() ? name : symbol;
        const bool further =
            !valued && !budget_.quantities.empty() && (label.empty() || label == last_label_);
        const auto stated = unit_of_row(row, *value, further ? std::string() : label);
        if (!stated) return fail(stated.error());
        const Unit unit = as_difference(row, further ? last_label_ : label, *stated);
        if (!further) {
            const auto c = coefficient_of(cells_, row);
            if (!c) return fail(c.error());
            model_.add(*c);
            NotedQuantity quantity{names_.take(label), name.empty() ? label : name, 0.0, unit, {}};
            if (*value) quantity.value = (*value)->value;
            budget_.quantities.push_back(std::move(quantity));
            last_label_ = label;
        }
        NotedQuantity& quantity = budget_.quantities.back();
        if (!uncertain) return {};
        auto component =
            component_of(cells_, row, further && !(unit == Unit()) ? unit : quantity.unit, proposals_);
        if (!component) return fail(component.error());
        component->name = name.empty() ? quantity.name : name;
        component->source = cells_.text(row, Column::source);
        const auto share = cells_.figure(row, Column::contribution);
        if (!share) return fail(share.error());
        if (*share)
            model_.add(StatedShare{row, budget_.quantities.size() - 1, (*share)->value, (*share)->unit,
                                   standard_uncertainty_of(*component)});
        quantity.components.push_back(std::move(*component));
        ++components_;
        return {};
    }

    /// The unit of the result: as stated in its row or above the contributions, else that of the quantities
    /// if they all have one.
    Result<Unit> unit_of_result() {
        if (result_unit_) return *result_unit_;
        if (const auto unit = cells_.unit_in_head(Column::contribution)) return *unit;
        if (const auto stated = choice_.units.find("result"); stated != choice_.units.end())
            return unstated_unit(choice_, "result", "the result", stated->second, proposals_);
        const Unit& first = budget_.quantities.front().unit;
        for (const NotedQuantity& q : budget_.quantities)
            if (q.unit.dimension() != first.dimension())
                return cells_.refused(
                    std::max(place().head_row, 1), Column::unit,
                    tell<"the unit of the result is not stated: give the result a row of its own, put the "
                         "unit behind the head of the contributions, or state it as that of 'result'">());
        return unstated_unit(choice_, "result", "the result", first.interval(), proposals_);
    }

    /// Adds the difference of the stated result from the sum of c x, as a quantity of its own.
    void add_what_is_missing(std::string& sum, double linear, double largest, const Unit& unit) {
        const double missing = result_value_ ? *result_value_ - linear : 0.0;
        if (std::abs(missing) <= no_constant * std::max(largest, std::abs(result_value_.value_or(0.0))))
            return;
        const std::string constant = names_.take("y_0");
        sum = constant + (sum.starts_with("-") ? " " : " + ") + sum;
        const double value = unit.interval_from_si(missing);
        budget_.quantities.push_back(
            {constant, "what the model adds to the sum", value, unit.interval(), {}});
        proposals_.found.push_back(tell<"the result is not the sum of c x: %1 = %2 is the difference">(
            constant, quantity_words(value, unit.interval())));
    }

    Result<Proposals> propose() {
        const auto unit = unit_of_result();
        if (!unit) return fail(unit.error());
        const std::string y = names_.take(result_symbol_.empty() ? "y" : result_symbol_);
        std::string sum;
        double linear = 0.0, largest = 0.0;
        for (std::size_t i = 0; i < budget_.quantities.size(); ++i) {
            const NotedQuantity& q = budget_.quantities[i];
            const auto term = model_.term_of(i, q, *unit, sum.empty(), proposals_);
            if (!term) return fail(term.error());
            sum += term->first;
            const double share = term->second * q.unit.to_si(q.value);
            linear += share;
            largest = std::max(largest, std::abs(share));
        }
        add_what_is_missing(sum, linear, largest, *unit);
        if (unit->has_offset()) sum = "0 [" + unit->text() + (sum.starts_with("-") ? "] " : "] + ") + sum;
        budget_.equations = y + " = " + sum;
        proposals_.found.push_back(tell<"model: %1; the sheet has sensitivity coefficients only, write your "
                                        "equation instead where you have it">(budget_.equations));
        budget_.results.push_back({y, result_name_.empty() ? y : result_name_, *unit});
        budget_.name = proposals_.title.empty() ? place().sheet->name : proposals_.title;
        budget_.id = id_of(budget_.name, "budget");
        budget_.notes = "Sheet " + in_quotes(place().sheet->name) +
                        ". Linear model from the sensitivity coefficients of the sheet.";
        proposals_.found.push_back(tell<"%1 quantities">(budget_.quantities.size()));
        proposals_.analyses.push_back(analysis_of(budget_));
        add_outcome(y, *unit);
        return std::move(proposals_);
    }

    void add_outcome(const std::string& y, const Unit& unit) {
        StatedOutcome outcome = own_.outcome(unit);
        outcome.analysis = budget_.id;
        outcome.symbol = y;
        if (const auto u = model_.combined_shares(unit, components_); u && !outcome.u && !outcome.expanded) {
            outcome.u = unit.interval_from_si(*u);
            outcome.from_contributions = true;
        }
        proposals_.outcomes.push_back(std::move(outcome));
    }

    BudgetCells cells_;
    const ReadChoice& choice_;
    Proposals proposals_;
    StatedBudget budget_;
    SymbolNames names_;
    LinearModel model_{cells_};
    SheetResult own_{cells_};
    std::size_t components_ = 0;
    std::string last_label_, result_name_, result_symbol_;
    std::optional<Unit> result_unit_;
    std::optional<double> result_value_;
    bool ended_ = false;
    int first_below_ = 0, last_below_ = 0;  ///< rows behind the budget
};

Recognition recognise_workbook(std::string_view beginning, const std::string& file_name) {
    const bool zip = beginning.starts_with("PK\x03\x04");
    return zip && (file_name.ends_with(".xlsx") || file_name.ends_with(".XLSX") ||
                   file_name.ends_with(".xlsm") ||
                   beginning.find("[Content_Types].xml") != std::string_view::npos)
               ? Recognition::certain
               : Recognition::no;
}

/// The sheet that is meant: named, else the first with a budget, else the first.
std::size_t meant_sheet(const std::vector<WorkbookSheet>& sheets, const ReadChoice& choice) {
    std::size_t with_budget = sheets.size();
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (sheets[i].name == choice.sheet) return i;
        if (with_budget == sheets.size() && budget_in(sheets[i])) with_budget = i;
    }
    return with_budget < sheets.size() ? with_budget : 0;
}

/// Changes cells to the texts that people say they are to be read as.
Result<void> mend_cells(std::vector<WorkbookSheet>& sheets, const ReadChoice& choice) {
    WorkbookSheet& sheet = sheets[meant_sheet(sheets, choice)];
    for (const int row : choice.rows_left_out)
        if (!sheet.rows.contains(row))
            return fail(ErrorCode::usage,
                        tell<"the sheet %1 has no row %2 to leave out">(in_quotes(sheet.name), row));
    for (const auto& [reference, text] : choice.cells) {
        const auto at = place_of_cell(reference);
        if (!at)
            return fail(ErrorCode::usage,
                        tell<"%1 is no place of a cell; D3 is one">(in_quotes(plain_name(reference))));
        sheet.set_cell(at->row, at->column, text);
    }
    return {};
}

Result<Proposals> read_budget(const std::string& text, const ReadChoice& choice) {
    auto sheets = read_workbook(text);
    if (!sheets) return fail(sheets.error());
    if (auto mended = mend_cells(*sheets, choice); !mended) return fail(mended.error());
    auto place = budget_place(*sheets, choice);
    if (!place) return fail(place.error());
    const WorkbookSheet* sheet = place->sheet;
    auto proposals = BudgetReader(std::move(*place), choice).read();
    if (!proposals) return proposals;
    for (const WorkbookSheet& other : *sheets)
        if (&other != sheet) proposals->leave_out(0, tell<"sheet %1">(in_quotes(other.name)));
    return proposals;
}

/// The table of all rows from the headers on, as they stand; where no headers are known, from the first row.
Result<SourceTable> table_of_budget(const std::string& text, const ReadChoice& choice) {
    const auto sheets = read_workbook(text);
    if (!sheets) return fail(sheets.error());
    const WorkbookSheet& shown = (*sheets)[meant_sheet(*sheets, choice)];
    SourceTable table{.sheet = shown.name, .unknown = as_headed};
    for (const WorkbookSheet& sheet : *sheets) table.sheets.push_back(sheet.name);
    const auto place = budget_in(shown);
    const int first = shown.first_column();
    int last = 0;
    for (const auto& [row, cells] : shown.rows) last = std::max(last, cells.rbegin()->first);
    last = std::min(last, first + most_shown_columns - 1);
    for (int column = first; column <= last; ++column) table.letters.push_back(column_letters(column));
    table.columns.resize(table.letters.size());
    for (std::size_t i = 0; place && i < place->columns.size(); ++i)
        for (const BudgetColumnWord& word : budget_column_words())
            if (const int at = place->columns[i] - first; word.column == place->heads[i].column &&
                                                          place->columns[i] <= last &&
                                                          place->heads[i].understood)
                table.columns[static_cast<std::size_t>(at)] = word.key;
    for (const auto& [row, cells] : shown.rows) {
        if (place && row < place->head_row) continue;
        table.row_numbers.push_back(row);
        std::vector<std::string>& texts = table.rows.emplace_back(table.columns.size());
        for (const auto& [column, cell] : cells)
            if (column <= last)
                texts[static_cast<std::size_t>(column - first)] =
                    cell.failure.empty() ? cell.text : "(" + cell.failure + ")";
    }
    for (const BudgetColumnWord& word : budget_column_words()) table.words.push_back({word.key, word.title});
    return table;
}

}  // namespace

Reader excel_budget_reader() {
    return {.name = "xlsx",
            .title = "Uncertainty budget in Excel",
            .pattern = "*.xlsx *.xlsm",
            .takes =
                "quantities with value, U or limits, divisor or distribution, k, nu, c (EA-4/02) -> linear "
                "measurement equation",
            .recognise = recognise_workbook,
            .read = read_budget,
            .table = table_of_budget,
            .mends_cells = true};
}

}  // namespace covaria
