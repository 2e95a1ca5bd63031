// The JSON schema of the project file, from which `covaria describe` is made, against what is written and
// read.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/project/design_fields.h"
#include "core/project/option_fields.h"
#include "core/project/options_json.h"
#include "core/project/project_file.h"
#include "core/project/study_fields.h"

namespace covaria::schema_test {
namespace {

const Json& definitions() {
    static const Json schema = [] {
        std::ifstream in(data_directory() / "resources/schema/covaria-project.schema.json");
        return Json::parse(in);
    }();
    return schema["$defs"];
}

std::set<std::string> keys_of(const Json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.insert(key);
    return keys;
}

/// An analysis with every key: nothing is as it is by default.
AnalysisEntry full_analysis() {
    const Quantity q{1.5, Unit::of("mm")};
    AnalysisEntry a{.id = "a", .model = "measurement-equation"};
    a.links.push_back({"y", {"b", "g", "z"}, true});
    ComponentEdit component{"c", "student-t", {0.0, 1.0, 5.0}, Unit::of("mm"), EvaluationType::type_a,
                            7.0, "x"};
    a.inputs.push_back({"x", q, std::vector<ComponentEdit>{component}, Combination::arithmetic, true});
    a.correlations.push_back({"x.1", "y.1", 0.5});
    EvaluationOptions& o = a.options;
    o = {Method::adaptive, 20, 2, VarianceReduction::sobol, 0.9, 2.0, true, 5, 6, 7, 3, q, 11, 1000};
    a.requirements.push_back({"g", "y", q, q, q, 0.5, q, q, GuardRule::rss, 0.05});
    StudyAxis axis{"plate",        "/setup/k", StudyChange::added,       1.0, 2.0,
                   Unit::of("mm"), 5,          StudySpacing::logarithmic};
    a.studies.push_back({"s", "study", {axis}, {{"g", "y"}}, Method::monte_carlo, 10});
    axis.values = 2;
    axis.spacing = StudySpacing::linear;
    DesignReduction reduction{.price = 3.0, .law = PriceLaw::repeats};
    reduction.number.asset = "plate";
    reduction.number.target = "/setup/k";
    reduction.number.from = 0.2;
    const DesignBox box{"pillar", {0, 0, 0}, {1, 2, 3}, Unit::of("mm")};
    a.designs.push_back({"d",
                         "design",
                         {{axis, 0.1}},
                         DesignChoice{"plate", "/setup/points/rows", 2, {1}, "more.csv", {1.0}},
                         {reduction},
                         {{"g", "y"}},
                         DesignObjective::mean,
                         q,
                         {box},
                         {box},
                         3,
                         4,
                         5,
                         6});
    a.views.push_back({"v", {0, 1, 0}, {0, 0, 1}, {1, 2, 3}, 4, 5, true, {"body:b"}, "body:c"});
    a.measured = "2026-04-16/2026-04-17";
    const Quantity degrees{20.0, Unit::of("degC")};
    a.certificates.push_back({FiguresFrom::report,
                              "7",
                              "2",
                              "X",
                              "2026-01-02",
                              "2026-01-03",
                              "2027-01-03",
                              "dry",
                              "7.pdf",
                              std::string(64, '0'),
                              {{"T", degrees, degrees}},
                              {"x"}});
    return a;
}

TEST(JsonSchema, HasTheKeysThatAreWritten) {
    Project project;
    project.analyses.push_back(full_analysis());
    project.report = {{"a"}, {"scene"}, true};
    project.results.style.digits = 1;
    put_kept(project.kept, state_of_other(project, "a", "hall.covaria: a", "a", "2026-11-20T09:30:00Z"));
    const std::string digest(64, '0');
    project.review = {{"A", "2026-01-02"}, {"B", "2026-01-03"},       {"C", "2026-01-04"}, digest,
                      {{"/p", "n", "0"}},  {{"2026-01-04", "C", "w"}}};
    project.amendment = {{{"method", "m"}}, {{"a", "g", "y", 1, 2, Unit::of("mm"), ReplacedDecision::fail}}};
    const Json whole = Json::parse(project_text(project)), written = whole["analyses"][0];
    const std::pair<const char*, Json> objects[] = {
        {"report", whole["report"]},
        {"keptState", whole["kept"][0]},
        {"review", whole["review"]},
        {"reviewStep", whole["review"]["released"]},
        {"releasedPart", whole["review"]["parts"][0]},
        {"reviewEntry", whole["review"]["log"][0]},
        {"amendment", whole["amendment"]},
        {"replacedText", whole["amendment"]["texts"][0]},
        {"replacedResult", whole["amendment"]["results"][0]},
        {"link", written["links"][0]},
        {"inputEdit", written["inputs"][0]},
        {"component", written["inputs"][0]["components"][0]},
        {"correlation", written["correlations"][0]},
        {"options", written["options"]},
        {"requirement", written["requirements"][0]},
        {"study", written["studies"][0]},
        {"studyAxis", written["studies"][0]["axes"][0]},
        {"design", written["designs"][0]},
        {"designVariable", written["designs"][0]["variables"][0]},
        {"designReduction", written["designs"][0]["reductions"][0]},
        {"designChoice", written["designs"][0]["choose"]},
        {"designBox", written["designs"][0]["keepOut"][0]},
        {"figuresCertificate", written["certificates"][0]}};
    for (const auto& [name, object] : objects) {
        EXPECT_EQ(keys_of(definitions()[name]["properties"]), keys_of(object)) << name;
        for (const auto& [key, field] : definitions()[name]["properties"].items())
            EXPECT_TRUE(field.contains("description") || field.contains("$ref")) << name << "/" << key;
    }
    // The reader knows every key that was written: an unknown one is a problem.
    const LoadedProject again = parse_project(project_text(project), {}, "full");
    for (const Problem& p : again.problems.items())
        EXPECT_EQ(p.message.english().find("there is no '"), std::string::npos)
            << p.path << ": " << p.message.english();
    EXPECT_EQ(again.project.review, project.review);
    EXPECT_EQ(again.project.amendment, project.amendment);
    ASSERT_EQ(again.project.analyses.size(), 1u);
    EXPECT_EQ(again.project.analyses[0].links, project.analyses[0].links);
    EXPECT_EQ(again.project.analyses[0].inputs, project.analyses[0].inputs);
    EXPECT_EQ(again.project.analyses[0].options, project.analyses[0].options);
    EXPECT_EQ(again.project.analyses[0].studies, project.analyses[0].studies);
    EXPECT_EQ(again.project.analyses[0].designs, project.analyses[0].designs);
}

/// An object in which every key that has a default has it.
Json with_defaults(const char* definition) {
    Json object = Json::object();
    for (const auto& [key, field] : definitions()[definition]["properties"].items())
        if (field.contains("default")) object[key] = field["default"];
    return object;
}

TEST(JsonSchema, StatesTheDefaults) {
    Problems problems;
    const Json options = with_defaults("options");
    EXPECT_EQ(options.size(), 12u);
    EXPECT_EQ(options_from_json(options, "", problems), EvaluationOptions{});
    Json study = with_defaults("study");
    study["id"] = "s";
    Json axis = with_defaults("studyAxis");
    axis.update(Json{{"target", "/setup/k"}, {"from", 0}, {"to", 1}});
    study["axes"] = Json::array({axis});
    Study plain{.id = "s"};
    plain.axes.push_back({.target = "/setup/k"});
    EXPECT_EQ(study_fields().read(study, "", problems), plain);
    Json design = with_defaults("design");
    design["id"] = "d";
    Json variable = with_defaults("designVariable");
    variable.update(Json{{"target", "/setup/k"}, {"from", 0}, {"to", 1}});
    design["variables"] = Json::array({variable});
    Design plain_design{.id = "d"};
    plain_design.variables.resize(1);
    plain_design.variables[0].number.target = "/setup/k";
    EXPECT_EQ(design_fields().read(design, "", problems), plain_design);
    EXPECT_EQ(with_defaults("requirement")["guardFactor"].get<double>(), Requirement{}.guard_factor);
    EXPECT_EQ(with_defaults("requirement")["targetRisk"].get<double>(), Requirement{}.target_risk);
    EXPECT_EQ(with_defaults("requirement")["guardRule"], "factor");
    EXPECT_EQ(with_defaults("component")["type"], "B");
    EXPECT_EQ(with_defaults("inputEdit")["held"], false);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
}

/// The entry of an option in the schema, as its declaration makes it.
struct MadeEntry {
    const OptionField& field;
    nlohmann::json made = {{"description", field.help}};
    const EvaluationOptions defaults = {};

    void type(const char* name, bool is_number = true) {
        made["type"] = name;
        if (!is_number) return;
        if (std::isfinite(field.range.low))
            made[field.range.low_open ? "exclusiveMinimum" : "minimum"] = field.range.low;
        if (std::isfinite(field.range.high))
            made[field.below_high ? "exclusiveMaximum" : "maximum"] = field.range.high;
    }
    void operator()(const ChosenOption& member) {
        for (const Choice& choice : field.choices) made["enum"].push_back(choice.key);
        made["default"] = member.get(defaults);
    }
    void operator()(const SeedOption& seed) {
        type("string", false);
        made["pattern"] = "^[0-9]+$";
        made["default"] = std::to_string(defaults.*seed.member);
    }
    void operator()(std::uint64_t EvaluationOptions::*member) {
        type("integer");
        made["default"] = defaults.*member;
    }
    void operator()(int EvaluationOptions::*member) {
        type("integer");
        made["default"] = defaults.*member;
    }
    void operator()(double EvaluationOptions::*member) {
        type("number");
        made["default"] = defaults.*member;
    }
    void operator()(std::optional<double> EvaluationOptions::*) { type("number"); }
    void operator()(std::optional<Quantity> EvaluationOptions::*) {
        made["anyOf"] = {{{"type", "number"}, {"exclusiveMinimum", field.range.low}},
                         {{"$ref", "#/$defs/quantity"}}};
    }
    void operator()(bool EvaluationOptions::*member) {
        type("boolean", false);
        made["default"] = defaults.*member;
    }
};

TEST(JsonSchema, OfTheOptionsIsWhatTheirDeclarationsMake) {
    std::vector<std::string> stated, declared;
    const Json& properties = definitions()["options"]["properties"];
    for (const auto& [key, field] : properties.items()) stated.push_back(key);
    for (const OptionField& field : option_fields()) {
        declared.emplace_back(field.key);
        MadeEntry entry{field};
        std::visit(entry, field.member);
        ASSERT_TRUE(properties.contains(field.key)) << field.key;
        EXPECT_EQ(nlohmann::json::parse(properties[field.key].dump()), entry.made) << field.key;
    }
    EXPECT_EQ(stated, declared);
}

TEST(JsonSchema, NamesTheChoicesThatAreRead) {
    std::set<std::string> kinds, stated;
    for (const DistributionKindInfo& kind : distribution_kinds()) kinds.emplace(kind.key);
    for (const Json& kind : definitions()["component"]["properties"]["distribution"]["enum"])
        stated.insert(kind.get<std::string>());
    EXPECT_EQ(kinds, stated);
    for (const Json& method : definitions()["options"]["properties"]["method"]["enum"]) {
        Problems problems;
        options_from_json(Json{{"method", method}}, "", problems);
        EXPECT_TRUE(problems.items().empty()) << method;
    }
    for (const Json& objective : definitions()["design"]["properties"]["objective"]["enum"]) {
        Problems problems;
        design_fields().read(Json{{"id", "d"}, {"objective", objective}}, "", problems);
        EXPECT_TRUE(problems.items().empty()) << objective;
    }
    for (const char* key : {"change", "spacing"})
        for (const Json& choice : definitions()["studyAxis"]["properties"][key]["enum"]) {
            Problems problems;
            const Json axis{{"target", "/setup/k"}, {"from", 1}, {"to", 2}, {key, choice}};
            study_fields().read(Json{{"id", "s"}, {"axes", Json::array({axis})}}, "", problems);
            EXPECT_TRUE(problems.items().empty()) << choice;
        }
}

/// More trials than all machines make would never end, and nothing would say so.
TEST(Options, EveryNumberOfTrialsHasAnEnd) {
    for (const OptionField& field : option_fields()) {
        const auto* member = std::get_if<std::uint64_t EvaluationOptions::*>(&field.member);
        if (!member || *member == &EvaluationOptions::minimum_batches) continue;
        EXPECT_LE(field.range.high, 1e12) << field.key;
        Problems problems;
        options_from_json(Json{{field.key, 1e15}}, "", problems);
        EXPECT_TRUE(problems.has_errors()) << field.key;
    }
}

}  // namespace
}  // namespace covaria::schema_test
