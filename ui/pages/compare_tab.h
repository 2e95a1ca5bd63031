// Results that were kept beside those of now: U beside U, what of the budget changed, and the way back.
#pragma once

#include <QAction>
#include <QWidget>
#include <functional>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/models/compared_table_models.h"
#include "ui/run/analysis_runner.h"

class QComboBox;
class QLabel;
class QMenu;

namespace covaria::ui {

class ChartView;
class EmptyNote;
class SortableTable;

class CompareTab : public QWidget {
    Q_OBJECT
public:
    CompareTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

    /// Adds the actions: keep, compare with, go back, discard.
    void add_to(QMenu& menu);
    QString state_words() const;
    SortableTable& results() { return *results_; }
    SortableTable& budget() { return *budget_; }
    ChartView& chart() { return *chart_; }
    QComboBox& chart_list() { return *chart_list_; }
    void set_units(const DisplayUnits& units);
    void set_digits(int digits);
    const KeptStates& kept() const { return kept_; }
    /// The menu of analyses to put in place of the kept results: one of this project, or one of a file,
    /// which is asked for where that has several.
    QMenu& others() { return *others_; }
    /// Dialogs, replaceable in tests; an empty text: none was chosen.
    std::function<QString()> ask_for_file;
    std::function<QString(const QStringList& analyses)> ask_for_analysis;

signals:
    void message(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void make_actions();
    QWidget* make_head();
    QWidget* make_body();
    void connect_parts();
    void update_actions();
    void refresh();
    void show_output();
    void show_chart();
    void keep();
    void list_others();
    void compare_with_file();
    void compare_with(const Project& project, const std::string& other, const QString& name);
    void go_back();
    bool can_go_back() const;
    /// Index, among the outputs compared, of the one that is selected.
    std::optional<std::size_t> selected() const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    KeptStates& kept_;
    ComparedResultsModel results_model_;
    ComparedBudgetModel budget_model_;
    ComparisonPointer comparison_;
    bool current_ = true;
    DisplayUnits units_;
    QMenu* others_ = nullptr;
    QAction *keep_ = nullptr, *go_back_ = nullptr, *discard_ = nullptr;
    QLabel* state_ = nullptr;
    EmptyNote* what_to_do_ = nullptr;  ///< in the place of the body while nothing is compared
    QWidget* body_ = nullptr;
    SortableTable* results_ = nullptr;
    SortableTable* budget_ = nullptr;
    QComboBox* chart_list_ = nullptr;
    ChartView* chart_ = nullptr;
};

}  // namespace covaria::ui
