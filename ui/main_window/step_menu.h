// The list of all steps that can be undone or done again.
#pragma once

#include "ui/document/document.h"

class QMenu;
class QWidget;

namespace covaria::ui {

/// A menu of steps, newest first, with the last done one checked; choosing one leads back or forth to it.
QMenu* make_step_menu(Document& document, QWidget* parent);

}  // namespace covaria::ui
