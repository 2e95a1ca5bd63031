// The promises of the shipped examples and the front page: certificates that lack nothing, published figures,
// and the figures of the README as the program prints them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.h"

namespace examples_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string example(const std::string& name) {
    return shipped_project(name + ".covaria").string();
}

json results_of(const std::string& project, const std::vector<std::string>& more = {}) {
    const fs::path folder = fresh_folder("example-results");
    std::vector<std::string> words{"run", project, "--no-studies", "--out", folder.string()};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(read_text(folder / "results.json"));
}

const json& output_of(const json& analysis, const std::string& symbol, const std::string& group = "") {
    for (const json& output : analysis.at("outputs"))
        if (output.at("symbol") == symbol && output.at("group") == group) return output;
    ADD_FAILURE() << group << " " << symbol;
    return analysis.at("outputs").at(0);
}

std::string fixed(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

/// "1,616".
std::string with_commas(std::size_t number) {
    std::string digits = std::to_string(number);
    for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), ",");
    return digits;
}

TEST(Examples, CertificatesLackNothing) {
    for (const char* name : {"certificate-gauge-block", "gewichtsstueck"}) {
        const Outcome valid = run_program({"validate", example(name), "--certificate"});
        EXPECT_EQ(valid.status, 0) << valid.err;
        EXPECT_EQ(valid.err, "");
        const fs::path file = fresh_folder("example-certificate") / "certificate.html";
        const Outcome made = run_program({"report", example(name), "--certificate", "-o", file.string()});
        EXPECT_EQ(made.status, 0) << made.err;
        EXPECT_EQ(made.err, "") << "nothing is missing";
        const fs::path digital = file.parent_path() / "certificate.xml";
        const Outcome exported =
            run_program({"export", example(name), "--as", "dcc", "-o", digital.string()});
        EXPECT_EQ(exported.status, 0) << exported.err;
    }
    EXPECT_NE(read_text(shipped_project("gewichtsstueck.covaria")).find("\"language\": \"de\""),
              std::string::npos);
}

/// EA-4/02 M:2022, S2: 10.000 025 kg, u = 29.3 mg, U = 59 mg.
TEST(Examples, TheWeightHasThePublishedFigures) {
    const json output = output_of(results_of(example("gewichtsstueck")).at("analyses").at(0), "m_X");
    EXPECT_EQ(output.at("unit"), "g");
    EXPECT_NEAR(output.at("estimate"), 10000.025, 1e-9);
    EXPECT_EQ(fixed(1000 * output.at("standardUncertainty").get<double>(), 1), "29.3");
    EXPECT_EQ(fixed(1000 * output.at("expandedUncertainty").get<double>(), 0), "59");
}

/// sqrt(15^2 + 30^2/6 + 5.4^2 + 32^2/3 + (50 mm x 11.5e-6/K x 0.05 K)^2/3 + 6.7^2/3 + second order) nm.
TEST(Examples, TheGaugeBlockHasTheFiguresOfItsBudget) {
    const json output = output_of(
        results_of(example("certificate-gauge-block"), {"--first-order"}).at("analyses").at(0), "l_X");
    const double temperature = 50e6 * 11.5e-6 * 0.05;  // nm
    const double u = std::sqrt(15 * 15 + 30 * 30 / 6.0 + 5.4 * 5.4 + 32 * 32 / 3.0 +
                               temperature * temperature / 3 + 6.7 * 6.7 / 3);
    EXPECT_NEAR(1e6 * output.at("standardUncertainty").get<double>(), u, 1e-6);
    EXPECT_NEAR(output.at("estimate"), 49.999926, 1e-12);
}

TEST(Examples, TheMicrometerConformsUnderEveryRequirement) {
    const Outcome check = run_program({"check", example("conformity-micrometer")});
    EXPECT_EQ(check.status, 0) << check.err;
    EXPECT_NE(check.out.find("4 requirements, 0 not met"), std::string::npos) << check.out;
    // A narrower tolerance: the guard band is what is left.
    const Outcome narrow = run_program({"check", example("conformity-micrometer"), "--set",
                                        "/analyses/errors/requirements/3/upperLimit/value=2.5"});
    EXPECT_EQ(narrow.status, 3) << narrow.out << narrow.err;
}

TEST(Examples, TheBudgetFromExcelIsWhatTheImportMakes) {
    const fs::path made = fresh_folder("example-excel") / "excel-budget.covaria";
    const Outcome import =
        run_program({"import", shipped_project("excel-budget.xlsx").string(), "-o", made.string()});
    ASSERT_EQ(import.status, 0) << import.err;
    const json ours = json::parse(read_text(example("excel-budget"))), theirs = json::parse(read_text(made));
    EXPECT_EQ(ours.at("analyses").at(0).at("setup"), theirs.at("analyses").at(0).at("setup"));
}

TEST(FrontPage, HasTheFiguresThatTheProgramPrints) {
    const std::string page = read_text(fs::path(COVARIA_SOURCE_DIR) / "README.md");
    const json printed =
        results_of(example("stewart-platform"), {"--analysis", "printed"}).at("analyses").at(0);
    const double expanded = output_of(printed, "x", "pose 3").at("expandedUncertainty");
    EXPECT_NE(page.find("U(x) of pose 3 is " + fixed(expanded, 3) + " mm"), std::string::npos) << expanded;
    const Outcome verified = run_program({"verify", "--json"});
    ASSERT_EQ(verified.status, 0) << verified.err;
    const json all = json::parse(verified.out);
    EXPECT_NE(page.find(with_commas(all.at("figures")) + " figures"), std::string::npos) << all.at("figures");
    EXPECT_NE(page.find("evaluates " + std::to_string(all.at("cases").size()) + " shipped cases"),
              std::string::npos)
        << all.at("cases").size();
}

/// Shares of b_1z and b_2z in the budget of x of pose 3.
TEST(FrontPage, HasTheSharesOfTheBudget) {
    const fs::path folder = fresh_folder("front-page-budget");
    ASSERT_EQ(run_program({"run", example("stewart-platform"), "--analysis", "printed", "--first-order",
                           "--out", folder.string()})
                  .status,
              0);
    std::istringstream budget(read_text(folder / "printed-budget.csv"));
    double share = 0.0;
    std::size_t column = 0;
    for (std::string line; std::getline(budget, line);) {
        std::vector<std::string> cells;
        std::istringstream in(line);
        for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
        if (column == 0) {
            while (column < cells.size() && cells[column] != "share of variance") ++column;
            ASSERT_LT(column, cells.size()) << line;
        } else if (cells[0] == "pose 3" && cells[1] == "x" && (cells[3] == "b_1z" || cells[3] == "b_2z")) {
            share += std::stod(cells[column]);
        }
    }
    const std::string page = read_text(fs::path(COVARIA_SOURCE_DIR) / "README.md");
    EXPECT_NE(page.find(fixed(100 * share, 1) + " % of the variance"), std::string::npos) << share;
}

}  // namespace
}  // namespace examples_test
