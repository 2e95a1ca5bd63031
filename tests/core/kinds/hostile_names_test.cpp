// Names are data: whatever the assets and points of the shipped projects are called, the numbers, the budgets
// and all that is written stay the same.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/resource_path.h"
#include "core/document/document_writers.h"
#include "core/project/csv_reader.h"
#include "core/project/project_file.h"
#include "core/propagation/engine.h"
#include "core/report/report.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "core/result_files/results_json.h"
#include "tests/core/made.h"

namespace covaria::hostile_names_test {
namespace {

constexpr const char* shipped[] = {"tracker-pose", "stewart-platform", "lsm-network", "ballbar-tcp"};

struct Evaluated {
    MadeProject::Pointer made;
    std::vector<EvaluatedAnalysis> analyses;
};

Evaluated evaluated(Project project) {
    Evaluated all;
    for (AnalysisEntry& entry : project.analyses) {
        entry.options = {};
        entry.options.method = Method::first_order;
        entry.options.contributor_trials = 0;
        entry.studies.clear();
    }
    all.made = MadeProject::make(project);
    for (const AnalysisEntry& entry : project.analyses) {
        const auto prepared = all.made->analysis(entry.id);
        if (!prepared) continue;
        auto result = run_analysis(*prepared);
        if (result)
            all.analyses.push_back(
                {prepared, std::make_shared<const UncertaintyResult>(std::move(*result)), {}, {}});
    }
    const Problems problems = all.made->problems();
    for (const Problem& p : problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << ": " << p.message.english();
    EXPECT_EQ(all.analyses.size(), project.analyses.size());
    return all;
}

/// The assets' names, and the names in cells of tables that no choice or reference gives.
Project renamed(Project project, const std::function<std::string(const std::string&)>& rename) {
    for (AssetEntry& asset : project.assets) asset.name = rename(asset.name);
    for (AnalysisEntry& analysis : project.analyses) analysis.name = rename(analysis.name);
    return project;
}

void expect_same_numbers(const Evaluated& a, const Evaluated& b, const std::string& what) {
    ASSERT_EQ(a.analyses.size(), b.analyses.size());
    for (std::size_t i = 0; i < a.analyses.size(); ++i) {
        const UncertaintyResult &x = *a.analyses[i].result, &y = *b.analyses[i].result;
        ASSERT_EQ(x.outputs.size(), y.outputs.size());
        for (std::size_t j = 0; j < x.outputs.size(); ++j)
            EXPECT_EQ(x.outputs[j].expanded_uncertainty, y.outputs[j].expanded_uncertainty) << what;
        ASSERT_EQ(x.contributors.size(), y.contributors.size()) << what << ": contributors merged";
        for (std::size_t c = 0; c < x.contributors.size(); ++c) {
            EXPECT_EQ(x.contributors[c].without.first_order, y.contributors[c].without.first_order) << what;
            for (std::size_t d = 0; d < c; ++d)
                EXPECT_NE(y.contributors[c].contributor, y.contributors[d].contributor) << what;
        }
    }
}

/// Every component of every budget knows its quantities, and the estimate is theirs.
void expect_whole_budgets(const Evaluated& all) {
    for (const EvaluatedAnalysis& analysis : all.analyses) {
        const UncertaintyResult& result = *analysis.result;
        for (const auto& rows : result.budget.rows)
            for (const BudgetRow& row : rows) {
                const BudgetComponent& c = result.budget.components[row.component];
                ASSERT_FALSE(c.quantities.empty()) << c.id;
                for (const std::string& symbol : c.quantities)
                    EXPECT_NE(result.inputs->find(symbol), InputSet::npos) << symbol;
                EXPECT_EQ(c.estimate, estimate_of(result.inputs, result.inputs->find(c.quantities.front())));
            }
        for (const Table& table : result_tables(Project{}, analysis)) {
            const auto csv = read_csv(to_csv(table), ',');
            ASSERT_TRUE(csv) << table.id << ": " << csv.error().message.english();
            ASSERT_EQ(csv->rows.size(), table.rows + 1) << table.id;
            for (std::size_t r = 0; r < table.rows; ++r) {
                const Cell cell = table.columns.front().cell(r);
                const auto* text = std::get_if<std::string>(&cell);
                if (!text || text->empty() || text->front() == ' ') continue;
                EXPECT_TRUE(csv->rows[r + 1].cells.front().ends_with(*text)) << *text;
            }
        }
    }
}

void expect_written(const Project& project, const Evaluated& all) {
    const std::string written = project_text(project);
    const LoadedProject again = parse_project(written, data_directory() / "projects", "renamed");
    EXPECT_FALSE(again.problems.has_errors());
    EXPECT_EQ(project_text(again.project), written);
    EXPECT_TRUE(nlohmann::json::accept(results_json(project, all.analyses)));
    const ReportDocument report = build_report(*all.made, all.analyses);
    EXPECT_FALSE(to_html(report).empty());
    EXPECT_FALSE(to_markdown(report).empty());
}

class HostileNames : public testing::TestWithParam<const char*> {
protected:
    Project project_ =
        load_project(data_directory() / "projects" / (std::string(GetParam()) + ".covaria")).project;
};

TEST_P(HostileNames, LeaveNumbersAndBudgets) {
    const Evaluated plain = evaluated(project_);
    for (const char* ending : {",1", ".1", " 1", ";\"'", "<b>&amp;", " | `x`", "\xe6\xb5\x8b \xce\xb1"}) {
        const Project named = renamed(project_, [&](const std::string& name) { return name + ending; });
        const Evaluated all = evaluated(named);
        expect_same_numbers(plain, all, ending);
        expect_whole_budgets(all);
        expect_written(named, all);
    }
}

TEST_P(HostileNames, AssetsOfOneNameStayApart) {
    const Evaluated plain = evaluated(project_);
    const Evaluated alike = evaluated(renamed(project_, [](const std::string&) { return "tracker"; }));
    expect_same_numbers(plain, alike, "one name for all");
}

INSTANTIATE_TEST_SUITE_P(Shipped, HostileNames, testing::ValuesIn(shipped), [](const auto& file) {
    std::string name = file.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

// Symbols with a comma come from names of points: "q_1,1".
TEST(HostileSymbols, KeepTheirEstimatesInTheBudget) {
    InputSet inputs;
    for (const char* symbol : {"q_1,1", "q_1,2", "a.b", "c d", "e\"f", "\xce\xb8,1"}) {
        InputQuantity quantity{.symbol = symbol, .name = symbol, .offset = 2.0};
        UncertaintyComponent own{.id = std::string(symbol) + ".own", .name = "own"};
        own.distribution = Distribution::normal(1.0);
        inputs.add(std::move(quantity), {std::move(own)});
    }
    const std::size_t shared =
        inputs.add({.id = "both", .name = "both", .distribution = Distribution::normal(1.0)});
    for (std::size_t i = 0; i < 2; ++i) inputs.quantities[i].shares.push_back({shared, 1.0});
    class Sum : public MeasurementModel {
    public:
        explicit Sum(const InputSet& set) : inputs_(set) { outputs_.push_back({.symbol = "y,1"}); }
        const InputSet& inputs() const override { return inputs_; }
        const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
        bool evaluate(std::span<const double> x, std::span<double> y) const override {
            y[0] = 0.0;
            for (const double value : x) y[0] += value;
            return true;
        }
        Layout layout(std::span<const double>) const override { return {}; }

    private:
        InputSet inputs_;
        std::vector<OutputQuantity> outputs_;
    };
    EvaluationOptions options;
    options.method = Method::first_order;
    auto result = evaluate(Sum(inputs), inputs, options);
    ASSERT_TRUE(result) << result.error().message.english();
    const BudgetComponent& both = result->budget.components[shared];
    EXPECT_EQ(both.quantities, (std::vector<std::string>{"q_1,1", "q_1,2"}));
    Evaluated all;
    all.analyses.push_back({analysis_with("sum", inputs),
                            std::make_shared<const UncertaintyResult>(std::move(*result)),
                            {},
                            {}});
    expect_whole_budgets(all);
}

}  // namespace
}  // namespace covaria::hostile_names_test
