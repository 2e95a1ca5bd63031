// Calibration curves with stated uncertainties of y and x, against published fits and a slow minimisation.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/kinds/curve/curve_setups.h"

namespace covaria::curve_stated_uncertainties_test {
namespace {

using namespace curve_setups;

// Pearson's data with York's weights (D. York, Can. J. Phys. 44 (1966) 1079): the exact solution is known.
Points pearson_york() {
    Points p;
    p.x = {0, 0.9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
    p.y = {5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
    for (double w : {1000.0, 1000.0, 500.0, 800.0, 200.0, 80.0, 60.0, 20.0, 1.8, 1.0})
        p.u_x.push_back(1 / std::sqrt(w));
    for (double w : {1.0, 1.8, 4.0, 8.0, 20.0, 20.0, 70.0, 70.0, 100.0, 500.0})
        p.u_y.push_back(1 / std::sqrt(w));
    return p;
}

TEST(CalibrationCurve, YorksLineWithUncertaintiesInBoth) {
    Problems problems;
    const auto model = model_of(setup_of(pearson_york(), "stated"), problems);
    ASSERT_TRUE(model);
    const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
    EXPECT_NEAR(result.outputs[0].estimate, 5.47991022, 5e-9);
    EXPECT_NEAR(result.outputs[1].estimate, -0.48053341, 5e-9);
    // York et al. 2004, Table II: standard errors 0.29497 and 0.057985 in the least-squares estimation, to a
    // few per cent: these are evaluated at the adjusted points.
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, 0.295, 0.02);
    EXPECT_NEAR(result.outputs[1].standard_uncertainty, 0.058, 0.004);
}

// JCGM 100 4.2.3 in disguise: the line through equally uncertain points has its textbook covariance.
TEST(CalibrationCurve, StatedUncertaintiesOfYAloneGiveTheCovarianceOfLeastSquares) {
    Points p;
    p.x = {1, 2, 3, 4, 5};
    p.y = {1.1, 1.9, 3.2, 3.9, 5.1};
    p.u_y.assign(5, 0.1);
    Problems problems;
    const auto model = model_of(setup_of(p, "stated"), problems);
    ASSERT_TRUE(model);
    const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
    EXPECT_NEAR(result.outputs[1].standard_uncertainty, 0.1 / std::sqrt(10.0), 1e-12);
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, 0.1 * std::sqrt(55.0 / 50.0), 1e-12);
    EXPECT_NEAR(result.covariance(0, 1), -0.01 * 15.0 / 50.0, 1e-12);
}

// York's sum of squares at given coefficients: for each point the nearest place by golden sections.
double york_sum(const Points& p, const std::vector<double>& a) {
    const auto value = [&](double x) {
        double sum = 0.0;
        for (std::size_t k = a.size(); k-- > 0;) sum = sum * x + a[k];
        return sum;
    };
    double total = 0.0;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        const auto distance = [&](double x) {
            return std::pow((p.y[i] - value(x)) / p.u_y[i], 2) + std::pow((p.x[i] - x) / p.u_x[i], 2);
        };
        double low = p.x[i] - 8 * p.u_x[i], high = p.x[i] + 8 * p.u_x[i];
        for (int step = 0; step < 100; ++step) {
            const double left = high - 0.618033988749895 * (high - low),
                         right = low + 0.618033988749895 * (high - low);
            (distance(left) < distance(right) ? high : low) = distance(left) < distance(right) ? right : left;
        }
        total += distance(0.5 * (low + high));
    }
    return total;
}

// The iteration for uncertainties in x ends where no step of a coefficient makes the sum smaller, and its
// derivatives are those of its result.
TEST(CalibrationCurve, ErrorsInBothSettleAtTheMinimum) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 12; ++round) {
        const int degree = 1 + round % 4;
        Points p;
        for (int i = 0; i < 12; ++i) {
            p.u_x.push_back(0.02 + 0.08 * (i % 3));
            p.u_y.push_back(0.05 + 0.1 * (i % 2));
            const double x = 0.5 * i - 3.0;
            p.x.push_back(x + p.u_x.back() * normal(random));
            double y = 1.0 + p.u_y.back() * normal(random);
            for (int k = 1; k <= degree; ++k) y += std::pow(-0.5, k) / double(k) * std::pow(x, k);
            p.y.push_back(y);
        }
        Problems problems;
        const auto model = model_of(setup_of(p, "stated", degree), problems);
        ASSERT_TRUE(model) << round;
        const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
        std::vector<double> a;
        for (int k = 0; k <= degree; ++k) a.push_back(result.outputs[std::size_t(k)].first_order.estimate);
        const double least = york_sum(p, a);
        for (std::size_t k = 0; k < a.size(); ++k)
            for (const double step : {-1e-3, 1e-3}) {
                std::vector<double> moved = a;
                moved[k] += step * result.outputs[k].first_order.standard_uncertainty;
                EXPECT_GT(york_sum(p, moved), least) << round << " " << k;
            }
        std::vector<double> x;
        for (std::size_t i = 0; i < model->inputs().quantities.size(); ++i)
            x.push_back(estimate_of(model->inputs(), i));
        Eigen::MatrixXd exact, differences;
        ASSERT_TRUE(model->jacobian(x, exact));
        ASSERT_TRUE(model->MeasurementModel::jacobian(x, differences));
        EXPECT_LT((exact - differences).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff()) << round;
    }
}

}  // namespace
}  // namespace covaria::curve_stated_uncertainties_test
