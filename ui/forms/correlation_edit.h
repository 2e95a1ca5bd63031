// Edits the correlations between components of uncertainty; says at once when they are impossible together.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QWidget>

#include "ui/models/input_correlation_model.h"

namespace covaria::ui {

class CorrelationEdit : public QWidget {
    Q_OBJECT
public:
    explicit CorrelationEdit(Document& document, QWidget* parent = nullptr);
    /// The analysis as it was last prepared.
    void set_analysis(std::shared_ptr<const PreparedAnalysis> analysis);
    /// Gives the focus to the coefficient of two components, or to the matrix.
    void focus_pair(const std::string& first, const std::string& second);
    InputCorrelationModel& model() { return *model_; }
    QTableView& view() { return *view_; }

private:
    void refresh_choices();
    void refresh_state();

    InputCorrelationModel* model_;
    QTableView* view_;
    QComboBox* components_;
    QPushButton* add_;
    QPushButton* remove_;
    QLabel* state_;
};

}  // namespace covaria::ui
