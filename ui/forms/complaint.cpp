// The mark is a palette entry, so that it follows light and dark.
#include "ui/forms/complaint.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QPalette>
#include <QStringList>
#include <QVariant>
#include <algorithm>

#include "ui/theme/follow_font.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr const char* property = "complaint";

QColor mixed(const QColor& a, const QColor& b, float part) {
    return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * part,
                            a.greenF() + (b.greenF() - a.greenF()) * part,
                            a.blueF() + (b.blueF() - a.blueF()) * part);
}

constexpr const char* note = "note";  // the whole text of a label that shows what fits of it

void show_what_fits(QLabel& label) {
    label.setText(what_fits(label, label.property(note).toString()));
}

class NoteRoom : public QObject {
public:
    explicit NoteRoom(QLabel& label) : QObject(&label), label_(label) { label.installEventFilter(this); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Resize) show_what_fits(label_);
        return QObject::eventFilter(watched, event);
    }

private:
    QLabel& label_;
};

template <class Is>
QString words_where(const Problems& problems, Is is) {
    QStringList words;
    for (const Problem& problem : problems.items())
        if (is(problem.path)) words << to_qt(problem.message);
    return words.join(QLatin1Char('\n'));
}

}  // namespace

QString what_fits(const QLabel& label, const QString& text) {
    const int margins = 2 * label.margin();
    const QRect room(0, 0, std::max(1, label.contentsRect().width() - margins), QWIDGETSIZE_MAX);
    const int height = label.contentsRect().height() - margins;
    const auto fits = [&](const QString& shown) {
        return label.fontMetrics().boundingRect(room, Qt::TextWordWrap, shown).height() <= height;
    };
    if (fits(text)) return text;
    qsizetype shown = 0;
    for (qsizetype step = text.size(); step > 0; step /= 2)
        while (shown + step <= text.size() && fits(text.left(shown + step) + QChar(u'…'))) shown += step;
    return text.left(shown).trimmed() + QChar(u'…');
}

void mark(QWidget& widget, const QString& complaint, const QString& help) {
    widget.setToolTip(complaint.isEmpty() ? help : complaint);
    widget.setAccessibleDescription(widget.toolTip());
    if (complaint_of(widget) == complaint) return;
    widget.setProperty(property, complaint);
    QPalette palette;  // resolved against the application's: only the roles set here stay fixed
    // A table marks its cells itself.
    if (!complaint.isEmpty() && !qobject_cast<QAbstractItemView*>(&widget)) {
        const QPalette usual = widget.parentWidget() ? widget.parentWidget()->palette() : QPalette();
        for (const QPalette::ColorRole role : {QPalette::Base, QPalette::Button})
            palette.setColor(role, mixed(usual.color(role), QColor(213, 94, 0), 0.25f));
    }
    widget.setPalette(palette);
}

void keep_room(QLabel& label, int lines) {
    label.setWordWrap(true);
    label.setAlignment(Qt::AlignTop | Qt::AlignLeft);
    new NoteRoom(label);
    follow_font(label,
                [&label, lines] { label.setFixedHeight(lines * label.fontMetrics().lineSpacing() + 2); });
}

void show_note(QLabel& label, const QString& text) {
    label.setProperty(note, text);
    label.setToolTip(text);
    show_what_fits(label);
}

QString complaint_of(const QWidget& widget) {
    return widget.property(property).toString();
}

QString problems_at(const Problems& problems, const std::string& path) {
    return words_where(problems, [&](const std::string& at) { return at == path; });
}

QString problems_below(const Problems& problems, const std::string& place) {
    return words_where(problems,
                       [within = place + "/"](const std::string& at) { return at.starts_with(within); });
}

}  // namespace covaria::ui
