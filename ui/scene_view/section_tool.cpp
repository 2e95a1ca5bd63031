#include "ui/scene_view/section_tool.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>

#include "ui/scene_view/scene_view.h"
#include "ui/scene_view/section_bar.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int steps_of_page = 10;
constexpr int one_notch = 120;  // of a wheel

}  // namespace

SectionTool::SectionTool(SceneView& view, QObject* parent) : QObject(parent), view_(view) {
    toggle_ = make_action(tr("Section"), tr("Section: cut away what lies before a plane (S)"));
    toggle_->setIcon(icon(QStringLiteral("section")));
    toggle_->setCheckable(true);
    toggle_->setShortcut(Qt::Key_S);
    flip_ = make_action(tr("Flip Side"), tr("Cut away the other side (Shift+S)"));
    flip_->setShortcut(Qt::SHIFT | Qt::Key_S);
    off_ = make_action(tr("Off"), tr("The scene is whole again (Esc)"));
    off_->setIcon(icon(QStringLiteral("close")));
    choices_ = new QActionGroup(this);
    for (const QString& axis : {tr("Across x"), tr("Across y"), tr("Across z")}) {
        QAction* action = choices_->addAction(axis);
        action->setCheckable(true);
        const int number = static_cast<int>(choices_->actions().size()) - 1;
        connect(action, &QAction::triggered, this, [this, number] { cut_across(number); });
    }
    choices_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (QAction* action : {toggle_, flip_}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        view_.addAction(action);
    }
    bar_ = new SectionBar({flip_, off_}, view_.parentWidget());
    bar_->hide();
    connect(toggle_, &QAction::triggered, this, [this](bool on) { on ? begin() : set({}); });
    connect(flip_, &QAction::triggered, this, &SectionTool::flip);
    connect(off_, &QAction::triggered, this, [this] { set({}); });
    connect(bar_, &SectionBar::moved, this, &SectionTool::move_to);
    connect(bar_, &SectionBar::left, off_, &QAction::trigger);
    view_.installEventFilter(this);
    set({});
}

QAction* SectionTool::make_action(const QString& text, const QString& tip) {
    auto* action = new QAction(text, this);
    action->setToolTip(tip);
    return action;
}

void SectionTool::add_to(QToolBar& toolbar) {
    auto* button = new QToolButton(&toolbar);
    auto* menu = new QMenu(button);
    menu->addAction(off_);
    menu->addActions(choices_->actions());
    menu->addSeparator();
    menu->addAction(flip_);
    button->setDefaultAction(toggle_);
    button->setAccessibleName(toggle_->text());
    button->setMenu(menu);
    button->setPopupMode(QToolButton::MenuButtonPopup);
    toolbar.addWidget(button);
}

QWidget* SectionTool::bar() const {
    return bar_;
}

void SectionTool::show_section_of(const QString& thing) {
    if (thing == thing_) return;
    thing_ = thing;
    const auto found = sections_.find(thing);
    set(found == sections_.end() ? std::nullopt : std::optional(found->second));
}

void SectionTool::start_over() {
    sections_.clear();
    set({});
}

void SectionTool::take_scene() {
    const Scene* scene = view_.scene();
    if (section_ && scene) bar_->show_section(*section_, *scene);
    bar_->setVisible(section_ && scene);
}

void SectionTool::begin() {
    // Across the axis that points most at the eye.
    int axis = 0;
    view_.camera().direction.cwiseAbs().maxCoeff(&axis);
    cut_across(axis);
}

void SectionTool::cut_across(int axis) {
    const Scene* scene = view_.scene();
    if (!scene) return set(section_);
    SectionPlane section = middle_section(*scene, axis, view_.camera());
    const SectionSteps steps = steps_of_section(*scene, axis);
    section.at = steps.at(steps.nearest(section.at));
    set(section);
}

void SectionTool::set(const std::optional<SectionPlane>& section, bool moving) {
    section_ = section;
    if (section)
        sections_[thing_] = *section;
    else
        sections_.erase(thing_);
    view_.set_section(section, moving);
    toggle_->setChecked(section.has_value());
    for (QAction* action : {flip_, off_}) action->setEnabled(section.has_value());
    for (int axis = 0; axis < 3; ++axis)
        choices_->actions()[axis]->setChecked(section && section->axis == axis);
    if (!section && bar_->isAncestorOf(QApplication::focusWidget())) view_.setFocus();
    take_scene();
}

void SectionTool::move_to(double at) {
    if (!section_) return;
    SectionPlane moved = *section_;
    moved.at = at;
    set(moved, true);
}

void SectionTool::move_by(int count) {
    if (!section_ || !view_.scene()) return;
    const SectionSteps steps = steps_of_section(*view_.scene(), section_->axis);
    move_to(steps.at(std::clamp(steps.nearest(section_->at) + count, 0, steps.count)));
}

void SectionTool::flip() {
    if (!section_) return;
    SectionPlane flipped = *section_;
    flipped.hides_high = !flipped.hides_high;
    set(flipped);
}

bool SectionTool::take_key(int key, Qt::KeyboardModifiers modifiers) {
    const int steps = modifiers.testFlag(Qt::ShiftModifier) ? 1 : steps_of_page;
    if (key == Qt::Key_PageUp)
        move_by(steps);
    else if (key == Qt::Key_PageDown)
        move_by(-steps);
    else if (key == Qt::Key_Escape)
        set({});
    else
        return false;
    return true;
}

/// Keys and the wheel of the view while there is a section; Escape belongs to a tool in use first.
bool SectionTool::eventFilter(QObject* watched, QEvent* event) {
    if (!section_) return QObject::eventFilter(watched, event);
    if (event->type() == QEvent::Wheel) {
        const auto* wheel = static_cast<QWheelEvent*>(event);
        const QPoint turned = wheel->angleDelta();  // some platforms turn the wheel aside with Shift
        if (!wheel->modifiers().testFlag(Qt::ShiftModifier)) return false;
        turned_ += turned.y() != 0 ? turned.y() : turned.x();
        move_by(turned_ / one_notch);
        turned_ %= one_notch;
        return true;
    }
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape && view_.picks_places()) return false;
    if (event->type() == QEvent::KeyPress) return take_key(key->key(), key->modifiers());
    if (key->key() == Qt::Key_Escape) event->accept();
    return false;
}

}  // namespace covaria::ui
