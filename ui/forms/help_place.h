// What F1 shows: a widget says where its help is, a cell of a table by its model.
#pragma once

#include <QString>

class QWidget;

namespace covaria::ui {

/// For the widget and all in it that say nothing else.
void set_help_place(QWidget& widget, const QString& anchor);
/// Of the widget with the focus: its cell's, its own, else that of the nearest around it; empty: none says.
QString help_place(const QWidget* focus);

}  // namespace covaria::ui
