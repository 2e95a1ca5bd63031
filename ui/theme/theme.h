// Colours of the window and of charts, light and dark: neutral greys, one accent, colour for data only.
#pragma once

#include <QColor>
#include <QPalette>

#include "core/text/numbers.h"
#include "core/text/plot_specification.h"
#include "ui/theme/fonts.h"

class QApplication;

namespace covaria::ui {

/// Greys and accent of the window.
struct Neutrals {
    QColor ground;     ///< of charts, tables, text fields
    QColor panel;      ///< of forms, docks, tool bars
    QColor text;       ///< what is read first
    QColor quiet;      ///< units, axis titles, notes
    QColor disabled;   ///< text that stands back, but is read: what cannot be used, hints, notes
    QColor rule;       ///< axes, borders
    QColor grid;       ///< thin lines behind data
    QColor band;       ///< a shaded range
    QColor accent;     ///< selection, links, focus
    QColor on_accent;  ///< text on the accent
};

class Theme {
public:
    static Theme light();
    static Theme dark();
    /// The one whose ground is that of the palette's windows.
    static Theme of(const QPalette& palette);

    bool is_dark() const { return dark_; }
    /// How numbers in charts are written: as the language of the document does; as the user writes them in
    /// the window.
    const NumberLocale& numbers() const { return numbers_; }
    Theme with_numbers(const NumberLocale& numbers) const;
    const Neutrals& neutrals() const { return neutrals_; }
    /// Okabe and Ito's colours (Color Universal Design, 2008), on dark ground their lighter ones.
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
    Theme(bool dark, Neutrals neutrals) : dark_(dark), neutrals_(std::move(neutrals)) {}
    bool dark_;
    Neutrals neutrals_;
    NumberLocale numbers_;
};

/// Contrast ratio of two colours, 1 to 21 (WCAG 2.1).
double contrast(const QColor& a, const QColor& b);
/// Part of the way from one colour to another, 0 <= t <= 1.
QColor mix(const QColor& from, const QColor& to, double t);

/// Fusion style, palette and font for the whole application; may be called again to switch.
void apply_theme(QApplication& application, const Theme& theme, const FontChoice& font = {});

}  // namespace covaria::ui
