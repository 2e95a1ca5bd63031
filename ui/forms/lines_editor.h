// Editor of a text of several lines (equations): marks the places that problems name.
#pragma once

#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>

#include "ui/forms/field_editor.h"

namespace covaria::ui {

class LinesEditor : public FieldEditor {
    Q_OBJECT
public:
    LinesEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;
    void set_problem_places(const std::vector<std::string>& places) override;
    void focus_part(const std::string& path) override;
    bool is_wide() const override { return true; }

    QPlainTextEdit* text_edit() const { return edit_; }
    QPushButton* completion_button() const { return complete_; }

protected:
    /// Adds rows for the names that were typed as soon as the editor is left.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void adapt_height();
    void refresh_completion();
    void complete();

    Document& document_;
    SetupAddress address_;
    QPlainTextEdit* edit_;
    QLabel* message_;
    QPushButton* complete_;
    QString default_;
    QString help_;
    bool typed_ = false;  ///< since the editor was entered
};

}  // namespace covaria::ui
