// The fonts of the window, charts and pictures: Inter where it is installed, else Liberation Sans, DejaVu
// Sans.
#pragma once

#include <QFont>
#include <QString>
#include <QStringList>

namespace covaria::ui {

/// Of the window.
struct FontChoice {
    QString family = {};  ///< empty: ours
    int points = 0;       ///< 0: the desktop's
    bool operator==(const FontChoice&) const = default;
};

/// Family of running text.
QString text_family();
/// The same, and those that its missing letters come from.
QStringList text_families();
QStringList figures_families();
/// Family of numbers: the first whose figures are all equally wide.
QString figures_family();

/// Font of the whole application. A family that is not installed is ours.
QFont application_font(const FontChoice& chosen = {});
/// Same size and weight, with figures of equal width: numbers in tables, ticks, read-outs.
QFont with_tabular_figures(QFont font);

}  // namespace covaria::ui
