// The icons drawn for Covaria in resources/icons, in the window's colours: one set with one line width,
// whatever the desktop has.
#pragma once

#include <QIcon>
#include <QString>

namespace covaria::ui {

/// `name` is that of a file in resources/icons without its ending. Drawn in the palette's colours of the
/// moment: it follows a switch between light and dark by itself. A null icon for a name nobody knows.
QIcon icon(const QString& name);

}  // namespace covaria::ui
