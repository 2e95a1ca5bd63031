// Editor of a pose: position and three angles, named as the set-up's convention names them.
#pragma once

#include <QLabel>
#include <array>

#include "ui/forms/field_editor.h"
#include "ui/forms/quantity_edit.h"

namespace covaria::ui {

class PoseEditor : public FieldEditor {
    Q_OBJECT
public:
    PoseEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;
    /// "/position/1", "/angles/0".
    void focus_part(const std::string& path) override;

private:
    void collect(std::size_t changed);
    void name_angles();

    const FieldSpec& field_;
    const FieldContext context_;
    std::array<QLabel*, 3> angles_{};

    PoseValue pose_;
    std::array<QuantityEdit*, 6> edits_{};  ///< x, y, z, then the angles
};

}  // namespace covaria::ui
