// Calibration curves against published fits.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/core/kinds/curve/curve_setups.h"

namespace covaria::calibration_curve_test {
namespace {

using namespace curve_setups;

TEST(CalibrationCurve, APolynomialGoesThroughItsPoints) {
    Points p;
    for (int i = 0; i < 9; ++i) {
        p.x.push_back(i);
        p.y.push_back(2.0 - 0.5 * i + 0.25 * i * i - 0.01 * i * i * i);
    }
    Problems problems;
    const auto model = model_of(setup_of(p, "residuals", 3), problems);
    ASSERT_TRUE(model);
    const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
    const double expected[] = {2.0, -0.5, 0.25, -0.01};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(result.outputs[k].estimate, expected[k], 1e-9);
}

TEST(CalibrationCurve, TheFormulaHasTheTermsOfItsDegree) {
    const auto formula = [](int degree) {
        Problems problems;
        const auto model = model_of(setup_of(five(), "residuals", degree), problems);
        return model ? model->formulas().front().text : "";
    };
    EXPECT_EQ(formula(1), "b(x) = y₁ + y₂ (x − x₀)");
    EXPECT_EQ(formula(2), "b(x) = y₁ + y₂ (x − x₀) + y₃ (x − x₀)²");
}

// One s for all coefficients: its n - p degrees of freedom hold for every result and any origin. The
// coverage interval by Monte Carlo is that of one t distribution.
TEST(CalibrationCurve, EveryResultHasTheDegreesOfFreedomOfTheResiduals) {
    for (const double origin : {-40.0, -2.0, 0.0, 0.3, 1.5, 1e5}) {
        covaria::Setup setup = setup_of(five(), "residuals");
        set_number(setup, "origin", origin);
        use_at(setup, {1.5, -7.0});
        Problems problems;
        const auto model = model_of(setup, problems);
        ASSERT_TRUE(model);
        const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
        for (const OutputResult& o : result.outputs) {
            EXPECT_NEAR(o.first_order.effective_degrees_of_freedom, 3.0, 1e-9) << o.quantity.symbol << origin;
            EXPECT_NEAR(o.first_order.coverage_factor, 3.18244630528, 1e-9);
        }
        EXPECT_NEAR(output(result, "b_1").first_order.expanded_uncertainty, 0.32141124, 1e-7);
        EvaluationOptions options;
        options.trials = 200000;
        const auto drawn = evaluate(*model, model->inputs(), options).value();
        for (const OutputResult& o : drawn.outputs) {
            const CoverageInterval& interval = o.monte_carlo->symmetric;
            // 4 standard errors of a 97.5 % quantile of t(3): sqrt(p(1 - p)/M)/f(q)
            const double tolerance =
                4.0 * std::sqrt(0.025 * 0.975 / 2e5) / 0.0136 * o.first_order.standard_uncertainty;
            EXPECT_NEAR(interval.high, o.first_order.estimate + o.first_order.expanded_uncertainty,
                        tolerance);
            EXPECT_NEAR(interval.low, o.first_order.estimate - o.first_order.expanded_uncertainty, tolerance);
        }
    }
}

// x = 2000 ... 2020, degree 3: far from the origin the powers are nearly the same column.
TEST(CalibrationCurve, PredictionsDoNotDependOnTheOrigin) {
    Points p;
    for (int i = 0; i <= 20; ++i) {
        p.x.push_back(2000 + i);
        p.y.push_back(2.0 + std::sin(0.2 * i));
    }
    for (const int degree : {1, 3, 6, 10}) {
        covaria::Setup setup = setup_of(p, "residuals", degree);
        use_at(setup, {2003.25, 2015.5, 2022.0});
        set_number(setup, "origin", 2010.0);
        const auto reference = first_order(setup);
        for (const double origin : {0.0, 2000.0, -1e4}) {
            set_number(setup, "origin", origin);
            const auto moved = first_order(setup);
            for (const char* symbol : {"b_1", "b_2", "b_3"}) {
                const FirstOrderOutput &a = output(moved, symbol).first_order,
                                       &b = output(reference, symbol).first_order;
                EXPECT_NEAR(a.estimate, b.estimate, 1e-14 * std::abs(b.estimate)) << degree << " " << origin;
                EXPECT_NEAR(a.standard_uncertainty, b.standard_uncertainty, 1e-14);
            }
        }
    }
}

struct Textbook {
    double value, u;
};

/// Prediction and its u at x, by Householder's QR of powers about the middle, in extended precision.
Textbook by_qr(const Points& p, int degree, bool through_zero, double x) {
    using Matrix = Eigen::Matrix<long double, -1, -1>;
    using Vector = Eigen::Matrix<long double, -1, 1>;
    const auto [low, high] = std::minmax_element(p.x.begin(), p.x.end());
    const long double middle = through_zero ? 0.0L : 0.5L * (*low + *high), width = 0.5L * (*high - *low);
    const int first = through_zero ? 1 : 0, columns = degree + 1 - first;
    const auto row = [&](double at) {
        Vector powers(columns);
        for (int k = 0; k < columns; ++k)
            powers[k] = std::pow((at - middle) / width, (long double)(k + first));
        return powers;
    };
    Matrix design(Eigen::Index(p.x.size()), columns);
    Vector y(Eigen::Index(p.x.size()));
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        design.row(i) = row(p.x[std::size_t(i)]).transpose();
        y[i] = p.y[std::size_t(i)];
    }
    const Eigen::HouseholderQR<Matrix> qr(design);
    const Vector a = qr.solve(y);
    const long double s2 = (y - design * a).squaredNorm() / (long double)(design.rows() - columns);
    const Matrix r = qr.matrixQR().topRows(columns).template triangularView<Eigen::Upper>();
    const Vector z = r.transpose().template triangularView<Eigen::Lower>().solve(row(x));
    return {double(a.dot(row(x))), double(std::sqrt(s2) * z.norm())};
}

TEST(CalibrationCurve, AgreesWithQrOfRandomPoints) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int round = 0; round < 60; ++round) {
        const int degree = 1 + round % 10;
        const bool through_zero = round % 3 == 0;
        Points p;
        const double start = 50.0 * normal(random), width = std::exp(3.0 * normal(random));
        for (int i = 0; i < degree + 3 + round; ++i) {
            p.x.push_back((through_zero ? -0.4 * width : start) + width * uniform(random));
            p.y.push_back(3.0 * normal(random));
        }
        covaria::Setup setup = setup_of(p, "residuals", degree);
        setup.values["through_origin"] = through_zero;
        const double x = p.x[0] + 0.3 * (p.x[1] - p.x[0]);
        use_at(setup, {x});
        const auto result = first_order(setup);
        const FirstOrderOutput& b = output(result, "b_1").first_order;
        const Textbook expected = by_qr(p, degree, through_zero, x);
        EXPECT_NEAR(b.estimate, expected.value, 1e-9 * (1.0 + std::abs(expected.value))) << round;
        EXPECT_NEAR(b.standard_uncertainty, expected.u, 1e-9 * (1.0 + expected.u)) << round;
        EXPECT_NEAR(b.effective_degrees_of_freedom, double(p.x.size()) - degree - (through_zero ? 0 : 1),
                    1e-6);
    }
}

TEST(CalibrationCurve, ALineThroughTheOriginHasItsTextbookSlope) {
    covaria::Setup setup = setup_of({{1, 2, 3, 4}, {}, {2.1, 3.9, 6.2, 7.8}, {}}, "residuals");
    setup.values["through_origin"] = true;
    use_at(setup, {0.0, 10.0});
    const auto result = first_order(setup);
    const double slope = (2.1 + 7.8 + 18.6 + 31.2) / 30.0;
    const double s2 = (std::pow(2.1 - slope, 2) + std::pow(3.9 - 2 * slope, 2) +
                       std::pow(6.2 - 3 * slope, 2) + std::pow(7.8 - 4 * slope, 2)) /
                      3.0;
    EXPECT_NEAR(output(result, "y_2").first_order.estimate, slope, 1e-14);
    EXPECT_NEAR(output(result, "y_2").first_order.standard_uncertainty, std::sqrt(s2 / 30.0), 1e-14);
    EXPECT_NEAR(output(result, "b_1").first_order.estimate, 0.0, 1e-15);
    EXPECT_NEAR(output(result, "b_1").first_order.standard_uncertainty, 0.0, 1e-15);
    EXPECT_NEAR(output(result, "b_2").first_order.standard_uncertainty, 10.0 * std::sqrt(s2 / 30.0), 1e-13);
}

// The formula of the textbooks: u(x) = s/|b| sqrt(1/m + 1/n + (y - mean)^2/(b^2 S_xx)), with n - 2 degrees.
TEST(CalibrationCurve, InverseUseOfALine) {
    covaria::Setup setup = setup_of(five(), "residuals");
    use_inversely(setup, {{3.1, {}, 4.0, {}}, {3.1, 0.05, {}, {}}});
    const auto result = first_order(setup);
    const double b = 1.0, mean = 2.04, s = 0.1549193338482967, off = (3.1 - mean) / b;
    const FirstOrderOutput& read = output(result, "X_1").first_order;
    EXPECT_NEAR(read.estimate, 1.06, 1e-14);
    EXPECT_NEAR(read.standard_uncertainty, s / b * std::sqrt(1.0 / 4 + 1.0 / 5 + off * off / 10.0), 1e-13);
    EXPECT_NEAR(read.effective_degrees_of_freedom, 3.0, 1e-9);
    const double curve = s * std::sqrt(1.0 / 5 + off * off / 10.0);
    const FirstOrderOutput& stated = output(result, "X_2").first_order;
    EXPECT_NEAR(stated.standard_uncertainty, std::hypot(curve, 0.05), 1e-13);
    const double u4 = std::pow(stated.standard_uncertainty, 4);
    EXPECT_NEAR(stated.effective_degrees_of_freedom, 3.0 * u4 / std::pow(curve, 4), 1e-6);
}

// The curve predicts y at the x that it gives for y; of several places it gives the one that is asked for.
TEST(CalibrationCurve, InverseUseOfPolynomialsFindsTheBranch) {
    Points p;
    for (int i = 0; i <= 12; ++i) {
        p.x.push_back(0.5 * i);
        p.y.push_back((p.x.back() - 1.0) * (p.x.back() - 3.0) * (p.x.back() - 5.5) +
                      0.01 * ((i * 7) % 5 - 2));
    }
    covaria::Setup setup = setup_of(p, "residuals", 3);
    use_inversely(setup, {{0.0, {}, {}, {}}});
    Problems problems;
    EXPECT_EQ(model_of(setup, problems), nullptr);
    ASSERT_EQ(problems.items().size(), 1u);
    EXPECT_EQ(problems.items()[0].path, "/inverse/rows/0/y");
    EXPECT_NE(problems.items()[0].message.english().find("say in 'near' which"), std::string::npos);
    use_inversely(setup,
                  {{0.0, 0.01, {}, 0.0}, {0.0, 0.01, {}, 2.9}, {0.0, 0.01, {}, 9.0}, {20.0, 0.01, {}, {}}});
    const auto result = first_order(setup);
    EXPECT_NEAR(output(result, "X_1").first_order.estimate, 1.0, 0.01);
    EXPECT_NEAR(output(result, "X_2").first_order.estimate, 3.0, 0.01);
    EXPECT_NEAR(output(result, "X_3").first_order.estimate, 5.5, 0.01);
    const double beyond = output(result, "X_4").first_order.estimate;
    EXPECT_GT(beyond, 6.0);
    use_at(setup, {output(result, "X_2").first_order.estimate, beyond});
    const auto back = first_order(setup);
    EXPECT_NEAR(output(back, "b_1").first_order.estimate, 0.0, 1e-13);
    EXPECT_NEAR(output(back, "b_2").first_order.estimate, 20.0, 1e-12);
    use_inversely(setup, {{-1e9, {}, {}, {}}});
    setup.values["degree"] = Quantity{2.0, Unit{}};
    Problems none;
    EXPECT_EQ(model_of(setup, none), nullptr);
    EXPECT_NE(none.items()[0].message.english().find("does not reach y = -1000000000"), std::string::npos);
}

TEST(CalibrationCurve, TakesThousandsOfPoints) {
    Points p;
    for (int i = 0; i < 3000; ++i) {
        p.x.push_back(i);
        p.y.push_back(0.001 * i + ((i * 37) % 11 - 5) * 0.01);
        p.u_y.push_back(0.03);
    }
    for (const char* uncertainty : {"residuals", "stated"}) {
        covaria::Setup setup = setup_of(p, uncertainty, 2);
        use_at(setup, {1499.5});
        const auto result = first_order(setup);
        EXPECT_NEAR(output(result, "b_1").first_order.estimate, 1.4995, 2e-3);
        // quadratic through equidistant points, at the middle: 3/2 of the variance of the mean
        const double s = std::string(uncertainty) == "stated" ? 0.03 : std::sqrt(10.0) * 0.01;
        EXPECT_NEAR(output(result, "b_1").first_order.standard_uncertainty, s * 1.5 / std::sqrt(3000.0),
                    2e-2 * s / 54.0);
    }
}

TEST(CalibrationCurve, RefusesWhatDoesNotDetermineACurve) {
    const auto message = [](const Points& points, const std::string& uncertainty, int degree) {
        Problems problems;
        EXPECT_EQ(model_of(setup_of(points, uncertainty, degree), problems), nullptr);
        return problems.items().empty() ? std::string() : problems.items().front().message.english();
    };
    EXPECT_NE(message({{1, 1, 1}, {}, {1, 2, 3}, {}}, "residuals", 1).find("different places"),
              std::string::npos);
    EXPECT_NE(message({{1, 2}, {}, {1, 2}, {}}, "residuals", 1).find("more points than"), std::string::npos);
    EXPECT_NE(message({{1, 2, 3}, {}, {1, 2, 3}, {}}, "stated", 1).find("is missing in row 1"),
              std::string::npos);
    EXPECT_NE(
        message({{1, 2, 3}, {}, {1, 2, 3}, {0.1, 0, 0.1}}, "stated", 1).find("greater than zero in row 2"),
        std::string::npos);
}

}  // namespace
}  // namespace covaria::calibration_curve_test
