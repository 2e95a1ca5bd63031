#include "core/readers/sheet_result.h"

#include <algorithm>
#include <set>

#include "core/readers/budget_words.h"
#include "core/readers/xml_text.h"

namespace covaria {

namespace {

enum class SumRow { none, combined, expanded, factor };

bool has_any(const std::vector<std::string>& words, const char* of) {
    const std::vector<std::string> known = folded_words(of);
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return std::find(known.begin(), known.end(), word) != known.end();
    });
}

constexpr const char* combined_words = "combined kombinierte composée combinée combinada composta";

SumRow sum_row_of(const std::string& label) {
    const std::vector<std::string> words = folded_words(label);
    if (has_any(words, "expanded erweiterte élargie expandida estesa") || label == "U" || label == "U(y)")
        return SumRow::expanded;
    const bool standard = budget_head_of(label).column == BudgetColumn::standard;
    if (has_any(words, combined_words) || standard || label == "uc" || label == "u_c" || label == "u(y)" ||
        label == "u_c(y)")
        return SumRow::combined;
    if (budget_head_of(label).column == BudgetColumn::divisor) return SumRow::factor;
    return SumRow::none;
}

}  // namespace

bool is_row_of_sums(const std::string& label) {
    std::string rest = label;
    static_cast<void>(coverage_factor_in(rest));
    const std::vector<std::string> words = folded_words(rest);
    if (words.size() < 2) return false;
    std::string others;
    bool combined = false;
    for (std::size_t begin = 0; begin < rest.size();) {
        const std::size_t end = std::min(rest.find(' ', begin), rest.size());
        const std::string word = rest.substr(begin, end - begin);
        const bool sums = has_any(folded_words(word), combined_words);
        combined = combined || sums;
        others += sums ? std::string() : word + ' ';
        begin = end + 1;
    }
    const auto meaning = meaning_of_head(others);
    return meaning && (meaning->column == BudgetColumn::expanded
                           ? combined || !meaning->weak
                           : combined && meaning->column == BudgetColumn::standard);
}

/// The figure in the column of contributions or uncertainties, else the only number of the row.
std::optional<CellFigure> SheetResult::figure_of_sums(int row) const {
    const auto row_unit = Unit::parse(cells_.text(row, BudgetColumn::unit));
    const auto with_unit = [&](CellFigure figure, const std::optional<Unit>& head) {
        if (!figure.unit && !cells_.text(row, BudgetColumn::unit).empty() && row_unit)
            figure.unit = *row_unit;
        if (!figure.unit) figure.unit = head;
        return figure;
    };
    const auto read = [](const WorkbookCell& cell) {
        return cell.number ? std::optional(CellFigure{*cell.number}) : figure_in_text(cell.text);
    };
    for (const BudgetColumn column : {BudgetColumn::contribution, BudgetColumn::standard,
                                      BudgetColumn::expanded, BudgetColumn::limits, BudgetColumn::value})
        if (const WorkbookCell* cell = cells_.cell(row, column))
            if (const auto figure = read(*cell)) return with_unit(*figure, cells_.unit_in_head(column));
    std::optional<CellFigure> only;
    for (const auto& [column, cell] : cells_.place().sheet->rows.at(row)) {
        const auto figure = read(cell);
        if (figure && only) return std::nullopt;
        if (figure) only = figure;
    }
    return only ? std::optional(with_unit(*only, std::nullopt)) : std::nullopt;
}

bool SheetResult::take_sums(int row) {
    SumRow sums = SumRow::none;
    for (const auto& [column, cell] : cells_.place().sheet->rows.at(row)) {
        if (cell.number) continue;
        std::string words = cell.text;
        const auto k = coverage_factor_in(words);
        if (k) k_ = k;
        if (const SumRow of_cell = sum_row_of(words); sums == SumRow::none) sums = of_cell;
    }
    if (sums == SumRow::none) return false;
    const auto figure = figure_of_sums(row);
    if (!figure) return false;
    if (sums == SumRow::factor) k_ = figure->value;
    if (sums == SumRow::combined) u_ = figure;
    if (sums == SumRow::expanded) expanded_ = figure;
    if (const WorkbookCell* divisor = cells_.cell(row, BudgetColumn::divisor);
        divisor && divisor->number && sums == SumRow::expanded)
        k_ = divisor->number;
    return true;
}

void SheetResult::take_result(int row, const Unit& unit, const std::optional<CellFigure>& value) {
    if (value) value_ = value->value;
    for (const BudgetColumn column : {BudgetColumn::contribution, BudgetColumn::standard}) {
        const auto figure = cells_.figure(row, column);
        if (!figure || !*figure) continue;
        u_ = **figure;
        if (!u_->unit) u_->unit = unit.interval();
        return;
    }
}

StatedOutcome SheetResult::outcome(const Unit& unit) const {
    const auto in_unit = [&](const std::optional<CellFigure>& figure) -> std::optional<double> {
        if (!figure) return std::nullopt;
        const Unit own = figure->unit ? figure->unit->interval() : unit.interval();
        if (own.dimension() != unit.interval().dimension()) return std::nullopt;
        return unit.interval_from_si(own.interval_to_si(figure->value));
    };
    return {.value = value_, .u = in_unit(u_), .expanded = in_unit(expanded_), .k = k_, .unit = unit};
}

}  // namespace covaria
