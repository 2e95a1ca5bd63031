#include "ui/forms/certificate_form.h"

#include <QApplication>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>

#include "core/made/certificate_gaps.h"
#include "core/manual/help_page.h"
#include "core/manual/markdown.h"
#include "core/report/certificate_defaults.h"
#include "ui/forms/bring_into_view.h"
#include "ui/forms/complaint.h"
#include "ui/forms/date_editor.h"
#include "ui/forms/file_editor.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/help_place.h"
#include "ui/forms/prose_editor.h"
#include "ui/forms/simple_editors.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr const char* standard = "ISO/IEC 17025";

QString clause_words(const CertificateField& field) {
    return QStringLiteral("%1 %2").arg(QLatin1String(standard), QLatin1String(field.clause));
}

QString demand_words(const CertificateField& field) {
    if (field.required) return CertificateForm::tr("Required by %1.");
    return field.required_for_conformity ? CertificateForm::tr("Required by %1 where conformity is stated.")
                                         : CertificateForm::tr("Asked for by %1 where it applies.");
}

/// The field as other forms know fields; named by its place in the project.
FieldSpec spec_of(const CertificateField& field) {
    FieldSpec spec;
    spec.key = pointer_of(field);
    spec.title = field.title;
    spec.help = field.help;
    if (field.kind == CertificateText::language)
        for (const CertificateLanguage& one : certificate_languages())
            spec.choices.push_back({one.code, one.name});
    if (field.kind == CertificateText::site)
        for (const CertificateSite& one : certificate_sites()) spec.choices.push_back({one.key, one.words});
    if (*field.clause) spec.help += to_std(QLatin1Char(' ') + demand_words(field).arg(clause_words(field)));
    return spec;
}

/// A list whose empty choice says what stands for it.
class ChoiceEditor : public ListEditor {
public:
    ChoiceEditor(const FieldSpec& field, QString none, QWidget* parent)
        : ListEditor(field, parent), none_(std::move(none)) {}

protected:
    QString empty_words() const override { return none_; }

private:
    QString none_;
};

Conformity conformity_in(const Project& project) {
    return stated_conformity(project, certified_ids(project));
}

/// Names of results that the made project lacks; none before it is made.
QStringList unnamed_results(Document& document) {
    QStringList words;
    if (const auto& made = document.maker().made())
        for (const CertificateGap& gap : certificate_gaps(*made, certified_ids(made->project())))
            if (!gap.path.starts_with("/certificate/")) words << to_qt(gap.what);
    return words;
}

}  // namespace

CertificateForm::CertificateForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      groups_(new FoldGroups),
      state_(new QLabel(this)),
      next_(new QPushButton(tr("Next Missing"), this)) {
    add_head();
    for (const CertificateSection& section : certificate_sections()) add_section(section);
    refresh();
    refresh_problems();
    connect(&document_, &Document::project_changed, this, &CertificateForm::refresh);
    connect(&document_.maker(), &ProjectMaker::made_changed, this, &CertificateForm::refresh_state);
    connect(&document_, &Document::problems_changed, this, &CertificateForm::refresh_problems);
}

void CertificateForm::add_head() {
    keep_room(*state_, 3);
    state_->setObjectName(QStringLiteral("certificate_state"));
    state_->setAccessibleName(tr("What the certificate lacks"));
    next_->setObjectName(QStringLiteral("next_missing"));
    next_->setToolTip(
        tr("Goes to the next field that %1 requires and that is empty").arg(QLatin1String(standard)));
    next_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    next_->setFocusPolicy(Qt::TabFocus);  // a click goes on from the field that has the focus
    auto* head = new QVBoxLayout;
    head->addWidget(state_);
    head->addWidget(next_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    head->setContentsMargins(16, 2, 16, 8);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(groups_);
    connect(next_, &QPushButton::clicked, this, &CertificateForm::focus_next_missing);
    const QKeySequence keys(Qt::CTRL | Qt::Key_Return);
    auto* by_keys = new QShortcut(keys, this, {}, {}, Qt::WidgetWithChildrenShortcut);
    connect(by_keys, &QShortcut::activated, this, &CertificateForm::focus_next_missing);
    next_->setToolTip(
        QStringLiteral("%1 (%2)").arg(next_->toolTip(), keys.toString(QKeySequence::NativeText)));
}

void CertificateForm::add_section(const CertificateSection& section) {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    form->setVerticalSpacing(4);
    for (const CertificateField& field : section.fields) add_field(*form, certificate_field(field.member));
    groups_->add(page, core_text(section.title));
}

void CertificateForm::add_field(QFormLayout& form, const CertificateField& field) {
    FieldEditor* editor = make_editor(field, form.parentWidget());
    QLabel* title = make_form_label(field.title, form.parentWidget());
    title->setToolTip(help_text(spec_of(field)));
    title->setBuddy(editor);
    form.addRow(title, editor);
    set_help_place(*editor, to_qt(field_anchor("certificate", anchor_words(pointer_of(field)))));
    rows_.push_back({&field, editor, groups_->count()});
    connect(editor, &FieldEditor::edited, this, [this, &field](const SetupValue& value) {
        const std::string* text = std::get_if<std::string>(&value);
        write(field, text ? *text : std::string());
    });
}

FieldEditor* CertificateForm::make_editor(const CertificateField& field, QWidget* page) {
    const FieldSpec spec = spec_of(field);
    switch (field.kind) {
        case CertificateText::line:
        case CertificateText::country:
            return new TextEditor(spec, page);
        case CertificateText::lines:
            return new ProseEditor(spec, page);
        case CertificateText::language:
            return new ChoiceEditor(spec, tr("English (none chosen)"), page);
        case CertificateText::site:
            return new ChoiceEditor(spec, tr("in the laboratory, or at the place stated"), page);
        case CertificateText::picture:
            return new FileEditor(spec, document_, tr("Pictures (*.png *.jpg *.jpeg)"), page);
        case CertificateText::date:
        case CertificateText::dates:
            break;
    }
    const auto days =
        field.kind == CertificateText::dates ? DateEditor::Days::interval : DateEditor::Days::one;
    return new DateEditor(spec, days, document_, {project_address, spec.key}, page);
}

void CertificateForm::write(const CertificateField& field, const std::string& text) {
    document_.apply(
        tr("Change %1").arg(core_text(field.title)),
        [&](Project& project) { project.certificate.*field.member = text; }, to_qt(pointer_of(field)));
}

void CertificateForm::refresh() {
    const Certificate& certificate = document_.project().certificate;
    const Conformity conformity = conformity_in(document_.project());
    const DocumentLanguage in = language_of_window();
    for (const Row& row : rows_) {
        const std::string& text = certificate.*row.field->member;
        row.editor->set_value(text.empty() ? SetupValue() : SetupValue(text));
        row.editor->set_hint(is_missing(*row.field, certificate, conformity)
                                 ? clause_words(*row.field)
                                 : to_qt(said_in_place_of(row.field->member, in)));
    }
    count_stated();
    refresh_state();
}

/// "3 of 5"; a section that lacks something is open.
void CertificateForm::count_stated() {
    const Certificate& certificate = document_.project().certificate;
    const Conformity conformity = conformity_in(document_.project());
    for (int group = 0; group < groups_->count(); ++group) {
        int fields = 0, stated = 0;
        bool lacks = false;
        for (const Row& row : rows_) {
            if (row.group != group) continue;
            ++fields;
            stated += int(!(certificate.*row.field->member).empty());
            lacks = lacks || is_missing(*row.field, certificate, conformity);
        }
        groups_->set_summary(group, tr("%1 of %2").arg(stated).arg(fields));
        if (lacks) groups_->offer(group);
    }
}

void CertificateForm::refresh_state() {
    const Conformity conformity = conformity_in(document_.project());
    QStringList missing;
    qsizetype required = 0;
    for (const Row& row : rows_) {
        if (is_missing(*row.field, {}, conformity)) ++required;
        if (is_missing(*row.field, document_.project().certificate, conformity))
            missing << core_text(row.field->title);
    }
    next_->setEnabled(!missing.isEmpty());
    const QStringList unnamed = unnamed_results(document_);
    required += unnamed.size();
    missing << unnamed;
    if (missing.isEmpty())
        show_note(
            *state_,
            tr("Everything that %1 requires beside the results is stated.").arg(QLatin1String(standard)));
    else if (missing.size() == required)
        show_note(*state_, tr("For File › Export › Certificate. A clause of %1 stands where it requires "
                              "something; a report needs none of it.")
                               .arg(QLatin1String(standard)));
    else
        show_note(*state_, tr("%1 of %2 required texts are stated; missing: %3.")
                               .arg(required - missing.size())
                               .arg(required)
                               .arg(missing.join(tr(", "))));
}

void CertificateForm::refresh_problems() {
    for (const Row& row : rows_)
        row.editor->set_complaint(problems_at(document_.problems(), pointer_of(*row.field)));
}

bool CertificateForm::focus_field(const std::string& path) {
    for (const Row& row : rows_)
        if (path == pointer_of(*row.field)) {
            FoldGroups::reveal(*row.editor);
            row.editor->focus_part({});
            return true;
        }
    return false;
}

/// Goes to the next missing field after the one with the focus, or to the first.
void CertificateForm::focus_next_missing() {
    const auto has_focus = [](const Row& row) {
        return row.editor->isAncestorOf(QApplication::focusWidget());
    };
    const auto start = std::find_if(rows_.begin(), rows_.end(), has_focus);
    const std::size_t first = start == rows_.end() ? 0 : std::size_t(start - rows_.begin()) + 1;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[(first + i) % rows_.size()];
        if (!is_missing(*row.field, document_.project().certificate, conformity_in(document_.project())))
            continue;
        FoldGroups::reveal(*row.editor);
        row.editor->focus_part({});
        return bring_into_view(*row.editor);
    }
}

}  // namespace covaria::ui
