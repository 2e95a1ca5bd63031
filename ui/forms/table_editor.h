// Editor of a table field: the spreadsheet with its tools and import.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <vector>

#include "ui/forms/field_editor.h"
#include "ui/forms/spreadsheet_view.h"
#include "ui/models/setup_table_model.h"

namespace covaria::ui {

class RowTools;

class TableEditor : public FieldEditor {
    Q_OBJECT
public:
    TableEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent);
    /// The model follows the document by itself.
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;
    void focus_part(const std::string& path) override;
    bool is_wide() const override { return true; }

    SetupTableModel& model() { return *model_; }
    SpreadsheetView& view() { return *view_; }
    /// Buttons for rows and import. Whoever takes them puts them into the head of the table.
    QWidget* take_tools();
    /// Asks for a file, shows the preview, replaces the table.
    void import_csv();

private:
    void choose_unit(int column, const QPoint& position);
    /// Hides columns for the seventh joint, say, of a table whose arms have six, unless all are asked for.
    void hide_unused_columns();

    FieldSpec field_;
    SetupTableModel* model_;
    SpreadsheetView* view_;
    RowTools* tools_;
    QLabel* note_;
    QLabel* origin_;  ///< names the file that a linked table is read from
    QPushButton* embed_;
    QPushButton* all_columns_;
    std::vector<std::vector<int>> numbered_;  ///< columns q_1, q_2 ... that rows need not have
    QString complaint_;
};

}  // namespace covaria::ui
