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

QPalette palette_of(const Neutrals& n, bool dark) {
    QPalette palette(n.panel);
    palette.setColor(QPalette::Window, n.panel);
    palette.setColor(QPalette::Base, n.ground);
    palette.setColor(QPalette::AlternateBase, mix(n.ground, n.panel, 0.6));
    palette.setColor(QPalette::Button, n.panel);
    palette.setColor(QPalette::ToolTipBase, dark ? n.panel.lighter(120) : n.ground);
    palette.setColor(QPalette::Mid, n.rule);
    palette.setColor(QPalette::Dark, dark ? n.panel.darker(160) : n.panel.darker(135));
    palette.setColor(QPalette::Light, dark ? n.panel.lighter(130) : QColor(Qt::white));
    palette.setColor(QPalette::Highlight, n.accent);
    palette.setColor(QPalette::HighlightedText, n.on_accent);
    palette.setColor(QPalette::Link, n.accent);
    palette.setColor(QPalette::LinkVisited, n.accent);
    palette.setColor(QPalette::PlaceholderText, n.disabled);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, n.text);
        palette.setColor(QPalette::Disabled, role, n.disabled);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, n.band);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, n.disabled);
    return palette;
}

}  // namespace

void apply_theme(QApplication& application, const Theme& theme, const FontChoice& chosen) {
    const QPalette palette = palette_of(theme.neutrals(), theme.is_dark());
    if (!dynamic_cast<Style*>(application.style())) application.setStyle(new Style);
    application.setPalette(palette);
    const QFont font = application_font(chosen);
    if (font != QApplication::font()) application.setFont(font);
    QToolTip::setPalette(palette);
}

}  // namespace covaria::ui
