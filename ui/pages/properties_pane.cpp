#include "ui/pages/properties_pane.h"

#include <QApplication>
#include <QLabel>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/document/setup_address.h"
#include "ui/forms/bring_into_view.h"
#include "ui/forms/certificate_form.h"
#include "ui/forms/designs_form.h"
#include "ui/forms/help_place.h"
#include "ui/forms/options_form.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/report_form.h"
#include "ui/forms/requirements_form.h"
#include "ui/forms/scrolled.h"
#include "ui/forms/setup_form.h"
#include "ui/forms/spreadsheet_view.h"
#include "ui/forms/studies_form.h"
#include "ui/pages/asset_evaluation.h"
#include "ui/pages/field_help.h"
#include "ui/pages/inputs_page.h"
#include "ui/pages/notes_page.h"
#include "ui/pages/project_page.h"
#include "ui/theme/strings.h"
#include "ui/theme/tabs.h"

namespace covaria::ui {
namespace {

enum AnalysisTab {
    setup_tab,
    inputs_tab,
    options_tab,
    studies_tab,
    designs_tab,
    requirements_tab,
    notes_tab
};

QStringList analysis_tabs() {
    return {PropertiesPane::tr("Set-up"),  PropertiesPane::tr("Inputs"),  PropertiesPane::tr("Options"),
            PropertiesPane::tr("Studies"), PropertiesPane::tr("Designs"), PropertiesPane::tr("Requirements"),
            PropertiesPane::tr("Notes")};
}

}  // namespace

int PropertiesPane::room_for_tabs() {
    TabBar bar;
    for (const QString& title : analysis_tabs()) bar.addTab(title);
    return bar.closest_width();
}

PropertiesPane::PropertiesPane(Document& document, AnalysisRunner& runner, Selection& selection,
                               QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner), selection_(selection) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    help_ = new FieldHelp(*this);
    column->addWidget(help_);
    connect(&selection_, &Selection::entry_changed, this, &PropertiesPane::rebuild);
    connect(&document_, &Document::project_changed, this, &PropertiesPane::discard_if_gone);
    connect(&runner_, &AnalysisRunner::state_changed, this, &PropertiesPane::show_forecast);
    connect(&selection_, &Selection::field_changed, this, &PropertiesPane::follow_field);
    rebuild();
}

void PropertiesPane::rebuild() {
    help_->start_over();
    delete tabs_;
    setup_ = nullptr;
    certificate_ = nullptr;
    project_ = nullptr;
    inputs_ = nullptr;
    options_ = nullptr;
    studies_ = nullptr;
    designs_ = nullptr;
    requirements_ = nullptr;
    tabs_ = new Tabs(this);
    connect(tabs_, &QTabWidget::currentChanged, this, &PropertiesPane::start_help);
    static_cast<QVBoxLayout*>(layout())->insertWidget(0, tabs_, 1);
    const SetupAddress& entry = selection_.entry();
    if (entry.owner == SetupOwner::project) return add_project_pages();
    if (!find_setup(document_.project(), entry)) {
        hint_ = new QLabel(hint());
        hint_->setWordWrap(true);
        hint_->setMargin(16);
        hint_->setAlignment(Qt::AlignTop);
        hint_->setEnabled(false);
        tabs_->addTab(hint_, tr("Properties"));
        return;
    }
    setup_ = new SetupForm(document_, entry);
    set_help_place(*this, help_anchor(document_.project(), entry));
    connect(setup_, &SetupForm::part_selected, this, [this](const QString& path) {
        following_ = true;
        selection_.select_field(path);
        following_ = false;
    });
    tabs_->addTab(scrolled(setup_), analysis_tabs()[setup_tab]);
    if (entry.owner == SetupOwner::asset)
        add_asset_pages(entry);
    else
        add_analysis_pages(entry);
    add_notes_page(entry);
}

/// Where no entry is selected.
QString PropertiesPane::hint() const {
    return document_.project().assets.empty() && document_.project().analyses.empty()
               ? tr("The project is empty. Add an analysis, or first what it uses, with the "
                    "plus sign above or a right click in the project tree.")
               : tr("Select an entry of the project tree to see its properties.");
}

/// What was said of a field of another tab is over.
void PropertiesPane::start_help() {
    const QWidget* focused = QApplication::focusWidget();
    const QWidget* page = tabs_->currentWidget();
    if (!page || (focused && page->isAncestorOf(focused))) return;
    const auto shows = [page](const auto& editors) {
        return std::any_of(editors.begin(), editors.end(),
                           [page](const QWidget* editor) { return editor->isVisibleTo(page); });
    };
    help_->start_over(shows(page->findChildren<QuantityEdit*>()) ||
                      shows(page->findChildren<SpreadsheetView*>()));
}

void PropertiesPane::set_units(const DisplayUnits& units) {
    units_ = units;
    if (requirements_) requirements_->set_units(units_);
}

void PropertiesPane::start_over() {
    const int tab = tabs_->currentIndex();
    rebuild();
    tabs_->setCurrentIndex(tab);
}

void PropertiesPane::add_project_pages() {
    project_ = new ProjectPage(document_);
    tabs_->addTab(scrolled(project_), tr("Project"));
    certificate_ = new CertificateForm(document_);
    set_help_place(*certificate_, QStringLiteral("certificate"));
    tabs_->addTab(certificate_, tr("Certificate"));
    tabs_->addTab(scrolled(new ReportForm(document_)), tr("Report"));
}

void PropertiesPane::add_asset_pages(const SetupAddress& entry) {
    tabs_->addTab(new AssetEvaluation(document_, entry.id), tr("Evaluation"));
}

void PropertiesPane::add_analysis_pages(const SetupAddress& entry) {
    const QStringList titles = analysis_tabs();
    inputs_ = new InputsPage(document_, runner_, entry.id);
    options_ = new OptionsForm(document_, entry.id);
    show_forecast(to_qt(entry.id));
    tabs_->addTab(inputs_, titles[inputs_tab]);
    tabs_->addTab(scrolled(options_), titles[options_tab]);
    studies_ = new StudiesForm(document_, runner_, selection_, entry.id);
    tabs_->addTab(scrolled(studies_), titles[studies_tab]);
    designs_ = new DesignsForm(document_, runner_, selection_, entry.id);
    tabs_->addTab(scrolled(designs_), titles[designs_tab]);
    requirements_ = new RequirementsForm(document_, runner_, entry.id);
    requirements_->set_units(units_);
    connect(requirements_, &RequirementsForm::place_wanted, this, &PropertiesPane::place_wanted);
    set_help_place(*inputs_, QStringLiteral("analysis-inputs"));
    set_help_place(*options_, QStringLiteral("options"));
    set_help_place(*studies_, QStringLiteral("analysis-studies"));
    set_help_place(*designs_, QStringLiteral("analysis-designs"));
    set_help_place(*requirements_, QStringLiteral("analysis-requirements"));
    tabs_->addTab(scrolled(requirements_), titles[requirements_tab]);
}

void PropertiesPane::show_forecast(const QString& analysis) {
    if (!options_ || analysis != to_qt(selection_.entry().id)) return;
    const auto& prepared = runner_.status(analysis).prepared;
    options_->set_forecast(prepared ? to_qt(prepared->forecast) : QString());
}

void PropertiesPane::add_notes_page(const SetupAddress& entry) {
    tabs_->addTab(new NotesPage(document_, entry), analysis_tabs()[notes_tab]);
}

void PropertiesPane::discard_if_gone() {
    if (setup_ && !find_setup(document_.project(), setup_->address())) rebuild();
    if (hint_) hint_->setText(hint());  // entries come and go with undo, too
}

/// Shows the field selected elsewhere; the keyboard stays where it is.
void PropertiesPane::follow_field(const QString& field) {
    if (following_ || !setup_ || field.isEmpty()) return;
    const QPointer<QWidget> focus = QApplication::focusWidget();
    following_ = true;
    if (setup_->focus_field(to_std(field))) tabs_->setCurrentIndex(setup_tab);
    following_ = false;
    if (focus) focus->setFocus();
}

void PropertiesPane::show_studies() {
    if (studies_) tabs_->setCurrentIndex(studies_tab);
}

void PropertiesPane::show_designs() {
    if (designs_) tabs_->setCurrentIndex(designs_tab);
}

void PropertiesPane::go_to_first_field() {
    if (!setup_) return;
    tabs_->setCurrentIndex(setup_tab);
    setup_->focus_first();
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
    if (certificate_ && path.startsWith(QStringLiteral("/certificate"))) {
        tabs_->setCurrentIndex(1);
        if (!certificate_->focus_field(field)) certificate_->focus_next_missing();
        return;
    }
    if (project_ && project_->focus_field(field)) return tabs_->setCurrentIndex(0);
    if (studies_ && studies_->focus_field(field)) return tabs_->setCurrentIndex(studies_tab);
    if (designs_ && designs_->focus_field(field)) return tabs_->setCurrentIndex(designs_tab);
    if (requirements_ && requirements_->focus_field(field)) return tabs_->setCurrentIndex(requirements_tab);
    if (setup_ && setup_->focus_field(field))
        tabs_->setCurrentIndex(setup_tab);
    else if (options_ && options_->focus_field(field))
        tabs_->setCurrentIndex(options_tab);
    else if (inputs_ && inputs_->focus_field(field))
        tabs_->setCurrentIndex(inputs_tab);
}

}  // namespace covaria::ui
