#include "ui/pages/properties_pane.h"

#include <QApplication>
#include <QLabel>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "ui/document/setup_address.h"
#include "ui/forms/bring_into_view.h"
#include "ui/forms/certificate_form.h"
#include "ui/forms/designs_form.h"
#include "ui/forms/figure_sources_form.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/help_place.h"
#include "ui/forms/options_form.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/report_form.h"
#include "ui/forms/requirements_form.h"
#include "ui/forms/review_form.h"
#include "ui/forms/scrolled.h"
#include "ui/forms/setup_form.h"
#include "ui/forms/spreadsheet_view.h"
#include "ui/forms/studies_form.h"
#include "ui/pages/asset_evaluation.h"
#include "ui/pages/asset_uses.h"
#include "ui/pages/field_help.h"
#include "ui/pages/inputs_page.h"
#include "ui/pages/inspector_head.h"
#include "ui/pages/notes_page.h"
#include "ui/pages/project_page.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int certificate_group = 1;  // its place among the groups of the project

/// Group of an analysis in which a JSON pointer into the project is edited; nullopt: its set-up.
std::optional<AnalysisGroup> group_of_place(const std::string& path, const std::string& entry) {
    static constexpr std::array<std::pair<const char*, AnalysisGroup>, 9> places{
        {{"/inputs", inputs_group},
         {"/links", inputs_group},
         {"/correlations", inputs_group},
         {"/options", options_group},
         {"/studies", studies_group},
         {"/designs", designs_group},
         {"/requirements", requirements_group},
         {"/measured", certificates_group},
         {"/certificates", certificates_group}}};
    for (const auto& [key, group] : places)
        if (path.starts_with(entry + key)) return group;
    return std::nullopt;
}

/// Text where no entry is selected.
QString hint_in(const Project& project) {
    return project.assets.empty() && project.analyses.empty()
               ? PropertiesPane::tr(
                     "The project is empty. Add an analysis, or first what it uses, with the "
                     "plus sign above or a right click in the project tree.")
               : PropertiesPane::tr("Select an entry of the project tree to see its properties.");
}

QLabel* new_hint(const Project& project) {
    auto* hint = new QLabel(hint_in(project));
    hint->setWordWrap(true);
    hint->setMargin(16);
    hint->setAlignment(Qt::AlignTop);
    hint->setEnabled(false);
    return hint;
}

ReviewForm* add_review(Document& document, FoldGroups& groups) {
    auto* form = new ReviewForm(document);
    set_help_place(*form, QStringLiteral("release-review-and-release"));
    const int group = groups.add(form, PropertiesPane::tr("Review"));
    QObject::connect(form, &ReviewForm::summary_changed, &groups,
                     [&groups, group](const QString& words) { groups.set_summary(group, words); });
    form->show_state();
    return form;
}

void add_uses(Document& document, Selection& selection, const std::string& asset, FoldGroups& groups) {
    auto* uses = new AssetUses(document, selection, asset);
    const int group = groups.add(uses, PropertiesPane::tr("What can be evaluated with it"), true);
    groups.set_shown(group, false);
    QObject::connect(uses, &AssetUses::offered, &groups,
                     [&groups, group](bool any) { groups.set_shown(group, any); });
}

}  // namespace

PropertiesPane::PropertiesPane(Document& document, AnalysisRunner& runner, Selection& selection,
                               QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      head_(new InspectorHead(document, selection)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    help_ = new FieldHelp(*this);
    column->addWidget(help_);
    connect(&selection_, &Selection::entry_changed, this, &PropertiesPane::rebuild);
    connect(&document_, &Document::project_changed, this, &PropertiesPane::discard_if_gone);
    connect(&document_, &Document::project_changed, this, [this] { summarise(); });
    connect(&runner_, &AnalysisRunner::state_changed, this, &PropertiesPane::show_forecast);
    connect(&selection_, &Selection::field_changed, this, &PropertiesPane::follow_field);
    rebuild();
}

void PropertiesPane::rebuild() {
    help_->start_over();
    delete area_;
    forms_ = {};
    groups_ = new FoldGroups;
    const SetupAddress& entry = selection_.entry();
    if (entry.owner == SetupOwner::project)
        add_project_pages();
    else if (find_setup(document_.project(), entry))
        add_entry_pages(entry);
    else
        groups_->add(hint_ = new_hint(document_.project()), {});
    wrap_labels(*groups_);
    put_long_fields_below(*groups_);
    area_ = scrolled(groups_);
    static_cast<QVBoxLayout*>(layout())->insertWidget(0, area_, 1);
    connect(groups_, &FoldGroups::opened, this, &PropertiesPane::start_help);
    summarise();
}

void PropertiesPane::add_entry_pages(const SetupAddress& entry) {
    forms_.setup = new SetupForm(document_, entry);
    set_help_place(*this, help_anchor(document_.project(), entry));
    connect(forms_.setup, &SetupForm::part_selected, this, [this](const QString& path) {
        following_ = true;
        selection_.select_field(path);
        following_ = false;
    });
    if (entry.owner == SetupOwner::asset) add_uses(document_, selection_, entry.id, *groups_);
    groups_->add(forms_.setup, {});
    if (entry.owner == SetupOwner::asset)
        groups_->add(new AssetEvaluation(document_, entry.id), tr("Evaluation"));
    else
        add_analysis_pages(entry);
    forms_.sources = new FigureSourcesForm(document_, entry);
    connect(forms_.sources, &FigureSourcesForm::impact_wanted, this, &PropertiesPane::impact_wanted);
    set_help_place(*forms_.sources, QStringLiteral("results-certificates-of-the-figures"));
    groups_->add(forms_.sources, tr("Certificates"));
    groups_->add(new NotesPage(document_, entry), tr("Notes"));
}

/// Ends the help on a field of a group that was left.
void PropertiesPane::start_help() {
    const QWidget* focused = QApplication::focusWidget();
    if (focused && groups_->isAncestorOf(focused)) return;
    const auto shows = [this](const auto& editors) {
        return std::any_of(editors.begin(), editors.end(),
                           [this](const QWidget* editor) { return editor->isVisibleTo(groups_); });
    };
    help_->start_over(shows(groups_->findChildren<QuantityEdit*>()) ||
                      shows(groups_->findChildren<SpreadsheetView*>()));
}

void PropertiesPane::set_units(const DisplayUnits& units) {
    units_ = units;
    if (forms_.requirements) forms_.requirements->set_units(units_);
}

void PropertiesPane::add_project_pages() {
    forms_.project = new ProjectPage(document_);
    groups_->add(forms_.project, tr("Project"), true);
    forms_.certificate = new CertificateForm(document_);
    set_help_place(*forms_.certificate, QStringLiteral("certificate"));
    groups_->add(forms_.certificate, tr("Certificate"), true);
    forms_.review = add_review(document_, *groups_);
    groups_->add(new ReportForm(document_), tr("Report"));
}

void PropertiesPane::add_analysis_pages(const SetupAddress& entry) {
    forms_.inputs = new InputsPage(document_, runner_, entry.id);
    forms_.options = new OptionsForm(document_, entry.id);
    show_forecast(to_qt(entry.id));
    forms_.studies = new StudiesForm(document_, runner_, selection_, entry.id);
    forms_.designs = new DesignsForm(document_, runner_, selection_, entry.id);
    forms_.requirements = new RequirementsForm(document_, runner_, entry.id);
    forms_.requirements->set_units(units_);
    connect(forms_.requirements, &RequirementsForm::place_wanted, this, &PropertiesPane::place_wanted);
    set_help_place(*forms_.inputs, QStringLiteral("analysis-inputs"));
    set_help_place(*forms_.options, QStringLiteral("options"));
    set_help_place(*forms_.studies, QStringLiteral("analysis-studies"));
    set_help_place(*forms_.designs, QStringLiteral("analysis-designs"));
    set_help_place(*forms_.requirements, QStringLiteral("analysis-requirements"));
    groups_->add(forms_.inputs, tr("Inputs"));
    groups_->add(forms_.options, tr("Options"));
    groups_->add(forms_.studies, tr("Studies"));
    groups_->add(forms_.designs, tr("Designs"));
    groups_->add(forms_.requirements, tr("Requirements"));
}

void PropertiesPane::show_forecast(const QString& analysis) {
    if (!forms_.options || analysis != to_qt(selection_.entry().id)) return;
    const auto& prepared = runner_.status(analysis).prepared;
    forms_.options->set_forecast(prepared ? to_qt(prepared->forecast) : QString());
    summarise();
}

void PropertiesPane::summarise() {
    const AnalysisEntry* analysis = document_.project().find_analysis(selection_.entry().id);
    if (analysis && forms_.inputs && groups_->count() > notes_group)
        summarise_groups(*groups_, *analysis, runner_.status(to_qt(analysis->id)));
}

void PropertiesPane::discard_if_gone() {
    if (forms_.setup && !find_setup(document_.project(), forms_.setup->address())) rebuild();
    if (!hint_) return;
    if (find_setup(document_.project(), selection_.entry()))  // its removal was undone
        rebuild();
    else
        hint_->setText(hint_in(document_.project()));
}

/// Shows the field selected elsewhere; the keyboard stays where it is.
void PropertiesPane::follow_field(const QString& field) {
    if (following_ || !forms_.setup || field.isEmpty()) return;
    const QPointer<QWidget> focus = QApplication::focusWidget();
    following_ = true;
    if (forms_.setup->focus_field(to_std(field))) scroll_to_focus();
    following_ = false;
    if (focus) focus->setFocus();
}

void PropertiesPane::go_to_first_field() {
    if (forms_.setup) forms_.setup->focus_first();
}

/// Brings the head of a group to the top of the pane, as far as the pages below it allow.
void PropertiesPane::show_group(int group) {
    if (group >= groups_->count()) return;
    groups_->open(group);
    QMetaObject::invokeMethod(
        this, [this, group] { area_->ensureWidgetVisible(groups_->page(group), 0, 0); },
        Qt::QueuedConnection);
}

void PropertiesPane::focus_field(const QString& path) {
    go_to_field(path);
    // Qt scrolls to what Tab reaches only; a page that was hidden has no places yet.
    QMetaObject::invokeMethod(this, &PropertiesPane::scroll_to_focus, Qt::QueuedConnection);
}

void PropertiesPane::scroll_to_focus() {
    QWidget* focused = QApplication::focusWidget();
    if (!focused || !isAncestorOf(focused)) return;
    bring_into_view(*focused);
}

void PropertiesPane::go_to_field(const QString& path) {
    const std::string field = to_std(path);
    if (forms_.certificate && path.startsWith(QStringLiteral("/certificate"))) {
        groups_->open(certificate_group);
        if (!forms_.certificate->focus_field(field)) forms_.certificate->focus_next_missing();
        return;
    }
    const auto group = group_of_place(field, entry_path(document_.project(), selection_.entry()));
    if (forms_.inputs && group) groups_->open(*group);  // a hidden field gets no focus
    const auto focus_in = [&](auto*... forms) { (void)((forms && forms->focus_field(field)) || ...); };
    focus_in(forms_.project, forms_.review, forms_.studies, forms_.designs, forms_.requirements,
             forms_.sources, forms_.setup, forms_.options, forms_.inputs);
}

}  // namespace covaria::ui
