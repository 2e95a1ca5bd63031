// Scatter that is stated of observations in groups against the components of variance that they show.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

#include "core/evidence/seen.h"
#include "core/kinds/registries.h"
#include "core/model/asset.h"

namespace covaria::group_evidence_test {
namespace {

using Groups = std::vector<std::vector<double>>;
const Groups balanced{{1.0, 1.2, 1.1, 0.8}, {2.0, 2.1, 2.3, 1.9}, {0.4, 0.6, 0.2, 0.7}, {1.6, 1.9, 1.4, 1.3}};

std::unique_ptr<MeasurementModel> model_of(covaria::Setup setup, std::optional<double> within,
                                           std::optional<double> between, Problems& problems) {
    setup.values["unit"] = std::string("mm");
    if (within) setup.values["stated_within"] = Quantity{*within, Unit{}};
    if (between) setup.values["stated_between"] = Quantity{*between, Unit{}};
    const ModelDescriptor& d = *find_model("observations-in-groups");
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

covaria::Setup observations(const Groups& groups) {
    SetupTable table;
    table.units.assign(2, Unit{});
    for (std::size_t j = 0; j < groups.size(); ++j)
        for (const double v : groups[j]) table.rows.push_back({"day " + std::to_string(j), v});
    covaria::Setup setup;
    setup.values["observations"] = table;
    return setup;
}

struct Squares {
    double within = 0.0, means = 0.0, degrees_within = 0.0;
};
Squares squares_of(const Groups& groups) {
    Squares found;
    double grand = 0.0;
    std::vector<double> means;
    for (const auto& group : groups) {
        double mean = 0.0;
        for (const double v : group) mean += v / double(group.size());
        for (const double v : group) found.within += (v - mean) * (v - mean);
        found.degrees_within += double(group.size()) - 1.0;
        means.push_back(mean);
        grand += mean / double(groups.size());
    }
    for (const double mean : means) found.means += (mean - grand) * (mean - grand);
    return found;
}

TEST(GroupEvidence, WithinTheGroupsIsTheMeanSquare) {
    const Groups unbalanced{{10.1, 10.4, 9.9}, {11.0, 11.3, 10.7, 11.1, 10.9}, {9.2, 9.6}, {10.5}};
    Problems problems;
    const auto readings = model_of(observations(unbalanced), 0.2, {}, problems)->redundant_readings();
    ASSERT_TRUE(readings);
    const evidence::Seen seen = evidence::see(*readings);
    ASSERT_TRUE(seen.found);
    const Squares squares = squares_of(unbalanced);
    const double expected = squares.within / squares.degrees_within / 0.04;
    EXPECT_NEAR(seen.figures[0].square, expected, 1e-9 * expected);
    EXPECT_NEAR(seen.figures[0].degrees_of_freedom, squares.degrees_within, 1e-6);
    EXPECT_NEAR(readings->figures[0].least, 0.2e-3, 1e-15);
    EXPECT_TRUE(std::isnan(readings->w.back()));  // nothing controls the one observation of the last day
}

/// Of groups of one size restricted maximum likelihood is the analysis of variance.
TEST(GroupEvidence, ComponentsAreThoseOfTheAnalysisOfVariance) {
    Problems problems;
    const auto readings = model_of(observations(balanced), 0.1, 0.5, problems)->redundant_readings();
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->figures.size(), 2u);
    const evidence::Seen seen = evidence::see(*readings);
    ASSERT_TRUE(seen.found);
    const Squares squares = squares_of(balanced);
    const double within = squares.within / squares.degrees_within;
    const double between = squares.means / 3.0 - within / 4.0;
    EXPECT_NEAR(seen.figures[0].square, within / 0.01, 1e-7 * within / 0.01);
    EXPECT_NEAR(seen.figures[1].square, between / 0.25, 1e-7 * between / 0.25);
}

TEST(GroupEvidence, SummariesSayWhatTheirObservationsDo) {
    covaria::Setup summary;
    summary.values["data"] = std::string("summary");
    SetupTable table;
    table.units.assign(4, Unit{});
    for (std::size_t j = 0; j < balanced.size(); ++j) {
        const Squares own = squares_of({balanced[j]});
        double mean = 0.0;
        for (const double v : balanced[j]) mean += v / 4.0;
        table.rows.push_back({"day " + std::to_string(j), mean, std::sqrt(own.within / 3.0), 4.0});
    }
    summary.values["groups"] = table;
    for (const std::optional<double> between : {std::optional<double>(), std::optional<double>(0.5)}) {
        Problems problems;
        const auto whole = model_of(observations(balanced), 0.1, between, problems)->redundant_readings();
        const auto summed = model_of(summary, 0.1, between, problems)->redundant_readings();
        ASSERT_TRUE(whole && summed);
        const evidence::Seen a = evidence::see(*whole), b = evidence::see(*summed);
        ASSERT_TRUE(a.found && b.found);
        EXPECT_NEAR(a.sum_of_squares, b.sum_of_squares, 1e-9 * a.sum_of_squares);
        EXPECT_EQ(a.degrees_of_freedom, b.degrees_of_freedom);
        for (std::size_t k = 0; k < a.figures.size(); ++k) {
            EXPECT_NEAR(a.figures[k].square, b.figures[k].square, 1e-7 * a.figures[k].square);
            EXPECT_NEAR(a.figures[k].degrees_of_freedom, b.figures[k].degrees_of_freedom, 1e-5);
        }
    }
}

TEST(GroupEvidence, NothingStatedIsNotHeldAgainstAnything) {
    Problems problems;
    EXPECT_EQ(model_of(observations(balanced), {}, {}, problems)->redundant_readings(), nullptr);
    EXPECT_EQ(model_of(observations(balanced), {}, 0.5, problems), nullptr);
    ASSERT_EQ(problems.items().size(), 1u);
    EXPECT_EQ(problems.items()[0].path, "/stated_within");
}

}  // namespace
}  // namespace covaria::group_evidence_test
