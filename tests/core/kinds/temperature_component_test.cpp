// A temperature keeps its estimate when its components are edited, in whatever unit.
#include <gtest/gtest.h>

#include "core/project/component_edit.h"
#include "tests/core/made.h"

namespace covaria::temperature_component_test {
namespace {

constexpr const char* expansion = R"json({"format": "covaria", "schemaVersion": 1, "title": "", "assets": [],
 "analyses": [{"id": "a", "model": "measurement-equation", "setup": {
  "equations": ["y = alpha*(t - 20 [degC])"],
  "quantities": {
   "columns": ["symbol", "value", "unit", "statement", "a"],
   "rows": [["α", 1.15e-5, "1/K", "standard", 1e-6], ["t", 20.5, "degC", "standard", 0.1]]}}}]})json";

std::shared_ptr<const PreparedAnalysis> prepared(const Project& project) {
    Problems problems;
    auto analysis = made_analysis(project, "a", problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    return analysis;
}

// The edit is the window's: the model's components are copied into the project, changed and added to.
TEST(TemperatureComponent, AComponentOfATemperatureLeavesItsEstimate) {
    const LoadedProject loaded = parse_project(expansion, {}, "expansion");
    for (const Problem& p : loaded.problems.items()) FAIL() << p.path << ": " << p.message.english();
    const auto plain = prepared(loaded.project);
    ASSERT_TRUE(plain);
    const std::size_t t = plain->inputs.find("t");
    ASSERT_NE(t, InputSet::npos);
    ASSERT_NE(plain->inputs.find("alpha"), InputSet::npos) << "typed as a Greek letter";
    EXPECT_NEAR(estimate_of(plain->inputs, t), 293.65, 1e-12);
    for (const char* unit : {"K", "mK", "degC"}) {
        Project project = loaded.project;
        InputEdit edit{.symbol = "t"};
        edit.components.emplace();
        for (const Share& share : plain->inputs.quantities[t].shares)
            edit.components->push_back(
                in_unit(to_edit(plain->inputs.components[share.component]), Unit::of(unit)));
        ComponentEdit added{.name = "drift", .distribution = "", .parameters = {}, .unit = Unit::of(unit)};
        set_distribution(added, Distribution::normal(0.0));
        edit.components->push_back(added);
        project.analyses[0].inputs = {edit};
        const auto edited = prepared(project);
        ASSERT_TRUE(edited);
        EXPECT_NEAR(estimate_of(edited->inputs, t), 293.65, 1e-12) << unit;
        EXPECT_NEAR(standard_uncertainty_of(edited->inputs, t), 0.1, 1e-13) << unit;
    }
}

}  // namespace
}  // namespace covaria::temperature_component_test
