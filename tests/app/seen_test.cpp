// covaria seen: stated figures against the residuals, on the command line and in results.json.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace seen_test {
namespace {

using nlohmann::json;

const std::string network = shipped_project("seen-network.covaria").string();

TEST(Seen, AContradictedFigureIsSaidAndIsStatusThree) {
    const Outcome run = run_program({"seen", network, "--analysis", "stated"});
    EXPECT_EQ(run.status, 3) << run.err;
    for (const char* words : {"directions", "seen is larger", "agrees", "seen is smaller", "passes"})
        EXPECT_NE(run.out.find(words), std::string::npos) << words << "\n" << run.out;
}

TEST(Seen, ProgramsReadTheSameFiguresAsInTheResults) {
    const Outcome run = run_program({"seen", network, "--analysis", "stated", "--json"});
    EXPECT_EQ(run.status, 3) << run.err;
    const json seen = json::parse(run.out).at("analyses").at(0);
    const auto folder = fresh_folder("seen-results");
    const Outcome evaluated =
        run_program({"run", network, "--first-order", "--analysis", "stated", "--out", folder.string()});
    ASSERT_EQ(evaluated.status, 0) << evaluated.err;
    const json results = json::parse(read_text(folder / "results.json")).at("analyses").at(0).at("seen");
    ASSERT_EQ(results.at("figures").size(), 3u);
    EXPECT_EQ(results.at("figures"), seen.at("figures"));
    double redundancy = 0.0;
    for (const json& figure : results["figures"]) redundancy += figure.at("redundancy").get<double>();
    EXPECT_NEAR(redundancy, results.at("degreesOfFreedom").get<double>(), 1e-6);
    EXPECT_NE(read_text(folder / "stated-seen.csv").find("slope distances"), std::string::npos);
}

TEST(Seen, CheckFailsWhereAFigureIsContradicted) {
    const Outcome run =
        run_program({"check", network, "--analysis", "stated", "--first-order", "--seen", "0.05"});
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_NE(run.out.find("NOT MET stated/seen, directions: seen is larger"), std::string::npos) << run.out;
    EXPECT_EQ(
        run_program({"check", network, "--analysis", "stated", "--first-order", "--seen", "1e-6"}).status, 0);
}

TEST(Seen, WithoutRedundantReadingsItSaysSo) {
    const Outcome run = run_program({"seen", shipped_project("gum/h1-end-gauge.covaria").string()});
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.err.find("no analysis has redundant readings"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace seen_test
