#include "ui/forms/studies_form.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>
#include <charconv>

#include "ui/document/setup_address.h"
#include "ui/forms/complaint.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/whole_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr std::size_t most_axes = 3;

}  // namespace

StudiesForm::StudiesForm(Document& document, AnalysisRunner& runner, Selection& selection,
                         std::string analysis, QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      analysis_(std::move(analysis)) {
    auto* column = new QVBoxLayout(this);
    build_head();
    build_body();
    column->addStretch(1);
    connect(&document_, &Document::project_changed, this, &StudiesForm::refresh);
    connect(&document_, &Document::problems_changed, this, &StudiesForm::refresh_problems);
    connect(&selection_, &Selection::study_changed, this, &StudiesForm::refresh);
    connect(&runner_, &AnalysisRunner::state_changed, this, [this](const QString& id) {
        if (to_std(id) == analysis_ && study()) refresh_outputs(*study());
    });
    refresh();
}

void StudiesForm::build_head() {
    head_ = new InquiryHead(
        {QStringLiteral("study"), QStringLiteral("studies"), tr("Study"), tr("Adds a study of this analysis"),
         tr("Adds a copy of this study"), tr("Deletes this study"),
         tr("Evaluates the analysis at every grid point of this study"),
         tr("A study evaluates this analysis for many values of a number: a sweep over one, a map "
            "over two or three. Add one to see how the uncertainty depends on the set-up.")});
    layout()->addWidget(head_);
    connect(head_, &InquiryHead::chosen, &selection_, &Selection::select_study);
    connect(head_, &InquiryHead::add_wanted, this, [this] {
        if (const AnalysisEntry* entry = document_.project().find_analysis(analysis_))
            selection_.select_study(
                to_qt(study_list().add(document_, analysis_, new_study(document_.project(), *entry))));
    });
    connect(head_, &InquiryHead::duplicate_wanted, this, [this] {
        if (const Study* shown = study())
            selection_.select_study(to_qt(study_list().duplicate(document_, analysis_, shown->id)));
    });
    connect(head_, &InquiryHead::remove_wanted, this, [this] {
        const Study* shown = study();
        if (!shown) return;
        document_.unread().replace_under({SetupOwner::analysis, analysis_}, "/studies/", {});
        study_list().remove(document_, analysis_, std::string(shown->id));
    });
    connect(head_, &InquiryHead::run_wanted, this, [this] {
        if (const Study* shown = study()) runner_.studies().run(to_qt(analysis_), to_qt(shown->id));
    });
}

void StudiesForm::build_body() {
    body_ = new QWidget;
    auto* column = new QVBoxLayout(body_);
    column->setContentsMargins(0, 0, 0, 0);
    auto* form = new QFormLayout;
    name_ = new QLineEdit;
    name_->setObjectName(QStringLiteral("study_name"));
    name_->setAccessibleName(tr("Name of the study"));
    method_ = new QComboBox;
    method_->setObjectName(QStringLiteral("study_method"));
    method_->setAccessibleName(tr("Method"));
    may_be_narrow(*method_);
    keep_whole(*method_);
    method_->addItem(tr("Law of propagation"), int(Method::first_order));
    method_->addItem(tr("Monte Carlo"), int(Method::monte_carlo));
    trials_ = new QuantityEdit;
    trials_->setObjectName(QStringLiteral("study_trials"));
    trials_->setAccessibleName(tr("Trials at each grid point"));
    trials_->set_integer(true);
    trials_->set_optional(false);
    trials_->set_range({2.0, 1e12});
    for (QLineEdit* edit : {name_, static_cast<QLineEdit*>(trials_)}) keep_letters(*edit);
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Method"), method_);
    form->addRow(tr("Trials per point"), trials_);
    column->addLayout(form);
    axes_ = new QVBoxLayout;
    column->addLayout(axes_);
    add_axis_ = new QPushButton(tr("Add Axis"));
    add_axis_->setObjectName(QStringLiteral("add_axis"));
    add_axis_->setToolTip(tr("Varies one more number: every combination is evaluated"));
    column->addWidget(add_axis_, 0, Qt::AlignLeft);
    build_outputs();
    layout()->addWidget(body_);
    connect(name_, &QLineEdit::editingFinished, this,
            [this] { change([this](Study& s) { s.name = to_std(name_->text()); }, QStringLiteral("name")); });
    connect(method_, &QComboBox::activated, this, [this](int row) {
        change([this, row](Study& s) { s.method = static_cast<Method>(method_->itemData(row).toInt()); });
    });
    connect(trials_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& quantity) {
        const auto trials = static_cast<std::uint64_t>(quantity ? quantity->value : 2.0);
        change([trials](Study& s) { s.trials = trials; }, QStringLiteral("trials"));
    });
    connect(add_axis_, &QPushButton::clicked, this, &StudiesForm::add_axis);
}

void StudiesForm::build_outputs() {
    outputs_ = new OutputTicks;
    outputs_->setObjectName(QStringLiteral("study_outputs"));
    outputs_->setAccessibleName(tr("Output quantities of the study"));
    outputs_->setToolTip(tr("Output quantities looked at; with none ticked, all measurands"));
    auto* title = new QLabel(tr("Outputs (none ticked: all measurands)"));
    title->setWordWrap(true);
    static_cast<QVBoxLayout*>(body_->layout())->addWidget(title);
    static_cast<QVBoxLayout*>(body_->layout())->addWidget(outputs_);
    connect(outputs_, &OutputTicks::ticks_edited, this, [this](const std::vector<StudyOutput>& ticked) {
        change([&](Study& s) { s.outputs = ticked; });
    });
}

const Study* StudiesForm::study() const {
    return study_list().find(document_.project(), analysis_, to_std(selection_.study()));
}

const InputSet* StudiesForm::inputs() const {
    const PreparedPointer& prepared = runner_.status(to_qt(analysis_)).prepared;
    return prepared ? &prepared->inputs : nullptr;
}

void StudiesForm::change(const std::function<void(Study&)>& edit, const QString& merge_key) {
    study_list().change(document_, analysis_, to_std(selection_.study()), edit, merge_key);
}

void StudiesForm::change_axis(std::size_t axis, const std::function<void(StudyAxis&)>& edit,
                              const QString& field) {
    change(
        [&](Study& s) {
            if (axis < s.axes.size()) edit(s.axes[axis]);
        },
        field.isEmpty() ? field : QStringLiteral("axis-%1-%2").arg(axis).arg(field));
}

void StudiesForm::add_axis() {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    const Study* shown = study();
    if (!entry || !shown) return;
    for (const StudyTargetChoice& choice : study_targets(document_.project(), *entry, nullptr)) {
        const bool used = std::any_of(shown->axes.begin(), shown->axes.end(), [&](const StudyAxis& axis) {
            return axis.asset == choice.axis.asset && axis.target == choice.axis.target;
        });
        if (used) continue;
        const StudyAxis axis = choice.axis;
        return change([&axis](Study& s) { s.axes.push_back(axis); });
    }
}

void StudiesForm::refresh_list() {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    // A study is chosen only for the analysis being looked at: that of another one is not this form's to
    // choose (the tab of results would choose back, for ever).
    const bool looked_at = selection_.analysis() == to_qt(analysis_);
    if (entry && looked_at && !entry->studies.empty() && !study())
        selection_.select_study(to_qt(entry->studies.front().id));
    head_->show_items(entry ? &entry->studies : nullptr, selection_.study());
}

void StudiesForm::refresh() {
    refresh_list();
    const Study* shown = study();
    body_->setVisible(shown != nullptr);
    if (!shown) return;
    if (!name_->hasFocus() || name_->text() != to_qt(shown->name)) name_->setText(to_qt(shown->name));
    method_->setCurrentIndex(method_->findData(int(shown->method)));
    trials_->set_place(document_.unread(), place("/trials"));
    if (shown->method != Method::monte_carlo) document_.unread().remove(place("/trials"));
    trials_->set_quantity(Quantity{double(shown->trials), {}});
    trials_->setEnabled(shown->method == Method::monte_carlo);
    forget_axes_from(shown->axes.size());
    refresh_axes(*shown);
    refresh_outputs(*shown);
    refresh_problems();
}

TextPlace StudiesForm::place(const std::string& part) const {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    const Study* shown = study();
    const auto index = entry && shown ? shown - entry->studies.data() : 0;
    return {{SetupOwner::analysis, analysis_}, "/studies/" + std::to_string(index) + part};
}

/// Texts in axes that are gone.
void StudiesForm::forget_axes_from(std::size_t first) {
    for (std::size_t i = first; i < axis_edits_.size(); ++i) {
        const TextPlace gone = place("/axes/" + std::to_string(i) + "/");
        document_.unread().replace_under(gone.entry, gone.part, {});
    }
}

void StudiesForm::add_axis_edit() {
    const std::size_t number = axis_edits_.size();
    auto* edit = new StudyAxisEdit(
        [this]() -> std::vector<StudyTargetChoice> {
            const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
            if (!entry) return {};
            return study_targets(document_.project(), *entry, inputs());
        },
        StudyAxisEdit::Use::axis, number);
    axes_->addWidget(edit);
    axis_edits_.push_back(edit);
    connect(edit, &StudyAxisEdit::edited, this,
            [this, number](const std::function<void(StudyAxis&)>& how, const QString& field) {
                change_axis(number, how, field);
            });
    connect(edit, &StudyAxisEdit::remove_wanted, this, [this, number] {
        change([number](Study& s) {
            if (number < s.axes.size()) s.axes.erase(s.axes.begin() + std::ptrdiff_t(number));
        });
    });
}

void StudiesForm::refresh_axes(const Study& shown) {
    while (axis_edits_.size() < std::min(most_axes, shown.axes.size())) add_axis_edit();
    const AnalysisEntry& entry = *document_.project().find_analysis(analysis_);
    for (std::size_t i = 0; i < axis_edits_.size(); ++i) {
        axis_edits_[i]->setVisible(i < shown.axes.size());
        if (i >= shown.axes.size()) continue;
        axis_edits_[i]->set_place(document_.unread(), place("/axes/" + std::to_string(i)));
        const auto target = find_study_target(document_.project(), entry, inputs(), shown.axes[i]);
        axis_edits_[i]->show_axis(shown.axes[i], target ? &*target : nullptr, shown.axes.size() == 1);
    }
    add_axis_->setVisible(shown.axes.size() < most_axes);
}

void StudiesForm::refresh_outputs(const Study& shown) {
    const PreparedPointer& prepared = runner_.status(to_qt(analysis_)).prepared;
    if (prepared) outputs_->show_outputs(prepared->model->outputs(), shown.outputs);
}

void StudiesForm::refresh_problems() {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    const Study* shown = study();
    if (!entry || !shown) return;
    const std::string prefix = entry_path(document_.project(), {SetupOwner::analysis, analysis_}) +
                               "/studies/" + std::to_string(shown - entry->studies.data()) + "/axes/";
    for (std::size_t i = 0; i < axis_edits_.size(); ++i)
        axis_edits_[i]->set_complaint(problems_below(document_.problems(), prefix + std::to_string(i)));
}

bool StudiesForm::focus_field(const std::string& path) {
    const std::string prefix =
        entry_path(document_.project(), {SetupOwner::analysis, analysis_}) + "/studies/";
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    if (!path.starts_with(prefix) || !entry) return false;
    std::size_t index = 0;
    std::from_chars(path.data() + prefix.size(), path.data() + path.size(), index);
    if (index < entry->studies.size()) selection_.select_study(to_qt(entry->studies[index].id));
    return true;
}

}  // namespace covaria::ui
