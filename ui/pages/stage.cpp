#include "ui/pages/stage.h"

#include <QActionGroup>
#include <QMenu>
#include <QSettings>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QToolButton>

#include "ui/pages/second_part.h"
#include "ui/theme/icons.h"

namespace covaria::ui {
namespace {

const char* const split_key = "stage/split";
const char* const beside_key = "stage/beside";

}  // namespace

Stage::Stage(QTabWidget& tabs, QWidget* parent)
    : QSplitter(Qt::Vertical, parent), tabs_(tabs), second_(new SecondPart(tabs)), split_(new QToolButton) {
    addWidget(&tabs);
    addWidget(second_);
    setChildrenCollapsible(false);
    setStretchFactor(0, 3);
    setStretchFactor(1, 2);
    make_split_button();
    if (QSettings().value(QLatin1String(beside_key)).toBool()) setOrientation(Qt::Horizontal);
    connect(second_, &SecondPart::changed, this, [this] {
        const QSignalBlocker quiet(split_);
        split_->setChecked(second_->view() != nullptr);
        give_room();
        emit changed();
    });
}

void Stage::make_split_button() {
    split_->setObjectName(QStringLiteral("split_stage"));
    split_->setIcon(icon(QStringLiteral("split")));
    split_->setCheckable(true);
    split_->setAutoRaise(true);
    split_->setFocusPolicy(Qt::TabFocus);
    split_->setToolTip(tr("Two views at once"));
    split_->setAccessibleName(tr("Two views at once"));
    auto* menu = new QMenu(split_);
    auto* ways = new QActionGroup(menu);
    const auto add = [&](const QString& words, Qt::Orientation orientation) {
        QAction* way = menu->addAction(words);
        way->setCheckable(true);
        way->setChecked(this->orientation() == orientation);
        ways->addAction(way);
        connect(way, &QAction::triggered, this, [this, orientation] { turn(orientation); });
    };
    add(tr("Below Each Other"), Qt::Vertical);
    add(tr("Beside Each Other"), Qt::Horizontal);
    split_->setMenu(menu);
    split_->setPopupMode(QToolButton::MenuButtonPopup);
    tabs_.setCornerWidget(split_);
    connect(split_, &QToolButton::toggled, this, [this](bool wanted) {
        QSettings().setValue(QLatin1String(split_key), wanted);
        split(wanted);
    });
}

void Stage::add_first(QWidget& view, const QString& name) {
    first_ = &view;
    tabs_.insertTab(0, &view, name);
    tabs_.setCurrentIndex(0);
}

void Stage::name_first(const QString& name) {
    tabs_.setTabText(tab_of(first_), name);
    second_->take_names();
}

void Stage::give_whole_stage(QWidget& view) {
    alone_ = &view;
}

void Stage::give_room() {
    const bool alone = alone_ && tabs_.currentWidget() == alone_;
    second_->setVisible(second_->view() && !alone);
    split_->setEnabled(!alone);
}

void Stage::show_usual(QWidget& second) {
    usual_ = &second;
    if (second_->view() == first_) second_->close_part();
    tabs_.setCurrentWidget(first_);
    if (QSettings().value(QLatin1String(split_key), true).toBool()) second_->show_view(usual_);
}

void Stage::show_view(QWidget* view) {
    if (shows(*view)) return;
    if (second_->view() && tabs_.currentWidget() == first_ && view != alone_)
        second_->show_view(view);
    else
        tabs_.setCurrentWidget(view);
}

bool Stage::shows(const QWidget& part) const {
    const auto has = [&part](const QWidget* view) {
        return view && (view == &part || (view->isAncestorOf(&part) && part.isVisibleTo(view)));
    };
    return has(tabs_.currentWidget()) || (second_->isVisibleTo(this) && has(second_->view()));
}

int Stage::tab_of(const QWidget* view) const {
    return second_->tab_of(view);
}

void Stage::split(bool wanted) {
    if (!wanted) return second_->close_part();
    QWidget* second = usual_ && tabs_.currentWidget() != usual_ ? usual_ : first_;
    second_->show_view(second);
}

void Stage::turn(Qt::Orientation orientation) {
    QSettings().setValue(QLatin1String(beside_key), orientation == Qt::Horizontal);
    setOrientation(orientation);
    split_->setChecked(true);
}

}  // namespace covaria::ui
