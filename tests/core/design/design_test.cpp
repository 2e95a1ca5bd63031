// Designs whose best is known exactly, searched from many starts; rows against all choices; constraints.
#include "core/design/design.h"
#include "core/result_files/design_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <random>

#include "core/base/file_io.h"
#include "core/made/load_project.h"
#include "core/text/numbers.h"
#include "core/views/design_results.h"
#include "tests/core/made.h"
#include "tests/fresh_folder.h"

namespace covaria::design_test {
namespace {

std::string number(double value) {
    return format_exact(value);
}

/// An analysis "a" of typed equations; quantities: symbol, value, unit, u. Targets of 1 mm, k = 1.
struct Equations {
    std::vector<std::string> lines, outputs;
    std::string quantities;

    void quantity(const std::string& symbol, double value, const std::string& unit, double u) {
        quantities += (quantities.empty() ? "" : ",") + std::string("[\"") + symbol + "\"," + number(value) +
                      ",\"" + unit + "\"," + (u > 0 ? "\"standard\"," + number(u) : "null,null") + "]";
    }
    Project project(const std::string& design) const {
        std::string text, results, requirements;
        for (const std::string& line : lines) text += (text.empty() ? "\"" : ",\"") + line + "\"";
        for (const std::string& output : outputs) {
            results += (results.empty() ? "" : ",") + std::string("[\"") + output + "\",\"mm\"]";
            requirements += (requirements.empty() ? "" : ",") + std::string("{\"symbol\":\"") + output +
                            R"(","targetUncertainty":{"value":1,"unit":"mm"}})";
        }
        const LoadedProject loaded = parse_project(
            R"({"format":"covaria","schemaVersion":1,"title":"t","assets":[],"analyses":[{"id":"a",
              "model":"measurement-equation","setup":{"equations":[)" +
                text + R"(],"outputs":{"columns":["symbol","unit"],"rows":[)" + results +
                R"(]},"quantities":{"columns":["symbol","value","unit","statement","a"],"rows":[)" +
                quantities + R"(]}},"options":{"coverageFactor":1},"requirements":[)" + requirements +
                R"(],"designs":[)" + design + "]}]}",
            {}, "test");
        for (const Problem& p : loaded.problems.items())
            ADD_FAILURE() << p.path << ": " << p.message.english();
        return loaded.project;
    }
};

std::string angle(const std::string& symbol) {
    return R"({"target":"/inputs/)" + symbol + R"(/estimate","from":-3.2,"to":3.2,"unit":"rad"})";
}

std::string sum_of(std::size_t n, const std::function<std::string(const std::string&)>& term) {
    std::string sum;
    for (std::size_t i = 1; i <= n; ++i) sum += (i > 1 ? " + " : "") + term(std::to_string(i));
    return sum;
}

/// n ranges of u = 1 mm to one point in the plane, from the directions a_1 ... a_n; least squares.
Project ranges_in_plane(std::size_t n, const std::string& objective, std::uint64_t seed) {
    Equations e;
    std::string variables;
    for (std::size_t i = 1; i <= n; ++i) {
        const std::string k = std::to_string(i);
        e.quantity("a_" + k, 0.1 * static_cast<double>(i), "rad", 0.0);
        e.quantity("d_" + k, 0.0, "mm", 1.0);
        variables += (i > 1 ? "," : "") + angle("a_" + k);
    }
    const auto sum = [n](const char* f, const char* g) {
        return sum_of(n, [&](const std::string& k) {
            const std::string first = std::string(f) + "(a_" + k + ")*";
            return first + (g[0] == 'd' ? "d_" + k : std::string(g) + "(a_" + k + ")");
        });
    };
    e.lines = {"N_11 = " + sum("cos", "cos"), "N_12 = " + sum("cos", "sin"), "N_22 = " + sum("sin", "sin"),
               "b_1 = " + sum("cos", "d"),    "b_2 = " + sum("sin", "d"),    "D = N_11*N_22 - N_12^2",
               "x = (N_22*b_1 - N_12*b_2)/D", "y = (N_11*b_2 - N_12*b_1)/D"};
    e.outputs = {"x", "y"};
    return e.project(R"({"id":"d","variables":[)" + variables + R"(],"objective":")" + objective +
                     R"(","starts":2,"seed":")" + std::to_string(seed) + R"(","trials":2000})");
}

/// The same in space, from directions of azimuth a and elevation h.
Project ranges_in_space(std::size_t n, std::uint64_t seed) {
    Equations e;
    std::string variables;
    for (std::size_t i = 1; i <= n; ++i) {
        const std::string k = std::to_string(i);
        e.quantity("a_" + k, 1.3 * static_cast<double>(i), "rad", 0.0);
        e.quantity("h_" + k, 0.2 * static_cast<double>(i), "rad", 0.0);
        e.quantity("d_" + k, 0.0, "mm", 1.0);
        e.lines.push_back("p_" + k + " = cos(h_" + k + ")*cos(a_" + k + ")");
        e.lines.push_back("q_" + k + " = cos(h_" + k + ")*sin(a_" + k + ")");
        e.lines.push_back("r_" + k + " = sin(h_" + k + ")");
        variables += (i > 1 ? "," : "") + angle("a_" + k) + "," + angle("h_" + k);
    }
    const auto sum = [n](const std::string& f, const std::string& g) {
        return sum_of(n, [&](const std::string& k) { return f + "_" + k + "*" + g + "_" + k; });
    };
    for (const auto& [name, f, g] : {std::array<std::string, 3>{"A", "p", "p"},
                                     {"B", "p", "q"},
                                     {"C", "p", "r"},
                                     {"E", "q", "q"},
                                     {"F", "q", "r"},
                                     {"G", "r", "r"},
                                     {"b_1", "p", "d"},
                                     {"b_2", "q", "d"},
                                     {"b_3", "r", "d"}})
        e.lines.push_back(name + " = " + sum(f, g));
    e.lines.insert(e.lines.end(), {"D = A*(E*G - F^2) - B*(B*G - C*F) + C*(B*F - C*E)",
                                   "x = ((E*G - F^2)*b_1 + (C*F - B*G)*b_2 + (B*F - C*E)*b_3)/D",
                                   "y = ((C*F - B*G)*b_1 + (A*G - C^2)*b_2 + (B*C - A*F)*b_3)/D",
                                   "z = ((B*F - C*E)*b_1 + (B*C - A*F)*b_2 + (A*E - B^2)*b_3)/D"});
    e.outputs = {"x", "y", "z"};
    return e.project(R"({"id":"d","variables":[)" + variables +
                     R"(],"objective":"root-mean-square","starts":2,"seed":")" + std::to_string(seed) +
                     R"(","trials":2000})");
}

/// Lengths and offsets of two joints of a planar arm from the positions of m poses, u = 1 mm, by least
/// squares of c_1 = L_1 exp(i o_1), c_2 = L_2 exp(i (o_1 + o_2)); joint 2 is chosen, joint 1 is not.
Project arm(std::size_t m, std::uint64_t seed) {
    Equations e;
    std::string variables;
    const std::string count = std::to_string(m);
    for (std::size_t i = 1; i <= m; ++i) {
        const std::string k = std::to_string(i);
        e.quantity("t_" + k, 0.7 * static_cast<double>(i), "rad", 0.0);
        e.quantity("q_" + k, 0.2 + 0.3 * static_cast<double>(i), "rad", 0.0);
        e.quantity("d_" + k, 0.0, "mm", 1.0);
        e.quantity("f_" + k, 0.0, "mm", 1.0);
        e.lines.push_back("x_" + k + " = A*cos(t_" + k + ") + B*cos(t_" + k + " + q_" + k + ") + d_" + k);
        e.lines.push_back("y_" + k + " = A*sin(t_" + k + ") + B*sin(t_" + k + " + q_" + k + ") + f_" + k);
        variables += (i > 1 ? "," : "") + angle("q_" + k);
    }
    e.quantity("A", 400, "mm", 0.0);
    e.quantity("B", 300, "mm", 0.0);
    const auto turned = [m](const std::string& angle_1, const char* x, const char* f, const char* y,
                            const char* g, const char* sign) {
        return sum_of(m, [&](const std::string& k) {
            const std::string at = angle_1 == "t" ? "(t_" + k + ")" : "(t_" + k + " + q_" + k + ")";
            return "(" + std::string(x) + "_" + k + "*" + f + at + sign + y + "_" + k + "*" + g + at + ")";
        });
    };
    e.lines.insert(
        e.lines.end(),
        {"S = " + sum_of(m, [](const std::string& k) { return "cos(q_" + k + ")"; }),
         "T = " + sum_of(m, [](const std::string& k) { return "sin(q_" + k + ")"; }),
         "a_r = " + turned("t", "x", "cos", "y", "sin", " + "),
         "a_i = " + turned("t", "y", "cos", "x", "sin", " - "),
         "b_r = " + turned("q", "x", "cos", "y", "sin", " + "),
         "b_i = " + turned("q", "y", "cos", "x", "sin", " - "), "N = " + count + "^2 - S^2 - T^2",
         "L_1 = sqrt((" + count + "*a_r - S*b_r + T*b_i)^2 + (" + count + "*a_i - S*b_i - T*b_r)^2)/N",
         "L_2 = sqrt((" + count + "*b_r - S*a_r - T*a_i)^2 + (" + count + "*b_i - S*a_i + T*a_r)^2)/N"});
    e.outputs = {"L_1", "L_2"};
    return e.project(R"({"id":"d","variables":[)" + variables + R"(],"starts":2,"seed":")" +
                     std::to_string(seed) + R"(","trials":2000})");
}

DesignResult run(const Project& project, int threads = 2) {
    Problems problems;
    const auto design = prepare_design(MadeProject::make(project), project.analyses.front().id,
                                       project.analyses.front().designs.front().id, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    if (!design) return {};
    auto result = run_design(*design, {{}, {}, threads});
    if (!result) ADD_FAILURE() << result.error().message.english();
    return result ? *std::move(result) : DesignResult{};
}

TEST(Design, RangesInThePlaneReachTheirBound) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        EXPECT_NEAR(run(ranges_in_plane(5, "root-mean-square", seed)).objective, std::sqrt(2.0 / 5.0), 5e-7)
            << seed;
}

TEST(Design, RangesInSpaceReachTheTetrahedron) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const DesignResult result = run(ranges_in_space(4, seed));
        EXPECT_NEAR(result.objective * std::sqrt(3.0), 1.5, 1e-6) << seed;
        EXPECT_TRUE(result.found);
    }
}

// The largest of two has a kink where they are equal, and there the best is.
TEST(Design, TheLargestRatioIsMadeSmallestAtItsKink) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        EXPECT_NEAR(run(ranges_in_plane(3, "largest", seed)).objective, std::sqrt(2.0 / 3.0), 5e-7) << seed;
}

TEST(Design, PlanarArmReachesTheVarianceOfIndependentLengths) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const DesignResult result = run(arm(4, seed));
        EXPECT_NEAR(result.objective, 0.5, 5e-7) << seed;
        for (const DesignGoal& goal : result.goals) EXPECT_NEAR(goal.after, 0.5e-3, 5e-10);
    }
}

TEST(Design, TwoBearingsMeetAtARightAngle) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const DesignResult result = run(ranges_in_plane(2, "root-mean-square", seed));
        EXPECT_NEAR(result.objective, 1.0, 1e-6);
        EXPECT_NEAR(std::cos(result.values[0].chosen - result.values[1].chosen), 0.0, 2e-3) << seed;
    }
}

/// Distance meters at random places round the point P.
struct Stations {
    std::string assets, rows;
    explicit Stations(std::size_t n, std::uint32_t seed) {
        std::mt19937 engine(seed);
        const auto draw = [&](double from, double to) {
            return from + (to - from) * static_cast<double>(engine()) / 4294967296.0;
        };
        for (std::size_t i = 0; i < n; ++i) {
            const std::string id = "s" + std::to_string(i);
            const double x = draw(-5000, 5000), y = draw(-5000, 5000), z = draw(-1000, 3000);
            assets += (i ? "," : "") + std::string(R"({"id":")") + id +
                      R"(","kind":"spherical-instrument","setup":{"station":{"position":[)" + number(x) +
                      "," + number(y) + "," + number(z) +
                      R"(],"lengthUnit":"mm","angles":[0,0,0],"angleUnit":"rad"},"kind":"distance-meter",
                      "distance_constant":{"value":)" +
                      number(draw(0.01, 0.05)) + R"(,"unit":"mm"}}})";
            rows += (i ? ",[\"" : "[\"") + id + "\"]";
        }
    }
    Project project(const std::string& design) const {
        const LoadedProject loaded = parse_project(
            R"({"format":"covaria","schemaVersion":1,"title":"t","assets":[)" + assets +
                R"(],"analyses":[{"id":"a","model":"points-from-sensors","setup":{"sensors":{"columns":["sensor"],
              "rows":[)" +
                rows +
                R"(]},"targets":{"columns":["name","x [mm]","y [mm]","z [mm]"],"rows":[["P",100,200,300],
              ["Q",900,-200,500]]}},"designs":[)" +
                design + "]}]}",
            {}, "test");
        for (const Problem& p : loaded.problems.items())
            ADD_FAILURE() << p.path << ": " << p.message.english();
        return loaded.project;
    }
};

std::string choosing(std::size_t keep, const std::string& more) {
    return R"({"id":"d","choose":{"table":"/setup/sensors/rows","keep":)" + std::to_string(keep) +
           R"(},"trials":1000)" + more + "}";
}

TEST(Design, ExchangeFindsTheBestOfAllChoices) {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        const Stations stations(10, seed);
        const DesignResult all = run(stations.project(choosing(4, "")));
        const DesignResult some =
            run(stations.project(choosing(4, R"(,"mostEvaluations":209,"objective":"largest")")));
        EXPECT_TRUE(all.proved);
        EXPECT_FALSE(some.proved);
        EXPECT_EQ(all.objective, some.objective) << seed;
        ASSERT_EQ(all.rows.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(all.rows[i].row, some.rows[i].row);
    }
}

TEST(Design, RowsSayWhatTheyAreWorthAndHowManyAreNeeded) {
    const DesignResult result = run(Stations(7, 3).project(choosing(4, "")));
    ASSERT_EQ(result.rows.size(), 4u);
    for (const DesignRow& row : result.rows)
        EXPECT_GT(row.without.value_or(2.0 * result.objective), result.objective);
    for (std::size_t i = 1; i < result.curve.size(); ++i) {
        EXPECT_EQ(result.curve[i].rows, result.curve[i - 1].rows + 1);
        EXPECT_LT(result.curve[i].objective, result.curve[i - 1].objective);
    }
    EXPECT_EQ(result.curve.front().rows, 3u);  // fewer distances do not fix a point
    EXPECT_EQ(result.curve.back().rows, 7u);
    EXPECT_NEAR(result.curve.back().objective, 1.0, 1e-12);  // all rows are the present design
}

// Rows of one name are told apart in the reader's words.
TEST(Design, RowsOfOneNameSayTheirNumberInTheReadersLanguage) {
    Project project = load_project(COVARIA_SOURCE_DIR "/projects/ballbar-design.covaria").project;
    Design& design = project.analyses.front().designs.front();
    design.starts = 1;
    design.most_evaluations = 300;
    design.trials = 1000;
    const DesignResult result = run(project);
    ASSERT_FALSE(result.gains.empty());
    const auto german = [](const std::string& words) {
        return words == "%1 (row %2)" ? std::string("%1 (Zeile %2)") : words;
    };
    EXPECT_TRUE(result.gains.front().name.english().ends_with(" (row 1)")) << result.gains.front().name;
    EXPECT_TRUE(result.gains.front().name.in(german).ends_with(" (Zeile 1)"));
}

/// m
Eigen::Vector3d stations_at(const Project& project, std::size_t i) {
    const auto& pose = std::get<PoseValue>(project.assets[i].setup.values.at("station"));
    return 1e-3 * Eigen::Vector3d(pose.position[0], pose.position[1], pose.position[2]);
}

/// The gain of a row is told by two searches that may not choose: with it and without it.
TEST(Design, EveryCandidateHasItsPlaceAndWhatItGains) {
    const Project project = Stations(7, 3).project(choosing(4, ""));
    const DesignResult result = run(project);
    ASSERT_EQ(result.gains.size(), 7u);
    std::vector<std::size_t> kept;
    for (const DesignGain& gain : result.gains)
        if (gain.kept) kept.push_back(gain.row);
    ASSERT_EQ(kept.size(), 4u);
    for (const DesignGain& gain : result.gains) {
        ASSERT_TRUE(gain.place) << gain.row;
        EXPECT_NEAR((*gain.place - stations_at(project, gain.row)).norm(), 0.0, 1e-12) << gain.row;
        ASSERT_TRUE(gain.gain) << gain.row;
        std::vector<std::size_t> others = kept;
        if (gain.kept)
            std::erase(others, gain.row);
        else
            others.insert(std::lower_bound(others.begin(), others.end(), gain.row), gain.row);
        Project changed = project;
        DesignChoice& choice = *changed.analyses[0].designs[0].choose;
        choice.keep = others.size();
        choice.fixed = others;
        const double with = gain.kept ? result.objective : run(changed).objective;
        const double without = gain.kept ? run(changed).objective : result.objective;
        EXPECT_NEAR(*gain.gain, 1.0 - with / without, 1e-12) << gain.row;
        EXPECT_GT(*gain.gain, 0.0);
    }
}

/// A design with prices and targets for P; `more` stands behind the choice.
Project priced(std::uint32_t seed, double target_mm, const std::string& prices, const std::string& more) {
    Project project =
        Stations(9, seed).project(R"({"id":"d","choose":{"table":"/setup/sensors/rows","keep":8,"prices":[)" +
                                  prices + R"(]},"trials":1000,"objective":"cost")" + more + "}");
    for (const char* symbol : {"x", "y", "z"})
        project.analyses.front().requirements.push_back(
            {.group = "P", .symbol = symbol, .target_uncertainty = Quantity{target_mm, Unit::of("mm")}});
    return project;
}

/// A target that some choices of eight reach, mm.
double reachable(std::uint32_t seed) {
    Project project = priced(seed, 1.0, "1", "");
    project.analyses[0].designs[0].objective = DesignObjective::largest;
    return 1.4 * run(project).objective;
}

/// The cheapest rows at one price for all are the fewest with which the targets are met.
TEST(Design, CheapestRowsAreTheFewestAtOnePriceForAll) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        Project project = priced(seed, reachable(seed), "7", "");
        const DesignResult cheapest = run(project);
        EXPECT_TRUE(cheapest.proved);
        ASSERT_TRUE(cheapest.met()) << seed;
        EXPECT_LE(cheapest.objective, 1.0);
        EXPECT_EQ(cheapest.cost, 7.0 * double(cheapest.rows.size()));
        Design& fewer = project.analyses[0].designs[0];
        fewer.objective = DesignObjective::largest;
        fewer.choose->keep = cheapest.rows.size();
        EXPECT_LE(run(project).objective, 1.0);
        if (--fewer.choose->keep < 3) continue;  // three distances fix a point
        EXPECT_GT(run(project).objective, 1.0) << seed;
    }
}

TEST(Design, CheapestRowsAreFoundByExchangeToo) {
    const std::string prices = "9,4,7,12,5,8,3,11,6";
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        const double target = reachable(seed);
        const DesignResult all = run(priced(seed, target, prices, ""));
        const DesignResult some = run(priced(seed, target, prices, R"(,"mostEvaluations":400)"));
        EXPECT_TRUE(all.proved);
        EXPECT_FALSE(some.proved);
        ASSERT_TRUE(all.met() && some.met()) << seed;
        EXPECT_EQ(*all.cost, *some.cost) << seed;
        double sum = 0.0;
        for (const DesignRow& row : all.rows) sum += row.price.value_or(1e9);
        EXPECT_EQ(*all.cost, sum);
        ASSERT_GT(all.front.size(), 1u);
        for (std::size_t i = 1; i < all.front.size(); ++i) {
            EXPECT_GT(all.front[i].largest_ratio, all.front[i - 1].largest_ratio);
            EXPECT_LT(all.front[i].cost, all.front[i - 1].cost);
        }
    }
}

TEST(Design, WhatNoRowsReachHasTheBestThatIsReached) {
    const DesignResult result = run(priced(2, 1e-4, "1", ""));
    EXPECT_TRUE(result.found);
    EXPECT_FALSE(result.met());
    EXPECT_GT(result.objective, 1.0);
    EXPECT_EQ(result.rows.size(), 8u) << "the most that may be kept come nearest";
    EXPECT_NE(design_text(result).find("is not met: the best design found reaches"), std::string::npos);
}

/// A source that lost its uncertainty would gain what its share of the variance says.
TEST(Design, SourcesAreWorthTheirShareOfTheVariance) {
    Equations e;
    e.quantity("t", 0.0, "rad", 0.0);
    e.quantity("p", 0.0, "mm", 3.0);
    e.quantity("q", 0.0, "mm", 4.0);
    e.lines = {"y = (p + q)*(2 + cos(t))"};
    e.outputs = {"y"};
    const DesignResult result =
        run(e.project(R"({"id":"d","variables":[)" + angle("t") + R"(],"trials":1000})"));
    ASSERT_EQ(result.sources.size(), 2u);
    EXPECT_NEAR(result.sources[0].gain, 1.0 - 3.0 / 5.0, 1e-9) << result.sources[0].origin;
    EXPECT_NEAR(result.sources[1].gain, 1.0 - 4.0 / 5.0, 1e-9) << result.sources[1].origin;
}

const char* const free_station = R"("variables":[
    {"asset":"s1","target":"/setup/station/position/0","from":-3000,"to":3000,"unit":"mm"},
    {"asset":"s1","target":"/setup/station/position/1","from":-3000,"to":3000,"unit":"mm"}])";

/// No exchange of a row that may go gains anything for the values found.
TEST(Design, RowsAreChosenAnewForTheValuesFound) {
    int exchanged = 0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        Project project = Stations(9, seed).project(
            R"({"id":"d","choose":{"table":"/setup/sensors/rows","keep":4,"fixed":[1]},)" +
            std::string(free_station) + R"(,"starts":2,"mostEvaluations":6000,"trials":1000})");
        for (const char* symbol : {"x", "y", "z"})
            project.analyses.front().requirements.push_back(
                {.group = "P", .symbol = symbol, .target_uncertainty = Quantity{0.1, Unit::of("mm")}});
        const DesignResult found = run(project);
        for (const DesignStep& step : found.path) exchanged += step.search == "exchange";
        auto& position = std::get<PoseValue>(project.assets[1].setup.values.at("station")).position;
        for (std::size_t i = 0; i < 2; ++i) position[i] = found.values[i].chosen;
        Design& design = project.analyses.front().designs.front();
        design.variables.clear();
        for (const DesignRow& goes : found.rows) {
            if (goes.row == 1) continue;
            design.choose->fixed.clear();
            for (const DesignRow& stays : found.rows)
                if (stays.row != goes.row) design.choose->fixed.push_back(stays.row);
            const DesignResult other = run(project);
            EXPECT_TRUE(other.proved);
            EXPECT_GE(other.objective, found.objective * (1.0 - 1e-9)) << seed;
        }
    }
    EXPECT_GT(exchanged, 0);
}

// The curve is that of the values found: at their number of rows it has the objective of the design.
TEST(Design, TheCurveIsAtTheValuesThatWereFound) {
    const DesignResult result = run(Stations(8, 4).project(
        R"({"id":"d","choose":{"table":"/setup/sensors/rows","keep":4,"fixed":[1]},)"
        R"("variables":[{"asset":"s1","target":"/setup/station/position/0","from":-5000,"to":5000,"unit":"mm"}],)"
        R"("trials":1000})"));
    const auto kept = std::ranges::find(result.curve, result.rows.size(), &DesignCount::rows);
    ASSERT_NE(kept, result.curve.end());
    EXPECT_NEAR(kept->objective, result.objective, 1e-12);
    for (std::size_t i = 1; i < result.curve.size(); ++i)
        EXPECT_LT(result.curve[i].objective, result.curve[i - 1].objective);
}

TEST(Design, SameBytesForAnyNumberOfThreads) {
    const Project project = Stations(6, 5).project(
        R"({"id":"d","choose":{"table":"/setup/sensors/rows","keep":4,"fixed":[1]},)" +
        std::string(free_station) + R"(,"starts":4,"mostEvaluations":1500,"trials":5000})");
    const std::string one = design_json(run(project, 1));
    EXPECT_EQ(one, design_json(run(project, 2)));
    EXPECT_EQ(one, design_json(run(project, 3)));
}

TEST(Design, BoxesAndDistancesAreKept) {
    const std::string box =
        R"({"name":"pillar","from":[-1000,-4000,-9000],"to":[4000,900,9000],"unit":"mm"})";
    const DesignResult free = run(Stations(4, 7).project(R"({"id":"d",)" + std::string(free_station) +
                                                         R"(,"mostEvaluations":4000,"trials":1000})"));
    const DesignResult kept = run(Stations(4, 7).project(
        R"({"id":"d",)" + std::string(free_station) + R"(,"keepOut":[)" + box +
        R"(],"leastDistance":{"value":500,"unit":"mm"},"mostEvaluations":4000,"trials":1000})"));
    ASSERT_TRUE(kept.found);
    const double x = kept.values[0].chosen, y = kept.values[1].chosen;
    EXPECT_FALSE(x > -1000 && y < 900) << x << ", " << y;
    EXPECT_GE(kept.objective, free.objective * (1.0 - 1e-9));
    EXPECT_FALSE(kept.reasons.empty());
}

TEST(Design, WhatVariablesMoveIsFollowedFromItsPlaceToTheBest) {
    const Project project =
        Stations(4, 7).project(R"({"id":"d",)" + std::string(free_station) +
                               R"(,"keepOut":[{"name":"crate","from":[9,9,0],"to":[10,11,3],"unit":"m"}],)" +
                               R"("mostEvaluations":2000,"trials":1000})");
    const DesignResult result = run(project);
    ASSERT_EQ(result.places.obstacles.size(), 1u);
    EXPECT_EQ(result.places.obstacles[0].high, Eigen::Vector3d(10, 11, 3));
    ASSERT_EQ(result.places.tracks.size(), 1u);
    const DesignTrack& track = result.places.tracks.front();
    const Eigen::Vector3d before = stations_at(project, 1);
    ASSERT_TRUE(track.before);
    EXPECT_NEAR((*track.before - before).norm(), 0.0, 1e-12);
    const Eigen::Vector3d best(1e-3 * result.values[0].chosen, 1e-3 * result.values[1].chosen, before.z());
    EXPECT_NEAR((track.chosen - best).norm(), 0.0, 1e-12);
    ASSERT_FALSE(track.path.empty());
    EXPECT_NEAR((track.path.back() - best).norm(), 0.0, 1e-12);
    EXPECT_NEAR(track.objectives.back(), result.objective, 1e-12);
    ASSERT_EQ(track.region.size(), 4u);
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const Eigen::Vector3d wanted((corner & 1) ? 3.0 : -3.0, (corner & 2) ? 3.0 : -3.0, before.z());
        EXPECT_NEAR((track.region[corner] - wanted).norm(), 0.0, 1e-12) << corner;
    }
    for (const LayoutBody& body : result.places.layout.bodies) EXPECT_TRUE(body.source.path.empty());
    EXPECT_FALSE(stands_in_space(run(ranges_in_plane(2, "mean", 1)))) << "equations are nowhere";
}

TEST(Design, NothingAllowedIsSaidWithItsReasons) {
    const DesignResult result = run(Stations(4, 7).project(
        R"({"id":"d",)" + std::string(free_station) +
        R"(,"keepOut":[{"from":[-4000,-4000,-9000],"to":[4000,4000,9000],"unit":"mm"}],"mostEvaluations":300})"));
    EXPECT_FALSE(result.found);
    EXPECT_FALSE(result.met());
    ASSERT_FALSE(result.reasons.empty());
    EXPECT_NE(result.reasons.front().reason.english().find("stands in a box"), std::string::npos);
    const auto german = [](const std::string& words) {
        return words == "%1 stands in a box" ? std::string("%1 steht in einem Quader") : words;
    };
    EXPECT_NE(result.reasons.front().reason.in(german).find("steht in einem Quader"), std::string::npos);
    EXPECT_NE(design_text(result).find("no candidate has a result"), std::string::npos);
}

TEST(Design, TakenOverItGivesWhatItPromised) {
    Project project = Stations(6, 5).project(
        R"({"id":"d","choose":{"table":"/setup/sensors/rows","keep":4,"fixed":[1]},)" +
        std::string(free_station) + R"(,"starts":2,"mostEvaluations":800,"trials":1000})");
    Problems problems;
    const auto design = prepare_design(MadeProject::make(project), "a", "d", problems);
    ASSERT_TRUE(design);
    const DesignResult result = *run_design(*design);
    auto taken = take_over(project, *design, result);
    ASSERT_TRUE(taken) << taken.error().message.english();
    taken->analyses.front().options.method = Method::first_order;
    const auto analysis = made_analysis(*taken, "a", problems);
    ASSERT_TRUE(analysis);
    const UncertaintyResult whole = *run_analysis(*analysis);
    ASSERT_FALSE(result.goals.empty());
    for (const DesignGoal& goal : result.goals) {
        const auto output = std::find_if(whole.outputs.begin(), whole.outputs.end(), [&](const auto& one) {
            return one.quantity.symbol == goal.output.symbol && one.quantity.group == goal.output.group;
        });
        ASSERT_NE(output, whole.outputs.end());
        EXPECT_DOUBLE_EQ(output->expanded_uncertainty, goal.after);
    }
}

// Candidates may refer to assets that the analysis does not use yet.
TEST(Design, CandidatesOfAFileStandBehindTheRowsOfTheTable) {
    const Stations stations(9, 2);
    const std::string targets = R"(,"outputs":[{"group":"P","symbol":"x"}])";  // one: no weights
    Project project = stations.project(choosing(4, targets));
    const DesignResult all = run(project);
    auto& rows = std::get<SetupTable>(project.analyses[0].setup.values.at("sensors")).rows;
    std::string csv = "sensor\n";
    for (std::size_t i = 5; i < rows.size(); ++i) csv += std::get<std::string>(rows[i][0]) + "\n";
    rows.resize(5);
    project.directory = test::fresh_folder();
    ASSERT_TRUE(write_file_atomically(project.directory / "more.csv", csv));
    project.analyses[0].designs[0].choose->candidates = "more.csv";
    const DesignResult some = run(project);
    ASSERT_EQ(some.rows.size(), 4u);
    EXPECT_EQ(some.candidates, 9u);
    for (const DesignRow& row : some.rows) EXPECT_EQ(row.added, row.row >= 5);
    EXPECT_TRUE(some.rows.back().added);
    ASSERT_EQ(all.rows.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(some.rows[i].row, all.rows[i].row);
    EXPECT_NEAR(some.goals[0].after, all.goals[0].after, 1e-12 * all.goals[0].after);
}

TEST(Design, AWorseNeighbourCountsWhereAPlaceIsUncertain) {
    const Project exact = ranges_in_plane(2, "root-mean-square", 1);
    Project uncertain = exact;
    for (DesignVariable& variable : uncertain.analyses[0].designs[0].variables) variable.tolerance = 0.1;
    const double nominal = run(exact).objective, worst = run(uncertain).objective;
    EXPECT_NEAR(nominal, 1.0, 1e-6);
    EXPECT_NEAR(worst, 1.0 / std::cos(0.1), 1e-6);  // u = 1/sin of the angle between the two
}

TEST(Design, EndsSoonAfterAStopRequest) {
    const Project project = ranges_in_space(4, 1);
    Problems problems;
    const auto design = prepare_design(MadeProject::make(project), "a", "d", problems);
    ASSERT_TRUE(design);
    std::stop_source source;
    source.request_stop();
    const auto result = run_design(*design, {source.get_token(), {}, 2});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace covaria::design_test
