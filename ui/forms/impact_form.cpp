#include "ui/forms/impact_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>

#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// A row of a title with a mnemonic, its field, and a button beside it.
void add_row(QFormLayout& form, const QString& title, QWidget* field, QWidget* button = nullptr) {
    auto* label = new QLabel(title);
    label->setBuddy(field);
    field->setAccessibleName(QString(title).remove(QLatin1Char('&')));
    auto* row = new QHBoxLayout;
    row->addWidget(field, 1);
    if (button) row->addWidget(button, 0, Qt::AlignTop);
    form.addRow(label, row);
}

template <class Entry>
QStringList numbers_of(const Entry& entry) {
    QStringList numbers;
    for (const AssetCertificate& certificate : entry.certificates)
        if (!certificate.number.empty()) numbers << to_qt(certificate.number);
    return numbers;
}

QStringList certificates_of(const Project& project, const SetupAddress& chosen) {
    QStringList first, others;
    const auto add = [&](const auto& entries, SetupOwner owner) {
        for (const auto& entry : entries)
            (chosen == SetupAddress{owner, entry.id} ? first : others) << numbers_of(entry);
    };
    add(project.assets, SetupOwner::asset);
    add(project.analyses, SetupOwner::analysis);
    first << others;
    first.removeDuplicates();
    return first;
}

}  // namespace

ImpactForm::ImpactForm(QWidget* parent)
    : QWidget(parent),
      certificate_(new QComboBox),
      figures_(new QLineEdit),
      places_(new QPlainTextEdit),
      first_order_(new QCheckBox(tr("To first &order: quick"))),
      figures_button_(new QPushButton(tr("&Browse …"))),
      place_button_(new QPushButton(tr("&Add Folder …"))) {
    certificate_->setObjectName(QStringLiteral("impact_certificate"));
    certificate_->setEditable(true);
    certificate_->setInsertPolicy(QComboBox::NoInsert);
    certificate_->setToolTip(
        tr("Number of the certificate, its file or the SHA-256 of it; else the name of an asset"));
    certificate_->lineEdit()->setPlaceholderText(tr("Number, file, or name of an asset"));
    figures_->setObjectName(QStringLiteral("impact_figures"));
    figures_->setClearButtonEnabled(true);
    figures_->setPlaceholderText(tr("Empty: only who used the certificate"));
    figures_->setToolTip(
        tr("A project, a report (PDF) or a file of others with the new figures; FILE#ID is "
           "one asset or analysis of it"));
    places_->setObjectName(QStringLiteral("impact_places"));
    places_->setTabChangesFocus(true);
    places_->setLineWrapMode(QPlainTextEdit::NoWrap);
    places_->setPlaceholderText(tr("A folder or file on each line"));
    places_->setToolTip(tr("Projects and reports (PDF) below these folders are looked at"));
    places_->setFixedHeight(3 * places_->fontMetrics().lineSpacing() + 14);
    first_order_->setToolTip(
        tr("Else each analysis is evaluated as its project says, with all its trials, twice"));
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    add_row(*form, tr("&Certificate"), certificate_);
    add_row(*form, tr("&New figures"), figures_, figures_button_);
    add_row(*form, tr("&Look in"), places_, place_button_);
    form->addRow(QString(), first_order_);
    connect(certificate_, &QComboBox::editTextChanged, this, &ImpactForm::changed);
    connect(figures_, &QLineEdit::textChanged, this, &ImpactForm::changed);
    connect(places_, &QPlainTextEdit::textChanged, this, &ImpactForm::changed);
}

void ImpactForm::offer(const Project& project, const SetupAddress& entry) {
    const QString typed = certificate_->currentText();
    certificate_->clear();
    certificate_->addItems(certificates_of(project, entry));
    if (!typed.isEmpty()) certificate_->setEditText(typed);
}

void ImpactForm::ask_about(const QString& certificate) {
    certificate_->setEditText(certificate);
}

ImpactWords ImpactForm::words() const {
    ImpactWords words;
    words.old_figures = to_std(certificate_->currentText().trimmed());
    words.new_figures = to_std(figures_->text().trimmed());
    words.is_first_order = first_order_->isChecked();
    for (const QString& place : places_->toPlainText().split(QLatin1Char('\n'), Qt::SkipEmptyParts))
        if (!place.trimmed().isEmpty()) words.folders.push_back(to_std(place.trimmed()));
    return words;
}

void ImpactForm::set_new_figures(const QString& file) {
    figures_->setText(file);
}

void ImpactForm::add_place(const QString& folder) {
    places_->appendPlainText(folder);
}

}  // namespace covaria::ui
