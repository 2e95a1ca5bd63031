// Colours of the window and of charts, light and dark: neutral greys, blue for outputs, orange for inputs,
// green and red for verdicts.
#pragma once

#include <QColor>
#include <QPalette>

#include "core/text/numbers.h"
#include "core/text/plot_specification.h"
#include "ui/theme/fonts.h"

class QApplication;

namespace covaria::ui {

/// Ground of a cell or field whose text is not taken, laid over the usual one.
inline QColor refused_ground() {
    return QColor(213, 94, 0, 60);
}

/// The colours of everything in the window. Inks reach a contrast of 4.5 on every ground.
struct Tokens {
    QColor chrome;             ///< bars
    QColor panel;              ///< tree, inspector, forms
    QColor stage;              ///< tables, charts, fields
    QColor line;               ///< between rows and groups, behind data
    QColor line2;              ///< below heads, around totals, zero of a chart
    QColor field_line;         ///< around what can be typed into or pressed
    QColor hover;              ///< under the mouse, a neutral chip, a shaded range
    QColor ink;                ///< text to be read first
    QColor ink2;               ///< labels, heads, axis titles
    QColor ink3;               ///< units, hints, what cannot be used
    QColor blue;               ///< outputs, focus, links
    QColor on_blue;            ///< text on blue
    QColor fill;               ///< outputs in charts
    QColor tint;               ///< the selected row
    QColor orange;             ///< inputs; fills only, never text
    QColor type_a;             ///< inputs evaluated by Type A
    QColor green, green_tint;  ///< a requirement is met, and the ground of its chip
    QColor red, red_tint;      ///< it is not, or something failed
};

class Theme {
public:
    static Theme light();
    static Theme dark();
    /// The theme whose ground is that of the palette's windows.
    static Theme of(const QPalette& palette);

    bool is_dark() const { return dark_; }
    /// Writing of numbers in charts: that of the document's language, or in the window that of the user's
    /// locale.
    const NumberLocale& numbers() const { return numbers_; }
    Theme with_numbers(const NumberLocale& numbers) const;
    const Tokens& tokens() const { return tokens_; }
    /// Results are blue; families beside them have Okabe and Ito's colours (Color Universal Design, 2008), on
    /// dark ground their lighter ones.
    QColor series(SeriesRole role) const;
    /// Filling of bars of that role: between the role's colour and the ground.
    QColor filling(SeriesRole role) const;
    /// Perceptually uniform magnitude, 0 <= t <= 1 (clamped): control points of viridis (S. van der Walt, N.
    /// Smith, 2015, CC0), interpolated.
    QColor sequential(double t) const;
    /// Blue, neutral, vermilion for -1 <= t <= 1 (clamped); 0 is close to the ground.
    QColor diverging(double t) const;
    /// Black or white, whichever reads better on `ground` (relative luminance of WCAG 2.1).
    static QColor text_on(const QColor& ground);

private:
    Theme(bool dark, Tokens tokens) : dark_(dark), tokens_(std::move(tokens)) {}
    bool dark_;
    Tokens tokens_;
    NumberLocale numbers_;
};

/// Tokens of the theme whose panels have the colour of the palette's windows.
const Tokens& tokens_of(const QPalette& palette);

/// Contrast ratio of two colours, 1 to 21 (WCAG 2.1).
double contrast(const QColor& a, const QColor& b);
/// Part of the way from one colour to another, 0 <= t <= 1.
QColor mix(const QColor& from, const QColor& to, double t);

/// Fusion style, palette and font for the whole application; may be called again to switch.
void apply_theme(QApplication& application, const Theme& theme, const FontChoice& font = {});

}  // namespace covaria::ui
