#include "ui/main_window/dock_title.h"

#include <QApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <utility>

#include "ui/theme/elided_label.h"
#include "ui/theme/icons.h"

namespace covaria::ui {
namespace {

constexpr int line_height = 2;

QToolButton* add_button(QHBoxLayout& row, const QString& picture, const QString& tip) {
    auto* button = new QToolButton;
    button->setIcon(icon(picture));
    button->setIconSize({12, 12});
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    row.addWidget(button);
    return button;
}

}  // namespace

DockTitle::DockTitle(QDockWidget& dock, QWidget* controls) : QWidget(&dock), dock_(dock) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 4, 2);
    row->setSpacing(2);
    if (controls) {
        row->addWidget(controls, 1);
        connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
        return;  // it floats by dragging, and the view menu closes it
    }
    auto* label = new ElidedLabel(dock.windowTitle());
    QFont font = label->font();
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    row->addWidget(label, 1);
    connect(&dock, &QWidget::windowTitleChanged, label, &QLabel::setText);
    row->addSpacing(4);
    QToolButton* floating = add_button(*row, QStringLiteral("float"), tr("Float or dock"));
    QToolButton* close = add_button(*row, QStringLiteral("close"), tr("Close"));
    connect(floating, &QToolButton::clicked, &dock, [&dock] { dock.setFloating(!dock.isFloating()); });
    connect(close, &QToolButton::clicked, &dock, &QWidget::close);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

void DockTitle::follow(const QWidget* focused) {
    const bool has = focused && dock_.isAncestorOf(focused);
    if (std::exchange(has_keyboard_, has) != has) update();
}

void DockTitle::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (!has_keyboard_) return;
    QPainter painter(this);
    painter.fillRect(0, height() - line_height, width(), line_height, palette().highlight());
}

}  // namespace covaria::ui
