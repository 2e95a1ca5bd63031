#include "ui/scene_view/section_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QToolTip>

#include "ui/document/quantity_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int digits_of_position = 12;

}  // namespace

SectionBar::SectionBar(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 8, 2);
    across_ = new QLabel(this);
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setAccessibleName(tr("Section"));
    slider_->setToolTip(
        tr("In the picture Shift+wheel, Page Up and Page Down move the section, with Shift in fine steps; "
           "Esc ends it"));
    slider_->setPageStep(10);
    typed_ = new QLineEdit(this);
    typed_->setAccessibleName(tr("Position of the section"));
    typed_->setFixedWidth(typed_->fontMetrics().averageCharWidth() * digits_of_position + 16);
    across_->setBuddy(slider_);
    row->addWidget(across_);
    row->addWidget(slider_, 1);
    row->addWidget(typed_);
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setAutoRaise(true);
        button->setDefaultAction(action);
        button->setAccessibleName(action->text());
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    for (QWidget* each : findChildren<QWidget*>()) each->installEventFilter(this);
    connect(slider_, &QSlider::valueChanged, this, [this](int step) { emit moved(steps_.at(step)); });
    connect(typed_, &QLineEdit::editingFinished, this, &SectionBar::take_typed);
}

void SectionBar::show_section(const SectionPlane& section, const Scene& scene) {
    static const QString axes[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    across_->setText(tr("Section across %1").arg(axes[section.axis]));
    at_ = section.at;
    steps_ = steps_of_section(scene, section.axis);
    unit_ = Unit::parse(scene.unit.text).value_or(Unit::of("m"));
    typed_->setToolTip(
        tr("Where the plane is; a number without a unit is in %1").arg(to_qt(unit_.display())));
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, steps_.count);
    slider_->setValue(steps_.nearest(at_));
    write_position();
}

void SectionBar::write_position() {
    typed_->setText(quantity_text({converted(at_, Unit::of("m"), unit_), unit_}, QLocale()));
    typed_->setModified(false);
}

/// A text that is no length is told and taken back.
void SectionBar::take_typed() {
    if (!typed_->isModified()) return;
    const auto typed = parse_quantity(typed_->text(), unit_, QLocale());
    if (typed && *typed) return emit moved((*typed)->si());
    write_position();
    if (!typed) QToolTip::showText(typed_->mapToGlobal(QPoint()), to_qt(typed.error().message), typed_);
}

/// Escape ends the section, and stops no run.
bool SectionBar::eventFilter(QObject* watched, QEvent* event) {
    const bool is_key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!is_key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return QWidget::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::KeyPress) emit left();
    return true;
}

}  // namespace covaria::ui
