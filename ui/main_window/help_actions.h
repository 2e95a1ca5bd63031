// Help: a page per measurement model, what the keys do, about.
#pragma once

#include "ui/document/document.h"
#include "ui/document/selection.h"

class QMenu;
class QWidget;

namespace covaria::ui {

/// The pages are those of the registered models; the first entry opens the page of the selected analysis
/// (F1).
void add_help_actions(QMenu& menu, QWidget& window, Selection& selection, Document& document);

/// A model's page as Markdown: summary, equations, notes, references, and the text of resources/help.
QString help_text(const std::string& model);

/// Versions of Covaria and of what it is built on.
QString about_text();

}  // namespace covaria::ui
