#include "ui/forms/target_box.h"

#include <QCompleter>
#include <QLineEdit>
#include <QSignalBlocker>

#include "ui/theme/strings.h"

namespace covaria::ui {

TargetBox::TargetBox(std::function<std::vector<StudyTargetChoice>()> choices, QWidget* parent)
    : QComboBox(parent), choices_(std::move(choices)) {
    setEditable(true);
    setInsertPolicy(NoInsert);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(18);
    completer()->setFilterMode(Qt::MatchContains);
    completer()->setCompletionMode(QCompleter::PopupCompletion);
    setToolTip(tr("What is varied: type a part of its name to search"));
    setAccessibleName(tr("What is varied"));
    connect(this, &QComboBox::activated, this, &TargetBox::take);
    connect(lineEdit(), &QLineEdit::editingFinished, this, [this] {
        if (currentText() != title_ && findText(currentText()) < 0) show_title(title_);
    });
}

void TargetBox::show_title(const QString& title) {
    title_ = title;
    const QSignalBlocker blocker(this);
    setCurrentIndex(findText(title));
    setEditText(title);
    lineEdit()->setCursorPosition(0);
}

void TargetBox::fill() {
    listed_ = choices_();
    const QSignalBlocker blocker(this);
    clear();
    for (const StudyTargetChoice& choice : listed_) {
        QString title = to_qt(choice.target.title);
        if (choice.axis.change == StudyChange::factor) title += tr(" (factor)");
        addItem(title);
    }
    setEditText(title_);
    setCurrentIndex(findText(title_));
}

void TargetBox::showPopup() {
    fill();
    QComboBox::showPopup();
}

void TargetBox::focusInEvent(QFocusEvent* event) {
    fill();
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
    emit chosen(listed_[std::size_t(index)].axis);
}

}  // namespace covaria::ui
