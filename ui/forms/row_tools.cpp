#include "ui/forms/row_tools.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/forms/spreadsheet_view.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/icons.h"

namespace covaria::ui {

RowTools::RowTools(const QWidget& table, SpreadsheetView& view, QWidget* parent)
    : QWidget(parent), table_(&table), view_(view), buttons_(new QWidget(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addStretch(1);
    row->addWidget(buttons_);
    places_ = new QHBoxLayout(buttons_);
    places_->setContentsMargins(0, 0, 0, 0);
    places_->setSpacing(2);
    add(QStringLiteral("add"), tr("Add row"), view.append_row_action());
    add(QStringLiteral("remove"), tr("Delete rows"), view.remove_rows_action());
    add(QStringLiteral("fill"), tr("Fill down"), view.fill_down_action());
    follow_font(*this, [this] { setFixedHeight(fontMetrics().height() + 8); });
    buttons_->hide();
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow_focus(now); });
}

/// QWidget's destructor moves the focus away, when no member of this class is left.
RowTools::~RowTools() {
    disconnect(qApp, nullptr, this, nullptr);
}

void RowTools::follow_focus(const QWidget* focused) {
    const auto is_in = [focused](const QWidget* part) {
        return part && (part == focused || part->isAncestorOf(focused));
    };
    buttons_->setVisible(focused && (is_in(table_) || is_in(buttons_)));
}

void RowTools::add(const QString& picture, const QString& text, QAction* action) {
    auto* button = new QToolButton(buttons_);
    button->setIcon(icon(picture));
    button->setIconSize({16, 16});
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    button->setToolTip(keys.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(action->text(), keys));
    button->setAccessibleName(text);
    button->setEnabled(action->isEnabled());
    connect(button, &QToolButton::clicked, this, [this, action] {
        action->trigger();
        view_.setFocus();  // the user types next
    });
    connect(action, &QAction::enabledChanged, button, &QWidget::setEnabled);
    places_->addWidget(button);
}

}  // namespace covaria::ui
