// projects/ballbar-tcp.covaria, the procedure of Brosed et al., and variants of it: published and reference
// values, laws of the robot's deviation, edge cases. Micrometres, microradians, k = 2.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/resource_path.h"
#include "tests/core/made.h"

namespace covaria::tcp_project_test {
namespace {

using Row = std::vector<double>;

struct Procedure {
    Procedure() : project(load_project(data_directory() / "projects/ballbar-tcp.covaria").project) {}

    AnalysisEntry& analysis(const std::string& id = "paper") {
        for (AnalysisEntry& entry : project.analyses)
            if (entry.id == id) return entry;
        throw std::out_of_range(id);
    }
    covaria::Setup& asset(const std::string& id) {
        for (AssetEntry& entry : project.assets)
            if (entry.id == id) return entry.setup;
        throw std::out_of_range(id);
    }
    SetupTable& sequences() { return std::get<SetupTable>(analysis().setup.values.at("sequences")); }
    void set(const std::string& key, SetupValue value) { analysis().setup.values[key] = std::move(value); }
    void set_figures(double um) {
        for (const char* const key : {"reading_constant", "support_constant"})
            asset("ballbars").values[key] = Quantity{um, Unit::of("um")};
    }
    /// Points alone, in mm in the ballbars' frame, without a robot.
    void measure_points(const std::vector<std::array<double, 3>>& points) {
        SetupTable table;
        table.units = {Unit{}, Unit::of("mm"), Unit::of("mm"), Unit::of("mm")};
        for (const auto& p : points)
            table.rows.push_back({"P" + std::to_string(table.rows.size() + 1), p[0], p[1], p[2]});
        analysis().setup.values = {
            {"ballbars", std::string("ballbars")}, {"evaluation", std::string("points")}, {"points", table}};
    }

    std::shared_ptr<const PreparedAnalysis> prepare(const std::string& id = "paper") {
        problems = {};
        return made_analysis(project, id, problems);
    }
    UncertaintyResult run(std::uint64_t trials, const std::string& id = "paper") {
        EvaluationOptions& options = analysis(id).options;
        options.method = trials == 0 ? Method::first_order : Method::monte_carlo;
        options.contributor_trials = trials;
        if (trials > 0) options.trials = trials;
        const auto prepared = prepare(id);
        if (!prepared) throw std::runtime_error(words());
        return *run_analysis(*prepared, {});
    }
    std::string words() const {
        std::string text;
        for (const Problem& problem : problems.items())
            text += problem.path + ": " + problem.message.english() + "\n";
        return text;
    }
    /// Whether the project is refused with a message that has these words.
    bool refuses(const std::string& expected) {
        return !prepare() && problems.has_errors() && words().find(expected) != std::string::npos;
    }

    Project project;
    Problems problems;
};

Row expanded(const UncertaintyResult& r, const std::string& group) {
    Row row;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.group == group) row.push_back(2e6 * y.standard_uncertainty);
    return row;
}

Row expanded_first_order(const UncertaintyResult& r, const std::string& group) {
    Row row;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.group == group) row.push_back(2e6 * y.first_order.standard_uncertainty);
    return row;
}

const ContributorResult& contributor(const UncertaintyResult& r, const std::string& name) {
    for (const ContributorResult& c : r.contributors)
        if (c.contributor == name) return c;
    throw std::out_of_range(name);
}

Row expanded(const UncertaintyResult& r, const std::string& group, const std::vector<double>& u) {
    Row row;
    for (std::size_t j = 0; j < u.size(); ++j)
        if (r.outputs[j].quantity.group == group) row.push_back(2e6 * u[j]);
    return row;
}

/// Largest of the points x 1 ... y 11, coordinate by coordinate.
Row largest_of_points(const UncertaintyResult& r, const std::vector<double>& u) {
    Row row(3, 0.0);
    for (std::size_t j = 0; j < u.size(); ++j)
        if (const std::string& group = r.outputs[j].quantity.group; group.size() > 2 && group[1] == ' ')
            row[static_cast<std::size_t>(r.outputs[j].quantity.symbol[0] - 'x')] =
                std::max(row[static_cast<std::size_t>(r.outputs[j].quantity.symbol[0] - 'x')], 2e6 * u[j]);
    return row;
}

void expect_near(const Row& found, const Row& expected, double relative, const char* what) {
    ASSERT_EQ(found.size(), expected.size()) << what;
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], relative * expected[i]) << what << " " << i;
}

// Reference values have three or four figures and a standard error up to 0.1 %; 10^5 trials have 0.22 %.
constexpr double four_errors = 4.0 * 0.0025;

TEST(TcpFromBallbars, ReproducesThePaper) {
    const UncertaintyResult r = Procedure().run(100'000);
    EXPECT_EQ(r.failed_trials, 0u);
    expect_near(expanded(r, "TCP"), {8.16, 10.92, 5.00}, four_errors, "TCP");
    expect_near(expanded(r, "axes of the flange"), {78.3, 87.2, 58.5, 120.6}, four_errors, "angles");
    expect_near(expanded(r, "centre of the flange"), {5.96, 7.42, 6.94}, four_errors, "centre");
    const auto& ideal = contributor(r, "Robot").without;
    expect_near(expanded(r, "TCP", ideal.monte_carlo), {2.77, 3.61, 1.57}, four_errors, "ideal robot");
    expect_near(largest_of_points(r, ideal.monte_carlo), {5.83, 5.72, 2.38}, four_errors, "points");
    // Published: three figures of the tool, three with an ideal robot, four angles, three of the points.
    expect_near(expanded(r, "TCP"), {8.2, 11.1, 5.1}, 0.03, "published TCP");
    expect_near(expanded(r, "axes of the flange"), {79, 87, 59, 123}, 0.03, "published angles");
    expect_near(expanded(r, "TCP", ideal.monte_carlo), {2.8, 3.7, 1.6}, 0.04, "published ideal robot");
    expect_near(largest_of_points(r, ideal.monte_carlo), {5.7, 5.7, 2.4}, 0.035, "published points");
}

/// Equal when rounded to the unit of the last digit that the reference states.
void expect_rounds_to(const Row& found, const Row& expected, double unit, const char* what) {
    ASSERT_EQ(found.size(), expected.size()) << what;
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(std::round(found[i] / unit) * unit, expected[i], 1e-9) << what << " " << i;
}

TEST(TcpFromBallbars, FirstOrderIsThatOfTheReference) {
    const UncertaintyResult r = Procedure().run(0);
    expect_rounds_to(expanded(r, "TCP"), {8.142, 10.916, 4.990}, 1e-3, "TCP");
    expect_rounds_to(expanded(r, "axes of the flange"), {78.37, 87.15, 58.58, 120.46}, 1e-2, "angles");
    const ContributorResult& robot = contributor(r, "Robot");
    expect_rounds_to(expanded(r, "TCP", robot.without.first_order), {2.768, 3.609, 1.572}, 1e-3, "ideal");
    expect_rounds_to(expanded(r, "TCP", robot.alone.first_order), {7.657, 10.302, 4.737}, 1e-3, "robot");
}

TEST(TcpFromBallbars, FirstOrderAndMonteCarloAgree) {
    const UncertaintyResult r = Procedure().run(400'000);
    const Row first = expanded_first_order(r, "TCP"), monte_carlo = expanded(r, "TCP");
    for (std::size_t i = 0; i < 3; ++i)  // 0.3 %, and the standard error of 4 * 10^5 trials
        EXPECT_NEAR(first[i] / monte_carlo[i], 1.0, 0.003 + 4.0 / std::sqrt(8e5)) << i;
    for (std::size_t j = 0; j < 3; ++j)
        EXPECT_LT(std::abs(r.outputs[j].estimate - r.outputs[j].first_order.estimate), 0.03e-6);  // bias
}

TEST(TcpFromBallbars, TheStatedUncertaintyOfALengthDiffers) {
    const UncertaintyResult r = Procedure().run(100'000, "stated");
    expect_near(expanded(r, "TCP"), {8.46, 11.31, 5.16}, four_errors, "TCP");
    const auto& ideal = contributor(r, "Robot").without;
    expect_near(expanded(r, "TCP", ideal.monte_carlo), {3.57, 4.66, 2.03}, four_errors, "ideal robot");
    expect_near(largest_of_points(r, ideal.monte_carlo), {7.53, 7.37, 3.07}, four_errors, "points");
}

TEST(TcpFromBallbars, CountsTrialsWhoseLengthsDoNotMeet) {
    Procedure p;
    p.set_figures(4.0);
    p.measure_points({{260.0, 150.0, 1.0}});
    const UncertaintyResult r = p.run(100'000);
    EXPECT_NE(p.words().find("negative root"), std::string::npos) << p.words();
    const double fraction = static_cast<double>(r.failed_trials) / 1e5;
    EXPECT_NEAR(fraction, 0.1058, 4.0 * std::sqrt(0.1058 * 0.8942 / 1e5) + 5e-5);
    ASSERT_FALSE(r.warnings.empty());
    EXPECT_NE(r.warnings[0].english().find("of 100000 trials"), std::string::npos);
}

TEST(TcpFromBallbars, AllUncertaintiesZeroGiveZero) {
    Procedure p;
    p.set_figures(0.0);
    p.asset("robot").values["repeatability"] = Quantity{0.0, Unit::of("mm")};
    const UncertaintyResult r = p.run(2'000);
    for (const OutputResult& y : r.outputs) {
        EXPECT_EQ(y.first_order.standard_uncertainty, 0.0);
        EXPECT_LT(y.standard_uncertainty, 1e-15) << y.quantity.symbol;
    }
}

// Each point has the weights of its own lengths: (AᵀWA)⁻¹ with W = diag(1/u²) at that point, A by hand.
TEST(TcpFromBallbars, MoreThanThreeLengthsAreWeighedByTheirUncertaintiesAtEachPoint) {
    Procedure p;
    p.set_figures(0.0);
    auto& bars = p.asset("ballbars").values;
    bars = {{"length_12", Quantity{2000, Unit::of("mm")}},
            {"length_13", Quantity{std::sqrt(2.0) * 2000, Unit::of("mm")}},
            {"length_23", Quantity{2000, Unit::of("mm")}},
            {"reading_constant", Quantity{1, Unit::of("um")}},
            {"reading_scale", Quantity{20, Unit::of("ppm")}}};
    const std::vector<Eigen::Vector3d> supports{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0.3}, {1, 1, -0.5}};
    SetupTable further;
    for (int c = 0; c < 5; ++c) further.units.push_back(Unit::of("mm"));
    for (std::size_t k = 3; k < supports.size(); ++k) {
        const auto length = [&](std::size_t j) { return 1e3 * (supports[k] - supports[j]).norm(); };
        further.rows.push_back({length(0), length(1), length(2), 1e3 * supports[k].z(), 0.0});
    }
    bars["further_supports"] = further;
    const std::vector<std::array<double, 3>> points{{100, 150, 400}, {1700, 400, 900}, {5000, 4000, 1500}};
    p.measure_points(points);
    const UncertaintyResult r = p.run(0);
    ASSERT_EQ(r.outputs.size(), 9u) << p.words();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d x = Eigen::Vector3d(points[i][0], points[i][1], points[i][2]) / 1e3;
        Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
        for (const Eigen::Vector3d& support : supports) {
            const Eigen::Vector3d d = x - support;
            N += d * d.transpose() / d.squaredNorm() / std::pow(1e-6 + 20e-6 * d.norm(), 2);
        }
        const Eigen::Matrix3d C = N.inverse();
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(r.outputs[3 * i + static_cast<std::size_t>(c)].standard_uncertainty,
                        std::sqrt(C(c, c)), 1e-6 * std::sqrt(C(c, c)))
                << i << "xyz"[c];
    }
}

TEST(TcpFromBallbars, ShortArcsAreWarnedOf) {
    Procedure p;
    p.sequences().rows = {{"x", -90.0, 180.0, 11.0}, {"y", -90.0, 180.0, 11.0}};
    const Row long_arcs = expanded(p.run(0), "TCP");
    EXPECT_NEAR(long_arcs[1], 10.9, 0.1);
    EXPECT_TRUE(p.words().empty()) << p.words();
    p.sequences().rows = {{"x", -20.0, 40.0, 11.0}, {"y", -20.0, 40.0, 11.0}};
    EXPECT_NEAR(expanded(p.run(0), "TCP")[1], 197.0, 1.0);
    EXPECT_NE(p.words().find("inverse square of the span"), std::string::npos) << p.words();
}

TEST(TcpFromBallbars, RefusesWhatCannotWork) {
    Procedure one;
    one.sequences().rows.pop_back();
    EXPECT_TRUE(one.refuses("at least 2 rows") || one.refuses("one circle")) << one.words();
    Procedure same_axis;
    same_axis.sequences().rows[1][0] = std::string("x");
    EXPECT_TRUE(same_axis.refuses("two rotations")) << same_axis.words();
    Procedure on_axis;
    on_axis.sequences().rows[1][0] = std::string("z");
    EXPECT_TRUE(on_axis.refuses("no rotation measures axis y")) << on_axis.words();
    on_axis.set("frame", std::string("x-first"));
    EXPECT_TRUE(on_axis.refuses("traces no circle")) << on_axis.words();
    Procedure no_tool;
    no_tool.set("tool_z", Quantity{0.0, Unit::of("mm")});
    EXPECT_TRUE(no_tool.refuses("traces no circle")) << no_tool.words();
    Procedure below;
    below.asset("ballbars").values["side"] = std::string("negative");
    EXPECT_TRUE(below.refuses("other side")) << below.words();
}

TEST(TcpFromBallbars, RefusesImpossibleSupports) {
    Procedure line;
    for (const char* const key : {"length_13", "length_23"})
        line.asset("ballbars").values[key] = Quantity{260.0, Unit::of("mm")};
    EXPECT_TRUE(line.refuses("on a line")) << line.words();
    Procedure triangle;
    triangle.asset("ballbars").values["length_12"] = Quantity{1100.0, Unit::of("mm")};
    EXPECT_TRUE(triangle.refuses("no triangle")) << triangle.words();
}

}  // namespace
}  // namespace covaria::tcp_project_test
