#include "ui/forms/date_editor.h"

#include <QAction>
#include <QCalendarWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QVBoxLayout>
#include <QWidgetAction>

#include "ui/forms/complaint.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

std::optional<QDate> read_date(const QString& text) {
    for (const QString& form : {QStringLiteral("yyyy-MM-dd"), QStringLiteral("yyyy-M-d"),
                                QStringLiteral("yyyyMMdd"), QStringLiteral("d.M.yyyy")})
        if (const QDate date = QDate::fromString(text.trimmed(), form); date.isValid() && date.year() > 999)
            return date;
    return std::nullopt;
}

DateEditor::DateEditor(const FieldSpec& field, Days days, Document& document, TextPlace place,
                       QWidget* parent)
    : FieldEditor(parent), unread_(document.unread()), place_(std::move(place)), help_(help_text(field)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    const QString key = to_qt(field.key);
    column->addWidget(first_ = add_line(field, key));
    if (days == Days::interval) {
        auto* row = new QHBoxLayout;
        row->setSpacing(6);
        row->addWidget(new QLabel(tr("to"), this));
        row->addWidget(last_ = add_line(field, key + QStringLiteral("/last")), 1);
        column->addLayout(row);
        last_->setAccessibleName(tr("%1, last day").arg(core_text(field.title)));
    }
    setFocusProxy(first_);
    connect(&unread_, &UnreadTexts::changed, this, [this] {
        if (reason_.isEmpty() || unread_.find(place_)) return;
        reason_.clear();
        show_value();
    });
}

QLineEdit* DateEditor::add_line(const FieldSpec& field, const QString& name) {
    auto* line = new QLineEdit(this);
    line->setObjectName(name);
    line->setAccessibleName(core_text(field.title));
    line->setToolTip(help_);
    QAction* calendar = line->addAction(icon(QStringLiteral("calendar")), QLineEdit::TrailingPosition);
    calendar->setToolTip(tr("Choose from a calendar"));
    connect(calendar, &QAction::triggered, this, [this, line] { open_calendar(*line); });
    // While a date is being typed it is no mistake: a whole one counts at once, another when it is left.
    connect(line, &QLineEdit::textEdited, this, [this] {
        QString reason;
        if (typed(reason)) take();
    });
    connect(line, &QLineEdit::editingFinished, this, [this, line] {
        if (!line->isModified()) return;
        take();
        if (reason_.isEmpty()) show_value();
    });
    return line;
}

void DateEditor::open_calendar(QLineEdit& line) {
    QMenu menu(this);
    auto* calendar = new QCalendarWidget(&menu);
    calendar->setAccessibleName(line.accessibleName());
    if (const auto date = read_date(line.text())) calendar->setSelectedDate(*date);
    auto* entry = new QWidgetAction(&menu);
    entry->setDefaultWidget(calendar);
    menu.addAction(entry);
    const auto choose = [&](QDate date) {
        line.setText(date.toString(Qt::ISODate));
        take();
        menu.close();
    };
    connect(calendar, &QCalendarWidget::clicked, &menu, choose);
    connect(calendar, &QCalendarWidget::activated, &menu, choose);
    QMetaObject::invokeMethod(calendar, qOverload<>(&QWidget::setFocus), Qt::QueuedConnection);
    menu.exec(line.mapToGlobal(QPoint(0, line.height())));
}

std::optional<QString> DateEditor::typed(QString& reason) const {
    QStringList days;
    for (const QLineEdit* line : {first_, last_}) {
        if (!line || line->text().trimmed().isEmpty()) continue;
        const auto date = read_date(line->text());
        if (!date) {
            reason = tr("“%1” is no date of the form 2026-04-17.").arg(line->text().trimmed());
            return std::nullopt;
        }
        days << date->toString(Qt::ISODate);
    }
    if (last_ && !last_->text().trimmed().isEmpty() && days.size() == 1)
        reason = tr("The first day is missing.");
    else if (days.size() == 2 && days[1] < days[0])
        reason = tr("The last day is before the first.");
    if (!reason.isEmpty()) return std::nullopt;
    if (days.size() == 2 && days[0] == days[1]) days.removeLast();
    return days.join(QLatin1Char('/'));
}

QString DateEditor::words() const {
    return last_ ? first_->text() + QLatin1Char('/') + last_->text() : first_->text();
}

void DateEditor::take() {
    QString reason;
    const auto value = typed(reason);
    reason_ = reason;
    show_marks();
    if (!value) return unread_.set(place_, {words(), reason, to_std(value_)});
    unread_.remove(place_);
    if (*value == value_) return;
    value_ = *value;
    emit edited(value->isEmpty() ? SetupValue() : SetupValue(to_std(*value)));
}

void DateEditor::set_value(const SetupValue& value) {
    const std::string* text = std::get_if<std::string>(&value);
    const QString of_project = text ? to_qt(*text) : QString();
    const bool typing = of_project == value_ && (first_->isModified() || (last_ && last_->isModified()));
    if (typing) return;
    value_ = of_project;
    const UnreadText* kept = unread_.find(place_);
    if (kept && to_qt(kept->instead_of) == value_) {
        reason_ = kept->reason;
        const qsizetype slash = kept->text.indexOf(QLatin1Char('/'));
        first_->setText(last_ ? kept->text.left(slash) : kept->text);
        if (last_) last_->setText(slash < 0 ? QString() : kept->text.mid(slash + 1));
        for (QLineEdit* line : {first_, last_})
            if (line) line->setModified(true);
        return show_marks();
    }
    reason_.clear();
    unread_.remove(place_);
    show_value();
}

void DateEditor::show_value() {
    const QStringList days = value_.split(QLatin1Char('/'));
    if (last_) {
        first_->setText(days.front());
        last_->setText(days.value(1));
        last_->setModified(false);
    } else {
        first_->setText(value_);
    }
    first_->setModified(false);
    show_marks();
}

void DateEditor::set_complaint(const QString& complaint) {
    complaint_ = complaint;
    show_marks();
}

void DateEditor::set_hint(const QString& hint) {
    for (QLineEdit* line : {first_, last_})
        if (line) line->setPlaceholderText(line == first_ ? hint : tr("the same day"));
}

void DateEditor::show_marks() {
    for (QLineEdit* line : {first_, last_})
        if (line) mark(*line, reason_.isEmpty() ? complaint_ : reason_, help_);
}

}  // namespace covaria::ui
