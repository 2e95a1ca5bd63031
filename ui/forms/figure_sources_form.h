// The certificates, reports and data sheets that the figures of an asset or analysis come from, one at a
// time, and whether they are applicable where they are used.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "core/project/asset_certificate_fields.h"
#include "ui/document/document.h"
#include "ui/forms/field_editor.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace covaria::ui {

class MeasuredDate;

/// Follows the document; every edit is one undo step. An analysis has its date of measurement besides.
class FigureSourcesForm : public QWidget {
    Q_OBJECT
public:
    FigureSourcesForm(Document& document, const SetupAddress& entry, QWidget* parent = nullptr);

    /// Gives the focus to the field that a JSON pointer into the project names; false when it names none.
    bool focus_field(const std::string& path);

signals:
    void impact_wanted(const QString& certificate);

private:
    struct Row {
        const AssetCertificateText* text;
        FieldEditor* editor;
    };
    QWidget* make_head();
    QWidget* make_fields();
    void add_field(const AssetCertificateText& text, QWidget* page);
    /// Another certificate is shown: its texts, its verdict, its problems.
    void show_chosen();
    void refresh();          ///< of texts, with every edit
    void refresh_verdict();  ///< with every made project
    void refresh_problems();
    void add_certificate();
    void remove_certificate();
    void read_file();
    void change(const QString& words, const std::function<void(AssetCertificate&)>& edit, const QString& key);
    const std::vector<AssetCertificate>* certificates() const;
    const AssetCertificate* shown() const;
    /// JSON pointer of the list of certificates: "/assets/3/certificates".
    std::string list_path() const;

    Document& document_;
    SetupAddress entry_;
    MeasuredDate* measured_ = nullptr;  ///< null for an asset
    QComboBox* list_;
    QComboBox* kinds_;
    QToolButton *remove_, *file_, *impact_;
    QWidget* fields_;
    QLabel* verdict_;
    std::vector<Row> rows_;
};

}  // namespace covaria::ui
