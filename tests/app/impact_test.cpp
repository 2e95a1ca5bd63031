// covaria impact: the invented three years of a gauge block, their reports among them; what cannot be
// evaluated, what is written, exit statuses; covaria check judges the certificates.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/program.h"

namespace impact_command_test {

namespace {

namespace fs = std::filesystem;

const fs::path three_years = fs::path(COVARIA_SOURCE_DIR) / "docs/three-years";

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::size_t count_of(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
}

TEST(ImpactCommand, TellsWhatChangesInReportsAndProjects) {
    const fs::path folder = fresh_folder("archive"), made = fresh_folder("made");
    fs::copy(three_years, folder, fs::copy_options::recursive);
    ASSERT_EQ(run_program({"report", (folder / "2025/customer-a.covaria").string(), "--first-order", "-o",
                           (folder / "2025/customer-a.pdf").string()})
                  .status,
              0);
    const std::string found = (folder / "standard/2026-as-found.covaria").string();
    const Outcome told =
        run_program({"impact", "--replace", "NI 2025-0933", found, (folder / "2024").string(),
                     (folder / "2025").string(), "--first-order", "--csv", (made / "impact.csv").string(),
                     "--amend", (made / "amend.txt").string(), "-o", (made / "impact.pdf").string()});
    EXPECT_EQ(told.status, 0) << told.err;
    EXPECT_TRUE(has(told.out, "9 projects and reports were looked at; 5 use the figures.")) << told.out;
    EXPECT_TRUE(has(told.out, "met -> NOT MET")) << told.out;
    const std::string amend = read_text(made / "amend.txt"), csv = read_text(made / "impact.csv");
    EXPECT_EQ(count_of(amend, "\n"), 5u) << amend;
    EXPECT_TRUE(has(amend, "customer-a.pdf"));
    EXPECT_FALSE(has(amend, "2024"));
    EXPECT_EQ(count_of(csv, "l_X"), 5u) << csv;
    EXPECT_TRUE(read_text(made / "impact.pdf").starts_with("%PDF-"));
}

TEST(ImpactCommand, ListsWhoUsedIt) {
    const Outcome told = run_program({"impact", "--used", "ni 2024-1187", three_years.string()});
    EXPECT_EQ(told.status, 0);
    EXPECT_EQ(count_of(told.out, "2024/customer-"), 4u) << told.out;
    EXPECT_TRUE(has(told.out, "standard/2024.covaria"));
}

TEST(ImpactCommand, NamesWhatCannotBeEvaluated) {
    const fs::path folder = fresh_folder("archive");
    fs::copy(three_years / "2025", folder, fs::copy_options::recursive);
    write_text(folder / "broken.covaria", "{");
    const std::string found = (three_years / "standard/2026-as-found.covaria").string();
    const Outcome told =
        run_program({"impact", "--replace", "NI 2025-0933", found, folder.string(), "--first-order"});
    EXPECT_EQ(told.status, 1);
    EXPECT_TRUE(has(told.err, "broken.covaria: not evaluated")) << told.err;
    EXPECT_TRUE(has(told.out, "4 use the figures")) << told.out;
}

TEST(ImpactCommand, RefusesWhatIsNoQuestion) {
    EXPECT_EQ(run_program({"impact", three_years.string()}).status, 2);
    EXPECT_EQ(run_program({"impact", "--used", "x", "--replace", "x", "y", three_years.string()}).status, 2);
    EXPECT_EQ(run_program({"impact", "--used", "x", "/nowhere/at/all"}).status, 1);
    const std::string out = (fresh_folder("refused") / "impact").string();
    for (const auto& [option, value] : {std::pair("--csv", out + ".csv"),
                                        {"-o", out + ".pdf"},
                                        {"--amend", out + ".txt"},
                                        {"--trials", "2000"}})
        EXPECT_EQ(run_program({"impact", "--used", "x", three_years.string(), option, value}).status, 2)
            << option << ": nothing is evaluated that it could be of";
}

TEST(CheckCommand, JudgesCertificates) {
    const Outcome applicable =
        run_program({"check", (three_years / "2025/customer-a.covaria").string(), "--first-order"});
    EXPECT_EQ(applicable.status, 0) << applicable.out;
    EXPECT_TRUE(has(applicable.out, "certificate NI 2025-0933")) << applicable.out;
    const Outcome expired =
        run_program({"check", (three_years / "2025/customer-d.covaria").string(), "--first-order"});
    EXPECT_EQ(expired.status, 3) << expired.out;
    EXPECT_TRUE(has(expired.out, "expired; it was valid until 2026-01-31")) << expired.out;
}

}  // namespace

}  // namespace impact_command_test
