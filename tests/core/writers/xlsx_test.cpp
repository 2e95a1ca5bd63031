// Workbooks: read again by the reader, recomputed by LibreOffice where it is installed.
#include <cmath>
#include <cstdlib>
#include <regex>

#include "core/base/file_io.h"
#include "core/readers/readers.h"
#include "core/readers/workbook.h"
#include "core/readers/zip_parts.h"
#include "tests/core/readers/zipped.h"
#include "tests/core/writers/evaluated.h"
#include "tests/fresh_folder.h"

namespace covaria::xlsx_test {

using namespace writers_test;
namespace fs = std::filesystem;

namespace {

const fs::path projects = fs::path(COVARIA_SOURCE_DIR) / "projects";

std::string written(const Evaluated& evaluated) {
    const auto file = write_as("xlsx", evaluated.source());
    EXPECT_TRUE(file) << file.error().message.english();
    return file ? file->bytes : std::string();
}

std::vector<WorkbookSheet> sheets_of(const std::string& bytes) {
    auto sheets = read_workbook(bytes);
    EXPECT_TRUE(sheets) << sheets.error().message.english();
    return sheets.value_or(std::vector<WorkbookSheet>());
}

std::size_t output_lines(const Evaluated& evaluated) {
    return evaluated.analyses[0].result->budget.rows[0].size();
}

TEST(WriteXlsx, TheReaderGetsTheSameBudgetBack) {
    for (const char* name : {"gum/h1-end-gauge.covaria", "gum/s1-9.5-gauge-block.covaria"}) {
        Project project = loaded(projects / name);
        project.analyses.resize(1);
        const Evaluated evaluated = evaluate(project);
        const auto read = find_reader("xlsx")->read(written(evaluated), {.file_name = "h1.xlsx"});
        ASSERT_TRUE(read) << read.error().message.english();
        Project again;
        add_to_project(again, *read);
        const Evaluated second = evaluate(again);
        ASSERT_EQ(second.analyses.size(), 1u);
        const FirstOrderOutput &a = evaluated.analyses[0].result->outputs[0].first_order,
                               &b = second.analyses[0].result->outputs[0].first_order;
        // The terms of the sum are 50 mm; their roundings are all that may differ.
        EXPECT_NEAR(b.estimate, a.estimate, 4.0 * 2.3e-16 * 0.05) << name;
        EXPECT_NEAR(b.standard_uncertainty, a.standard_uncertainty, 1e-13 * a.standard_uncertainty) << name;
        EXPECT_NEAR(1.0 / b.effective_degrees_of_freedom, 1.0 / a.effective_degrees_of_freedom, 1e-14)
            << name;
    }
}

TEST(WriteXlsx, EqualResultsGiveEqualBytes) {
    const Evaluated evaluated = evaluate(loaded(projects / "gum/h2-impedance.covaria"));
    EXPECT_EQ(written(evaluated), written(evaluated));
}

/// Texts that Excel would compute or follow stay texts: no cell has a formula that was not written here.
TEST(WriteXlsx, WhatWasTypedIsNeverAFormula) {
    Project project = loaded(projects / "gum/h1-end-gauge.covaria");
    project.analyses.resize(1);
    project.title = "=HYPERLINK(\"http://x\")";
    project.analyses[0].name = "@SUM(A1)";
    auto& rows = std::get<SetupTable>(project.analyses[0].setup.values.at("quantities")).rows;
    std::size_t expected = 0;
    for (const char* name : {"plain", "=1+1", "+2", "-3", "@x", "http://example.org",
                             "a\tb\x01"
                             "c]]><f>1</f>"}) {
        rows[0][1] = std::string(name);
        const std::string bytes = written(evaluate(project));
        auto zip = ZipParts::open(bytes, 100'000'000);
        ASSERT_TRUE(zip);
        const std::string leads_to = zip->read("xl/worksheets/_rels/sheet2.xml.rels").value_or("");
        EXPECT_EQ(leads_to.find("hyperlink"), std::string::npos) << "only to its chart";
        const std::string sheet = zip->read("xl/worksheets/sheet2.xml").value_or("");
        const std::regex formula("<f>([^<]*)</f>");
        std::size_t formulas = 0;
        for (std::sregex_iterator at(sheet.begin(), sheet.end(), formula), end; at != end; ++at, ++formulas)
            EXPECT_EQ(std::string((*at)[1]).find("HYPERLINK"), std::string::npos);
        if (expected == 0) expected = formulas;
        EXPECT_GT(formulas, 10u);
        EXPECT_EQ(formulas, expected) << name;
        EXPECT_EQ(sheet.find("<hyperlink"), std::string::npos);
    }
}

/// Cells keep all digits and show as many as the uncertainty has; heads stay in sight, in print too; results
/// have names for formulas, and the contributions a chart.
TEST(WriteXlsx, LooksLikeABudget) {
    Project project = loaded(projects / "gum/h1-end-gauge.covaria");
    project.analyses.resize(1);
    const Evaluated evaluated = evaluate(project);
    const std::string bytes = written(evaluated);
    auto zip = ZipParts::open(bytes, 100'000'000);
    ASSERT_TRUE(zip);
    const std::string sheet = zip->read("xl/worksheets/sheet2.xml").value_or("");
    EXPECT_NE(sheet.find("ySplit=\"4\""), std::string::npos) << "the heads are frozen";
    EXPECT_NE(sheet.find("fitToHeight=\"0\""), std::string::npos) << "as wide as a page";
    const std::string styles = zip->read("xl/styles.xml").value_or("");
    EXPECT_NE(styles.find("formatCode=\"0.0###%\""), std::string::npos);
    const auto sheets = sheets_of(bytes);
    const WorkbookCell* y = nullptr;
    for (const auto& [row, cells] : sheets[1].rows)
        if (const WorkbookCell* symbol = sheets[1].cell(row, 1); symbol && symbol->text == "l" && row > 5)
            y = sheets[1].cell(row, 3);
    ASSERT_TRUE(y && y->number);
    const OutputResult& output = evaluated.analyses[0].result->outputs[0];
    EXPECT_EQ(*y->number, output.quantity.unit.from_si(output.first_order.estimate)) << "all digits";
    const std::string book = zip->read("xl/workbook.xml").value_or("");
    for (const char* name : {"estimate", "standard_uncertainty", "effective_degrees_of_freedom",
                             "coverage_probability", "coverage_factor", "expanded_uncertainty"})
        EXPECT_NE(book.find("name=\"" + std::string(name) + "\""), std::string::npos) << name;
    EXPECT_NE(book.find("_xlnm.Print_Titles"), std::string::npos) << "each page repeats the heads";
    const std::string chart = zip->read("xl/charts/chart1.xml").value_or("");
    const std::size_t last = 4 + output_lines(evaluated);
    EXPECT_NE(chart.find("$I$5:$I$" + std::to_string(last)), std::string::npos) << "all contributions";
}

std::string without_values(const std::string& bytes) {
    auto zip = ZipParts::open(bytes, 100'000'000);
    EXPECT_TRUE(zip);
    readers_test::Parts parts;
    for (const char* name :
         {"[Content_Types].xml", "_rels/.rels", "docProps/app.xml", "docProps/core.xml", "xl/workbook.xml",
          "xl/_rels/workbook.xml.rels", "xl/sharedStrings.xml", "xl/styles.xml", "xl/theme/theme1.xml"})
        if (const auto part = zip->read(name)) parts[name] = *part;
    for (int i = 1; zip->has("xl/worksheets/sheet" + std::to_string(i) + ".xml"); ++i) {
        const std::string name = "xl/worksheets/sheet" + std::to_string(i) + ".xml";
        parts[name] = std::regex_replace(*zip->read(name), std::regex("</f><v>[^<]*</v>"), "</f>");
    }
    return readers_test::zipped(parts);
}

TEST(WriteXlsx, LibreOfficeComputesTheSameNumbers) {
    if (std::system("command -v soffice >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "LibreOffice is not installed";
    const fs::path folder = test::fresh_folder();
    fs::create_directories(folder / "out");
    for (const char* name :
         {"gum/h1-end-gauge.covaria", "gum/h2-impedance.covaria", "gum/s1-9.2-additive.covaria"}) {
        const std::string bytes = written(evaluate(loaded(projects / name)));
        ASSERT_TRUE(write_file_atomically(folder / "book.xlsx", without_values(bytes)));
        fs::remove(folder / "out/book.xlsx");
        const std::string command = "soffice -env:UserInstallation=file://" + (folder / "profile").string() +
                                    " --headless --convert-to 'xlsx:Calc MS Excel 2007 XML' --outdir " +
                                    (folder / "out").string() + " " + (folder / "book.xlsx").string() +
                                    " >/dev/null 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << name;
        const auto recomputed = read_file(folder / "out/book.xlsx");
        ASSERT_TRUE(recomputed);
        const auto ours = sheets_of(bytes), theirs = sheets_of(*recomputed);
        ASSERT_EQ(ours.size(), theirs.size());
        int numbers = 0, agreements = 0;
        for (std::size_t s = 0; s < ours.size(); ++s)
            for (const auto& [row, cells] : ours[s].rows)
                for (const auto& [column, cell] : cells) {
                    const WorkbookCell* other = theirs[s].cell(row, column);
                    ASSERT_TRUE(other) << ours[s].place(row, column);
                    if (cell.number) {
                        ASSERT_TRUE(other->number) << ours[s].place(row, column) << other->text;
                        // BETAINV of LibreOffice is good to nine digits.
                        EXPECT_NEAR(*other->number, *cell.number, 1e-8 * std::abs(*cell.number))
                            << name << " " << ours[s].place(row, column);
                        ++numbers;
                    } else {
                        EXPECT_EQ(other->text, cell.text) << ours[s].place(row, column);
                        agreements += cell.text == "yes";
                    }
                }
        EXPECT_GT(numbers, 30) << name;
        EXPECT_GE(agreements, 4) << name;
    }
}

}  // namespace

}  // namespace covaria::xlsx_test
