// The chart in the window: zoom with the mouse, the value under the pointer, saving.
#include "ui/charts/chart_view.h"

#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include "tests/ui/charts/chart_test.h"
#include "ui/theme/strings.h"

namespace covaria::ui::chart_view_test {
namespace {

class ChartViewTest : public ::testing::Test {
protected:
    ChartViewTest() {
        view_.resize(700, 440);
        view_.set_plot(test::all_plots()[0]);
        view_.show();
        QCoreApplication::processEvents();
    }
    PlotGeometry geometry() const { return view_.chart().chart_layout().geometry; }
    QPoint pixel(double x, double y) const { return geometry().at(x, y).toPoint(); }
    void drag(QPoint from, QPoint to) {
        QTest::mousePress(view_.viewport(), Qt::LeftButton, {}, from);
        QTest::mouseMove(view_.viewport(), (from + to) / 2);
        QTest::mouseMove(view_.viewport(), to);
        QTest::mouseRelease(view_.viewport(), Qt::LeftButton, {}, to);
    }
    void wheel(QPoint at, int turns) {
        QWheelEvent event(at, view_.viewport()->mapToGlobal(at), {}, {0, 120 * turns}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view_.viewport(), &event);
    }
    ChartView view_;
};

TEST_F(ChartViewTest, RubberBandZoomsAndDoubleClickResets) {
    const PlotView whole = view_.chart().view();
    drag(pixel(-120.4, 0.8), pixel(-119.8, 0.2));
    EXPECT_TRUE(view_.is_zoomed());
    const double step = (whole.x_high - whole.x_low) / geometry().area.width();
    EXPECT_NEAR(view_.chart().view().x_low, -120.4, 1.5 * step);
    EXPECT_NEAR(view_.chart().view().x_high, -119.8, 1.5 * step);
    EXPECT_NEAR(view_.chart().view().y_high, 0.8, 0.01);
    QTest::mouseDClick(view_.viewport(), Qt::LeftButton, {}, pixel(-120.0, 0.5));
    EXPECT_FALSE(view_.is_zoomed());
}

/// Texts of the ticks of a chart with tenths on its axis.
QStringList texts_of(const ChartLayout& layout) {
    QStringList texts;
    for (const Tick& tick : layout.x.ticks) texts << to_qt(tick.text);
    return texts;
}

TEST_F(ChartViewTest, NumbersHaveTheDecimalMarkOfTheUserInTheWindowAndThePointInReports) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    ChartView german;
    german.resize(700, 440);
    german.set_plot(test::all_plots()[0]);
    german.show();
    QCoreApplication::processEvents();
    const QStringList shown = texts_of(german.chart().chart_layout());
    const QStringList printed =
        texts_of(layout_chart(test::all_plots()[0], {700, 440}, german.chart().view()));
    QLocale::setDefault(before);
    ASSERT_FALSE(shown.isEmpty());
    EXPECT_TRUE(shown.front().contains(u',')) << shown.front().toStdString();
    EXPECT_TRUE(printed.front().contains(u'.')) << printed.front().toStdString();
    EXPECT_EQ(QStringList(shown).replaceInStrings(",", "."), printed);
}

TEST_F(ChartViewTest, SeriesFollowTheZoom) {
    drag(pixel(-120.4, 0.8), pixel(-119.8, 0.2));
    const QImage image = view_.grab().toImage();
    const double x = -120.3, y = 0.398942 / 0.367 * std::exp(-0.5 * std::pow(0.3 / 0.367, 2));
    EXPECT_LE(test::nearest_difference(image, geometry().at(x, y), Theme::light().series(SeriesRole::fit)),
              48);
}

TEST_F(ChartViewTest, WheelKeepsThePointUnderThePointerAndStaysInside) {
    const QPoint at = pixel(-120.2, 0.5);
    const QPointF before = geometry().coordinates_at(at);
    wheel(at, 3);
    EXPECT_TRUE(view_.is_zoomed());
    EXPECT_NEAR(geometry().coordinates_at(at).x(), before.x(), 0.02);
    wheel(at, -20);
    EXPECT_FALSE(view_.is_zoomed()) << "zooming out stops at the whole";
}

TEST_F(ChartViewTest, KeysZoomToo) {
    QTest::keyClick(&view_, Qt::Key_Plus);
    EXPECT_TRUE(view_.is_zoomed());
    QTest::keyClick(&view_, Qt::Key_0);
    EXPECT_FALSE(view_.is_zoomed());
}

TEST_F(ChartViewTest, NewDataOfTheSameChartKeepTheZoom) {
    wheel(pixel(-120.0, 0.5), 2);
    const PlotView zoomed = view_.chart().view();
    view_.set_plot(test::all_plots()[0]);
    EXPECT_EQ(view_.chart().view(), zoomed);
    view_.set_plot(test::all_plots()[1]);
    EXPECT_FALSE(view_.is_zoomed());
}

TEST_F(ChartViewTest, ReadsOutTheValueUnderThePointer) {
    QSignalSpy spy(&view_, &ChartView::read_out_changed);
    QTest::mouseMove(view_.viewport(), pixel(-120.0, 0.5));
    ASSERT_GE(spy.size(), 1);
    const QString text = spy.takeLast().at(0).toString();
    EXPECT_TRUE(text.contains(QStringLiteral("x = −"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("mm"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("probability density = 1.0"))) << text.toStdString();
    QTest::mouseMove(view_.viewport(), QPoint(2, 2));
    EXPECT_EQ(spy.takeLast().at(0).toString(), QString());
}

TEST_F(ChartViewTest, SavesByEnding) {
    QTemporaryDir folder;
    for (const char* name : {"a.png", "a.svg", "a.csv"}) {
        const QString file = folder.filePath(QLatin1String(name));
        ASSERT_TRUE(view_.save(file)) << name;
        EXPECT_GT(QFileInfo(file).size(), 500) << name;
    }
    EXPECT_EQ(view_.save(folder.filePath("a.bmp")).error().code, ErrorCode::bad_input);
    EXPECT_EQ(view_.save(folder.filePath("no/a.png")).error().code, ErrorCode::io);
}

TEST_F(ChartViewTest, CopiesPictureAndData) {
    view_.copy_image();
    EXPECT_EQ(QApplication::clipboard()->image().size(), view_.viewport()->size() * 2);
    view_.copy_data();
    EXPECT_TRUE(QApplication::clipboard()->text().startsWith(QStringLiteral("Monte Carlo: x (mm),")));
}

TEST_F(ChartViewTest, AnEmptyPlotSaysWhatToDo) {
    view_.set_plot({});
    EXPECT_EQ(view_.plot().title, "Run the analysis to see this chart");
    EXPECT_EQ(view_.accessibleName(), QStringLiteral("Run the analysis to see this chart"));
    wheel({300, 200}, 1);
    EXPECT_FALSE(view_.is_zoomed());
}

TEST_F(ChartViewTest, FollowsItsSizeAndTheme) {
    view_.set_theme(Theme::dark());
    view_.resize(500, 300);
    QCoreApplication::processEvents();
    EXPECT_EQ(view_.chart().size().toSize(), view_.viewport()->size());
    const QImage image = view_.grab().toImage();
    EXPECT_LE(test::difference(image.pixelColor(498, 298), Theme::dark().tokens().stage), 2);
}

TEST(ReadOut, KnowsBarsCellsAndPoints) {
    const auto plots = test::all_plots();
    const auto at = [](const PlotSpecification& plot, double x, double y) {
        const PlotGeometry geometry = layout_chart(plot, {900, 560}, whole_view(plot)).geometry;
        const auto found = read_out(plot, geometry, geometry.at(x, y));
        return found ? to_unicode(found->text) : std::string("nothing");
    };
    EXPECT_EQ(at(plots[3], 1.0, 0.0), "p₁ₓ: share of the variance, first order = 25.25\u00a0%");
    EXPECT_EQ(at(plots[4], 1.0, 0.0), "x; y: −0.800");
    EXPECT_EQ(at(plots[2], 0.0, 1174.909),
              "quantile of the standard normal distribution = 0.000, quantile of z = 1174.909\u00a0mm");
    EXPECT_EQ(at(plots[2], -2.0, 1175.3), "nothing");
    PlotSpecification map = plots[4];
    map.x.title = "east";
    map.x.unit = "m";
    map.y.title = "height";
    map.y.unit = "mm";
    map.x.categories[1] = "20";
    map.y.categories[0] = "500";
    map.series[0].name = "U(x)";
    map.series[0].unit = "mm";
    EXPECT_EQ(at(map, 1.0, 0.0), "east = 20\u00a0m; height = 500\u00a0mm: U(x) = −0.800\u00a0mm");
    EXPECT_TRUE(
        at(plots[6], 6.0, plots[6].marks[0].at).starts_with("number of trials = 1\u202f000\u202f000"));
}

}  // namespace
}  // namespace covaria::ui::chart_view_test
