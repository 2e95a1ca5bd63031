// Observations in groups: analysis of variance of unbalanced groups against an independent computation.
#include <gtest/gtest.h>

#include <cmath>

#include "core/kinds/registries.h"
#include "core/model/asset.h"
#include "core/propagation/engine.h"

namespace covaria::group_observations_test {
namespace {

using Groups = std::vector<std::vector<double>>;

covaria::Setup setup_of(const Groups& groups, const std::string& between) {
    covaria::Setup setup;
    SetupTable table;
    table.units.assign(2, Unit{});
    for (std::size_t j = 0; j < groups.size(); ++j)
        for (const double v : groups[j]) table.rows.push_back({"day " + std::to_string(j + 1), v});
    setup.values["observations"] = table;
    setup.values["between"] = between;
    return setup;
}

std::unique_ptr<MeasurementModel> model_of(const covaria::Setup& setup, Problems& problems) {
    const ModelDescriptor& d = *find_model("observations-in-groups");
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

FirstOrderOutput mean_of(const covaria::Setup& setup) {
    Problems problems;
    const auto model = model_of(setup, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << " " << p.message.english();
    return evaluate_first_order(*model, model->inputs(), {}).value().outputs[0].first_order;
}

double cell(const MeasurementModel& model, const std::string& id, std::size_t row, std::size_t column) {
    for (const Table& table : model.evaluation())
        if (table.id == id) {
            const Cell found = table.columns.at(column).cell(row);
            return std::holds_alternative<Quantity>(found) ? std::get<Quantity>(found).value
                                                           : std::get<Measured>(found).si;
        }
    throw std::runtime_error("no table " + id);
}

const Groups unbalanced{{10.1, 10.4, 9.9}, {11.0, 11.3, 10.7, 11.1, 10.9}, {9.2, 9.6}, {10.5}};

// scipy.stats.f_oneway and numpy, 1.10 and 1.24.
TEST(GroupObservations, UnbalancedAnalysisOfVariance) {
    Problems problems;
    const auto model = model_of(setup_of(unbalanced, "included"), problems);
    ASSERT_TRUE(model);
    EXPECT_NEAR(cell(*model, "variance", 0, 1), 4.01515151515, 1e-10);
    EXPECT_NEAR(cell(*model, "variance", 0, 2), 3.0, 0.0);
    EXPECT_NEAR(cell(*model, "variance", 1, 1), 0.406666666667, 1e-11);
    EXPECT_NEAR(cell(*model, "variance", 1, 2), 7.0, 0.0);
    EXPECT_NEAR(cell(*model, "variance", 0, 4), 23.037754595131577, 1e-10);
    EXPECT_NEAR(cell(*model, "variance", 0, 5), 0.0005292015689280536, 1e-12);
    EXPECT_NEAR(cell(*model, "variance", 2, 2), 10.0, 0.0);
    EXPECT_NEAR(cell(*model, "anova", 3, 1), 0.717800874364, 1e-11);
    EXPECT_NEAR(cell(*model, "anova", 4, 1), 2.48484848485, 1e-10);
}

TEST(GroupObservations, UnbalancedMeans) {
    const FirstOrderOutput included = mean_of(setup_of(unbalanced, "included"));
    EXPECT_NEAR(included.estimate, 10.2583333333, 1e-9);
    EXPECT_NEAR(included.standard_uncertainty, 0.336753289186, 1e-11);
    EXPECT_NEAR(included.effective_degrees_of_freedom, 3.0, 1e-9);
    const FirstOrderOutput components = mean_of(setup_of(unbalanced, "components"));
    EXPECT_NEAR(components.estimate, 10.2608396684, 1e-9);
    EXPECT_NEAR(components.standard_uncertainty, 0.368854291429, 1e-11);
    EXPECT_NEAR(components.effective_degrees_of_freedom, 3.0564486, 1e-6);
    const FirstOrderOutput none = mean_of(setup_of(unbalanced, "none"));
    EXPECT_NEAR(none.estimate, 10.4272727273, 1e-9);
    EXPECT_NEAR(none.standard_uncertainty, 0.200495254576, 1e-11);
    EXPECT_NEAR(none.effective_degrees_of_freedom, 10.0, 1e-9);
}

// Groups of one size: the components of variance say what the scatter of the means says; without an effect
// that is seen, what all observations say.
TEST(GroupObservations, ComponentsOfBalancedGroupsAreTheScatterOfTheMeans) {
    const Groups apart{{1.0, 1.2, 1.1}, {2.0, 2.1, 2.3}, {0.4, 0.6, 0.2}},
        mixed{{1.0, 3.0}, {2.0, 1.9}, {3.1, 0.9}};
    const auto equal = [](const FirstOrderOutput& a, const FirstOrderOutput& b) {
        EXPECT_NEAR(a.estimate, b.estimate, 1e-14);
        EXPECT_NEAR(a.standard_uncertainty, b.standard_uncertainty, 1e-14);
        EXPECT_NEAR(a.effective_degrees_of_freedom, b.effective_degrees_of_freedom, 1e-9);
    };
    equal(mean_of(setup_of(apart, "components")), mean_of(setup_of(apart, "included")));
    equal(mean_of(setup_of(mixed, "components")), mean_of(setup_of(mixed, "none")));
}

// Means, deviations and numbers say the same as the observations.
TEST(GroupObservations, ASummaryEqualsItsObservations) {
    covaria::Setup setup;
    setup.values["data"] = std::string("summary");
    SetupTable table;
    table.units.assign(4, Unit{});
    for (std::size_t j = 0; j < unbalanced.size(); ++j) {
        const auto n = static_cast<double>(unbalanced[j].size());
        double mean = 0.0, squares = 0.0;
        for (const double v : unbalanced[j]) mean += v / n;
        for (const double v : unbalanced[j]) squares += (v - mean) * (v - mean);
        table.rows.push_back(
            {"day " + std::to_string(j), mean, n > 1.0 ? std::sqrt(squares / (n - 1.0)) : 0.0, n});
    }
    setup.values["groups"] = table;
    for (const char* between : {"included", "components", "none"}) {
        setup.values["between"] = std::string(between);
        const FirstOrderOutput a = mean_of(setup), b = mean_of(setup_of(unbalanced, between));
        EXPECT_NEAR(a.estimate, b.estimate, 1e-13);
        EXPECT_NEAR(a.standard_uncertainty, b.standard_uncertainty, 1e-13);
        EXPECT_NEAR(a.effective_degrees_of_freedom, b.effective_degrees_of_freedom, 1e-6);
    }
}

TEST(GroupObservations, RefusesGroupsThatSayNothing) {
    const auto message = [](const Groups& groups) {
        Problems problems;
        EXPECT_EQ(model_of(setup_of(groups, "included"), problems), nullptr);
        return problems.items().empty() ? std::string() : problems.items().front().message.english();
    };
    EXPECT_NE(message({{1, 2, 3, 4}}).find("at least two groups"), std::string::npos);
    EXPECT_NE(message({{1}, {2}, {3}, {4}}).find("no group has more than one"), std::string::npos);
}

}  // namespace
}  // namespace covaria::group_observations_test
