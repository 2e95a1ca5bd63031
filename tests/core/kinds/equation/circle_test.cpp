// Angles of typed equations are on the circle: at its cut, in intervals, under limits, through links.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/project/stated_requirements.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace covaria::circle_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string analysis(const std::string& id, const std::string& equation, const std::string& rows,
                     const std::string& further = "") {
    return R"({"id": ")" + id + R"(", "model": "measurement-equation", "setup": {"equations": [")" +
           equation +
           R"("], "quantities": {"columns": ["symbol", "value", "unit", "statement", "a"], "rows": [)" +
           rows +
           R"(]}, "outputs": {"columns": ["symbol", "unit"], "rows": [["y", "deg"]]}},
           "options": {"trials": 100000, "seed": "7"})" +
           further + "}";
}

struct Evaluated {
    LoadedProject loaded;
    UncertaintyResult result;
    const OutputResult& y() const { return result.outputs[0]; }
    RequirementResult verdict() const { return judge(result, loaded.project, "a").at(0); }
};

Evaluated evaluated(const std::string& analyses) {
    Evaluated made{
        parse_project(
            R"({"format": "covaria", "schemaVersion": 2, "title": "", "assets": [], "analyses": [)" +
                analyses + "]}",
            {}, "circle"),
        {}};
    for (const Problem& p : made.loaded.problems.items())
        ADD_FAILURE() << p.path << ": " << p.message.english();
    Problems problems;
    const auto prepared = made_analysis(made.loaded.project, "a", problems);
    if (!prepared) return made;
    auto result = evaluate(*prepared->propagated, prepared->options);
    if (!result) ADD_FAILURE() << result.error().message.english();
    if (result) made.result = std::move(*result);
    return made;
}

const std::string at_the_cut = R"(["im", 0.001, "1", "standard", 0.01], ["re", -1, "1", "standard", 0.01])";

TEST(CircleOfEquations, AnAngleAtTheCutHasTheMeanAndUOfAnyOther) {
    const Evaluated made = evaluated(analysis("a", "y = atan2(im, re)", at_the_cut));
    const double angle = std::atan2(0.001, -1.0), u = 0.01 / std::hypot(0.001, 1.0);
    const MonteCarloOutput& trials = *made.y().monte_carlo;
    EXPECT_NEAR(made.y().first_order.estimate, angle, 1e-12);
    EXPECT_NEAR(made.y().first_order.standard_uncertainty, u, 1e-9);
    EXPECT_NEAR(trials.mean, angle, 4 * u / std::sqrt(1e5));
    EXPECT_NEAR(trials.standard_uncertainty, u, 4 * u / std::sqrt(2e5));
    EXPECT_NEAR(trials.symmetric.low, angle - 1.96 * u, 0.03 * u);
    EXPECT_NEAR(trials.symmetric.high, angle + 1.96 * u, 0.03 * u);
}

// The same angle, with turns and quarters added.
TEST(CircleOfEquations, TurnsMakeNoDifference) {
    const double u = evaluated(analysis("a", "y = atan2(im, re)", at_the_cut)).y().standard_uncertainty;
    for (const char* equation :
         {"y = atan2(im, re) + pi", "y = atan2(im, re) - 720 [deg]", "y = -atan2(im, re)",
          "y = if(atan2(im, re) < 0, atan2(im, re) + 2*pi, atan2(im, re))",
          "y = atan2(im, re) - atan2(-im, -re)"}) {
        const double found = evaluated(analysis("a", equation, at_the_cut)).y().standard_uncertainty;
        EXPECT_LT(found, 2.5 * u) << equation;
    }
    EXPECT_NEAR(evaluated(analysis("a", "y = 2*atan2(im, re)", at_the_cut)).y().standard_uncertainty, 2 * u,
                1e-3 * u);
}

TEST(CircleOfEquations, LimitsHoldWhatIsOneTurnAway) {
    const std::string limits = R"(, "requirements": [{"symbol": "y", "guardFactor": 0,
        "lowerLimit": {"value": %1, "unit": "deg"}, "upperLimit": {"value": %2, "unit": "deg"}}])";
    const auto verdict = [&](const std::string& low, const std::string& high, const std::string& angle) {
        std::string stated = limits;
        stated.replace(stated.find("%1"), 2, low);
        stated.replace(stated.find("%2"), 2, high);
        return evaluated(
                   analysis("a", "y = phi", R"(["phi", )" + angle + R"(, "deg", "standard", 0.1])", stated))
            .verdict();
    };
    const RequirementResult inside = verdict("-1", "1", "359.9"), outside = verdict("-1", "1", "358.0");
    EXPECT_EQ(inside.decision, RequirementResult::Decision::accept);
    EXPECT_NEAR(inside.conformance, 1.0, 1e-12);
    EXPECT_EQ(outside.decision, RequirementResult::Decision::reject);
    EXPECT_NEAR(outside.conformance, 0.0, 1e-12);
    EXPECT_EQ(verdict("179", "181", "-180.5").decision, RequirementResult::Decision::accept);
}

TEST(CircleOfEquations, ALinkTakesTheAngleNextToItsEstimate) {
    const Evaluated made =
        evaluated(analysis("up", "y = atan2(im, re)", at_the_cut) + ", " +
                  analysis("a", "y = 0.5*phi", R"(["phi", 0, "deg", "constant", null])",
                           R"(, "links": [{"input": "phi", "analysis": "up", "output": "y"}])"));
    EXPECT_NEAR(made.y().standard_uncertainty, 0.005, 1e-4);
    EXPECT_NEAR(made.y().estimate, 0.5 * std::atan2(0.001, -1.0), 1e-3 * degree + 1e-4);
}

}  // namespace
}  // namespace covaria::circle_test
