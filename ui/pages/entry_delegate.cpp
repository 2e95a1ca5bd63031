#include "ui/pages/entry_delegate.h"

#include <QPainter>
#include <array>

#include "core/base/error.h"
#include "ui/models/project_tree_model.h"
#include "ui/models/roles.h"
#include "ui/theme/icons.h"

namespace covaria::ui {
namespace {

QString category_icon(int category) {
    static const std::array<QString, ProjectTreeModel::category_count> names{
        QStringLiteral("project"), QStringLiteral("artefact"), QStringLiteral("instrument"),
        QStringLiteral("robot"),   QStringLiteral("points"),   QStringLiteral("layers"),
        QStringLiteral("analysis")};
    const bool known = category >= 0 && category < ProjectTreeModel::category_count;
    return known ? names[static_cast<std::size_t>(category)] : QString();
}

QString icon_of(const QModelIndex& index) {
    if (const QVariant severity = index.data(severity_role); severity.isValid()) {
        if (index.column() != 0) return {};
        if (index.data(incomplete_role).toBool()) return QStringLiteral("state-incomplete");
        return severity.toInt() == static_cast<int>(Severity::error) ? QStringLiteral("error")
                                                                     : QStringLiteral("warning");
    }
    if (index.column() == ProjectTreeModel::name_column) {
        const QVariant category = index.data(category_role);
        return category.isValid() ? category_icon(category.toInt()) : QString();
    }
    if (index.data(incomplete_role).toBool()) return QStringLiteral("state-incomplete");
    if (!index.data(problem_role).toString().isEmpty())
        return index.data(worst_role).toInt() == static_cast<int>(Severity::error)
                   ? QStringLiteral("error")
                   : QStringLiteral("warning");
    if (!index.data(verdict_role).toString().isEmpty()) return QStringLiteral("state-not-met");
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

void EntryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
}

QSize EntryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    return QStyledItemDelegate::sizeHint(option, index);
}

void EntryDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    TypesetDelegate::initStyleOption(option, index);
    const QString name = icon_of(index);
    if (name.isEmpty()) return;
    option->icon = icon(name);
    option->features |= QStyleOptionViewItem::HasDecoration;
    const int size = option->fontMetrics.height() + 1;
    option->decorationSize = {size, size};
    const bool is_state =
        !index.data(severity_role).isValid() && index.column() == ProjectTreeModel::state_column;
    if (is_state && (option->state & QStyle::State_Selected)) option->icon = on_disc(option->icon, *option);
    // The state's words are in the tooltip and in the status bar; the name needs the room.
    if (is_state) option->text.clear();
}

}  // namespace covaria::ui
