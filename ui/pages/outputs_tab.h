// The results of an analysis: a row for each output quantity, and above them a filter and what is required.
#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/models/result_table_model.h"
#include "ui/run/run_backend.h"

class QCheckBox;
class QHBoxLayout;
class QLineEdit;
class QSpinBox;

namespace covaria::ui {

class SortableTable;
class UnitButton;

class OutputsTab : public QWidget {
    Q_OBJECT
public:
    /// `units` and `digits` stand at the right of the filter.
    OutputsTab(Document& document, Selection& selection, UnitButton& units, QSpinBox& digits,
               QWidget* parent = nullptr);

    void set_result(const ResultPointer& result, bool current);
    /// Judges the result by the requirements as they are now.
    void take_requirements();
    void take_units();
    /// Shows the rows of the group looked at, or all of them.
    void take_group();
    void select_output(std::size_t output);
    /// Group that is shown; empty: all.
    QString shown_group() const;

    ResultTableModel& model() { return model_; }
    SortableTable& table() { return *table_; }
    /// Field above the table that filters its rows.
    QLineEdit& filter() { return *filter_; }
    QCheckBox& only_not_met() { return *only_not_met_; }
    QCheckBox& all_groups() { return *all_groups_; }

signals:
    /// Another group is shown than before, or all of them.
    void shown_group_changed();

private:
    QWidget* make_filter(QSpinBox& digits);
    void make_table();
    void take_filter();
    std::vector<std::size_t> selected_outputs() const;
    void require_of_selected();

    Document& document_;
    Selection& selection_;
    UnitButton& units_;
    ResultPointer result_;
    bool current_ = true;
    bool shortest_ = false;  ///< coverage intervals, else probabilistically symmetric ones
    ResultTableModel model_;
    SortableTable* table_;
    QLineEdit* filter_;
    QCheckBox *only_not_met_, *all_groups_;
};

}  // namespace covaria::ui
