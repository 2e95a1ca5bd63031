#include "ui/pages/entry_delegate.h"

#include <QPainter>

#include "core/base/error.h"
#include "ui/models/category_icon.h"
#include "ui/models/project_tree_model.h"
#include "ui/models/roles.h"
#include "ui/theme/fonts.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int beside_icons = 8, for_plus = 28;  // px at the left of icons, at the right of the title
// px above and below a line of text together: rows of 36, 28 and 24 px at the usual size.
constexpr int around_project = 21, around_category = 13, around_entry = 9;

/// Icon of a top-level row; between the project and the analyses stand the categories of assets.
QString row_icon(int row) {
    if (row == ProjectTreeModel::project_row) return QStringLiteral("project");
    if (row == ProjectTreeModel::analyses) return QStringLiteral("analysis");
    return category_icon(static_cast<AssetCategory>(row - ProjectTreeModel::artefacts));
}

QString icon_of(const QModelIndex& index) {
    if (const QVariant severity = index.data(severity_role); severity.isValid()) {
        if (index.column() != 0) return {};
        if (index.data(incomplete_role).toBool()) return QStringLiteral("state-incomplete");
        return severity.toInt() == static_cast<int>(Severity::error) ? QStringLiteral("error")
                                                                     : QStringLiteral("warning");
    }
    if (index.column() == ProjectTreeModel::name_column) {
        if (const QString own = index.data(icon_role).toString(); !icon(own).isNull()) return own;
        const QVariant category = index.data(category_role);
        return category.isValid() ? row_icon(category.toInt()) : QString();
    }
    if (index.data(incomplete_role).toBool()) return QStringLiteral("state-incomplete");
    if (!index.data(problem_role).toString().isEmpty())
        return index.data(worst_role).toInt() == static_cast<int>(Severity::error)
                   ? QStringLiteral("error")
                   : QStringLiteral("warning");
    if (!index.data(verdict_role).toString().isEmpty()) return QStringLiteral("state-not-met");
    if (index.data(met_role).toBool()) return QStringLiteral("state-met");
    const QVariant state = index.data(state_role);
    return state.isValid() ? state_icon(static_cast<RunState>(state.toInt())) : QString();
}

/// A state keeps its colour on the colour of the selection: it stands on a disc of the ground.
QIcon on_disc(const QIcon& of, const QStyleOptionViewItem& option) {
    const qreal ratio = option.widget ? option.widget->devicePixelRatioF() : 1.0;
    const QSize size = option.decorationSize;
    QPixmap made(size * ratio);
    made.setDevicePixelRatio(ratio);
    made.fill(Qt::transparent);
    QPainter painter(&made);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(option.palette.color(QPalette::Base));
    painter.drawEllipse(QRectF(QPointF(), QSizeF(size)));
    of.paint(&painter, QRect(QPoint(), size).marginsRemoved({1, 1, 1, 1}));
    QIcon state(made);
    state.addPixmap(made, QIcon::Selected);  // else it is blended with the selection
    return state;
}

}  // namespace

QString state_icon(RunState state) {
    switch (state) {
        case RunState::running:
            return QStringLiteral("state-running");
        case RunState::up_to_date:
            return QStringLiteral("state-up-to-date");
        case RunState::failed:
            return QStringLiteral("state-failed");
        case RunState::incomplete:
            return QStringLiteral("state-incomplete");
        case RunState::out_of_date:
            break;
    }
    return QStringLiteral("state-out-of-date");
}

/// Level of a row of the tree: project, category or entry. Rows of other lists are entries.
EntryDelegate::Level EntryDelegate::level_of(const QModelIndex& index) {
    if (index.parent().isValid() || index.data(severity_role).isValid()) return Level::entry;
    return index.data(category_role).toInt() == ProjectTreeModel::project_row ? Level::project
                                                                              : Level::category;
}

void EntryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    const bool in_tree = !index.data(severity_role).isValid();
    QStyleOptionViewItem cell(option);
    if (in_tree && index.column() == ProjectTreeModel::name_column) cell.rect.adjust(beside_icons, 0, 0, 0);
    if (in_tree && level_of(index) == Level::project) cell.rect.adjust(0, 0, -for_plus, 0);
    if (!in_tree || level_of(index) != Level::category)
        return QStyledItemDelegate::paint(painter, cell, index);
    initStyleOption(&cell, index);
    painter->save();
    painter->setFont(cell.font);
    painter->setPen(tokens_of(cell.palette).ink3);
    painter->drawText(cell.rect.adjusted(4, 0, 0, -4), Qt::AlignLeft | Qt::AlignBottom, cell.text);
    painter->restore();
}

QSize EntryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const QSize size = QStyledItemDelegate::sizeHint(option, index);
    if (index.data(severity_role).isValid()) return size;
    const int line = option.fontMetrics.height();
    const Level level = level_of(index);
    return {size.width() + beside_icons, line + (level == Level::project    ? around_project
                                                 : level == Level::category ? around_category
                                                                            : around_entry)};
}

void EntryDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    TypesetDelegate::initStyleOption(option, index);
    const Level level = level_of(index);
    if (level == Level::project) option->font.setWeight(QFont::DemiBold);
    if (level == Level::category) {
        option->font = sized(option->font, TextSize::small);
        option->font.setWeight(QFont::DemiBold);
        return;
    }
    const bool is_name = index.column() == ProjectTreeModel::name_column;
    const QString name = level == Level::project && is_name ? QString() : icon_of(index);
    if (name.isEmpty()) return;
    option->icon = icon(name);
    option->features |= QStyleOptionViewItem::HasDecoration;
    const int size = option->fontMetrics.height() + 1;
    option->decorationSize = {size, size};
    const bool is_state =
        !index.data(severity_role).isValid() && index.column() == ProjectTreeModel::state_column;
    if (is_state && (option->state & QStyle::State_Selected)) option->icon = on_disc(option->icon, *option);
    if (!is_state) return;
    // The state's words are in the tooltip and in the status bar; the name needs the room.
    const int count = index.data(count_role).toInt();
    option->text = count > 0 ? QString::number(count) : QString();
    option->font = sized(option->font, TextSize::small);
    option->decorationPosition = QStyleOptionViewItem::Right;
    option->displayAlignment = Qt::AlignRight | Qt::AlignVCenter;
}

}  // namespace covaria::ui
