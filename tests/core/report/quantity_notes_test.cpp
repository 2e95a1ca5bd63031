// Notes on input quantities: in the file and back, in the report, and no number depends on them.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/document/document_writers.h"
#include "core/made/load_project.h"
#include "core/made/made_project.h"
#include "core/project/project_file.h"
#include "core/report/report.h"

namespace covaria::test::quantity_notes_test {
namespace {

Project shipped() {
    Project project = load_project(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria").project;
    for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
    return project;
}

TEST(QuantityNotes, ComeBackFromTheFile) {
    Project project = shipped();
    EXPECT_EQ(project_text(project).find("quantityNotes"), std::string::npos);
    project.analyses[0].quantity_notes = {{"l_S", "Certificate 4711,\nof \"May\""}, {"d", "five readings"}};
    const std::string text = project_text(project);
    const ReadProject read = read_project(text, project.directory, "p");
    EXPECT_TRUE(read.problems.empty());
    EXPECT_EQ(read.project, project);
    EXPECT_EQ(project_text(read.project), text);
}

TEST(QuantityNotes, NoNumberDependsOnThemAndNothingIsMadeAnew) {
    Project project = shipped();
    const auto before = MadeProject::make(project);
    const std::string print = fingerprint(project);
    const std::string id = project.analyses[0].id;
    project.analyses[0].quantity_notes = {{"l_S", "as agreed"}};
    EXPECT_EQ(fingerprint(project), print);
    const auto after = MadeProject::make(project, before);
    EXPECT_EQ(after->analysis(id), before->analysis(id)) << "the same object";
    EXPECT_TRUE(after->problems().empty());
}

TEST(QuantityNotes, StandInTheReportBelowTheInputQuantities) {
    Project project = shipped();
    project.analyses[0].quantity_notes = {{"l_S", "Agreed with the customer."}, {"gone", "of another time"}};
    const auto made = MadeProject::make(project);
    const auto prepared = made->analysis(project.analyses[0].id);
    const auto result = std::make_shared<const UncertaintyResult>(*run_analysis(*prepared));
    const std::string report = to_markdown(build_report(*made, {{prepared, result}}));
    EXPECT_NE(report.find("Agreed with the customer."), std::string::npos);
    EXPECT_LT(report.find("Input quantities and the origin"), report.find("Agreed with the customer."));
    EXPECT_EQ(report.find("of another time"), std::string::npos) << "of a quantity that is not there";
}

}  // namespace
}  // namespace covaria::test::quantity_notes_test
