// covaria import-urdf: a new project, an existing one, and what is refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const char* const arm =
    "<robot name=\"Two Links\">\n"
    "<joint name=\"shoulder\" type=\"revolute\"><origin xyz=\"0 0 0.4\"/><parent link=\"base\"/><child "
    "link=\"upper\"/>"
    "<axis xyz=\"0 0 1\"/><limit lower=\"-1.5\" upper=\"1.5\"/></joint>\n"
    "<joint name=\"elbow\" type=\"continuous\"><origin xyz=\"0.3 0 0\"/><parent link=\"upper\"/><child "
    "link=\"lower\"/>"
    "<axis xyz=\"0 1 0\"/></joint>\n"
    "<joint name=\"end\" type=\"fixed\"><origin xyz=\"0.2 0 0\"/><parent link=\"lower\"/><child "
    "link=\"tool0\"/></joint>\n"
    "</robot>\n";

TEST(ImportUrdf, WritesAProjectAndAddsToIt) {
    const fs::path folder = fresh_folder("urdf");
    write_text(folder / "arm.urdf", arm);
    const std::string file = (folder / "arm.urdf").string(), project = (folder / "arm.covaria").string();
    for (int time = 1; time <= 2; ++time) {
        const Outcome done = run_program({"import-urdf", file, "-o", project});
        ASSERT_EQ(done.status, 0) << done.err;
        EXPECT_EQ(run_program({"validate", project}).status, 0);
        EXPECT_EQ(json::parse(read_text(project)).at("assets").size(), static_cast<std::size_t>(time));
    }
    const json assets = json::parse(read_text(project)).at("assets");
    EXPECT_EQ(assets[0].at("id"), "two-links");
    EXPECT_EQ(assets[1].at("id"), "two-links-2");
    EXPECT_EQ(assets[0].at("setup").at("joints").at("rows").size(), 2u);
}

TEST(ImportUrdf, SaysWhatItTookAndFreezesJoints) {
    const fs::path folder = fresh_folder("urdf-freeze");
    write_text(folder / "arm.urdf", arm);
    const std::string file = (folder / "arm.urdf").string(), project = (folder / "arm.covaria").string();
    const Outcome done = run_program({"import-urdf", file, "-o", project, "--freeze", "shoulder=30"});
    ASSERT_EQ(done.status, 0) << done.err;
    for (const char* words : {"1 joint from link base to link tool0", "joint 1: elbow, turns, without limits",
                              "shoulder: frozen at 30°", "the tool stands at (433.013, 250, 400) mm"})
        EXPECT_NE(done.out.find(words), std::string::npos) << words << "\n" << done.out;
    for (const char* wrong : {"shoulder", "shoulder=", "=3", "shoulder=3 mm", "elbo=1"})
        EXPECT_EQ(run_program({"import-urdf", file, "-o", project, "--freeze", wrong}).status, 1) << wrong;
}

TEST(ImportUrdf, SaysWhatItDoesNotUnderstand) {
    const fs::path folder = fresh_folder("urdf-bad");
    write_text(folder / "bad.urdf", "<robot name=\"x\"></robot>");
    const std::string project = (folder / "out.covaria").string();
    const Outcome empty = run_program({"import-urdf", (folder / "bad.urdf").string(), "-o", project});
    EXPECT_EQ(empty.status, 1);
    EXPECT_NE(empty.err.find("bad.urdf:1: the file has no moving joint"), std::string::npos) << empty.err;
    EXPECT_FALSE(fs::exists(project));
    const Outcome missing = run_program({"import-urdf", (folder / "none.urdf").string(), "-o", project});
    EXPECT_EQ(missing.status, 1);
    EXPECT_NE(missing.err.find("cannot be read"), std::string::npos) << missing.err;
    EXPECT_EQ(run_program({"import-urdf", "a.urdf"}).status, 2);
}

TEST(ImportUrdf, IsWhatImportDoes) {
    const fs::path folder = fresh_folder("urdf-import");
    write_text(folder / "arm.urdf", arm);
    const std::string file = (folder / "arm.urdf").string(), project = (folder / "arm.covaria").string(),
                      other = (folder / "other.covaria").string();
    const Outcome shown = run_program({"import", file});
    ASSERT_EQ(shown.status, 0) << shown.err;
    for (const char* words : {"Robot description (URDF)", "2 joints from link base to link tool0",
                              "joint 1: shoulder", "Nothing was written"})
        EXPECT_NE(shown.out.find(words), std::string::npos) << words << "\n" << shown.out;
    ASSERT_EQ(run_program({"import", file, "-o", project}).status, 0);
    ASSERT_EQ(run_program({"import-urdf", file, "-o", other}).status, 0);
    EXPECT_EQ(read_text(project), read_text(other));
    EXPECT_EQ(run_program({"import", file, "-o", project}).status, 1) << "nothing is overwritten";
    ASSERT_EQ(run_program({"import", file, "-o", project, "--add", "--freeze", "shoulder=30"}).status, 0);
    const json assets = json::parse(read_text(project)).at("assets");
    ASSERT_EQ(assets.size(), 2u);
    EXPECT_EQ(assets[1].at("setup").at("joints").at("rows").size(), 1u);
    write_text(folder / "bad.urdf", "<robot name=\"x\"></robot>");
    const Outcome bad = run_program({"import", (folder / "bad.urdf").string()});
    EXPECT_EQ(bad.status, 1);
    EXPECT_NE(bad.err.find("bad.urdf:1: the file has no moving joint"), std::string::npos) << bad.err;
}

}  // namespace
