// Editors of forms whose text is not cut while the form has room for it.
#pragma once

class QComboBox;
class QLineEdit;

namespace covaria::ui {

/// Keeps the box as wide as the chosen entry, and no wider than the page that the form scrolls in: the form
/// sets it below its label where both have no room in one line.
void keep_whole(QComboBox& box);
/// Keeps the line as wide as its text, but not while one types.
void keep_whole(QLineEdit& line);

}  // namespace covaria::ui
