// Distance meter on a baseline (ISO 17123-4) against closed forms and a dense solution written here.
#include <Eigen/LU>
#include <cmath>
#include <random>

#include "core/text/cell.h"
#include "tests/core/kinds/sheets/made_sheet.h"

namespace covaria::sheets_test {
namespace {

constexpr const char* baseline = "distance-meter-baseline";

struct Read {
    std::size_t from, to;
    double distance;
};

covaria::Setup setup_of(const std::vector<Read>& readings) {
    SetupTable table;
    table.units = {Unit{}, Unit{}, Unit::of("m"), Unit::of("m")};
    for (const Read& r : readings)
        table.rows.push_back(
            {"P" + std::to_string(r.from), "P" + std::to_string(r.to), r.distance, std::monostate{}});
    covaria::Setup setup;
    setup.values["readings"] = table;
    return setup;
}

/// Distances of all pairs, with a zero offset and normal scatter.
std::vector<Read> all_pairs(const std::vector<double>& places, double zero, double sigma, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> scatter(0.0, sigma);
    std::vector<Read> readings;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = i + 1; j < places.size(); ++j)
            readings.push_back(
                {i, j, places[j] - places[i] - zero + (sigma > 0.0 ? scatter(generator) : 0.0)});
    return readings;
}

std::vector<double> places_of(std::size_t pillars, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> step(5.0, 180.0);
    std::vector<double> places{0.0};
    while (places.size() < pillars) places.push_back(places.back() + step(generator));
    return places;
}

/// Normal equations of the readings as they stand, unknowns: places of all but the first, zero offset.
struct Dense {
    Eigen::VectorXd x;
    Eigen::MatrixXd q;
    double s = 0.0;

    Dense(const std::vector<Read>& readings, std::size_t pillars) {
        const auto n = Eigen::Index(readings.size()), u = Eigen::Index(pillars);
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, u);
        Eigen::VectorXd l(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Read& r = readings[std::size_t(i)];
            const std::size_t low = std::min(r.from, r.to), high = std::max(r.from, r.to);
            if (low > 0) a(i, Eigen::Index(low) - 1) = -1.0;
            a(i, Eigen::Index(high) - 1) = 1.0;
            a(i, u - 1) = -1.0;
            l[i] = r.distance;
        }
        q = (a.transpose() * a).inverse();
        x = q * a.transpose() * l;
        s = std::sqrt((a * x - l).squaredNorm() / double(n - u));
    }
};

TEST(DistanceMeter, CofactorOfTheZeroOffsetIsThatOfTheNumberOfPillars) {
    for (std::size_t n = 4; n <= 12; ++n)
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const auto model = made(baseline, setup_of(all_pairs(places_of(n, seed), 0.002, 1e-3, seed)));
            const Table sheet = table_of(model->evaluation(), "sheet");
            const double expected = 6.0 / (double(n - 1) * double(n - 2));
            EXPECT_NEAR(value(sheet.columns[1].cell(7)), expected, 1e-12) << n;
            EXPECT_EQ(value(sheet.columns[1].cell(2)), double(n * (n - 1) / 2 - n));
            const FirstOrderOutput delta = first_order(*model, "delta"), s = first_order(*model, "s");
            EXPECT_NEAR(delta.standard_uncertainty, s.estimate * std::sqrt(expected), 1e-12);
            EXPECT_NEAR(delta.effective_degrees_of_freedom, double(n * (n - 1) / 2 - n), 1e-6);
        }
}

TEST(DistanceMeter, EqualsADenseSolution) {
    std::vector<Read> readings = all_pairs(places_of(6, 5), -0.0013, 0.6e-3, 11);
    readings.erase(readings.begin() + 3);
    readings.push_back({4, 1, readings[6].distance + 0.0007});
    readings.push_back({0, 5, readings[3].distance - 0.0004});
    const auto model = made(baseline, setup_of(readings));
    const Dense dense(readings, 6);
    const FirstOrderOutput delta = first_order(*model, "delta");
    EXPECT_NEAR(delta.estimate, dense.x[5], 1e-11);
    EXPECT_NEAR(delta.standard_uncertainty, dense.s * std::sqrt(dense.q(5, 5)), 1e-11);
    EXPECT_NEAR(first_order(*model, "s").estimate, dense.s, 1e-11);
    for (Eigen::Index k = 0; k < 5; ++k) {
        const FirstOrderOutput x = first_order(*model, "X_" + std::to_string(k + 2));
        EXPECT_NEAR(x.estimate, dense.x[k], 1e-9);
        EXPECT_NEAR(x.standard_uncertainty, dense.s * std::sqrt(dense.q(k, k)), 1e-11);
    }
    const auto result = evaluate_first_order(*model, model->inputs(), {});
    ASSERT_TRUE(result);
    EXPECT_NEAR(first_order_covariance(*result)(0, 4), dense.s * dense.s * dense.q(5, 2),
                1e-6 * dense.s * dense.s);
}

// The places of the pillars and the beginning of the line follow from the distances.
TEST(DistanceMeter, PillarsAreFoundInWhateverOrderTheyAreRead) {
    std::vector<Read> readings = all_pairs(places_of(6, 8), 0.004, 0.5e-3, 3), turned = readings;
    std::swap(turned[2], turned[9]);
    std::rotate(turned.begin(), turned.begin() + 7, turned.end());
    for (std::size_t i = 0; i < turned.size(); i += 2) std::swap(turned[i].from, turned[i].to);
    const auto a = made(baseline, setup_of(readings)), b = made(baseline, setup_of(turned));
    EXPECT_NEAR(first_order(*a, "delta").estimate, first_order(*b, "delta").estimate, 1e-11);
    EXPECT_NEAR(first_order(*a, "s").estimate, first_order(*b, "s").estimate, 1e-11);
}

TEST(DistanceMeter, ASlopeDistanceCountsWithItsHeightDifference) {
    const std::vector<double> places = places_of(5, 2), heights{0.0, 3.0, -4.0, 9.0, 14.0};
    std::vector<Read> readings = all_pairs(places, 0.0, 0.0, 1);
    covaria::Setup setup = setup_of(readings);
    auto& table = std::get<SetupTable>(setup.values["readings"]);
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const double rise = heights[readings[i].to] - heights[readings[i].from];
        table.rows[i][2] = std::hypot(readings[i].distance, rise) + 0.0025;
        table.rows[i][3] = rise;
    }
    const auto model = made(baseline, setup);
    EXPECT_NEAR(first_order(*model, "delta").estimate, -0.0025, 1e-10);
    EXPECT_NEAR(first_order(*model, "X_5").estimate, places[4], 1e-9);
}

// Limits of test a over sigma: quantiles of chi-squared for 14 and 27 degrees of freedom; of b: of F for 14.
TEST(DistanceMeter, LimitsOfTheTestsAreQuantiles) {
    for (const auto& [pillars, factor] : {std::pair<std::size_t, double>{7, 1.3007}, {9, 1.2189}}) {
        covaria::Setup setup = setup_of(all_pairs(places_of(pillars, 4), 0.0, 1e-3, 6));
        setup.values["stated_s"] = Quantity{2.0, Unit::of("mm")};
        setup.values["other_s"] = Quantity{1.1, Unit::of("mm")};
        setup.values["other_degrees_of_freedom"] = Quantity{pillars == 7 ? 14.0 : 27.0, Unit{}};
        const auto model = made(baseline, setup);
        const Table tests = table_of(model->evaluation(), "tests");
        ASSERT_EQ(tests.rows, 3u);
        EXPECT_NEAR(value(tests.columns[3].cell(0)) / 2.0, factor, 5e-5);
        EXPECT_NEAR(value(tests.columns[2].cell(1)), pillars == 7 ? 0.3357 : 0.4628, 5e-5);
        EXPECT_NEAR(value(tests.columns[3].cell(1)), pillars == 7 ? 2.9786 : 2.1609, 5e-5);
        const FirstOrderOutput delta = first_order(*model, "delta");
        EXPECT_NEAR(value(tests.columns[3].cell(2)) / (1e3 * delta.standard_uncertainty),
                    pillars == 7 ? 2.1448 : 2.0518, 5e-5);
    }
}

TEST(DistanceMeter, ANegativeZeroOffsetFailsAsAPositiveOneDoes) {
    const auto verdict = [](double zero) {
        const auto model = made(baseline, setup_of(all_pairs(places_of(7, 4), zero, 0.3e-3, 6)));
        const Table tests = table_of(model->evaluation(), "tests");
        return english_of(tests.columns[4].cell(tests.rows - 1));
    };
    EXPECT_EQ(verdict(0.01), "not passed");
    EXPECT_EQ(verdict(-0.01), "not passed");
    EXPECT_EQ(verdict(0.0), "passed");
}

// m = sum g (L - X) by the covariance of the lengths, then all shares of its variance by hand.
TEST(DistanceMeter, ScaleByReferenceLengths) {
    const std::vector<double> places = places_of(6, 9);
    std::vector<Read> readings = all_pairs(places, 0.001, 0.4e-3, 21);
    for (Read& r : readings) r.distance /= 1.0 + 3e-6;
    covaria::Setup setup = setup_of(readings);
    setup.values["scale"] = std::string("reference");
    SetupTable table;
    table.units = {Unit{}, Unit::of("m"), Unit::of("mm")};
    const std::vector<std::size_t> known{2, 3, 5};
    const double u[] = {0.1e-3, 0.25e-3, 0.2e-3};
    for (std::size_t i = 0; i < 3; ++i)
        table.rows.push_back({"P" + std::to_string(known[i]), places[known[i]], 1e3 * u[i]});
    setup.values["reference"] = table;
    setup.values["u_reference_scale"] = Quantity{0.4, Unit::of("ppm")};
    setup.values["u_atmosphere"] = Quantity{0.7, Unit::of("ppm")};
    const auto model = made(baseline, setup);
    const Dense dense(readings, 6);
    Eigen::Matrix3d v;
    Eigen::Vector3d x, l;
    for (Eigen::Index i = 0; i < 3; ++i) {
        x[i] = dense.x[Eigen::Index(known[std::size_t(i)]) - 1];
        l[i] = places[known[std::size_t(i)]];
        for (Eigen::Index j = 0; j < 3; ++j)
            v(i, j) = dense.s * dense.s *
                          dense.q(Eigen::Index(known[std::size_t(i)]) - 1,
                                  Eigen::Index(known[std::size_t(j)]) - 1) +
                      (i == j ? u[i] * u[i] : 0.0);
    }
    const Eigen::Vector3d g = v.inverse() * x / (x.dot(v.inverse() * x));
    const double common = 0.4e-6 * g.dot(l), air = 0.7e-6 * g.dot(x);
    const FirstOrderOutput m = first_order(*model, "m");
    EXPECT_NEAR(m.estimate, g.dot(l - x), 1e-12);
    EXPECT_NEAR(m.standard_uncertainty, std::sqrt(g.dot(v * g) + common * common + air * air), 1e-12);
}

TEST(DistanceMeter, RefusesWhatDoesNotTellTheZeroOffset) {
    const auto refused = [](const std::vector<Read>& readings) {
        Problems problems;
        return !made(baseline, setup_of(readings), problems) && problems.has_errors();
    };
    EXPECT_TRUE(refused({{0, 1, 10.0}, {1, 2, 11.0}, {2, 3, 12.0}, {0, 1, 10.001}, {1, 2, 11.001}}))
        << "no distance is read whole and in parts";
    EXPECT_TRUE(refused({{0, 1, 10.0}, {0, 1, 10.001}, {2, 3, 12.0}, {2, 3, 12.0}, {2, 3, 12.001}}))
        << "two pieces";
    EXPECT_TRUE(refused({{0, 1, 10.0}, {0, 1, 10.001}, {0, 1, 10.0}, {1, 1, 12.0}})) << "of no length";
    EXPECT_FALSE(refused({{0, 1, 10.0}, {1, 2, 11.0}, {0, 2, 21.003}, {0, 2, 21.002}}));
}

}  // namespace
}  // namespace covaria::sheets_test
