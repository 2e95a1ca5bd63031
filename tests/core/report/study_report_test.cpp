// Studies in CSV, results.json, charts and the report.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/document/document_writers.h"
#include "core/report/report.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "core/result_files/results_json.h"
#include "core/views/plots.h"
#include "core/views/study_plots.h"
#include "tests/core/report/sample_report.h"

namespace covaria::study_report_test {
namespace {

const Unit mm = Unit::of("mm");

/// U(x) = 2 (1 + i + 10 j + 100 k) um over a grid; the point with number `broken` has no values.
StudyResult sample(const std::vector<std::size_t>& sizes, std::size_t broken = 1'000'000) {
    StudyResult study;
    study.id = "sweep";
    study.name = "A sweep";
    const char* const names[] = {"length", "angle", "height"};
    for (std::size_t axis = 0; axis < sizes.size(); ++axis) {
        study.axes.push_back({names[axis], axis == 1 ? Unit::of("deg") : mm, false, {}, 15.0});
        for (std::size_t i = 0; i < sizes[axis]; ++i)
            study.axes.back().values.push_back(10.0 * static_cast<double>(i + 1));
    }
    study.outputs = {
        {"x", "x", mm, "B"}, {"y", "y", mm, "B"}, {"z", "z", mm, "B"}, {"alpha", "", Unit::of("deg"), "B"}};
    study.triples = {{"B", {0, 1, 2}}};
    study.reasons = {"", "the bars do not meet"};
    std::size_t points = 1;
    for (const std::size_t size : sizes) points *= size;
    for (std::size_t i = 0; i < points; ++i) {
        StudyPoint point;
        study.points.push_back(point);
        const auto at = study.indices_of(i);
        double u = 1e-6;
        for (std::size_t axis = 0; axis < at.size(); ++axis)
            u += 1e-6 * std::pow(10.0, static_cast<double>(axis)) * static_cast<double>(at[axis]);
        if (i == broken) {
            study.points[i].reason = 1;
            continue;
        }
        for (int j = 0; j < 4; ++j) study.points[i].values.push_back({0.1, u, 2.0 * u});
        StudyPlace place;
        place.p_W = {0.1, 0.2, 0.3};
        place.covariance = Eigen::Matrix3d::Identity() * u * u;
        study.points[i].places = {place};
    }
    return study;
}

EvaluatedAnalysis analysis_with(const StudyResult& study) {
    EvaluatedAnalysis evaluated = test::sample_analysis(test::sample_result());
    evaluated.studies = {std::make_shared<const StudyResult>(study)};
    return evaluated;
}

TEST(StudyTable, OneLinePerGridPointWithTheReason) {
    const std::string csv = to_csv(study_table(sample({3}, 1)));
    const auto line = [&](std::size_t wanted) {
        std::size_t at = 0;
        for (std::size_t i = 0; i < wanted; ++i) at = csv.find("\r\n", at) + 2;
        return csv.substr(at, csv.find("\r\n", at) - at);
    };
    EXPECT_EQ(line(0).substr(0, 45), "length (mm),B x (mm),u B x (mm),U B x (mm),B ");
    EXPECT_NE(line(0).find("B covariance xx (mm^2)"), std::string::npos);
    EXPECT_EQ(line(1).substr(0, 19), "10,100,0.001,0.002,");
    EXPECT_EQ(line(2).substr(0, 4), "20,,");
    EXPECT_NE(line(2).find("the bars do not meet"), std::string::npos);
    EXPECT_EQ(line(3).substr(0, 19), "30,100,0.003,0.006,");
}

TEST(StudyJson, ListsOverTheGrid) {
    const auto json = nlohmann::ordered_json::parse(
        results_json(test::sample_project(), {analysis_with(sample({3}, 1))}))["analyses"][0]["studies"][0];
    EXPECT_EQ(json["id"], "sweep");
    EXPECT_EQ(json["axes"][0]["values"][2], 30.0);
    EXPECT_DOUBLE_EQ(json["outputs"][0]["expandedUncertainty"][2].get<double>(), 0.006);
    EXPECT_TRUE(json["outputs"][0]["estimate"][1].is_null());
    EXPECT_EQ(json["withoutValues"][0]["point"], 1);
    EXPECT_EQ(json["withoutValues"][0]["reason"], "the bars do not meet");
    EXPECT_DOUBLE_EQ(json["positions"][0]["covariance"][0][0].get<double>(), 1e-6);
    EXPECT_DOUBLE_EQ(json["positions"][0]["position"][0][1].get<double>(), 200.0);
}

TEST(StudyJson, NoKeyWithoutStudies) {
    const std::string json =
        results_json(test::sample_project(), {test::sample_analysis(test::sample_result())});
    EXPECT_EQ(json.find("studies"), std::string::npos);
}

TEST(StudyPlot, SweepHasALinePerOutputOfTheUnit) {
    const PlotSpecification plot = study_plot(sample({5}), {});
    std::vector<std::string> names;
    for (const PlotSeries& series : plot.series) names.push_back(to_unicode(series.name));
    EXPECT_EQ(names, (std::vector<std::string>{"u(3D), B", "U(x), B", "U(y), B", "U(z), B"}));
    EXPECT_EQ(plot.x.title.letters() + " " + plot.x.unit, "length mm");
    EXPECT_DOUBLE_EQ(plot.series[1].y[4], 0.010);
    ASSERT_EQ(plot.marks.size(), 1u);
    EXPECT_EQ(plot.marks[0].at, 15.0);
}

TEST(StudyPlot, LinesAreInterruptedWhereThereIsNoValue) {
    const PlotSpecification plot = study_plot(sample({5}, 2), {});
    EXPECT_EQ(plot.series[0].x, (std::vector<double>{10.0, 20.0}));
    EXPECT_EQ(plot.series[1].x, (std::vector<double>{40.0, 50.0}));
    EXPECT_EQ(to_unicode(plot.series[1].name), "");
    EXPECT_EQ(plot.series[1].role, plot.series[0].role);
}

TEST(StudyPlot, MapHasTheSecondAxisUpwards) {
    StudyView view;
    view.quantity = 1;  // U(x)
    const PlotSpecification plot = study_plot(sample({3, 2}), view);
    ASSERT_EQ(plot.series.size(), 1u);
    EXPECT_EQ(plot.series[0].kind, SeriesKind::heat_map);
    EXPECT_EQ(plot.x.categories, (std::vector<Text>{"10", "20", "30"}));
    EXPECT_EQ(plot.y.categories, (std::vector<Text>{"20", "10"}));
    EXPECT_DOUBLE_EQ(plot.series[0].z[0], 0.022);  // length 10, angle 20
    EXPECT_DOUBLE_EQ(plot.series[0].z[5], 0.006);  // length 30, angle 10
    EXPECT_DOUBLE_EQ(plot.z_high, 0.026);
    // The set-up has length and angle 15: between the first and the second column, below the lowest row.
    StudyResult inside = sample({3, 2});
    ASSERT_EQ(plot.marks.size(), 2u);
    EXPECT_DOUBLE_EQ(plot.marks[0].at, 0.5);
    EXPECT_TRUE(plot.marks[1].horizontal);
    EXPECT_DOUBLE_EQ(plot.marks[1].at, 0.5);
    inside.axes[1].present = 20.5;
    ASSERT_EQ(study_plot(inside, view).marks.size(), 1u) << "the angle is beside the map";
    EXPECT_FALSE(study_plot(inside, view).marks[0].horizontal);
}

TEST(StudyPlot, SliceOfThreeAxes) {
    StudyView view{.quantity = 1, .fixed_axis = 1, .slice = 1};
    const PlotSpecification plot = study_plot(sample({3, 2, 4}), view);
    EXPECT_EQ(plot.x.title.letters() + " " + plot.x.unit, "length mm");
    EXPECT_EQ(plot.y.title.letters() + " " + plot.y.unit, "height mm");
    EXPECT_EQ(plot.y.categories.size(), 4u);
    // length 30, height 10: 1 + 2 + 10
    EXPECT_DOUBLE_EQ(plot.series[0].z[11], 0.026);
    EXPECT_NE(to_unicode(plot.title).find("angle = 20"), std::string::npos) << to_unicode(plot.title);
}

TEST(StudyPlot, FamilyOfLines) {
    StudyView view{.quantity = 1, .lines = true};
    const PlotSpecification plot = study_plot(sample({3, 8}), view);
    ASSERT_EQ(plot.series.size(), 6u);
    EXPECT_EQ(to_unicode(plot.series.front().name), "angle = 10°");
    EXPECT_EQ(to_unicode(plot.series.back().name), "angle = 80°");
    EXPECT_TRUE(plot.y.logarithmic);
}

TEST(StudyPlot, NothingToShowSaysWhy) {
    StudyResult study = sample({2});
    for (StudyPoint& point : study.points) point = {.reason = 1};
    const PlotSpecification plot = study_plot(study, {});
    EXPECT_TRUE(plot.series.empty());
    EXPECT_NE(to_unicode(plot.title).find("the bars do not meet"), std::string::npos);
}

TEST(StudyReport, HasTableChartsAndReasons) {
    const EvaluatedAnalysis evaluated = analysis_with(sample({3, 2, 4}, 7));
    const std::string text =
        to_markdown(build_report(*MadeProject::make(test::sample_project()), {evaluated}));
    EXPECT_NE(text.find("Evaluated at 24 grid points"), std::string::npos);
    EXPECT_NE(text.find("best and worst grid points"), std::string::npos);
    EXPECT_NE(text.find("the bars do not meet"), std::string::npos);
    EXPECT_NE(text.find("height = 40\u00a0mm"), std::string::npos);
}

TEST(StudyExtremesTest, AreWhereTheFormulaHasThem) {
    const StudyResult study = sample({3, 2, 4});
    const StudyExtremes extremes = extremes_of(study, study_quantities(study)[1]);
    EXPECT_EQ(extremes.best, 0u);
    EXPECT_EQ(extremes.worst, 23u);
    EXPECT_EQ(point_words(study, 23), "length = 30\u00a0mm, angle = 20°, height = 40\u00a0mm");
}

}  // namespace
}  // namespace covaria::study_report_test
