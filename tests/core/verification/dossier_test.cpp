// The dossier: scope of every model, evidence for every clause, and rules that can fail.
#include "core/verification/dossier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/made/load_project.h"
#include "tests/core/made.h"

namespace covaria::dossier_test {
namespace {

const std::vector<VerificationCase>& shipped() {
    static const auto cases = shipped_verification();
    EXPECT_TRUE(cases) << cases.error().message.english();
    return *cases;
}

const VerificationCase& case_of(const std::string& title) {
    for (const VerificationCase& one : shipped())
        if (one.title == title) return one;
    ADD_FAILURE() << title;
    return shipped().front();
}

CheckedCase checked(const VerificationCase& verification) {
    const LoadedProject loaded = load_project(data_directory() / verification.project);
    std::vector<EvaluatedAnalysis> evaluated;
    for (const AnalysisEntry& entry : loaded.project.analyses) {
        if (entry.id != verification.checks.front().analysis) continue;
        Problems problems;
        const auto prepared = made_analysis(loaded.project, entry.id, problems);
        auto result = run_analysis(*prepared);
        EXPECT_TRUE(result);
        evaluated.push_back(
            {prepared, std::make_shared<const UncertaintyResult>(std::move(*result)), {}, {}});
    }
    auto found = check_case(verification, evaluated);
    EXPECT_TRUE(found) << found.error().message.english();
    return found.value_or(CheckedCase{});
}

TEST(Dossier, EveryModelSaysWhatItCoversAndWhatNot) {
    for (const ModelDescriptor& model : model_registry()) {
        const auto scope = model_scope(model.id);
        ASSERT_TRUE(scope) << model.id << ": " << scope.error().message.english();
        EXPECT_GE(scope->covered.size(), 2u) << model.id;
        EXPECT_GE(scope->not_covered.size(), 3u) << model.id;
    }
    EXPECT_FALSE(model_scope("no-such-model"));
}

// A clause without a figure is a gap in the matrix, a clause of a case that is not in it is lost.
TEST(Dossier, EveryClauseHasACaseAndEveryCaseNamesClausesOfTheMatrix) {
    const auto clauses = evaluation_clauses();
    ASSERT_TRUE(clauses) << clauses.error().message.english();
    std::set<std::string> listed, named;
    for (const EvaluationClause& clause : *clauses) EXPECT_TRUE(listed.insert(clause.clause).second);
    for (const VerificationCase& one : shipped()) {
        named.insert(one.source);
        named.insert(one.clauses.begin(), one.clauses.end());
        for (const std::string& clause : one.clauses) EXPECT_TRUE(listed.contains(clause)) << clause;
    }
    for (const std::string& clause : listed) EXPECT_TRUE(named.contains(clause)) << clause;
}

TEST(Dossier, ClausesThatNaiveProgramsGetWrongHaveNegativeCases) {
    std::vector<CheckedCase> all;
    for (const VerificationCase& one : shipped()) {
        CheckedCase made{one, {}};
        for (const VerificationCheck& check : one.checks) made.figures.push_back({check});
        all.push_back(std::move(made));
    }
    const auto evidence = evidence_of(*evaluation_clauses(), all);
    for (const char* clause : {"JCGM 100:2008, G.4.1", "JCGM 100:2008, F.2.2.1", "JCGM 101:2008, 6.4.9",
                               "JCGM 100:2008, 5.1.2 note", "JCGM 101:2008, 9.3", "JCGM 100:2008, G.6.4",
                               "JCGM 101:2008, 6.4.10", "JCGM 100:2008, 5.2.2", "JCGM 102:2011, 6.5",
                               "JCGM 106:2012, 7", "JCGM 106:2012, 8", "JCGM 106:2012, 9.5"}) {
        const auto found = std::find_if(evidence.begin(), evidence.end(),
                                        [&](const ClauseEvidence& e) { return e.of.clause == clause; });
        ASSERT_NE(found, evidence.end()) << clause;
        EXPECT_GT(found->negative, 0u) << clause;
    }
}

TEST(Dossier, TheToleranceIsTenConditionsOfTheLastBit) {
    const CheckedCase found = checked(case_of("Ring of 5 height differences, held"));
    EXPECT_TRUE(found.passed());
    for (const CheckedFigure& figure : found.figures) {
        const VerificationCheck& check = figure.check;
        ASSERT_GE(check.condition, 1.0) << check.what;
        if (check.reference && !std::isfinite(*check.reference)) continue;
        const double scale = check.scale > 0.0 ? check.scale : std::abs(*check.reference);
        EXPECT_DOUBLE_EQ(figure.tolerance,
                         10.0 * check.condition * std::numeric_limits<double>::epsilon() * scale);
        EXPECT_EQ(pass_rule(figure), "10κε");
        EXPECT_EQ(figure.model, "network-adjustment");
    }
}

TEST(Dossier, AFigureThatMissesItsReferenceByTwentyConditionsFails) {
    VerificationCase ring = case_of("Ring of 5 height differences, held");
    VerificationCheck& u = ring.checks.at(1);
    ASSERT_EQ(u.figure, "u");
    *u.reference *= 1.0 + 20.0 * u.condition * std::numeric_limits<double>::epsilon();
    EXPECT_FALSE(checked(ring).passed());
}

// Where the naive figure were ours, the case fails.
TEST(Dossier, AFigureThatIsTheNaiveOneFails) {
    VerificationCase resistors = case_of("Ten resistors in series, calibrated by one standard");
    EXPECT_TRUE(checked(resistors).passed());
    bool changed = false;
    for (VerificationCheck& check : resistors.checks)
        if (check.naive) {
            check.naive->value = 1.0;
            changed = true;
        }
    ASSERT_TRUE(changed);
    const CheckedCase found = checked(resistors);
    EXPECT_FALSE(found.passed());
    EXPECT_NE(
        verification_text({found}).find("FAILS: is the figure of an evaluation that adds the variances"),
        std::string::npos);
}

TEST(Dossier, DocumentHasAPageForEveryModelTheMatrixAndTheCases) {
    const std::vector<CheckedCase> cases{
        checked(case_of("Ten resistors in series, calibrated by one standard"))};
    const auto document = dossier_document(cases, {{"Program", "Covaria"}});
    ASSERT_TRUE(document) << document.error().message.english();
    std::set<std::string> pages, tables;
    for (const ReportBlock& block : document->blocks) {
        if (const auto* heading = std::get_if<HeadingBlock>(&block); heading && heading->begins_page)
            pages.insert(heading->anchor);
        if (const auto* table = std::get_if<TableBlock>(&block)) tables.insert(table->table.id);
    }
    for (const ModelDescriptor& model : model_registry())
        EXPECT_TRUE(pages.contains("dossier-" + model.id)) << model.id;
    EXPECT_TRUE(tables.contains("clauses"));
    EXPECT_EQ(tables.size(), 2u);
    const auto json = dossier_json(cases, {{"Program", "Covaria"}});
    ASSERT_TRUE(json);
    EXPECT_NE(json->find("\"format\": \"covaria-dossier\""), std::string::npos);
    EXPECT_NE(json->find("\"notCovered\""), std::string::npos);
}

TEST(Dossier, ACaseThatCannotBeEvaluatedIsNotPassed) {
    const CheckedCase one{shipped().front(), {}, "the file is gone"};
    EXPECT_FALSE(one.passed());
    EXPECT_NE(verification_text({one}).find("FAILS: the file is gone"), std::string::npos);
}

}  // namespace
}  // namespace covaria::dossier_test
