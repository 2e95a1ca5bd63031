// Messages on damaged projects name things as people see them: no ids, no paths of the file.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/kinds/registries.h"
#include "core/made/load_project.h"
#include "core/project/project_text.h"
#include "tests/core/shipped_projects.h"

namespace covaria::messages_test {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_damages = 40;  // damages of one project

/// Texts that are the id of an asset or analysis become another one that no word can be mistaken for.
void rename_ids(Json& node, const std::map<std::string, std::string>& ids) {
    if (node.is_string()) {
        if (const auto found = ids.find(node.get<std::string>()); found != ids.end()) node = found->second;
    }
    for (Json& part : node)
        if (node.is_structured()) rename_ids(part, ids);
}

/// Kinds and choices, which an id may be equal to.
std::set<std::string> words_of_files() {
    std::set<std::string> words;
    const auto add = [&](const SetupSchema& schema) {
        for (const FieldSpec& field : schema.fields()) {
            for (const Choice& choice : field.choices) words.insert(choice.key);
            for (const ColumnSpec& column : field.columns) {
                words.insert(column.key);
                for (const Choice& choice : column.choices) words.insert(choice.key);
            }
        }
    };
    for (const ModelDescriptor& model : model_registry()) {
        words.insert(model.id);
        add(model.schema);
    }
    for (const AssetDescriptor& kind : asset_registry()) {
        words.insert(kind.kind);
        add(kind.schema);
    }
    return words;
}

/// The project with ids "qz0-id", "qz1-id" ... and names "Thing 0", "Thing 1" ...
Json with_plain_ids(const std::filesystem::path& file) {
    std::ifstream in(file);
    Json project = Json::parse(in);
    const std::set<std::string> words = words_of_files();
    std::map<std::string, std::string> ids;
    for (const char* list : {"assets", "analyses"})
        for (Json& entry : project.value(list, Json::array()))
            if (const std::string id = entry.at("id").get<std::string>(); !words.contains(id))
                ids.try_emplace(id, "qz" + std::to_string(ids.size()) + "-id");
    rename_ids(project, ids);
    std::size_t number = 0;
    for (const char* list : {"assets", "analyses"})
        if (project.contains(list))
            for (Json& entry : project[list]) entry["name"] = "Thing " + std::to_string(number++);
    return project;
}

void collect_leaves(const Json& node, const Json::json_pointer& at, std::vector<Json::json_pointer>& leaves) {
    if (!node.is_structured()) return leaves.push_back(at);
    if (node.is_object())
        for (const auto& [key, part] : node.items()) collect_leaves(part, at / key, leaves);
    else
        for (std::size_t i = 0; i < node.size(); ++i) collect_leaves(node[i], at / i, leaves);
}

void expect_no_ids(const Problems& problems, const std::string& what) {
    for (const Problem& problem : problems.items()) {
        const std::string words = problem.message.english();
        if (words.find("is written as") != std::string::npos) continue;  // how to write it in the file
        for (const char* id :
             {"qz", "/analyses", "/assets", "/setup", "/rows/", "/options", "/studies", "/designs"})
            EXPECT_EQ(words.find(id), std::string::npos) << what << ": " << words;
    }
}

class DamagedProject : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(DamagedProject, IsSpokenOfWithoutIdsAndPaths) {
    const Json whole = with_plain_ids(GetParam());
    std::vector<Json::json_pointer> leaves;
    for (const char* list : {"assets", "analyses"})
        if (whole.contains(list))
            collect_leaves(whole.at(list), Json::json_pointer(std::string("/") + list), leaves);
    if (leaves.size() > 3000) GTEST_SKIP() << "large";
    const std::size_t stride = std::max<std::size_t>(1, leaves.size() / most_damages);
    for (std::size_t i = GetParam().string().size() % stride; i < leaves.size(); i += stride) {
        Json damaged = whole;
        Json& leaf = damaged[leaves[i]];
        const std::string key = leaves[i].back();
        if (key == "id" || key == "name") continue;
        if (leaf.is_number())
            leaf = i % 2 ? Json(-1e9) : Json("1,5");
        else if (leaf.is_string())
            leaf = i % 2 ? Json("nowhere") : Json(7);
        else
            leaf = Json("yes");
        expect_no_ids(parse_project(damaged.dump(), GetParam().parent_path(), "damaged").problems,
                      leaves[i].to_string());
    }
}

// The damaged entries lose their set-up, or are there twice; others refer to them.
TEST_P(DamagedProject, SpeaksOfWhatIsMissingOrWrongWithoutIds) {
    const Json whole = with_plain_ids(GetParam());
    std::vector<Json::json_pointer> leaves;
    collect_leaves(whole, Json::json_pointer(), leaves);
    if (leaves.size() > 3000) GTEST_SKIP() << "large";
    for (const char* list : {"assets", "analyses"}) {
        if (!whole.contains(list)) continue;
        for (std::size_t i = 0; i < whole.at(list).size() && i < 6; ++i) {
            Json empty = whole;
            empty[list][i]["setup"] = Json::object();
            expect_no_ids(parse_project(empty.dump(), GetParam().parent_path(), "empty").problems,
                          std::string("empty ") + list + std::to_string(i));
            Json twice = whole;
            twice[list].push_back(twice[list][i]);
            expect_no_ids(parse_project(twice.dump(), GetParam().parent_path(), "twice").problems,
                          std::string("twice ") + list + std::to_string(i));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, DamagedProject, testing::ValuesIn(shipped_projects()), test_name_of);

TEST(Messages, ACircleOfLinksIsNamedByItsAnalyses) {
    const auto entry = [](const char* id, const char* name, const char* other) {
        return Json::parse(
            R"({"id": ")" + std::string(id) + R"(", "model": "measurement-equation", "name": ")" + name +
            R"(", "setup": {"equations": ["y = a"], "quantities": {"columns": ["symbol", "value", "unit",
                           "statement", "a"], "rows": [["a", 1, "mm", "standard", 0.1]]}},
                           "links": [{"input": "a", "analysis": ")" +
            other + R"(", "output": "y"}]})");
    };
    Json project = {{"format", "covaria"}, {"schemaVersion", 2}, {"title", "t"}};
    project["analyses"] = {entry("qz1", "Gauge A", "qz2"), entry("qz2", "Gauge B", "qz1")};
    const Problems problems = parse_project(project.dump(), ".", "circle").problems;
    ASSERT_TRUE(problems.has_errors());
    expect_no_ids(problems, "circle");
    EXPECT_NE(problems.items().front().message.english().find("Gauge A"), std::string::npos)
        << problems.items().front().message.english();

    // Two that share a name are told apart as in the tree.
    for (auto& analysis : project["analyses"]) analysis["name"] = "Gauge";
    const Problems alike = parse_project(project.dump(), ".", "circle").problems;
    ASSERT_TRUE(alike.has_errors());
    const std::string words = alike.items().front().message.english();
    EXPECT_NE(words.find("Gauge (1)"), std::string::npos) << words;
    EXPECT_NE(words.find("Gauge (2)"), std::string::npos) << words;
}

}  // namespace
}  // namespace covaria::messages_test
