// A line for a number with a unit: "0.5 um" in a field of millimetres, "1,5" where the locale writes so.
#pragma once

#include <QLineEdit>
#include <optional>

#include "core/base/unit.h"
#include "core/setup/setup_schema.h"
#include "ui/document/unread_texts.h"

namespace covaria::ui {

/// A line for a quantity. A text that cannot be read stays in it, marked, with the reason as tooltip.
class QuantityEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit QuantityEdit(QWidget* parent = nullptr);

    /// Unit of a number typed without one.
    void set_unit(const Unit& unit);
    /// Off: whatever unit is typed, the quantity is converted to that of `set_unit`.
    void set_keeps_unit(bool keeps) { keeps_unit_ = keeps; }
    /// The number is a difference or an uncertainty: converted without the zero of degC.
    void set_interval(bool interval) { interval_ = interval; }
    void set_range(const Range& range) { range_ = range; }
    void set_integer(bool integer) { integer_ = integer; }
    /// Off: the line must not be left empty.
    void set_optional(bool optional) { optional_ = optional; }
    void set_help(const QString& help);
    /// Shows a problem of the project; an own complaint about the text that is typed comes first.
    void set_complaint(const QString& complaint);

    /// Sets its place in the project: a text that cannot be read is kept in the document under this place,
    /// and shown again when the line comes back to it.
    void set_place(UnreadTexts& unread, const TextPlace& place);

    /// Shows the quantity; a text being typed stays unless the value is another.
    void set_quantity(const std::optional<Quantity>& quantity);
    const std::optional<Quantity>& quantity() const { return quantity_; }
    bool is_valid() const { return own_complaint_.isEmpty(); }

signals:
    /// Enter, focus lost or arrow keys, with a valid text that means another quantity than before.
    void quantity_edited(const std::optional<covaria::Quantity>& quantity);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    Result<std::optional<Quantity>> parse() const;
    QString complaint_about(const std::optional<Quantity>& quantity) const;
    void commit();
    void step(int direction);
    void show_quantity();
    void show_mark();
    void complain(const QString& complaint);
    bool show_unread(const std::optional<Quantity>& quantity);
    void follow_unread();
    Unit typing_unit() const;

    Unit unit_;
    Range range_;
    bool keeps_unit_ = true;
    bool interval_ = false;
    bool integer_ = false;
    bool optional_ = true;
    QString help_;
    QString own_complaint_;
    QString outer_complaint_;
    std::optional<Quantity> quantity_;
    UnreadTexts* unread_ = nullptr;
    TextPlace place_;
};

}  // namespace covaria::ui
