// Colours and fonts of the program, light and dark: neutral greys, one accent, colour only for data.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>

#include "core/report/plot_specification.h"

class QApplication;

namespace covaria::ui {

class Theme {
public:
    static const Theme& light();
    static const Theme& dark();

    bool is_dark() const { return dark_; }
    QColor window() const { return window_; }  ///< ground of panes
    QColor base() const { return base_; }      ///< ground of charts, tables, fields
    QColor text() const { return text_; }
    QColor quiet_text() const { return quiet_; }
    QColor line() const { return line_; }  ///< grid lines, frames
    QColor accent() const { return accent_; }
    /// Okabe-Ito colours (Okabe & Ito 2008, "Color universal design"), lightened on dark ground where they
    /// need it.
    QColor of(SeriesRole role) const;
    /// Diverging map for t in [-1, 1]: blue, ground, vermillion.
    QColor diverging(double t) const;
    QPalette palette() const;

private:
    explicit Theme(bool dark);
    bool dark_;
    QColor window_, base_, text_, quiet_, line_, accent_;
};

/// The program's font: Inter, else Liberation Sans, else DejaVu Sans; figures of equal width.
QFont application_font();
/// Fusion style, palette and font for the whole program.
void apply_theme(QApplication& application, const Theme& theme);

}  // namespace covaria::ui
