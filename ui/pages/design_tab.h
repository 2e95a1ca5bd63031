// Findings of a design: tables, charts, and the edit that puts them into the project.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ui/document/file_watch.h"
#include "ui/document/inquiry_edits.h"
#include "ui/document/selection.h"
#include "ui/run/analysis_runner.h"

class QComboBox;

namespace covaria::ui {

class EmptyNote;
class EvaluationView;

class DesignTab : public QWidget {
    Q_OBJECT
public:
    DesignTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

    EvaluationView& view() { return *view_; }
    QString state_words() const;
    /// The result shown; null before the design was searched.
    const DesignPointer& result() const { return shown_; }
    bool is_current() const { return current_; }

signals:
    /// Another result is shown, or it has become out of date.
    void shown_changed();
    /// The user wants to change the designs of the analysis.
    void edit_wanted();

private:
    void make_head();
    void refresh();
    void refresh_list();
    void watch_candidates();
    void show_result();
    void show_progress(const RunProgress& progress);
    void take_over_design();
    const Design* design_of_project() const;
    DesignStatus status() const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    DesignPointer shown_;
    bool current_ = false;
    FileWatch candidates_;  ///< the file of further rows
    QWidget* head_ = nullptr;
    QComboBox* list_ = nullptr;
    QPushButton *run_ = nullptr, *stop_ = nullptr, *edit_ = nullptr, *take_over_ = nullptr;
    QLabel* state_ = nullptr;
    EvaluationView* view_ = nullptr;
    EmptyNote* what_to_do_ = nullptr;  ///< in place of the view
};

}  // namespace covaria::ui
