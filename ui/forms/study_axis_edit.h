// One axis of a study: what is varied, how, from, to, how many values.
#pragma once

#include <QComboBox>
#include <QGroupBox>
#include <QPushButton>

#include "ui/document/study_edits.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/target_box.h"

namespace covaria::ui {

class StudyAxisEdit : public QGroupBox {
    Q_OBJECT
public:
    using Choices = std::function<std::vector<StudyTargetChoice>()>;
    StudyAxisEdit(Choices choices, std::size_t number, QWidget* parent = nullptr);

    /// `target` is null when it does not exist any more; `only` when it is the only axis.
    void show_axis(const StudyAxis& axis, const StudyTarget* target, bool only);
    void set_complaint(const QString& complaint);
    /// Where in the project the axis stands.
    void set_place(UnreadTexts& unread, const TextPlace& place);

signals:
    void edited(const std::function<void(covaria::StudyAxis&)>& edit, const QString& field);
    void remove_wanted();

private:
    void build();
    void take_end(bool first, const Quantity& quantity);

    TargetBox* target_;
    QComboBox* change_;
    QuantityEdit* from_;
    QuantityEdit* to_;
    QuantityEdit* values_;
    QComboBox* spacing_;
    QPushButton* remove_;
    QString title_;
    StudyAxis axis_;
};

}  // namespace covaria::ui
