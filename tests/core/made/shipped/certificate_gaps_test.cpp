// Gaps of a certificate beside its texts: names of results, the specification of a tolerance, the coverage
// probability of an accreditation.
#include "core/made/certificate_gaps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/made/load_project.h"

namespace covaria::certificate_gaps_test {
namespace {

/// Two results, of which `names` says the names.
Project project_of(const std::string& rows_of_results) {
    const LoadedProject loaded = parse_project(
        R"({"format": "covaria", "schemaVersion": )" + std::to_string(project_schema_version) +
            R"(, "title": "t", "analyses": [{"id": "a", "name": "Bar", "model": "measurement-equation",
            "setup": {"equations": ["L_1 = x", "L_2 = 2*x"],
            "outputs": {"columns": ["symbol", "name", "unit"], "rows": [)" +
            rows_of_results + R"(]},
            "quantities": {"columns": ["symbol", "value", "unit", "statement", "a"],
                           "rows": [["x", 10, "mm", "standard", 1]]}}}]})",
        ".", "t");
    for (const Problem& problem : loaded.problems.items())
        ADD_FAILURE() << problem.path << ": " << problem.message.english();
    return loaded.project;
}

std::vector<CertificateGap> gaps_of(const Project& project) {
    return certificate_gaps(*MadeProject::make(project), certified_ids(project));
}

std::string list(const std::vector<CertificateGap>& gaps) {
    std::string all;
    for (const CertificateGap& gap : gaps)
        if (!gap.path.starts_with("/certificate/"))
            all += gap.path + ": " + gap.what.english() + " (" + gap.clause + ")\n";
    return all;
}

TEST(CertificateGaps, AResultThatIsCalledByItsSymbolAloneIsOne) {
    const auto gaps_with = [](const char* rows) { return list(gaps_of(project_of(rows))); };
    EXPECT_EQ(gaps_with(R"(["L_1", "length", "mm"], ["L_2", "twice", "mm"])"), "");
    EXPECT_EQ(gaps_with(R"(["L_1", "length", "mm"], ["L_2", null, "mm"])"),
              "/analyses/0/setup: the name of the result L₂ of 'Bar' (7.8.2.1 m)\n");
    EXPECT_EQ(gaps_with(R"(["L_1", null, "mm"], ["L_2", "L_2", "mm"])"),
              "/analyses/0/setup: the names of the results L₁, L₂ of 'Bar' (7.8.2.1 m)\n");
    Project left_out = project_of(R"(["L_1", null, "mm"])");
    left_out.report.without_analyses = {"a"};
    EXPECT_EQ(list(gaps_of(left_out)), "") << "the certificate does not state it";
}

TEST(CertificateGaps, ProblemsAndGapsAreTheSame) {
    Project project = project_of(R"(["L_1", null, "mm"])");
    for (const bool limited : {false, true}) {
        if (limited) project.analyses[0].requirements = {{"", "L_1", {}, {}, Quantity{11.0, Unit::of("mm")}}};
        const auto made = MadeProject::make(project);
        const auto gaps = certificate_gaps(*made, {"a"});
        const Problems missing = missing_in(*made, {"a"});
        ASSERT_EQ(gaps.size(), missing.items().size());
        bool specification = false;
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            EXPECT_EQ(gaps[i].path, missing.items()[i].path);
            specification = specification || gaps[i].path == "/certificate/specification";
        }
        EXPECT_EQ(certificate_gaps(*made, {}).size(), gaps.size() - (limited ? 2 : 1)) << "nothing is stated";
        EXPECT_EQ(specification, limited) << "conformity is stated where there is a limit";
    }
}

TEST(AccreditedProbability, IsAbout95PerCentOrWarnedOf) {
    for (const bool accredited : {false, true})
        for (const bool fixed : {false, true})
            for (int i = 1; i < 400; ++i) {
                const double k = 0.01 * i, p = std::erf(k / std::sqrt(2.0));
                Project project;
                project.certificate.accreditation = accredited ? "D-K-1" : " ";
                project.analyses = {{.id = "a", .model = "m", .name = "A"}};
                EvaluationOptions& options = project.analyses[0].options;
                options.coverage_probability = fixed ? 0.5 : p;
                if (fixed) options.coverage_factor = k;
                Problems problems;
                check_accredited_probability(project, problems);
                const bool about = p >= 0.94 && p <= 0.96;
                ASSERT_EQ(problems.items().size(), accredited && !about ? 1u : 0u) << "k = " << k;
                if (problems.empty()) continue;
                EXPECT_EQ(problems.items()[0].path, fixed ? "/analyses/0/options/coverageFactor"
                                                          : "/analyses/0/options/coverageProbability");
                EXPECT_EQ(problems.items()[0].severity, Severity::warning);
                EXPECT_NE(problems.items()[0].message.english().find("ILAC-P14"), std::string::npos);
            }
}

}  // namespace
}  // namespace covaria::certificate_gaps_test
