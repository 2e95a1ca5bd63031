// Calibrated lengths in the network of Galetto et al.: as checks, as constraints; large set-ups. Millimetres.
#include "core/kinds/registries.h"
#include "tests/core/kinds/network/network_project.h"
#include "tests/core/table_rows.h"

namespace covaria::network_scale_bar_test {
namespace {

void give_bar(Network& network, const std::string& role, double u, SetupCell length = {},
              const std::string& id = "recommended", const char* from = "A", const char* to = "B") {
    const FieldSpec* field = find_model("points-from-sensors")->schema.find("scale_bars");
    SetupTable bars;
    for (const ColumnSpec& column : field->columns) bars.units.push_back(column.unit);
    bars.rows = {{std::string(from), std::string(to), length, u, role}};
    network.setup(id).values["scale_bars"] = bars;
}

double u_of_distance(const UncertaintyResult& result, const std::string& symbol) {
    for (const OutputResult& output : result.outputs)
        if (output.quantity.symbol == symbol) return 1e3 * output.standard_uncertainty;
    ADD_FAILURE() << "no " << symbol;
    return 0.0;
}

TEST(NetworkScaleBar, ACheckLeavesTheNetworkAsItIs) {
    Network without, with;
    give_bar(with, "check", 0.01);
    const UncertaintyResult a = without.run("recommended", 0), b = with.run("recommended", 0);
    ASSERT_EQ(b.outputs.size(), a.outputs.size() + 1);
    EXPECT_EQ(u_of(a, "B"), u_of(b, "B"));
    const OutputResult& difference = b.outputs.back();
    EXPECT_EQ(difference.quantity.symbol, "ΔAB");
    EXPECT_NEAR(difference.estimate, 0.0, 1e-12);
    const double distance = u_of_distance(a, "AB");
    EXPECT_NEAR(u_of(b, "calibrated lengths")[0], std::hypot(distance, 0.01), 1e-9);
}

TEST(NetworkScaleBar, AConstraintHoldsTheLength) {
    Network without, tight, loose;
    give_bar(tight, "constraint", 0.001);
    give_bar(loose, "constraint", 1000.0);
    const UncertaintyResult free = without.run("recommended", 0);
    EXPECT_NEAR(u_of_distance(tight.run("recommended", 0), "AB"), 0.001, 1e-6);
    EXPECT_NEAR(u_of_distance(loose.run("recommended", 0), "AB"), u_of_distance(free, "AB"), 1e-7);
    for (const char* group : {"A", "B", "C"}) {
        const Row before = u_of(free, group), after = u_of(tight.run("recommended", 0), group);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_LE(after[i], before[i] * (1.0 + 1e-9)) << group << i;
    }
}

// The best combination of two independent values of one length: 1/u^2 = 1/u_1^2 + 1/u_2^2.
TEST(NetworkScaleBar, AConstraintIsWeighted) {
    Network without, with;
    const double free = u_of_distance(without.run("recommended", 0), "AB");
    give_bar(with, "constraint", free);
    EXPECT_NEAR(u_of_distance(with.run("recommended", 0), "AB"), free / std::sqrt(2.0), 1e-6 * free);
}

TEST(NetworkScaleBar, MonteCarloAgrees) {
    Network network;
    give_bar(network, "constraint", 0.02);
    const UncertaintyResult result = network.run("recommended", 100'000);
    EXPECT_EQ(result.failed_trials, 0u);
    for (const OutputResult& y : result.outputs)
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty, y.first_order.standard_uncertainty,
                    4.0 * y.monte_carlo->standard_error_of_uncertainty)
            << y.quantity.name;
}

TEST(NetworkScaleBar, GivenReadingsAreAdjustedWithIt) {
    Network network;
    give_readings(network, "recommended", 0.0);
    give_bar(network, "constraint", 0.001, 728.5);
    const auto prepared = network.prepare("recommended");
    ASSERT_NE(prepared, nullptr) << network.words();
    const Table residuals = prepared->model->evaluation().back();
    EXPECT_EQ(english_of(test::rows_of(residuals).back()[1]), "scale bar");
    EXPECT_EQ(residuals.rows, 28u);
    EXPECT_NE(residuals.notes.front().english().find("19 degrees of freedom"), std::string::npos)
        << residuals.notes.front();
    const UncertaintyResult result = network.run("recommended", 0);
    for (const OutputResult& output : result.outputs)
        if (output.quantity.symbol == "AB") {
            EXPECT_NEAR(1e3 * output.estimate, 728.5, 1e-3);
        }
}

TEST(NetworkScaleBar, WhatCannotBeDone) {
    Network network;
    give_bar(network, "constraint", 0.01, {}, "paper");
    network.setup("paper").values["estimator"] = std::string("linear");
    network.prepare("paper");
    EXPECT_NE(network.words().find("only of the non-linear estimator"), std::string::npos) << network.words();

    Network far;
    give_bar(far, "check", 0.01, 500.0);
    EXPECT_NE(far.prepare("recommended"), nullptr);
    EXPECT_NE(far.words().find("at another distance than its calibrated length"), std::string::npos);

    Network two;
    two.table("targets", "recommended").rows[1][4] = true;
    give_bar(two, "constraint", 0.01);
    EXPECT_EQ(two.prepare("recommended"), nullptr);
    EXPECT_NE(two.words().find("belong to two set-ups"), std::string::npos) << two.words();

    Network nobody;
    give_bar(nobody, "check", 0.01, {}, "recommended", "A", "Z");
    EXPECT_EQ(nobody.prepare("recommended"), nullptr);
    EXPECT_NE(nobody.words().find("there is no target Z"), std::string::npos) << nobody.words();
}

/// A grid of targets around B.
void give_grid(Network& network, const std::string& id, int n) {
    SetupTable& targets = network.table("targets", id);
    targets.rows.clear();
    for (int i = 0; i < n; ++i)
        targets.rows.push_back(
            {"T" + std::to_string(i), 4000.0 + 100.0 * (i % 10), 100.0 * (i / 10), -200.0, false});
    network.table("distances", id).rows = {{std::string("T0"), std::string("T" + std::to_string(n - 1))}};
}

// 60 targets by 9 readings are one adjustment; with 80 each target is estimated by itself, as if it were the
// only one: less well, because the others say nothing about the stations.
TEST(NetworkLarge, TargetsAreEstimatedByThemselves) {
    Network together, divided;
    give_grid(together, "recommended", 60);
    give_grid(divided, "recommended", 80);
    const UncertaintyResult a = together.run("recommended", 0), b = divided.run("recommended", 0);
    EXPECT_EQ(together.words(), "");
    EXPECT_NE(divided.words().find("720 readings of one set-up are too many"), std::string::npos)
        << divided.words();
    for (const int number : {0, 31, 59}) {
        const std::string name = "T" + std::to_string(number);
        Network alone;
        alone.keep_target(name, {4000.0 + 100.0 * (number % 10), 100.0 * (number / 10), -200.0},
                          "recommended");
        const Row best = u_of(a, name), single = u_of(b, name);
        expect_relative(single, u_of(alone.run("recommended", 0), name), 1e-6);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_GE(single[i], best[i] * (1.0 - 1e-9)) << name;
    }
}

TEST(NetworkLarge, MonteCarloAgreesWhereEachTargetIsByItself) {
    Network network;
    give_grid(network, "recommended", 80);
    const UncertaintyResult result = network.run("recommended", 20'000);
    EXPECT_EQ(result.failed_trials, 0u);
    for (const OutputResult& y : result.outputs)
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty, y.first_order.standard_uncertainty,
                    4.0 * y.monte_carlo->standard_error_of_uncertainty)
            << y.quantity.name;
}

}  // namespace
}  // namespace covaria::network_scale_bar_test
