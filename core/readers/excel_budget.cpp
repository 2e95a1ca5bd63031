// Uncertainty budgets in Excel workbooks: the columns of EA-4/02, as a linear measurement equation.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/readers/budget_columns.h"
#include "core/readers/budget_figures.h"
#include "core/readers/budget_place.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/stated_budget.h"
#include "core/readers/unstated_units.h"
#include "core/readers/workbook.h"
#include "core/readers/xml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr int most_shown_columns = 40;
constexpr double no_constant = 1e-13;

/// A figure with the unit that stands behind it in its cell.
struct CellFigure {
    double value = 0.0;
    std::optional<Unit> unit = {};
};

/// A sensitivity coefficient as the sheet states it.
struct Coefficient {
    int row = 0;
    double value = 1.0;
    std::optional<Unit> unit = {};
};
struct StatedShare {
    int row = 0;
    double contribution = 0.0;
};

/// What is read from which column, and which columns are left out.
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

/// The cells of a budget, by row and column of the budget.
class BudgetCells {
public:
    using Column = BudgetColumn;

    explicit BudgetCells(SheetBudget place) : place_(std::move(place)) {}

    const SheetBudget& place() const { return place_; }

    /// Of the sheet, 0 where there is none.
    int column(Column wanted) const {
        for (std::size_t i = 0; i < place_.heads.size(); ++i)
            if (place_.heads[i].column == wanted) return place_.columns[i];
        return 0;
    }
    std::optional<Unit> unit_in_head(Column wanted) const {
        for (const BudgetHead& head : place_.heads)
            if (head.column == wanted) return head.unit;
        return std::nullopt;
    }
    const WorkbookCell* cell(int row, Column wanted) const {
        const int at = column(wanted);
        return at > 0 ? place_.sheet->cell(row, at) : nullptr;
    }
    std::string text(int row, Column wanted) const {
        const WorkbookCell* found = cell(row, wanted);
        return found ? found->text : std::string();
    }
    tl::unexpected<Error> refused(int row, Column wanted, const Message& message) const {
        return place_.sheet->refused(row, std::max(column(wanted), 1), message);
    }

    /// A number, or a number with a unit behind it; empty where the cell is.
    Result<std::optional<CellFigure>> figure(int row, Column wanted) const {
        const WorkbookCell* found = cell(row, wanted);
        if (!found) return std::optional<CellFigure>();
        if (!found->failure.empty()) return refused(row, wanted, found->failure);
        if (found->number) return std::optional(CellFigure{*found->number, unit_in_head(wanted)});
        const std::string& words = found->text;
        if (words == "-" || words == "–" || words == "—") return std::optional<CellFigure>();
        std::size_t end = words.find_first_not_of("0123456789.+-eE±");
        std::string digits = words.substr(0, end);
        if (digits.starts_with("±")) digits = digits.substr(std::string("±").size());
        const auto number = number_in_text(digits);
        const auto unit =
            end == std::string::npos ? Result<Unit>(Unit()) : Unit::parse(plain_name(words.substr(end)));
        if (!number || !unit) return refused(row, wanted, tell<"%1 is no number">(in_quotes(words)));
        return std::optional(CellFigure{*number, *unit});
    }

    Result<std::optional<double>> plain_figure(int row, Column wanted) const {
        const auto read = figure(row, wanted);
        if (!read) return fail(read.error());
        return *read ? std::optional((*read)->value) : std::nullopt;
    }

    bool is_uncertain(int row) const {
        return cell(row, Column::standard) || cell(row, Column::expanded) || cell(row, Column::limits);
    }
    bool is_described(int row) const {
        return !text(row, Column::distribution).empty() || !text(row, Column::divisor).empty() ||
               !text(row, Column::c).empty();
    }
    bool has_figure(int row, Column wanted) const {
        const WorkbookCell* found = cell(row, wanted);
        return found && (found->number || !found->failure.empty());
    }

private:
    SheetBudget place_;
};

Result<NotedComponent> component_of(const BudgetCells& cells, int row, const Unit& unit,
                                    Proposals& proposals) {
    using Column = BudgetColumn;
    BudgetFigures figures{.distribution = cells.text(row, Column::distribution)};
    std::optional<Unit> own;
    Column main = Column::standard;
    for (const auto& [wanted, into] :
         {std::pair(Column::standard, &figures.standard), std::pair(Column::expanded, &figures.expanded),
          std::pair(Column::limits, &figures.limits)}) {
        const auto read = cells.figure(row, wanted);
        if (!read) return fail(read.error());
        if (!*read) continue;
        *into = (*read)->value;
        main = wanted;
        if ((*read)->unit && own && !(*(*read)->unit == *own))
            return cells.refused(row, wanted,
                                 tell<"its unit differs from that of the other uncertainty of the row">());
        if ((*read)->unit && !(*(*read)->unit == Unit())) own = (*read)->unit;
    }
    if (const WorkbookCell* divisor = cells.cell(row, Column::divisor); divisor && !divisor->text.empty()) {
        figures.divisor = divisor->number ? divisor->number : divisor_in_text(divisor->text);
        if (!figures.divisor)
            return cells.refused(row, Column::divisor, tell<"%1 is no divisor">(in_quotes(divisor->text)));
    }
    if (const std::string nu = cells.text(row, Column::nu);
        !nu.empty() && nu != "∞" && nu != "inf" && nu != "Inf" && nu != "infinity" && nu != "infinite") {
        const auto read = cells.plain_figure(row, Column::nu);
        if (!read) return fail(read.error());
        if (*read && !(**read > 0.0))
            return cells.refused(row, Column::nu, tell<"degrees of freedom must be greater than 0">());
        if (*read && **read < 1e6) figures.nu = *read;
    }
    std::string how;
    auto component = stated_component_of(figures, how);
    if (!component) return cells.refused(row, main, component.error().message);
    if (!how.empty()) proposals.found.push_back(tell<"row %1: %2">(row, how));
    component->unit = own ? *own : unit;
    return component;
}

/// Value and, where it is stated, unit of a sensitivity coefficient.
Result<Coefficient> coefficient_of(const BudgetCells& cells, int row) {
    const auto read = cells.figure(row, BudgetColumn::c);
    if (!read) return fail(read.error());
    return *read ? Coefficient{row, (*read)->value, (*read)->unit} : Coefficient{row, 1.0, std::nullopt};
}

/// Units that a coefficient may be in where the sheet does not say: one between units of a dimension, the
/// unit of the contributions or of the result per unit of the quantity.
std::vector<Unit> units_of_coefficient(const Unit& x, const Unit& y, const Unit& contribution) {
    std::vector<Unit> units;
    const auto add_unit = [&](const Unit& unit) {
        if (std::none_of(units.begin(), units.end(), [&](const Unit& u) {
                return u.dimension() == unit.dimension() && u.interval_to_si(1.0) == unit.interval_to_si(1.0);
            }))
            units.push_back(unit);
    };
    if (x.dimension() == y.dimension()) add_unit(Unit());
    for (const Unit& of : {contribution, y})
        if (const auto quotient = Unit::parse("(" + of.interval().text() + ")/(" + x.text() + ")"))
            add_unit(*quotient);
    return units;
}

/// The sensitivity coefficients of the sheet, one for each quantity, and the contributions stated with them.
class LinearModel {
public:
    explicit LinearModel(const BudgetCells& cells) : cells_(cells) {}

    void add(const Coefficient& c) { coefficients_.push_back(c); }
    void add(const StatedShare& share) { shares_.push_back(share); }

    /// " + 11.5 [nm/K]*x", and the coefficient in SI.
    Result<std::pair<std::string, double>> term_of(std::size_t index, const NotedQuantity& q, const Unit& y,
                                                   bool first, Proposals& proposals) const {
        const auto unit = unit_of_coefficient(coefficients_[index], q, y, proposals);
        if (!unit) return fail(unit.error());
        const double c = coefficients_[index].value;
        std::string sign = c < 0.0 ? "-" : "+";
        sign = first ? (c < 0.0 ? "-" : "") : " " + sign + " ";
        std::string factor = shortest_number(std::abs(c));
        const bool one = unit->dimension().is_one() && unit->interval_to_si(1.0) == 1.0;
        if (!one) factor += " [" + unit->text() + "]";
        factor = one && std::abs(c) == 1.0 ? std::string() : factor + "*";
        return std::pair(sign + factor + q.symbol, unit->interval_to_si(c));
    }

private:
    /// The contributions that the sheet states decide between them.
    Result<Unit> unit_of_coefficient(const Coefficient& c, const NotedQuantity& q, const Unit& y,
                                     Proposals& proposals) const {
        if (c.unit) return *c.unit;
        const Unit of = cells_.unit_in_head(BudgetColumn::contribution).value_or(y);
        const std::vector<Unit> units = units_of_coefficient(q.unit.interval(), y, of);
        for (const StatedShare& share : shares_) {
            const double u =
                standard_uncertainty_of(q.components.empty() ? NotedComponent{} : q.components[0]);
            if (share.row != c.row || !(u > 0.0) || c.value == 0.0) continue;
            for (const Unit& unit : units) {
                const double ratio = std::abs(unit.interval_to_si(c.value)) * u /
                                     of.interval_to_si(std::abs(share.contribution));
                if (!(ratio > 0.5 && ratio < 2.0)) continue;
                if (std::abs(ratio - 1.0) > 0.02)
                    proposals.leave_out(c.row, tell<"the contribution %1: c and u give %2">(
                                                   shortest_number(share.contribution),
                                                   readable_number(ratio * std::abs(share.contribution))));
                return unit;
            }
            return cells_.refused(c.row, BudgetColumn::contribution,
                                  tell<"the contribution does not follow from c and u in any unit; state the "
                                       "unit behind the coefficient ('-575 nm/K')">());
        }
        if (units.empty())
            return cells_.refused(c.row, BudgetColumn::unit,
                                  tell<"its unit makes no coefficient of the result">());
        if (units.size() > 1 && !(units.front() == Unit()))
            return cells_.refused(c.row, BudgetColumn::c,
                                  tell<"its unit may be %1 or %2: state it behind the coefficient">(
                                      units[0].text(), units[1].text()));
        return units.front();
    }

    const BudgetCells& cells_;
    std::vector<Coefficient> coefficients_;
    std::vector<StatedShare> shares_;
};

class BudgetReader {
public:
    BudgetReader(SheetBudget place, const ReadChoice& choice) : cells_(std::move(place)), choice_(choice) {
        proposals_.title = without_ending(choice.file_name);
    }

    Result<Proposals> read() {
        if (auto checked = check_budget_columns(place().heads); !checked) return fail(checked.error());
        say_columns(place(), proposals_);
        for (const auto& [row, cells] : place().sheet->rows) {
            if (row <= place().head_row) continue;
            if (ended_) {
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
            proposals_.leave_out(row, tell<"row %1 without figures">(in_quotes(label)));
            return {};
        }
        if (label.empty() && first)
            return cells_.refused(row, Column::name, tell<"the quantity has no name">());
        return add(row, symbol, name, uncertain, valued);
    }

    /// The row of the result, or of sums, ends the budget.
    Result<void> end_with(int row, bool result) {
        ended_ = true;
        if (!result) {
            const std::string name = cells_.text(row, Column::name);
            const std::string words = name.empty() ? cells_.text(row, Column::quantity) : name;
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
        if (*value) result_value_ = unit->to_si((*value)->value);
        return {};
    }

    /// In its own column, behind the value, or in the head; one where nothing says it.
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
        const auto unit = unit_of_row(row, *value, further ? std::string() : label);
        if (!unit) return fail(unit.error());
        if (!further) {
            const auto c = coefficient_of(cells_, row);
            if (!c) return fail(c.error());
            model_.add(*c);
            NotedQuantity quantity{names_.take(label), name.empty() ? label : name, 0.0, *unit, {}};
            if (*value) quantity.value = (*value)->value;
            budget_.quantities.push_back(std::move(quantity));
            last_label_ = label;
        }
        NotedQuantity& quantity = budget_.quantities.back();
        if (!uncertain) return {};
        auto component =
            component_of(cells_, row, further && !(*unit == Unit()) ? *unit : quantity.unit, proposals_);
        if (!component) return fail(component.error());
        component->name = name.empty() ? quantity.name : name;
        component->source = cells_.text(row, Column::source);
        const auto share = cells_.plain_figure(row, Column::contribution);
        if (!share) return fail(share.error());
        if (*share && **share != 0.0) model_.add(StatedShare{row, **share});
        quantity.components.push_back(std::move(*component));
        return {};
    }

    /// Of the result: as stated in its row or above the contributions, else that of the quantities if they
    /// all have one.
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
        const double missing = result_value_ ? *result_value_ - linear : 0.0;
        if (std::abs(missing) > no_constant * std::max(largest, std::abs(result_value_.value_or(0.0)))) {
            const std::string constant = names_.take("y_0");
            sum = constant + (sum.starts_with("-") ? " " : " + ") + sum;
            budget_.quantities.push_back(
                {constant, "what the model adds to the sum", unit->from_si(missing), *unit, {}});
            proposals_.found.push_back(
                tell<"the result is not the sum of c x: %1 is the difference">(constant));
        }
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
        return std::move(proposals_);
    }

    BudgetCells cells_;
    const ReadChoice& choice_;
    Proposals proposals_;
    StatedBudget budget_;
    SymbolNames names_;
    LinearModel model_{cells_};
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

Result<Proposals> read_budget(const std::string& text, const ReadChoice& choice) {
    const auto sheets = read_workbook(text);
    if (!sheets) return fail(sheets.error());
    auto place = budget_place(*sheets, choice);
    if (!place) return fail(place.error());
    const WorkbookSheet* sheet = place->sheet;
    auto proposals = BudgetReader(std::move(*place), choice).read();
    if (!proposals) return proposals;
    for (const WorkbookSheet& other : *sheets)
        if (&other != sheet) proposals->leave_out(0, tell<"sheet %1">(in_quotes(other.name)));
    return proposals;
}

/// The rows from the headers on, as they stand; where no headers are known, from the first row.
Result<SourceTable> table_of_budget(const std::string& text, const ReadChoice& choice) {
    const auto sheets = read_workbook(text);
    if (!sheets) return fail(sheets.error());
    const WorkbookSheet* shown = nullptr;
    SourceTable table;
    for (const WorkbookSheet& sheet : *sheets) {
        table.sheets.push_back(sheet.name);
        if (sheet.name == choice.sheet || (choice.sheet.empty() && !shown && budget_in(sheet)))
            shown = &sheet;
    }
    if (!shown) shown = &sheets->front();
    table.sheet = shown->name;
    const auto place = budget_in(*shown);
    int first = 0, last = 0;
    for (const auto& [row, cells] : shown->rows) {
        first = first == 0 ? cells.begin()->first : std::min(first, cells.begin()->first);
        last = std::max(last, cells.rbegin()->first);
    }
    last = std::min(last, first + most_shown_columns - 1);
    const int columns = last - first + 1;
    table.columns.resize(static_cast<std::size_t>(columns));
    for (std::size_t i = 0; place && i < place->columns.size(); ++i)
        for (const BudgetColumnWord& word : budget_column_words())
            if (const int at = place->columns[i] - first;
                word.column == place->heads[i].column && place->columns[i] <= last)
                table.columns[static_cast<std::size_t>(at)] = word.key;
    for (const auto& [row, cells] : shown->rows) {
        if ((place && row < place->head_row) || table.rows.size() == SourceTable::most_rows) continue;
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
            .table = table_of_budget};
}

}  // namespace covaria
