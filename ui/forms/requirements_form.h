// The requirements of an analysis, one result at a time: target uncertainty, tolerance, decision rule, prior;
// and what the present result says about them.
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/project/requirement_fields.h"
#include "core/propagation/reverse_budget.h"
#include "core/text/display_units.h"
#include "ui/document/document.h"
#include "ui/forms/quantity_edit.h"
#include "ui/run/analysis_runner.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {

class RequirementsForm : public QWidget {
    Q_OBJECT
public:
    RequirementsForm(Document& document, AnalysisRunner& runner, std::string analysis,
                     QWidget* parent = nullptr);
    ~RequirementsForm() override;
    /// Sets the units in which results are shown, and in which a number without a unit is typed.
    void set_units(const DisplayUnits& units);
    /// `path`: "/analyses/0/requirements/1/lowerLimit". False: it is not of a requirement.
    bool focus_field(const std::string& path);

    TypesetComboBox* outputs() const { return outputs_; }
    QLabel* verdict() const { return verdict_; }

signals:
    /// JSON pointer: where a component that could be reduced is stated.
    void place_wanted(const QString& path);

private:
    struct Row {
        const RequirementField& field;
        QuantityEdit* edit;
    };
    /// A target that is not met, for which the reverse budget is sought.
    struct Sought {
        ResultPointer result;
        std::size_t output = 0;
        double target = 0.0;
        bool operator==(const Sought&) const = default;
    };
    void add_row(const RequirementField& field);
    void add_choice(const RequirementField& field);
    void refresh();
    void refresh_outputs();
    void refresh_values();
    void refresh_problems();
    void refresh_verdict();
    QString reductions(const AnalysisStatus& status, const RequirementResult& r);
    const OutputQuantity* output() const;
    const Requirement* requirement() const;
    void change(const std::string& key, const std::function<void(Requirement&)>& edit);

    Document& document_;
    AnalysisRunner& runner_;
    std::string analysis_;
    DisplayUnits units_;
    QFormLayout* layout_;
    TypesetComboBox* outputs_;
    QLabel* verdict_;
    QComboBox* rules_ = nullptr;  ///< the kinds of guard bands
    std::vector<Row> rows_;
    std::vector<OutputQuantity> known_;
    Sought sought_;
    std::optional<ReverseBudget> found_;  ///< belongs to `sought_`
    std::stop_source search_;
    JobQueue jobs_;
};

}  // namespace covaria::ui
