// The designs of an analysis: which one, what may be chosen, what for, under which conditions.
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "core/project/design_check.h"
#include "ui/document/inquiry_edits.h"
#include "ui/document/selection.h"
#include "ui/forms/design_box_list.h"
#include "ui/forms/design_reduction_list.h"
#include "ui/forms/inquiry_head.h"
#include "ui/forms/output_ticks.h"
#include "ui/forms/study_axis_edit.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

class DesignsForm : public QWidget {
    Q_OBJECT
public:
    DesignsForm(Document& document, AnalysisRunner& runner, Selection& selection, std::string analysis,
                QWidget* parent = nullptr);
    /// `path`: "/analyses/0/designs/1/choose/keep". False: it is not of a design.
    bool focus_field(const std::string& path);

private:
    void build_head();
    void build_body();
    void build_goal(QVBoxLayout& column);
    void build_choice(QVBoxLayout& column);
    void build_space(QVBoxLayout& column);
    void build_reductions(QVBoxLayout& column);
    void build_search(QVBoxLayout& column);
    QLineEdit* build_prices();
    QLineEdit* build_seed();
    std::vector<StudyTargetChoice> targets() const;
    QString title_of(const StudyAxis& number) const;
    QuantityEdit* whole_number(const char* name, const QString& title, double least,
                               std::function<void(Design&, double)> set);
    void refresh();
    void refresh_variables(const Design& shown);
    void refresh_choice(const Design& shown);
    void refresh_reductions(const Design& shown);
    void refresh_problems();
    void add_variable_edit();
    void add_variable();
    void take_fixed();
    void change(const std::function<void(Design&)>& edit, const QString& merge_key = {});
    void change_variable(std::size_t variable, const std::function<void(DesignVariable&)>& edit,
                         const QString& field);
    TextPlace place(const std::string& part) const;
    const AnalysisEntry* entry() const { return document_.project().find_analysis(analysis_); }
    const Design* design() const;
    const PreparedAnalysis* prepared() const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    std::string analysis_;
    InquiryHead* head_ = nullptr;
    QWidget* body_ = nullptr;
    QLineEdit* name_ = nullptr;
    QComboBox* objective_ = nullptr;
    OutputTicks* outputs_ = nullptr;
    QVBoxLayout* variables_ = nullptr;
    std::vector<StudyAxisEdit*> variable_edits_;
    QComboBox* table_ = nullptr;
    QuantityEdit* keep_ = nullptr;
    QLineEdit* candidates_ = nullptr;
    QListWidget* fixed_ = nullptr;
    QuantityEdit* least_distance_ = nullptr;
    QLineEdit *prices_ = nullptr, *seed_ = nullptr;
    DesignBoxList *keep_out_ = nullptr, *hidden_by_ = nullptr;
    DesignReductionList* reductions_ = nullptr;
    std::vector<std::pair<QuantityEdit*, std::function<double(const Design&)>>> numbers_;
    std::vector<DesignTableOffer> offers_;
};

}  // namespace covaria::ui
