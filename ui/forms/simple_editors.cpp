// Each editor is one standard widget filling the row.
#include "ui/forms/simple_editors.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "core/setup/text_columns.h"
#include "ui/document/project_edits.h"
#include "ui/forms/complaint.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/whole_text.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

template <class Widget>
Widget* fill(FieldEditor* editor, Widget* widget, const FieldSpec& field) {
    auto* layout = new QHBoxLayout(editor);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(widget);
    widget->setAccessibleName(core_text(field.title));
    widget->setToolTip(help_text(field));
    widget->setObjectName(to_qt(field.key));
    editor->setFocusProxy(widget);
    return widget;
}

}  // namespace

NumberEditor::NumberEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent)
    : FieldEditor(parent), edit_(fill(this, new QuantityEdit(this), field)) {
    keep_letters(*edit_);
    edit_->set_unit(field.unit);
    edit_->set_range(field.range);
    edit_->set_integer(field.kind == FieldKind::integer);
    edit_->set_optional(field.optional || !std::holds_alternative<std::monostate>(field.default_value));
    edit_->set_help(help_text(field));
    edit_->set_place(context.document.unread(), {context.address, "/setup/" + field.key});
    connect(edit_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& quantity) {
        emit edited(quantity ? SetupValue(*quantity) : SetupValue());
    });
}

void NumberEditor::set_value(const SetupValue& value) {
    const Quantity* quantity = std::get_if<Quantity>(&value);
    edit_->set_quantity(quantity ? std::optional<Quantity>(*quantity) : std::nullopt);
}

TextEditor::TextEditor(const FieldSpec& field, QWidget* parent)
    : FieldEditor(parent),
      key_(field.key),
      edit_(fill(this, new QLineEdit(this), field)),
      help_(help_text(field)) {
    keep_letters(*edit_);
    edit_->installEventFilter(this);
    connect(edit_, &QLineEdit::textEdited, this, [this](const QString& text) {
        emit edited(text.isEmpty() ? SetupValue() : SetupValue(to_std(text)));
    });
}

void TextEditor::set_value(const SetupValue& value) {
    const std::string* text = std::get_if<std::string>(&value);
    text_ = text ? *text : std::string();
    show_text(edit_->hasFocus());
}

void TextEditor::show_text(bool as_typed) {
    const QString shown = to_qt(as_typed ? text_ : shown_text(key_, text_));
    if (edit_->text() != shown) edit_->setText(shown);
}

/// "°C" is read, "degC" is edited.
bool TextEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        show_text(event->type() == QEvent::FocusIn);
    return FieldEditor::eventFilter(watched, event);
}

void TextEditor::set_complaint(const QString& complaint) {
    mark(*edit_, complaint, help_);
}

FlagEditor::FlagEditor(const FieldSpec& field, QWidget* parent)
    : FieldEditor(parent), box_(fill(this, new QCheckBox(this), field)), help_(help_text(field)) {
    connect(box_, &QCheckBox::clicked, this, [this](bool checked) { emit edited(SetupValue(checked)); });
}

void FlagEditor::set_value(const SetupValue& value) {
    const bool* flag = std::get_if<bool>(&value);
    box_->setChecked(flag && *flag);
}

void FlagEditor::set_complaint(const QString& complaint) {
    mark(*box_, complaint, help_);
}

ListEditor::ListEditor(const FieldSpec& field, QWidget* parent)
    : FieldEditor(parent),
      field_(field),
      box_(fill(this, new QComboBox(this), field)),
      help_(help_text(field)) {
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box_->setMinimumContentsLength(10);
    box_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    keep_whole(*box_);
    connect(box_, &QComboBox::activated, this, [this](int row) {
        const QString key = box_->itemData(row).toString();
        emit edited(key.isEmpty() ? SetupValue() : SetupValue(to_std(key)));
    });
}

std::vector<Choice> ListEditor::choices() const {
    return field_.choices;
}

QString ListEditor::words_of(const Choice& choice) const {
    return core_text(choice.title);
}

QString ListEditor::empty_words() const {
    return tr("(none)");
}

void ListEditor::set_value(const SetupValue& value) {
    const QSignalBlocker quiet(box_);
    const std::string* text = std::get_if<std::string>(&value);
    const QString key = text ? to_qt(*text) : QString();
    box_->clear();
    if (field_.optional || key.isEmpty()) box_->addItem(empty_words(), QString());
    for (const Choice& choice : choices()) box_->addItem(words_of(choice), to_qt(choice.key));
    if (box_->findData(key) < 0) box_->addItem(tr("%1 (does not exist)").arg(key), key);
    box_->setCurrentIndex(box_->findData(key));
    show_whole_texts();
}

void ListEditor::show_whole_texts() {
    box_->view()->setMinimumWidth(box_->view()->sizeHintForColumn(0) + 8);
    if (complaint_of(*box_).isEmpty())
        box_->setToolTip(tr("%1\n\nChosen: %2").arg(help_, box_->currentText()));
}

void ListEditor::set_complaint(const QString& complaint) {
    mark(*box_, complaint, help_);
    show_whole_texts();
}

ReferenceEditor::ReferenceEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent)
    : ListEditor(field, parent), document_(context.document), address_(context.address) {}

std::vector<Choice> ReferenceEditor::choices() const {
    return fitting_assets(document_.project(), field().capabilities, address_);
}

QString ReferenceEditor::words_of(const Choice& choice) const {
    return to_qt(choice.title);
}

QString ReferenceEditor::empty_words() const {
    if (choices().empty()) return tr("(nothing in the project fits: add it first)");
    return field().optional ? tr("(none)") : tr("(choose)");
}

}  // namespace covaria::ui
