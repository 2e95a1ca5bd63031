// The report document: all sections in order, readable with many groups, and its Markdown and HTML.
#include "core/report/report.h"
#include "core/document/document_writers.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "core/result_files/results_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/project/stated_requirements.h"
#include "core/result/representation.h"
#include "core/text/symbol.h"
#include "core/views/plots.h"
#include "core/views/result_columns.h"
#include "core/views/result_statement.h"
#include "tests/core/report/sample_report.h"
#include "tests/core/report/shown_cells.h"

namespace covaria::report_test {
namespace {

std::vector<std::string> headings_of(const ReportDocument& document) {
    std::vector<std::string> headings;
    for (const ReportBlock& block : document.blocks)
        if (const auto* heading = std::get_if<HeadingBlock>(&block); heading && heading->level <= 2)
            headings.push_back(heading->text);
    return headings;
}

std::vector<const TableBlock*> tables_of(const ReportDocument& document) {
    std::vector<const TableBlock*> tables;
    for (const ReportBlock& block : document.blocks)
        if (const auto* table = std::get_if<TableBlock>(&block)) tables.push_back(table);
    return tables;
}

const TableBlock* table_with_id(const ReportDocument& document, const std::string& id) {
    for (const TableBlock* table : tables_of(document))
        if (table->table.id == id) return table;
    return nullptr;
}

using test::head_of;
using test::plain_cell;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Report, HasAllSectionsInOrder) {
    const std::vector<std::string> expected = {"1\u2002Measurement model",
                                               "1.1\u2002Pose from points <sample>",
                                               "2\u2002Pose of the platform",
                                               "2.1\u2002Set-up",
                                               "2.2\u2002Input quantities",
                                               "2.3\u2002Uncertainty budgets",
                                               "2.4\u2002Results",
                                               "2.5\u2002Law of propagation beside Monte Carlo",
                                               "2.6\u2002Joint coverage regions",
                                               "2.7\u2002Distributions",
                                               "2.8\u2002Correlation",
                                               "3\u2002Provenance"};
    EXPECT_EQ(headings_of(test::sample_report()), expected);
}

TEST(Report, BeginsWithTheFactsAndTheMatrixOfExpandedUncertainties) {
    const ReportDocument document = test::sample_report();
    ASSERT_TRUE(std::holds_alternative<FactsBlock>(document.blocks[0]));
    const TableBlock* summary = table_with_id(document, "summary-typed");
    ASSERT_NE(summary, nullptr);
    EXPECT_EQ(summary->table.shown_columns(), 2U + 13U);
    ASSERT_EQ(summary->table.rows, 6U);
    EXPECT_EQ(plain_cell(*summary, 0, 2), "0.74");
    EXPECT_EQ(plain_cell(*summary, 3, 2), "0.10");
    EXPECT_EQ(plain_cell(*summary, 3, 1), "°");
}

/// The first page answers: results, then the picture of the only analysis, which is nowhere else.
TEST(Report, ThePictureOfTheOnlyAnalysisIsBesideItsResults) {
    const ReportDocument document = test::sample_report();
    const auto of = [&](auto is) { return std::ranges::find_if(document.blocks, is); };
    const auto picture = of([](const ReportBlock& b) { return std::holds_alternative<SceneBlock>(b); });
    const auto chapter = of([](const ReportBlock& b) { return std::holds_alternative<HeadingBlock>(b); });
    ASSERT_NE(chapter, document.blocks.end());
    ASSERT_NE(picture, document.blocks.end());
    EXPECT_LT(picture, chapter);
    EXPECT_EQ(std::get<SceneBlock>(*picture).caption.rfind("Figure 1.", 0), 0U);
    EXPECT_EQ(
        std::ranges::count_if(document.blocks,
                              [](const ReportBlock& b) { return std::holds_alternative<SceneBlock>(b); }),
        1);
}

TEST(Report, ManyGroupsBecomeRowsOfTheMatrix) {
    const ReportDocument document = test::sample_report({20, 3, 3, true, "pose"});
    const TableBlock* summary = table_with_id(document, "summary-typed");
    ASSERT_NE(summary, nullptr);
    EXPECT_EQ(summary->table.rows, 20U);
    EXPECT_EQ(head_of(*summary, 1), "U(x) / mm");
    EXPECT_EQ(plain_cell(*summary, 0, 1), "0.74");
}

TEST(Report, ValuesMatchTheirExpandedUncertainty) {
    const ReportDocument document = test::sample_report();
    const TableBlock* results = table_with_id(document, "results-typed");
    ASSERT_NE(results, nullptr);
    ASSERT_TRUE(results->table.is_subhead(0));
    EXPECT_EQ(plain_cell(*results, 1, 2), "-119.00");  // U = 0.74 mm
    EXPECT_EQ(plain_cell(*results, 1, 4), "∞");
    EXPECT_EQ(plain_cell(*results, 1, 5), "2.00");
    EXPECT_EQ(plain_cell(*results, 4, 2), "5.00");  // U = 0.10 deg
}

TEST(Report, NumbersOfARowHaveOnePowerOfTenAndThoseOfAColumnOneForm) {
    const Unit mm = Unit::of("mm");
    TableBlock block;
    block.table.add("y").estimate_of("u").of_row({"y", "u"});
    block.table.add("u").uncertainty().of_row({"y", "u"});
    block.table.add("s").uncertainty();
    const auto add = [&](double y, double u, double s) {
        block.table.row({Quantity{y, mm}, Quantity{u, mm}, Quantity{s, mm}});
    };
    add(50.000838, 8.4e-5, 0.0012);
    add(1.234e-5, 1.2e-6, 3.4e-5);
    EXPECT_EQ(plain_cell(block, 0, 0), "50.000838");
    EXPECT_EQ(plain_cell(block, 0, 1), "0.000084");
    EXPECT_EQ(plain_cell(block, 1, 0), "1.23e-05");
    EXPECT_EQ(plain_cell(block, 1, 1), "0.12e-05");
    EXPECT_EQ(plain_cell(block, 0, 2), "0.0012");
    EXPECT_EQ(plain_cell(block, 1, 2), "0.000034");
}

TEST(Report, TheResultLineHasOnePowerOfTenInTheWindow) {
    UncertaintyResult result = test::sample_result();
    OutputResult& output = result.outputs.front();
    output.quantity.unit = Unit::of("m");
    output.monte_carlo.reset();
    output.estimate = 1.2345e-5;
    output.standard_uncertainty = 1e-7;
    output.expanded_uncertainty = 2e-7;
    const Table table = results_table(result, {0});
    const auto shown = [&](const char* key) { return to_unicode(written(table, table[key], 0, {})); };
    EXPECT_EQ(shown("estimate"), "1.235×10⁻⁵");
    EXPECT_EQ(shown("u"), "0.010×10⁻⁵");
    EXPECT_EQ(shown("U"), "0.020×10⁻⁵");
}

// 5.0×10⁻⁵ stood in the line, 0.000 050 in the table and 50×10⁻⁶ in the chart of one result.
TEST(Report, ALineARowAndAChartAgreeWhetherAResultIsWrittenOut) {
    for (int exponent = -8; exponent < 5; ++exponent)
        for (const double first : {1.4, 5.0, 9.6}) {
            const double u = first * std::pow(10.0, exponent);
            UncertaintyResult result = test::sample_result();
            OutputResult& output = result.outputs.front();
            output.quantity.unit = Unit{};
            output.monte_carlo->symmetric = {-0.5 * u, 2.4 * u};
            output.estimate = output.monte_carlo->mean = 0.3 * u;
            output.standard_uncertainty = u;
            output.expanded_uncertainty = 1.45 * u;
            const Table table = results_table(result, {0});
            const std::string row = to_unicode(written(table, table["estimate"], 0, {}));
            const std::string line = result_statement(output, result);
            const bool power = line.find("×10") != std::string::npos;
            EXPECT_EQ(row.find("×10") != std::string::npos, power) << row << " in " << line;
            const PlotSpecification plot = histogram_plot(result, 0);
            EXPECT_EQ(plot.x.exponent != 0, power) << line;
        }
}

TEST(EvaluationTable, HasTheUnitInTheHeadAndEvenDecimals) {
    const Unit mm = Unit::of("mm"), deg = Unit::of("deg");
    Table table{"t", "T"};
    table.add("same");
    table.add("other");
    table.add("rounded").figure(2);
    table.row({Quantity{1.5, mm}, Quantity{1.5, mm}, Quantity{1.234, mm}});
    table.row({Quantity{2.0, mm}, Quantity{2.0, deg}, Quantity{0.1234, mm}});
    table.row({Cell{}, Quantity{0.25, mm}, Cell{}});
    const TableBlock block = evaluation_block(table, {});
    EXPECT_EQ(head_of(block, 0), "same / mm");
    EXPECT_EQ(plain_cell(block, 0, 0), "1.5");
    EXPECT_EQ(plain_cell(block, 1, 0), "2.0");
    EXPECT_EQ(head_of(block, 1), "other");
    EXPECT_EQ(plain_cell(block, 1, 1), "2°");
    EXPECT_EQ(plain_cell(block, 0, 1), "1.5\u00a0mm");
    EXPECT_EQ(head_of(block, 2), "rounded / mm");
    EXPECT_EQ(plain_cell(block, 1, 2), "0.12");
}

TEST(EvaluationTable, ComputedNumbersAndDeviationsOfAColumnShareTheirDecimals) {
    const Unit mm = Unit::of("mm");
    Table table{"t", "T"};
    table.add("x").in(mm);
    table.add("residual").in(mm).figure(3);
    table.add("u").in(mm).figure(2);
    table.add("z").in(mm);
    table.row({1.571031123456789, 2.79123e-7, 1.86e-5, 500.0});
    table.row({0.000664026123456789, -5.65321e-6, 3.3e-4, 1e-10});
    const TableBlock block = evaluation_block(table, {});
    EXPECT_EQ(plain_cell(block, 0, 0), "1571.031");
    EXPECT_EQ(plain_cell(block, 1, 0), "0.664");
    EXPECT_EQ(plain_cell(block, 0, 1), "0.00028");
    EXPECT_EQ(plain_cell(block, 1, 1), "-0.00565");
    EXPECT_EQ(plain_cell(block, 0, 2), "0.019");
    EXPECT_EQ(plain_cell(block, 1, 2), "0.33") << "each with its own digits";
    EXPECT_EQ(plain_cell(block, 1, 3), "1e-07") << "nothing is lost";
}

TEST(EvaluationTable, ATemperatureHasNoMoreDecimalsThanWereRead) {
    Table table{"t", "T"};
    table.add("t").in(Unit::of("degC"));
    for (const double t : {21.521, 22.012, 26.01}) table.row({Unit::of("degC").to_si(t)});
    const TableBlock block = evaluation_block(table, {});
    EXPECT_EQ(plain_cell(block, 0, 0), "21.521");
    EXPECT_EQ(plain_cell(block, 2, 0), "26.010");
}

TEST(Report, BudgetsAreShownInFullForTheGroupWithTheLargestUncertainties) {
    const ReportDocument document = test::sample_report();
    int budgets = 0;
    for (const TableBlock* table : tables_of(document))
        if (table->table.id.rfind("budget-", 0) == 0) {
            ++budgets;
            EXPECT_TRUE(table->table.id.ends_with("pose-4")) << table->table.id;
            EXPECT_EQ(table->table.rows, 18U + 1U);
        }
    EXPECT_EQ(budgets, 6);
}

TEST(Report, TwoGroupsAreBothShownInFull) {
    const ReportDocument document = test::sample_report({2, 3, 3, true, "pose"});
    EXPECT_NE(table_with_id(document, "budget-typed-x-pose-1"), nullptr);
    EXPECT_NE(table_with_id(document, "budget-typed-x-pose-2"), nullptr);
}

TEST(Report, InputsWithEqualComponentsShareARow) {
    const ReportDocument long_report = test::sample_report();
    const TableBlock* many = table_with_id(long_report, "inputs-typed");
    ASSERT_NE(many, nullptr);
    ASSERT_EQ(many->table.rows, 2U);
    EXPECT_EQ(plain_cell(*many, 1, 0), to_unicode(symbols_text("p_1_1x, p_1_1y … p_13_3z (117)")));
    EXPECT_EQ(plain_cell(*many, 1, 4), "0.24");
    const ReportDocument short_report = test::sample_report({1, 3, 3, true, "pose"});
    const TableBlock* few = table_with_id(short_report, "inputs-typed");
    ASSERT_NE(few, nullptr);
    EXPECT_EQ(few->table.rows, 18U);
    EXPECT_EQ(plain_cell(*few, 0, 2), "344.000");
}

TEST(Report, SetupLeavesOutEmptyColumns) {
    const ReportDocument document = test::sample_report();
    const TableBlock* points = table_with_id(document, "setup-points");
    ASSERT_NE(points, nullptr);
    ASSERT_EQ(points->table.columns.size(), 3U);
    EXPECT_EQ(head_of(*points, 2), "uₓ / mm");
    EXPECT_EQ(plain_cell(*points, 0, 1), "-344");
    EXPECT_EQ(plain_cell(*points, 0, 2), "0.066");
}

TEST(Report, RequirementsAreJudged) {
    const ReportDocument document = test::sample_report();
    const TableBlock* verdicts = table_with_id(document, "requirements-typed");
    ASSERT_NE(verdicts, nullptr);
    ASSERT_EQ(verdicts->table.rows, 2U);
    EXPECT_EQ(plain_cell(*verdicts, 0, 5), "not met");
    EXPECT_EQ(plain_cell(*verdicts, 1, 4), "0.5");
    EXPECT_EQ(plain_cell(*verdicts, 1, 5), "met");
}

TEST(Report, WhatExceedsItsTargetIsNotWrittenAsTheTarget) {
    const UncertaintyResult result = test::sample_result();
    Project project = test::sample_project();
    const OutputResult* x = nullptr;
    for (const OutputResult& output : result.outputs)
        if (!x && output.quantity.symbol == "x") x = &output;
    ASSERT_NE(x, nullptr);
    const Unit mm = Unit::of("mm");
    const double U = mm.interval_from_si(x->expanded_uncertainty);
    project.analyses.front().requirements = {{x->quantity.group, "x", Quantity{U / 1.003, mm}, {}, {}}};
    const ReportDocument document =
        build_report(*MadeProject::make(project), {test::sample_analysis(result)});
    const TableBlock* verdicts = table_with_id(document, "requirements-typed");
    ASSERT_NE(verdicts, nullptr);
    EXPECT_EQ(plain_cell(*verdicts, 0, 5), "not met");
    EXPECT_NE(plain_cell(*verdicts, 0, 3), format_significant(U / 1.003, 2));
    const auto made = judge(result, project.analyses.front());
    const Table table = results_table(result, {made.front().output}, made);
    EXPECT_EQ(to_unicode(written(table, table["U/target"], 0, {})), "1.003");
}

TEST(Report, SaysWhatWentWrongInTheRun) {
    UncertaintyResult result = test::sample_result();
    result.failed_trials = 12;
    result.adaptive = true;
    result.stabilised = false;
    result.warnings = {"beta is close to 90°: gimbal lock", "12 of 1000000 trials (0.0012 %) have no value"};
    const std::string text = to_markdown(
        build_report(*MadeProject::make(test::sample_project()), {test::sample_analysis(result)}));
    EXPECT_TRUE(contains(text, "12 of 1000000 trials (0.0012 %) have no value"));
    EXPECT_TRUE(contains(text, "| 12 |")) << "the provenance counts them too";
    EXPECT_TRUE(contains(text, "not stabilised"));
    EXPECT_TRUE(contains(text, "gimbal lock"));
}

// Every output, up to one trial in a hundred and beyond.
TEST(Report, TooManyLostTrialsMarkTheResultEverywhere) {
    const auto texts = [](std::uint64_t failed) {
        UncertaintyResult result = test::sample_result();
        result.trials = 100'000;
        result.failed_trials = failed;
        const EvaluatedAnalysis analysis = test::sample_analysis(result);
        const ReportDocument document = build_report(*MadeProject::make(test::sample_project()), {analysis});
        return std::vector<std::string>{to_markdown(document), to_html(document),
                                        to_csv(result_tables(test::sample_project(), analysis).front())};
    };
    for (const std::string& text : texts(1000)) EXPECT_FALSE(contains(text, does_not_represent));
    for (const std::string& text : texts(1001)) EXPECT_TRUE(contains(text, does_not_represent));
    UncertaintyResult result = test::sample_result();
    result.failed_trials = result.trials / 100 + 1;
    EXPECT_FALSE(represents_measurand(result));
    EXPECT_TRUE(contains(results_json(test::sample_project(), {test::sample_analysis(result)}),
                         "\"representsMeasurand\": false"));
    StudyResult study;
    study.trials = 1000;
    study.points.resize(2);
    study.points[1].failed_trials = 11;
    EXPECT_EQ(not_representing(study), std::vector<std::size_t>{1});
    EXPECT_TRUE(contains(remark_on(study, 1).english(), does_not_represent));
    EXPECT_EQ(remark_on(study, 0), "");
}

// Nothing is met, accepted or rejected by a result that says nothing about the measurand.
TEST(Report, RequirementsOnWhatDoesNotRepresentTheMeasurandAreNotJudged) {
    UncertaintyResult result = test::sample_result();
    result.failed_trials = result.trials / 100 + 1;
    const Project project = test::sample_project();
    const EvaluatedAnalysis analysis = test::sample_analysis(result);
    const auto verdicts = judge(result, project.analyses.front());
    ASSERT_FALSE(verdicts.empty());
    for (const RequirementResult& r : verdicts) {
        EXPECT_EQ(r.not_judged, why_not_judged());
        EXPECT_FALSE(r.meets_target);
        EXPECT_EQ(r.decision, RequirementResult::Decision::none);
    }
    const std::string report = to_markdown(build_report(*MadeProject::make(project), {analysis}));
    EXPECT_TRUE(contains(report, "The requirements are not judged: the result does not represent")) << report;
    EXPECT_TRUE(contains(report, "| not judged |"));
    for (const char* verdict : {"| met |", "| not met |", "| accepted |", "| rejected |", "risk"})
        EXPECT_FALSE(contains(report, verdict)) << verdict;
    const std::string json = results_json(project, {analysis});
    EXPECT_TRUE(contains(json, "\"notJudged\": \"the result does not represent the measurand"));
    EXPECT_TRUE(contains(json, "\"targetMet\": null"));
    for (const char* key : {"\"targetMet\": true", "\"decision\": \"", "\"conformance\""})
        EXPECT_FALSE(contains(json, key)) << key;
    for (const Table& table : result_tables(project, analysis))
        if (table.id == "requirements") {
            EXPECT_TRUE(contains(to_csv(table), "not judged")) << to_csv(table);
        }
}

TEST(Report, ShowsWhatRemainsWithoutAContributor) {
    UncertaintyResult result = test::sample_result();
    EXPECT_EQ(table_with_id(test::sample_report(), "contributors-typed"), nullptr);
    for (const char* const name : {"Robot", "Ballbars"}) {
        ContributorResult c{name, 3, {}, {}};
        c.without.first_order = c.alone.first_order = std::vector<double>(result.outputs.size(), 1.25e-6);
        result.contributors.push_back(std::move(c));
    }
    const std::string text = to_markdown(
        build_report(*MadeProject::make(test::sample_project()), {test::sample_analysis(result)}));
    EXPECT_TRUE(contains(text, "without Robot"));
    EXPECT_TRUE(contains(text, "By the law of propagation."));
    const ReportDocument document =  // has room for long tables
        build_report(*MadeProject::make(test::sample_project()), {test::sample_analysis(result)}, {},
                     {{}, {"budgets", "comparison", "distributions"}, false});
    const TableBlock* table = table_with_id(document, "contributors-typed");
    ASSERT_NE(table, nullptr);
    EXPECT_GT(table->table.rows, result.outputs.size()) << "every output, and heads of groups";
}

TEST(Report, FigureNamesAreUniqueAndCarryTheAnalysis) {
    const ReportDocument document = test::sample_report();
    std::set<std::string> ids;
    std::size_t figures = 0;
    for (const ReportBlock& block : document.blocks) {
        const auto* plot = std::get_if<PlotBlock>(&block);
        const auto* scene = std::get_if<SceneBlock>(&block);
        if (!plot && !scene) continue;
        ++figures;
        const std::string id = plot ? plot->plot.id : scene->id;
        ids.insert(id);
        EXPECT_EQ(id.rfind("typed-", 0), 0U) << id;
        EXPECT_EQ(
            (plot ? plot->caption : scene->caption).rfind("Figure " + std::to_string(figures) + ". ", 0), 0U);
    }
    EXPECT_EQ(figures, 6U + 6U + 2U + 1U + 1U)
        << "budgets, distributions, quantiles and convergence, scene, correlation";
    EXPECT_EQ(ids.size(), figures);
}

TEST(Report, ZeroUncertaintyMakesNoNonsense) {
    UncertaintyResult result = test::sample_result({1, 1, 1, false, "pose"});
    for (OutputResult& output : result.outputs) {
        output.standard_uncertainty = output.expanded_uncertainty = 0.0;
        output.first_order.standard_uncertainty = 0.0;
    }
    result.covariance.whole().setZero();
    for (auto& rows : result.budget.rows) rows.clear();
    const std::string text = to_markdown(
        build_report(*MadeProject::make(test::sample_project()), {test::sample_analysis(result)}));
    EXPECT_FALSE(contains(text, "| nan"));
    EXPECT_FALSE(contains(text, "–"));
    EXPECT_TRUE(contains(text, "-119"));
}

/// Every cell of every table, as the writer shows it.
void expect_every_cell(const ReportDocument& document, const std::string& text, bool html) {
    for (const TableBlock* table : tables_of(document))
        for (std::size_t r = 0; r < table->table.rows; ++r)
            for (std::size_t c = 0; c < table->table.shown_columns(); ++c) {
                if (!test::is_number(*table, r, c)) continue;
                const std::string shown =
                    html ? to_html(test::typeset_cell(*table, r, c)) : plain_cell(*table, r, c);
                ASSERT_TRUE(contains(text, shown)) << table->table.title << ": " << shown;
            }
}

TEST(Markdown, ContainsEveryNumberAndEscapes) {
    const ReportDocument document = test::sample_report();
    const std::string text = to_markdown(document);
    expect_every_cell(document, text, false);
    EXPECT_TRUE(contains(text, "# Stewart platform &lt;test &amp; trial&gt;"));
    EXPECT_TRUE(contains(text, "Mode \\| a priori or not"));
    EXPECT_TRUE(contains(text, "![Figure 1. "));
    EXPECT_TRUE(contains(text, "(typed-scene-pose-4.png)"));
}

TEST(Html, ContainsEveryNumberAndEscapes) {
    const ReportDocument document = test::sample_report();
    const std::string text = to_html(document);
    expect_every_cell(document, text, true);
    EXPECT_TRUE(contains(text, "<h1>Stewart platform &lt;test &amp; trial&gt;</h1>"));
    EXPECT_TRUE(contains(text, "−119.00"));  // a true minus sign
    EXPECT_TRUE(contains(text, "<img src=\"typed-scene-pose-4.png\""));
    EXPECT_TRUE(contains(text, "<sub>eff</sub>"));
    EXPECT_FALSE(contains(text, "<test"));
}

TEST(Report, ComponentsThatOnlyRoundingMakesCountAreLeftOut) {
    UncertaintyResult result = test::sample_result({1, 3, 3, true, "pose"});
    result.budget.rows[0][17].contribution = 1e-16 * result.outputs[0].standard_uncertainty;
    const ReportDocument document =
        build_report(*MadeProject::make(test::sample_project()), {test::sample_analysis(result)});
    EXPECT_EQ(table_with_id(document, "budget-typed-x-pose-1")->table.rows, 17U + 1U);
    EXPECT_EQ(table_with_id(document, "budget-typed-y-pose-1")->table.rows, 18U + 1U);
}

/// The notes of the budget of x.
std::string notes_of_budget(const UncertaintyResult& result) {
    const ReportDocument document =
        build_report(*MadeProject::make(test::sample_project()), {test::sample_analysis(result)});
    std::string notes;
    for (const Message& note : table_with_id(document, "budget-typed-x-pose-1")->table.notes)
        notes += note.english() + "\n";
    return notes;
}

TEST(Report, ABudgetSaysWhatItLeavesOutAndWhichUIsStated) {
    UncertaintyResult result = test::sample_result({1, 3, 3, true, "pose"});
    EXPECT_FALSE(contains(notes_of_budget(result), "Left out"));
    result.budget.rows[0][17].contribution = 1e-16 * result.outputs[0].standard_uncertainty;
    EXPECT_TRUE(contains(notes_of_budget(result),
                         "Left out, because they contribute nothing (less than 10⁻⁹ of "
                         "u_c): p_1,3z, coordinate of a point."))
        << notes_of_budget(result);
    result.budget.rows[0].resize(8);
    EXPECT_TRUE(contains(notes_of_budget(result), "Left out: 10 components that contribute nothing"))
        << notes_of_budget(result);
    const std::string last =
        "Stated in the results: x (pose 1) = " + result_statement(result.outputs[0], result) +
        " (propagation of distributions).\n";
    EXPECT_TRUE(notes_of_budget(result).ends_with(last)) << notes_of_budget(result);
    UncertaintyResult by_law = test::sample_result({1, 3, 3, false, "pose"});
    EXPECT_TRUE(notes_of_budget(by_law).ends_with("(law of propagation).\n")) << notes_of_budget(by_law);
}

/// 60 components of so many owners, whose names are their numbers.
UncertaintyResult with_owners(std::size_t owners) {
    UncertaintyResult result = test::sample_result({1, 10, 10, false, "pose"});
    const double u = result.outputs[0].first_order.standard_uncertainty;
    result.budget.rows[0].clear();
    for (std::size_t i = 0; i < result.budget.components.size(); ++i) {
        BudgetComponent& component = result.budget.components[i];
        component.owner = i % owners == 0 ? "" : "asset " + std::to_string(i % owners);
        component.origin = "";
        result.budget.rows[0].push_back({i, 1.0, u / std::sqrt(60.0), 1.0 / 60.0, {}});
    }
    return result;
}

TEST(Report, FurtherComponentsAreBrokenDownByWhoBringsThemIn) {
    for (const std::size_t owners : {1u, 2u, 5u, 6u, 20u}) {
        const ReportDocument document = build_report(*MadeProject::make(test::sample_project()),
                                                     {test::sample_analysis(with_owners(owners))});
        const TableBlock* budget = table_with_id(document, "budget-typed-x-pose-1");
        ASSERT_NE(budget, nullptr);
        std::size_t name = 0, share = 0, rest = 0;
        for (std::size_t c = 0; c < budget->table.shown_columns(); ++c) {
            if (head_of(*budget, c) == "Component") name = c;
            if (contains(head_of(*budget, c), "Share of variance")) share = c;
        }
        double sum = 0.0;
        std::string words;
        for (std::size_t r = 0; r + 1 < budget->table.rows; ++r) {
            sum += *exact_number(budget->table.columns[share], r);
            const std::string text = plain_cell(*budget, r, name);
            if (!contains(text, "further component")) continue;
            ++rest;
            words += text + "\n";
        }
        EXPECT_EQ(rest, std::min<std::size_t>(owners, 5)) << words;
        EXPECT_NEAR(sum, 100.0, 1e-9) << "every component is in one row";
        EXPECT_EQ(contains(words, "other sources"), owners > 5) << words;
        EXPECT_EQ(contains(words, ": the set-up"), owners > 1 && owners <= 6) << words;
        if (owners == 1) {
            EXPECT_EQ(words, "36 further components\n");
        }
    }
}

TEST(Report, ALongOneHasContentsAndAShortOneNone) {
    const auto contents_of = [](const ReportDocument& document) {
        return std::count_if(document.blocks.begin(), document.blocks.end(), [](const ReportBlock& block) {
            return std::holds_alternative<ContentsBlock>(block);
        });
    };
    const ReportDocument document = test::sample_report();
    EXPECT_EQ(contents_of(document), 1);
    EXPECT_TRUE(contains(to_html(document), "<a href=\"#section-1\">")) << "linked on a screen too";
    EXPECT_TRUE(contains(to_html(document), "id=\"section-1\""));
    EXPECT_FALSE(contains(to_html(document), "type=\"search\""));
    EXPECT_EQ(contents_of(build_report(*MadeProject::make(test::sample_project()), {})), 0);
}

TEST(Report, AQuantityHasOneEstimateAndOneUnitInItsBudget) {
    UncertaintyResult result;
    result.outputs.resize(1);
    result.outputs[0].quantity.unit = Unit::of("nm");
    const auto add = [&](const char* quantity, const char* unit, const char* of_quantity, double estimate) {
        BudgetComponent c;
        c.unit = Unit::of(unit);
        c.quantity_unit = Unit::of(of_quantity);
        c.quantities = {quantity};
        c.estimate = estimate;
        c.standard_uncertainty = 1e-3;
        result.budget.components.push_back(c);
        result.budget.rows.resize(1);
        result.budget.rows[0].push_back(
            {.component = result.budget.components.size() - 1, .sensitivity = 2e-9});
    };
    add("theta", "rad", "deg", 0.5);
    add("d", "mm", "mm", 0.1);
    add("theta", "arcsec", "deg", 0.5);
    const Table table = budget_table(result, budget_places(result, 0));
    EXPECT_DOUBLE_EQ(std::get<Measured>(table.cell(0, "estimate")).si, 0.5);
    EXPECT_DOUBLE_EQ(std::get<Measured>(table.cell(1, "estimate")).si, 0.1);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(table.cell(2, "estimate"))) << "it stands above";
    for (const std::size_t row : {0u, 2u}) {
        EXPECT_EQ(std::get<Unit>(table.cell(row, "unit")), Unit::of("deg"));
        EXPECT_EQ(to_unicode(written(table, table["sensitivity"], row, {})), "0.0349\u00a0nm/°");
    }
    EXPECT_EQ(std::get<Unit>(table.cell(1, "sensitivity unit")), Unit::of("nm/mm"));
}

TEST(Report, AQuotientOfUnitsIsNoneForEqualOnesAndOfDifferencesOfTemperature) {
    EXPECT_EQ(quotient(Unit::of("mm"), Unit::of("degC")).display(), "mm/K");
    EXPECT_EQ(quotient(Unit::of("nm"), Unit::of("1/K")).display(), "nm·K");
    EXPECT_EQ(quotient(Unit::of("mm"), Unit::of("mm")), Unit{});
    EXPECT_EQ(quotient(Unit::of("mm"), Unit{}), Unit::of("mm"));
}

}  // namespace
}  // namespace covaria::report_test
