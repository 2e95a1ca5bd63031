#include "tests/ui/main_window/cut_texts.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>

#include "ui/theme/elided_label.h"
#include "ui/theme/label_text.h"
#include "ui/theme/tabs.h"

namespace covaria::ui {
namespace {

/// px: a field that has all of an inspector cannot be wider; a list is whole when it is opened, a line
/// scrolls.
constexpr int whole_inspector = 240;

class Reader {
public:
    void read(const QWidget& widget) {
        if (!widget.isVisible() || widget.width() < 2 || widget.height() < 2) return;
        widget_ = &widget;
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) read_label(*label);
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) read_button(*button);
        if (const auto* box = qobject_cast<const QComboBox*>(&widget)) read_list(*box);
        if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) read_line(*line);
        if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) read_tabs(*bar);
        if (const auto* head = qobject_cast<const QHeaderView*>(&widget)) read_head(*head);
        if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) read_cells(*view);
        if (const auto* area = qobject_cast<const QAbstractScrollArea*>(&widget)) read_scroll_bar(*area);
    }
    QStringList found;

private:
    void say(const char* kind, const QString& text, int missing) {
        if (missing <= 0) return;
        QString name = widget_->objectName();
        for (const QWidget* around = widget_->parentWidget(); name.isEmpty() && around;
             around = around->parentWidget())
            name = around->objectName() + QLatin1Char('/');
        found << QStringLiteral("%1 %2 %3: \"%4\" (%5 px)")
                     .arg(QString::fromLatin1(kind), QString::fromLatin1(widget_->metaObject()->className()),
                          name, text)
                     .arg(missing);
    }
    void read_label(const QLabel& label) {
        if (label.text().isEmpty()) return;
        // The name that a user gave an entry, as in the tree.
        if (label.objectName() == QLatin1String("inspector_title") && label.toolTip() == label.text()) return;
        if (qobject_cast<const ElidedLabel*>(&label))
            return say("label", label.text(),
                       label.fontMetrics().horizontalAdvance(label.text()) - label.contentsRect().width());
        if (label.wordWrap())
            return say("label", label.text(), label.heightForWidth(label.width()) - label.height());
        say("label", label.text(), label.sizeHint().width() - label.width());
    }
    void read_button(const QAbstractButton& button) {
        if (button.objectName() == QLatin1String("qt_toolbar_ext_button"))
            return say("bar hides tools", {}, 1);
        if (button.text().isEmpty()) return;
        if (const auto* tool = qobject_cast<const QToolButton*>(&button);
            tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull())
            return;
        say("button", button.text(), button.sizeHint().width() - button.width());
    }
    void read_list(const QComboBox& box) {
        if (box.width() >= whole_inspector) return;
        QStyleOptionComboBox option;
        option.initFrom(&box);
        option.subControls = QStyle::SC_All;
        option.editable = box.isEditable();
        const int room =
            box.style()
                ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
                .width();
        const QVariant typeset = box.currentData(typeset_role);
        const double wanted = typeset.isValid() ? text_width(typeset.value<Text>(), box.font())
                                                : box.fontMetrics().horizontalAdvance(box.currentText());
        const int icon = box.itemIcon(box.currentIndex()).isNull() ? 2 : box.iconSize().width() + 6;
        say("list", box.currentText(), int(wanted) + icon - room);
    }
    void read_line(const QLineEdit& line) {
        if (qobject_cast<const QComboBox*>(line.parentWidget()) || line.width() >= whole_inspector) return;
        const QString text = line.displayText().isEmpty() ? line.placeholderText() : line.displayText();
        const QMargins margins = line.textMargins();
        say("line", text,
            line.fontMetrics().horizontalAdvance(text) + margins.left() + margins.right() + 4 -
                line.contentsRect().width());
    }
    void read_tabs(const QTabBar& bar) {
        const auto* own = qobject_cast<const TabBar*>(&bar);
        for (int i = 0; i < bar.count(); ++i) {
            // A tab without room has its whole name in the menu at the end of the bar.
            if (!bar.isTabVisible(i) || (own && own->is_in_menu(i))) continue;
            say("tab", bar.tabText(i), bar.tabRect(i).right() - bar.width() + 1);
        }
    }
    void read_head(const QHeaderView& head) {
        if (head.orientation() == Qt::Vertical || !head.model()) return;
        for (int i = 0; i < head.count(); ++i) {
            const int section = head.logicalIndex(i);
            if (head.isSectionHidden(section) || head.sectionViewportPosition(section) >= head.width())
                continue;
            say("head", head.model()->headerData(section, head.orientation()).toString(),
                head.sectionSizeHint(section) - head.sectionSize(section));
        }
    }
    void read_cells(const QAbstractItemView& view) {
        if (!view.model() || qobject_cast<const QHeaderView*>(&view)) return;
        const auto* table = qobject_cast<const QTableView*>(&view);
        const auto* tree = qobject_cast<const QTreeView*>(&view);
        const QRect seen = view.viewport()->rect();
        for (int y = 2; y < seen.height(); y += 8)
            for (int c = 0; c < view.model()->columnCount(view.rootIndex()); ++c) {
                if ((table && table->isColumnHidden(c)) || (tree && tree->isColumnHidden(c))) continue;
                const int x = table  ? table->columnViewportPosition(c)
                              : tree ? tree->columnViewportPosition(c)
                                     : 0;
                const QModelIndex at = view.indexAt({std::max(x, 0) + 2, y});
                if (!at.isValid() || at.column() != c || at == last_) continue;
                last_ = at;
                if (view.indexWidget(at) || (table && table->columnSpan(at.row(), c) > 1)) continue;
                say("cell", at.data().toString(),
                    view.sizeHintForIndex(at).width() - view.visualRect(at).width());
            }
    }
    void read_scroll_bar(const QAbstractScrollArea& area) {
        if (area.horizontalScrollBar()->isVisible())
            say("scrolls sideways", area.accessibleName(), area.horizontalScrollBar()->maximum());
    }

    const QWidget* widget_ = nullptr;
    QModelIndex last_;
};

}  // namespace

QStringList cut_texts(const QWidget& window) {
    Reader reader;
    for (const QWidget* widget : window.findChildren<QWidget*>()) reader.read(*widget);
    return reader.found;
}

}  // namespace covaria::ui
