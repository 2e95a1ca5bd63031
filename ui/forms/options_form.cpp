// One row per option; rows that the method does not use are hidden.
#include "ui/forms/options_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <algorithm>

#include "core/manual/help_page.h"
#include "ui/document/setup_address.h"
#include "ui/forms/complaint.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/help_place.h"
#include "ui/forms/whole_text.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

bool is_whole(const OptionMember& member) {
    return std::holds_alternative<SeedOption>(member) ||
           std::holds_alternative<std::uint64_t EvaluationOptions::*>(member) ||
           std::holds_alternative<int EvaluationOptions::*>(member);
}

bool may_be_absent(const OptionField& field) {
    return field.none_at_zero ||
           std::holds_alternative<std::optional<double> EvaluationOptions::*>(field.member) ||
           std::holds_alternative<std::optional<Quantity> EvaluationOptions::*>(field.member);
}

Range range_of(const OptionField& field) {
    Range range = field.range;
    if (!is_whole(field.member)) return range;
    range.low = std::max(range.low, 0.0);
    range.high = std::min(range.high, largest_whole_number);
    return range;
}

std::optional<Quantity> quantity_of(const OptionField& field, const EvaluationOptions& options) {
    if (const auto* member = std::get_if<std::optional<Quantity> EvaluationOptions::*>(&field.member))
        return options.**member;
    const std::optional<double> number = number_of(field.member, options);
    if (field.none_at_zero && number == 0.0) return std::nullopt;
    return number ? std::optional<Quantity>({*number, Unit()}) : std::nullopt;
}

void set_quantity(const OptionField& field, EvaluationOptions& options,
                  const std::optional<Quantity>& quantity) {
    if (const auto* member = std::get_if<std::optional<Quantity> EvaluationOptions::*>(&field.member))
        options.** member = quantity;
    else
        set_number(field.member, options, quantity ? std::optional(quantity->value) : std::nullopt);
}

/// "/analyses/0/options/coverageProbability" -> "coverageProbability".
std::string key_of_path(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

}  // namespace

OptionsForm::OptionsForm(Document& document, std::string analysis, QWidget* parent)
    : QWidget(parent), document_(document), analysis_(std::move(analysis)), layout_(new QFormLayout(this)) {
    for (const OptionField& field : option_fields()) add(field);
    add_forecast();
    connect(&document_, &Document::project_changed, this, &OptionsForm::refresh);
    connect(&document_, &Document::problems_changed, this, &OptionsForm::refresh_problems);
    refresh();
    refresh_problems();
}

void OptionsForm::add(const OptionField& field) {
    if (const auto* chosen = std::get_if<ChosenOption>(&field.member))
        rows_.push_back(choice_row(field, *chosen));
    else if (const auto* flag = std::get_if<bool EvaluationOptions::*>(&field.member))
        rows_.push_back(flag_row(field, *flag));
    else
        rows_.push_back(quantity_row(field));
    QWidget* editor = rows_.back().editor;
    editor->setObjectName(QString::fromUtf8(field.key));
    set_help_place(*editor, to_qt(field_anchor("options", field.key)));
    editor->setAccessibleName(core_text(field.title));
}

OptionsForm::Row OptionsForm::choice_row(const OptionField& field, const ChosenOption& member) {
    auto* box = new QComboBox(this);
    may_be_narrow(*box);
    keep_whole(*box);
    for (const Choice& choice : field.choices) box->addItem(core_text(choice.title), to_qt(choice.key));
    box->setToolTip(core_text(field.help));
    layout_->addRow(core_text(field.title), box);
    connect(box, &QComboBox::activated, this, [this, box, &field, &member](int row) {
        const std::string key = box->itemData(row).toString().toStdString();
        change(field, [&](EvaluationOptions& options) { member.set(options, key); });
    });
    return {&field, box,
            [box, &member](const EvaluationOptions& options) {
                box->setCurrentIndex(box->findData(to_qt(member.get(options))));
            },
            [](const QString&) {}};
}

OptionsForm::Row OptionsForm::flag_row(const OptionField& field, bool EvaluationOptions::*member) {
    auto* box = new QCheckBox(core_text(field.title), this);
    box->setToolTip(core_text(field.help));
    layout_->addRow(QString(), box);
    connect(box, &QCheckBox::clicked, this, [this, &field, member](bool checked) {
        change(field, [&](EvaluationOptions& options) { options.*member = checked; });
    });
    return {&field, box,
            [box, member](const EvaluationOptions& options) { box->setChecked(options.*member); },
            [](const QString&) {}};
}

OptionsForm::Row OptionsForm::quantity_row(const OptionField& field) {
    auto* edit = new QuantityEdit(this);
    keep_letters(*edit);
    edit->set_integer(is_whole(field.member));
    edit->set_range(range_of(field));
    edit->set_optional(may_be_absent(field));
    if (may_be_absent(field)) edit->setPlaceholderText(field.none_at_zero ? tr("none") : tr("automatic"));
    edit->set_help(core_text(field.help));
    layout_->addRow(core_text(field.title), edit);
    edit->set_place(document_.unread(), place_of(field));
    connect(edit, &QuantityEdit::quantity_edited, this,
            [this, &field](const std::optional<Quantity>& quantity) {
                change(field, [&](EvaluationOptions& options) { set_quantity(field, options, quantity); });
            });
    return {
        &field, edit,
        [edit, &field](const EvaluationOptions& options) { edit->set_quantity(quantity_of(field, options)); },
        [edit](const QString& complaint) { edit->set_complaint(complaint); }};
}

void OptionsForm::add_forecast() {
    forecast_ = new QLabel(this);
    forecast_->setObjectName(QStringLiteral("forecast"));
    forecast_->setWordWrap(true);
    layout_->addRow(tr("Forecast"), forecast_);
}

void OptionsForm::set_forecast(const QString& words) {
    QString sentence = words;
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    forecast_->setText(sentence);
    const EvaluationOptions* shown = options();
    layout_->setRowVisible(forecast_, shown && shown->method == Method::adaptive);
}

TextPlace OptionsForm::place_of(const OptionField& field) const {
    return {{SetupOwner::analysis, analysis_}, std::string("/options/") + field.key};
}

const EvaluationOptions* OptionsForm::options() const {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    return entry ? &entry->options : nullptr;
}

void OptionsForm::change(const OptionField& field, const std::function<void(EvaluationOptions&)>& edit) {
    document_.apply(
        tr("Change evaluation options"),
        [&](Project& project) {
            if (AnalysisEntry* entry = find_analysis_entry(project, analysis_)) edit(entry->options);
        },
        QStringLiteral("options:%1:%2").arg(to_qt(analysis_), QString::fromUtf8(field.key)));
}

void OptionsForm::refresh() {
    const EvaluationOptions* shown = options();
    setEnabled(shown != nullptr);
    if (!shown) return;
    for (const Row& row : rows_) {
        const auto& methods = row.field->methods;
        const bool used = std::find(methods.begin(), methods.end(), shown->method) != methods.end();
        layout_->setRowVisible(row.editor, used);
        if (!used) document_.unread().remove(place_of(*row.field));
        row.show(*shown);
    }
    set_forecast(shown->method == Method::adaptive ? forecast_->text() : QString());
}

void OptionsForm::refresh_problems() {
    const std::string prefix =
        entry_path(document_.project(), {SetupOwner::analysis, analysis_}) + "/options/";
    for (const Row& row : rows_) row.complain(problems_at(document_.problems(), prefix + row.field->key));
}

bool OptionsForm::focus_field(const std::string& path) {
    const std::string key = key_of_path(path);
    const auto row =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& one) { return one.field->key == key; });
    if (row != rows_.end()) row->editor->setFocus(Qt::OtherFocusReason);
    return row != rows_.end();
}

}  // namespace covaria::ui
