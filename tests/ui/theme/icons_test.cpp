// The project's own icons: all there, in the palette's colours, sharp at 2x.
#include "ui/theme/icons.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QSvgRenderer>

#include "tests/ui/qt_application.h"
#include "ui/theme/theme.h"

namespace covaria::ui::icons_test {
namespace {

QStringList shipped_icons() {
    QStringList names;
    const QDir folder(QStringLiteral(COVARIA_SOURCE_DIR "/resources/icons"));
    for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("*.svg")}, QDir::Files))
        names << file.completeBaseName();
    return names;
}

int inked_pixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += qAlpha(image.pixel(x, y)) > 100;
    return count;
}

/// Mean grey of what is drawn.
double grey_of(const QImage& image) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qAlpha(image.pixel(x, y)) > 200) {
                sum += qGray(image.pixel(x, y));
                ++count;
            }
    return count > 0 ? sum / count : -1.0;
}

TEST(Icons, EveryDrawingIsValidAndShowsSomething) {
    apply_theme(*qApp, Theme::light());
    ASSERT_GT(shipped_icons().size(), 30);
    for (const QString& name : shipped_icons()) {
        EXPECT_TRUE(
            QSvgRenderer(QStringLiteral(COVARIA_SOURCE_DIR "/resources/icons/%1.svg").arg(name)).isValid())
            << name.toStdString();
        const QImage image = icon(name).pixmap(24, 24).toImage();
        EXPECT_GT(inked_pixels(image), 20) << name.toStdString();
    }
}

TEST(Icons, FollowThePalette) {
    apply_theme(*qApp, Theme::light());
    const QIcon run = icon(QStringLiteral("run"));
    const double on_light = grey_of(run.pixmap(24, 24).toImage());
    const double disabled = grey_of(run.pixmap(QSize(24, 24), QIcon::Disabled).toImage());
    apply_theme(*qApp, Theme::dark());
    const double on_dark = grey_of(run.pixmap(24, 24).toImage());
    apply_theme(*qApp, Theme::light());
    EXPECT_LT(on_light, 60.0);
    EXPECT_GT(on_dark, 200.0);
    EXPECT_GT(disabled, on_light + 50.0);
}

TEST(Icons, AreSharpOnDenseScreens) {
    const QImage dense = icon(QStringLiteral("open")).pixmap(QSize(24, 24), 2.0).toImage();
    EXPECT_EQ(dense.size(), QSize(48, 48));
    EXPECT_GT(inked_pixels(dense), 3 * inked_pixels(icon(QStringLiteral("open")).pixmap(24, 24).toImage()));
}

TEST(Icons, StandInForADesktopWithoutIcons) {
    QIcon::setThemeName(QStringLiteral("no-such-theme"));
    for (const char* name : {"new", "open", "save", "undo", "redo", "run", "stop", "live", "export"})
        EXPECT_FALSE(icon(QString::fromLatin1(name)).isNull()) << name;
    EXPECT_TRUE(icon(QStringLiteral("no-such-icon")).isNull());
}

}  // namespace
}  // namespace covaria::ui::icons_test
