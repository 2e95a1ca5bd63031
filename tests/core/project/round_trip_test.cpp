// A project that is loaded and saved comes back byte for byte; older versions are brought up.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/project/project_text.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::round_trip_test {

namespace {

std::string all_messages(const Problems& problems) {
    std::string all;
    for (const Problem& problem : problems.items())
        all += problem.path + ": " + problem.message.english() + "\n";
    return all;
}

}  // namespace

TEST(RoundTrip, CanonicalTextComesBackByteForByte) {
    const LoadedProject loaded = parse(whole_project);
    ASSERT_EQ(all_messages(loaded.problems), "");
    EXPECT_EQ(project_text(loaded.project), whole_project);
}

TEST(RoundTrip, ValuesAreReadAsTyped) {
    const Project project = parse(whole_project).project;
    const covaria::Setup& setup = project.find_asset("block-1")->setup;
    EXPECT_EQ(std::get<Quantity>(setup.values.at("temperature_deviation")), (Quantity{0.7, Unit::of("K")}));
    EXPECT_EQ(std::get<Quantity>(setup.values.at("freedom")).value, infinity);
    const SetupTable& points = std::get<SetupTable>(setup.values.at("points"));
    EXPECT_EQ(points.units[2], Unit::of("um"));
    ASSERT_EQ(points.rows.size(), 3u);
    EXPECT_EQ(std::get<double>(points.rows[1][2]), 12345678.9);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(points.rows[1][3]));
    const AnalysisEntry& analysis = *project.find_analysis("sum-1");
    EXPECT_EQ(analysis.options.seed, 18446744073709551615u);
    EXPECT_EQ(analysis.options.method, Method::adaptive);
    const auto& components = *analysis.inputs[0].components;
    EXPECT_EQ(components[1].type, EvaluationType::type_a);
    EXPECT_EQ(components[2].parameters, (std::vector<double>{-1, 1, 0.5, 0.5}));
    EXPECT_EQ(components[2].degrees_of_freedom, infinity);
    EXPECT_TRUE(analysis.inputs[1].components && analysis.inputs[1].components->empty());
}

TEST(RoundTrip, ColumnsInAnyOrderBecomeCanonical) {
    const std::string given = changed(R"("columns": ["point", "value [mm]"],
          "rows": [])",
                                      R"("columns": ["value [um]", "point"], "rows": [[12, "b1"]])");
    const LoadedProject loaded = parse(given);
    ASSERT_EQ(all_messages(loaded.problems), "");
    EXPECT_EQ(project_text(loaded.project), changed(R"("value [mm]"],
          "rows": [])",
                                                    R"("value [um]"],
          "rows": [
            ["b1", 12]
          ])"));
}

TEST(RoundTrip, EmptyOptionalColumnInAnotherUnitIsKept) {
    const std::string given = changed(R"("u [um]", "used"],
          "rows": [
            ["b1", -344, 196000, 0.066, true])",
                                      R"("u [mm]", "used"],
          "rows": [
            ["b1", -344, 196000, null, true])");
    const LoadedProject loaded = parse(given);
    EXPECT_EQ(all_messages(loaded.problems), "");
    EXPECT_EQ(project_text(loaded.project), given);
}

TEST(RoundTrip, EmptyProject) {
    Project project;
    project.title = "new";
    const LoadedProject loaded = parse(project_text(project));
    EXPECT_EQ(all_messages(loaded.problems), "");
    EXPECT_TRUE(loaded.project == project);
}

TEST(RoundTrip, InfiniteLimitsOfComponents) {
    const std::string given = changed(
        R"("normal", "parameters": {"mean": 0, "standard_deviation": 3})",
        R"("truncated-normal", "parameters": {"mean": 0, "standard_deviation": 3, "low": null, "high": null})");
    const LoadedProject loaded = parse(given);
    EXPECT_EQ((*loaded.project.analyses.at(0).inputs.at(0).components).at(0).parameters,
              (std::vector<double>{0, 3, -infinity, infinity}));
    EXPECT_EQ(project_text(loaded.project), given);
}

TEST(RoundTrip, WhatCannotBeWrittenIsNotSaved) {
    const auto folder = fresh_folder("unwritable");
    Project project = parse(whole_project).project;
    put_bytes(folder / "p.covaria", "old");
    project.assets[0].setup.values["length"] = Quantity{std::nan(""), Unit::of("mm")};
    const auto saved = save_project(project, folder / "p.covaria");
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().message.english().find("not finite"), std::string::npos);
    project = parse(whole_project).project;
    project.assets[0].setup.values["lenght"] = Quantity{1.0};
    EXPECT_FALSE(save_project(project, folder / "p.covaria"));
    EXPECT_EQ(bytes_of(folder / "p.covaria"), "old");
}

TEST(Migration, EvaluationsBecomeAnalyses) {
    std::string old = changed("\"schemaVersion\": 2", "\"schemaVersion\": 0");
    old.replace(old.find("\"analyses\""), 10, "\"evaluations\"");
    const LoadedProject loaded = parse(old);
    EXPECT_EQ(all_messages(loaded.problems), "");
    EXPECT_EQ(project_text(loaded.project), whole_project);
}

TEST(Migration, NewerVersionIsLeftAlone) {
    const LoadedProject loaded = parse(changed("\"schemaVersion\": 2", "\"schemaVersion\": 7"));
    const Problem problem = problem_with(loaded.problems, "newer version");
    EXPECT_EQ(problem.message.english(),
              "written by a newer version of Covaria (schema 7, this program reads up to 2); "
              "nothing was changed");
    EXPECT_EQ(problem.line, 3);
    EXPECT_EQ(loaded.problems.items().size(), 1u);
}

TEST(Fingerprint, FollowsNumbersOnly) {
    const Project project = parse(whole_project).project;
    const std::string before = fingerprint(project);
    EXPECT_EQ(before.size(), 16u);
    Project named = project;
    named.title = named.assets[0].name = named.analyses[0].notes = "other";
    named.analyses[0].inputs[0].components->at(0).origin = "elsewhere";
    EXPECT_EQ(fingerprint(named), before);
    Project hotter = project;
    hotter.assets[0].setup.values["temperature_deviation"] = Quantity{0.8, Unit::of("K")};
    EXPECT_NE(fingerprint(hotter), before);
    Project reseeded = project;
    reseeded.analyses[0].options.seed = 2;
    EXPECT_NE(fingerprint(reseeded), before);
}

TEST(Fingerprint, CountsCsvRowsNotTheFileName) {
    Project project = parse(whole_project).project;
    const std::string before = fingerprint(project);
    SetupTable& points = std::get<SetupTable>(project.assets[0].setup.values["points"]);
    points.csv_file = "points.csv";
    EXPECT_EQ(fingerprint(project), before);
    points.rows[0][1] = -345.0;
    EXPECT_NE(fingerprint(project), before);
}

TEST(JsonSchema, ParsesAndNamesEveryKeyOfTheFormat) {
    const auto schema = nlohmann::json::parse(
        bytes_of(std::filesystem::path(COVARIA_SOURCE_DIR) / "resources/schema/covaria-project.schema.json"));
    const auto project = nlohmann::json::parse(whole_project);
    for (const auto& [key, value] : project.items()) EXPECT_TRUE(schema["properties"].contains(key)) << key;
    const auto& definitions = schema["$defs"];
    for (const auto& [key, value] : project["assets"][0].items())
        EXPECT_TRUE(definitions["asset"]["properties"].contains(key)) << key;
    for (const auto& [key, value] : project["analyses"][0].items())
        EXPECT_TRUE(definitions["analysis"]["properties"].contains(key)) << key;
    for (const auto& [key, value] : project["analyses"][0]["options"].items())
        EXPECT_TRUE(definitions["options"]["properties"].contains(key)) << key;
    for (const auto& [key, value] : project["analyses"][0]["inputs"][0].items())
        EXPECT_TRUE(definitions["inputEdit"]["properties"].contains(key)) << key;
}

}  // namespace covaria::test::round_trip_test
