// The mark is a palette entry, so that it follows light and dark.
#include "ui/forms/complaint.h"

#include <QAbstractItemView>
#include <QPalette>
#include <QVariant>

#include "ui/theme/follow_font.h"

namespace covaria::ui {

namespace {

constexpr const char* property = "complaint";

QColor mixed(const QColor& a, const QColor& b, float part) {
    return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * part,
                            a.greenF() + (b.greenF() - a.greenF()) * part,
                            a.blueF() + (b.blueF() - a.blueF()) * part);
}

}  // namespace

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
    follow_font(label,
                [&label, lines] { label.setFixedHeight(lines * label.fontMetrics().lineSpacing() + 2); });
}

void show_note(QLabel& label, const QString& text) {
    label.setText(text);
    label.setToolTip(text);
}

QString complaint_of(const QWidget& widget) {
    return widget.property(property).toString();
}

}  // namespace covaria::ui
