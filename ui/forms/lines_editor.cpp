#include "ui/forms/lines_editor.h"

#include <QAbstractTextDocumentLayout>
#include <QFocusEvent>
#include <QFontDatabase>
#include <QSignalBlocker>
#include <QTextBlock>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdio>

#include "ui/forms/complaint.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr int fewest_lines = 3;
constexpr int most_lines = 14;

/// Line from 0, columns from 1: "/2/14-16".
struct LinePart {
    int line = 0, first = 1, last = 1;
};

std::optional<LinePart> part_of(const std::string& path) {
    LinePart part;
    const int read = std::sscanf(path.c_str(), "/%d/%d-%d", &part.line, &part.first, &part.last);
    if (read < 1) return std::nullopt;
    return part;
}

QTextCursor cursor_at(QTextDocument* document, const LinePart& part) {
    const QTextBlock block = document->findBlockByNumber(part.line);
    QTextCursor cursor(block.isValid() ? block : document->lastBlock());
    const int length = std::max(0, cursor.block().length() - 1);
    // The last character is marked for a problem behind it.
    const int first = std::clamp(part.first - 1, 0, std::max(0, length - 1));
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, first);
    cursor.movePosition(QTextCursor::Right, QTextCursor::KeepAnchor,
                        std::clamp(part.last, first + 1, std::max(length, first + 1)) - first);
    return cursor;
}

}  // namespace

LinesEditor::LinesEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent)
    : FieldEditor(parent),
      document_(context.document),
      address_(context.address),
      edit_(new QPlainTextEdit(this)),
      message_(new QLabel(this)),
      complete_(new QPushButton(tr("Add rows for new names"), this)),
      help_(help_text(field)) {
    if (const std::string* text = std::get_if<std::string>(&field.default_value)) default_ = to_qt(*text);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    edit_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    edit_->setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    edit_->setTabChangesFocus(true);
    edit_->setAccessibleName(core_text(field.title));
    edit_->setObjectName(to_qt(field.key));
    edit_->setToolTip(help_);
    keep_room(*message_, 2);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    complete_->setToolTip(tr("Adds a row to the tables below for every name that has none yet"));
    complete_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    column->addWidget(edit_);
    column->addWidget(message_);
    column->addWidget(complete_);
    setFocusProxy(edit_);
    edit_->installEventFilter(this);
    connect(edit_, &QPlainTextEdit::textChanged, this, [this] {
        adapt_height();
        const QString text = edit_->toPlainText();
        typed_ = true;
        // A field with a default keeps an empty text: no value would bring the default back.
        emit edited(text.isEmpty() && default_.isEmpty() ? SetupValue() : SetupValue(to_std(text)));
    });
    connect(complete_, &QPushButton::clicked, this, &LinesEditor::complete);
    connect(&document_, &Document::project_changed, this, &LinesEditor::refresh_completion);
    refresh_completion();
    adapt_height();
}

void LinesEditor::set_value(const SetupValue& value) {
    const std::string* text = std::get_if<std::string>(&value);
    const QString shown = text ? to_qt(*text) : QString();
    if (edit_->toPlainText() == shown) return;
    const QSignalBlocker quiet(edit_);
    edit_->setPlainText(shown);
    adapt_height();
}

void LinesEditor::set_complaint(const QString& complaint) {
    mark(*edit_, complaint, help_);
    show_note(*message_, complaint);
}

void LinesEditor::set_problem_places(const std::vector<std::string>& places) {
    QList<QTextEdit::ExtraSelection> marks;
    for (const std::string& place : places) {
        const auto part = part_of(place);
        if (!part) continue;
        QTextEdit::ExtraSelection mark;
        mark.cursor = cursor_at(edit_->document(), *part);
        mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        mark.format.setUnderlineColor(QColor(0xd5, 0x5e, 0x00));
        mark.format.setBackground(QColor(0xd5, 0x5e, 0x00, 56));
        marks.push_back(mark);
    }
    edit_->setExtraSelections(marks);
}

void LinesEditor::focus_part(const std::string& path) {
    if (const auto part = part_of(path)) {
        QTextCursor cursor = cursor_at(edit_->document(), *part);
        cursor.setPosition(cursor.selectionStart());
        edit_->setTextCursor(cursor);
    } else if (edit_->toPlainText() == default_) {
        edit_->selectAll();  // an example, to be typed over
    }
    edit_->setFocus(Qt::OtherFocusReason);
}

bool LinesEditor::eventFilter(QObject* watched, QEvent* event) {
    if (watched == edit_ && event->type() == QEvent::Resize) adapt_height();  // lines are broken anew
    if (watched == edit_ && event->type() == QEvent::FocusOut && typed_) {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        typed_ = reason == Qt::PopupFocusReason || reason == Qt::ActiveWindowFocusReason;
        if (!typed_ && complete_->isEnabled()) complete();
    }
    return FieldEditor::eventFilter(watched, event);
}

void LinesEditor::adapt_height() {
    // The size of a document of plain text is in lines.
    const int needed = int(edit_->document()->documentLayout()->documentSize().height());
    const int lines = std::clamp(needed + 1, fewest_lines, most_lines);
    const int frame = 2 * edit_->frameWidth() + 2 * int(edit_->document()->documentMargin());
    edit_->setFixedHeight(lines * edit_->fontMetrics().lineSpacing() + frame);
}

void LinesEditor::refresh_completion() {
    const Setup* setup = find_setup(document_.project(), address_);
    const auto completed = setup ? completed_setup(document_.project(), address_) : std::nullopt;
    complete_->setVisible(completed.has_value());
    complete_->setEnabled(completed && !(*completed == *setup));
}

void LinesEditor::complete() {
    document_.apply(tr("Add rows for new names"), [this](Project& project) {
        const auto completed = completed_setup(project, address_);
        if (Setup* setup = find_setup(project, address_); setup && completed) *setup = *completed;
    });
}

}  // namespace covaria::ui
