// The studies of an analysis: which one, its axes, the outputs looked at, the method.
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "ui/document/inquiry_edits.h"
#include "ui/document/selection.h"
#include "ui/forms/inquiry_head.h"
#include "ui/forms/output_ticks.h"
#include "ui/forms/study_axis_edit.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

class StudiesForm : public QWidget {
    Q_OBJECT
public:
    StudiesForm(Document& document, AnalysisRunner& runner, Selection& selection, std::string analysis,
                QWidget* parent = nullptr);
    /// `path`: "/analyses/0/studies/1/axes/0/target". False: it is not of a study.
    bool focus_field(const std::string& path);

private:
    void build_head();
    void build_body();
    void build_outputs();
    void refresh();
    void refresh_list();
    void refresh_axes(const Study& study);
    void refresh_outputs(const Study& study);
    void refresh_problems();
    void add_axis_edit();
    void add_axis();
    void change(const std::function<void(Study&)>& edit, const QString& merge_key = {});
    void change_axis(std::size_t axis, const std::function<void(StudyAxis&)>& edit, const QString& field);
    void forget_axes_from(std::size_t first);
    TextPlace place(const std::string& part) const;
    const Study* study() const;
    const InputSet* inputs() const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    std::string analysis_;
    InquiryHead* head_ = nullptr;
    QWidget* body_ = nullptr;
    QLineEdit* name_ = nullptr;
    QComboBox* method_ = nullptr;
    QuantityEdit* trials_ = nullptr;
    QVBoxLayout* axes_ = nullptr;
    std::vector<StudyAxisEdit*> axis_edits_;
    QPushButton* add_axis_ = nullptr;
    OutputTicks* outputs_ = nullptr;
};

}  // namespace covaria::ui
