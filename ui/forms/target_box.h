// A list to choose what an axis of a study varies: searched by typing, filled when it is opened.
#pragma once

#include <QComboBox>
#include <functional>

#include "core/project/study_target.h"
#include "ui/document/unread_texts.h"

namespace covaria::ui {

class TargetBox : public QComboBox {
    Q_OBJECT
public:
    /// `choices` is asked each time the list is opened or searched.
    explicit TargetBox(std::function<std::vector<StudyTargetChoice>()> choices, QWidget* parent = nullptr);
    /// Sets its place in the project: a text that names nothing is kept in the document under this place.
    void set_place(UnreadTexts& unread, const TextPlace& place);
    /// Shows the title of what is varied now.
    void show_title(const QString& title);
    void showPopup() override;
    /// Chooses the entry with this title, as a click on it does. False: there is none.
    bool choose(const QString& title);

signals:
    void chosen(const covaria::StudyAxis& axis);

protected:
    void focusInEvent(QFocusEvent* event) override;

private:
    void fill();
    void take(int index);
    void take_typed();
    void show_mark();

    std::function<std::vector<StudyTargetChoice>()> choices_;
    std::vector<StudyTargetChoice> listed_;
    QString title_, help_;
    UnreadTexts* unread_ = nullptr;
    TextPlace place_;
};

}  // namespace covaria::ui
