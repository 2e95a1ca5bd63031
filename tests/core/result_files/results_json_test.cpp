// results.json against the contract of the command line: keys, order, units, null for what does not exist.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/result_files/results_json.h"
#include "tests/core/report/sample_report.h"

namespace covaria::results_json_test {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
}

std::string text_of(const UncertaintyResult& result) {
    return results_json(test::sample_project(), {test::sample_analysis(result)});
}

TEST(ResultsJson, HasTheKeysOfTheContractInOrder) {
    const Json json = Json::parse(text_of(test::sample_result()));
    using Keys = std::vector<std::string>;
    EXPECT_EQ(keys_of(json), (Keys{"format", "schemaVersion", "project", "analyses"}));
    EXPECT_EQ(json["format"], "covaria-results");
    EXPECT_EQ(json["schemaVersion"], 1);
    const Json& analysis = json["analyses"][0];
    EXPECT_EQ(keys_of(analysis), (Keys{"id", "model", "trials", "failedTrials", "representsMeasurand",
                                       "stabilised", "seed", "outputs", "covariance", "requirements"}));
    const Json& output = analysis["outputs"][0];
    EXPECT_EQ(keys_of(output),
              (Keys{"symbol", "group", "unit", "role", "estimate", "mean", "standardUncertainty",
                    "expandedUncertainty", "coverageFactor", "expandedUncertaintyBy", "interval",
                    "shortestInterval", "skewness", "kurtosis", "excessKurtosis", "firstOrder"}));
    EXPECT_EQ(keys_of(output["interval"]), (Keys{"kind", "probability", "low", "high"}));
    EXPECT_EQ(keys_of(output["shortestInterval"]), (Keys{"low", "high"}));
    EXPECT_EQ(keys_of(output["firstOrder"]),
              (Keys{"estimate", "standardUncertainty", "effectiveDegreesOfFreedom", "coverageFactor",
                    "expandedUncertainty", "validated"}));
}

TEST(ResultsJson, NumbersAreInTheUnitThatIsNamed) {
    const UncertaintyResult result = test::sample_result();
    const Json analysis = Json::parse(text_of(result))["analyses"][0];
    const Json& x = analysis["outputs"][0];
    const Json& alpha = analysis["outputs"][3];
    EXPECT_EQ(x["unit"], "mm");
    EXPECT_NEAR(x["estimate"].get<double>(), 1e3 * result.outputs[0].estimate, 1e-9);
    EXPECT_NEAR(x["interval"]["low"].get<double>(), 1e3 * result.outputs[0].monte_carlo->symmetric.low, 1e-9);
    EXPECT_EQ(alpha["unit"], "deg");
    EXPECT_NEAR(alpha["estimate"].get<double>(), 5.0, 1e-12);
    EXPECT_NEAR(alpha["expandedUncertainty"].get<double>(), 0.101, 1e-12);
    const double degrees = 180.0 / std::acos(-1.0);
    EXPECT_NEAR(analysis["covariance"][0][3].get<double>(), 1e3 * degrees * result.covariance(0, 3), 1e-12);
    EXPECT_NEAR(analysis["covariance"][3][3].get<double>(), degrees * degrees * result.covariance(3, 3),
                1e-12);
}

TEST(ResultsJson, CorrelationsOfInputsAreThereWhereThereAreSome) {
    UncertaintyResult result = test::sample_result();
    EXPECT_FALSE(Json::parse(text_of(result))["analyses"][0].contains("inputCorrelations"));
    InputSet inputs = result.inputs;
    inputs.correlations = {{0, 4, -0.36}};
    result.inputs = inputs;
    const Json pairs = Json::parse(text_of(result))["analyses"][0]["inputCorrelations"];
    EXPECT_EQ(pairs.dump(), "[{\"component\":\"b_1x.typed\",\"with\":\"b_2y.typed\",\"coefficient\":-0.36}]");
}

TEST(ResultsJson, InfinityIsNullAndTheSeedIsText) {
    const Json analysis = Json::parse(text_of(test::sample_result()))["analyses"][0];
    EXPECT_TRUE(analysis["outputs"][0]["firstOrder"]["effectiveDegreesOfFreedom"].is_null());
    EXPECT_EQ(analysis["seed"], "18446744073709551615");
    EXPECT_EQ(analysis["outputs"][0]["firstOrder"]["validated"], true);
}

// kurtosis is that of JCGM and of statistics books, 3 for a normal distribution.
TEST(ResultsJson, KurtosisAndExcessDifferByThree) {
    const UncertaintyResult result = test::sample_result();
    const Json x = Json::parse(text_of(result))["analyses"][0]["outputs"][0];
    EXPECT_NEAR(x["excessKurtosis"].get<double>(), result.outputs[0].monte_carlo->kurtosis, 1e-15);
    EXPECT_NEAR(x["kurtosis"].get<double>(), 3.0 + result.outputs[0].monte_carlo->kurtosis, 1e-15);
    EXPECT_EQ(x["expandedUncertaintyBy"], "half-interval");
    EXPECT_NEAR(x["firstOrder"]["estimate"].get<double>(), 1e3 * result.outputs[0].first_order.estimate,
                1e-9);
}

TEST(ResultsJson, ToleranceIsHeldAgainstTheUncertainty) {
    const UncertaintyResult result = test::sample_result();
    const OutputResult& x = result.outputs[0];
    Project project = test::sample_project();
    Requirement& requirement = project.analyses[0].requirements[0];
    const double middle = 1e3 * x.estimate;
    requirement.lower_limit = Quantity{middle - 5.0, Unit::of("mm")};
    requirement.upper_limit = Quantity{middle + 5.0, Unit::of("mm")};
    const Json json = Json::parse(results_json(project, {test::sample_analysis(result)}));
    const Json& stated = json["analyses"][0]["requirements"][0];
    EXPECT_NEAR(stated["capabilityIndex"].get<double>(), 10.0 / (4e3 * x.standard_uncertainty), 1e-9);
    EXPECT_NEAR(stated["testUncertaintyRatio"].get<double>(), 5.0 / (1e3 * x.expanded_uncertainty), 1e-9);
    EXPECT_FALSE(json["analyses"][0]["requirements"][1].contains("capabilityIndex"));
}

TEST(ResultsJson, AConstantHasNoShape) {
    UncertaintyResult result = test::sample_result();
    result.outputs[0].monte_carlo->standard_uncertainty = 0.0;
    const Json output = Json::parse(text_of(result))["analyses"][0]["outputs"][0];
    for (const char* key : {"skewness", "kurtosis", "excessKurtosis"})
        EXPECT_TRUE(output[key].is_null()) << key;
}

TEST(ResultsJson, SecondOrderTermsStandWhereTheyWereAskedFor) {
    UncertaintyResult result = test::sample_result();
    EXPECT_FALSE(
        Json::parse(text_of(result))["analyses"][0]["outputs"][0]["firstOrder"].contains("secondOrder"));
    result.outputs[0].first_order.second_order_standard_uncertainty = 0.0004;
    result.outputs[0].first_order.second_order_estimate_shift = -0.00002;
    const Json second =
        Json::parse(text_of(result))["analyses"][0]["outputs"][0]["firstOrder"]["secondOrder"];
    EXPECT_NEAR(second["standardUncertainty"].get<double>(), 0.4, 1e-12);
    EXPECT_NEAR(second["estimateShift"].get<double>(), -0.02, 1e-12);
}

TEST(ResultsJson, WithoutMonteCarloTheIntervalIsFirstOrder) {
    const Json output =
        Json::parse(text_of(test::sample_result({1, 1, 1, false, "pose"})))["analyses"][0]["outputs"][0];
    EXPECT_EQ(output["interval"]["kind"], "first-order");
    EXPECT_TRUE(output["mean"].is_null());
    EXPECT_TRUE(output["shortestInterval"].is_null());
    EXPECT_TRUE(output["firstOrder"]["validated"].is_null());
    const double middle =
        0.5 * (output["interval"]["low"].get<double>() + output["interval"]["high"].get<double>());
    EXPECT_NEAR(middle, output["estimate"].get<double>(), 1e-9);
}

TEST(ResultsJson, LinesAreReadableAndNumbersShortest) {
    const std::string text = text_of(test::sample_result());
    EXPECT_NE(text.find("\"interval\": {\"kind\": \"symmetric\", \"probability\": 0.95, "),
              std::string::npos);
    EXPECT_EQ(text.back(), '\n');
    EXPECT_EQ(text, text_of(test::sample_result()));
    std::size_t covariance_lines = 0;
    for (std::size_t at = text.find("\"covariance\"");
         (at = text.find("\n        [", at)) != std::string::npos; ++at)
        ++covariance_lines;
    EXPECT_EQ(covariance_lines, 78U);
}

}  // namespace
}  // namespace covaria::results_json_test
