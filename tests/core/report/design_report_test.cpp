// Designs in charts, tables for people and the report.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/document/document_writers.h"
#include "core/report/report.h"
#include "core/result_files/csv_writer.h"
#include "core/views/design_plots.h"
#include "core/views/design_results.h"
#include "tests/core/report/sample_report.h"
#include "tests/core/report/shown_cells.h"
#include "tests/core/table_rows.h"

namespace covaria::design_report_test {
namespace {

const Unit mm = Unit::of("mm");

/// Three rows of five kept.
DesignResult of_rows() {
    DesignResult design;
    design.id = "three";
    design.name = "Three stations";
    design.objective_words = "largest U/target";
    design.found = true;
    design.before = 1.5;
    design.objective = 0.8;
    design.rows = {{0, "s0", false, false, 1.6}, {2, "s2", false, false, 0.88}, {4, "s4", true, false, {}}};
    design.candidates = 5;
    design.goals = {{{"x", "x", mm, "B"}, 1e-3, 1.5e-3, 0.8e-3}, {{"y", "y", mm, "B"}, 1e-3, 1e-3, 0.7e-3}};
    design.curve = {{2, 1.6}, {3, 0.8}, {4, 0.75}};
    design.path = {{10, "greedy", 1.0}, {30, "exchange", 0.8}};
    design.evaluations = 50;
    return design;
}

DesignResult of_reductions() {
    DesignResult design = of_rows();
    design.rows.clear();
    design.curve.clear();
    design.path.clear();
    design.values = {{"p: uncertainty", Unit{}, 0.1, 1.0, 1.0, 0.5, 0.0, 100.0}};
    design.cost = 100.0;
    design.goals[0].price_of_target = 4e5;  // per metre
    design.front = {{0.5, 300.0}, {1.0, 100.0}};
    return design;
}

const PlotSpecification* find(const std::vector<PlotSpecification>& plots, const std::string& id) {
    for (const PlotSpecification& plot : plots)
        if (plot.id == id) return &plot;
    return nullptr;
}

TEST(DesignTables, SayWhatIsChosenAtAnEndOfItsRange) {
    DesignResult design = of_rows();
    design.values = {{"place: x", mm, -100.0, 100.0, 0.0, 100.0},
                     {"place: y", mm, -100.0, 100.0, 0.0, 40.0},
                     {"place: z", mm, -100.0, 100.0, 0.0, -100.0}};
    const auto notes_of = [](const DesignResult& of) {
        std::vector<std::string> notes;
        for (const Table& table : readable_design_tables(of))
            for (const Message& note : table.notes) notes.push_back(note.english());
        return notes;
    };
    const std::vector<std::string> notes = notes_of(design);
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_NE(notes[0].find("place: x"), std::string::npos) << notes[0];
    EXPECT_NE(notes[1].find("place: z"), std::string::npos) << notes[1];
    EXPECT_NE(design_text(design).find(notes[1]), std::string::npos);
    DesignResult reductions = of_reductions();
    reductions.values[0].chosen = 1.0;
    EXPECT_TRUE(notes_of(reductions).empty()) << "what is not reduced reaches no limit";
    reductions.values[0].chosen = 0.1;
    EXPECT_EQ(notes_of(reductions).size(), 1u);
}

TEST(DesignPlots, ShowWhatMoreRowsGiveAndWhatEachIsWorth) {
    const auto plots = design_plots(of_rows());
    const PlotSpecification* curve = find(plots, "design-three-curve");
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->series[0].x, (std::vector<double>{2, 3, 4}));
    EXPECT_EQ(curve->series[0].y, (std::vector<double>{1.6, 0.8, 0.75}));
    EXPECT_EQ(curve->marks[0].at, 3.0);
    const PlotSpecification* rows = find(plots, "design-three-rows");
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->series[0].x.size(), 2u) << "without the last there is no result";
    EXPECT_NEAR(rows->series[0].x[0], 100.0, 1e-9);
    EXPECT_NEAR(rows->series[0].x[1], 10.0, 1e-9);
    const PlotSpecification* outputs = find(plots, "design-three-outputs");
    ASSERT_TRUE(outputs);
    EXPECT_NEAR(outputs->series[0].y[0], 1.5, 1e-12);
    EXPECT_NEAR(outputs->series[1].y[1], 0.7, 1e-12);
    EXPECT_TRUE(find(plots, "design-three-path"));
    EXPECT_FALSE(find(plots, "design-three-front"));
    DesignResult nothing = of_rows();
    nothing.found = false;
    EXPECT_TRUE(design_plots(nothing).empty());
}

TEST(DesignPlots, ShowCostAgainstUncertainty) {
    const auto plots = design_plots(of_reductions());
    const PlotSpecification* front = find(plots, "design-three-front");
    ASSERT_TRUE(front);
    EXPECT_EQ(front->series[0].x, (std::vector<double>{0.5, 1.0}));
    EXPECT_EQ(front->series[0].y, (std::vector<double>{300.0, 100.0}));
}

TEST(DesignTables, ForPeopleHaveNoColumnsThatSayNothing) {
    for (const Table& table : readable_design_tables(of_rows())) {
        EXPECT_NE(table.id, "path");
        for (const Column& column : table.columns) {
            EXPECT_NE(column.key, "of the candidates' file");
            EXPECT_NE(column.key, "U by Monte Carlo");
        }
    }
}

TEST(DesignTables, TheChangeIsInPerCentForPeopleAndAPartOfOneInFiles) {
    const auto curve = [](const std::vector<Table>& tables) {
        return *std::find_if(tables.begin(), tables.end(),
                             [](const Table& table) { return table.id == "curve"; });
    };
    const TableBlock block = evaluation_block(curve(readable_design_tables(of_rows())), {});
    EXPECT_EQ(test::head_of(block, 2), "change / %");
    EXPECT_EQ(test::plain_cell(block, 1, 2), "-50.0");
    EXPECT_EQ(test::plain_cell(block, 2, 2), "-6.3");
    const Table file = curve(design_tables(of_rows()));
    EXPECT_EQ(file.columns.at(2).key, "change");
    EXPECT_NEAR(test::si_of(file.columns[2].cell(1)), -0.5, 1e-12);
}

TEST(DesignTables, CandidatesHaveTheirGainAndPlace) {
    DesignResult design = of_rows();
    design.gains = {{0, "s0", true, 0.5, Eigen::Vector3d(1.0, 2.0, 3.0)}, {1, "s1", false, {}, {}}};
    for (const Table& table : design_tables(design)) {
        if (table.id != "gains") continue;
        const std::string file = to_csv(table);
        EXPECT_EQ(file.substr(0, file.find('\r')), "row,name,chosen,gain (%),x (mm),y (mm),z (mm)");
        EXPECT_NE(file.find(",50,1000,2000,3000\r\n"), std::string::npos) << file;
        EXPECT_TRUE(std::holds_alternative<std::monostate>(table.columns[3].cell(1)));
        return;
    }
    ADD_FAILURE() << "there is no such table";
}

TEST(DesignTables, CheapestRowsHaveTheirPrices) {
    DesignResult design = of_rows();
    design.cost = 300.0;
    for (DesignRow& row : design.rows) row.price = 100.0;
    const std::string text = design_text(design);
    EXPECT_NE(text.find("The cheapest rows cost 300.0"), std::string::npos) << text;
    EXPECT_NE(text.find("100.0"), std::string::npos);
}

TEST(DesignTables, PriceOfATargetIsOfItsUnit) {
    const Table outputs = design_tables(of_reductions()).front();
    EXPECT_EQ(outputs.columns.back().key, "cost per unit of target");
    EXPECT_NEAR(test::si_of(outputs.columns.back().cell(0)), 400.0, 1e-9) << "for a millimetre";
    EXPECT_TRUE(std::holds_alternative<std::monostate>(outputs.columns.back().cell(1))) << "it does not bind";
    EXPECT_NE(design_text(of_reductions()).find("costs 400.0 for every mm less"), std::string::npos);
}

TEST(DesignReport, HasAChapterThatCanBeLeftOut) {
    EvaluatedAnalysis evaluated = test::sample_analysis(test::sample_result());
    evaluated.designs = {std::make_shared<const DesignResult>(of_rows()),
                         std::make_shared<const DesignResult>(of_reductions())};
    const auto made = MadeProject::make(test::sample_project());
    const std::string whole = to_markdown(build_report(*made, {evaluated}));
    EXPECT_NE(whole.find("Three stations"), std::string::npos);
    EXPECT_EQ(whole.find("Not every target is met"), std::string::npos);
    EXPECT_NE(whole.find("50 candidates"), std::string::npos);
    EXPECT_NE(whole.find("Cost: 100.0"), std::string::npos);
    EXPECT_EQ(whole.find("what they gain; the larger"), std::string::npos) << "these stand nowhere";
    DesignResult in_space = of_rows();
    in_space.gains = {{0, "s0", true, 0.5, Eigen::Vector3d(1.0, 2.0, 3.0)}, {1, "s1", false, 0.01, {}}};
    evaluated.designs.push_back(std::make_shared<const DesignResult>(in_space));
    const std::string drawn = to_markdown(build_report(*made, {evaluated}));
    EXPECT_NE(drawn.find("coloured by what they gain; the larger ones are chosen"), std::string::npos);
    ReportContents contents;
    contents.without_chapters = {"designs"};
    const std::string without = to_markdown(build_report(*made, {evaluated}, {}, contents));
    EXPECT_EQ(without.find("Three stations"), std::string::npos);
}

}  // namespace
}  // namespace covaria::design_report_test
