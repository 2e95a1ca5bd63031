#include "ui/models/study_table_model.h"

#include <algorithm>

#include "core/result/representation.h"
#include "core/views/study_view.h"
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
    const DocumentLanguage language = language_of_window();
    Table table = study_view(*study_, language);
    for (const StudyQuantity& quantity : study_quantities(*study_, language)) {
        const auto column = std::ranges::find(table.columns, quantity.id, &Column::key);
        column->tip(to_std(quantity.position ? ui::tr(position_help) : ui::tr(expanded_help)));
    }
    if (table.find("remark"))
        table.columns.back().window(to_std(tr("Remark")),
                                    to_std(tr("Why there are no values, or what is wrong with them")));
    std::vector<std::string> keys;
    for (const Column& column : table.columns) keys.push_back(column.key);
    set_contents(study_, std::move(table), std::move(keys), current);
}

QVariant StudyTableModel::extra(std::size_t row, std::size_t, int role) const {
    const Message remark = role == Qt::ToolTipRole && study_ ? remark_on(*study_, row) : Message();
    return remark.empty() ? QVariant() : to_qt(remark);
}

}  // namespace covaria::ui
