// The project's statements for all its results: units and digits change no number, k does where an analysis
// states none.
#include "core/project/project_results.h"
#include "core/document/document_writers.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "core/result_files/results_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/made/load_project.h"
#include "core/made/made_project.h"
#include "core/project/project_file.h"
#include "core/report/report.h"

namespace covaria::test::project_results_test {
namespace {

Project shipped() {
    Project project = load_project(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria").project;
    for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
    return project;
}

std::shared_ptr<const UncertaintyResult> evaluated(const Project& project, std::size_t analysis = 0) {
    const auto made = MadeProject::make(project);
    const auto prepared = made->analysis(project.analyses[analysis].id);
    EXPECT_NE(prepared, nullptr);
    return std::make_shared<const UncertaintyResult>(*run_analysis(*prepared));
}

TEST(ProjectResults, ComeBackFromTheFile) {
    Project project = shipped();
    const std::string plain = project_text(project);
    EXPECT_EQ(plain.find("\"results\""), std::string::npos) << "nothing is stated";
    project.author = "A. Author";
    project.number = "2026-17";
    project.results.style.units.choose(Unit::of("thou"));
    project.results.style.units.choose(Unit::of("arcsec"));
    project.results.style.digits = 1;
    project.results.coverage_factor = 2.0;
    const std::string text = project_text(project);
    EXPECT_NE(text.find("\"units\": [\"thou\", \"arcsec\"]"), std::string::npos) << text.substr(0, 600);
    const ReadProject read = read_project(text, project.directory, "p");
    EXPECT_TRUE(read.problems.empty());
    EXPECT_EQ(read.project, project);
    EXPECT_EQ(project_text(read.project), text);
}

TEST(ProjectResults, WhatIsSenselessIsRefusedWithItsPlace) {
    const std::string text = project_text(shipped());
    const auto refused = [&](const std::string& section, const std::string& path) {
        std::string with = text;
        with.insert(with.find("  \"assets\""), "  \"results\": " + section + ",\n");
        const ReadProject read = read_project(with, {}, "p");
        const auto& found = read.problems.items();
        return std::count_if(found.begin(), found.end(), [&](const Problem& problem) {
                   return problem.path == path && problem.severity == Severity::error;
               }) == 1;
    };
    EXPECT_TRUE(refused("{\"units\": [\"mm\", \"um\"]}", "/results/units/1"));
    EXPECT_TRUE(refused("{\"units\": [\"furlong\"]}", "/results/units/0"));
    EXPECT_TRUE(refused("{\"units\": [\"%\"]}", "/results/units/0"));
    EXPECT_TRUE(refused("{\"units\": [7]}", "/results/units/0"));
    EXPECT_TRUE(refused("{\"digits\": 0}", "/results/digits"));
    EXPECT_TRUE(refused("{\"digits\": 1.5}", "/results/digits"));
    EXPECT_TRUE(refused("{\"digits\": 7}", "/results/digits"));
    EXPECT_FALSE(refused("{\"digits\": 3}", "/results/digits"));
    EXPECT_TRUE(refused("{\"coverageFactor\": -2}", "/results/coverageFactor"));
    EXPECT_TRUE(refused("{\"colour\": \"red\"}", "/results/colour"));
}

TEST(ProjectResults, UnitsAndDigitsChangeNoNumberAndNoFingerprint) {
    Project project = shipped();
    const auto before = evaluated(project);
    const std::string print = fingerprint(project);
    project.results.style.units.choose(Unit::of("thou"));
    project.results.style.digits = 1;
    project.author = "A";
    project.certificate.issued = "2026-04-20";
    EXPECT_EQ(fingerprint(project), print);
    const auto after = evaluated(project);
    ASSERT_EQ(after->outputs.size(), before->outputs.size());
    EXPECT_EQ(after->provenance.project_fingerprint, before->provenance.project_fingerprint);
    for (std::size_t i = 0; i < before->outputs.size(); ++i) {
        EXPECT_EQ(after->outputs[i].estimate, before->outputs[i].estimate);
        EXPECT_EQ(after->outputs[i].expanded_uncertainty, before->outputs[i].expanded_uncertainty);
    }
    EXPECT_EQ(after->outputs[0].quantity.unit, Unit::of("thou"));
    const auto made = MadeProject::make(project);
    const EvaluatedAnalysis shown{made->analysis(project.analyses[0].id), after};
    const std::string csv = to_csv(result_tables(project, shown).front());
    EXPECT_NE(csv.find("thou"), std::string::npos) << csv;
    const std::string report = to_markdown(build_report(*made, {shown}));
    EXPECT_NE(report.find("| thou "), std::string::npos) << report.substr(0, 3000);
    EXPECT_NE(report.find("| Author | A |"), std::string::npos) << report.substr(0, 600);
    EXPECT_NE(report.find("| Date of issue | 20 April 2026 |"), std::string::npos) << report.substr(0, 600);
}

TEST(ProjectResults, TheFactorIsThatOfAnalysesThatStateNone) {
    Project project = shipped();
    const auto from_nu = evaluated(project);
    const std::string print = fingerprint(project);
    project.results.coverage_factor = 3.0;
    EXPECT_NE(fingerprint(project), print) << "a number depends on it";
    const auto stated = evaluated(project);
    EXPECT_EQ(stated->outputs[0].coverage_factor, 3.0);
    const auto made = MadeProject::make(project);
    const std::string report =
        to_markdown(build_report(*made, {{made->analysis(project.analyses[0].id), stated}}));
    EXPECT_NE(report.find("k = 3.00, p = 99.18\u00a0%"), std::string::npos)
        << "not the 99 % that were asked for: Student's t, 16.66 degrees of freedom";
    EXPECT_NE(stated->provenance.project_fingerprint, from_nu->provenance.project_fingerprint);
    project.analyses[0].options.coverage_factor = 2.0;
    EXPECT_EQ(evaluated(project)->outputs[0].coverage_factor, 2.0) << "its own counts";
    const std::string own = evaluated(project)->provenance.project_fingerprint;
    project.results.coverage_factor.reset();
    EXPECT_EQ(evaluated(project)->provenance.project_fingerprint, own) << "that of the project did not count";
}

TEST(ProjectResults, AnEditOfThemMakesAnewWhatDependsOnThem) {
    Project project = shipped();
    const auto before = MadeProject::make(project);
    const std::string id = project.analyses[0].id;
    project.results.coverage_factor = 3.0;
    const auto with_factor = MadeProject::make(project, before);
    EXPECT_EQ(with_factor->analysis(id)->options.coverage_factor, 3.0);
    EXPECT_FALSE(same_numbers(*before->analysis(id), *with_factor->analysis(id)));
    project.results.style.digits = 1;
    const auto with_digits = MadeProject::make(project, with_factor);
    EXPECT_EQ(with_digits->analysis(id)->style.digits, 1);
    EXPECT_TRUE(same_numbers(*with_factor->analysis(id), *with_digits->analysis(id)));
}

TEST(ProjectResults, TheReportHasAsManyDigitsAsTheyState) {
    Project project = shipped();
    project.results.style.digits = 4;
    project.results.style.units.choose(Unit::of("um"));
    const auto made = MadeProject::make(project);
    const auto analysis = made->analysis(project.analyses[0].id);
    const auto result = evaluated(project);
    const std::string report = to_markdown(build_report(*made, {{analysis, result}}));
    const OutputResult& y = result->outputs[0];
    const double U = y.quantity.unit.interval_from_si(y.expanded_uncertainty);
    for (const std::string& text :
         {format_significant(U, 4), format_to_match(y.quantity.unit.from_si(y.estimate), U, 4)})
        EXPECT_NE(report.find("| " + text + " |"), std::string::npos) << text;
}

/// The files state enough of the inputs to recompute u_c: JCGM 100 H.2, with observations made
/// together.
TEST(ProjectResults, TheFilesHaveTheCorrelationsOfTheInputs) {
    Project project = load_project(COVARIA_SOURCE_DIR "/projects/gum/h2-impedance.covaria").project;
    project.analyses[0].options.method = Method::first_order;
    const auto made = MadeProject::make(project);
    const auto result = evaluated(project);
    const EvaluatedAnalysis shown{made->analysis(project.analyses[0].id), result};
    std::map<std::string, Table> tables;
    for (Table& table : result_tables(project, shown)) tables[table.id] = table;
    const auto column = [&](const char* table, const char* head) {
        std::vector<Cell> cells;
        for (std::size_t row = 0; row < tables[table].rows; ++row)
            cells.push_back(tables[table].cell(row, head));
        return cells;
    };
    const auto number = [](const Cell& cell) { return exact_quantity(cell).value().value; };
    const auto output = column("budget", "output"), id = column("budget", "id");
    const auto sensitivity = column("budget", "sensitivity"), u = column("budget", "u");
    const auto first = column("input-correlations", "id");
    const auto second = column("input-correlations", "other id");
    const auto r = column("input-correlations", "r");
    EXPECT_EQ(r.size(), 3U) << "V, I and phi";
    for (const OutputResult& of : result->outputs) {
        std::map<std::string, double> signed_contributions;
        for (std::size_t row = 0; row < id.size(); ++row)
            if (std::get<Symbols>(output[row]) == Symbols{of.quantity.symbol})
                signed_contributions[std::get<std::string>(id[row])] =
                    number(sensitivity[row]) * number(u[row]);
        double variance = 0.0;
        for (const auto& [component, contribution] : signed_contributions)
            variance += contribution * contribution;
        for (std::size_t pair = 0; pair < r.size(); ++pair)
            variance += 2.0 * number(r[pair]) * signed_contributions[std::get<std::string>(first[pair])] *
                        signed_contributions[std::get<std::string>(second[pair])];
        const double stated = of.quantity.unit.interval_from_si(of.first_order.standard_uncertainty);
        EXPECT_NEAR(std::sqrt(variance), stated, 1e-12 * stated) << of.quantity.symbol;
    }
    EXPECT_NE(results_json(project, {shown}).find("\"with\": \"phi.1\""), std::string::npos);
}

TEST(ProjectResults, CombinedUncertaintyIsWrittenAsTheResultBesideIt) {
    Project project = shipped();
    project.results.style.units.choose(Unit::of("mm"));
    const auto made = MadeProject::make(project);
    const EvaluatedAnalysis shown{made->analysis(project.analyses[0].id), evaluated(project)};
    const std::string report = to_markdown(build_report(*made, {shown}));
    EXPECT_NE(report.find("= 0.000\u202f032\u00a0mm, effective"), std::string::npos)
        << report.substr(report.find("u\\_c = "), 60);
}

}  // namespace
}  // namespace covaria::test::project_results_test
