// The theme as style, palette and font of the application.
#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QToolTip>

#include "ui/theme/fonts.h"
#include "ui/theme/style.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

QPalette palette_of(const Tokens& t, bool dark) {
    QPalette palette(t.panel);
    palette.setColor(QPalette::Window, t.panel);
    palette.setColor(QPalette::Base, t.stage);
    palette.setColor(QPalette::AlternateBase, t.stage);
    palette.setColor(QPalette::Button, t.stage);
    palette.setColor(QPalette::ToolTipBase, dark ? t.panel.lighter(120) : t.stage);
    palette.setColor(QPalette::Mid, t.line2);
    palette.setColor(QPalette::Midlight, t.line);
    palette.setColor(QPalette::Dark, t.field_line);
    palette.setColor(QPalette::Light, dark ? t.hover : t.stage);
    palette.setColor(QPalette::Highlight, t.blue);
    palette.setColor(QPalette::HighlightedText, t.on_blue);
    palette.setColor(QPalette::Link, t.blue);
    palette.setColor(QPalette::LinkVisited, t.blue);
    palette.setColor(QPalette::PlaceholderText, t.ink3);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, t.ink);
        palette.setColor(QPalette::Disabled, role, t.ink3);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, t.hover);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, t.ink3);
    return palette;
}

/// A selected row is tinted; its inks stay.
QPalette palette_of_rows(QPalette palette, const Tokens& t) {
    palette.setColor(QPalette::Highlight, t.tint);
    palette.setColor(QPalette::HighlightedText, t.ink);
    return palette;
}

/// Bars of the window.
QPalette palette_of_bars(QPalette palette, const Tokens& t) {
    for (const auto role : {QPalette::Window, QPalette::Button}) palette.setColor(role, t.chrome);
    palette.setColor(QPalette::Highlight, t.tint);
    palette.setColor(QPalette::HighlightedText, t.ink);
    return palette;
}

}  // namespace

void apply_theme(QApplication& application, const Theme& theme, const FontChoice& chosen) {
    const Tokens& tokens = theme.tokens();
    const QPalette palette = palette_of(tokens, theme.is_dark());
    if (!dynamic_cast<Style*>(application.style())) application.setStyle(new Style);
    application.setPalette(palette);
    const QFont font = application_font(chosen);
    if (font != QApplication::font()) application.setFont(font);
    for (const char* rows : {"QAbstractItemView", "QMenu"})
        QApplication::setPalette(palette_of_rows(palette, tokens), rows);
    for (const char* bar : {"QMenuBar", "QStatusBar"})
        QApplication::setPalette(palette_of_bars(palette, tokens), bar);
    QApplication::setFont(sized(font, TextSize::small), "QHeaderView");
    QToolTip::setPalette(palette);
}

}  // namespace covaria::ui
