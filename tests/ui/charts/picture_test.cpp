// Pictures of every kind of chart, light and dark, as pixels and as SVG, without a display.
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "core/result_files/csv_writer.h"
#include "tests/ui/charts/chart_test.h"
#include "ui/charts/chart_layout.h"
#include "ui/theme/fonts.h"

namespace covaria::ui::picture_test {
namespace {

constexpr QSize size(900, 560);

PlotGeometry geometry_of(const PlotSpecification& plot) {
    return layout_chart(plot, size, whole_view(plot)).geometry;
}

using ChartPicture = test::PictureTest;

TEST_F(ChartPicture, HistogramFillsItsCells) {
    const PlotSpecification plot = test::all_plots()[0];
    const PlotGeometry at = geometry_of(plot);
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
        draw({plot, theme, size, {}});
        const double u = 0.367, top = 0.398942 / u;
        EXPECT_LE(test::nearest_difference(image_, at.at(-120.0 - 0.5 * u, 0.35),
                                           theme.filling(SeriesRole::data), 0),
                  2);
        EXPECT_LE(test::nearest_difference(image_, at.at(-120.0 - 1.7 * u, 0.95), theme.tokens().hover, 0),
                  2);
        EXPECT_LE(test::nearest_difference(image_, at.at(-120.0 + 2.6 * u, 0.95), theme.tokens().stage, 0),
                  2);
        EXPECT_LE(test::nearest_difference(image_, at.at(-120.0, 0.3), theme.series(SeriesRole::emphasis)),
                  24);
        EXPECT_LE(test::nearest_difference(image_, at.at(-120.0 + 0.3 * u, top * std::exp(-0.045)),
                                           theme.series(SeriesRole::fit)),
                  48);
        EXPECT_LE(test::nearest_difference(image_, at.at(-120.0 + 1.959964 * u, 0.9),
                                           theme.series(SeriesRole::reference)),
                  24);
        EXPECT_GT(
            test::nearest_difference(image_, at.at(-120.0 - 1.7 * u, 0.95), theme.series(SeriesRole::fit), 6),
            60)
            << "no curve far above the normal density";
    }
}

TEST_F(ChartPicture, QuantilesAreOnTheirPlaces) {
    const PlotSpecification plot = test::all_plots()[2];
    const PlotGeometry at = geometry_of(plot);
    const Theme theme = Theme::light();
    draw({plot, theme, size, {}});
    const PlotSeries& points = plot.series[1];
    for (const std::size_t i : {0U, 1U, 99U, 197U, 198U})
        EXPECT_LE(test::nearest_difference(image_, at.at(points.x[i], points.y[i]),
                                           theme.series(SeriesRole::monte_carlo), 1),
                  12)
            << i;
    EXPECT_LE(test::nearest_difference(image_, at.at(0.75, 1175.3), theme.tokens().stage, 0), 2);
}

TEST_F(ChartPicture, BarsEndAtTheirShares) {
    const PlotSpecification plot = test::all_plots()[3];
    const PlotGeometry at = geometry_of(plot);
    const Theme theme = Theme::light();
    draw({plot, theme, size, {}});
    const PlotSeries& bars = plot.series[0];
    for (std::size_t i = 0; i < bars.x.size(); ++i) {
        const QPointF end = at.at(bars.x[i], bars.y[i]);
        EXPECT_LE(test::nearest_difference(image_, end - QPointF(3, 0), theme.filling(SeriesRole::data), 0),
                  2)
            << i;
        EXPECT_LE(test::nearest_difference(image_, end + QPointF(3, 0), theme.tokens().stage, 0), 30) << i;
    }
    EXPECT_LT(at.y_at(0.0), at.y_at(1.0)) << "the largest is on top";
}

TEST_F(ChartPicture, ASingleBarIsNoBlock) {
    PlotSpecification plot = test::all_plots()[3];
    plot.y.categories.resize(1);
    plot.series.resize(1);
    PlotSeries& bar = plot.series.front();
    bar.x.resize(1);
    bar.y.resize(1);
    const PlotGeometry at = geometry_of(plot);
    ASSERT_GT(at.area.height(), 200.0);
    const Theme theme = Theme::light();
    draw({plot, theme, size, {}});
    const QColor filling = theme.filling(SeriesRole::data);
    const int x = int(at.x_at(0.5 * bar.x.front()));
    int thick = 0;
    for (int y = 0; y < image_.height(); ++y)
        thick += int(test::difference(image_.pixelColor(x, y), filling) <= 2);
    EXPECT_GT(thick, 20);
    EXPECT_LE(thick, 41);
    EXPECT_LE(test::nearest_difference(image_, at.at(0.5 * bar.x.front(), bar.y.front()), filling, 0), 2);
}

TEST_F(ChartPicture, MapCellsHaveTheColourOfTheirCoefficient) {
    const PlotSpecification plot = test::all_plots()[4];
    const PlotGeometry at = geometry_of(plot);
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
        draw({plot, theme, size, {}});
        for (std::size_t i = 0; i < 36; ++i) {
            const QPointF corner = at.at(double(i % 6) - 0.35, double(i / 6) - 0.35);
            EXPECT_LE(test::nearest_difference(image_, corner, theme.diverging(plot.series[0].z[i]), 0), 2)
                << i;
        }
    }
}

TEST_F(ChartPicture, ConvergenceIsDrawnOnALogarithmicAxis) {
    const PlotSpecification plot = test::all_plots()[6];
    const PlotGeometry at = geometry_of(plot);
    const Theme theme = Theme::light();
    draw({plot, theme, size, {}});
    for (std::size_t i = 0; i < plot.series[0].x.size(); i += 4) {
        const QPointF u = at.at(std::log10(plot.series[0].x[i]), plot.series[0].y[i]);
        EXPECT_LE(test::nearest_difference(image_, u, theme.series(SeriesRole::monte_carlo)), 48) << i;
        const QPointF high = at.at(std::log10(plot.series[2].x[i]), plot.series[2].y[i]);
        // A line of 1.5 px covers no pixel whole.
        EXPECT_LE(test::nearest_difference(image_, high, theme.series(SeriesRole::reference)), 64) << i;
    }
}

TEST_F(ChartPicture, EveryChartIsFilledInBothThemes) {
    for (const PlotSpecification& plot : test::all_plots())
        for (const Theme& theme : {Theme::light(), Theme::dark()}) {
            draw({plot, theme, {380, 260}, {}}, 2.0);
            ASSERT_EQ(image_.size(), QSize(760, 520));
            int ground = 0, text = 0;
            for (int y = 0; y < image_.height(); ++y)
                for (int x = 0; x < image_.width(); ++x) {
                    const QColor pixel = image_.pixelColor(x, y);
                    ground += test::difference(pixel, theme.tokens().stage) <= 2;
                    text += contrast(pixel, theme.tokens().stage) >= 4.5;
                }
            EXPECT_GT(ground, 760 * 520 / 12) << plot.id;
            EXPECT_GT(text, 500) << plot.id << ": words that can be read";
        }
}

/// Share of the pixels that differ clearly from the kept picture.
double differing(const QImage& image, const QImage& kept) {
    if (image.size() != kept.size()) return 1.0;
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += test::difference(image.pixelColor(x, y), kept.pixelColor(x, y)) > 48;
    return double(count) / (image.width() * image.height());
}

TEST_F(ChartPicture, LooksAsKept) {
    if (text_family() != QStringLiteral("Inter")) GTEST_SKIP() << "the pictures are kept with the font Inter";
    for (const std::size_t i : {0U, 4U}) {
        const PlotSpecification plot = test::all_plots()[i];
        const QString file = QStringLiteral(COVARIA_SOURCE_DIR "/tests/ui/charts/baselines/%1.png")
                                 .arg(QString::fromStdString(plot.id));
        draw({plot, Theme::light(), {380, 260}, {}});
        const QImage kept(file);
        ASSERT_FALSE(kept.isNull()) << file.toStdString();
        ASSERT_LT(differing(image_, kept), 0.01) << "differs from " << file.toStdString();
    }
}

class ChartFile : public ::testing::Test {
protected:
    std::string path(const char* name) const { return folder_.filePath(QLatin1String(name)).toStdString(); }
    QString read(const char* name) const {
        QFile file(folder_.filePath(QLatin1String(name)));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }
    QTemporaryDir folder_;
};

TEST_F(ChartFile, SvgHasTextAndNoRaster) {
    for (const PlotSpecification& plot : test::all_plots()) {
        ASSERT_TRUE(write_svg(path("a.svg"), {plot, Theme::light(), {720, 440}, {}}));
        const QString svg = read("a.svg");
        EXPECT_TRUE(svg.contains(QStringLiteral("viewBox=\"0 0 720 440\"")));
        EXPECT_FALSE(svg.contains(QStringLiteral("<image"))) << plot.id;
        const QString word = QString::fromStdString(to_unicode(plot.title)).section(u' ', 0, 0);
        EXPECT_TRUE(svg.contains(u'>' + word)) << plot.id;
    }
}

TEST_F(ChartFile, SvgOfAPartHasNothingOutsideIt) {
    PlotSpecification plot;
    plot.series.push_back({"line", SeriesKind::line, SeriesRole::fit, {0.0, 10.0}, {0.0, 10.0}, {}, 0.0});
    const PlotView part{4.0, 5.0, 0.0, 10.0};
    ASSERT_TRUE(write_svg(path("part.svg"), {plot, Theme::light(), {720, 440}, part}));
    const QString svg = read("part.svg");
    const QRegularExpression place(QStringLiteral("(-?[0-9.]+),(-?[0-9.]+)"));
    int places = 0;
    for (const QString& part_of_svg : svg.split(QStringLiteral("points=\"")).mid(1))
        for (auto it = place.globalMatch(part_of_svg.section(u'"', 0, 0)); it.hasNext(); ++places) {
            const double x = it.next().captured(1).toDouble();
            EXPECT_TRUE(x >= 0.0 && x <= 720.0) << x;
        }
    EXPECT_GE(places, 2);
}

TEST_F(ChartFile, PngAndCsvAreWritten) {
    const PlotSpecification plot = test::all_plots()[3];
    ASSERT_TRUE(write_png(path("a.png"), {plot, Theme::dark(), {380, 260}, {}}));
    EXPECT_EQ(QImage(QString::fromStdString(path("a.png"))).size(), QSize(760, 520));
    ASSERT_TRUE(write_csv(path("a.csv"), plot));
    EXPECT_EQ(read("a.csv").toStdString(), plot_csv(plot));
}

TEST_F(ChartFile, SaysWhichFileItCannotWrite) {
    const std::string file = path("no/such/folder/a.svg");
    const auto written = write_svg(file, {test::all_plots()[0], Theme::light(), {720, 440}, {}});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::io);
    EXPECT_NE(written.error().message.english().find(file), std::string::npos);
}

}  // namespace
}  // namespace covaria::ui::picture_test
