// The fonts of the window, charts and pictures: Inter where it is installed, else Liberation Sans, DejaVu
// Sans; symbols and formulae in STIX, so that l, I and 1 differ.
#pragma once

#include <QFont>
#include <QString>
#include <QStringList>

namespace covaria::ui {

/// The user's choice of the window's font.
struct FontChoice {
    QString family = {};  ///< empty: ours
    int points = 0;       ///< 0: the desktop's
    bool operator==(const FontChoice&) const = default;
};

/// Family of running text.
QString text_family();
/// The family of running text, and those that its missing letters come from.
QStringList text_families();
QStringList figures_families();
/// Family of numbers: the first whose figures are all equally wide.
QString figures_family();

/// Font of the whole application. A family that is not installed is ours.
QFont application_font(const FontChoice& chosen = {});
/// 20, 15, 13 and 11 px where the text of the window has 13: the answer, titles, all else, and heads with
/// units and captions. The first two are semibold.
enum class TextSize { answer, title, text, small };
QFont sized(QFont font, TextSize size);
/// Font of formulae beside that text: a serif, as much larger as its small letters are lower.
QFont formula_font(QFont font);
/// Font of the symbol of a quantity in running text: that serif in italics.
QFont symbol_font(QFont font);
/// The font with figures of equal width: for numbers in tables, ticks, read-outs.
QFont with_tabular_figures(QFont font);

}  // namespace covaria::ui
