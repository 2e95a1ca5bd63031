// Standard deviations that are stated of a distance meter and a theodolite: their residuals see the s that
// the procedures compute.
#include <gtest/gtest.h>

#include "core/base/resource_path.h"
#include "core/evidence/seen.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace covaria::sheet_evidence_test {
namespace {

/// Expects figure k to see the output with this symbol.
void expect_seen(const char* project, const std::vector<std::string>& symbols) {
    const Project loaded = load_project(data_directory() / "projects" / project).project;
    Problems problems;
    const auto prepared = made_analysis(loaded, loaded.analyses.front().id, problems);
    ASSERT_TRUE(prepared && prepared->model);
    const auto readings = prepared->model->redundant_readings();
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->figures.size(), symbols.size());
    const evidence::Seen seen = evidence::see(*readings);
    ASSERT_TRUE(seen.found);
    const UncertaintyResult result = run_analysis(*prepared).value();
    for (std::size_t k = 0; k < symbols.size(); ++k)
        for (const OutputResult& output : result.outputs)
            if (output.quantity.symbol == symbols[k]) {
                const double s = seen.figures[k].factor * readings->figures[k].least;
                EXPECT_NEAR(s, output.first_order.estimate, 1e-6 * s) << symbols[k];
            }
}

TEST(SheetEvidence, ADistanceMeterSeesItsStandardDeviation) {
    expect_seen("distance-meter.covaria", {"s"});
}

TEST(SheetEvidence, ATheodoliteSeesThoseOfDirectionsAndZenithAngles) {
    expect_seen("theodolite.covaria", {"s_Hz", "s_V"});
}

}  // namespace
}  // namespace covaria::sheet_evidence_test
