// Every change is an edit of the project, saved in its file.
#include "ui/pages/project_page.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "core/text/numbers.h"
#include "ui/document/setup_address.h"
#include "ui/forms/complaint.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/unit_choices.h"
#include "ui/pages/notes_page.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {
const std::string factor_path = "/results/coverageFactor";
}

ProjectPage::ProjectPage(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(new NotesPage(document_, project_address), 1);
    auto* form = new QFormLayout;
    form->setContentsMargins(9, 0, 9, 0);
    number_ = add_text(*form, tr("Number"), "project_number", tr("Of the project or order; in the report"),
                       &Project::number);
    author_ =
        add_text(*form, tr("Author"), "project_author", tr("Who evaluated; in the report"), &Project::author);
    column->addLayout(form);
    auto* group = new QGroupBox(tr("Results of all analyses"));
    auto* results = new QFormLayout(group);
    results->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    add_results(*results);
    auto* margin = new QVBoxLayout;
    margin->setContentsMargins(9, 0, 9, 9);
    margin->addWidget(group);
    column->addLayout(margin);
    refresh();
    refresh_problems();
    connect(&document_, &Document::project_changed, this, &ProjectPage::refresh);
    connect(&document_, &Document::problems_changed, this, &ProjectPage::refresh_problems);
}

QLineEdit* ProjectPage::add_text(QFormLayout& form, const QString& title, const char* name,
                                 const QString& help, std::string Project::*member) {
    auto* edit = new QLineEdit;
    edit->setObjectName(QString::fromLatin1(name));
    edit->setAccessibleName(title);
    edit->setToolTip(help);
    form.addRow(title, edit);
    connect(edit, &QLineEdit::editingFinished, this, [this, edit, title, member] {
        edit->setModified(false);
        document_.apply(tr("Change %1").arg(title),
                        [&](Project& project) { project.*member = to_std(edit->text().trimmed()); });
    });
    return edit;
}

void ProjectPage::add_results(QFormLayout& form) {
    units_ = new UnitChoices(form, tr("Not stated"),
                             tr("Of results in the window, reports, tables and CSV files; where it is not "
                                "stated, files have the unit of the model"),
                             this);
    connect(units_, &UnitChoices::edited, this, [this] {
        document_.apply(tr("Change units of results"),
                        [this](Project& project) { project.results.style.units = units_->units(); });
    });
    auto* documents = new QLabel(
        tr("Reports, certificates and files have these units, and those of the model where none is stated; "
           "units of the preferences are of the window only."));
    documents->setObjectName(QStringLiteral("units_of_documents"));
    documents->setWordWrap(true);
    form.addRow(documents);
    digits_ = new QComboBox;
    digits_->setObjectName(QStringLiteral("project_digits"));
    digits_->setAccessibleName(tr("Digits of U"));
    digits_->setToolTip(
        tr("Significant digits of uncertainties in the window and the report; certificates "
           "have two"));
    digits_->addItem(tr("Not stated"), 0);
    for (int digits = fewest_digits; digits <= most_digits; ++digits)
        digits_->addItem(QString::number(digits), digits);
    form.addRow(tr("Digits of U"), digits_);
    connect(digits_, &QComboBox::activated, this, [this](int row) {
        const int digits = digits_->itemData(row).toInt();
        document_.apply(tr("Change digits of results"), [&](Project& project) {
            project.results.style.digits = digits > 0 ? std::optional(digits) : std::nullopt;
        });
    });
    factor_ = new QuantityEdit(this);
    factor_->setObjectName(QStringLiteral("project_factor"));
    factor_->setAccessibleName(tr("Coverage factor"));
    factor_->set_optional(true);
    factor_->set_range({.low = 0.0, .low_open = true});
    factor_->set_help(
        tr("A fixed k for U = k u of all analyses whose options state none; empty: from the "
           "degrees of freedom, or the coverage interval"));
    factor_->set_place(document_.unread(), {project_address, factor_path});
    form.addRow(tr("Coverage factor"), factor_);
    connect(factor_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& k) {
        document_.apply(tr("Change coverage factor"), [&](Project& project) {
            project.results.coverage_factor = k ? std::optional(k->value) : std::nullopt;
        });
    });
}

void ProjectPage::refresh() {
    const Project& project = document_.project();
    for (const auto& [edit, text] :
         {std::pair(number_, &project.number), std::pair(author_, &project.author)})
        if (!(edit->hasFocus() && edit->isModified()) && edit->text() != to_qt(*text))
            edit->setText(to_qt(*text));
    units_->set_units(project.results.style.units);
    digits_->setCurrentIndex(std::max(0, digits_->findData(project.results.style.digits.value_or(0))));
    const auto& k = project.results.coverage_factor;
    factor_->set_quantity(k ? std::optional(Quantity{*k, Unit()}) : std::nullopt);
}

void ProjectPage::refresh_problems() {
    factor_->set_complaint(problems_at(document_.problems(), factor_path));
}

bool ProjectPage::focus_field(const std::string& path) {
    if (!path.starts_with("/results")) return false;
    if (path == factor_path)
        factor_->setFocus(Qt::OtherFocusReason);
    else
        digits_->setFocus(Qt::OtherFocusReason);
    return true;
}

}  // namespace covaria::ui
