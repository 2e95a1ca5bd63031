// The place of a budget: a row of headers, or the columns that are stated.
#include "core/readers/budget_place.h"

#include <algorithm>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/readers/xml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr int heads_within = 300;  // rows that heads are looked for in

std::vector<std::string> sheet_names(const std::vector<WorkbookSheet>& sheets) {
    std::vector<std::string> names;
    for (const WorkbookSheet& sheet : sheets) names.push_back(sheet.name);
    return names;
}

/// Takes units and coverage factors behind the headers where the stated columns have none; a column that is
/// stated to be as its header says is that.
void take_units_of_heads(SheetBudget& place) {
    for (std::size_t i = 0; i < place.heads.size(); ++i) {
        const WorkbookCell* cell = place.sheet->cell(place.head_row, place.columns[i]);
        if (!cell) continue;
        const BudgetHead head = budget_head_of(cell->text);
        if (!place.heads[i].understood) {
            place.heads[i] = head;
            continue;
        }
        if (!place.heads[i].unit) place.heads[i].unit = head.unit;
        place.heads[i].k = head.k;
    }
}

/// Settles words that mean something else beside others: a source where nothing else names the quantity, a
/// quantity beside its symbol.
void read_heads_together(std::vector<BudgetHead>& heads) {
    const auto count = [&](BudgetColumn column) {
        return std::count_if(heads.begin(), heads.end(),
                             [&](const BudgetHead& head) { return head.column == column; });
    };
    if (count(BudgetColumn::name) == 0 && count(BudgetColumn::quantity) == 2)
        for (BudgetHead& head : heads)
            if (head.column == BudgetColumn::quantity && head.weak && count(BudgetColumn::quantity) == 2)
                head.column = BudgetColumn::name;
    if (count(BudgetColumn::name) > 0 || count(BudgetColumn::quantity) > 0) return;
    for (BudgetHead& head : heads)
        if (head.column == BudgetColumn::source && count(BudgetColumn::name) == 0)
            head.column = BudgetColumn::name;
}

/// Stated columns stand side by side from the first column that the sheet uses.
Result<SheetBudget> stated_place(const WorkbookSheet& sheet, const ReadChoice& choice) {
    auto heads = stated_budget_columns(choice.columns);
    if (!heads) return fail(heads.error());
    const int first = sheet.first_column();
    SheetBudget place{&sheet, 0, std::move(*heads), {}};
    for (std::size_t i = 0; i < place.heads.size(); ++i) place.columns.push_back(first + static_cast<int>(i));
    // Columns that are as their headers say have these in the row that makes a budget.
    const bool by_heads = std::any_of(place.heads.begin(), place.heads.end(),
                                      [](const BudgetHead& head) { return !head.understood; });
    if (const auto found = by_heads ? budget_in(sheet) : std::nullopt) {
        place.head_row = found->head_row;
        take_units_of_heads(place);
        return place;
    }
    // Rows above the first one with a number in a column of figures are headings.
    for (const auto& [row, cells] : sheet.rows) {
        for (std::size_t i = 0; i < place.heads.size(); ++i) {
            const BudgetColumn column = place.heads[i].column;
            const WorkbookCell* cell = sheet.cell(row, place.columns[i]);
            const bool figure = column == BudgetColumn::standard || column == BudgetColumn::expanded ||
                                column == BudgetColumn::limits;
            if (!figure || !cell || !cell->number) continue;
            take_units_of_heads(place);
            return place;
        }
        place.head_row = row;
    }
    return sheet.refused(1, place.columns.front(), tell<"no row has a number in the stated columns">());
}

}  // namespace

std::optional<SheetBudget> budget_in(const WorkbookSheet& sheet) {
    for (const auto& [row, cells] : sheet.rows) {
        if (row > heads_within) break;
        SheetBudget place{&sheet, row, {}, {}};
        for (const auto& [column, cell] : cells) {
            if (cell.number) continue;
            place.heads.push_back(budget_head_of(cell.text));
            place.columns.push_back(column);
        }
        read_heads_together(place.heads);
        if (are_budget_heads(place.heads)) return place;
    }
    return std::nullopt;
}

Result<SheetBudget> budget_place(const std::vector<WorkbookSheet>& sheets, const ReadChoice& choice) {
    const WorkbookSheet* named = nullptr;
    for (const WorkbookSheet& sheet : sheets)
        if (sheet.name == choice.sheet) named = &sheet;
    if (!choice.sheet.empty() && !named)
        return fail(ErrorCode::usage, tell<"there is no sheet %1 with cells; there are %2">(
                                          in_quotes(plain_name(choice.sheet)), listed(sheet_names(sheets))));
    if (!choice.columns.empty()) {
        if (!named && sheets.size() > 1)
            return fail(ErrorCode::usage,
                        tell<"the workbook has several sheets, %1: name the sheet whose columns are stated">(
                            listed(sheet_names(sheets))));
        return stated_place(named ? *named : sheets.front(), choice);
    }
    std::vector<SheetBudget> places;
    std::vector<std::string> names;
    for (const WorkbookSheet& sheet : sheets) {
        if (named && &sheet != named) continue;
        if (auto place = budget_in(sheet)) {
            names.push_back(sheet.name);
            places.push_back(std::move(*place));
        }
    }
    if (places.size() == 1) return std::move(places.front());
    if (places.empty())
        return fail(ErrorCode::usage, tell<"no row of headers of a budget was found; state the columns "
                                           "(quantity, value, unit, U, divisor ...)">());
    return fail(ErrorCode::usage, tell<"several sheets have a budget: %1; name one of them">(listed(names)));
}

}  // namespace covaria
