// A budget in Excel becomes a certificate that carries it; opened again it gives the same bits.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/pdf/pdf_archive.h"
#include "tests/app/program.h"

namespace budget_session_test {

namespace {

namespace fs = std::filesystem;

const std::string budget = (fs::path(COVARIA_SOURCE_DIR) / "tests/data/readers/budget.xlsx").string();

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::string results_of(const std::string& project, const fs::path& folder) {
    EXPECT_EQ(run_program({"run", project, "--out", folder.string()}).status, 0) << project;
    const std::string results = read_text(folder / "results.json");
    return results.substr(results.find("\"analyses\""));
}

TEST(BudgetSession, FromExcelToACertificateAndBack) {
    const fs::path folder = fresh_folder("budget-session");
    const std::string project = (folder / "gauge.covaria").string(),
                      pdf = (folder / "certificate.pdf").string(), book = (folder / "out.xlsx").string();
    const Outcome shown = run_program({"import", budget});
    EXPECT_TRUE(has(shown.out, "not taken over") && has(shown.out, "sheet 'Cover'")) << shown.out;
    ASSERT_EQ(run_program({"import", budget, "-o", project}).status, 0);
    std::vector<std::string> report{"report", project, "--certificate", "-o", pdf};
    for (const char* value :
         {"number=K-7", "laboratory/name=Laboratory A", "laboratory/address=Road 1", "laboratory/country=DE",
          "customer/name=Customer B", "customer/address=Lane 2", "item/description=Gauge block",
          "item/serialNumber=17", "dates/calibrated=2026-04-17", "dates/issued=2026-04-20", "method=M 3",
          "environment=20 degC", "traceability=To PTB", "authorised/name=E. Muster"}) {
        report.push_back("--set");
        report.push_back(std::string("/certificate/") + value);
    }
    ASSERT_EQ(run_program(report).status, 0);
    const Outcome verified = run_program({"verify-report", pdf});
    EXPECT_EQ(verified.status, 0) << verified.err;
    EXPECT_TRUE(has(verified.out, "same bits")) << verified.out;
    // A file carried by the PDF is opened on its own.
    const auto files = covaria::files_in_pdf(read_text(pdf));
    ASSERT_TRUE(files);
    const auto file = [&](const char* name) {
        const auto found =
            std::find_if(files->begin(), files->end(), [&](const auto& f) { return f.name == name; });
        EXPECT_TRUE(found != files->end()) << name;
        return found == files->end() ? std::string() : found->bytes;
    };
    EXPECT_TRUE(has(file("certificate.xml"), "digitalCalibrationCertificate"));
    const std::string again = (folder / "again.covaria").string();
    write_text(again, file("project.covaria"));
    EXPECT_EQ(results_of(again, folder / "b"), results_of(project, folder / "a"));
    // The digital certificate comes in as quantities; the workbook goes out and says that it agrees.
    const std::string dcc = (folder / "certificate.xml").string();
    write_text(dcc, file("certificate.xml"));
    EXPECT_EQ(run_program({"import", dcc}).status, 0);
    ASSERT_EQ(run_program({"export", project, "--as", "xlsx", "-o", book}).status, 0);
    const Outcome back = run_program({"import", book});
    EXPECT_EQ(back.status, 0) << back.err;
    EXPECT_TRUE(has(back.out, "575 [nm/K]*delta_t") || has(back.out, "0.000575 [mm/K]*delta_t")) << back.out;
}

TEST(BudgetSession, ColumnsAndSheetsThatAreNotThereAreUsageErrors) {
    const Outcome sheet = run_program({"import", budget, "--sheet", "Bugdet"});
    EXPECT_EQ(sheet.status, 2);
    EXPECT_TRUE(has(sheet.err, "there is no sheet 'Bugdet'")) << sheet.err;
    const Outcome column = run_program({"import", budget, "--sheet", "Budget", "--columns", "name,uu"});
    EXPECT_EQ(column.status, 2);
    EXPECT_TRUE(has(column.err, "a column cannot be 'uu'")) << column.err;
}

}  // namespace

}  // namespace budget_session_test
