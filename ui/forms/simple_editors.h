// Editors of fields that hold one value: number, integer, choice, text, flag, reference.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>

#include "ui/forms/field_editor.h"
#include "ui/forms/quantity_edit.h"

namespace covaria::ui {

class NumberEditor : public FieldEditor {
    Q_OBJECT
public:
    NumberEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override { edit_->set_complaint(complaint); }

private:
    QuantityEdit* edit_;
};

class TextEditor : public FieldEditor {
    Q_OBJECT
public:
    TextEditor(const FieldSpec& field, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;
    void set_hint(const QString& hint) override { edit_->setPlaceholderText(hint); }
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show_text(bool as_typed);

    std::string key_, text_;
    QLineEdit* edit_;
    QString help_;
};

class FlagEditor : public FieldEditor {
    Q_OBJECT
public:
    FlagEditor(const FieldSpec& field, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;

private:
    QCheckBox* box_;
    QString help_;
};

/// A list to choose from; a value that is not in it is shown as such, not replaced.
class ListEditor : public FieldEditor {
    Q_OBJECT
public:
    ListEditor(const FieldSpec& field, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;

protected:
    virtual std::vector<Choice> choices() const;
    virtual QString empty_words() const;
    /// Titles of a field's choices are words of ours, translated; names of a project's assets are not.
    virtual QString words_of(const Choice& choice) const;
    const FieldSpec& field() const { return field_; }

private:
    /// A narrow form cuts them; the list and the tooltip do not.
    void show_whole_texts();

    FieldSpec field_;
    QComboBox* box_;
    QString help_;
};

/// Assets of the project that can do what the field asks for.
class ReferenceEditor : public ListEditor {
    Q_OBJECT
public:
    ReferenceEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent);

protected:
    std::vector<Choice> choices() const override;
    QString empty_words() const override;
    QString words_of(const Choice& choice) const override;

private:
    Document& document_;
    SetupAddress address_;
};

}  // namespace covaria::ui
