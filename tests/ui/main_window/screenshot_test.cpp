// Screenshots of every tab, light and dark, with no display. Each is looked at as numbers here (nothing
// empty, no pane without contents) and left in the build folder for people.
#include <QDir>
#include <QTabWidget>
#include <cmath>

#include "tests/ui/main_window/baseline_check.h"
#include "tests/ui/main_window/window_fixture.h"
#include "ui/main_window/theme_switch.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/results_pane.h"
#include "ui/scene_view/scene_panel.h"

namespace covaria::ui::screenshot_test {
namespace {

class Screenshots : public WindowFixture {
protected:
    QImage shoot(const QString& name) {
        settle();
        const QImage image = window_->grab().toImage();
        const QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        image.save(folder.filePath(name + density_ending() + QStringLiteral(".png")));
        if (has_baseline(name + density_ending())) {
            EXPECT_TRUE(matches_screenshot(
                image, QStringLiteral(COVARIA_SOURCE_DIR "/tests/ui/main_window/baselines"),
                name + density_ending()));
        }
        return image;
    }
    /// The stage with the results below the scene, charts in the dark, a document. Not the start page: it
    /// grows with every example.
    static bool has_baseline(const QString& name) {
        static const QStringList compared{QStringLiteral("scene-light"), QStringLiteral("charts-dark"),
                                          QStringLiteral("document-light"), QStringLiteral("scene-light-2x")};
        return compared.contains(name);
    }
    /// Told apart in file names: "-2x" where a pixel of the window is two of the display.
    QString density_ending() const {
        const double ratio = window_->devicePixelRatioF();
        return ratio == 1.0 ? QString() : QStringLiteral("-%1x").arg(ratio);
    }
    /// Part of the pixels of a region (of the window) that differ from its most frequent grey.
    static double busy_part(const QImage& image, const QRect& window_region) {
        const double ratio = image.devicePixelRatio();
        const QRect region(window_region.topLeft() * ratio, window_region.size() * ratio);
        std::vector<int> greys(256, 0);
        for (int y = region.top(); y <= region.bottom(); ++y)
            for (int x = region.left(); x <= region.right(); ++x)
                ++greys[std::size_t(qGray(image.pixel(x, y)))];
        const int most = *std::max_element(greys.begin(), greys.end());
        return 1.0 - double(most) / (double(region.width()) * region.height());
    }
    QRect rect_of(const QWidget& widget) const {
        return QRect(widget.mapTo(window_.get(), QPoint()), widget.size());
    }
};

TEST_F(Screenshots, StartPageOffersWhatToDo) {
    window_->findChild<ThemeSwitch*>()->choose(QStringLiteral("dark"));
    EXPECT_GT(busy_part(shoot(QStringLiteral("start-page-dark")), window_->rect()), 0.02);
    window_->findChild<ThemeSwitch*>()->choose(QStringLiteral("light"));
    const QImage image = shoot(QStringLiteral("start-page-light"));
    EXPECT_EQ(image.size(), QSize(1280, 800) * window_->devicePixelRatioF());
    EXPECT_GT(busy_part(image, window_->rect()), 0.02);
}

TEST_F(Screenshots, EveryTabShowsSomething) {
    open(project_copy());
    wait_until_idle();
    QTabWidget& tabs = window_->results().tabs();
    for (const char* theme : {"light", "dark"}) {
        window_->findChild<ThemeSwitch*>()->choose(QString::fromLatin1(theme));
        for (int tab = 0; tab < tabs.count(); ++tab) {
            if (!tabs.isTabVisible(tab)) continue;
            tabs.setCurrentIndex(tab);
            if (auto* report = qobject_cast<ReportPreview*>(tabs.widget(tab))) {
                EXPECT_TRUE(QTest::qWaitFor([&] { return report->page_count() > 0; }, 120'000));
            }
            const QImage image =
                shoot(QStringLiteral("%1-%2").arg(tabs.tabText(tab).toLower(), QString::fromLatin1(theme)));
            EXPECT_GT(busy_part(image, rect_of(*tabs.widget(tab))), 0.01)
                << tabs.tabText(tab).toStdString() << ' ' << theme;
            if (window_->scene().view().isVisible()) {
                // A picture of its new size comes when it is drawn.
                const QRect scene = rect_of(window_->scene().view());
                EXPECT_TRUE(QTest::qWaitFor(
                    [&] {
                        const QImage now = window_->grab().toImage();
                        return busy_part(now, scene) > 0.02;
                    },
                    20'000))
                    << "scene, " << theme << ", tab " << tab;
            }
        }
    }
}

}  // namespace
}  // namespace covaria::ui::screenshot_test
