#include "ui/forms/file_editor.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/forms/complaint.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

FileEditor::FileEditor(const FieldSpec& field, Document& document, QString filter, QWidget* parent)
    : FieldEditor(parent),
      document_(document),
      filter_(std::move(filter)),
      edit_(new QLineEdit(this)),
      title_(core_text(field.title)),
      help_(help_text(field)) {
    auto* button = new QToolButton(this);
    button->setText(QStringLiteral("…"));
    button->setObjectName(to_qt(field.key) + QStringLiteral("_choose"));
    button->setAccessibleName(tr("Choose a file: %1").arg(title_));
    button->setToolTip(button->accessibleName());
    button->setFocusPolicy(Qt::StrongFocus);
    edit_->setObjectName(to_qt(field.key));
    edit_->setAccessibleName(title_);
    edit_->setToolTip(help_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(edit_, 1);
    row->addWidget(button);
    setFocusProxy(edit_);
    connect(edit_, &QLineEdit::textEdited, this, [this](const QString& text) {
        emit edited(text.isEmpty() ? SetupValue() : SetupValue(to_std(text)));
    });
    connect(button, &QToolButton::clicked, this, &FileEditor::ask);
}

void FileEditor::ask() {
    const QString file =
        QFileDialog::getOpenFileName(this, title_, from_path(document_.project().directory), filter_);
    if (!file.isEmpty()) choose(file);
}

void FileEditor::choose(const QString& file) {
    const std::filesystem::path chosen = to_path(file);
    const std::filesystem::path beside = chosen.lexically_relative(document_.project().directory);
    const bool inside = !beside.empty() && *beside.begin() != "..";
    edit_->setText(from_path(inside ? beside : chosen));
    emit edited(SetupValue(to_std(edit_->text())));
}

void FileEditor::set_value(const SetupValue& value) {
    const std::string* text = std::get_if<std::string>(&value);
    const QString shown = text ? to_qt(*text) : QString();
    if (edit_->text() != shown) edit_->setText(shown);
}

void FileEditor::set_complaint(const QString& complaint) {
    mark(*edit_, complaint, help_);
}

}  // namespace covaria::ui
