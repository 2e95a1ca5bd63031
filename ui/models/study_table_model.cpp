#include "ui/models/study_table_model.h"

#include <cmath>

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "core/result/representation.h"
#include "ui/document/quantity_text.h"
#include "ui/models/number_words.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void StudyTableModel::set_study(std::shared_ptr<const StudyResult> study, bool current) {
    study_ = std::move(study);
    std::vector<Column> columns;
    if (!study_) return set_contents({}, 0, current);
    const StudyResult& shown = *study_;
    for (std::size_t axis = 0; axis < shown.axes.size(); ++axis) {
        const auto value = [this, axis](std::size_t row) {
            return study_->axes[axis].values[study_->indices_of(row)[axis]];
        };
        columns.push_back({with_unit(to_qt(shown.axes[axis].title), shown.axes[axis].unit),
                           {},
                           [value](std::size_t row) { return localized(format_significant(value(row), 6)); },
                           value});
    }
    for (const StudyQuantity& quantity : study_quantities(shown)) {
        const auto value = [this, quantity](std::size_t row) {
            return quantity.unit.interval_from_si(value_at(*study_, quantity, row));
        };
        const auto text = [value](std::size_t row) {
            return std::isfinite(value(row)) ? localized(format_significant(value(row), 3)) : QString();
        };
        const QString help = quantity.position
                                 ? tr("Standard uncertainty of the position in space: square root of the sum "
                                      "of the variances of its three coordinates")
                                 : tr("Expanded uncertainty");
        columns.push_back({with_unit(to_qt(quantity.title), quantity.unit), help, text, value});
    }
    if (shown.failed() > 0 || !not_representing(shown).empty())
        columns.push_back({tr("Remark"), tr("Why there are no values, or what is wrong with them"),
                           [this](std::size_t row) { return to_qt(remark_on(*study_, row)); }});
    set_contents(std::move(columns), shown.points.size(), current);
}

QVariant StudyTableModel::extra(std::size_t row, std::size_t, int role) const {
    const std::string remark = role == Qt::ToolTipRole && study_ ? remark_on(*study_, row) : std::string();
    return remark.empty() ? QVariant() : to_qt(remark);
}

}  // namespace covaria::ui
