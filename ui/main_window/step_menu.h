// The list of all steps that can be undone or done again.
#pragma once

#include "ui/document/document.h"

class QMenu;
class QWidget;

namespace covaria::ui {

/// Newest first, the last one that is done is checked; who chooses one is where it was done.
QMenu* make_step_menu(Document& document, QWidget* parent);

}  // namespace covaria::ui
