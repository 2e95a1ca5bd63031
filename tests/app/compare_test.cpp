// covaria compare: a project and what it would be with another value, two projects, two analyses of one.
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace covaria::compare_test {
namespace {

const std::string gauge = shipped_project("gum/h1-end-gauge.covaria").string();
const std::string stewart = shipped_project("stewart-platform.covaria").string();

/// GUM, Table H.1: u_c^2 is 625 (standard) + 94.09 (difference) + 8.41 + 278.06 = 1005.56 nm^2. Twice the
/// u of the difference, 19.4 nm for 9.7 nm, adds 282.27 nm^2, that is 28.1 %.
TEST(Compare, AProjectBesideWhatItWouldBe) {
    const auto folder = fresh_folder("compare");
    const Outcome what_if =
        run_program({"compare", gauge, "--analysis", "table", "--set",
                     "/analyses/table/setup/quantities/rows/d/a=19.4", "--out", folder.string()});
    ASSERT_EQ(what_if.status, 0) << what_if.err;
    EXPECT_NE(what_if.out.find("1 of 1 measurands are in both results"), std::string::npos) << what_if.out;
    EXPECT_NE(what_if.out.find("28.1"), std::string::npos) << what_if.out;
    EXPECT_NE(what_if.out.find("d/a=19.4"), std::string::npos) << "what is after is named";
    EXPECT_EQ(read_text(folder / "comparison.md"), what_if.out);
    const std::string budget = read_text(folder / "table-compared-budget.csv");
    EXPECT_NE(budget.find(",changed,nm,9.7"), std::string::npos) << budget;
    EXPECT_NE(budget.find(",same,"), std::string::npos) << budget;
    EXPECT_NE(read_text(folder / "table-compared-results.csv").find(",both,nm,"), std::string::npos);
}

/// The same in a report: what if, and what the file says.
TEST(Compare, AReportHasTheResultsOfAnotherFileBesideItsOwn) {
    const auto folder = fresh_folder("compare-report");
    const auto to = (folder / "report.md").string();
    const Outcome what_if =
        run_program({"report", gauge, "--analysis", "table", "--set",
                     "/analyses/table/setup/quantities/rows/d/a=19.4", "--before", gauge, "-o", to});
    ASSERT_EQ(what_if.status, 0) << what_if.err;
    const std::string text = read_text(to);
    const std::size_t chapter = text.find("Results before and after");
    ASSERT_NE(chapter, std::string::npos);
    EXPECT_NE(text.find("28.1", chapter), std::string::npos) << text.substr(chapter, 2000);
    EXPECT_NE(text.find(gauge, chapter), std::string::npos) << "what is before is named";
    const Outcome without = run_program(
        {"report", gauge, "--analysis", "table", "--before", gauge, "--without", "before", "-o", to});
    ASSERT_EQ(without.status, 0) << without.err;
    EXPECT_EQ(read_text(to).find("Results before and after"), std::string::npos);
    const Outcome strangers = run_program({"report", gauge, "--before", stewart, "-o", to});
    EXPECT_EQ(strangers.status, 1);
    EXPECT_NE(strangers.err.find("none of the analyses"), std::string::npos) << strangers.err;
    EXPECT_EQ(run_program({"report", gauge, "--before", gauge, "--certificate", "-o", to}).status, 2);
}

TEST(Compare, IsAPdfTooThatCarriesTheProjectOfAfter) {
    const auto file = fresh_folder("compare-pdf") / "comparison.pdf";
    const Outcome made = run_program({"compare", gauge, "--analysis", "table", "--first-order", "--set",
                                      "/analyses/table/setup/quantities/rows/d/a=19.4", "-o", file.string()});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_TRUE(read_text(file).starts_with("%PDF"));
    const Outcome again = run_program({"verify-report", file.string()});
    EXPECT_EQ(again.status, 0) << again.out << again.err;
    EXPECT_EQ(
        run_program({"compare", gauge, "--analysis", "table", "--set", "/title=x", "-o", "a.doc"}).status, 2);
}

TEST(Compare, EqualProjectsDoNotDiffer) {
    const Outcome same = run_program({"compare", gauge, gauge, "--first-order"});
    ASSERT_EQ(same.status, 0) << same.err;
    EXPECT_NE(same.out.find("the budgets of 0 of them differ"), std::string::npos) << same.out;
    EXPECT_EQ(same.out.find("| changed |"), std::string::npos) << same.out;
}

TEST(Compare, TwoAnalysesOfOneProject) {
    const Outcome two =
        run_program({"compare", gauge, "--analysis", "table", "--analysis", "statements", "--first-order"});
    ASSERT_EQ(two.status, 0) << two.err;
    EXPECT_NE(two.out.find("table (before), statements (after)"), std::string::npos) << two.out;
    EXPECT_NE(two.out.find("| comparator, random effects | new |"), std::string::npos) << two.out;
    const Outcome back =
        run_program({"compare", gauge, "--analysis", "statements", "--analysis", "table", "--first-order"});
    ASSERT_EQ(back.status, 0) << back.err;
    EXPECT_NE(back.out.find("| comparator, random effects | gone |"), std::string::npos) << back.out;
}

TEST(Compare, WhatIsMissingIsWrongUsageOrBadInput) {
    const Outcome alone = run_program({"compare", gauge});
    EXPECT_EQ(alone.status, 2);
    EXPECT_NE(alone.err.find("name what to compare with"), std::string::npos) << alone.err;
    EXPECT_EQ(run_program({"compare"}).status, 2);
    EXPECT_EQ(run_program({"compare", gauge, "--analysis", "table", "--analysis", "table"}).status, 2);
    EXPECT_EQ(run_program({"compare", gauge, "/nowhere.covaria"}).status, 1);
    const Outcome strangers = run_program({"compare", gauge, stewart});
    EXPECT_EQ(strangers.status, 1);
    EXPECT_NE(strangers.err.find("no analysis of the same id"), std::string::npos) << strangers.err;
    EXPECT_EQ(run_program({"compare", stewart, stewart, "--analysis", "nothing"}).status, 1);
}

/// The certificate of a gauge block of which the customer's address and one comparison were wrong.
class Amended : public testing::Test {
protected:
    Amended() {
        std::string text = read_text(certificate);
        for (const auto& [from, to] :
             {std::pair("22 Factory Road", "24 Factory Road"), {"-94, \"nm\"", "-49, \"nm\""}}) {
            const std::size_t at = text.find(from);
            EXPECT_NE(at, std::string::npos) << from;
            text.replace(at, std::string(from).size(), to);
        }
        write_text(right, text);
    }
    std::vector<std::string> amend(const std::string& old, const std::string& to) const {
        return {"compare",
                old,
                right.string(),
                "--amend",
                "L-2026-0417-A",
                "--reason",
                "A digit was wrong",
                "--issued",
                "2026-05-04",
                "-o",
                to};
    }
    const std::filesystem::path folder = fresh_folder("amended"), right = folder / "right.covaria";
    const std::string certificate = shipped_project("certificate-gauge-block.covaria").string();
    const std::string space = "\u202f";
};

TEST_F(Amended, StatesWhatItReplacesWhyAndWhatHasChanged) {
    const auto to = folder / "amended.md";
    const Outcome made = run_program(amend(certificate, to.string()));
    ASSERT_EQ(made.status, 0) << made.err;
    const std::string text = read_text(to);
    for (const std::string& words :
         {std::string("Calibration certificate L-2026-0417-A"), std::string("L-2026-0417"),
          std::string("20 April 2026"), std::string("4 May 2026"), std::string("A digit was wrong"),
          std::string("Changes to certificate L-2026-0417"), std::string("22 Factory Road, 20095 Exampleton"),
          std::string("24 Factory Road, 20095 Exampleton"), "(49.999" + space + "926 ±",
          "(49.999" + space + "971 ±"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    const std::string changes = text.substr(text.find("Changes to certificate"));
    EXPECT_EQ(changes.find("Example Length Laboratory"), std::string::npos) << "it has not changed";
}

TEST_F(Amended, IsMadeOfTheIssuedPdfAndCarriesItsProject) {
    const auto issued = folder / "issued.pdf", pdf = folder / "amended.pdf",
               project = folder / "amended.covaria";
    ASSERT_EQ(run_program({"report", certificate, "--certificate", "-o", issued.string()}).status, 0);
    const Outcome made = run_program(amend(issued.string(), pdf.string()));
    ASSERT_EQ(made.status, 0) << made.err;
    const Outcome same = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    ASSERT_EQ(run_program(amend(issued.string(), project.string())).status, 0);
    EXPECT_EQ(run_program({"validate", project.string(), "--certificate"}).status, 0);
    const auto again = folder / "again.md", there = folder / "there.md";
    ASSERT_EQ(run_program({"report", project.string(), "--certificate", "-o", again.string()}).status, 0);
    ASSERT_EQ(run_program(amend(issued.string(), there.string())).status, 0);
    EXPECT_EQ(read_text(again), read_text(there));
    // What is put right again has not changed.
    ASSERT_EQ(run_program({"report", project.string(), "--certificate", "--set",
                           "/analyses/length/setup/quantities/rows/d/value=-94", "-o", again.string()})
                  .status,
              0);
    EXPECT_NE(read_text(again).find("No result has changed."), std::string::npos);
}

TEST_F(Amended, IsRefusedWhereItsReferenceWouldBeNone) {
    const std::string to = (folder / "amended.covaria").string();
    const std::string plain = (folder / "plain.covaria").string(), number = "\"number\": \"L-2026-0417\",";
    std::string without = read_text(certificate);
    without.erase(without.find(number), number.size());
    write_text(plain, without);
    const auto status = [&](std::vector<std::string> arguments) { return run_program(arguments).status; };
    EXPECT_EQ(status(amend(plain, to)), 1) << "the one to replace has no number";
    EXPECT_EQ(
        status({"compare", certificate, right.string(), "--amend", "L-2026-0417", "--reason", "x", "-o", to}),
        1)
        << "no number of its own";
    EXPECT_EQ(status({"compare", certificate, right.string(), "--amend", "A", "--reason", "x", "--issued",
                      "soon", "-o", to}),
              1);
    EXPECT_EQ(status({"compare", certificate, right.string(), "--amend", "A", "-o", to}), 2);
    EXPECT_EQ(status({"compare", certificate, right.string(), "--amend", "A", "--reason", "x"}), 2);
    EXPECT_EQ(status({"compare", certificate, right.string(), "--reason", "x", "-o", to}), 2);
    EXPECT_EQ(status({"compare", certificate, right.string(), "--issued", "2026-05-04", "-o", to}), 2);
    EXPECT_EQ(status({"compare", certificate, right.string(), "--amend", "A", "--reason", "x", "--analysis",
                      "length", "-o", to}),
              2);
    EXPECT_FALSE(std::filesystem::exists(to));
}

}  // namespace
}  // namespace covaria::compare_test
