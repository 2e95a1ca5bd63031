// The report carries its data: PDF/A-3b with project, results and certificate; verify-report computes it
// again.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/pdf/pdf_archive.h"
#include "tests/app/program.h"

namespace verify_report_test {

namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::vector<std::string> names_in(const fs::path& pdf) {
    const auto files = covaria::files_in_pdf(read_text(pdf));
    EXPECT_TRUE(files) << pdf;
    std::vector<std::string> names;
    if (files)
        for (const auto& file : *files) names.push_back(file.name);
    std::sort(names.begin(), names.end());
    return names;
}

TEST(VerifyReport, AReportCarriesItsProjectAndGivesTheSameBits) {
    const fs::path folder = fresh_folder("verify-report"), pdf = folder / "report.pdf";
    const std::string project = shipped_project("force-moment-sensor.covaria").string();
    const std::vector<std::string> report{"report",       project, "--trials",  "3000",
                                          "--no-studies", "-o",    pdf.string()};
    ASSERT_EQ(run_program(report).status, 0);
    const std::string first = read_text(pdf);
    EXPECT_TRUE(first.starts_with("%PDF-1.7"));
    for (const char* part : {"<pdfaid:part>3</pdfaid:part>", "/AFRelationship /Source", "/OutputIntents"})
        EXPECT_TRUE(has(first, part)) << part;
    ASSERT_EQ(run_program(report).status, 0);
    EXPECT_EQ(read_text(pdf), first) << "equal bytes twice";
    const std::vector<std::string> names = names_in(pdf);
    for (const char* name : {"project.covaria", "results.json", "force-moment-sensor.csv"})
        EXPECT_TRUE(std::find(names.begin(), names.end(), name) != names.end()) << name;
    const Outcome same = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(same.status, 0) << same.err << same.out;
    EXPECT_TRUE(has(same.out, "same bits")) << same.out;
    EXPECT_EQ(run_program({"verify-report", pdf.string(), "--threads", "1"}).status, 0);
}

TEST(VerifyReport, StudiesAreComparedWhereTheReportHasThem) {
    const fs::path folder = fresh_folder("verify-report-studies");
    for (const bool without : {true, false}) {
        const std::string pdf = (folder / (without ? "without.pdf" : "with.pdf")).string();
        std::vector<std::string> report{"report", shipped_project("lsm-network.covaria").string(),
                                        "--first-order", "-o", pdf};
        if (without) report.push_back("--no-studies");
        ASSERT_EQ(run_program(report).status, 0);
        const auto files = covaria::files_in_pdf(read_text(pdf)).value();
        const auto results = std::find_if(files.begin(), files.end(),
                                          [](const auto& file) { return file.name == "results.json"; });
        EXPECT_EQ(has(results->bytes, "\"studies\""), !without);
        const Outcome same = run_program({"verify-report", pdf});
        EXPECT_EQ(same.status, 0) << same.out << same.err;
    }
}

TEST(VerifyReport, NamesWhatDiffersAndTheOtherVersion) {
    const fs::path folder = fresh_folder("verify-report-differs"), pdf = folder / "report.pdf";
    const std::string project = (fs::path(COVARIA_SOURCE_DIR) / "projects/gum/h1-end-gauge.covaria").string();
    ASSERT_EQ(run_program({"report", project, "--first-order", "--certificate", "-o", pdf.string()}).status,
              0);
    auto files = covaria::files_in_pdf(read_text(pdf)).value();
    for (auto& file : files) {
        if (file.name != "results.json") continue;
        const std::string estimate = "\"estimate\": ", version = "\"covariaVersion\": \"";
        file.bytes.insert(file.bytes.find(estimate) + estimate.size(), "1");
        file.bytes.insert(file.bytes.find(version) + version.size(), "9.");
    }
    const auto changed = covaria::archived_pdf(read_text(pdf), {"t", "c"}, files);
    ASSERT_TRUE(changed) << changed.error().message.english();
    write_text(pdf, *changed);
    const Outcome differs = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(differs.status, 1);
    EXPECT_TRUE(has(differs.out, ", estimate: ")) << differs.out;
    EXPECT_TRUE(has(differs.out, "not the same bits")) << differs.out;
    EXPECT_TRUE(has(differs.err, "made by Covaria 9.")) << differs.err;
    files.push_back({"../escaped.csv", "x", "text/csv", "", covaria::AttachedAs::data});
    write_text(pdf, covaria::archived_pdf(*changed, {"t", "c"}, files).value());
    const Outcome escaped = run_program({"verify-report", pdf.string()});
    EXPECT_EQ(escaped.status, 1);
    EXPECT_TRUE(has(escaped.err, "would leave its folder")) << escaped.err;
    const Outcome none = run_program({"verify-report", project});
    EXPECT_EQ(none.status, 1);
    EXPECT_TRUE(has(none.err, "it is no PDF")) << none.err;
}

TEST(VerifyReport, ACompleteCertificateIsCarriedForMachines) {
    const fs::path folder = fresh_folder("verify-report-dcc"), pdf = folder / "certificate.pdf";
    std::vector<std::string> arguments{
        "report",
        (fs::path(COVARIA_SOURCE_DIR) / "projects/gum/h1-end-gauge.covaria").string(),
        "--first-order",
        "--certificate",
        "-o",
        pdf.string()};
    ASSERT_EQ(run_program(arguments).status, 0);
    std::vector<std::string> names = names_in(pdf);
    EXPECT_TRUE(std::find(names.begin(), names.end(), "certificate.xml") == names.end());
    for (const char* value :
         {"number=K-7", "laboratory/name=Laboratory A", "laboratory/address=Road 1", "laboratory/country=DE",
          "customer/name=Customer B", "customer/address=Lane 2", "item/description=Gauge block",
          "item/serialNumber=17", "dates/calibrated=2026-04-17", "dates/issued=2026-04-20", "method=M 3",
          "environment=20 degC", "traceability=To PTB", "specification=ISO 3650",
          "authorised/name=E. Muster"}) {
        arguments.push_back("--set");
        arguments.push_back(std::string("/certificate/") + value);
    }
    ASSERT_EQ(run_program(arguments).status, 0);
    names = names_in(pdf);
    EXPECT_TRUE(std::find(names.begin(), names.end(), "certificate.xml") != names.end());
    EXPECT_EQ(run_program({"verify-report", pdf.string()}).status, 0);
}

}  // namespace

}  // namespace verify_report_test
