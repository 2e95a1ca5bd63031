#include "core/readers/budget_cells.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/base/in_quotes.h"
#include "core/readers/budget_figures.h"
#include "core/readers/entry_texts.h"
#include "core/readers/xml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using Column = BudgetColumn;

bool holds_figure(const WorkbookCell& cell) {
    return cell.number || !cell.failure.empty() || figure_in_text(cell.text) || divisor_in_text(cell.text);
}

/// Rows with a value or an uncertainty, down to the first row of sums.
std::vector<int> rows_with_figures(const BudgetCells& cells) {
    std::vector<int> rows;
    for (const auto& [row, ignored] : cells.place().sheet->rows) {
        if (row <= cells.place().head_row) continue;
        if (is_sum_label(cells.text(row, Column::quantity)) || is_sum_label(cells.text(row, Column::name)))
            break;
        if (cells.is_uncertain(row) || cells.cell(row, Column::value)) rows.push_back(row);
    }
    return rows;
}

/// The columns as people would type them: "quantity,value [mm],?,u".
std::string typed_columns(const SheetBudget& place, int last) {
    std::string words;
    for (int column = place.sheet->first_column(); column <= last; ++column) {
        std::string key = as_headed;
        for (std::size_t i = 0; i < place.columns.size(); ++i)
            if (place.columns[i] == column && place.heads[i].understood)
                for (const BudgetColumnWord& word : budget_column_words())
                    if (word.column == place.heads[i].column) key = word.key;
        words += (words.empty() ? "" : ",") + key;
    }
    return words;
}

}  // namespace

std::optional<CellFigure> figure_in_text(const std::string& words) {
    std::string_view rest = words;
    if (rest.starts_with("±")) rest.remove_prefix(std::string_view("±").size());
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    std::size_t end = rest.find_first_not_of("0123456789.+-");
    // The e of an exponent has digits behind it: "1e-5", but "1 eV".
    if (end != std::string_view::npos && end > 0 && (rest[end] == 'e' || rest[end] == 'E') &&
        end + 1 < rest.size() &&
        std::string_view("0123456789+-").find(rest[end + 1]) != std::string_view::npos)
        end = rest.find_first_not_of("0123456789+-", end + 1);
    const auto number = number_in_text(std::string(rest.substr(0, end)));
    if (!number) return std::nullopt;
    if (end == std::string_view::npos) return CellFigure{*number};
    const auto unit = Unit::parse(plain_name(std::string(rest.substr(end))));
    if (!unit) return std::nullopt;
    return CellFigure{*number, *unit};
}

int BudgetCells::column(Column wanted) const {
    for (std::size_t i = 0; i < place_.heads.size(); ++i)
        if (place_.heads[i].column == wanted) return place_.columns[i];
    return 0;
}

const BudgetHead* BudgetCells::head(Column wanted) const {
    for (const BudgetHead& head : place_.heads)
        if (head.column == wanted) return &head;
    return nullptr;
}

std::optional<Unit> BudgetCells::unit_in_head(Column wanted) const {
    const BudgetHead* found = head(wanted);
    return found ? found->unit : std::nullopt;
}

const WorkbookCell* BudgetCells::cell(int row, Column wanted) const {
    const int at = column(wanted);
    return at > 0 ? place_.sheet->cell(row, at) : nullptr;
}

std::string BudgetCells::text(int row, Column wanted) const {
    const WorkbookCell* found = cell(row, wanted);
    return found ? found->text : std::string();
}

tl::unexpected<Error> BudgetCells::refused(int row, Column wanted, const Message& message) const {
    return place_.sheet->refused(row, std::max(column(wanted), 1), message);
}

Result<std::optional<CellFigure>> BudgetCells::figure(int row, Column wanted) const {
    const WorkbookCell* found = cell(row, wanted);
    if (!found) return std::optional<CellFigure>();
    if (!found->failure.empty()) return refused(row, wanted, found->failure);
    if (found->number) return std::optional(CellFigure{*found->number, unit_in_head(wanted)});
    const std::string& words = found->text;
    if (words == "-" || words == "–" || words == "—") return std::optional<CellFigure>();
    if (auto figure = figure_in_text(words)) {
        if (!figure->unit) figure->unit = unit_in_head(wanted);
        return figure;
    }
    std::string with_point = words;
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    if (words.find('.') == std::string::npos && figure_in_text(with_point))
        return refused(row, wanted,
                       tell<"%1 is no number: write %2, with a point">(in_quotes(words), with_point));
    return refused(row, wanted, tell<"%1 is no number">(in_quotes(words)));
}

bool BudgetCells::is_uncertain(int row) const {
    return cell(row, Column::standard) || cell(row, Column::expanded) || cell(row, Column::limits);
}

bool BudgetCells::is_described(int row) const {
    return !text(row, Column::distribution).empty() || !text(row, Column::divisor).empty() ||
           !text(row, Column::c).empty();
}

bool BudgetCells::has_figure(int row, Column wanted) const {
    const WorkbookCell* found = cell(row, wanted);
    return found && (found->number || !found->failure.empty());
}

Result<NotedComponent> component_of(const BudgetCells& cells, int row, const Unit& unit,
                                    Proposals& proposals) {
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
    if (const BudgetHead* head = cells.head(Column::expanded); head && head->k && !figures.divisor)
        figures.divisor = head->k;
    if (const std::string nu = cells.text(row, Column::nu);
        !nu.empty() && nu != "∞" && nu != "inf" && nu != "Inf" && nu != "infinity" && nu != "infinite") {
        const auto read = cells.figure(row, Column::nu);
        if (!read) return fail(read.error());
        if (*read && !((*read)->value > 0.0))
            return cells.refused(row, Column::nu, tell<"degrees of freedom must be greater than 0">());
        if (*read && (*read)->value < 1e6) figures.nu = (*read)->value;
    }
    std::string how;
    auto component = stated_component_of(figures, how);
    if (!component) return cells.refused(row, main, component.error().message);
    if (!how.empty()) proposals.found.push_back(tell<"row %1: %2">(row, how));
    component->unit = own ? *own : unit;
    return component;
}

Result<void> check_no_column_is_dropped(const BudgetCells& cells) {
    const SheetBudget& place = cells.place();
    const std::vector<int> rows = rows_with_figures(cells);
    // Whether each column has a figure, and whether all in it are units.
    std::map<int, std::pair<bool, bool>> unread;
    for (const int row : rows)
        for (const auto& [column, cell] : place.sheet->rows.at(row)) {
            const auto head = std::find(place.columns.begin(), place.columns.end(), column);
            if (head != place.columns.end() &&
                place.heads[static_cast<std::size_t>(head - place.columns.begin())].understood)
                continue;
            auto& [figures, units] = unread.emplace(column, std::pair(false, true)).first->second;
            figures = figures || holds_figure(cell);
            units = units && Unit::parse(cell.text).has_value();
        }
    std::vector<std::string> keys;
    for (const BudgetColumnWord& word : budget_column_words()) keys.emplace_back(word.key);
    int last = 0;
    for (const auto& [row, in_row] : place.sheet->rows) last = std::max(last, in_row.rbegin()->first);
    for (const auto& [column, holds] : unread) {
        const WorkbookCell* head = place.sheet->cell(place.head_row, column);
        if (!holds.first && !holds.second && !head) continue;  // the column is a remark beside the budget
        return fail(Error{ErrorCode::usage,
                          tell<"column %1%2 of sheet %3 is filled but not understood: state what each column "
                               "is, %4, with one of %5 in place of ? (- leaves the column out)">(
                              column_letters(column), head ? " " + in_quotes(head->text) : std::string(),
                              in_quotes(place.sheet->name), typed_columns(place, last), listed(keys)),
                          {},
                          {},
                          std::max(place.head_row, 1)});
    }
    return {};
}

}  // namespace covaria
