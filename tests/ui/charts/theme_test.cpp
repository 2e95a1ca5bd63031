// Colours that can be read and told apart, in both themes; the application's palette and font.
#include "ui/theme/theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFontMetricsF>
#include <QPalette>
#include <QProxyStyle>
#include <QStyle>

#include "ui/theme/fonts.h"

namespace covaria::ui::theme_test {
namespace {

constexpr SeriesRole roles[] = {SeriesRole::data,        SeriesRole::fit,         SeriesRole::reference,
                                SeriesRole::first_order, SeriesRole::monte_carlo, SeriesRole::emphasis};

TEST(Theme, InksCanBeReadOnEveryGround) {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
        const Tokens& t = theme.tokens();
        for (const QColor& ground : {t.chrome, t.panel, t.stage, t.hover, t.tint})
            for (const QColor& ink : {t.ink, t.ink2, t.ink3, t.blue})
                EXPECT_GE(contrast(ink, ground), 4.5)
                    << ink.name().toStdString() << " on " << ground.name().toStdString();
        EXPECT_GE(contrast(t.on_blue, t.blue), 4.5);
        EXPECT_GE(contrast(t.green, t.green_tint), 4.5);
        EXPECT_GE(contrast(t.red, t.red_tint), 4.5);
        for (const QColor& ground : {t.panel, t.stage}) {
            EXPECT_GE(contrast(t.field_line, ground), 2.9) << "what can be typed into is seen";
            for (const QColor& sign : {t.green, t.red}) EXPECT_GE(contrast(sign, ground), 4.5);
        }
        EXPECT_GE(contrast(t.orange, t.stage), 2.8) << "fills, beside their figures";
    }
}

TEST(Theme, ColoursStandOutFromTheGround) {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
        const Tokens& n = theme.tokens();
        EXPECT_GE(contrast(n.ink, n.stage), 10.0);
        EXPECT_GE(contrast(n.ink, n.panel), 10.0);
        EXPECT_GE(contrast(n.ink2, n.stage), 4.5);
        EXPECT_GE(contrast(n.ink2, n.panel), 4.5);
        EXPECT_GE(contrast(n.on_blue, n.blue), 4.5);
        for (const SeriesRole role : roles)
            EXPECT_GE(contrast(theme.series(role), n.stage), 3.0) << int(role);
    }
    EXPECT_TRUE(Theme::dark().is_dark());
}

TEST(Theme, MagnitudesGetSteadilyLighter) {
    const Theme theme = Theme::light();
    double last = 0.0;
    for (int i = 0; i <= 40; ++i) {
        const double now = contrast(theme.sequential(i / 40.0), Qt::black);
        EXPECT_GT(now, last) << i;
        last = now;
    }
    EXPECT_EQ(theme.sequential(-1.0), theme.sequential(0.0));
}

TEST(Theme, DivergingMapIsNeutralInTheMiddle) {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
        EXPECT_LT(contrast(theme.diverging(0.0), theme.tokens().stage), 1.3);
        for (const double sign : {-1.0, 1.0}) {
            EXPECT_GT(contrast(theme.diverging(sign), theme.tokens().stage), 4.5);
            EXPECT_GT(contrast(theme.diverging(sign), theme.tokens().stage),
                      contrast(theme.diverging(0.5 * sign), theme.tokens().stage));
        }
        for (int i = -20; i <= 20; ++i) {
            const QColor colour = theme.diverging(i / 20.0);
            EXPECT_GE(contrast(Theme::text_on(colour), colour), 4.0) << i;
        }
    }
}

TEST(Theme, ContrastIsThatOfTheGuidelines) {
    EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-6);
    EXPECT_NEAR(contrast(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.01);
}

TEST(ApplyTheme, SetsStylePaletteAndFont) {
    for (const Theme& theme : {Theme::dark(), Theme::light()}) {
        apply_theme(*qApp, theme);
        const auto* style = qobject_cast<const QProxyStyle*>(QApplication::style());
        ASSERT_NE(style, nullptr);
        EXPECT_EQ(style->baseStyle()->name(), QStringLiteral("fusion"));
        EXPECT_EQ(QApplication::palette().color(QPalette::Base), theme.tokens().stage);
        EXPECT_EQ(QApplication::palette().color(QPalette::Disabled, QPalette::Text), theme.tokens().ink3);
        EXPECT_EQ(QApplication::font().family(), text_family());
    }
}

// Dim text is read too: hints, notes, what is out of date or of a skewed distribution.
TEST(ApplyTheme, DimTextCanBeReadOnEveryGround) {
    for (const Theme& theme : {Theme::dark(), Theme::light()}) {
        apply_theme(*qApp, theme);
        const QPalette palette = QApplication::palette();
        const QColor dim[] = {palette.color(QPalette::PlaceholderText),
                              palette.color(QPalette::Disabled, QPalette::Text),
                              palette.color(QPalette::Disabled, QPalette::WindowText),
                              palette.color(QPalette::Disabled, QPalette::ButtonText), theme.tokens().ink2};
        for (const QColor& ink : dim) {
            for (const auto ground :
                 {QPalette::Base, QPalette::AlternateBase, QPalette::Window, QPalette::Button})
                EXPECT_GE(contrast(ink, palette.color(ground)), 4.5)
                    << theme.is_dark() << ' ' << ink.name().toStdString() << " on " << int(ground);
            EXPECT_GE(contrast(theme.tokens().ink, ink), 1.5) << "it stands back";
        }
        EXPECT_GE(contrast(palette.color(QPalette::Disabled, QPalette::HighlightedText),
                           palette.color(QPalette::Disabled, QPalette::Highlight)),
                  4.5);
    }
}

TEST(Fonts, FiguresAreEquallyWide) {
    QFont font = with_tabular_figures(application_font());
    font.setPixelSize(100);
    font.setHintingPreference(QFont::PreferNoHinting);
    const QFontMetricsF metrics(font);
    for (char16_t digit = u'1'; digit <= u'9'; ++digit)
        EXPECT_NEAR(metrics.horizontalAdvance(QChar(digit)), metrics.horizontalAdvance(u'0'), 0.5);
}

}  // namespace
}  // namespace covaria::ui::theme_test
