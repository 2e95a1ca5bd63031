// A study's results: chart or map, table, what is shown of it.
#pragma once

#include <QCheckBox>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "core/views/study_plots.h"
#include "ui/document/inquiry_edits.h"
#include "ui/document/selection.h"
#include "ui/models/study_table_model.h"
#include "ui/run/analysis_runner.h"
#include "ui/theme/typeset_views.h"

class QLabel;
class QSplitter;

namespace covaria::ui {

class ChartView;
class EmptyNote;
class SortableTable;

class StudyTab : public QWidget {
    Q_OBJECT
public:
    StudyTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

    ChartView& chart() { return *chart_; }
    SortableTable& table() { return *table_; }
    /// The study shown, current or not; null when there is none.
    const StudyPointer& study() const { return result_; }
    bool is_current() const { return current_; }
    const StudyView& view() const { return view_; }
    QString state_words() const;
    /// Shows the study anew, with numbers in their present form.
    void show_study();
    /// Choices about what the scene shows of the study.
    bool wants_ellipsoids() const { return ellipsoids_->isChecked(); }
    bool wants_slice() const { return only_slice_->isChecked(); }

signals:
    /// Another study is shown, or another part of it.
    void shown_changed();
    /// The user wants to change the studies of the analysis.
    void edit_wanted();

private:
    void make_head();
    void refresh();
    void refresh_list();
    void refresh_choices();
    void take_view();
    const Study* study_of_project() const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    StudyTableModel model_;
    StudyPointer result_;
    bool current_ = false;
    StudyView view_;
    QWidget* head_ = nullptr;
    TypesetComboBox* list_ = nullptr;
    QPushButton* run_ = nullptr;
    QPushButton* edit_ = nullptr;
    TypesetComboBox* quantity_ = nullptr;
    TypesetComboBox* kind_ = nullptr;
    TypesetComboBox* fixed_ = nullptr;
    QSlider* slice_ = nullptr;
    QCheckBox* only_slice_ = nullptr;
    QCheckBox* ellipsoids_ = nullptr;
    QLabel* state_ = nullptr;
    QSplitter* body_ = nullptr;
    EmptyNote* what_to_do_ = nullptr;  ///< in place of the body
    ChartView* chart_ = nullptr;
    SortableTable* table_ = nullptr;
};

}  // namespace covaria::ui
