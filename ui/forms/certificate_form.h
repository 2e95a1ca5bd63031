// The form of the certificate, made from the one declaration of its fields.
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "core/project/certificate.h"
#include "ui/document/document.h"
#include "ui/forms/field_editor.h"

namespace covaria::ui {

class FoldGroups;

/// Follows the document; every edit is one undo step, typing in one field merges. What ISO/IEC 17025 requires
/// and is not stated yet is counted above the fields, and its clause stands in the empty field. Sections in
/// which nothing is missing are folded to a count.
class CertificateForm : public QWidget {
    Q_OBJECT
public:
    explicit CertificateForm(Document& document, QWidget* parent = nullptr);

    /// Gives the focus to the field a JSON pointer into the project names; false when it names none.
    bool focus_field(const std::string& path);
    void focus_next_missing();

private:
    struct Row {
        const CertificateField* field;
        FieldEditor* editor;
        int group;
    };
    void add_head();
    void add_section(const CertificateSection& section);
    void add_field(QFormLayout& form, const CertificateField& field);
    FieldEditor* make_editor(const CertificateField& field, QWidget* page);
    void count_stated();
    void write(const CertificateField& field, const std::string& text);
    void refresh();
    void refresh_state();  ///< counts the missing fields, those that only the made project knows included
    void refresh_problems();

    Document& document_;
    FoldGroups* groups_;  ///< a section each, below what is missing and the way to it
    QLabel* state_;
    QPushButton* next_;
    std::vector<Row> rows_;
};

}  // namespace covaria::ui
