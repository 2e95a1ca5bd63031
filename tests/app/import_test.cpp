// covaria import: shown, written, added; what is asked for and what is refused.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace import_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string data = std::string(COVARIA_SOURCE_DIR) + "/tests/data/readers/";

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST(Import, ShowsWritesAndAddsButNeverOverwrites) {
    const std::string project = (fresh_folder("import") / "points.covaria").string();
    const Outcome shown = run_program({"import", data + "points.csv"});
    ASSERT_EQ(shown.status, 0) << shown.err;
    for (const char* words :
         {"read as Table of points", "x [m]", "not taken over", "'Notes'", "Nothing was written"})
        EXPECT_TRUE(has(shown.out, words)) << words << "\n" << shown.out;
    ASSERT_EQ(run_program({"import", data + "points.csv", "-o", project}).status, 0);
    const Outcome valid = run_program({"validate", project});
    EXPECT_EQ(valid.status, 0) << valid.err;
    const std::string before = read_text(project);
    const Outcome again = run_program({"import", data + "points.csv", "-o", project});
    EXPECT_EQ(again.status, 1);
    EXPECT_TRUE(has(again.err, "exists already")) << again.err;
    EXPECT_EQ(read_text(project), before);
    ASSERT_EQ(run_program({"import", data + "points.csv", "-o", project, "--add"}).status, 0);
    const json assets = json::parse(read_text(project)).at("assets");
    ASSERT_EQ(assets.size(), 2u);
    EXPECT_EQ(assets[1].at("id"), "points-2");
    EXPECT_EQ(run_program({"validate", project}).status, 0);
}

TEST(Import, AsksForWhatTheFileDoesNotSay) {
    const Outcome unclear = run_program({"import", data + "sa-groups.txt"});
    EXPECT_EQ(unclear.status, 2);
    EXPECT_TRUE(has(unclear.err, "--columns")) << unclear.err;
    EXPECT_EQ(run_program({"import", data + "sa-groups.txt", "--as", "spatialanalyzer"}).status, 0);
    const Outcome stated =
        run_program({"import", data + "sa-groups.txt", "--columns", "group,name,x,y,z,-,-,-", "--unit", "m"});
    EXPECT_EQ(stated.status, 0) << stated.err;
    EXPECT_TRUE(has(stated.out, "x [m]")) << stated.out;
    const Outcome mistyped = run_program({"import", data + "points.csv", "--as", "pionts"});
    EXPECT_EQ(mistyped.status, 2);
    EXPECT_TRUE(has(mistyped.err, "did you mean 'points'")) << mistyped.err;
    EXPECT_EQ(run_program({"import", data + "points.csv", "--unit", "kg"}).status, 2);
    EXPECT_EQ(run_program({"import"}).status, 2);
}

// A column that is not understood is asked about with what can be typed, and what was typed then reads it.
TEST(Import, AsksAboutColumnsAndMendsCellsOfABudget) {
    const std::string file = data + "budgets/unknown-unit.xlsx";
    const Outcome asked = run_program({"import", file});
    EXPECT_EQ(asked.status, 2);
    EXPECT_TRUE(has(asked.err, "column E 'Xyzzy'")) << asked.err;
    EXPECT_TRUE(has(asked.err, "name,value,unit,u,?")) << asked.err;
    const std::vector<std::string> stated{"import", file, "--columns", "?,?,?,?,-"};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> words = stated;
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words);
    };
    const Outcome unknown = with({});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_TRUE(has(unknown.err, "B!C3")) << unknown.err;
    EXPECT_TRUE(has(unknown.err, "--cell PLACE=TEXT")) << unknown.err;
    const Outcome mended = with({"--cell", "C3=mm"}), without = with({"--leave-out", "3"});
    EXPECT_EQ(mended.status, 0) << mended.err;
    EXPECT_EQ(without.status, 0) << without.err;
    EXPECT_TRUE(has(mended.out, "43 quantities")) << mended.out;
    EXPECT_TRUE(has(without.out, "42 quantities")) << without.out;
    EXPECT_TRUE(has(without.out, "row 3 was left out")) << without.out;
    EXPECT_EQ(run_program({"import", data + "points.csv", "--cell", "C3=mm"}).status, 2);
}

// Sheets of laboratories: heads of DAkkS-DKD-3 and M3003, a difference in degrees Celsius.
TEST(Import, ReadsTheBudgetsOfLaboratories) {
    struct Case {
        const char *file, *words;
    };
    for (const Case& c :
         {Case{"budget-sensitivitaet", "y = 2*lS + 3*dx"}, Case{"b5", "y = 2*lS + 3*dx"},
          Case{"budget-m3003", "U(y), k = 2: the file states 0.052 µm"}, Case{"degc-a", "in K"},
          Case{"degc-b", "in K"}, Case{"degc-c", "in K"}, Case{"degc-d", "u(y) by its contributions"}}) {
        const Outcome read = run_program({"import", data + "budgets/" + c.file + ".xlsx"});
        EXPECT_EQ(read.status, 0) << c.file << read.err;
        EXPECT_TRUE(has(read.out, c.words)) << c.file << read.out;
        EXPECT_FALSE(has(read.out, "FIND OUT WHY")) << c.file << read.out;
    }
}

TEST(Import, ListsItsReaders) {
    const Outcome list = run_program({"import", "--list"});
    EXPECT_EQ(list.status, 0);
    for (const char* reader : {"spatialanalyzer", "points", "dcc", "gsi", "gama", "comp3d"})
        EXPECT_TRUE(has(list.out, reader)) << list.out;
}

TEST(Import, NamesFileLineAndColumn) {
    const fs::path folder = fresh_folder("import-bad");
    write_text(folder / "bad.csv", "name,x,y,z\na,1,2,three\n");
    const Outcome bad =
        run_program({"import", (folder / "bad.csv").string(), "-o", (folder / "o.covaria").string()});
    EXPECT_EQ(bad.status, 1);
    EXPECT_TRUE(has(bad.err, "bad.csv:2: column 4: (z) 'three' is not a number")) << bad.err;
    EXPECT_FALSE(fs::exists(folder / "o.covaria"));
}

TEST(Import, RefusesWhatIsNoFileAndWhatIsTooLarge) {
    const fs::path folder = fresh_folder("import-kinds"), pipe = folder / "pipe.txt",
                   large = folder / "large.txt";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    write_text(large, "A 1 2 3\n");
    fs::resize_file(large, 1'000'000'000);  // sparse
    for (const auto& [file, words] : {std::pair<std::string, const char*>{pipe.string(), "a pipe"},
                                      {folder.string(), "a folder"},
                                      {"/dev/zero", "a device"},
                                      {large.string(), "1000 MB"},
                                      {(folder / "none").string(), "cannot be read"}}) {
        const Outcome run = run_program({"import", file});
        EXPECT_EQ(run.status, 1) << file;
        EXPECT_TRUE(has(run.err, words)) << run.err;
    }
    fs::remove(large);
}

}  // namespace

}  // namespace import_test
