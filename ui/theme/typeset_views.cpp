// The style draws everything but the text; the text is drawn with its subscripts.
#include "ui/theme/typeset_views.h"

#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QApplication>
#include <QHelpEvent>
#include <QScrollBar>
#include <QStylePainter>
#include <QToolTip>
#include <cmath>

#include "core/text/symbol.h"
#include "ui/theme/fonts.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int around_head = 12;  // px above and below the text of a head

QStyle* style_of(const QWidget* widget) {
    return widget ? widget->style() : QApplication::style();
}

/// Text that a model gives with scripts; else the one it shows, read as running text.
Text text_from(const QVariant& typeset, const QVariant& shown) {
    return typeset.isValid() ? typeset.value<Text>() : running_text(to_std(shown.toString()));
}

/// Draws `text` in `area` with the painter's pen, shortened where it must be.
void draw_typeset(QPainter& painter, const Text& text, const QFont& font, const QRect& area,
                  Qt::Alignment alignment) {
    const LabelText label(shortened(text, font, area.width()), font);
    double left = area.left();
    if (alignment & Qt::AlignRight) left += area.width() - label.width();
    if (alignment & Qt::AlignHCenter) left += 0.5 * (area.width() - label.width());
    label.draw(painter, {left, area.top() + 0.5 * (area.height() - label.height())});
}

/// Whether it has a symbol or a script: it is then drawn by hand, not by the style.
bool is_typeset(const Text& text) {
    return !text.empty() && !text.is_plain();
}

QColor text_colour(const QStyleOptionViewItem& option) {
    const QPalette::ColorGroup group = !(option.state & QStyle::State_Enabled)  ? QPalette::Disabled
                                       : !(option.state & QStyle::State_Active) ? QPalette::Inactive
                                                                                : QPalette::Normal;
    return option.palette.color(
        group, option.state & QStyle::State_Selected ? QPalette::HighlightedText : QPalette::Text);
}

/// The part of `whole` that the edges of its view, and a column over it, leave: it is drawn as if it began
/// and ended there.
QRect seen_part(const QRect& whole, const QWidget* view) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(view);
    if (!area) return whole;
    QRect room = area->viewport()->rect();
    room.setLeft(room.left() + area->property(covered_width).toInt());
    room.setTop(whole.top());
    room.setBottom(whole.bottom());
    const QRect seen = whole & room;
    return seen.isEmpty() ? whole : seen;
}

/// Left and right of the text of a cell together.
int text_margins(const QStyleOptionViewItem& cell) {
    return 2 * (style_of(cell.widget)->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, cell.widget) + 1);
}

}  // namespace

TypesetDelegate::TypesetDelegate(QObject* parent, Qt::TextElideMode elide)
    : SteadyDelegate(parent), elide_(elide) {
    // Scrolling moves what was painted; what was cut is whole then, and another column is cut.
    if (const auto* view = qobject_cast<QAbstractScrollArea*>(parent))
        connect(view->horizontalScrollBar(), &QScrollBar::valueChanged, view->viewport(),
                qOverload<>(&QWidget::update));
}

void TypesetDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    // "θ" of a model whose cell is "theta"; with scripts it is drawn by hand.
    if (const QVariant text = index.data(typeset_role); text.isValid() && !is_typeset(text.value<Text>()))
        option->text = to_qt(to_unicode(text.value<Text>()));
    if (option->displayAlignment & Qt::AlignRight)
        option->font = with_tabular_figures(option->font);
    else
        option->textElideMode = elide_;
}

void TypesetDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    QStyleOptionViewItem cell(option);
    initStyleOption(&cell, index);
    Text text = text_from(index.data(typeset_role), cell.text);
    cell.rect = seen_part(cell.rect, cell.widget);
    // The digits that remain of a number would be another one.
    const bool is_number = cell.displayAlignment & Qt::AlignRight;
    if (is_number && !cell.text.isEmpty() &&
        text_width(text, cell.font) + text_margins(cell) > cell.rect.width()) {
        cell.text = QStringLiteral("…");
        text = Text("…");
    }
    QStyle* style = style_of(cell.widget);
    const int margin = text_margins(cell) / 2;
    const QRect area = style->subElementRect(QStyle::SE_ItemViewItemText, &cell, cell.widget)
                           .adjusted(margin, 0, -margin, 0);
    if (!is_typeset(text)) {
        if (cell.textElideMode == Qt::ElideMiddle && text_width(text, cell.font) > area.width())
            cell.text = to_qt(to_unicode(shortened(text, cell.font, area.width())));
        style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
        return;
    }
    const QString plain = std::exchange(cell.text, QString());
    style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
    cell.text = plain;
    painter->save();
    painter->setClipRect(cell.rect);
    painter->setPen(text_colour(cell));
    draw_typeset(*painter, text, cell.font, area, cell.displayAlignment);
    painter->restore();
}

bool TypesetDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view,
                                const QStyleOptionViewItem& option, const QModelIndex& index) {
    const QString text = index.data().toString(), help = index.data(Qt::ToolTipRole).toString();
    QStyleOptionViewItem of_cell = option;
    initStyleOption(&of_cell, index);
    const bool is_cut = event->type() == QEvent::ToolTip && !text.isEmpty() && !help.contains(text) &&
                        sizeHint(of_cell, index).width() > option.rect.width();
    if (!is_cut) return SteadyDelegate::helpEvent(event, view, option, index);
    QToolTip::showText(event->globalPos(), help.isEmpty() ? text : text + QStringLiteral("\n\n") + help, view,
                       option.rect);
    return true;
}

QSize TypesetDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    QStyleOptionViewItem cell(option);
    initStyleOption(&cell, index);
    const Text text = text_from(index.data(typeset_role), cell.text);
    if (is_typeset(text))
        size.rwidth() += int(
            std::ceil(text_width(text, cell.font) - QFontMetricsF(cell.font).horizontalAdvance(cell.text)));
    return size;
}

TypesetHeader::TypesetHeader(Qt::Orientation orientation, QWidget* parent)
    : QHeaderView(orientation, parent) {
    setSectionsClickable(true);
    setHighlightSections(false);
    if (const auto* view = qobject_cast<QAbstractScrollArea*>(parent))
        connect(view->horizontalScrollBar(), &QScrollBar::valueChanged, viewport(),
                qOverload<>(&QWidget::update));
}

Text TypesetHeader::text_of(int section) const {
    if (!model()) return {};
    return text_from(model()->headerData(section, orientation(), typeset_role),
                     model()->headerData(section, orientation()));
}

void TypesetHeader::initStyleOptionForIndex(QStyleOptionHeader* option, int section) const {
    QHeaderView::initStyleOptionForIndex(option, section);
    if (draws_text(section)) option->text.clear();
}

bool TypesetHeader::draws_text(int section) const {
    const QRect whole(sectionViewportPosition(section), 0, sectionSize(section), height());
    const bool is_cut = orientation() == Qt::Horizontal && seen_part(whole, this) != whole;
    return is_cut || is_typeset(text_of(section));
}

void TypesetHeader::paintSection(QPainter* painter, const QRect& whole, int section) const {
    const QRect rect = seen_part(whole, this);
    painter->save();
    QHeaderView::paintSection(painter, rect, section);
    painter->restore();
    if (!draws_text(section)) return;
    QStyleOptionHeaderV2 option;
    initStyleOption(&option);
    initStyleOptionForIndex(&option, section);
    option.rect = rect;
    const QRect area = style()->subElementRect(QStyle::SE_HeaderLabel, &option, this);
    painter->save();
    painter->setPen(tokens_of(option.palette).ink2);
    draw_typeset(*painter, text_of(section), font(), area, option.textAlignment);
    painter->restore();
}

/// Room for the mark of sorting has the section that is sorted by, not every one.
QSize TypesetHeader::sectionSizeFromContents(int section) const {
    const QSize size = QHeaderView::sectionSizeFromContents(section);
    const bool sorted = isSortIndicatorShown() && sortIndicatorSection() == section;
    const int margin = style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, this);
    const int mark = sorted ? style()->pixelMetric(QStyle::PM_HeaderMarkSize) + margin : 0;
    const int width = int(std::ceil(text_width(text_of(section), font()))) + 1;
    const int height = std::max(size.height(), QFontMetrics(font()).height() + around_head);
    return {width + 2 * margin + mark, height};
}

TypesetComboBox::TypesetComboBox(QWidget* parent) : QComboBox(parent) {
    setItemDelegate(new TypesetDelegate(this));
}

void TypesetComboBox::add_item(const Text& text, const QVariant& own) {
    addItem(to_qt(to_unicode(text)), own);
    setItemData(count() - 1, QVariant::fromValue(text), typeset_role);
}

void TypesetComboBox::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    const Text text = text_from(currentData(typeset_role), option.currentText);
    if (!is_typeset(text)) {
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
        return;
    }
    const QRect area = style()
                           ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this)
                           .adjusted(1, 0, -1, 0);
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Normal : QPalette::Disabled, QPalette::ButtonText));
    draw_typeset(painter, text, font(), area, Qt::AlignLeft);
}

}  // namespace covaria::ui
