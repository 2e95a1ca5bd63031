#include "ui/forms/quantity_notes_edit.h"

#include <QSignalBlocker>

#include "ui/document/quantity_edits.h"

namespace covaria::ui {

QuantityNotesEdit::QuantityNotesEdit(Document& document, std::string analysis, QWidget* parent)
    : QPlainTextEdit(parent), document_(document), analysis_(std::move(analysis)) {
    setObjectName(QStringLiteral("quantity_notes"));
    setAccessibleName(tr("Notes on the quantity"));
    setPlaceholderText(tr("Why this figure, what was agreed: in the report, below the input quantities"));
    setTabChangesFocus(true);
    connect(this, &QPlainTextEdit::textChanged, this,
            [this] { set_quantity_notes(document_, analysis_, symbol_, toPlainText()); });
    connect(&document_, &Document::project_changed, this, &QuantityNotesEdit::refresh);
    refresh();
}

void QuantityNotesEdit::set_quantity(const std::string& symbol) {
    symbol_ = symbol;
    refresh();
}

void QuantityNotesEdit::refresh() {
    setEnabled(!symbol_.empty());
    const QString notes = quantity_notes(document_.project(), analysis_, symbol_);
    const QSignalBlocker quiet(this);
    if (notes != toPlainText()) setPlainText(notes);
}

}  // namespace covaria::ui
