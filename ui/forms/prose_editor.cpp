#include "ui/forms/prose_editor.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/forms/complaint.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {
constexpr int fewest_lines_of_prose = 2;
constexpr int most_lines_of_prose = 8;
}  // namespace

ProseEditor::ProseEditor(const FieldSpec& field, QWidget* parent)
    : FieldEditor(parent), edit_(new QPlainTextEdit(this)), help_(help_text(field)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(edit_);
    edit_->setTabChangesFocus(true);
    edit_->setAccessibleName(core_text(field.title));
    edit_->setObjectName(to_qt(field.key));
    edit_->setToolTip(help_);
    setFocusProxy(edit_);
    connect(edit_, &QPlainTextEdit::textChanged, this, [this] {
        adapt_height();
        const QString text = edit_->toPlainText();
        emit edited(text.isEmpty() ? SetupValue() : SetupValue(to_std(text)));
    });
    adapt_height();
}

void ProseEditor::set_value(const SetupValue& value) {
    const std::string* text = std::get_if<std::string>(&value);
    const QString shown = text ? to_qt(*text) : QString();
    if (edit_->toPlainText() == shown) return;
    const QSignalBlocker quiet(edit_);
    edit_->setPlainText(shown);
    adapt_height();
}

void ProseEditor::set_complaint(const QString& complaint) {
    mark(*edit_, complaint, help_);
}

void ProseEditor::adapt_height() {
    // The height of a plain text's layout is its number of lines, wrapped ones counted.
    const int wrapped = int(std::ceil(edit_->document()->size().height()));
    const int lines = std::clamp(wrapped, fewest_lines_of_prose, most_lines_of_prose);
    const int frame = 2 * edit_->frameWidth() + 2 * int(edit_->document()->documentMargin());
    edit_->setFixedHeight(lines * edit_->fontMetrics().lineSpacing() + frame);
}

}  // namespace covaria::ui
