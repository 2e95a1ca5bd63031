// The page that F1 opens: a widget has its place in the help, a cell of a table has it from its model.
#pragma once

#include <QString>

class QWidget;

namespace covaria::ui {

/// Sets the place in the help for the widget, and for all in it that have none of their own.
void set_help_place(QWidget& widget, const QString& anchor);
/// Place in the help for the focus: its cell's, its own, else that of the nearest widget around; empty: none.
QString help_place(const QWidget* focus);

}  // namespace covaria::ui
