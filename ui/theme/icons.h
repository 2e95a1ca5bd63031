// Icons: those of the desktop's icon theme, else drawn for Covaria in resources/icons, in the window's
// colours.
#pragma once

#include <QIcon>
#include <QString>

namespace covaria::ui {

/// `name` is that of a file in resources/icons without its ending. An icon that the desktop does not have is
/// drawn in the palette's colours of the moment: it follows a switch between light and dark by itself.
/// A null icon for a name nobody knows.
QIcon icon(const QString& name);

/// The project's own icon only, whatever the desktop has.
QIcon own_icon(const QString& name);

}  // namespace covaria::ui
