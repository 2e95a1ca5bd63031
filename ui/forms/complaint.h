// Marks a field as wrong: tinted ground, the reason as tooltip and for screen readers.
#pragma once

#include <QLabel>
#include <QString>
#include <QWidget>
#include <string>

#include "core/base/error.h"

namespace covaria::ui {

/// An empty complaint removes the mark; `help` is the tooltip of a field that is right.
void mark(QWidget& widget, const QString& complaint, const QString& help);
/// A label for messages that come and go: its room of `lines` is always there, so that nothing below jumps;
/// a text that does not fit ends with "…", and is in the tooltip.
void keep_room(QLabel& label, int lines);
void show_note(QLabel& label, const QString& text);
/// The part of the text that the label has lines for; it ends with "…" where it was cut.
QString what_fits(const QLabel& label, const QString& text);
/// Words of the problems at a place of the project, and at all places below one; a line each.
QString problems_at(const Problems& problems, const std::string& path);
QString problems_below(const Problems& problems, const std::string& place);
/// The complaint shown; empty when there is none.
QString complaint_of(const QWidget& widget);

}  // namespace covaria::ui
