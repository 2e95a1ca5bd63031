// Project files of every version, with the kinds that the program has.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/made/load_project.h"
#include "core/project/project_file.h"
#include "core/project/project_text.h"

namespace covaria::migration_test {
namespace {

std::filesystem::path sample(int version) {
    return std::filesystem::path(COVARIA_SOURCE_DIR) / "tests/data/projects" /
           ("version-" + std::to_string(version) + ".covaria");
}

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

std::string all_messages(const Problems& problems) {
    std::string all;
    for (const Problem& problem : problems.items())
        all += problem.path + ": " + problem.message.english() + "\n";
    return all;
}

std::string robot_of(const Project& project, const std::string& analysis) {
    return std::get<std::string>(project.find_analysis(analysis)->setup.values.at("robot"));
}

TEST(Migration, EveryVersionLoads) {
    for (int version = 0; version < project_schema_version; ++version) {
        const LoadedProject loaded = load_project(sample(version));
        EXPECT_EQ(all_messages(loaded.problems), "") << version;
        EXPECT_FALSE(loaded.project.title.empty());
        const LoadedProject again = parse_project(project_text(loaded.project), {}, "again");
        EXPECT_EQ(project_text(again.project), project_text(loaded.project)) << version;
    }
}

TEST(Migration, AnIdentifiedRobotIsTheAnalysisThatIdentifiesIt) {
    const LoadedProject loaded = load_project(sample(1));
    const Project& project = loaded.project;
    ASSERT_EQ(all_messages(loaded.problems), "");
    ASSERT_EQ(project.assets.size(), 1u);
    ASSERT_EQ(project.analyses.size(), 4u);
    EXPECT_EQ(robot_of(project, "of-trajectories"), "trajectories") << "which has the same set-up";
    EXPECT_EQ(robot_of(project, "fit"), "fit-2") << "an analysis was called fit";
    EXPECT_EQ(project.analyses[3].model, "robot-calibration");
    EXPECT_EQ(project.analyses[3].notes, "An analysis has this id, too.");
    const auto made = MadeProject::make(project);
    for (const char* id : {"of-trajectories", "fit"}) {
        const auto analysis = made->analysis(id);
        ASSERT_TRUE(analysis) << id;
        // The robot is evaluated in every trial: down to the points that identify it.
        EXPECT_GE(analysis->inputs.components.size(), 60u) << id;
        EXPECT_EQ(analysis->assets.find("by-trajectories"), nullptr);
    }
}

TEST(Migration, ProblemsStandWhereTheyStoodInTheFile) {
    std::string text = text_of(sample(1));
    const std::string name = "ER10L-C10, nominal";
    text.replace(text.find(name) - 1, name.size() + 2, "7");
    text.replace(text.find("\"pose_count\": 20"), 16, "\"pose_count\": -3");
    const LoadedProject loaded = parse_project(text, {}, "file");
    const auto line_of = [&](const std::string& part) {
        const std::size_t at = text.find(part);
        return 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
    };
    int robot = 0, count = 0;
    for (const Problem& problem : loaded.problems.items()) {
        if (problem.path == "/assets/0/name") robot = problem.line;
        if (problem.path == "/analyses/3/setup/pose_count") count = problem.line;
    }
    EXPECT_EQ(robot, line_of("\"er10l-nominal\", \"kind\"")) << all_messages(loaded.problems);
    EXPECT_EQ(count, line_of("\"calibrated-robot\"")) << all_messages(loaded.problems);
}

}  // namespace
}  // namespace covaria::migration_test
