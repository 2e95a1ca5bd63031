// The input quantities of an analysis: a table, and below it, in groups that fold, the selected one's
// components, observations and notes, and the correlations.
#pragma once

#include <QSortFilterProxyModel>
#include <QWidget>
#include <string>
#include <vector>

#include "ui/models/input_quantities_model.h"
#include "ui/run/analysis_runner.h"

class QLineEdit;
class QTableView;

namespace covaria::ui {

class ComponentsEdit;
class CorrelationEdit;
class EvaluationView;
class FoldGroups;
class QuantityNotesEdit;
struct LinkChoice;

class InputsPage : public QWidget {
    Q_OBJECT
public:
    InputsPage(Document& document, AnalysisRunner& runner, std::string analysis, QWidget* parent = nullptr);

    /// Shows the page of a quantity; the keyboard stays where it is.
    void show_quantity_of(const std::string& symbol);
    /// Selects the quantity of an edit: "/analyses/0/inputs/3/...". False if the pointer names none.
    bool focus_field(const std::string& path);
    QTableView& table() { return *table_; }
    /// Results of other analyses, of those that are prepared, that the quantity could take its value from.
    std::vector<LinkChoice> link_choices(const std::string& symbol) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum Detail { components, observations, correlations, notes };
    void fit_components();
    void fit_height();
    void show_menu(const QPoint& at);
    void ask_for_link(const std::string& symbol);
    void make_table();
    void take_analysis();
    void show_quantity();
    void show_observations(const std::string& symbol);
    bool select_quantity(const std::string& symbol);

    Document& document_;
    AnalysisRunner& runner_;
    std::string analysis_;
    InputQuantitiesModel model_;
    QSortFilterProxyModel filter_;
    QLineEdit* search_;
    QTableView* table_;
    ComponentsEdit* components_;
    FoldGroups* details_;
    EvaluationView* observations_;
    CorrelationEdit* correlations_;
    QuantityNotesEdit* notes_;
};

}  // namespace covaria::ui
