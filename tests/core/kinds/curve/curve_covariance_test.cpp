// Calibration curves through points whose coordinates are correlated: against the closed form for exact x,
// and against a slow minimisation over the curve and all true places at once.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <random>

#include "tests/core/kinds/curve/curve_setups.h"

namespace covaria::curve_covariance_test {
namespace {

using namespace curve_setups;

struct Correlation {
    std::string first, second;
    double coefficient;
};

void correlate(covaria::Setup& setup, const std::vector<Correlation>& correlations) {
    SetupTable table;
    table.units.assign(3, Unit{});
    for (const Correlation& c : correlations) table.rows.push_back({c.first, c.second, c.coefficient});
    setup.values["correlations"] = table;
}

Eigen::Index index_of(const std::string& coordinate, std::size_t points) {
    return std::stol(coordinate.substr(2)) - 1 + (coordinate[0] == 'y' ? Eigen::Index(points) : 0);
}

/// Covariance of all x, then all y.
Eigen::MatrixXd covariance_of(const Points& p, const std::vector<Correlation>& correlations, double common_x,
                              double common_y) {
    const auto n = Eigen::Index(p.x.size());
    Eigen::MatrixXd v = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    v.topLeftCorner(n, n).setConstant(common_x * common_x);
    v.bottomRightCorner(n, n).setConstant(common_y * common_y);
    Eigen::VectorXd u(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        u[i] = p.u_x.empty() ? 0.0 : p.u_x[std::size_t(i)];
        u[n + i] = p.u_y[std::size_t(i)];
    }
    v.diagonal() += u.cwiseAbs2();
    for (const Correlation& c : correlations) {
        const Eigen::Index i = index_of(c.first, p.x.size()), j = index_of(c.second, p.x.size());
        v(i, j) += c.coefficient * u[i] * u[j];
        v(j, i) = v(i, j);
    }
    return v;
}

/// Coefficients that minimise v^T V^-1 v over them and the true places: Gauss-Newton steps on all unknowns.
std::vector<double> slowly_fitted(const Points& p, const Eigen::MatrixXd& covariance, int degree) {
    const auto n = Eigen::Index(p.x.size()), terms = Eigen::Index(degree + 1);
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(terms + n);
    unknowns[1] = 1e-3;
    for (Eigen::Index i = 0; i < n; ++i) unknowns[terms + i] = p.x[std::size_t(i)];
    for (int step = 0; step < 200; ++step) {
        Eigen::VectorXd r(2 * n);
        Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(2 * n, terms + n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double place = unknowns[terms + i];
            double value = 0.0, derivative = 0.0;
            for (Eigen::Index k = 0; k < terms; ++k) {
                value += unknowns[k] * std::pow(place, double(k));
                if (k > 0) derivative += unknowns[k] * double(k) * std::pow(place, double(k - 1));
                slope(n + i, k) = -std::pow(place, double(k));
            }
            r[i] = p.x[std::size_t(i)] - place;
            r[n + i] = p.y[std::size_t(i)] - value;
            slope(i, terms + i) = -1.0;
            slope(n + i, terms + i) = -derivative;
        }
        unknowns -= factor.matrixL().solve(slope).colPivHouseholderQr().solve(factor.matrixL().solve(r));
    }
    return {unknowns.data(), unknowns.data() + terms};
}

Points twelve(int degree, bool with_u_x, std::mt19937& random) {
    std::normal_distribution<double> normal;
    Points p;
    for (int i = 0; i < 12; ++i) {
        if (with_u_x) p.u_x.push_back(0.02 + 0.03 * (i % 3));
        p.u_y.push_back(0.05 + 0.1 * (i % 2));
        const double x = 0.5 * i - 3.0;
        p.x.push_back(x + (with_u_x ? p.u_x.back() * normal(random) : 0.0));
        double y = 1.0 + p.u_y.back() * normal(random);
        for (int k = 1; k <= degree; ++k) y += std::pow(-0.5, k) / double(k) * std::pow(x, k);
        p.y.push_back(y);
    }
    return p;
}

std::vector<Correlation> neighbours(bool with_x) {
    std::vector<Correlation> all;
    for (int i = 1; i < 12; ++i)
        all.push_back({"y_" + std::to_string(i), "y_" + std::to_string(i + 1), i % 2 == 0 ? 0.4 : -0.2});
    for (int i = 1; with_x && i <= 12; i += 2)
        all.push_back({"x_" + std::to_string(i), "y_" + std::to_string(i), 0.5});
    return all;
}

// ISO/TS 28037:2010, 9: (A^T V^-1 A)^-1 is the covariance matrix of the coefficients.
TEST(CalibrationCurve, CovarianceOfYIsThatOfGeneralisedLeastSquares) {
    std::mt19937 random(3);
    for (const int degree : {1, 2, 3}) {
        const Points p = twelve(degree, false, random);
        covaria::Setup setup = setup_of(p, "stated", degree);
        correlate(setup, neighbours(false));
        set_number(setup, "common_u_y", 0.08);
        const auto result = first_order(setup);
        const Eigen::MatrixXd v =
            covariance_of(p, neighbours(false), 0.0, 0.08).bottomRightCorner(12, 12).eval();
        Eigen::MatrixXd a(12, degree + 1);
        for (Eigen::Index i = 0; i < 12; ++i)
            for (Eigen::Index k = 0; k <= degree; ++k) a(i, k) = std::pow(p.x[std::size_t(i)], double(k));
        const Eigen::MatrixXd weighted = v.llt().solve(a);
        const Eigen::MatrixXd covariance = (a.transpose() * weighted).inverse();
        const Eigen::VectorXd fitted =
            covariance * weighted.transpose() * Eigen::Map<const Eigen::VectorXd>(p.y.data(), 12);
        for (Eigen::Index k = 0; k <= degree; ++k) {
            EXPECT_NEAR(result.outputs[std::size_t(k)].estimate, fitted[k], 1e-10) << degree;
            for (Eigen::Index l = 0; l <= degree; ++l)
                EXPECT_NEAR(result.covariance(k, l), covariance(k, l), 1e-10) << degree;
        }
    }
}

TEST(CalibrationCurve, CovarianceOfXAndYSettlesAtTheMinimum) {
    std::mt19937 random(5);
    for (const int degree : {1, 2, 3}) {
        const Points p = twelve(degree, true, random);
        covaria::Setup setup = setup_of(p, "stated", degree);
        correlate(setup, neighbours(true));
        set_number(setup, "common_u_x", 0.03);
        set_number(setup, "common_u_y", 0.06);
        Problems problems;
        const auto model = model_of(setup, problems);
        ASSERT_TRUE(model) << degree;
        const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
        const std::vector<double> slow =
            slowly_fitted(p, covariance_of(p, neighbours(true), 0.03, 0.06), degree);
        for (std::size_t k = 0; k < slow.size(); ++k)
            EXPECT_NEAR(result.outputs[k].estimate, slow[k], 1e-7 * (1.0 + std::abs(slow[k])))
                << degree << " " << k;
        std::vector<double> x;
        for (std::size_t i = 0; i < model->inputs().quantities.size(); ++i)
            x.push_back(estimate_of(model->inputs(), i));
        Eigen::MatrixXd exact, differences;
        ASSERT_TRUE(model->jacobian(x, exact));
        ASSERT_TRUE(model->MeasurementModel::jacobian(x, differences));
        EXPECT_LT((exact - differences).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff()) << degree;
    }
}

// The same points with coefficients of zero are those of York's line.
TEST(CalibrationCurve, CorrelationsOfZeroChangeNothing) {
    std::mt19937 random(7);
    const Points p = twelve(1, true, random);
    covaria::Setup plain = setup_of(p, "stated"), correlated = plain;
    correlate(correlated, {{"y_1", "y_2", 0.0}, {"x_3", "y_3", 0.0}});
    const auto a = first_order(plain), b = first_order(correlated);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(a.outputs[k].estimate, b.outputs[k].estimate, 1e-9);
        EXPECT_NEAR(a.outputs[k].standard_uncertainty, b.outputs[k].standard_uncertainty, 1e-9);
    }
}

TEST(CalibrationCurve, TrialsAreFittedWithTheCovariance) {
    std::mt19937 random(9);
    const Points p = twelve(1, true, random);
    covaria::Setup setup = setup_of(p, "stated");
    correlate(setup, neighbours(true));
    set_number(setup, "common_u_x", 0.03);
    Problems problems;
    const auto model = model_of(setup, problems);
    ASSERT_TRUE(model);
    EvaluationOptions options;
    options.trials = 20'000;
    const auto result = evaluate(*model, model->inputs(), options).value();
    EXPECT_EQ(result.failed_trials, 0u);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(result.outputs[k].standard_uncertainty,
                    result.outputs[k].first_order.standard_uncertainty,
                    0.03 * result.outputs[k].standard_uncertainty)
            << k;
}

TEST(CalibrationCurve, ACorrelationNamesTwoUncertainCoordinates) {
    const auto objection = [](const std::vector<Correlation>& correlations, const char* uncertainty) {
        Points p = five();
        p.u_y.assign(5, 0.1);
        covaria::Setup setup = setup_of(p, uncertainty);
        correlate(setup, correlations);
        Problems problems;
        model_of(setup, problems);
        return problems.items().empty() ? std::string() : problems.items().front().message.english();
    };
    EXPECT_EQ(objection({{"y_1", "y_2", 0.5}}, "stated"), "");
    EXPECT_NE(objection({{"y_1", "y_6", 0.5}}, "stated").find("'y_6' is no coordinate"), std::string::npos);
    EXPECT_NE(objection({{"y_1", "z_1", 0.5}}, "stated").find("no coordinate"), std::string::npos);
    EXPECT_NE(objection({{"y_1", "x_1", 0.5}}, "stated").find("no standard uncertainty"), std::string::npos);
    EXPECT_NE(objection({{"y_1", "y_1", 0.5}}, "stated").find("itself"), std::string::npos);
    EXPECT_NE(objection({{"y_1", "y_2", 0.5}}, "residuals").find("stated uncertainties"), std::string::npos);
}

}  // namespace
}  // namespace covaria::curve_covariance_test
