#include "ui/pages/second_part.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "ui/theme/fonts.h"
#include "ui/theme/icons.h"

namespace covaria::ui {

SecondPart::SecondPart(QTabWidget& tabs, QWidget* parent)
    : QWidget(parent), tabs_(tabs), gap_(new QWidget(this)), list_(new QComboBox) {
    gap_->hide();
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    room_ = new QVBoxLayout(this);
    room_->setContentsMargins(0, 0, 0, 0);
    room_->setSpacing(0);
    make_head(*room_);
    connect(&tabs_, &QTabWidget::currentChanged, this, &SecondPart::follow_tabs);
    hide();
}

void SecondPart::make_head(QVBoxLayout& column) {
    list_->setObjectName(QStringLiteral("second_view"));
    list_->setAccessibleName(tr("View of the second part"));
    list_->setToolTip(tr("What the second part of the stage shows"));
    list_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* close = new QToolButton;
    close->setIcon(icon(QStringLiteral("close")));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::TabFocus);
    close->setToolTip(tr("Close this part"));
    close->setAccessibleName(tr("Close this part"));
    head_ = new QHBoxLayout;
    head_->setContentsMargins(8, 4, 8, 4);
    head_->addWidget(list_);
    head_->addStretch(1);
    head_->addWidget(close);
    column.addLayout(head_);
    connect(close, &QToolButton::clicked, this, &SecondPart::close_part);
    connect(list_, &QComboBox::activated, this,
            [this](int index) { show_view(list_->itemData(index).value<QWidget*>()); });
}

int SecondPart::tab_of(const QWidget* view) const {
    for (int i = 0; i < tabs_.count(); ++i)
        if (tabs_.widget(i) == (view == view_ ? gap_ : view)) return i;
    return -1;
}

/// Puts another page behind a tab, unnoticed by those who follow the tabs, which stay in their order.
void SecondPart::replace_page(int tab, QWidget* page) {
    const QSignalBlocker quiet(&tabs_);
    QWidget* current = tabs_.currentIndex() == tab ? page : tabs_.currentWidget();
    const QString text = tabs_.tabText(tab);
    const bool visible = tabs_.isTabVisible(tab), enabled = tabs_.isTabEnabled(tab);
    QWidget* before = tabs_.widget(tab);
    tabs_.insertTab(tab, page, text);
    tabs_.removeTab(tabs_.indexOf(before));
    tabs_.setTabVisible(tab, visible);
    tabs_.setTabEnabled(tab, enabled);
    tabs_.setCurrentWidget(current);
}

void SecondPart::take(QWidget* view) {
    replace_page(tabs_.indexOf(view), gap_);
    view_ = view;
    room_->addWidget(view, 1);
    line_ = view->findChild<QWidget*>(QLatin1String(head_of_view), Qt::FindDirectChildrenOnly);
    if (line_) head_->insertWidget(1, line_);
    view->show();
}

void SecondPart::give_back() {
    if (!view_) return;
    const int tab = tab_of(view_);
    if (line_) qobject_cast<QBoxLayout*>(view_->layout())->insertWidget(0, std::exchange(line_, nullptr));
    room_->removeWidget(view_);
    replace_page(tab, view_);
    gap_->setParent(this);
    gap_->hide();
    view_ = nullptr;
}

void SecondPart::show_view(QWidget* view) {
    if (view == view_ || !view || tab_of(view) < 0) return;
    QWidget* before = view_;
    QWidget* main = tabs_.currentWidget();
    give_back();
    if (view == main) {
        const QSignalBlocker quiet(&tabs_);
        for (int i = 0; !before && i < tabs_.count(); ++i)
            if (tabs_.isTabVisible(i) && tabs_.widget(i) != view) before = tabs_.widget(i);
        tabs_.setCurrentWidget(before);
        main = before;
    }
    take(view);
    main_ = main;
    take_names();
    show();
    emit changed();
}

void SecondPart::close_part() {
    if (!view_) return;
    give_back();
    hide();
    emit changed();
}

void SecondPart::follow_tabs() {
    QWidget* now = tabs_.currentWidget();
    if (now == gap_ && main_ && main_ != gap_) {
        QWidget* view = view_;
        give_back();
        {
            const QSignalBlocker quiet(&tabs_);
            tabs_.setCurrentWidget(view);
        }
        take(main_);
        now = view;
        take_names();
    }
    main_ = now;
    emit changed();
}

void SecondPart::take_names() {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (int i = 0; i < tabs_.count(); ++i) {
        if (!tabs_.isTabVisible(i)) continue;
        QWidget* view = tabs_.widget(i) == gap_ ? view_ : tabs_.widget(i);
        list_->addItem(tabs_.tabText(i), QVariant::fromValue(view));
        if (view == view_) list_->setCurrentIndex(list_->count() - 1);
    }
}

}  // namespace covaria::ui
