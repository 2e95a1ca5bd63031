// Output of commands for programs, and numbers as programs write them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace json_output_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string gauge = shipped_project("gum/h1-end-gauge.covaria").string();

json printed(const std::vector<std::string>& words, const std::string& format, int status = 0) {
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, status) << run.err;
    const json document = json::parse(run.out, nullptr, false);
    EXPECT_FALSE(document.is_discarded()) << run.out;
    if (document.is_discarded()) return json::object();
    EXPECT_EQ(document.value("format", ""), format);
    EXPECT_EQ(document.value("schemaVersion", 0), 1);
    return document;
}

TEST(JsonOutput, EveryModelAssetAndPartIsDescribed) {
    const json list = printed({"describe", "--json"}, "covaria-description");
    ASSERT_GT(list.at("models").size(), 10u);
    ASSERT_GT(list.at("assets").size(), 10u);
    for (const json& model : list["models"]) {
        const json one = printed({"describe", model.at("id"), "--json"}, "covaria-description").at("model");
        EXPECT_EQ(one.at("title"), model.at("title"));
        EXPECT_FALSE(one.at("fields").empty()) << model;
        for (const json& field : one["fields"]) EXPECT_FALSE(field.at("help").get<std::string>().empty());
    }
    for (const json& asset : list["assets"])
        EXPECT_FALSE(printed({"describe", asset.at("kind"), "--json"}, "covaria-description")
                         .at("asset")
                         .at("fields")
                         .empty());
    for (const json& part : list["parts"])
        EXPECT_TRUE(printed({"describe", part.at("name"), "--json"}, "covaria-description")
                        .at("part")
                        .at("schema")
                        .contains("properties"))
            << part;
}

TEST(JsonOutput, FieldsHaveUnitsRangesAndDefaults) {
    const json bar = printed({"describe", "pose-from-points", "--json"}, "covaria-description").at("model");
    const auto field = [&](const std::string& key) {
        for (const json& one : bar.at("fields"))
            if (one.at("key") == key) return one;
        ADD_FAILURE() << key;
        return json::object();
    };
    const json points = field("base_points");
    EXPECT_EQ(points.at("kind"), "table");
    EXPECT_EQ(points.at("columns").at(1).at("unit"), "mm");
}

TEST(JsonOutput, TheLibraryHasItsFigures) {
    const json all = printed({"library", "--json"}, "covaria-library");
    EXPECT_GT(all.at("items").size(), 20u);
    const json found = printed({"library", "search", "at960", "--json"}, "covaria-library");
    ASSERT_GE(found.at("items").size(), 1u);
    const json item = printed({"library", "show", found["items"][0].at("id"), "--json"}, "covaria-library");
    EXPECT_EQ(item.at("item").at("name"), found["items"][0].at("name"));
    EXPECT_TRUE(item["item"].at("setup").is_object());
    printed({"library", "search", "no-such-thing", "--json"}, "covaria-library", 1);
}

TEST(JsonOutput, ProblemsHavePlaces) {
    const json right = printed({"validate", gauge, "--json"}, "covaria-validation");
    EXPECT_EQ(right.at("valid"), true);
    EXPECT_EQ(right.at("analyses"), 2);
    const json wrong =
        printed({"validate", gauge, "--json", "--set", "/analyses/table/setup/quantities/rows/l_S/a=-1"},
                "covaria-validation", 1);
    EXPECT_EQ(wrong.at("valid"), false);
    ASSERT_GE(wrong.at("problems").size(), 1u);
    const json& problem = wrong["problems"][0];
    EXPECT_EQ(problem.at("severity"), "error");
    EXPECT_NE(problem.at("path").get<std::string>().find("/quantities"), std::string::npos) << problem;
    EXPECT_FALSE(problem.at("message").get<std::string>().empty());
}

TEST(JsonOutput, BytesThatAreNoTextAreReplaced) {
    const fs::path folder = fresh_folder("json-bytes");
    const std::string file = (folder / "bad-\xFF.covaria").string();
    write_text(file, "{\"format\": \"covaria\", \"title\": \"\x01\"}");
    EXPECT_FALSE(printed({"validate", file, "--json"}, "covaria-validation", 1).at("problems").empty());
}

TEST(JsonOutput, ADesignIsPrintedAsItIsWritten) {
    const fs::path folder = fresh_folder("json-design");
    const std::string file = shipped_project("ballbar-design.covaria").string();
    const Outcome run = run_program({"design", file, "--json", "--out", folder.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, read_text(folder / "design-points-twelve.json"));
}

TEST(JsonOutput, VerificationHasEveryFigure) {
    const json all = printed({"verify", "--json"}, "covaria-verification");
    std::size_t figures = 0, passed = 0;
    for (const json& one : all.at("cases"))
        for (const json& figure : one.at("figures")) {
            ++figures;
            passed += figure.at("passed").get<bool>();
            EXPECT_FALSE(figure.at("value").is_null()) << figure;
        }
    EXPECT_GT(figures, 5000u);
    EXPECT_EQ(all.at("figures"), figures);
    EXPECT_EQ(all.at("passed"), passed);
}

TEST(Numbers, OfTrialsMayHaveAPowerOfTen) {
    const fs::path folder = fresh_folder("numbers");
    std::string bytes;
    for (const char* trials : {"20000", "2e4", "2E+4", "2.0e4", "0.2e5", "020000"}) {
        const Outcome run = run_program(
            {"run", gauge, "--trials", trials, "--seed", "1e3", "--threads", "2", "--out", folder.string()});
        ASSERT_EQ(run.status, 0) << trials << run.err;
        const std::string now = read_text(folder / "results.json");
        EXPECT_EQ(json::parse(now)["analyses"][0].at("trials"), 20000) << trials;
        if (bytes.empty()) bytes = now;
        EXPECT_EQ(now, bytes) << trials;
    }
    for (const char* trials : {"1e-3", "1.5", "1e", "e6", "", "1e6 ", "1e30", "99999999999999999999", "1,000",
                               "0x10", "inf", "nan", "2e4e1", "1"}) {
        const Outcome run = run_program({"run", gauge, "--trials", trials, "--out", folder.string()});
        EXPECT_EQ(run.status, 2) << trials;
        EXPECT_NE(run.err.find("--trials"), std::string::npos) << run.err;
    }
    // Exact where a double is not.
    const Outcome seed = run_program(
        {"run", gauge, "--trials", "1e3", "--seed", "18446744073709551615", "--out", folder.string()});
    ASSERT_EQ(seed.status, 0) << seed.err;
    EXPECT_NE(read_text(folder / "results.json").find("18446744073709551615"), std::string::npos);
}

}  // namespace
}  // namespace json_output_test
