// The name of a file: typed, or chosen. One beside the project is named relative to it.
#pragma once

#include <QLineEdit>

#include "ui/forms/field_editor.h"

namespace covaria::ui {

class FileEditor : public FieldEditor {
    Q_OBJECT
public:
    /// `filter`: what the dialog offers, "Pictures (*.png)".
    FileEditor(const FieldSpec& field, Document& document, QString filter, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;
    void set_hint(const QString& hint) override { edit_->setPlaceholderText(hint); }
    /// Takes the file over as if it were chosen in the dialog.
    void choose(const QString& file);

private:
    void ask();

    Document& document_;
    QString filter_;
    QLineEdit* edit_;
    QString title_, help_;
};

}  // namespace covaria::ui
