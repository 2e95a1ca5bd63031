// Tables and charts of an evaluation side by side: of an asset, or of a model's set-up.
#pragma once

#include <QWidget>
#include <vector>

#include "core/text/plot_specification.h"

class QComboBox;
class QTextBrowser;

namespace covaria::ui {

class ChartView;

/// Tables of an evaluation and its charts; without charts the tables have the whole room.
class EvaluationView : public QWidget {
    Q_OBJECT
public:
    explicit EvaluationView(Qt::Orientation orientation, QWidget* parent = nullptr);

    /// `html`: the tables, or what to say where there are none. Keeps what is being looked at.
    void show_evaluation(const QString& html, std::vector<PlotSpecification> figures);
    QComboBox& chart_list() { return *list_; }
    ChartView& chart() { return *chart_; }
    QTextBrowser& text() { return *text_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void take_theme();
    void show_chart();

    QTextBrowser* text_;
    QWidget* charts_;
    QComboBox* list_;
    ChartView* chart_;
    std::vector<PlotSpecification> figures_;
};

}  // namespace covaria::ui
