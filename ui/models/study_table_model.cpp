#include "ui/models/study_table_model.h"

#include <cmath>

#include "core/result/representation.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

const char* const position_help = QT_TR_NOOP(
    "Standard uncertainty of the position in space: square root of the sum of the variances of its three "
    "coordinates");
const char* const expanded_help = QT_TR_NOOP("Expanded uncertainty");

}  // namespace

void StudyTableModel::set_study(std::shared_ptr<const StudyResult> study, bool current) {
    study_ = std::move(study);
    if (!study_) return set_contents({}, {}, {}, current);
    const StudyResult& shown = *study_;
    set_digits(0);
    const DocumentLanguage language = language_of_window();
    Table table{"study-" + shown.id, shown.name, shown.points.size()};
    for (const StudyAxisValues& axis : shown.axes) {
        const auto value = [&shown, &axis,
                            i = std::size_t(&axis - shown.axes.data())](std::size_t row) -> Cell {
            const double typed = axis.values[shown.indices_of(row)[i]];
            return Measured{axis.unit.to_si(typed), Measured::Scale::value, axis.unit, {}};
        };
        table.add(axis.title.message().english(), value)
            .window(axis.title.in(language))
            .round({.typed = true})
            .in(axis.unit);
    }
    for (const StudyQuantity& quantity : study_quantities(shown, language)) {
        const auto value = [&shown, quantity](std::size_t row) -> Cell {
            const double si = value_at(shown, quantity, row);
            return std::isfinite(si) ? Cell(Measured{si, Measured::Scale::interval, quantity.unit, {}})
                                     : Cell();
        };
        table.add(quantity.id, value)
            .window(quantity.title, to_std(quantity.position ? ui::tr(position_help) : ui::tr(expanded_help)))
            .digits(3)
            .in(quantity.unit);
    }
    if (shown.failed() > 0 || !not_representing(shown).empty())
        table.add("remark", [&shown](std::size_t row) -> Cell { return remark_on(shown, row); })
            .window(to_std(tr("Remark")), to_std(tr("Why there are no values, or what is wrong with them")));
    std::vector<std::string> keys;
    for (const Column& column : table.columns) keys.push_back(column.key);
    set_contents(study_, std::move(table), std::move(keys), current);
}

QVariant StudyTableModel::extra(std::size_t row, std::size_t, int role) const {
    const Message remark = role == Qt::ToolTipRole && study_ ? remark_on(*study_, row) : Message();
    return remark.empty() ? QVariant() : to_qt(remark);
}

}  // namespace covaria::ui
