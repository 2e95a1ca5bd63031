// Something varied: an axis of a study (how, from, to, how many values), or a variable of a design (between
// two values, and how well it can be put into effect).
#pragma once

#include <QComboBox>
#include <QGroupBox>
#include <QPushButton>

#include "core/project/study_target.h"
#include "ui/document/unread_texts.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/target_box.h"

namespace covaria::ui {

class StudyAxisEdit : public QGroupBox {
    Q_OBJECT
public:
    using Choices = std::function<std::vector<StudyTargetChoice>()>;
    enum class Use { axis, variable };
    StudyAxisEdit(Choices choices, Use use, std::size_t number, QWidget* parent = nullptr);

    /// `target` is null when it does not exist any more; `only` when it is the only axis.
    void show_axis(const StudyAxis& axis, const StudyTarget* target, bool only);
    /// Shows the tolerance of a variable, in the unit of the axis.
    void show_tolerance(double tolerance);
    void set_complaint(const QString& complaint);
    /// Sets the place of the axis in the project.
    void set_place(UnreadTexts& unread, const TextPlace& place);

signals:
    void edited(const std::function<void(covaria::StudyAxis&)>& edit, const QString& field);
    /// `tolerance`: in the unit of the axis.
    void tolerance_edited(double tolerance);
    void remove_wanted();

private:
    void build();
    void connect_parts();
    void take_end(bool first, const Quantity& quantity);

    TargetBox* target_;
    QComboBox* change_;
    QuantityEdit* from_;
    QuantityEdit* to_;
    QuantityEdit* values_;
    QComboBox* spacing_;
    QuantityEdit* tolerance_;
    QPushButton* remove_;
    Use use_;
    QString title_;
    StudyAxis axis_;
};

}  // namespace covaria::ui
