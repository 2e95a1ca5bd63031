// Analyses that take inputs from others, against the same measurement written as one analysis.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/project/entry_graph.h"
#include "core/project/links.h"
#include "core/project/project_file.h"
#include "core/study/study.h"
#include "tests/core/made.h"

namespace covaria::chain_test {
namespace {

/// An analysis by an equation, as text of a project file.
struct Written {
    std::string id;
    std::vector<std::string> equations, outputs;
    std::vector<std::string> rows;   ///< the table of quantities: symbol, value, unit, statement, a, nu
    std::vector<std::string> links;  ///< input, analysis, output
    std::string more = {};           ///< further members of the analysis
};

std::string quoted(const std::string& text) {
    return "\"" + text + "\"";
}

template <class Item>
std::string joined(const std::vector<std::string>& items, Item item) {
    std::string text;
    for (const std::string& i : items) text += (text.empty() ? "" : ", ") + item(i);
    return text;
}

std::string text_of(const Written& w) {
    const auto as_is = [](const std::string& item) { return item; };
    return R"json({"id": ")json" + w.id +
           R"json(", "model": "measurement-equation", "setup": {"equations": [)json" +
           joined(w.equations, quoted) + R"json(], "outputs": {"columns": ["symbol"], "rows": [)json" +
           joined(w.outputs, [](const std::string& o) { return "[" + quoted(o) + "]"; }) +
           R"json(]}, "quantities": {"columns": ["symbol", "value", "unit", "statement", "a", "nu"], "rows": [)json" +
           joined(w.rows, [](const std::string& row) { return "[" + row + "]"; }) +
           R"json(]}}, "links": [)json" + joined(w.links, as_is) + "]" +
           (w.more.empty() ? "" : ", " + w.more) + "}";
}

std::string link(const std::string& input, const std::string& analysis, const std::string& output,
                 bool linearised = false) {
    return R"json({"input": ")json" + input + R"json(", "analysis": ")json" + analysis +
           R"json(", "output": ")json" + output + (linearised ? R"json(", "linearised": true})json" : "\"}");
}

LoadedProject parsed(const std::vector<Written>& analyses, const std::string& assets = "") {
    std::string text = R"json({"format": "covaria", "schemaVersion": 1, "title": "chain", "assets": [)json" +
                       assets + R"json(], "analyses": [)json";
    for (const Written& w : analyses) text += (&w == analyses.data() ? "" : ", ") + text_of(w);
    return parse_project(text + "]}", {}, "chain.covaria");
}

Project project_of(const std::vector<Written>& analyses, const std::string& assets = "") {
    const LoadedProject loaded = parsed(analyses, assets);
    for (const Problem& p : loaded.problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    return loaded.project;
}

std::shared_ptr<const PreparedAnalysis> prepared(const Project& project, const std::string& id) {
    Problems problems;
    auto analysis = made_analysis(project, id, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << id << p.path << ": " << p.message.english();
    return analysis;
}

UncertaintyResult run(Project project, const std::string& id, std::uint64_t trials = 0) {
    for (AnalysisEntry& entry : project.analyses) {
        entry.options.method = trials == 0 ? Method::first_order : Method::monte_carlo;
        if (trials > 0) entry.options.trials = trials;
    }
    const auto analysis = prepared(project, id);
    if (!analysis) return {};
    auto result = run_analysis(*analysis);
    EXPECT_TRUE(result) << result.error().message.english();
    return result ? *std::move(result) : UncertaintyResult{};
}

void expect_same(const UncertaintyResult& chain, const UncertaintyResult& flat) {
    ASSERT_EQ(chain.outputs.size(), flat.outputs.size());
    ASSERT_FALSE(flat.outputs.empty());
    for (std::size_t j = 0; j < flat.outputs.size(); ++j) {
        const OutputResult &a = chain.outputs[j], &b = flat.outputs[j];
        EXPECT_NEAR(a.first_order.estimate, b.first_order.estimate, 1e-9 * std::abs(b.first_order.estimate));
        EXPECT_NEAR(a.first_order.standard_uncertainty, b.first_order.standard_uncertainty,
                    1e-9 * b.first_order.standard_uncertainty);
        EXPECT_NEAR(a.first_order.expanded_uncertainty, b.first_order.expanded_uncertainty,
                    1e-9 * b.first_order.expanded_uncertainty);
        if (!b.monte_carlo) continue;
        EXPECT_EQ(a.monte_carlo->mean, b.monte_carlo->mean);
        EXPECT_EQ(a.monte_carlo->standard_uncertainty, b.monte_carlo->standard_uncertainty);
        EXPECT_EQ(a.monte_carlo->symmetric.high, b.monte_carlo->symmetric.high);
    }
    EXPECT_EQ(chain.failed_trials, flat.failed_trials);
}

Problem problem_of(const std::vector<Written>& analyses, const std::string& words) {
    const LoadedProject loaded = parsed(analyses);
    std::string all;
    for (const Problem& p : loaded.problems.items()) {
        if (p.message.english().find(words) != std::string::npos) return p;
        all += p.path + ": " + p.message.english() + "\n";
    }
    ADD_FAILURE() << words << " is not among\n" << all;
    return {};
}

/// End gauge calibrated by comparison; then used at another temperature.
const Written gauge{
    "gauge",
    {"l = l_S + d"},
    {"l"},
    {R"("l_S", 50.000623, "mm", "standard", 25e-6, 18)", R"("d", 215e-6, "mm", "standard", 9.7e-6, 25)"},
    {}};
const Written use{"use",
                  {"L = l*(1 + alpha*theta)"},
                  {"L"},
                  {R"("alpha", 11.5e-6, "1/K", "standard", 1.2e-6, null)",
                   R"("theta", 1.5, "K", "standard", 0.3, null)", R"("l", 50, "mm", "standard", 1, null)"},
                  {link("l", "gauge", "l")}};

/// Random equations of quantities of their own and of earlier results.
class RandomChain {
public:
    explicit RandomChain(unsigned seed) : generator_(seed) {
        const std::size_t count = 3 + generator_() % 5;
        for (std::size_t i = 0; i < count; ++i) add(i, i + 1 == count);
        // The order is the chain's: the last one's quantities, then upstream ones as they are reached.
        Written flat{"flat", {}, {}, {}, {}};
        order(count - 1, flat);
        flat.rows.insert(flat.rows.begin(), own_.back().begin(), own_.back().end());
        flat.outputs = parts.back().outputs;
        parts.push_back(std::move(flat));
    }
    std::vector<Written> parts;  ///< the last is all of them in one

private:
    std::string name(const char* letter, std::size_t i) {
        return letter + std::string("_") + std::to_string(i + 1);
    }

    void add(std::size_t i, bool last) {
        Written w{"part" + std::to_string(i + 1), {}, {name("y", i)}, {}, {}};
        std::vector<std::string> own;
        for (const char* letter : {"a", "b"}) {
            const double value = 1.0 + 0.01 * static_cast<double>(generator_() % 200);
            const std::string nu = generator_() % 3 == 0 ? "7" : "null";
            own.push_back(quoted(name(letter, i)) + ", " + std::to_string(value) +
                          R"(, "1", "standard", 0.03, )" + nu);
        }
        w.rows = own;
        own_.push_back(own);
        std::string taken;
        uses_.emplace_back();
        for (std::size_t j = 0; j < i; ++j) {
            if (!last && j + 1 != i && generator_() % 3 != 0) continue;
            if (last && j + 1 != i && generator_() % 2 != 0) continue;
            uses_.back().push_back(j);
            w.rows.push_back(quoted(name("y", j)) + R"(, 1, "1", "constant", null, null)");
            w.links.push_back(link(name("y", j), "part" + std::to_string(j + 1), name("y", j)));
            static const char* const shapes[] = {" + sqrt(abs(#) + 1)", " - #/(2 + #^2)", " + sin(#)",
                                                 " + 0.3*#"};
            std::string shape = shapes[generator_() % 4];
            for (std::size_t at; (at = shape.find('#')) != std::string::npos;)
                shape.replace(at, 1, name("y", j));
            taken += shape;
        }
        w.equations = {name("y", i) + " = " + name("a", i) + "*" + name("b", i) + taken};
        parts.push_back(std::move(w));
    }

    void order(std::size_t i, Written& flat) {
        if (!reached_.insert(i).second) return;
        for (const std::size_t j : uses_[i]) order(j, flat);
        flat.equations.push_back(parts[i].equations.front());
        if (i + 1 < own_.size()) flat.rows.insert(flat.rows.end(), own_[i].begin(), own_[i].end());
    }

    std::mt19937 generator_;
    std::vector<std::vector<std::string>> own_;
    std::vector<std::vector<std::size_t>> uses_;
    std::set<std::size_t> reached_;
};

}  // namespace

TEST(Chain, RandomOnesAreTheOneFlatEquation) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const RandomChain chain(seed);
        const Project project = project_of(chain.parts);
        ASSERT_FALSE(HasFailure());
        const std::string last = chain.parts[chain.parts.size() - 2].id;
        expect_same(run(project, last), run(project, "flat"));
        expect_same(run(project, last, 20'000), run(project, "flat", 20'000));
    }
}

TEST(Chain, GoesDownToTheCertificate) {
    const Project project = project_of({use, gauge});
    const UncertaintyResult result = run(project, "use", 20'000);
    std::set<std::string> ids;
    for (const BudgetRow& row : result.budget.rows.at(0))
        ids.insert(result.budget.components[row.component].id);
    EXPECT_TRUE(ids.contains("gauge:l_S.1"));
    EXPECT_TRUE(ids.contains("theta.1"));
    EXPECT_FALSE(ids.contains("l.1"));  // stated by the set-up beside the link
    double of_gauge = 0.0;
    for (const GroupContribution& g : contributions_by_group(result.budget, 0, "analysis"))
        if (g.group == "gauge") of_gauge = g.share;
    const double u_l = std::hypot(25e-9, 9.7e-9), u = result.outputs[0].first_order.standard_uncertainty;
    EXPECT_NEAR(of_gauge, u_l * u_l / (u * u), 1e-4);
    const auto linked = prepared(project, "use")->linked;
    ASSERT_EQ(linked.size(), 1u);
    EXPECT_EQ(linked[0].symbol, "l");
    EXPECT_EQ(linked[0].analysis, "gauge");
    EXPECT_NEAR(linked[0].estimate, 50.000838e-3, 1e-15);
    EXPECT_NEAR(linked[0].standard_uncertainty, u_l, 1e-12 * u_l);
}

TEST(Chain, AnInstrumentOnTwoWaysIsOneInstrument) {
    const std::string instrument =
        R"json({"id": "lt", "kind": "spherical-instrument", "name": "tracker", "setup":
        {"kind": "tracker", "distance_constant": {"value": 0.01, "unit": "mm"}, "u_scale": {"value": 5, "unit": "ppm"}}})json";
    const auto analysis = [](const std::string& id, const std::string& symbol) {
        return R"json({"id": ")json" + id +
               R"json(", "model": "measurement-equation", "setup": {"equations": ["y = )json" + symbol +
               R"json("], "quantities": {"columns": ["symbol", "value", "unit", "statement", "instrument"], "rows": [[")json" +
               symbol + R"json(", 4, "m", "instrument", "lt"]]}}})json";
    };
    const std::string difference =
        R"json({"id": "d", "model": "measurement-equation", "setup": {"equations": ["d = p - q"],
        "quantities": {"columns": ["symbol", "value", "unit"], "rows": [["p", 4, "m"], ["q", 4, "m"]]}},
        "links": [{"input": "p", "analysis": "one", "output": "y"}, {"input": "q", "analysis": "two", "output": "y"}]})json";
    const LoadedProject loaded =
        parse_project(R"json({"format": "covaria", "schemaVersion": 1, "title": "t", "assets": [)json" +
                          instrument + R"json(], "analyses": [)json" + analysis("one", "a") + ", " +
                          analysis("two", "b") + ", " + difference + "]}",
                      {}, "t");
    for (const Problem& p : loaded.problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    const double u_y = run(loaded.project, "one").outputs.at(0).standard_uncertainty;
    const UncertaintyResult result = run(loaded.project, "d");
    const double u_d = result.outputs.at(0).standard_uncertainty;
    EXPECT_GT(u_y, 20e-6);                       // the scale, and the reading
    EXPECT_LT(u_d, 0.8 * std::sqrt(2.0) * u_y);  // the scale cancels
    EXPECT_EQ(assets_used_by(loaded.project, loaded.project.analyses[2]), std::vector<std::string>{"lt"});
    EXPECT_EQ(analyses_using(loaded.project, "lt"), (std::vector<std::string>{"one", "two", "d"}));
}

TEST(Chain, AnUpstreamEditIsAnEditOfWhatIsMadeOfIt) {
    const Written other{"other", {"y = x"}, {"y"}, {R"("x", 1, "1", "standard", 0.1, null)"}, {}};
    const Project before = project_of({use, gauge, other});
    Project after = before;
    after.analyses[1].inputs.push_back({.symbol = "d", .estimate = Quantity{220, Unit::of("nm")}});
    EXPECT_NE(prepared(before, "use")->fingerprint(), prepared(after, "use")->fingerprint());
    EXPECT_EQ(prepared(before, "other")->fingerprint(), prepared(after, "other")->fingerprint());
    Project renamed = before;
    renamed.analyses[1].name = "Gauge";
    renamed.analyses[1].options.trials = 77'000;  // for its own evaluation
    EXPECT_EQ(prepared(before, "use")->fingerprint(), prepared(renamed, "use")->fingerprint());
    EXPECT_EQ(analyses_used_by(before, before.analyses[0]), std::vector<std::string>{"gauge"});
    EXPECT_EQ(analyses_taking_from(before, "gauge"), std::vector<std::string>{"use"});
    EXPECT_TRUE(analyses_taking_from(before, "use").empty());
}

TEST(Chain, WrittenAndReadAgain) {
    Written linear = use;
    linear.links = {link("l", "gauge", "l", true)};
    const Project project = project_of({gauge, linear});
    EXPECT_EQ(project.analyses[1].links,
              (std::vector<InputLink>{{"l", {.analysis = "gauge", .symbol = "l"}, true}}));
    const LoadedProject again = parse_project(project_text(project), {}, "again");
    EXPECT_EQ(again.project, project);
    EXPECT_EQ(project_text(again.project), project_text(project));
    EXPECT_TRUE(prepared(project, "use")->linked.at(0).linearised);
    expect_same(run(project, "use"), run(project_of({gauge, use}), "use"));
}

TEST(Chain, MistakesHaveTheirPlace) {
    const auto with_links = [](std::vector<std::string> links) {
        Written w = use;
        w.links = std::move(links);
        return std::vector<Written>{w, gauge};
    };
    EXPECT_EQ(problem_of(with_links({link("l", "gaug", "l")}), "did you mean 'gauge'").path,
              "/analyses/0/links/0/analysis");
    EXPECT_EQ(problem_of(with_links({link("l", "gauge", "x")}), "has no output 'x'").path,
              "/analyses/0/links/0/output");
    EXPECT_EQ(problem_of(with_links({link("ll", "gauge", "l")}), "no input quantity 'll'").path,
              "/analyses/0/links/0/input");
    EXPECT_EQ(problem_of(with_links({link("theta", "gauge", "l")}), "is a length").path,
              "/analyses/0/links/0/output");
    EXPECT_EQ(problem_of(with_links({link("l", "gauge", "l"), link("l", "gauge", "l")}), "linked twice").path,
              "/analyses/0/links/1/input");
    auto edited = with_links({link("l", "gauge", "l")});
    edited[0].more = R"("inputs": [{"symbol": "l", "estimate": {"value": 51, "unit": "mm"}}])";
    EXPECT_EQ(problem_of(edited, "remove either this or the link").path, "/analyses/0/inputs/0/symbol");
    edited[0].more = R"("correlations": [{"first": "alpha.1", "second": "l.1", "coefficient": 0.5}])";
    EXPECT_EQ(problem_of(edited, "remove either this or the link").path, "/analyses/0/correlations/0/second");
    Written broken = gauge;
    broken.equations = {"l = l_S +"};
    EXPECT_EQ(problem_of({use, broken}, "'gauge' has errors of its own").path,
              "/analyses/0/links/0/analysis");
}

TEST(Chain, CirclesAreRefusedWithTheirPath) {
    const auto part = [](const std::string& id, const std::string& from) {
        return Written{
            id, {"y = x"}, {"y"}, {R"("x", 1, "1", "standard", 0.1, null)"}, {link("x", from, "y")}};
    };
    EXPECT_EQ(problem_of({part("a", "c"), part("b", "a"), part("c", "b")}, "a ← c ← b ← a").path,
              "/analyses/0/links/0/analysis");
    EXPECT_EQ(problem_of({part("a", "a")}, "a ← a").path, "/analyses/0/links/0/analysis");
    std::vector<Written> many{{"a0", {"y = x"}, {"y"}, {R"("x", 1, "1", "standard", 0.1, null)"}, {}}};
    for (int i = 1; i <= 80; ++i) many.push_back(part("a" + std::to_string(i), "a" + std::to_string(i - 1)));
    EXPECT_EQ(problem_of(many, "more than 64 analyses").path, "/analyses/64/links/0/analysis");
    // Once for all that it is true of, and without a list of those in between.
    const Problems problems = parsed(many).problems;
    EXPECT_EQ(problems.items().size(), 1u);
    EXPECT_EQ(problems.items().front().message, chain_too_long());
}

TEST(Chain, AnErrorUpstreamIsSaidInTheWordsOfItsAnalysis) {
    const auto part = [](const std::string& id, const std::string& from) {
        return Written{
            id, {"y = x"}, {"y"}, {R"("x", 1, "1", "standard", 0.1, null)"}, {link("x", from, "y")}};
    };
    Written broken{"first", {"y = x +"}, {"y"}, {R"("x", 1, "1", "standard", 0.1, null)"}, {}};
    const std::string said =
        problem_of({part("c", "b"), part("b", "a"), part("a", "first"), broken}, "").message.english();
    EXPECT_TRUE(said.starts_with("the analysis 'first' has errors of its own: ")) << said;
    EXPECT_EQ(said.find("errors of its own", said.find("errors of its own") + 1), std::string::npos) << said;
}

// Circles are named as in the window's tree.
TEST(Chain, CirclesAreOfNamesNotIds) {
    const auto part = [](const std::string& id, const std::string& name, const std::string& from) {
        return Written{id,
                       {"y = x"},
                       {"y"},
                       {R"("x", 1, "1", "standard", 0.1, null)"},
                       {link("x", from, "y")},
                       R"("name": ")" + name + R"(")"};
    };
    problem_of({part("one", "Gauge A", "two"), part("two", "Gauge B", "one")},
               "the analysis 'Gauge B' would be made of itself: Gauge A ← Gauge B ← Gauge A");
}

TEST(Chain, AStudyVariesWhatIsDownstream) {
    Project project = project_of({use, gauge});
    Study study{.id = "s", .name = "s"};
    study.axes = {{.target = "/setup/quantities/rows/1/a", .from = 0.1, .to = 0.5, .values = 3}};
    study.outputs = {{"", "L"}};
    study.method = Method::first_order;
    project.analyses[0].studies = {study};
    Problems problems;
    const auto plan = prepare_study(MadeProject::make(project), "use", "s", problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    ASSERT_TRUE(plan);
    const auto result = run_study(*plan);
    ASSERT_TRUE(result) << result.error().message.english();
    EXPECT_NEAR(result->points.at(1).values.at(0).standard_uncertainty,
                run(project, "use").outputs[0].standard_uncertainty, 1e-15);
    EXPECT_LT(result->points.at(0).values.at(0).standard_uncertainty,
              result->points.at(2).values.at(0).standard_uncertainty);
}

}  // namespace covaria::chain_test
