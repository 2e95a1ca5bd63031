// covaria release, and what check, report and verify-report say of a project that was released.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/pdf/pdf_archive.h"
#include "tests/app/program.h"

namespace release_command_test {

namespace {

namespace fs = std::filesystem;

const std::string gauge = shipped_project("certificate-gauge-block.covaria").string();

const std::string digit = "-94, \"nm\"", another = "-95, \"nm\"";  ///< a comparison of the gauge block

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

void replace_in(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

Outcome release(const std::string& file, const std::string& output) {
    return run_program({"release", file, "--prepared", "A. Ames", "--checked", "B. Bell", "--released",
                        "C. Cole", "--date", "2026-11-28", "-o", output});
}

/// A released project in a folder of its own.
struct Released : testing::Test {
    Released() {
        std::string text = read_text(gauge);
        replace_in(text, "\"options\": {", "\"options\": {\"method\": \"first-order\",");
        write_text(draft, text);
        const Outcome done = release(draft.string(), project.string());
        EXPECT_EQ(done.status, 0) << done.err;
        EXPECT_TRUE(has(done.out, "released by C. Cole on 2026-11-28, digest ")) << done.out;
    }
    /// The report as a PDF and as Markdown.
    std::string report(const fs::path& file, const char* kind = "--no-studies") const {
        for (const fs::path& to : {pdf, markdown}) {
            const Outcome made = run_program({"report", file.string(), kind, "-o", to.string()});
            EXPECT_EQ(made.status, 0) << made.err;
        }
        return read_text(markdown);
    }
    /// Changes the project that the report carries.
    void change_carried(const std::string& from, const std::string& to) const {
        auto files = covaria::files_in_pdf(read_text(pdf)).value();
        for (auto& file : files)
            if (file.name == "project.covaria") replace_in(file.bytes, from, to);
        const auto changed = covaria::archived_pdf(read_text(pdf), {"t", "c"}, files);
        ASSERT_TRUE(changed);
        write_text(pdf, *changed);
    }
    const fs::path folder = fresh_folder("release"), draft = folder / "draft.covaria",
                   project = folder / "order.covaria", pdf = folder / "report.pdf",
                   markdown = folder / "report.md";
};

TEST_F(Released, DocumentsSayByWhomAndTheirPdfProvesIt) {
    const std::string text = report(project);
    for (const char* words :
         {"Prepared by", "A. Ames, 28 November 2026", "Checked by", "Released by", "Digest of the release"})
        EXPECT_TRUE(has(text, words)) << words;
    const Outcome same = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    EXPECT_TRUE(has(same.out, "its project: released by C. Cole on 2026-11-28")) << same.out;
    EXPECT_TRUE(has(report(project, "--certificate"), "Digest of the release"));
    EXPECT_EQ(run_program({"verify-report", pdf.string()}).status, 0);
    EXPECT_FALSE(has(report(draft), "Prepared by")) << "of a project without a review";
    EXPECT_FALSE(has(run_program({"verify-report", pdf.string()}).out, "its project")) << "nothing to say";
}

TEST_F(Released, OneDigitMakesADraftAndItsReportSaysSo) {
    std::string text = read_text(project);
    replace_in(text, digit, another);
    write_text(project, text);
    for (const char* kind : {"--no-studies", "--certificate"}) {
        const std::string document = report(project, kind);
        EXPECT_TRUE(has(document, "changed since the release by C. Cole, 28 November 2026: analysis '"))
            << document.substr(0, 2000);
        EXPECT_FALSE(has(document, "Digest of the release"));
    }
    const Outcome told = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(told.status, 3) << told.out << told.err;
    EXPECT_TRUE(has(told.out, "same bits")) << told.out;
    EXPECT_TRUE(
        has(told.out, "draft again: changed since it was released by C. Cole on 2026-11-28: analysis '"))
        << told.out;
}

TEST_F(Released, OneDigitOfWhatItsReportCarriesIsFound) {
    report(project);
    change_carried(digit, another);
    const Outcome told = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(told.status, 1) << told.out;
    EXPECT_TRUE(has(told.out, "not the same bits")) << told.out;
    EXPECT_TRUE(has(told.out, "draft again: changed since it was released")) << told.out;
    report(project);
    change_carried("\"checked\": {\"name\": \"B. Bell\"", "\"checked\": {\"name\": \"D. Dale\"");
    const Outcome other = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(other.status, 3) << other.out << other.err;
    EXPECT_TRUE(has(other.out, "the names and dates of the review")) << other.out;
}

TEST_F(Released, OptionsThatChangeTheEvaluationAreSaid) {
    run_program({"report", project.string(), "--trials", "2000", "-o", markdown.string()});
    EXPECT_TRUE(has(read_text(markdown), "changed since the release")) << "other trials than were released";
}

TEST_F(Released, CheckJudgesADraftWhereItIsAsked) {
    const auto check = [&](const std::string& file, bool asked) {
        std::vector<std::string> arguments{"check", file};
        if (asked) arguments.push_back("--released");
        return run_program(arguments);
    };
    const int plain = check(draft.string(), false).status;
    const Outcome released = check(project.string(), true);
    EXPECT_EQ(released.status, plain) << released.out;
    EXPECT_TRUE(has(released.out, "met     project/release")) << released.out;
    EXPECT_TRUE(has(released.out, "the project: released by C. Cole")) << released.out;
    EXPECT_EQ(check(draft.string(), true).status, 3) << "it never was released";
    std::string text = read_text(project);
    replace_in(text, digit, another);
    write_text(project, text);
    const Outcome again = check(project.string(), false);
    EXPECT_EQ(again.status, plain) << "a draft may be judged";
    EXPECT_TRUE(has(again.out, "the project: draft again")) << again.out;
    EXPECT_TRUE(has(check(project.string(), true).out, "NOT MET project/release: draft again"));
}

TEST_F(Released, ALineOfTheLogLeavesItReleased) {
    const Outcome written = run_program({"release", project.string(), "--log", "Sent", "--by", "A. Ames"});
    EXPECT_EQ(written.status, 0) << written.err;
    EXPECT_TRUE(has(written.out, "released by C. Cole")) << written.out;
    EXPECT_TRUE(has(read_text(project), "\"who\": \"A. Ames\", \"what\": \"Sent\""));
    std::string text = read_text(project);
    replace_in(text, digit, another);
    write_text(project, text);
    const Outcome again = run_program({"release", project.string(), "--date", "2026-12-01"});
    EXPECT_EQ(again.status, 0) << "the names are there";
    EXPECT_TRUE(has(again.out, "released by C. Cole on 2026-12-01")) << again.out;
    EXPECT_TRUE(has(read_text(project), "Released, digest "));
}

TEST(ReleaseCommand, InAnotherFolderTheTablesOfItsFilesStandInTheProject) {
    const fs::path there = fresh_folder("elsewhere") / "sensor.covaria";
    const std::string sensor = shipped_project("force-moment-sensor.covaria").string();
    ASSERT_EQ(release(sensor, there.string()).status, 0);
    EXPECT_FALSE(has(read_text(there), "force-moment-sensor.csv"));
    EXPECT_EQ(run_program({"validate", there.string()}).status, 0);
    const Outcome line = run_program({"release", there.string(), "--log", "x", "--by", "A"});
    EXPECT_TRUE(has(line.out, "released by C. Cole")) << line.out << "the same figures";
}

TEST(ReleaseCommand, RefusesWhatIsNoRelease) {
    const std::string out = (fresh_folder("refused") / "order.covaria").string();
    EXPECT_EQ(run_program({"release", gauge, "-o", out}).status, 1) << "nobody is named";
    EXPECT_EQ(run_program({"release", gauge, "--prepared", "A", "--checked", "B", "-o", out}).status, 1);
    EXPECT_EQ(run_program({"release", gauge, "--prepared", "A", "--checked", "B", "--released", "C", "--date",
                           "soon", "-o", out})
                  .status,
              1);
    EXPECT_EQ(run_program({"release", gauge, "--log", "x", "-o", out}).status, 2) << "whose line?";
    EXPECT_EQ(run_program({"release", gauge, "--by", "A", "-o", out}).status, 2) << "which line?";
    EXPECT_EQ(run_program({"release", gauge, "--log", "x", "--by", "A", "--checked", "B", "-o", out}).status,
              2);
    EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace release_command_test
