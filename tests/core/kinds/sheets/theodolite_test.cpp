// Theodolite in rounds (ISO 17123-3) against the scheme of means written here, figures that are known by
// construction, and simulated campaigns.
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/text/cell.h"
#include "tests/core/kinds/sheets/made_sheet.h"

namespace covaria::sheets_test {
namespace {

constexpr const char* theodolite = "theodolite-rounds";
constexpr double second = std::numbers::pi / 180.0 / 3600.0;

/// Readings in both faces, in degrees; NaN: not read.
struct Faces {
    int series, set;
    std::string target;
    double hz_1, hz_2, v_1, v_2;
};

covaria::Setup setup_of(const std::vector<Faces>& readings) {
    const Unit deg = Unit::of("deg");
    SetupTable table;
    table.units = {Unit{}, Unit{}, Unit{}, deg, deg, deg, deg};
    const auto cell = [](double angle) { return std::isnan(angle) ? SetupCell() : SetupCell(angle); };
    for (const Faces& r : readings)
        table.rows.push_back({std::to_string(r.series), std::to_string(r.set), r.target, cell(r.hz_1),
                              cell(r.hz_2), cell(r.v_1), cell(r.v_2)});
    covaria::Setup setup;
    setup.values["readings"] = table;
    return setup;
}

double on_the_circle(double degrees) {
    return degrees - 360.0 * std::floor(degrees / 360.0);
}

/// A campaign with s of the mean of both faces and index in seconds; the circle is turned in every set.
struct Campaign {
    int series = 4, sets = 3, targets = 5;
    double s_hz = 0.8, s_v = 1.1, index = 2.4, collimation = 5.0;

    std::vector<Faces> readings(unsigned seed) const {
        std::mt19937 generator(seed);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> turn(0.0, 360.0);
        const auto scatter = [&](double s) { return std::sqrt(2.0) * s / 3600.0 * normal(generator); };
        std::vector<Faces> all;
        for (int i = 1; i <= series; ++i)
            for (int j = 1; j <= sets; ++j) {
                const double orientation = turn(generator);
                for (int k = 0; k < targets; ++k) {
                    const double hz = orientation + 71.3 * k + i, v = 84.0 + 3.1 * k,
                                 c = collimation / 3600.0, delta = index / 3600.0;
                    all.push_back({i, j, "T" + std::to_string(k), on_the_circle(hz + c + scatter(s_hz)),
                                   on_the_circle(hz + 180.0 - c + scatter(s_hz)), v + delta + scatter(s_v),
                                   360.0 - v + delta + scatter(s_v)});
                }
            }
        return all;
    }
};

/// The scheme of ISO 17123-3 as it is calculated by hand: means of the faces, reduced to the first target,
/// means over the sets, differences, less their mean in each set. Seconds squared.
struct ByHand {
    double hz = 0.0, v = 0.0, index = 0.0, index_squares = 0.0;

    ByHand(const std::vector<Faces>& all, const Campaign& c) {
        std::vector<double> indices(std::size_t(c.series), 0.0);
        const std::size_t in_series = std::size_t(c.sets * c.targets);
        for (std::size_t i = 0; i < std::size_t(c.series); ++i) {
            const Faces* series = &all[i * in_series];
            add_directions(series, c);
            add_zeniths(series, c);
            for (std::size_t n = 0; n < in_series; ++n) indices[i] += index_of(series[n]) / double(in_series);
            for (std::size_t n = 0; n < in_series; ++n)
                index_squares += std::pow(index_of(series[n]) - indices[i], 2);
            index += indices[i] / c.series;
        }
    }

private:
    static double index_of(const Faces& r) { return 3600.0 * 0.5 * (r.v_1 + r.v_2 - 360.0); }
    static double direction(const Faces& r) {
        const double other = r.hz_2 >= 180.0 ? r.hz_2 - 180.0 : r.hz_2 + 180.0;
        const double mean = 0.5 * (r.hz_1 + other);
        return std::abs(r.hz_1 - other) > 180.0 ? mean - 180.0 : mean;
    }

    void add_directions(const Faces* series, const Campaign& c) {
        Eigen::MatrixXd x(c.sets, c.targets);
        for (int j = 0; j < c.sets; ++j)
            for (int k = 0; k < c.targets; ++k)
                x(j, k) = on_the_circle(direction(series[j * c.targets + k]) -
                                        direction(series[j * c.targets]) + 10.0);
        const Eigen::MatrixXd d = x.colwise().mean().replicate(c.sets, 1) - x;
        hz += 3600.0 * 3600.0 * (d - d.rowwise().mean().replicate(1, c.targets)).squaredNorm();
    }

    void add_zeniths(const Faces* series, const Campaign& c) {
        Eigen::MatrixXd x(c.sets, c.targets);
        for (int j = 0; j < c.sets; ++j)
            for (int k = 0; k < c.targets; ++k) {
                const Faces& r = series[j * c.targets + k];
                x(j, k) = 0.5 * (r.v_1 - r.v_2 + 360.0);
            }
        v += 3600.0 * 3600.0 * (x.colwise().mean().replicate(c.sets, 1) - x).squaredNorm();
    }
};

TEST(TheodoliteRounds, EqualTheSchemeByHand) {
    const Campaign c;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const std::vector<Faces> readings = c.readings(seed);
        const auto model = made(theodolite, setup_of(readings));
        const ByHand hand(readings, c);
        const FirstOrderOutput hz = first_order(*model, "s_Hz"), v = first_order(*model, "s_V"),
                               delta = first_order(*model, "delta");
        EXPECT_NEAR(hz.estimate / second, std::sqrt(hand.hz / 32.0), 1e-8);
        EXPECT_NEAR(v.estimate / second, std::sqrt(hand.v / 40.0), 1e-8);
        EXPECT_NEAR(hz.standard_uncertainty / hz.estimate, 1.0 / 8.0, 1e-12) << "1/sqrt(2 32)";
        EXPECT_NEAR(v.standard_uncertainty / v.estimate, 1.0 / std::sqrt(80.0), 1e-12);
        EXPECT_NEAR(delta.estimate / second, hand.index, 1e-8);
        EXPECT_NEAR(delta.standard_uncertainty / second, std::sqrt(hand.index_squares / 56.0 / 60.0), 1e-8);
        EXPECT_NEAR(delta.effective_degrees_of_freedom, 56.0, 1e-6);
        const Table sheet = table_of(model->evaluation(), "sheet");
        EXPECT_EQ(value(sheet.columns[4].cell(0)), 32.0);
        EXPECT_EQ(value(sheet.columns[4].cell(1)), 40.0);
        EXPECT_NEAR(value(sheet.columns[3].cell(0)), 12.5, 1e-9) << "%";
    }
}

// Two sets of two targets: an angle that is 4" larger in the second one has residuals of 1" (nu = 1);
// zenith angles that differ by 6" and by 8" between the sets have residuals of 3" and 4" (nu = 2).
TEST(TheodoliteRounds, FiguresThatAreKnown) {
    const double s = 1.0 / 3600.0;
    const auto model =
        made(theodolite, setup_of({{1, 1, "A", 10.0, 190.0, 90.0, 270.0},
                                   {1, 1, "B", 70.0, 250.0, 80.0, 280.0},
                                   {1, 2, "A", 359.0, 179.0, 90.0 + 6 * s, 270.0 - 6 * s},
                                   {1, 2, "B", 59.0 + 4 * s, 239.0 + 4 * s, 80.0 + 8 * s, 280.0 - 8 * s}}));
    EXPECT_NEAR(first_order(*model, "s_Hz").estimate / second, 2.0, 1e-8);
    EXPECT_NEAR(first_order(*model, "s_V").estimate / second, std::sqrt((2 * 9.0 + 2 * 16.0) / 2.0), 1e-8);
    EXPECT_NEAR(first_order(*model, "delta").estimate / second, 0.0, 1e-8);
    EXPECT_NEAR(first_order(*model, "s_Hz").standard_uncertainty / second, std::sqrt(2.0), 1e-8);
    const Table left = table_of(model->evaluation(), "directions");
    ASSERT_EQ(left.rows, 2u);
    for (std::size_t set = 0; set < 2; ++set)
        for (std::size_t target = 0; target < 2; ++target)
            EXPECT_NEAR(value(left.columns[2 + target].cell(set)) / second, set == target ? -1.0 : 1.0, 1e-8);
}

// Ten targets do not stand abreast: a second table has the last two.
TEST(TheodoliteRounds, ManyTargetsTakeMoreTables) {
    Campaign c;
    c.targets = 10;
    const auto tables = made(theodolite, setup_of(c.readings(1)))->evaluation();
    EXPECT_EQ(table_of(tables, "directions").columns.size(), 2u + 8u);
    const Table rest = table_of(tables, "directions-2");
    EXPECT_EQ(rest.columns.size(), 2u + 2u);
    EXPECT_EQ(rest.rows, 12u);
    EXPECT_EQ(rest.columns[3].key, "T9");
}

// Collimation and index leave the means of both faces, and the circle may be turned and pass zero.
TEST(TheodoliteRounds, ErrorsOfTheAxesLeaveTheMeans) {
    Campaign straight, crooked;
    straight.collimation = straight.index = 0.0;
    crooked.collimation = 90.0;
    crooked.index = -40.0;
    const auto a = made(theodolite, setup_of(straight.readings(3))),
               b = made(theodolite, setup_of(crooked.readings(3)));
    EXPECT_NEAR(first_order(*a, "s_Hz").estimate / second, first_order(*b, "s_Hz").estimate / second, 1e-7);
    EXPECT_NEAR(first_order(*a, "s_V").estimate / second, first_order(*b, "s_V").estimate / second, 1e-7);
    EXPECT_NEAR((first_order(*b, "delta").estimate - first_order(*a, "delta").estimate) / second, -40.0,
                1e-7);
}

// A reading that is left out: the other residuals are those of a dense least squares by normal equations.
TEST(TheodoliteRounds, AReadingLeftOutLeavesTheOthers) {
    Campaign c;
    c.series = 1;
    std::vector<Faces> readings = c.readings(9);
    readings[7].hz_1 = readings[7].hz_2 = std::nan("");
    readings.erase(readings.begin());
    const auto model = made(theodolite, setup_of(readings));
    // Unknowns: orientations of three sets, directions of T1 to T4 relative to T0; whole turns taken out.
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(13, 7);
    Eigen::VectorXd l(13);
    Eigen::Index n = 0;
    std::array<double, 3> turn{};
    for (const Faces& r : readings) {
        if (std::isnan(r.hz_1)) continue;
        const int k = r.target[1] - '0';
        const double mean = 0.5 * (r.hz_1 + on_the_circle(r.hz_2 + 180.0)) +
                            (std::abs(r.hz_1 - on_the_circle(r.hz_2 + 180.0)) > 180.0 ? 180.0 : 0.0);
        double& start = turn[std::size_t(r.set - 1)];
        if (start == 0.0) start = mean - 71.3 * k;
        design(n, r.set - 1) = 1.0;
        if (k > 0) design(n, 2 + k) = 1.0;
        l[n++] = 3600.0 * std::remainder(mean - start - 71.3 * k, 360.0);
    }
    ASSERT_EQ(n, 13);
    const Eigen::VectorXd x = (design.transpose() * design).inverse() * design.transpose() * l;
    const double s = std::sqrt((design * x - l).squaredNorm() / 6.0);
    EXPECT_NEAR(first_order(*model, "s_Hz").estimate / second, s, 1e-8);
    const Table series = table_of(model->evaluation(), "series");
    EXPECT_EQ(value(series.columns[2].cell(0)), 6.0) << "13 - 7";
    EXPECT_EQ(value(series.columns[4].cell(0)), 9.0) << "14 - 5";
}

// Quantiles of chi-squared, F and t: 8, 32, 40 and 56 degrees of freedom.
TEST(TheodoliteRounds, LimitsOfTheTestsAreQuantiles) {
    const auto tests_of = [](int series, double nu_hz, double nu_v) {
        Campaign c;
        c.series = series;
        covaria::Setup setup = setup_of(c.readings(2));
        for (const char* key : {"direction", "zenith"}) {
            setup.values["stated_" + std::string(key)] = Quantity{2.0, Unit::of("arcsec")};
            setup.values["other_" + std::string(key)] = Quantity{1.0, Unit::of("arcsec")};
        }
        setup.values["other_degrees_of_freedom_direction"] = Quantity{nu_hz, Unit{}};
        setup.values["other_degrees_of_freedom_zenith"] = Quantity{nu_v, Unit{}};
        return table_of(made(theodolite, setup)->evaluation(), "tests");
    };
    const Table four = tests_of(4, 32.0, 40.0), one = tests_of(1, 8.0, 10.0);
    ASSERT_EQ(four.rows, 6u);
    ASSERT_EQ(one.rows, 5u) << "one series has none to compare its index with";
    EXPECT_NEAR(value(four.columns[3].cell(0)) / 2.0, 1.2015, 5e-5);
    EXPECT_NEAR(value(one.columns[3].cell(0)) / 2.0, 1.3923, 5e-5);
    EXPECT_NEAR(value(one.columns[3].cell(2)) / 2.0, 1.3530, 5e-5);
    EXPECT_NEAR(value(four.columns[2].cell(1)), 0.4939, 5e-5);
    EXPECT_NEAR(value(four.columns[3].cell(1)), 2.0247, 5e-5);
    EXPECT_NEAR(value(four.columns[3].cell(2)) / 2.0, 1.1807, 5e-5);
    EXPECT_NEAR(value(four.columns[2].cell(3)), 0.5333, 5e-5);
    EXPECT_NEAR(value(four.columns[3].cell(3)), 1.8752, 5e-5);
}

TEST(TheodoliteRounds, ANegativeIndexFailsAsAPositiveOneDoes) {
    const auto verdict = [](double index) {
        Campaign c;
        c.index = index;
        const Table tests = table_of(made(theodolite, setup_of(c.readings(4)))->evaluation(), "tests");
        return english_of(tests.columns[4].cell(0));
    };
    EXPECT_EQ(verdict(3.0), "not passed");
    EXPECT_EQ(verdict(-3.0), "not passed");
    EXPECT_EQ(verdict(0.0), "passed");
}

// An index that moves by 3" between the series: each series agrees in itself, the test sees it.
TEST(TheodoliteRounds, AnIndexThatMovesIsSeen) {
    const auto verdict = [](double moves) {
        std::vector<Faces> readings = Campaign().readings(6);
        for (Faces& r : readings) {
            r.v_1 += moves * r.series / 3600.0;
            r.v_2 += moves * r.series / 3600.0;
        }
        const Table tests = table_of(made(theodolite, setup_of(readings))->evaluation(), "tests");
        return english_of(tests.columns[4].cell(1));
    };
    EXPECT_EQ(verdict(0.0), "passed");
    EXPECT_EQ(verdict(3.0), "not passed");
}

// Over campaigns: s^2 is unbiased, u(s) is its scatter, the interval of the index has its probability, and
// an instrument as good as stated passes test a in 95 of 100. Four standard errors of each.
TEST(TheodoliteRounds, DispersionOfCampaignsIsWhatIsStated) {
    const int campaigns = 800;
    double squares = 0.0, sum = 0.0, covered = 0.0, passed = 0.0;
    for (unsigned seed = 1; seed <= unsigned(campaigns); ++seed) {
        covaria::Setup setup = setup_of(Campaign().readings(1000 + seed));
        setup.values["stated_direction"] = Quantity{0.8, Unit::of("arcsec")};
        const auto model = made(theodolite, setup);
        const FirstOrderOutput hz = first_order(*model, "s_Hz"), delta = first_order(*model, "delta");
        sum += hz.estimate / second;
        squares += hz.estimate * hz.estimate / (second * second);
        covered += std::abs(delta.estimate / second - 2.4) <= 2.0032 * delta.standard_uncertainty / second;
        passed += english_of(table_of(model->evaluation(), "tests").columns[4].cell(0)) == "passed";
    }
    const double n = campaigns, mean = sum / n, binomial = std::sqrt(0.95 * 0.05 / n);
    const double deviation = std::sqrt(squares / n - mean * mean);
    EXPECT_NEAR(squares / n, 0.64, 4.0 * 0.64 * std::sqrt(2.0 / 32.0 / n));
    const double c4 = std::sqrt(2.0 / 32.0) * std::exp(std::lgamma(16.5) - std::lgamma(16.0));
    const double exact = 0.8 * std::sqrt(1.0 - c4 * c4);  // of the s of 32 degrees of freedom
    EXPECT_NEAR(exact, 0.8 / 8.0, 0.01 * 0.1) << "u(s) = s/sqrt(2 nu) is near to it";
    EXPECT_NEAR(deviation, exact, 4.0 * exact / std::sqrt(2.0 * n));
    EXPECT_NEAR(covered / n, 0.95, 4.0 * binomial);
    EXPECT_NEAR(passed / n, 0.95, 4.0 * binomial);
}

// t with 56 degrees of freedom has the standard deviation u sqrt(56/54).
TEST(TheodoliteRounds, MonteCarloDrawsTheirDistributions) {
    const auto model = made(theodolite, setup_of(Campaign().readings(8)));
    EvaluationOptions options;
    options.trials = 200'000;
    const auto result = evaluate(*model, model->inputs(), options);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->outputs.size(), 3u);
    for (const OutputResult& y : result->outputs) {
        const double widened = y.quantity.symbol == "delta" ? std::sqrt(56.0 / 54.0) : 1.0;
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty, widened * y.first_order.standard_uncertainty,
                    4.0 * y.monte_carlo->standard_error_of_uncertainty)
            << y.quantity.symbol;
        EXPECT_NEAR(y.monte_carlo->mean, y.first_order.estimate, 4.0 * y.monte_carlo->standard_error_of_mean);
    }
}

TEST(TheodoliteRounds, DirectionsOrZenithAnglesAlone) {
    std::vector<Faces> readings = Campaign().readings(5);
    for (Faces& r : readings) r.v_1 = r.v_2 = std::nan("");
    EXPECT_EQ(made(theodolite, setup_of(readings))->outputs().size(), 1u);
    readings = Campaign().readings(5);
    for (Faces& r : readings) r.hz_1 = r.hz_2 = std::nan("");
    EXPECT_EQ(made(theodolite, setup_of(readings))->outputs().size(), 2u);
}

TEST(TheodoliteRounds, RefusesWhatCannotBe) {
    const auto refused = [](const std::function<void(std::vector<Faces>&)>& spoil) {
        std::vector<Faces> readings = Campaign().readings(7);
        spoil(readings);
        Problems problems;
        return !made(theodolite, setup_of(readings), problems) && problems.has_errors();
    };
    EXPECT_FALSE(refused([](auto&) {}));
    EXPECT_TRUE(refused([](auto& all) { all[3].hz_2 = std::nan(""); })) << "one face";
    EXPECT_TRUE(refused([](auto& all) { std::swap(all[3].v_1, all[3].v_2); })) << "faces exchanged";
    EXPECT_TRUE(refused([](auto& all) { all[3].hz_2 = on_the_circle(all[3].hz_2 + 71.3); })) << "target";
    EXPECT_TRUE(refused([](auto& all) { all[4].target = all[3].target; })) << "twice";
    EXPECT_TRUE(refused([](auto& all) {
        all[3].hz_1 = all[3].hz_2 = all[3].v_1 = all[3].v_2 = std::nan("");
    })) << "nothing";
    EXPECT_TRUE(refused([](auto& all) { all.resize(5); })) << "one set leaves no degrees of freedom";
}

}  // namespace
}  // namespace covaria::sheets_test
