#include "ui/pages/study_tab.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/text/numbers.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/finish_typing.h"
#include "ui/forms/flow_layout.h"
#include "ui/forms/form_labels.h"
#include "ui/pages/empty_note.h"
#include "ui/pages/side_by_side.h"
#include "ui/pages/sortable_table.h"
#include "ui/theme/document_language.h"
#include "ui/theme/elided_label.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

StudyTab::StudyTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner), selection_(selection) {
    make_head();
    chart_ = new ChartView;
    table_ = new SortableTable(model_, tr("study"));
    body_ = side_by_side(chart_, table_);
    widen_to_content(*body_, *table_);
    what_to_do_ = new EmptyNote;
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(head_);
    column->addWidget(body_, 1);
    column->addWidget(what_to_do_, 1);
    const auto refresh_if_shown = [this](const QString& analysis, const QString& study) {
        if (analysis == selection_.analysis() && study == selection_.study()) refresh();
    };
    connect(&runner_.studies(), &StudyRunner::changed, this, refresh_if_shown);
    connect(&document_, &Document::project_changed, this, &StudyTab::refresh);
    connect(&selection_, &Selection::study_changed, this, &StudyTab::refresh);
    connect(&selection_, &Selection::analysis_changed, this, &StudyTab::refresh);
    refresh();
}

void StudyTab::make_head() {
    head_ = new QWidget;
    auto* around = new QHBoxLayout(head_);
    around->setContentsMargins(4, 2, 4, 2);
    auto* row = new FlowLayout;  // a narrow pane has them in two lines
    around->addLayout(row);
    const auto combo = [](const QString& name, const QString& tip) {
        auto* made = new TypesetComboBox;
        made->setAccessibleName(name);
        made->setToolTip(tip);
        return made;
    };
    list_ = combo(tr("Study"), tr("Study of this analysis"));
    narrow_if_need_be(*list_);
    run_ = new QPushButton(tr("Run Study"));
    edit_ = new QPushButton(tr("Edit …"));
    edit_->setToolTip(tr("Axes, outputs and method of the study, in the properties of the analysis"));
    quantity_ = combo(tr("Quantity of the study"), tr("What the chart and the scene show"));
    kind_ = combo(tr("Kind of chart"), tr("A map, or lines over the first axis"));
    kind_->addItems({tr("Map"), tr("Lines")});
    fixed_ = combo(tr("Axis of the slices"), tr("Which axis the slices are across"));
    for (TypesetComboBox* each : {quantity_, kind_, fixed_}) may_be_narrow(*each);
    slice_ = new QSlider(Qt::Horizontal);
    slice_->setAccessibleName(tr("Slice"));
    slice_->setFixedWidth(110);
    only_slice_ = new QCheckBox(tr("slice only"));
    only_slice_->setToolTip(tr("In the scene: the points of this slice; else all"));
    ellipsoids_ = new QCheckBox(tr("ellipsoids"));
    ellipsoids_->setToolTip(tr("In the scene: coverage ellipsoids at the grid points"));
    state_ = new ElidedLabel;
    state_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);  // else no room in a line
    state_->setMinimumWidth(1);
    for (QWidget* each : std::initializer_list<QWidget*>{list_, run_, edit_, quantity_, kind_, fixed_, slice_,
                                                         only_slice_, ellipsoids_})
        row->addWidget(each);
    row->addWidget(state_);
    connect(list_, &QComboBox::activated, this,
            [this](int index) { selection_.select_study(list_->itemData(index).toString()); });
    connect(run_, &QPushButton::clicked, this, [this] {
        finish_typing();
        if (study_of_project()) runner_.studies().run(selection_.analysis(), selection_.study());
    });
    connect(edit_, &QPushButton::clicked, this, [this] {
        const std::string analysis = to_std(selection_.analysis());
        const AnalysisEntry* entry = document_.project().find_analysis(analysis);
        if (entry && list_->count() == 0) {
            const Study added = new_study(document_.project(), *entry);
            selection_.select_study(to_qt(study_list().add(document_, analysis, added)));
        }
        emit edit_wanted();
    });
    for (QComboBox* each : {quantity_, kind_, fixed_})
        connect(each, &QComboBox::activated, this, &StudyTab::take_view);
    connect(slice_, &QSlider::valueChanged, this, &StudyTab::take_view);
    for (QCheckBox* each : {only_slice_, ellipsoids_})
        connect(each, &QCheckBox::toggled, this, &StudyTab::shown_changed);
}

const Study* StudyTab::study_of_project() const {
    return study_list().find(document_.project(), to_std(selection_.analysis()), to_std(selection_.study()));
}

void StudyTab::refresh_list() {
    const AnalysisEntry* entry = document_.project().find_analysis(to_std(selection_.analysis()));
    const QSignalBlocker blocker(list_);
    list_->clear();
    for (std::size_t i = 0; entry && i < entry->studies.size(); ++i) {
        const Study& study = entry->studies[i];
        list_->addItem(to_qt(study.name.empty() ? study.id : study.name), to_qt(study.id));
    }
    if (entry && !entry->studies.empty() && !study_of_project())
        selection_.select_study(to_qt(entry->studies.front().id));
    list_->setCurrentIndex(list_->findData(selection_.study()));
    list_->setVisible(list_->count() > 0);
    edit_->setEnabled(entry != nullptr);
    edit_->setText(list_->count() > 0 ? tr("Edit …") : tr("Add Study …"));
}

void StudyTab::refresh() {
    refresh_list();
    const StudyStatus status = runner_.studies().status(selection_.analysis(), selection_.study());
    const bool other = status.result != result_;
    result_ = study_of_project() ? status.result : nullptr;
    current_ = status.is_current();
    run_->setVisible(study_of_project() != nullptr);
    run_->setEnabled(status.state != RunState::running);
    state_->setText(state_words());
    state_->setToolTip(state_->text());
    if (other) refresh_choices();
    model_.set_study(result_, current_);
    table_->setVisible(result_ != nullptr);
    table_->set_remark(result_ && !current_ ? tr("Out of date: of the project as it was") : QString());
    show_study();
}

void StudyTab::refresh_choices() {
    const QSignalBlocker quantities(quantity_), fixed(fixed_), slices(slice_);
    const QString before = quantity_->currentText();
    quantity_->clear();
    fixed_->clear();
    if (!result_) return;
    const DocumentLanguage in = language_of_window();
    for (const StudyQuantity& quantity : study_quantities(*result_, in)) quantity_->add_item(quantity.title);
    quantity_->setCurrentIndex(std::max(0, quantity_->findText(before)));
    for (const StudyAxisValues& axis : result_->axes)
        fixed_->add_item(to_std(tr("slice: ")) + axis.title.in(in));
    if (result_->axes.size() == 3) {
        if (view_.fixed_axis > 2 || view_ == StudyView{}) view_.fixed_axis = 2;
        fixed_->setCurrentIndex(int(view_.fixed_axis));
        slice_->setRange(0, int(result_->axes[view_.fixed_axis].values.size()) - 1);
        slice_->setValue(slice_->maximum() / 2);
        view_.slice = std::size_t(slice_->value());
    }
    view_.quantity = std::size_t(std::max(0, quantity_->currentIndex()));
}

void StudyTab::take_view() {
    if (!result_) return;
    view_.quantity = std::size_t(std::max(0, quantity_->currentIndex()));
    view_.lines = kind_->currentIndex() == 1;
    const auto fixed = std::size_t(std::max(0, fixed_->currentIndex()));
    if (result_->axes.size() == 3) {
        const QSignalBlocker blocker(slice_);
        const int last = int(result_->axes[fixed].values.size()) - 1;
        if (fixed != view_.fixed_axis) {
            slice_->setRange(0, last);
            slice_->setValue(last / 2);
        }
        view_.fixed_axis = fixed;
        view_.slice = std::size_t(slice_->value());
    }
    show_study();
}

void StudyTab::show_study() {
    const std::size_t axes = result_ ? result_->axes.size() : 0;
    quantity_->setVisible(axes > 0);
    kind_->setVisible(axes > 1);
    fixed_->setVisible(axes == 3);
    slice_->setVisible(axes == 3);
    only_slice_->setVisible(axes == 3);
    ellipsoids_->setVisible(result_ && !result_->triples.empty());
    PlotSpecification plot;
    body_->setVisible(result_ != nullptr);
    what_to_do_->setVisible(!result_);
    what_to_do_->setText(
        study_of_project()
            ? tr("“%1” shows how the uncertainty depends on what the study varies.").arg(run_->text())
            : tr("A study evaluates the analysis for many values of a number: add one with “%1”.")
                  .arg(edit_->text()));
    if (result_) plot = study_plot(*result_, view_, language_of_window());
    if (result_ && !current_) plot.title += to_std(tr(" – out of date"));
    chart_->set_plot(std::move(plot));
    emit shown_changed();
}

QString StudyTab::state_words() const {
    const StudyStatus status = runner_.studies().status(selection_.analysis(), selection_.study());
    if (!study_of_project()) return {};
    if (status.state == RunState::running) return tr("running …");
    if (status.state == RunState::failed) return tr("Failed: %1").arg(status.message);
    if (!status.result) return tr("Not evaluated yet.");
    const std::size_t failed = status.result->failed();
    QString words = tr("%1 grid points").arg(to_qt(count_text(status.result->points.size())));
    if (failed > 0) words += tr(", %1 without values").arg(to_qt(count_text(failed)));
    return status.is_current() ? words : tr("<b>Out of date</b>: shown for the project as it was. ") + words;
}

}  // namespace covaria::ui
