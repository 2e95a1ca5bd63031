// The best capability of a laboratory: the smallest U of a value by ranges, and how a certificate states a U
// below it.
#include "core/model/best_capability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/document/report_document.h"
#include "core/report/report.h"
#include "core/report/stated_uncertainty.h"
#include "tests/core/made.h"

namespace covaria::best_capability_test {
namespace {

SetupTable ranges(const std::vector<std::vector<double>>& rows) {
    SetupTable table;
    table.units.assign(4, Unit{});
    for (const std::vector<double>& row : rows) table.rows.emplace_back(row.begin(), row.end());
    return table;
}

AssetEntry capability(const SetupTable& table, const std::string& below = "raised",
                      const std::string& symbols = "") {
    AssetEntry entry{"cmc", "best-capability", "Gauge blocks", {}, {}};
    entry.setup.values = {{"unit", std::string("mm")},    {"range_unit", std::string("mm")},
                          {"symbols", symbols},           {"ranges", table},
                          {"parts", std::string("root")}, {"below", below}};
    return entry;
}

/// The gauge block of 50 mm with U = 66 nm, and these capabilities.
class BestCapabilityTest : public testing::Test {
protected:
    void evaluate(std::vector<AssetEntry> capabilities) {
        Project project = load_project(data_directory() / "projects/certificate-gauge-block.covaria").project;
        for (AssetEntry& one : capabilities) project.assets.push_back(std::move(one));
        id_ = project.analyses.front().id;
        made_ = MadeProject::make(std::move(project));
        const Problems problems = made_->problems();
        for (const Problem& problem : problems.items())
            if (problem.severity == Severity::error)
                ADD_FAILURE() << problem.path << ": " << problem.message.english();
        const auto prepared = made_->analysis(id_);
        ASSERT_TRUE(prepared);
        auto result = run_analysis(*prepared);
        ASSERT_TRUE(result);
        evaluated_ = {{prepared, std::make_shared<const UncertaintyResult>(*std::move(result)), {}}};
    }
    double evaluated_U() const { return evaluated_.front().result->outputs.front().expanded_uncertainty; }
    std::vector<CapabilityFinding> findings() const {
        return capability_findings(*made_, *evaluated_.front().result);
    }
    std::string certificate() const {
        std::string text;
        for (const auto& block : build_certificate(*made_, evaluated_).blocks) {
            if (const auto* paragraph = std::get_if<ParagraphBlock>(&block)) text += paragraph->text + "\n";
            if (const auto* facts = std::get_if<FactsBlock>(&block))
                for (const auto& [name, words] : facts->facts) text += name + ": " + words + "\n";
        }
        return text;
    }

    bool states_conformity() const {
        const auto blocks = build_certificate(*made_, evaluated_).blocks;
        return std::ranges::any_of(blocks, [](const ReportBlock& block) {
            const auto* table = std::get_if<TableBlock>(&block);
            return table && table->table.id.starts_with("conformity");
        });
    }

    std::string id_;
    MadeProject::Pointer made_;
    std::vector<EvaluatedAnalysis> evaluated_;
};

TEST_F(BestCapabilityTest, ProjectsWithoutOneStateWhatTheyEvaluate) {
    evaluate({});
    EXPECT_TRUE(findings().empty());
    EXPECT_EQ(as_stated(*made_, evaluated_).front().result, evaluated_.front().result);
}

TEST_F(BestCapabilityTest, ASmallerUIsRaisedToItInTheCertificateAlone) {
    // Q[80 nm; 1e-6 L] of 50 mm is 94.34 nm.
    evaluate({capability(ranges({{0.0, 100.0, 80e-6, 1e-6}}))});
    const double U = evaluated_U(), least = std::hypot(80e-9, 50e-9);
    ASSERT_LT(U, 70e-9);
    ASSERT_EQ(findings().size(), 1U);
    EXPECT_EQ(findings()[0].verdict, CapabilityVerdict::raised);
    EXPECT_NEAR(findings()[0].smallest, least, 1e-6 * least);
    EXPECT_EQ(evaluated_U(), U);
    EXPECT_TRUE(states_conformity());
    EXPECT_NEAR(as_stated(*made_, evaluated_).front().result->outputs.front().expanded_uncertainty, least,
                1e-6 * least);
    EXPECT_NE(certificate().find("094)\u00a0mm, k = 2.00"), std::string::npos) << certificate();
    EXPECT_NE(certificate().find("best measurement capability of the laboratory"), std::string::npos)
        << certificate();
    EXPECT_EQ(as_stated(*made_, evaluated_).front().result->outputs.front().coverage_factor, 2.0);
}

TEST_F(BestCapabilityTest, ALargerUStays) {
    evaluate({capability(ranges({{0.0, 100.0, 30e-6, 0.5e-6}}))});  // 39 nm
    EXPECT_TRUE(findings().empty());
    EXPECT_EQ(certificate().find("capability"), std::string::npos) << certificate();
}

TEST_F(BestCapabilityTest, ASmallerUMayBeRefused) {
    evaluate({capability(ranges({{0.0, 100.0, 80e-6, 0.0}}), "refused")});
    ASSERT_EQ(findings().size(), 1U);
    EXPECT_EQ(findings()[0].verdict, CapabilityVerdict::refused);
    EXPECT_NE(certificate().find("is not stated"), std::string::npos) << certificate();
    EXPECT_FALSE(states_conformity());
    EXPECT_EQ(as_stated(*made_, evaluated_).front().result->outputs.front().quantity.role,
              OutputRole::intermediate);
}

// Nobody knows what a capability with errors allows: it does not count as none.
TEST_F(BestCapabilityTest, WithErrorsNothingMayBeStated) {
    evaluate({});
    Project project = made_->project();
    project.assets.push_back(capability(ranges({{30.0, 20.0, 80e-6, 0.0}})));
    made_ = MadeProject::make(std::move(project));
    ASSERT_EQ(findings().size(), 1U);
    EXPECT_EQ(findings()[0].verdict, CapabilityVerdict::refused);
    EXPECT_NE(findings()[0].words.english().find("Gauge blocks has errors"), std::string::npos);
}

TEST_F(BestCapabilityTest, TheFirstRangeThatHasTheValueCountsAndItsEndsBelongToIt) {
    evaluate(
        {capability(ranges({{0.0, 20.0, 500e-6, 0.0}, {20.0, 50.1, 90e-6, 0.0}, {0.0, 500.0, 1.0, 0.0}}))});
    ASSERT_EQ(findings().size(), 1U);
    EXPECT_NEAR(findings()[0].smallest, 90e-9, 1e-15);
    const auto* asset = offers<BestCapability>(made_->assets().find("cmc")->asset);
    ASSERT_NE(asset, nullptr);
    EXPECT_NEAR(*asset->smallest(20e-3), 500e-9, 1e-15);
    EXPECT_NEAR(*asset->smallest(0.0), 500e-9, 1e-15);
    EXPECT_FALSE(asset->smallest(0.6));
    EXPECT_FALSE(asset->smallest(-1e-9));
}

TEST_F(BestCapabilityTest, AResultInNoRangeIsOutsideTheScope) {
    evaluate({capability(ranges({{0.0, 25.0, 80e-6, 0.0}}))});
    ASSERT_EQ(findings().size(), 1U);
    EXPECT_EQ(findings()[0].verdict, CapabilityVerdict::outside);
    evaluate({capability(ranges({{0.0, 100.0, 80e-6, 0.0}}), "raised", "d e")});
    ASSERT_EQ(findings().size(), 1U) << "it is for other symbols";
    EXPECT_EQ(findings()[0].verdict, CapabilityVerdict::outside);
    AssetEntry other = capability(ranges({{0.0, 100.0, 80e-6, 0.0}}));
    other.setup.values["unit"] = std::string("kg");
    other.setup.values["range_unit"] = std::string("kg");
    evaluate({other});
    ASSERT_EQ(findings().size(), 1U) << "it is for masses";
    EXPECT_EQ(findings()[0].verdict, CapabilityVerdict::outside);
}

// The value that decides may be another one than the result: the nominal length of a deviation.
TEST_F(BestCapabilityTest, AnotherQuantityMayDecide) {
    AssetEntry by_length = capability(ranges({{10.0, 100.0, 80e-6, 0.0}}));
    by_length.setup.values["over"] = std::string("l_S");
    evaluate({by_length});
    ASSERT_EQ(findings().size(), 1U);
    EXPECT_EQ(findings()[0].verdict, CapabilityVerdict::raised);
    by_length.setup.values["over"] = std::string("nothing");
    evaluate({by_length});
    EXPECT_EQ(findings().at(0).verdict, CapabilityVerdict::outside);
}

TEST_F(BestCapabilityTest, RangesThatAreNoneAreRefused) {
    const auto first_problem = [](const SetupTable& table) {
        Project project;
        project.assets.push_back(capability(table));
        const Problems problems = MadeProject::make(std::move(project))->problems();
        return problems.items().empty() ? std::string() : problems.items().front().path;
    };
    EXPECT_EQ(first_problem(ranges({{5.0, 1.0, 1e-6, 0.0}})), "/assets/0/setup/ranges/rows/0/to");
    EXPECT_EQ(first_problem(ranges({{0.0, 1.0, 0.0, 0.0}})), "/assets/0/setup/ranges/rows/0/absolute");
    EXPECT_EQ(first_problem(ranges({{0.0, 1.0, -1e-6, 0.0}})), "/assets/0/setup/ranges/rows/0/absolute");
}

}  // namespace
}  // namespace covaria::best_capability_test
