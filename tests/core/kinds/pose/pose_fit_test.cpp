// Measured points against their nominal coordinates: chi-square, redundancy, what explains a misfit.
#include "core/kinds/pose/tables.h"

#include <gtest/gtest.h>

#include <random>

#include "core/math/rotation.h"
#include "tests/core/kinds/pose/pose_case.h"
#include "tests/core/kinds/pose/stewart.h"
#include "tests/core/table_rows.h"

namespace covaria::pose_fit_test {
namespace {

using namespace stewart;

std::vector<std::string> warnings_of(const std::string& name) {
    const Project project = pose_case::project(name);
    Problems problems;
    EXPECT_TRUE(pose_case::prepared(project, "post", problems)) << name;
    std::vector<std::string> texts;
    for (const Problem& p : problems.items()) {
        EXPECT_EQ(p.severity, Severity::warning);
        EXPECT_EQ(p.path, "/analyses/0/setup/measured_points") << p.message.english();
        texts.push_back(p.message.english());
    }
    return texts;
}

bool says(const std::vector<std::string>& texts, const std::string& set, const std::string& words) {
    for (const std::string& text : texts)
        if (text.find("'" + set + "'") != std::string::npos && text.find(words) != std::string::npos)
            return true;
    return false;
}

TEST(PoseFit, ExchangedNamesAreFound) {
    const auto texts = warnings_of("swap");
    EXPECT_TRUE(says(texts, "base", "with b1 and b2 exchanged"));
    EXPECT_FALSE(says(texts, "A", "exchanged"));
}

TEST(PoseFit, ALeftHandedFrameIsFound) {
    const auto texts = warnings_of("mirror");
    for (const char* set : {"base", "A", "B"}) EXPECT_TRUE(says(texts, set, "left-handed")) << set;
}

constexpr int points = 6;

/// A posteriori: six points off a plane, measured with the deviations given.
covaria::Setup measured(const std::array<double, 3>& u, unsigned seed, bool common) {
    const Points local{{-300, 100, 20}, {310, 90, -40}, {280, -200, 60},
                       {-250, -220, 0}, {20, 30, 150},  {10, -90, -120}};
    covaria::Setup s = setup(base_688, local, {.1, .1, .1}, 0.0);
    s.values["evaluation"] = std::string("a-posteriori");
    s.values["moving_fit"] = std::string("least-squares");
    s.values["base_fit"] = std::string("least-squares");
    s.values["poses"] = poses_table({{0, 0, 0, 0, 0, 0}});
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    SetupTable table = empty_table("measured_points");
    for (std::size_t i = 0; i < 3; ++i)
        table.rows.push_back({std::string("base"), "b" + std::to_string(i + 1), 1.0, base_688[i][0],
                              base_688[i][1], base_688[i][2]});
    const std::array<double, 3> shared{normal(generator), normal(generator), normal(generator)};
    const Eigen::Matrix3d R = rotation_from_zyx<double>({0.4, -1.1, 2.0});
    for (std::size_t i = 0; i < points; ++i) {
        Eigen::Vector3d p(local[i].data());
        for (int c = 0; c < 3; ++c) {
            const auto k = static_cast<std::size_t>(c);
            p[c] += u[k] * (common && c == 2 ? shared[k] : normal(generator));
        }
        p = R * p + Eigen::Vector3d(100, -2000, 800);
        table.rows.push_back({std::string("pose 1"), "p" + std::to_string(i + 1), 1.0, p.x(), p.y(), p.z()});
    }
    s.values["measured_points"] = table;
    const char* const keys[] = {"moving_u_x", "moving_u_y", "moving_u_z"};
    for (std::size_t k = 0; k < 3; ++k) s.values[keys[k]] = mm(u[k]);
    s.values["moving_common_z"] = common;
    return s;
}

Table fits_of(const covaria::Setup& s) {
    const auto tables = make(s)->evaluation();
    EXPECT_EQ(tables.size(), 2u);
    return tables.front();
}

// If the uncertainties are true, chi-square has the mean of its degrees of freedom; and the redundancies sum
// up to them.
TEST(PoseFit, ChiSquareHasItsDegreesOfFreedom) {
    for (bool common : {false, true}) {
        double sum = 0.0, small = 0.0, degrees = 0.0;
        constexpr int repeats = 400;
        for (unsigned k = 0; k < repeats; ++k) {
            const Table table = fits_of(measured({.05, .2, .1}, 1000 + k, common));
            degrees = test::si_of(table.columns[3].cell(1));
            sum += test::si_of(table.columns[4].cell(1));
            small += test::si_of(table.columns[5].cell(1)) < 0.5;
        }
        EXPECT_EQ(degrees, common ? 3.0 * points - 6.0 - 3.0 : 3.0 * points - 6.0);
        EXPECT_NEAR(sum / repeats, degrees, 4 * std::sqrt(2 * degrees / repeats));
        EXPECT_NEAR(small / repeats, 0.5, 4 * 0.5 / std::sqrt(repeats));
    }
}

TEST(PoseFit, RedundanciesSumUp) {
    const Table table = make(measured({.05, .2, .1}, 5, false))->evaluation()[1];
    double sum = 0.0;
    for (const auto& row : test::rows_of(table))
        if (std::get<std::string>(row[0]) == "pose 1")
            for (std::size_t c = 8; c < 11; ++c) sum += test::si_of(row[c]);
    EXPECT_NEAR(sum, 3.0 * points - 6.0, 1e-9);
}

TEST(PoseFit, ABadPointIsNamed) {
    covaria::Setup s = measured({.05, .05, .05}, 3, false);
    auto& rows = std::get<SetupTable>(s.values["measured_points"]).rows;
    rows[5][4] = std::get<double>(rows[5][4]) + 3.0;
    Problems problems;
    const auto model = make(s, problems);
    ASSERT_TRUE(model);
    ASSERT_EQ(problems.items().size(), 1u);
    EXPECT_NE(problems.items()[0].message.english().find("(p3, "), std::string::npos)
        << problems.items()[0].message.english();
}

TEST(PoseFit, APrioriHasNothingToFit) {
    covaria::Setup s = setup();
    s.values["moving_fit"] = std::string("least-squares");
    EXPECT_TRUE(make(s)->evaluation().empty());
}

}  // namespace
}  // namespace covaria::pose_fit_test
