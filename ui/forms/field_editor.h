// The editor of one field of a set-up: a widget per kind of field, all behind one interface.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/setup/setup_schema.h"
#include "ui/document/document.h"
#include "ui/document/setup_address.h"

namespace covaria::ui {

class FieldEditor : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;
    /// Shows the value the project has (given or default).
    virtual void set_value(const SetupValue& value) = 0;
    /// Problems of the field, in words; empty: none.
    virtual void set_complaint(const QString& complaint) = 0;
    /// Sets the text that an empty field shows.
    virtual void set_hint(const QString&) {}
    /// Sets the places of problems within the field: JSON pointers relative to it ("/2/14-16").
    virtual void set_problem_places(const std::vector<std::string>&) {}
    /// Gives the focus to the field, or the part of it a JSON pointer relative to the field names.
    virtual void focus_part(const std::string& path);
    /// Takes the whole width of the form, under its title.
    virtual bool is_wide() const { return false; }

signals:
    /// The user gave another value; monostate: none.
    void edited(const covaria::SetupValue& value);
    /// The user went to a part of the field: JSON pointer relative to it ("/rows/2").
    void part_selected(const QString& part);
};

/// The document, entry and schema that a field belongs to.
struct FieldContext {
    Document& document;
    SetupAddress address;
    const SetupSchema* schema;
};

/// The editor for the field's kind. This is the one place that knows all kinds.
FieldEditor* make_field_editor(const FieldSpec& field, const FieldContext& context, QWidget* parent);

/// Tooltip: the field's help with its unit and range.
QString help_text(const FieldSpec& field);

}  // namespace covaria::ui
