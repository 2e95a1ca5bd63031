#include "ui/forms/target_box.h"

#include <QCompleter>
#include <QFocusEvent>
#include <QLineEdit>
#include <QSignalBlocker>

#include "ui/forms/complaint.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

TargetBox::TargetBox(std::function<std::vector<StudyTargetChoice>()> choices, QWidget* parent)
    : QComboBox(parent), choices_(std::move(choices)) {
    setEditable(true);
    setInsertPolicy(NoInsert);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(12);
    completer()->setFilterMode(Qt::MatchContains);
    completer()->setCompletionMode(QCompleter::PopupCompletion);
    help_ = tr("What is varied: type a part of its name to search");
    setToolTip(help_);
    setAccessibleName(tr("What is varied"));
    connect(this, &QComboBox::activated, this, &TargetBox::take);
    connect(lineEdit(), &QLineEdit::editingFinished, this, &TargetBox::take_typed);
}

void TargetBox::set_place(UnreadTexts& unread, const TextPlace& place) {
    if (!unread_) connect(&unread, &UnreadTexts::changed, this, &TargetBox::show_mark);
    unread_ = &unread;
    place_ = place;
}

void TargetBox::show_mark() {
    const UnreadText* kept = unread_ ? unread_->find(place_) : nullptr;
    mark(*this, kept ? kept->reason : QString(), help_);
}

/// A part of a name will do where only one name has it; what names nothing stays, as a problem.
void TargetBox::take_typed() {
    const QString typed = lineEdit()->text().trimmed();
    if (typed == title_ || typed.isEmpty()) {
        if (typed.isEmpty()) show_title(title_);
        if (unread_) unread_->remove(place_);
        return;
    }
    std::vector<int> fitting;
    for (int i = 0; i < count(); ++i) {
        if (itemText(i).compare(typed, Qt::CaseInsensitive) == 0) return take(i);
        if (itemText(i).contains(typed, Qt::CaseInsensitive)) fitting.push_back(i);
    }
    if (fitting.size() == 1) return take(fitting.front());
    if (unread_)
        unread_->set(
            place_,
            {typed,
             fitting.empty()
                 ? tr("“%1” names nothing that can be varied.").arg(typed)
                 : tr("“%1” names %n things that can be varied.", nullptr, int(fitting.size())).arg(typed),
             to_std(title_)});
}

void TargetBox::show_title(const QString& title) {
    title_ = title;
    const UnreadText* kept = unread_ ? unread_->find(place_) : nullptr;
    if (kept && kept->instead_of != to_std(title)) {
        unread_->remove(place_);
        kept = nullptr;
    }
    if (hasFocus() && lineEdit()->isModified()) return;  // being typed
    const QSignalBlocker blocker(this);
    setCurrentIndex(findText(title));
    setEditText(kept ? kept->text : title);
    lineEdit()->setCursorPosition(0);
    show_mark();
}

void TargetBox::fill() {
    listed_ = choices_();
    const QSignalBlocker blocker(this);
    const QString typed = lineEdit()->text();
    const bool modified = lineEdit()->isModified();
    clear();
    for (const StudyTargetChoice& choice : listed_) {
        QString title = to_qt(choice.target.title.message());
        if (choice.axis.change == StudyChange::factor) title += tr(" (factor)");
        addItem(title);
    }
    setCurrentIndex(findText(title_));
    setEditText(typed);
    lineEdit()->setModified(modified);
}

void TargetBox::showPopup() {
    fill();
    QComboBox::showPopup();
}

void TargetBox::focusInEvent(QFocusEvent* event) {
    // The list is not filled anew when typing goes on after its own list or another window.
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) fill();
    QComboBox::focusInEvent(event);
}

bool TargetBox::choose(const QString& title) {
    fill();
    const int index = findText(title);
    take(index);
    return index >= 0;
}

void TargetBox::take(int index) {
    if (index < 0 || std::size_t(index) >= listed_.size()) return;
    lineEdit()->setModified(false);
    if (unread_) unread_->remove(place_);
    emit chosen(listed_[std::size_t(index)].axis);
}

}  // namespace covaria::ui
