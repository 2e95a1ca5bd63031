#include "ui/pages/first_steps_panel.h"

#include <QEvent>
#include <QFont>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

QPushButton* button(const QString& words, const char* name) {
    auto* made = new QPushButton(words);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    return made;
}

QLabel* words_label(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

}  // namespace

FirstStepsPanel::FirstStepsPanel(QWidget* parent)
    : QWidget(parent),
      progress_(new QLabel),
      tick_(new QLabel),
      state_(new QLabel),
      title_(words_label("step_title")),
      text_(words_label("step_text")),
      remark_(words_label("step_remark")),
      show_(button(tr("Show Me"), "step_show")),
      back_(button(tr("Back"), "step_back")),
      next_(button(tr("Next"), "step_next")) {
    setAccessibleName(tr("First steps"));
    progress_->setObjectName(QStringLiteral("step_progress"));
    state_->setObjectName(QStringLiteral("step_state"));
    QFont bold;
    bold.setBold(true);
    title_->setFont(bold);  // the size stays that of the window
    remark_->setEnabled(false);
    show_->setToolTip(tr("Shows where it is done: opens the tab and puts a frame around it"));
    auto* close = button(tr("Close"), "step_close");
    auto* head = new QHBoxLayout;
    head->addWidget(progress_);
    head->addStretch(1);
    head->addWidget(tick_);
    head->addWidget(state_);
    auto* buttons = new QGridLayout;
    buttons->addWidget(show_, 0, 0, 1, 2);
    buttons->addWidget(back_, 1, 0);
    buttons->addWidget(next_, 1, 1);
    buttons->addWidget(close, 2, 0, 1, 2);
    auto* column = new QVBoxLayout(this);
    column->addLayout(head);
    column->addWidget(title_);
    column->addWidget(text_);
    column->addWidget(remark_);
    column->addStretch(1);
    column->addLayout(buttons);
    connect(show_, &QPushButton::clicked, this, [this] { emit show_wanted(step_); });
    connect(back_, &QPushButton::clicked, this, [this] { go_to(step_ - 1); });
    connect(next_, &QPushButton::clicked, this, [this] { go_to(step_ + 1); });
    connect(close, &QPushButton::clicked, this, &FirstStepsPanel::close_wanted);
    refresh();
}

void FirstStepsPanel::go_to(int step) {
    step = std::clamp(step, 0, int(first_steps().size()) - 1);
    if (step == step_) return;
    step_ = step;
    remark_->clear();
    refresh();
    emit step_changed(step_);
}

void FirstStepsPanel::set_done(int step, bool done) {
    done_[std::size_t(step)] = done;
    refresh();
}

void FirstStepsPanel::set_remark(const QString& words) {
    remark_->setText(words);
    remark_->setVisible(!words.isEmpty());
    take_height();
}

void FirstStepsPanel::take_height() {
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : 0;
    if (height > 0 && height != minimumHeight()) setMinimumHeight(height);
}

void FirstStepsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    take_height();
}

void FirstStepsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) refresh();
}

void FirstStepsPanel::refresh() {
    const FirstStep& shown = first_steps()[std::size_t(step_)];
    const bool done = is_done(step_);
    progress_->setText(tr("%1 of %2", "step 3 of 10").arg(step_ + 1).arg(first_steps().size()));
    const int size = fontMetrics().height();
    tick_->setPixmap(done ? icon(QStringLiteral("state-up-to-date")).pixmap(size, size) : QPixmap());
    state_->setText(done ? tr("done") : QString());
    title_->setText(covaria::ui::tr(shown.title));
    text_->setText(covaria::ui::tr(shown.text));
    remark_->setVisible(!remark_->text().isEmpty());
    // A button that is disabled loses the focus to whatever comes next.
    if (step_ == 0 && back_->hasFocus()) next_->setFocus();
    const bool last = step_ + 1 == int(first_steps().size());
    if (last && next_->hasFocus()) back_->setFocus();
    back_->setEnabled(step_ > 0);
    next_->setEnabled(!last);
    take_height();
}

}  // namespace covaria::ui
