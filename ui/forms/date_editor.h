// Editor of a date, or of the first and the last day of an interval: typed, or chosen from a calendar.
#pragma once

#include <QDate>
#include <QLineEdit>
#include <optional>

#include "ui/forms/field_editor.h"

namespace covaria::ui {

/// Reads "2026-04-17", "17.4.2026", "20260417".
std::optional<QDate> read_date(const QString& text);

/// A value is an ISO 8601 date, or two of them with '/' between them. What cannot be read stays in the field
/// and is remembered as unread.
class DateEditor : public FieldEditor {
    Q_OBJECT
public:
    enum class Days { one, interval };
    DateEditor(const FieldSpec& field, Days days, Document& document, TextPlace place, QWidget* parent);
    void set_value(const SetupValue& value) override;
    void set_complaint(const QString& complaint) override;
    void set_hint(const QString& hint) override;

private:
    QLineEdit* add_line(const FieldSpec& field, const QString& name);
    void open_calendar(QLineEdit& line);
    void take();
    void show_value();
    void show_marks();
    /// ISO text of what is typed; nothing where it cannot be read, with the reason.
    std::optional<QString> typed(QString& reason) const;
    QString words() const;

    UnreadTexts& unread_;
    TextPlace place_;
    QLineEdit* first_ = nullptr;
    QLineEdit* last_ = nullptr;  ///< the end of an interval
    QString value_;              ///< the project's value
    QString reason_;             ///< why what is typed cannot be read
    QString complaint_, help_;
};

}  // namespace covaria::ui
