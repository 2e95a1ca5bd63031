// Contents of a report, and how it becomes short: nothing is lost that the annex is asked for.
#include "core/report/report_extent.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/report/sample_report.h"
#include "tests/core/report/shown_cells.h"

namespace covaria::report_extent_test {
namespace {

using namespace report_parts;

std::vector<std::string> headings_of(const ReportDocument& document, int level) {
    std::vector<std::string> headings;
    for (const ReportBlock& block : document.blocks)
        if (const auto* heading = std::get_if<HeadingBlock>(&block); heading && heading->level == level)
            headings.push_back(heading->text.substr(heading->text.find("\u2002") + 3));
    return headings;
}

bool has_heading(const ReportDocument& document, const std::string& title) {
    for (const int level : {1, 2})
        for (const std::string& heading : headings_of(document, level))
            if (heading == title) return true;
    return false;
}

std::size_t rows_of(const ReportDocument& document, const std::string& id) {
    std::size_t rows = 0;
    for (const ReportBlock& block : document.blocks)
        if (const auto* table = std::get_if<TableBlock>(&block); table && table->table.id == id)
            rows = std::max(rows, table->table.rows);
    return rows;
}

std::size_t count_figures(const ReportDocument& document) {
    std::size_t count = 0;
    for (const ReportBlock& block : document.blocks) count += std::holds_alternative<PlotBlock>(block);
    return count;
}

/// The sample, as often as asked for, under names of their own.
struct Many {
    explicit Many(int count, int poses = 13) {
        test::SampleOptions options;
        options.poses = poses;
        Project project = test::sample_project();
        const AnalysisEntry entry = project.analyses.front();
        project.analyses.clear();
        for (int i = 0; i < count; ++i) {
            EvaluatedAnalysis one = test::sample_analysis(test::sample_result(options));
            auto analysis = std::make_shared<PreparedAnalysis>(*one.analysis);
            analysis->id = entry.id + std::to_string(i);
            analysis->name = "Analysis " + std::to_string(i);
            one.analysis = analysis;
            one.warnings = {"A warning of the run."};  // a chapter of notes
            analyses.push_back(one);
            project.analyses.push_back(entry);
            project.analyses.back().id = analysis->id;
            project.analyses.back().name = analysis->name;
        }
        made = MadeProject::make(project);
    }
    ReportDocument report(const ReportContents& contents = {}) const {
        return build_report(*made, analyses, {}, contents);
    }
    std::vector<EvaluatedAnalysis> analyses;
    MadeProject::Pointer made;
};

TEST(ReportContents, AChapterThatIsLeftOutIsNotThere) {
    const Many sample(1);
    const ReportDocument whole = sample.report();
    int there = 0;
    for (const ReportChapterField& chapter : report_chapters()) {
        ReportContents contents;
        choose(contents.without_chapters, chapter.key, false);
        EXPECT_FALSE(has_heading(sample.report(contents), chapter.title)) << chapter.key;
        there += has_heading(whole, chapter.title);
        EXPECT_TRUE(has_heading(sample.report(contents), "Results")) << chapter.key;
    }
    EXPECT_GE(there, 10) << "titles of the list are those of the report, whose picture is on its first page";
}

TEST(ReportContents, AnAnalysisThatIsLeftOutIsNamedAndNotShown) {
    const Many sample(3);
    ReportContents contents;
    choose(contents.without_analyses, sample.analyses[1].analysis->id, false);
    const ReportDocument report = sample.report(contents);
    EXPECT_TRUE(has_heading(report, "Analysis 0"));
    EXPECT_FALSE(has_heading(report, "Analysis 1"));
    EXPECT_TRUE(has_heading(report, "Analysis 2"));
    const auto& facts = std::get<FactsBlock>(report.blocks[0]).facts;
    EXPECT_TRUE(std::any_of(facts.begin(), facts.end(), [](const auto& fact) {
        return fact == std::pair<std::string, std::string>("Not in this report", "Analysis 1");
    }));
}

TEST(ReportExtent, AShortReportIsWhole) {
    const Many sample(1, 1);
    const ReportDocument report = sample.report(), with_annex = sample.report({{}, {}, true});
    EXPECT_EQ(report.blocks.size(), with_annex.blocks.size());
    EXPECT_FALSE(has_heading(with_annex, "Annex")) << "nothing is left for it";
}

TEST(ReportExtent, ALongOneIsShortenedAndWholeInTheAnnex) {
    for (const int count : {4, 14}) {
        const Many sample(count, 60);
        const ReportDocument body = sample.report(), all = sample.report({{}, {}, true});
        EXPECT_LE(lines_of(body.blocks), 20.0 * lines_of_page) << count;
        EXPECT_GT(lines_of(all.blocks), 3.0 * lines_of(body.blocks));
        EXPECT_TRUE(has_heading(all, "Annex"));
        for (const EvaluatedAnalysis& one : sample.analyses) {
            EXPECT_TRUE(has_heading(body, one.analysis->name));
            const std::string id = "results-" + one.analysis->id;
            EXPECT_GT(rows_of(body, id), 5U) << "results are always there";
            EXPECT_LT(rows_of(body, id), 31U);
            EXPECT_EQ(rows_of(all, id), 60U * 7U) << "six of each pose under its name";
        }
        EXPECT_GE(count_figures(all), std::size_t(count) * 14);
        EXPECT_LT(count_figures(body), count_figures(all));
    }
}

TEST(ReportExtent, TheRowsShownAreOfTheGroupWithTheLargestUncertainties) {
    const Many sample(4, 60);
    const std::string group = groups_in_full(*sample.analyses[0].result).front();
    const ReportDocument body = sample.report();
    for (const ReportBlock& block : body.blocks) {
        const auto* table = std::get_if<TableBlock>(&block);
        if (!table || table->table.id != "results-" + sample.analyses[0].analysis->id) continue;
        EXPECT_EQ(table->table.subheads.at(0), group);
        EXPECT_NE(table->table.notes.back().english().find("of 360 rows"), std::string::npos)
            << table->table.notes.back() << ": sub-heads are no rows";
        EXPECT_EQ(table->table.rows, table->table.subheads.size() * 7) << "no group is cut";
    }
}

TEST(ReportExtent, WhatDecidesTheDecimalsOfARowStaysWithIt) {
    Extent extent;
    extent.rows = 6;
    TableBlock table;
    std::vector<int> decimals;
    table.table.add("estimate").estimate_of("spread");
    table.table.add("reading");
    table.table.add("spread").uncertainty(2).hidden = true;
    for (const char* group : {"a", "b"}) {
        table.table.subhead(group);
        decimals.push_back(-1);
        for (int row = 0; row < 20; ++row) {
            table.table.row({1.0, 2.0, group[0] == 'a' ? 0.11 : 0.011});
            decimals.push_back(group[0] == 'a' ? 1 : 2);
        }
    }
    table.table.columns[1].rule.by_row = decimals;
    const ShortenedChapter part = shorten({table}, extent, "b", Elsewhere::files, {});
    const auto& shown = std::get<TableBlock>(part.body.front());
    ASSERT_EQ(shown.table.subheads.at(0), "b");
    EXPECT_EQ(test::plain_cell(shown, 1, 0), "1.000");
    EXPECT_EQ(test::plain_cell(shown, 1, 1), "2.00");
}

TableBlock of_two_columns() {
    TableBlock block;
    for (const char* key : {"a", "b"}) block.table.add(key);
    return block;
}

TEST(ReportExtent, ATableThatIsCutSaysSoAndNoOther) {
    Extent extent;
    extent.rows = 6;
    for (const bool groups : {false, true})
        for (std::size_t rows = 1; rows < 40; ++rows) {
            TableBlock table = of_two_columns();
            for (std::size_t row = 0; row < rows; ++row) {
                if (groups && row % 4 == 0) table.table.subhead("group");
                table.table.row({1.0, 2.0});
            }
            const ShortenedChapter part = shorten({table}, extent, "", Elsewhere::files, {});
            const auto& shown = std::get<TableBlock>(part.body.front()).table;
            EXPECT_EQ(shown.notes.empty(), shown.rows == table.table.rows) << rows;
            EXPECT_LE(shown.rows, 12U) << rows << " rows" << (groups ? " in groups" : "");
        }
}

TEST(ReportExtent, AHeadingGoesWithTheTablesThatWereUnderIt) {
    TableBlock table = of_two_columns();
    for (const double x : {1.0, 2.0}) table.table.row({x, x + 1.0});
    Blocks chapter{HeadingBlock{2, "Chapter"}};
    for (const char* name : {"first", "second", "third"}) {
        chapter.push_back(HeadingBlock{3, name});
        chapter.push_back(ParagraphBlock{"About it."});
        chapter.push_back(table);
    }
    chapter.push_back(HeadingBlock{3, "words alone"});
    chapter.push_back(ParagraphBlock{"It never had a table."});
    Extent extent;
    extent.tables = 2;
    std::vector<std::string> headings;
    for (const ReportBlock& block : shorten(chapter, extent, "", Elsewhere::files, {}).body)
        if (const auto* heading = std::get_if<HeadingBlock>(&block)) headings.push_back(heading->text);
    EXPECT_EQ(headings, (std::vector<std::string>{"Chapter", "first", "second", "words alone"}));
}

TEST(GroupsShown, AreComparedWithThoseOfTheSameQuantitiesOnly) {
    UncertaintyResult result;
    const auto add = [&](const char* group, const char* symbol, double U) {
        OutputResult output;
        output.quantity.group = group;
        output.quantity.symbol = symbol;
        output.expanded_uncertainty = U;
        result.outputs.push_back(output);
    };
    add("A", "x", 1.0);
    add("B", "x", 3.0);
    add("C", "x", 2.0);
    for (const char* only : {"d_1", "d_2", "d_3"}) add("distances", only, 0.1);
    EXPECT_EQ(groups_like_the_first(result), (std::vector<Name>{"A", "B", "C"}));
    EXPECT_EQ(groups_in_full(result), std::vector<Name>{"B"}) << "not the one with symbols of its own";
}

TEST(ReportExtent, RoomGoesToThoseThatNeedIt) {
    EXPECT_EQ(shares_of(100.0, {10.0, 200.0, 30.0, 300.0}), (std::vector<double>{10.0, 30.0, 30.0, 30.0}));
    EXPECT_EQ(shares_of(100.0, {10.0, 200.0}), (std::vector<double>{10.0, 90.0}));
    EXPECT_EQ(shares_of(100.0, {10.0, 20.0}), (std::vector<double>{10.0, 20.0}));
    EXPECT_TRUE(shares_of(100.0, {}).empty());
}

}  // namespace
}  // namespace covaria::report_extent_test
