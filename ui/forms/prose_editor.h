// Editor of a text of several lines for people: an address, a method.
#pragma once

#include <QPlainTextEdit>

#include "ui/forms/field_editor.h"

namespace covaria::ui {

/// A field for several lines, as high as its text needs, within bounds.
class ProseEditor : public FieldEditor {
    Q_OBJECT
public:
    ProseEditor(const FieldSpec& field, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;
    void set_hint(const QString& hint) override { edit_->setPlaceholderText(hint); }

protected:
    void resizeEvent(QResizeEvent*) override { adapt_height(); }

private:
    void adapt_height();

    QPlainTextEdit* edit_;
    QString help_;
};

}  // namespace covaria::ui
