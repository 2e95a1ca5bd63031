// Runs with other values, tables of serial numbers, requirements as test cases.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "tests/app/program.h"

namespace covaria::automation_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string gauge = shipped_project("gum/h1-end-gauge.covaria").string();

double estimate_in(const fs::path& folder) {
    return json::parse(read_text(folder / "results.json"))["analyses"][0]["outputs"][0]["estimate"];
}

TEST(Automation, AValueIsSetForOneRun) {
    const fs::path folder = fresh_folder("set");
    const Outcome run = run_program({"run", gauge, "--analysis", "table", "--out", folder.string(), "--set",
                                     "/analyses/table/setup/quantities/rows/l_S/value=50000723"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(estimate_in(folder), 50000838 + 100, 1.0);
}

TEST(Automation, AWrongPlaceOrValueIsRefusedWithItsPath) {
    const Outcome place = run_program({"run", gauge, "--set", "/analyses/tabel/name=x"});
    EXPECT_EQ(place.status, 1);
    EXPECT_NE(place.err.find("/analyses/tabel/name"), std::string::npos) << place.err;
    EXPECT_NE(place.err.find("did you mean 'table'"), std::string::npos) << place.err;
    const Outcome value =
        run_program({"run", gauge, "--set", "/analyses/table/options/coverageProbability=2"});
    EXPECT_EQ(value.status, 1);
    EXPECT_NE(value.err.find("/analyses/0/options/coverageProbability"), std::string::npos) << value.err;
    EXPECT_EQ(run_program({"run", gauge, "--set", "title"}).status, 2);
}

TEST(Automation, ARowOfATableIsARun) {
    const fs::path folder = fresh_folder("set-from");
    write_text(folder / "blocks.csv",
               "serial,/title,/analyses/table/setup/quantities/rows/l_S/value\n"
               "A 1,Block A 1,50000623\nA/1,Block A/1,50000723\nB,,50000523\n");
    const Outcome run = run_program({"run", gauge, "--analysis", "table", "--set-from",
                                     (folder / "blocks.csv").string(), "--out", (folder / "out").string()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(estimate_in(folder / "out" / "A-1"), 50000838, 1.0);
    EXPECT_NEAR(estimate_in(folder / "out" / "A-1-2"), 50000938, 1.0);
    EXPECT_NEAR(estimate_in(folder / "out" / "B"), 50000738, 1.0);
    const std::string table = read_text(folder / "out" / "results.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4) << table;
    EXPECT_NE(table.find("\r\nA/1,table,,l,nm,50000"), std::string::npos) << table;
    EXPECT_NE(table.find(",A-1-2,\r\n"), std::string::npos) << "the folder of the row: " << table;
}

TEST(Automation, ARowThatCannotBeRunIsSaidAndTheOthersAre) {
    const fs::path folder = fresh_folder("set-from-wrong");
    write_text(folder / "blocks.csv",
               "serial,/analyses/table/setup/quantities/rows/l_S/value\nA 7,long\nB,50000523\n");
    const Outcome run = run_program({"run", gauge, "--analysis", "table", "--set-from",
                                     (folder / "blocks.csv").string(), "--out", (folder / "out").string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(fs::exists(folder / "out" / "B" / "results.json"));
    EXPECT_NE(run.err.find("1 of 2 rows"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("blocks.csv:2: row 1 (A 7): "), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder / "out" / "A-7")) << "no folder for what was never run";
    const std::string table = read_text(folder / "out" / "results.csv");
    EXPECT_NE(table.find("\r\nA 7,,,,,,,,,,,,,,\""), std::string::npos) << "a row that says why: " << table;
    EXPECT_NE(table.find("\r\nB,table,,l,nm,50000"), std::string::npos) << table;
    const auto said = run.err.find("row 1 (A 7)"), warned = run.err.find("warning", said);
    EXPECT_TRUE(warned == std::string::npos || said < warned) << "before the first run: " << run.err;
    write_text(folder / "heads.csv", "value\n1\n");
    const Outcome heads = run_program({"run", gauge, "--set-from", (folder / "heads.csv").string()});
    EXPECT_EQ(heads.status, 1);
    EXPECT_NE(heads.err.find("heads.csv:1"), std::string::npos) << heads.err;
}

// An analysis that cannot be made keeps no other from being run that does not use it.
TEST(Automation, WhatIsAskedForIsRunWhateverElseIsWrong) {
    const fs::path folder = fresh_folder("other-errors");
    const std::string file = (folder / "p.covaria").string(), out = (folder / "out").string();
    const std::vector<std::string> run{"run", file, "--first-order", "--out", out, "--analysis"};
    const auto with = [&](std::string analysis) {
        std::vector<std::string> command = run;
        command.push_back(std::move(analysis));
        return run_program(command);
    };
    const auto analysis = [](const char* id, const char* equation, const char* links) {
        return std::string(R"({"id": ")") + id +
               R"(", "model": "measurement-equation", "setup": {"equations": [")" + equation +
               R"("], "outputs": {"columns": ["symbol", "name", "unit"], "rows": [["y", "y", "1"]]},
 "quantities": {"columns": ["symbol", "name", "unit", "value", "statement", "a"],
 "rows": [["x", "x", "1", 1, "standard", 0.1]]}})" +
               links + "}";
    };
    write_text(
        file,
        R"({"format": "covaria", "schemaVersion": 2, "title": "t", "assets": [], "analyses": [)" +
            analysis("good", "y = x", "") + "," + analysis("bad", "y = x +", "") + "," +
            analysis("user", "y = 2*x", R"(, "links": [{"input": "x", "analysis": "bad", "output": "y"}])") +
            "]}");
    const Outcome good = with("good");
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_NE(good.err.find("error: /analyses/1/"), std::string::npos) << "and it is said: " << good.err;
    EXPECT_TRUE(fs::exists(folder / "out/results.json"));
    EXPECT_EQ(run_program({"check", file, "--analysis", "good"}).status, 0);
    // A run that fails leaves nothing that looks like its result.
    EXPECT_EQ(with("bad").status, 1);
    EXPECT_FALSE(fs::exists(folder / "out/results.json"));
    EXPECT_TRUE(fs::exists(folder / "out/results.before.json")) << "what was there is kept";
    EXPECT_EQ(with("user").status, 1) << "it is made of the bad one";
    EXPECT_EQ(run_program({"run", file, "--out", out}).status, 1) << "all are asked for";
    EXPECT_EQ(with("good").status, 0);
    EXPECT_TRUE(fs::exists(folder / "out/results.json"));
    EXPECT_FALSE(fs::exists(folder / "out/results.before.json"));
}

TEST(Automation, OneFormatIsWrittenWhereOneIsWanted) {
    const fs::path folder = fresh_folder("format");
    const Outcome run = run_program({"run", gauge, "--analysis", "table", "--first-order", "--report",
                                     "--format", "markdown", "--out", folder.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(fs::exists(folder / "report.md"));
    EXPECT_FALSE(fs::exists(folder / "report.pdf") || fs::exists(folder / "report.html"));
}

TEST(Automation, RequirementsAreTestCases) {
    const fs::path folder = fresh_folder("check");
    const std::string file = (folder / "junit.xml").string();
    const Outcome met =
        run_program({"check", gauge, "--analysis", "statements", "--trials", "20000", "--junit", file});
    EXPECT_TRUE(met.status == 0 || met.status == 3) << met.err;
    pugi::xml_document xml;
    ASSERT_TRUE(xml.load_file(file.c_str()));
    const pugi::xml_node suite = xml.child("testsuites").child("testsuite");
    EXPECT_STREQ(suite.attribute("name").value(), "statements");
    EXPECT_EQ(suite.attribute("tests").as_int(), 2);  // target and tolerance
    const bool all_met = suite.attribute("failures").as_int() == 0;
    EXPECT_EQ(met.status, all_met ? 0 : 3) << met.out;

    const Outcome missed =
        run_program({"check", gauge, "--analysis", "statements", "--trials", "20000", "--junit", file,
                     "--set", "/analyses/statements/requirements/0/targetUncertainty=1"});
    EXPECT_EQ(missed.status, 3) << missed.err;
    EXPECT_NE(missed.out.find("NOT MET statements/l, target uncertainty: U = "), std::string::npos)
        << missed.out;
    ASSERT_TRUE(xml.load_file(file.c_str()));
    EXPECT_GE(xml.child("testsuites").child("testsuite").attribute("failures").as_int(), 1);
}

/// All that is required of a certificate, for the command line.
std::vector<std::string> with_certificate(std::vector<std::string> arguments) {
    for (const char* value :
         {"number=2026-0417", "laboratory/name=Length laboratory", "laboratory/address=Road 1, Town",
          "customer/name=Works", "customer/address=Road 2, Town", "item/description=Gauge block",
          "item/serialNumber=0815", "dates/calibrated=2026-04-17", "dates/issued=2026-04-20",
          "method=Comparison, MP-12", "environment=(20.0 ± 0.1) °C", "traceability=Certificate 55-2026",
          "specification=ISO 3650:1998, grade 1", "authorised/name=E. Muster"}) {
        arguments.emplace_back("--set");
        arguments.push_back(std::string("/certificate/") + value);
    }
    return arguments;
}

TEST(Certificate, ValidateListsWhatIsMissing) {
    const Outcome without = run_program({"validate", gauge, "--certificate"});
    EXPECT_EQ(without.status, 1);
    EXPECT_NE(without.err.find("/certificate/laboratory/address: "), std::string::npos) << without.err;
    EXPECT_NE(without.err.find("must be stated (ISO/IEC 17025 7.8.4.1 c)"), std::string::npos) << without.err;
    EXPECT_EQ(run_program({"validate", gauge}).status, 0) << "nobody asked for a certificate";
    const Outcome with = run_program(with_certificate({"validate", gauge, "--certificate"}));
    EXPECT_EQ(with.status, 0) << with.err;
    EXPECT_EQ(with.err, "");
    std::vector<std::string> accredited = with_certificate({"validate", gauge});
    accredited.insert(accredited.end(), {"--set", "/certificate/laboratory/accreditation=D-K-1"});
    const Outcome warned = run_program(accredited);
    EXPECT_EQ(warned.status, 0) << "a warning";
    EXPECT_NE(warned.err.find("about 95 % (ILAC-P14 5.3); here it is 99"), std::string::npos) << warned.err;
    const Outcome wrong = run_program({"validate", gauge, "--set", "/certificate/dates/issued=17.4.2026"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_NE(wrong.err.find("must be a date of the form 2026-04-17"), std::string::npos) << wrong.err;
    std::vector<std::string> early = with_certificate({"validate", gauge});
    early.insert(early.end(), {"--set", "/certificate/dates/issued=2026-04-16"});
    EXPECT_EQ(run_program(early).status, 0) << "a warning";
    early.push_back("--certificate");
    const Outcome before = run_program(early);
    EXPECT_EQ(before.status, 1) << "no certificate can be issued so";
    EXPECT_NE(before.err.find("before the calibration"), std::string::npos) << before.err;
}

TEST(Certificate, IsOneFileOfTheFormatThatItsNameAsksFor) {
    const fs::path folder = fresh_folder("certificate");
    for (const std::string name : {"c.pdf", "c.html", "c.md"}) {
        const std::string file = (folder / "new" / name).string();
        const Outcome run = run_program(
            with_certificate({"report", gauge, "--certificate", "--analysis", "table", "-o", file}));
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.err, "");
        EXPECT_TRUE(fs::exists(file)) << name;
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "new"), fs::directory_iterator()), 3);
    EXPECT_EQ(read_text(folder / "new" / "c.pdf").substr(0, 5), "%PDF-");
    const std::string html = read_text(folder / "new" / "c.html");
    for (const char* part :
         {"Calibration certificate 2026-0417", "0815", "End of certificate 2026-0417", "17 April 2026",
          "Date of issue: 20 April 2026", "l = (50 000 838 ± 92) nm, k = 2.91", "p = 99 %"})
        EXPECT_NE(html.find(part), std::string::npos) << part << "\n" << html;
    const Outcome wrong = run_program({"report", gauge, "-o", (folder / "c.docx").string()});
    EXPECT_EQ(wrong.status, 2) << wrong.err;
}

TEST(Certificate, ThereIsOneForEachSerialNumber) {
    const fs::path folder = fresh_folder("certificates");
    write_text(folder / "blocks.csv",
               "serial,/certificate/number,/certificate/item/serialNumber,"
               "/analyses/table/setup/quantities/rows/l_S/value\n"
               "17,2026-1,17,50000623\n18,2026-2,18,50000723\n");
    const Outcome run =
        run_program(with_certificate({"run", gauge, "--analysis", "table", "--certificate", "--set-from",
                                      (folder / "blocks.csv").string(), "--out", (folder / "out").string()}));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(read_text(folder / "out/17/certificate.html").find("certificate 2026-1<"), std::string::npos);
    const std::string second = read_text(folder / "out/18/certificate.md");
    EXPECT_NE(second.find("2026-2"), std::string::npos);
    EXPECT_NE(second.find("50 000 938"), std::string::npos) << second;
    EXPECT_TRUE(fs::exists(folder / "out/18/certificate.pdf"));
}

std::size_t pages_of(const fs::path& pdf) {
    const std::string bytes = read_text(pdf);
    const std::string key = "/Count ";
    const std::size_t pages = bytes.find("/Type /Pages");
    const std::size_t at = bytes.find(key, bytes.rfind(" obj", pages));
    return at == std::string::npos ? 0 : std::stoul(bytes.substr(at + key.size(), 8));
}

TEST(Reports, OfTheExamplesHaveUpToTwentyPages) {
    const fs::path folder = fresh_folder("reports");
    std::size_t longest = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(COVARIA_SOURCE_DIR) / "projects")) {
        if (entry.path().extension() != ".covaria") continue;
        const fs::path pdf = folder / (entry.path().stem().string() + ".pdf");
        const Outcome run =
            run_program({"report", entry.path().string(), "--trials", "2000", "-o", pdf.string()});
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_GE(pages_of(pdf), 4U) << entry.path();  // a budget of one result has no more to say
        EXPECT_LE(pages_of(pdf), 20U) << entry.path();
        longest = std::max(longest, pages_of(pdf));
    }
    const fs::path whole = folder / "whole.pdf";
    const Outcome run =
        run_program({"report", (fs::path(COVARIA_SOURCE_DIR) / "projects/tracker-pose.covaria").string(),
                     "--trials", "2000", "--annex", "-o", whole.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_GT(pages_of(whole), 4 * longest) << "the annex has the long tables";
}

TEST(Sheets, HaveTwoPagesForEachAnalysis) {
    const fs::path folder = fresh_folder("sheets");
    for (const auto& [name, analyses] :
         {std::pair("tracker-test", 1u), std::pair("robot-performance", 1u), std::pair("distance-meter", 2u),
          std::pair("theodolite", 1u), std::pair("force-transducer", 2u), std::pair("turned-part", 1u),
          std::pair("gauge-block-history", 2u), std::pair("eye-on-hand", 2u), std::pair("robot-readings", 4u),
          std::pair("tracker-network", 1u), std::pair("certificate-gauge-block", 1u)})
        for (const char* language : {"en", "de"}) {
            const fs::path pdf = folder / (std::string(name) + "-" + language + ".pdf");
            const Outcome run =
                run_program({"report", shipped_project(std::string(name) + ".covaria").string(), "--sheet",
                             "--first-order", "--set", std::string("/certificate/language=") + language, "-o",
                             pdf.string()});
            ASSERT_EQ(run.status, 0) << run.err;
            EXPECT_LE(pages_of(pdf), 2 * analyses) << pdf;
        }
}

TEST(Sheets, BeginWithTheirDecisions) {
    const fs::path file = fresh_folder("sheet-words") / "sheet.md";
    const Outcome run = run_program({"report", shipped_project("tracker-test.covaria").string(), "--sheet",
                                     "--first-order", "-o", file.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string text = read_text(file);
    const std::size_t decided = text.find("Decisions"), table = text.find("Decisions after ISO 14253-1"),
                      setup = text.find("Set-up");
    ASSERT_NE(table, std::string::npos) << text;
    EXPECT_LT(decided, table);
    EXPECT_LT(table, setup);
    EXPECT_EQ(text.find("Uncertainty budgets"), std::string::npos);
}

TEST(Automation, ResultsNameTheirCertificatesAndDecisions) {
    const auto results_of = [](const fs::path& file, const char* folder) {
        const fs::path out = fresh_folder(folder);
        const Outcome run = run_program({"run", file.string(), "--first-order", "--out", out.string()});
        EXPECT_EQ(run.status, 0) << run.err;
        return json::parse(read_text(out / "results.json"))["analyses"].at(0);
    };
    const json expired =
        results_of(fs::path(COVARIA_SOURCE_DIR) / "docs/three-years/2025/customer-d.covaria", "expired");
    const json& used = expired["figures"]["certificates"].at(0);
    EXPECT_EQ(used["verdict"], "expired");
    EXPECT_NE(std::string(used["reasons"].at(0)).find("2026-01-31"), std::string::npos) << used;
    EXPECT_FALSE(expired.contains("decisions"));
    const json sheet = results_of(shipped_project("tracker-test.covaria"), "decided");
    ASSERT_EQ(sheet["decisions"].size(), 48u);
    EXPECT_EQ(sheet["decisions"].at(0)["subject"], "Decisions after ISO 14253-1: T1, two-face");
    EXPECT_EQ(sheet["decisions"].at(0)["verdict"], "met");
    EXPECT_FALSE(sheet.contains("figures"));
}

TEST(Automation, DecisionsOfTestSheetsAreTestCases) {
    const std::string file = shipped_project("tracker-test.covaria").string();
    const Outcome met = run_program({"check", file, "--first-order"});
    EXPECT_EQ(met.status, 0) << met.out << met.err;
    EXPECT_NE(met.out.find("met     acceptance/Decisions after ISO 14253-1: T1, two-face\n"),
              std::string::npos)
        << met.out;
    const Outcome failed = run_program(
        {"check", file, "--first-order", "--set", "/analyses/acceptance/setup/length_constant=25"});
    EXPECT_EQ(failed.status, 3) << failed.out << failed.err;
    EXPECT_NE(failed.out.find("not decided; "), std::string::npos) << failed.out;
    EXPECT_NE(failed.out.find("MPE = "), std::string::npos) << failed.out;
}

}  // namespace
}  // namespace covaria::automation_test
