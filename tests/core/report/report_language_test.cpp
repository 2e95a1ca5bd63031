// A report in another language: nothing that it says goes past it, neither words nor numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "core/base/name.h"
#include "core/document/document_writers.h"
#include "core/quantity/distribution.h"
#include "core/report/comparison_report.h"
#include "core/report/report.h"
#include "core/text/symbol.h"
#include "core/views/comparison_columns.h"
#include "core/views/design_results.h"
#include "core/views/result_columns.h"
#include "tests/core/report/compared_sample.h"
#include "tests/core/report/sample_report.h"
#include "tests/core/report/shown_cells.h"
#include "tests/core/result/changed_inputs.h"

namespace covaria::report_language_test {
namespace {

/// A language that leaves of every text only its placeholders, so that names and numbers remain of a report.
struct Mute {
    std::set<std::string> asked;
    DocumentLanguage language{"xx", {",", "'"}, [this](const std::string& english) {
                                  asked.insert(english);
                                  std::string places;
                                  for (std::size_t i = 0; i + 1 < english.size(); ++i)
                                      if (english[i] == '%' && english[i + 1] >= '1' && english[i + 1] <= '9')
                                          places += " " + english.substr(i, 2) + " ";
                                  return places;
                              }};
};

StudyResult study(std::size_t points, std::size_t axes) {
    StudyResult study;
    study.id = study.name = "study-" + std::to_string(axes);
    for (std::size_t axis = 0; axis < axes; ++axis) {
        study.axes.push_back({"varied", test::mm(), axis == 1, {}, 2.5});
        for (std::size_t i = 0; i < points; ++i) study.axes.back().values.push_back(1.5 + double(i));
    }
    study.outputs = {{"x", "x", test::mm(), "pose 1"}};
    study.reasons = {"", "a reason"};
    study.trials = 1000;
    study.points.resize(axes == 1 ? points : points * points);
    for (StudyPoint& point : study.points) point.values = {{0.1, 1.25e-6, 2.5e-6}};
    study.points[0].failed_trials = 100;
    study.points[1] = {1};
    return study;
}

DesignResult design(bool of_rows) {
    DesignResult design;
    design.id = design.name = of_rows ? "design-rows" : "design-values";
    design.analysis = "typed";
    design.objective_words = "largest U/target";
    design.found = true;
    design.before = 1.5;
    design.objective = 0.825;
    design.goals = {{{"x", "x", test::mm(), "pose 1"}, 1e-3, 1.5e-3, 1.8e-3, 0.9e-3, true}};
    design.evaluations = 50;
    design.trials = 1000;
    design.reasons = {{"a reason", 3}};
    if (of_rows) {
        design.rows = {{0, "row-name", false, true, 1.6}, {2, "row-name", true, false, {}}};
        design.gains = {{0, "row-name", true, 0.25, {}}};
        design.curve = {{2, 1.65}, {3, 0.825}};
        design.path = {{10, "greedy", 1.05}, {30, "exchange", 0.825}};
        design.sources = {{"an origin", 0.125}};
    } else {
        design.values = {{"varied", test::mm(), 0.15, 1.5, 1.25, 0.5, 0.01, 2.5}};
        design.cost = 2.5;
        design.goals[0].price_of_target = 4e5;
        design.front = {{0.5, 300.5}, {1.0, 100.5}};
    }
    return design;
}

struct Sample {
    int poses = 1;
    bool monte_carlo = true;
    bool annex = false;
};

/// A result with something in every chapter.
UncertaintyResult result_of(const Sample& sample) {
    UncertaintyResult result = test::sample_result({sample.poses, 3, 3, sample.monte_carlo, "pose"});
    test::change_inputs(result, [](InputSet& inputs) {
        inputs.correlations = {{0, 1, 0.25}};
        inputs.components[2].held = true;
    });
    result.budget.components[2].held = true;
    result.budget.components[0].tags = {{"parameter", "b_1"}};
    result.warnings = {tell<"%1 components with smaller indices are left out.">(2)};
    result.stabilised = result.intervals_exact = false;
    result.variance_reduction = sample.annex ? VarianceReduction::sobol : VarianceReduction::control_variate;
    result.regions[0].singular = true;
    const std::size_t outputs = result.outputs.size();
    for (const char* name : {"", "contributor"}) {
        ContributorResult one{name, 1, {}, {}};
        one.without = one.alone = {std::vector<double>(outputs, 1.5e-6), {}, 3};
        result.contributors.push_back(one);
    }
    if (sample.annex) result.contributors.push_back(result.contributors.back());
    result.sobol.assign(outputs, std::vector<SobolIndex>(20, {"b_1x.typed", {0}, 0.25, 0.5, 0.01, 0.02}));
    result.sobol_trials = 10'000;
    for (OutputResult& output : result.outputs) {
        output.first_order.second_order_standard_uncertainty = 1.5e-4;
        output.first_order.second_order_estimate_shift = 1.5e-5;
        if (!output.monte_carlo) continue;
        output.monte_carlo->normality.acceptable = false;
        output.monte_carlo->normality.words = tell<"too flat for k u">();
    }
    result.outputs.back().quantity.role = OutputRole::intermediate;
    if (sample.monte_carlo) result.failed_trials = sample.annex ? result.trials : 3;
    return result;
}

Project project_of() {
    Project project = test::sample_project();
    project.number = "A 7";
    project.author = "author-name";
    AnalysisEntry& entry = project.analyses[0];
    entry.requirements.push_back(
        {"pose 1", "y", {}, Quantity{100.5, test::mm()}, Quantity{127.5, test::mm()}, 0.83});
    entry.requirements.push_back({"pose 1", "x", {}, {}, Quantity{-300.5, test::mm()}});
    entry.quantity_notes = {{"b_1x", "a note"}};
    entry.notes = "a note";
    AnalysisEntry other = entry;
    other.id = other.name = "other-analysis";
    project.analyses.push_back(other);
    return project;
}

EvaluatedAnalysis analysis_of(const Sample& sample) {
    EvaluatedAnalysis evaluated = test::sample_analysis(result_of(sample));
    auto prepared = std::make_shared<PreparedAnalysis>(*evaluated.analysis);
    prepared->linked = {{"x",
                         "linked-quantity",
                         test::mm(),
                         "id",
                         "other-analysis",
                         {"x", "x", test::mm(), "pose 1"},
                         true,
                         0.125,
                         0.0015,
                         12.5}};
    evaluated.analysis = prepared;
    evaluated.warnings = {
        tell<"No ellipsoid is given where the covariance matrix of the group is singular.">()};
    evaluated.studies = {std::make_shared<const StudyResult>(study(4, 1)),
                         std::make_shared<const StudyResult>(study(4, 2))};
    evaluated.designs = {std::make_shared<const DesignResult>(design(true)),
                         std::make_shared<const DesignResult>(design(false))};
    const auto after = std::make_shared<const UncertaintyResult>(result_of({sample.poses, true}));
    auto before = std::make_shared<UncertaintyResult>(*after);
    before->fixed_coverage_factor = 2.0;
    before->budget.components[1].standard_uncertainty *= 1.5;
    for (auto& rows : before->budget.rows) rows[1].contribution *= 1.5;
    evaluated.before =
        std::make_shared<const ResultsBefore>(ResultsBefore{"earlier-file", compare_results(before, after)});
    return evaluated;
}

ReportDocument report_of(const Sample& sample, const DocumentLanguage& in) {
    ReportContents contents;
    contents.annex = sample.annex;
    return build_report(*MadeProject::make(project_of()), {analysis_of(sample)},
                        {{"f", "failed-one", {}, "a reason"}, {"f", "failed-one", "study-f", "a reason"}},
                        contents, in);
}

const std::vector<Sample>& samples() {
    static const std::vector<Sample> all{{}, {1, false}, {2, true, true}, {13}, {40}, {40, true, true}};
    return all;
}

/// Every text that readers see, in their notation.
struct Texts {
    std::vector<std::string> texts = {};

    void operator()(const HeadingBlock& block) { texts.push_back(block.text); }
    void operator()(const ParagraphBlock& block) { texts.push_back(block.text); }
    void operator()(const ListBlock& block) {
        texts.insert(texts.end(), block.items.begin(), block.items.end());
    }
    void operator()(const FactsBlock& block) {
        for (const auto& [name, value] : block.facts) texts.insert(texts.end(), {name, value});
    }
    void operator()(const TableBlock& block) {
        texts.push_back(block.table.title);
        for (std::size_t c = 0; c < block.table.shown_columns(); ++c) {
            texts.push_back(test::head_of(block, c));
            for (std::size_t r = 0; r < block.table.rows; ++r)
                texts.push_back(to_unicode(test::typeset_cell(block, r, c)));
        }
        for (const Message& note : block.table.notes) texts.push_back(note.english());
    }
    void operator()(const PlotBlock& block) {
        texts.push_back(block.caption);
        const auto add = [this](const Text& text) { texts.push_back(to_unicode(text)); };
        add(block.plot.title);
        for (const PlotAxis* axis : {&block.plot.x, &block.plot.y}) {
            add(axis->title);
            for (const Text& category : axis->categories) add(category);
        }
        for (const PlotSeries& series : block.plot.series) add(series.name);
        for (const PlotMark& mark : block.plot.marks) add(mark.label);
        for (const PlotBand& band : block.plot.bands) add(band.label);
    }
    void operator()(const SceneBlock& block) { texts.push_back(block.caption); }
    void operator()(const EquationBlock&) {}  // an equation of the model, with its source
    void operator()(const ContentsBlock&) {}  // the headings
    template <class Other>
    void operator()(const Other&) {
        ADD_FAILURE() << "a report has no such block";
    }
};

std::vector<std::string> texts_of(const ReportDocument& document) {
    Texts texts{{document.title, document.running_head, document.over, document.page_words}};
    for (const ReportBlock& block : document.blocks) std::visit(texts, block);
    return texts.texts;
}

/// The text without the names that the sample and its model give.
std::string without_names(const std::string& text) {
    static const std::regex names(
        "Stewart platform <test & trial>|Pose of the platform|pose [0-9]+|sample-pose|study-[0-9f]|"
        "coordinate of a point|point [bp]|typed, Table "
        "1|[bp][_0-9]+[xyz]\\.typed|design-(rows|values)|varied|"
        "row-name|a reason|an origin|author-name|other-analysis|a "
        "note|linked-quantity|earlier-file|failed-one|"
        "contributor|Covaria|[0-9a-f]{16}|\\b(normal|typed|base|TUR)\\b|ν_eff|d_(low|high)|\\b0\\.2\\.0\\b");
    return std::regex_replace(text, names, "");
}

TEST(ReportLanguage, EveryWordGoesThroughIt) {
    Mute mute;
    const std::regex word("[A-Za-z]{3,}");
    for (const Sample& sample : samples()) {
        const ReportDocument document = report_of(sample, mute.language);
        EXPECT_EQ(document.language, "xx");
        for (const std::string& text : texts_of(document))
            EXPECT_FALSE(std::regex_search(without_names(text), word)) << text;
    }
}

TEST(ReportLanguage, NumbersHaveItsDecimalSign) {
    Mute mute;
    const std::regex with_point("[0-9]\\.[0-9]");
    for (const Sample& sample : samples()) {
        const ReportDocument document = report_of(sample, mute.language);
        EXPECT_EQ(document.numbers.decimal, ",");
        for (const ReportBlock& block : document.blocks) {
            if (std::holds_alternative<HeadingBlock>(block)) continue;  // "2.1"
            Texts texts;
            std::visit(texts, block);
            for (const std::string& text : texts.texts)
                EXPECT_FALSE(std::regex_search(without_names(text), with_point)) << text;
        }
        EXPECT_TRUE(std::regex_search(to_markdown(document), std::regex("\\| [0-9]+,[0-9]+ \\|")));
    }
}

void know(std::set<std::string>& known, const Table& table) {
    for (const Column& column : table.columns) {
        known.insert(column.head);
        known.insert(column.undeclared.begin(), column.undeclared.end());
    }
}

/// Adds a table whose keys are its heads for people, too.
void know_heads(std::set<std::string>& known, const Table& table) {
    known.insert(table.title);
    for (const Column& column : table.columns) known.insert({column.key, column.head});
}

std::set<std::string> declared() {
    std::set<std::string> known{Answer{}.yes, Answer{}.no, "parameter", "largest U/target", ""};
    for (const char* words : Message::all_words()) known.insert(words);
    for (const char* phrase : Phrase::all()) known.insert(phrase);
    for (const DistributionKindInfo& kind : distribution_kinds()) known.emplace(kind.title);
    known.insert({test::sample_model().title, test::sample_model().summary});
    for (const FieldSpec& field : test::sample_model().schema.fields()) {
        known.insert({field.title, field.section});
        for (const ColumnSpec& column : field.columns) known.insert(column.title);
        for (const Choice& choice : field.choices) known.insert(choice.title);
    }
    const UncertaintyResult result = result_of({});
    know(known, results_table(result));
    know(known, budget_table(result, budget_places(result, 0)));
    know(known, inputs_table(result.inputs, all_shares(result.inputs)));
    know(known, input_correlations_table(result.inputs, {}));
    know(known, regions_table(result));
    const ResultComparison comparison = test::sample_comparison();
    know(known, compared_results_table(comparison));
    know(known, compared_budget_table(comparison, compared_places(comparison, 0)));
    for (const bool of_rows : {true, false})
        for (const Table& table : design_tables(design(of_rows))) know_heads(known, table);
    return known;
}

TEST(ReportLanguage, CataloguesHaveWhatIsAskedFor) {
    Mute mute;
    for (const Sample& sample : samples()) report_of(sample, mute.language);
    const std::set<std::string> known = declared();
    for (const std::string& text : mute.asked)
        EXPECT_TRUE(known.contains(text)) << "the catalogues have no " << text;
}

/// Texts of a report with this group of results, contributor, and group of contributions.
std::vector<std::string> texts_with(const Name& name, const DocumentLanguage& in) {
    EvaluatedAnalysis evaluated = analysis_of({});
    auto result = std::make_shared<UncertaintyResult>(*evaluated.result);
    for (OutputResult& output : result->outputs) output.quantity.group = name;
    for (CoverageRegion& region : result->regions) region.group = name;
    for (ContributorResult& contributor : result->contributors) contributor.contributor = name;
    for (BudgetComponent& component : result->budget.components) component.tags = {{"kind", name}};
    evaluated.result = result;
    return texts_of(build_report(*MadeProject::make(project_of()), {evaluated}, {}, {}, in));
}

// "distances" is a word of the program: a group that somebody called so keeps its name in every language.
TEST(ReportLanguage, ANameThatSomebodyGaveIsNotTranslatedForBeingAWordOfTheProgram) {
    Mute mute;
    const auto with_it = [&](const Name& name) {
        const std::vector<std::string> texts = texts_with(name, mute.language);
        return std::count_if(texts.begin(), texts.end(), [](const std::string& text) {
            return text.find("test only: distances") != std::string::npos;
        });
    };
    EXPECT_EQ(with_it(own_name<"test only: distances">()), 0);
    const auto typed = with_it(Name("test only: distances"));
    EXPECT_GT(typed, 3) << "heads of tables, subheads, rows of contributions, titles of plots";
}

TEST(ReportLanguage, EnglishIsWhatALanguageOfTheSameWordsSays) {
    const DocumentLanguage same{"en", {}, [](const std::string& english) { return english; }};
    for (const Sample& sample : samples()) {
        EXPECT_EQ(to_markdown(report_of(sample, same)), to_markdown(report_of(sample, {})));
        EXPECT_EQ(to_html(report_of(sample, same)), to_html(report_of(sample, {})));
    }
}

TEST(ReportLanguage, AComparisonIsInItToo) {
    Mute mute;
    const ReportDocument document = build_comparison(
        {"a.covaria", "b.covaria", {"old"}, {}}, {{"id", "A 7", test::sample_comparison()}}, mute.language);
    const std::regex word("[A-Za-z]{3,}"),
        names("[ab]\\.covaria|old|pose 1|calibration|drift|temperature|reading");
    for (const std::string& text : texts_of(document))
        EXPECT_FALSE(std::regex_search(std::regex_replace(text, names, ""), word)) << text;
    EXPECT_EQ(document.language, "xx");
}

TEST(DocumentLanguage, SaysATitleThatHasNoSymbols) {
    Mute mute;
    EXPECT_EQ(to_unicode(mute.language.say_title(Text("deviation"))), "");
    EXPECT_EQ(to_unicode(mute.language.say_title(symbol_text("b_1x"))), "b₁ₓ");
    EXPECT_TRUE(mute.language.say_title({}).empty());
}

}  // namespace
}  // namespace covaria::report_language_test
