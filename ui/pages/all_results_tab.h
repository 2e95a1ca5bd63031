// The results of all analyses at once: filter, what is not met, and the way to each.
#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/models/all_results_model.h"
#include "ui/run/analysis_runner.h"

class QCheckBox;
class QLabel;
class QLineEdit;

namespace covaria::ui {

class SortableTable;

class AllResultsTab : public QWidget {
    Q_OBJECT
public:
    AllResultsTab(Document& document, AnalysisRunner& runner, QWidget* parent = nullptr);

    SortableTable& table() { return *table_; }
    QLineEdit& filter() { return *filter_; }
    QCheckBox& only_not_met() { return *only_not_met_; }
    /// "12 of 14 requirements met; 1 of 3 analyses without a result".
    QLabel& count() { return *count_; }
    void set_units(const DisplayUnits& units) { model_.set_units(units); }
    void set_digits(int digits) { model_.set_digits(digits); }

signals:
    void result_wanted(const QString& analysis, const QString& group, int output);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void refresh();
    QString count_words(const std::vector<ShownAnalysis>& analyses) const;

    Document& document_;
    AnalysisRunner& runner_;
    AllResultsModel model_;
    SortableTable* table_ = nullptr;
    QLineEdit* filter_ = nullptr;
    QCheckBox* only_not_met_ = nullptr;
    QLabel* count_ = nullptr;
};

}  // namespace covaria::ui
