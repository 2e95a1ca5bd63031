#include "ui/theme/flat_parts.h"

#include <QAbstractItemView>
#include <QHeaderView>
#include <QMainWindow>
#include <QPainter>
#include <QStyleOption>
#include <QTableView>
#include <QToolBar>
#include <QTreeView>
#include <algorithm>

#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr double radius = 4.0, focus_width = 2.0;
constexpr int mark_width = 2;  // px at the left of the selected row, below the current tab

void draw_check_box(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokens_of(option.palette);
    const bool enabled = option.state & QStyle::State_Enabled;
    const double side = std::min(option.rect.width(), option.rect.height());
    const QRectF box(option.rect.x(), option.rect.y(), side, side);
    const bool marked = option.state & (QStyle::State_HasFocus | QStyle::State_MouseOver);
    // A selected row has an outline: filled with the ground of other boxes it would look ticked.
    const bool selected = option.state & QStyle::State_Selected;
    const QColor line = enabled && marked ? t.blue : selected ? t.ink3 : t.field_line;
    draw_box(painter, box, selected ? QColor(Qt::transparent) : t.stage, line);
    const QColor ink = enabled ? t.ink : t.ink3;
    painter.setPen(QPen(ink, 0.13 * side, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [&](double x, double y) { return box.topLeft() + QPointF(x * side, y * side); };
    if (option.state & QStyle::State_On)
        painter.drawPolyline(QPolygonF{at(0.24, 0.53), at(0.42, 0.71), at(0.77, 0.3)});
    if (option.state & QStyle::State_NoChange) painter.drawLine(at(0.27, 0.5), at(0.73, 0.5));
}

void draw_button(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokens_of(option.palette);
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
    if (button && (button->features & QStyleOptionButton::Flat)) return;
    const bool enabled = option.state & QStyle::State_Enabled;
    const bool first = enabled && button && (button->features & QStyleOptionButton::DefaultButton);
    const bool pointed =
        enabled && (option.state & (QStyle::State_MouseOver | QStyle::State_Sunken | QStyle::State_On));
    // A complaint tints this role of the field's palette, so that its buttons show it, too.
    const QColor ground = option.palette.color(QPalette::Button);
    const QColor fill = first ? mix(t.blue, t.ink, pointed ? 0.15 : 0.0) : pointed ? t.hover : ground;
    draw_box(painter, option.rect, fill, first ? fill : enabled ? t.field_line : t.line2);
}

void draw_tool(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokens_of(option.palette);
    if (!(option.state & QStyle::State_Enabled)) return;
    if (option.state & QStyle::State_On) return draw_box(painter, option.rect, t.tint, t.tint);
    if (option.state & (QStyle::State_MouseOver | QStyle::State_Sunken))
        draw_box(painter, option.rect, t.hover, t.hover);
}

/// The first column that is seen of a table.
bool is_at_left(const QStyleOptionViewItem& cell, const QWidget* widget) {
    if (const auto* table = qobject_cast<const QTableView*>(widget)) {
        const QHeaderView& head = *table->horizontalHeader();
        for (int at = 0; at < head.count(); ++at)
            if (!head.isSectionHidden(head.logicalIndex(at)))
                return head.logicalIndex(at) == cell.index.column();
    }
    return cell.index.column() == 0 && !qobject_cast<const QTreeView*>(widget);
}

/// Rows are tinted where they are selected or under the mouse, and end in a thin line in tables.
void draw_cell(const QStyleOptionViewItem& cell, QPainter& painter, const QWidget* widget) {
    const Tokens& t = tokens_of(cell.palette);
    const bool selected = cell.state & QStyle::State_Selected;
    if (cell.backgroundBrush.style() != Qt::NoBrush) painter.fillRect(cell.rect, cell.backgroundBrush);
    if (selected) painter.fillRect(cell.rect, t.tint);
    if (qobject_cast<const QTableView*>(widget))
        painter.fillRect(QRect(cell.rect.left(), cell.rect.bottom(), cell.rect.width(), 1), t.line);
    if (selected && is_at_left(cell, widget))
        painter.fillRect(QRect(cell.rect.left(), cell.rect.top(), mark_width, cell.rect.height()), t.blue);
}

/// The ground of a selected row of a tree, with the branches before its first cell.
void draw_row(const QStyleOption& option, QPainter& painter, const QWidget* widget) {
    const auto* tree = qobject_cast<const QTreeView*>(widget);
    if (!tree || !(option.state & QStyle::State_Selected)) return;
    const Tokens& t = tokens_of(option.palette);
    const QRect row(0, option.rect.top(), tree->viewport()->width(), option.rect.height());
    painter.fillRect(row & QRect(option.rect.topLeft(), row.bottomRight()), t.tint);
    if (option.rect.left() <= 0) painter.fillRect(QRect(0, row.top(), mark_width, row.height()), t.blue);
}

void draw_ring(const QStyleOption& option, QPainter& painter, const QWidget* widget) {
    const bool by_keys = option.state & QStyle::State_KeyboardFocusChange;
    const bool in_view = qobject_cast<const QAbstractItemView*>(widget);
    if (!by_keys && !in_view) return;
    if (qobject_cast<const QTreeView*>(widget)) return;  // the row's tint and bar say it
    const Tokens& t = tokens_of(option.palette);
    draw_box(painter, option.rect, Qt::transparent, t.blue, focus_width);
}

void draw_tab(const QStyleOptionTab& tab, QPainter& painter) {
    const Tokens& t = tokens_of(tab.palette);
    if (!(tab.state & QStyle::State_Selected)) return;
    const bool below = tab.shape != QTabBar::RoundedSouth;
    const int y = below ? tab.rect.bottom() - mark_width + 1 : tab.rect.top();
    painter.fillRect(QRect(tab.rect.left() + 4, y, tab.rect.width() - 8, mark_width), t.blue);
}

void draw_head(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokens_of(option.palette);
    painter.fillRect(option.rect, t.stage);
    const auto* head = qstyleoption_cast<const QStyleOptionHeader*>(&option);
    const bool across = !head || head->orientation == Qt::Horizontal;
    painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1),
                     across ? t.line2 : t.line);
}

/// Ground of a bar; bars of the window have their own colour and a line below.
void draw_bar(const QStyleOption& option, QPainter& painter, const QWidget* widget) {
    const Tokens& t = tokens_of(option.palette);
    const bool of_window = widget && qobject_cast<const QMainWindow*>(widget->parentWidget());
    painter.fillRect(option.rect, of_window ? t.chrome : t.stage);
    if (!of_window || (option.state & QStyle::State_Horizontal))
        painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), t.line);
}

void draw_progress(const QStyleOption& option, QPainter& painter, bool done) {
    constexpr int height = 4;
    const Tokens& t = tokens_of(option.palette);
    const auto& bar_option = static_cast<const QStyleOptionProgressBar&>(option);
    QRect rect = option.rect;
    rect.setTop(rect.center().y() - height / 2);
    rect.setHeight(height);
    const double range = double(bar_option.maximum) - bar_option.minimum;
    if (done && range > 0.0)
        rect.setWidth(qRound(rect.width() * (double(bar_option.progress) - bar_option.minimum) / range));
    if (rect.width() > 0) draw_box(painter, rect, done ? t.blue : t.line, done ? t.blue : t.line);
}

void draw_divider(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokens_of(option.palette);
    const QRect& r = option.rect;
    if (r.width() < r.height())
        painter.fillRect(QRect(r.center().x(), r.top(), 1, r.height()), t.line);
    else
        painter.fillRect(QRect(r.left(), r.center().y(), r.width(), 1), t.line);
}

}  // namespace

void draw_box(QPainter& painter, const QRectF& rect, const QColor& fill, const QColor& line, double width) {
    const double in = 0.5 * width, most = 0.5 * std::min(rect.width(), rect.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(line, width));
    painter.setBrush(fill);
    const double round = std::min(radius, most);
    painter.drawRoundedRect(rect.adjusted(in, in, -in, -in), round, round);
    painter.restore();
}

void draw_chevron(QPainter& painter, const QRectF& rect, const QColor& colour, Qt::ArrowType to) {
    constexpr double half = 3.5, rise = 2.0;
    const double down = to == Qt::UpArrow ? -rise : rise;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF at = rect.center();
    painter.drawPolyline(
        QPolygonF{at + QPointF(-half, -down), at + QPointF(0.0, down), at + QPointF(half, -down)});
    painter.restore();
}

void draw_field(QPainter& painter, const QStyleOption& option, bool focused) {
    const Tokens& t = tokens_of(option.palette);
    const bool enabled = option.state & QStyle::State_Enabled;
    const bool fixed = !enabled || (option.state & QStyle::State_ReadOnly);
    const QColor fill = fixed ? t.panel : option.palette.color(QPalette::Base);
    draw_box(painter, option.rect, fill,
             focused ? t.blue
             : fixed ? t.line2
                     : t.field_line,
             focused ? focus_width : 1.0);
}

bool draw_flat(QStyle::PrimitiveElement element, const QStyleOption& option, QPainter& painter,
               const QWidget* widget) {
    painter.save();
    bool drawn = true;
    const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(&option);
    const auto* cell = qstyleoption_cast<const QStyleOptionViewItem*>(&option);
    if (element == QStyle::PE_IndicatorCheckBox)
        draw_check_box(option, painter);
    else if (element == QStyle::PE_PanelButtonCommand)
        draw_button(option, painter);
    else if (element == QStyle::PE_PanelButtonTool)
        draw_tool(option, painter);
    else if (element == QStyle::PE_PanelLineEdit && frame && frame->lineWidth > 0)
        draw_field(painter, option, option.state & QStyle::State_HasFocus);
    else if (element == QStyle::PE_FrameLineEdit)
        draw_field(painter, option, option.state & QStyle::State_HasFocus);
    else if (element == QStyle::PE_PanelItemViewItem && cell)
        draw_cell(*cell, painter, widget);
    else if (element == QStyle::PE_PanelItemViewRow)
        draw_row(option, painter, widget);
    else if (element == QStyle::PE_FrameFocusRect)
        draw_ring(option, painter, widget);
    else if (element == QStyle::PE_FrameTabBarBase)
        painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1),
                         tokens_of(option.palette).line);
    else if (element == QStyle::PE_IndicatorDockWidgetResizeHandle)
        draw_divider(option, painter);
    else if (element != QStyle::PE_FrameStatusBarItem && element != QStyle::PE_FrameTabWidget)
        drawn = false;
    painter.restore();
    return drawn;
}

bool draw_flat(QStyle::ControlElement element, const QStyleOption& option, QPainter& painter,
               const QWidget* widget) {
    painter.save();
    bool drawn = true;
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(&option);
    if (element == QStyle::CE_TabBarTabShape && tab)
        draw_tab(*tab, painter);
    else if (element == QStyle::CE_HeaderSection || element == QStyle::CE_HeaderEmptyArea)
        draw_head(option, painter);
    else if (element == QStyle::CE_ToolBar)
        draw_bar(option, painter, widget);
    else if (element == QStyle::CE_MenuBarEmptyArea)
        painter.fillRect(option.rect, tokens_of(option.palette).chrome);
    else if (element == QStyle::CE_ProgressBarGroove)
        draw_progress(option, painter, false);
    else if (element == QStyle::CE_ProgressBarContents)
        draw_progress(option, painter, true);
    else if (element == QStyle::CE_Splitter)
        draw_divider(option, painter);
    else
        drawn = false;
    painter.restore();
    return drawn;
}

}  // namespace covaria::ui
