// Marks a field as wrong: tinted ground, the reason as tooltip and for screen readers.
#pragma once

#include <QString>
#include <QWidget>

namespace covaria::ui {

/// An empty complaint removes the mark; `help` is the tooltip of a field that is right.
void mark(QWidget& widget, const QString& complaint, const QString& help);
/// The complaint shown; empty when there is none.
QString complaint_of(const QWidget& widget);

}  // namespace covaria::ui
