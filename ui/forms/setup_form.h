// The form of a set-up, made from its schema.
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QWidget>
#include <map>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/setup_address.h"
#include "ui/forms/field_editor.h"

namespace covaria::ui {

class FoldGroups;

/// Follows the document; every edit is one undo step, typing in one field merges. When the entry is removed
/// the form stays empty of use: its owner deletes it. The first section is open, and those that lack
/// something.
class SetupForm : public QWidget {
    Q_OBJECT
public:
    SetupForm(Document& document, SetupAddress address, QWidget* parent = nullptr);
    /// Takes a schema that lives longer than the form, instead of the registered one.
    SetupForm(Document& document, SetupAddress address, const SetupSchema* schema, QWidget* parent = nullptr);

    const SetupAddress& address() const { return address_; }
    /// Null when the schema has no such field.
    FieldEditor* editor(const std::string& key) const;
    /// Gives the focus to the field a JSON pointer names: into the project ("/assets/0/setup/alpha") or
    /// relative to the set-up ("/alpha"). False when it names none of the form.
    bool focus_field(const std::string& path);
    /// Gives the focus to the first field that is shown.
    void focus_first();

signals:
    /// The user went to a part of the form: JSON pointer relative to the set-up ("/points/rows/2").
    void part_selected(const QString& path);

private:
    struct Row {
        const FieldSpec* field;
        FieldEditor* editor;
        QWidget* head;  ///< the title of a wide editor; null: it stands beside the editor
        std::size_t section;
    };
    /// Fields that belong together: a form in a group that folds.
    struct Section {
        int group;
        QFormLayout* form;
    };
    void build();
    void add_field(const FieldSpec& field);
    void add_section(const QString& title);
    void refresh();
    void refresh_problems();
    void say_what_is_taken();
    void forget_unread(const std::string& part);
    void write(const FieldSpec& field, const SetupValue& value);

    Document& document_;
    SetupAddress address_;
    const SetupSchema* schema_;
    FoldGroups* groups_;
    QLabel* taken_;  ///< names the quantities that other analyses give in place of this set-up
    std::vector<Row> rows_;
    std::vector<Section> sections_;
};

}  // namespace covaria::ui
