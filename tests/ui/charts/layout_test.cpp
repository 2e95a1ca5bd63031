// No text is cut or covers another, whatever the chart and its size.
#include "ui/charts/chart_layout.h"

#include <QFontMetricsF>
#include <algorithm>

#include "core/text/symbol.h"
#include "tests/ui/charts/chart_test.h"
#include "ui/charts/mark_labels.h"
#include "ui/charts/visible_part.h"
#include "ui/theme/label_text.h"

namespace covaria::ui::layout_test {
namespace {

/// The part of a text's box that has ink: without the leading of the line.
QRectF ink(const PlacedText& text) {
    const double lead = 0.14 * (text.upwards ? text.box.width() : text.box.height());
    return text.upwards ? text.box.adjusted(lead, 0.0, -lead, 0.0) : text.box.adjusted(0.0, lead, 0.0, -lead);
}

void expect_clear(const ChartLayout& layout, const QSizeF& size, const std::string& what) {
    const QRectF whole(QPointF(), size);
    for (std::size_t i = 0; i < layout.texts.size(); ++i) {
        const PlacedText& text = layout.texts[i];
        EXPECT_TRUE(whole.contains(ink(text))) << what << ": cut: " << to_unicode(text.text);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(ink(text).intersects(ink(layout.texts[j])))
                << what << ": " << to_unicode(text.text) << " covers " << to_unicode(layout.texts[j].text);
    }
}

TEST(ChartLayout, KeepsTextsWholeAndApart) {
    int checked = 0;
    for (const PlotSpecification& plot : test::all_plots())
        for (const QSize size : {QSize(900, 560), QSize(380, 260), QSize(302, 205), QSize(300, 180),
                                 QSize(1200, 700), QSize(1600, 300), QSize(300, 700)}) {
            const ChartLayout layout = layout_chart(plot, size, whole_view(plot));
            expect_clear(layout, size, plot.id + " at " + std::to_string(size.width()));
            if (!plot.series.empty()) {
                EXPECT_GT(layout.geometry.area.height(), 0.3 * std::min(size.width(), size.height()))
                    << plot.id;
            }
            checked += static_cast<int>(layout.texts.size());
        }
    EXPECT_GT(checked, 400);
}

TEST(ChartLayout, ShortensTheTitleOfAnAxisAndKeepsANoun) {
    PlotSpecification plot = test::all_plots()[0];
    plot.y.title = "probability density";
    plot.y.unit = "1/mm";
    plot.y.short_title = "density";
    const auto title = [&](QSize size) {
        for (const PlacedText& text : layout_chart(plot, size, whole_view(plot)).texts)
            if (text.kind == TextKind::axis_title && text.upwards) return to_unicode(text.text);
        return std::string();
    };
    EXPECT_EQ(title({600, 400}), "probability density / (1/mm)");
    EXPECT_EQ(title({600, 150}), "density / (1/mm)");
    plot.y.title = "Anteil an der Varianz der Ausgangsgröße";
    plot.y.unit = "%";
    plot.y.short_title = {};
    EXPECT_TRUE(title({600, 220}).starts_with("Anteil")) << title({600, 220});
    EXPECT_TRUE(title({600, 220}).ends_with(" / %")) << title({600, 220});
}

TEST(ChartLayout, KeepsLongNamesInside) {
    PlotSpecification plot = test::all_plots()[3];
    plot.y.categories[0] = "length standard, uncertainty of the calibration of the artefact at 20 degrees";
    plot.title += " with a title that is so long that it has to be broken into several lines";
    expect_clear(layout_chart(plot, {380, 260}, whole_view(plot)), {380, 260}, "long");
}

/// The map is of a study: its axes have other values, so that the cells are not made square.
TEST(ChartLayout, NamesOnlyAsManyColumnsOfAMapAsHaveRoom) {
    PlotSpecification plot = test::all_plots()[4];
    plot.x.categories.clear();
    for (int i = 0; i < 24; ++i) plot.x.categories.emplace_back("−1250." + std::to_string(10 + i));
    plot.y.categories = {"1", "2"};
    plot.series[0].z.assign(48, 0.5);
    for (const QSize size : {QSize(300, 180), QSize(380, 260), QSize(1600, 300)}) {
        const ChartLayout layout = layout_chart(plot, size, whole_view(plot));
        expect_clear(layout, size, "study at " + std::to_string(size.width()));
        EXPECT_TRUE(std::ranges::any_of(layout.texts, [](const PlacedText& text) {
            return to_unicode(text.text) == "−1250.10";
        })) << "the first is named";
    }
}

TEST(ChartLayout, MapsValuesToPlacesAndBack) {
    const PlotSpecification plot = test::all_plots()[0];
    const PlotGeometry geometry = layout_chart(plot, {900, 560}, whole_view(plot)).geometry;
    EXPECT_DOUBLE_EQ(geometry.x_at(plot.x.low), geometry.area.left());
    EXPECT_DOUBLE_EQ(geometry.x_at(plot.x.high), geometry.area.right());
    EXPECT_DOUBLE_EQ(geometry.y_at(0.0), geometry.area.bottom());
    const QPointF back = geometry.coordinates_at(geometry.at(-120.1, 0.5));
    EXPECT_NEAR(back.x(), -120.1, 1e-9);
    EXPECT_NEAR(back.y(), 0.5, 1e-9);
}

TEST(MarkLabels, MoveAsideOrToASecondRow) {
    std::vector<MarkLabel> apart = {{50, 40, false, 0, 0}, {100, 40, true, 0, 0}, {150, 40, false, 0, 0}};
    EXPECT_EQ(place_mark_labels(apart, 0, 200, 8), 1);
    EXPECT_EQ(apart[1].left, 80.0);
    std::vector<MarkLabel> close = {{90, 60, false, 0, 0}, {100, 60, true, 0, 0}, {110, 60, false, 0, 0}};
    EXPECT_EQ(place_mark_labels(close, 0, 200, 8), 2);
    EXPECT_EQ(close[1].row, 1);
    EXPECT_EQ(close[1].left, 70.0);
    EXPECT_GE(close[2].left, close[0].left + 60 + 8);
    std::vector<MarkLabel> edge = {{2, 60, false, 0, 0}};
    EXPECT_EQ(place_mark_labels(edge, 0, 200, 8), 1);
    EXPECT_EQ(edge[0].left, 0.0);
}

TEST(LabelText, SetsScriptsSmall) {
    const QFont font = fonts_for(900).label;
    EXPECT_LT(LabelText(symbol_text("b_1"), font).width(), LabelText("b1", font).width());
    EXPECT_DOUBLE_EQ(LabelText(symbol_text("b_1"), font).width(),
                     LabelText(symbol_text("b^1"), font).width());
    EXPECT_DOUBLE_EQ(LabelText("b_1", font).width(), QFontMetricsF(font).horizontalAdvance("b_1"))
        << "nothing is guessed";
}

TEST(VisiblePart, CutsLinesAtTheEdges) {
    PlotSpecification plot;
    plot.series.push_back(
        {"a", SeriesKind::line, SeriesRole::data, {0, 1, 2, 3, 4}, {0, 2, 0, 2, 0}, {}, 0.0});
    plot.series.push_back({"p", SeriesKind::points, SeriesRole::data, {0, 2}, {0, 5}, {}, 0.0});
    const PlotSpecification part = visible_part(plot, {0.0, 4.0, 0.0, 1.0});
    ASSERT_EQ(part.series.size(), 4U) << "a line in three runs, and the points";
    EXPECT_EQ(part.series[0].name, "a");
    EXPECT_EQ(part.series[0].x, (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(part.series[1].name, "");
    EXPECT_EQ(part.series[1].x, (std::vector<double>{1.5, 2.0, 2.5}));
    EXPECT_EQ(part.series[1].y, (std::vector<double>{1.0, 0.0, 1.0}));
    EXPECT_EQ(part.series[2].x, (std::vector<double>{3.5, 4.0}));
    EXPECT_EQ(part.series[3].x, (std::vector<double>{0.0}));
    EXPECT_TRUE(visible_part(plot, {5.0, 6.0, 0.0, 1.0}).series[0].x.empty());
}

}  // namespace
}  // namespace covaria::ui::layout_test
