#include "ui/models/study_table_model.h"

#include <cmath>

#include "core/result/representation.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

const char* const expanded_help = "Expanded uncertainty";
const char* const position_help =
    "Standard uncertainty of the position in space: square root of the sum of the variances of its three "
    "coordinates";

}  // namespace

void StudyTableModel::set_study(std::shared_ptr<const StudyResult> study, bool current) {
    study_ = std::move(study);
    if (!study_) return set_contents({}, {}, {}, current);
    const StudyResult& shown = *study_;
    set_digits(0);
    Table table{"study-" + shown.id, shown.name, {}, shown.points.size()};
    for (std::size_t axis = 0; axis < shown.axes.size(); ++axis)
        table.columns.push_back(
            {.key = to_unicode(shown.axes[axis].title),
             .title = shown.axes[axis].title,
             .rule = {.typed = true},
             .unit = shown.axes[axis].unit,
             .cell = [&shown, axis](std::size_t row) -> Cell {
                 const StudyAxisValues& of = shown.axes[axis];
                 const double typed = of.values[shown.indices_of(row)[axis]];
                 return Measured{of.unit.to_si(typed), Measured::Scale::value, of.unit, {}};
             }});
    for (const StudyQuantity& quantity : study_quantities(shown))
        table.columns.push_back(
            {.key = quantity.id,
             .title = quantity.title,
             .help = quantity.position ? position_help : expanded_help,
             .rule = {.digits = 3},
             .unit = quantity.unit,
             .cell = [&shown, quantity](std::size_t row) -> Cell {
                 const double si = value_at(shown, quantity, row);
                 return std::isfinite(si) ? Cell(Measured{si, Measured::Scale::interval, quantity.unit, {}})
                                          : Cell();
             }});
    if (shown.failed() > 0 || !not_representing(shown).empty())
        table.columns.push_back(
            {.key = "remark",
             .title = "Remark",
             .help = "Why there are no values, or what is wrong with them",
             .cell = [&shown](std::size_t row) -> Cell { return remark_on(shown, row); }});
    std::vector<std::string> keys;
    for (const Column& column : table.columns) keys.push_back(column.key);
    set_contents(study_, std::move(table), std::move(keys), current);
}

QVariant StudyTableModel::extra(std::size_t row, std::size_t, int role) const {
    const std::string remark = role == Qt::ToolTipRole && study_ ? remark_on(*study_, row) : std::string();
    return remark.empty() ? QVariant() : to_qt(remark);
}

}  // namespace covaria::ui
