// The fonts of the window, charts and pictures: Inter where it is installed, else Liberation Sans, DejaVu
// Sans.
#pragma once

#include <QFont>

namespace covaria::ui {

/// Family of running text.
QString text_family();
/// Family of numbers: the first whose figures are all equally wide.
QString figures_family();

/// Font of the whole application, of the desktop's size.
QFont application_font();
/// Same size and weight, with figures of equal width: numbers in tables, ticks, read-outs.
QFont with_tabular_figures(QFont font);

}  // namespace covaria::ui
