// Parsing is that of ui/document/quantity_text.h.
#include "ui/forms/quantity_edit.h"

#include <QKeyEvent>
#include <cmath>

#include "ui/document/quantity_text.h"
#include "ui/document/setup_cells.h"
#include "ui/forms/complaint.h"
#include "ui/theme/number_locale.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

std::string written(const std::optional<Quantity>& quantity) {
    return quantity ? to_std(quantity_text(*quantity, QLocale::c())) : std::string();
}

}  // namespace

QuantityEdit::QuantityEdit(QWidget* parent) : QLineEdit(parent) {
    setAlignment(Qt::AlignRight);
    connect(this, &QLineEdit::editingFinished, this, &QuantityEdit::commit);
    connect(this, &QLineEdit::textEdited, this, [this] {
        if (own_complaint_.isEmpty())
            return;  // complaints come when typing is over, and go as soon as they can
        const auto parsed = parse();
        own_complaint_ = parsed ? complaint_about(*parsed) : to_qt(parsed.error().message);
        show_mark();
    });
}

void QuantityEdit::set_unit(const Unit& unit) {
    unit_ = unit;
    setPlaceholderText(unit == Unit() ? QString() : to_qt(unit.display()));
    if (!isModified()) show_quantity();
}

void QuantityEdit::set_help(const QString& help) {
    help_ = help;
    show_mark();
}

void QuantityEdit::set_complaint(const QString& complaint) {
    outer_complaint_ = complaint;
    show_mark();
}

void QuantityEdit::show_mark() {
    mark(*this, own_complaint_.isEmpty() ? outer_complaint_ : own_complaint_, help_);
}

Unit QuantityEdit::typing_unit() const {
    return keeps_unit_ && quantity_ ? quantity_->unit : unit_;
}

Result<std::optional<Quantity>> QuantityEdit::parse() const {
    auto parsed = parse_quantity(text(), typing_unit(), locale());
    if (parsed && *parsed && !keeps_unit_) {
        const auto convert = interval_ ? converted_interval : converted;
        **parsed = Quantity{convert((**parsed).value, (**parsed).unit, unit_), unit_};
    }
    return parsed;
}

QString QuantityEdit::complaint_about(const std::optional<Quantity>& quantity) const {
    if (!quantity) return optional_ ? QString() : tr("A value is needed here.");
    if (integer_ && quantity->value != std::round(quantity->value))
        return tr("A whole number is needed here.");
    return range_complaint(range_, quantity->si(), quantity->unit, locale());
}

void QuantityEdit::set_place(UnreadTexts& unread, const TextPlace& place) {
    if (!unread_) connect(&unread, &UnreadTexts::changed, this, &QuantityEdit::follow_unread);
    if (unread_ && place == place_) return;
    unread_ = &unread;
    place_ = place;
    own_complaint_.clear();  // was about the place before
    setModified(false);
}

/// Shows the text that could not be read here, if there is one and the project's value is still the same.
bool QuantityEdit::show_unread(const std::optional<Quantity>& quantity) {
    const UnreadText* kept = unread_ ? unread_->find(place_) : nullptr;
    if (!kept || kept->instead_of != written(quantity)) return false;
    quantity_ = quantity;
    own_complaint_ = kept->reason;
    setText(kept->text);
    setModified(true);
    show_mark();
    return true;
}

/// Somebody else has settled what this line complained about.
void QuantityEdit::follow_unread() {
    if (own_complaint_.isEmpty() || hasFocus() || unread_->find(place_)) return;
    own_complaint_.clear();
    show_quantity();
    show_mark();
}

/// Remembers in the document that the text cannot be read, or that it can.
void QuantityEdit::complain(const QString& complaint) {
    own_complaint_ = complaint;
    show_mark();
    if (!unread_) return;
    if (complaint.isEmpty())
        unread_->remove(place_);
    else
        unread_->set(place_, {text(), complaint, written(quantity_)});
}

void QuantityEdit::set_quantity(const std::optional<Quantity>& quantity) {
    if (quantity == quantity_ && (isModified() || !own_complaint_.isEmpty())) return;
    if (show_unread(quantity)) return;
    quantity_ = quantity;
    show_quantity();
    complain({});
}

/// Digits are read in groups and behind a true minus sign, those of a computed value not all; edited as they
/// are.
void QuantityEdit::show_quantity() {
    QString shown = quantity_ ? quantity_text(*quantity_, locale()) : QString();
    if (quantity_ && !hasFocus())
        shown.replace(0, number_text(quantity_->value, locale()).size(),
                      to_qt(grouped_digits(format_typed(quantity_->value), number_locale(locale()))));
    if (hasFocus()) shown.replace(QChar(0x2212), QLatin1Char('-'));
    setText(shown);
    if (!hasFocus()) setCursorPosition(0);  // keeps the sign in sight where there is no room for all of it
    setModified(false);
}

void QuantityEdit::focusInEvent(QFocusEvent* event) {
    if (!isModified()) show_quantity();
    QLineEdit::focusInEvent(event);
}

void QuantityEdit::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (!isModified() && own_complaint_.isEmpty()) show_quantity();
}

void QuantityEdit::commit() {
    if (!isModified()) return;
    const auto parsed = parse();
    complain(parsed ? complaint_about(*parsed) : to_qt(parsed.error().message));
    if (!own_complaint_.isEmpty()) return;
    const bool changed = *parsed != quantity_;
    quantity_ = *parsed;
    show_quantity();
    if (changed) emit quantity_edited(quantity_);
}

void QuantityEdit::step(int direction) {
    const auto parsed = isModified() ? parse() : quantity_;
    if (!parsed || !*parsed) return;
    const QString number = number_text((**parsed).value, QLocale::c());
    const qsizetype point = number.indexOf('.');
    const int decimals = integer_ || point < 0 ? 0 : static_cast<int>(number.size() - point - 1);
    Quantity next = **parsed;
    next.value =
        QString::number(next.value + direction * std::pow(10.0, -decimals), 'f', decimals).toDouble();
    if (!complaint_about(next).isEmpty()) return;
    complain({});
    quantity_ = next;
    show_quantity();
    emit quantity_edited(quantity_);
}

/// Keeps the field's own keys: Escape and undo while something is typed; otherwise they are the
/// window's.
bool QuantityEdit::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Escape && isModified()) {
            key->accept();
            return true;
        }
        if (!isModified() && (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
            key->ignore();
            return false;
        }
    }
    return QLineEdit::event(event);
}

void QuantityEdit::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        step(event->key() == Qt::Key_Up ? 1 : -1);
    } else if (event->key() == Qt::Key_Escape && isModified()) {
        show_quantity();
        complain({});
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

}  // namespace covaria::ui
