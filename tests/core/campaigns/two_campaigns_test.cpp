// A figure that two rounds of a total station have seen, in the network that takes it: projects/seen-chain
// with a second campaign.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/resource_path.h"
#include "core/evidence/combined.h"
#include "core/kinds/registries.h"
#include "core/math/special_quantiles.h"
#include "tests/core/made.h"

namespace covaria::two_campaigns_test {
namespace {

std::size_t column_of(const char* table, const char* key) {
    const auto& columns = find_model("network-adjustment")->schema.find(table)->columns;
    return static_cast<std::size_t>(std::ranges::find(columns, key, &ColumnSpec::key) - columns.begin());
}

/// The chain, with a copy of its rounds whose directions scatter otherwise.
struct Chain {
    Chain() : project(load_project(data_directory() / "projects/seen-chain.covaria").project) {
        AnalysisEntry again = *project.find_analysis("rounds");
        again.id = "again";
        again.name = "Rounds again";
        auto& rows = std::get<SetupTable>(again.setup.values.at("readings")).rows;
        const std::size_t angle = column_of("readings", "angle");
        std::mt19937_64 random(5);
        std::normal_distribution<double> scatter(0.0, 0.002);  // gon
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (auto* value = std::get_if<double>(&rows[i][angle])) *value += scatter(random);
        project.analyses.insert(project.analyses.begin(), std::move(again));
    }

    covaria::Setup& network() {
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == "network") return analysis.setup;
        throw std::out_of_range("network");
    }

    /// The first direction of the network, taken from these campaigns.
    UncertaintyComponent direction(const std::string& first, const std::vector<std::string>& further) {
        network().values["seen_in"] = first;
        SetupTable table;
        table.units = {Unit{}};
        for (const std::string& id : further) table.rows.push_back({id});
        network().values["further_campaigns"] = table;
        Problems problems;
        const auto prepared = made_analysis(project, "network", problems);
        for (const Problem& problem : problems.items())
            if (problem.severity == Severity::error)
                ADD_FAILURE() << problem.path << " " << problem.message.english();
        return prepared->model->inputs().components.front();
    }

    Project project;
};

TEST(TwoCampaigns, AFigureIsCombinedWithWhatItChangesBetweenThem) {
    Chain chain;
    const UncertaintyComponent a = chain.direction("rounds", {}), b = chain.direction("again", {});
    const double u_a = a.distribution.standard_uncertainty(), u_b = b.distribution.standard_uncertainty();
    ASSERT_GT(std::abs(u_b / u_a - 1.0), 0.5);
    const evidence::CombinedFigure expected =
        evidence::combined({{u_a, a.degrees_of_freedom}, {u_b, b.degrees_of_freedom}});
    ASSERT_GT(expected.between, 0.0);
    const UncertaintyComponent both = chain.direction("rounds", {"again"});
    EXPECT_NEAR(both.distribution.standard_uncertainty(), expected.u, 1e-9 * expected.u);
    EXPECT_NEAR(both.degrees_of_freedom, expected.degrees_of_freedom, 1e-9 * expected.degrees_of_freedom);
    EXPECT_LT(both.degrees_of_freedom, std::min(a.degrees_of_freedom, b.degrees_of_freedom));
    EXPECT_NE(both.origin.english().find("from one campaign to the next it changes by"), std::string::npos)
        << both.origin.english();
}

/// A chart of the figures of the network over its campaigns, as of directions.
TEST(TwoCampaigns, AFigureIsDrawnOverTheDaysOfItsCampaigns) {
    Chain chain;
    const auto charts = [&] {
        const UncertaintyComponent both = chain.direction("rounds", {"again"});
        Problems problems;
        std::vector<PlotSpecification> drawn =
            made_analysis(chain.project, "network", problems)->model->figures();
        return std::pair(both, drawn);
    };
    const double u_first = chain.direction("rounds", {}).distribution.standard_uncertainty(),
                 u_second = chain.direction("again", {}).distribution.standard_uncertainty();
    const auto directions = [](const std::vector<PlotSpecification>& drawn) {
        return std::ranges::find(drawn, "campaigns-directions-TS", &PlotSpecification::id);
    };
    const auto [both, in_order] = charts();
    ASSERT_NE(directions(in_order), in_order.end());
    EXPECT_EQ(directions(in_order)->series[0].x, (std::vector<double>{1.0, 2.0}));

    for (AnalysisEntry& analysis : chain.project.analyses) {
        if (analysis.id == "rounds") analysis.setup.values["read_on"] = std::string("2024-11-28");
        if (analysis.id == "again") analysis.setup.values["read_on"] = std::string("2026-11-28");
    }
    const std::vector<PlotSpecification> drawn = charts().second;
    const auto chart = directions(drawn);
    ASSERT_NE(chart, drawn.end());
    ASSERT_EQ(chart->series.size(), 6u);  // values, their intervals, the combined one, ends of its interval
    const Unit unit = Unit::parse(chart->y.unit).value();
    EXPECT_EQ(chart->series[0].x, (std::vector<double>{0.0, 730.0 / 365.25}));
    EXPECT_NEAR(unit.to_si(chart->series[0].y[0]), u_first, 1e-9 * u_first);
    EXPECT_NEAR(unit.to_si(chart->series[0].y[1]), u_second, 1e-9 * u_second);
    for (const std::size_t k : {0u, 1u}) {
        const PlotSeries& interval = chart->series[1 + k];
        EXPECT_EQ(interval.x, std::vector<double>(2, chart->series[0].x[k]));
        EXPECT_LT(interval.y[0], chart->series[0].y[k]);
        EXPECT_GT(interval.y[1], chart->series[0].y[k]);
    }
    const double combined = both.distribution.standard_uncertainty();
    EXPECT_NEAR(unit.to_si(chart->series[3].y[0]), combined, 1e-9 * combined);
    EXPECT_LT(chart->series[3].x[0], 0.0);
    // The next campaign is known as the degrees of freedom say.
    const double nu = both.degrees_of_freedom;
    for (const auto& [series, p] : {std::pair(4, 0.975), std::pair(5, 0.025)}) {
        const double end = combined * std::sqrt(nu / chi_squared_quantile(p, nu));
        EXPECT_NEAR(unit.to_si(chart->series[static_cast<std::size_t>(series)].y[1]), end, 1e-9 * end);
    }
}

TEST(TwoCampaigns, OneCampaignIsNotDrawn) {
    Chain chain;
    chain.direction("rounds", {});
    Problems problems;
    EXPECT_TRUE(made_analysis(chain.project, "network", problems)->model->figures().empty());
}

TEST(TwoCampaigns, TheSameCampaignTwiceIsOne) {
    Chain chain;
    const UncertaintyComponent once = chain.direction("rounds", {}),
                               twice = chain.direction("rounds", {"rounds"});
    EXPECT_EQ(once.distribution.standard_uncertainty(), twice.distribution.standard_uncertainty());
    EXPECT_EQ(once.degrees_of_freedom, twice.degrees_of_freedom);
}

}  // namespace
}  // namespace covaria::two_campaigns_test
