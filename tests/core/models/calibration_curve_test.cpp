// Calibration curves against published fits.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/math/special_quantiles.h"
#include "core/model/asset.h"
#include "core/models/registry.h"
#include "core/propagation/engine.h"

namespace covaria::calibration_curve_test {
namespace {

struct Points {
    std::vector<double> x, u_x, y, u_y;
};

covaria::Setup setup_of(const Points& points, const std::string& uncertainty, int degree = 1) {
    covaria::Setup setup;
    SetupTable table;
    table.units.assign(4, Unit{});
    for (std::size_t i = 0; i < points.x.size(); ++i)
        table.rows.push_back({points.x[i], points.u_x.empty() ? SetupCell{} : SetupCell(points.u_x[i]),
                              points.y[i], points.u_y.empty() ? SetupCell{} : SetupCell(points.u_y[i])});
    setup.values["points"] = table;
    setup.values["uncertainty"] = uncertainty;
    setup.values["degree"] = Quantity{double(degree), Unit{}};
    return setup;
}

std::unique_ptr<MeasurementModel> model_of(const covaria::Setup& setup, Problems& problems) {
    const ModelDescriptor& d = *find_model("calibration-curve");
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

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

void set_number(covaria::Setup& setup, const std::string& key, double value) {
    setup.values[key] = Quantity{value, Unit{}};
}

void use_at(covaria::Setup& setup, const std::vector<double>& places) {
    SetupTable table;
    table.units.assign(2, Unit{});
    for (const double x : places) table.rows.push_back({x, SetupCell{}});
    setup.values["predictions"] = table;
}

struct Observed {
    double y = 0.0;
    std::optional<double> u_y = {}, readings = {}, near = {};
};

void use_inversely(covaria::Setup& setup, const std::vector<Observed>& observed) {
    SetupTable table;
    table.units.assign(5, Unit{});
    const auto cell = [](const std::optional<double>& v) { return v ? SetupCell(*v) : SetupCell{}; };
    for (const Observed& o : observed)
        table.rows.push_back({o.y, cell(o.u_y), cell(o.readings), cell(o.near), SetupCell{}});
    setup.values["inverse"] = table;
}

const OutputResult& output(const UncertaintyResult& result, const std::string& symbol) {
    for (const OutputResult& o : result.outputs)
        if (o.quantity.symbol == symbol) return o;
    throw std::runtime_error("no output " + symbol);
}

UncertaintyResult first_order(const covaria::Setup& setup) {
    Problems problems;
    const auto model = model_of(setup, problems);
    for (const Problem& p : problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << " " << p.message;
    return evaluate_first_order(*model, model->inputs(), {}).value();
}

Points five() {
    return {{-2, -1, 0, 1, 2}, {}, {0.1, 0.9, 2.2, 2.9, 4.1}, {}};
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
            const double tolerance = 4.0 * std::sqrt(0.025 * 0.975 / 2e5) / 0.0136 * o.first_order.standard_uncertainty;
            EXPECT_NEAR(interval.high, o.first_order.estimate + o.first_order.expanded_uncertainty, tolerance);
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

/// At x, by Householder's QR of powers about the middle, in extended precision.
Textbook by_qr(const Points& p, int degree, bool through_zero, double x) {
    using Matrix = Eigen::Matrix<long double, -1, -1>;
    using Vector = Eigen::Matrix<long double, -1, 1>;
    const auto [low, high] = std::minmax_element(p.x.begin(), p.x.end());
    const long double middle = through_zero ? 0.0L : 0.5L * (*low + *high), width = 0.5L * (*high - *low);
    const int first = through_zero ? 1 : 0, columns = degree + 1 - first;
    const auto row = [&](double at) {
        Vector powers(columns);
        for (int k = 0; k < columns; ++k) powers[k] = std::pow((at - middle) / width, (long double)(k + first));
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
        EXPECT_NEAR(b.effective_degrees_of_freedom, double(p.x.size()) - degree - (through_zero ? 0 : 1), 1e-6);
    }
}

TEST(CalibrationCurve, ALineThroughTheOriginHasItsTextbookSlope) {
    covaria::Setup setup = setup_of({{1, 2, 3, 4}, {}, {2.1, 3.9, 6.2, 7.8}, {}}, "residuals");
    setup.values["through_origin"] = true;
    use_at(setup, {0.0, 10.0});
    const auto result = first_order(setup);
    const double slope = (2.1 + 7.8 + 18.6 + 31.2) / 30.0;
    const double s2 = (std::pow(2.1 - slope, 2) + std::pow(3.9 - 2 * slope, 2) + std::pow(6.2 - 3 * slope, 2) +
                       std::pow(7.8 - 4 * slope, 2)) / 3.0;
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

// What the curve predicts at the x that it gives for y is y; of several places the one that is asked for.
TEST(CalibrationCurve, InverseUseOfPolynomialsFindsTheBranch) {
    Points p;
    for (int i = 0; i <= 12; ++i) {
        p.x.push_back(0.5 * i);
        p.y.push_back((p.x.back() - 1.0) * (p.x.back() - 3.0) * (p.x.back() - 5.5) + 0.01 * ((i * 7) % 5 - 2));
    }
    covaria::Setup setup = setup_of(p, "residuals", 3);
    use_inversely(setup, {{0.0, {}, {}, {}}});
    Problems problems;
    EXPECT_EQ(model_of(setup, problems), nullptr);
    ASSERT_EQ(problems.items().size(), 1u);
    EXPECT_EQ(problems.items()[0].path, "/inverse/rows/0/y");
    EXPECT_NE(problems.items()[0].message.find("say in 'near' which"), std::string::npos);
    use_inversely(setup, {{0.0, 0.01, {}, 0.0}, {0.0, 0.01, {}, 2.9}, {0.0, 0.01, {}, 9.0}, {20.0, 0.01, {}, {}}});
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
    EXPECT_NE(none.items()[0].message.find("does not reach y = -1000000000"), std::string::npos);
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
            const double left = high - 0.618033988749895 * (high - low), right = low + 0.618033988749895 * (high - low);
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
        for (std::size_t i = 0; i < model->inputs().quantities.size(); ++i) x.push_back(estimate_of(model->inputs(), i));
        Eigen::MatrixXd exact, differences;
        ASSERT_TRUE(model->jacobian(x, exact));
        ASSERT_TRUE(model->MeasurementModel::jacobian(x, differences));
        EXPECT_LT((exact - differences).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff()) << round;
    }
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
        EXPECT_NEAR(output(result, "b_1").first_order.standard_uncertainty, s * 1.5 / std::sqrt(3000.0), 2e-2 * s / 54.0);
    }
}

TEST(CalibrationCurve, RefusesWhatDoesNotDetermineACurve) {
    const auto message = [](const Points& points, const std::string& uncertainty, int degree) {
        Problems problems;
        EXPECT_EQ(model_of(setup_of(points, uncertainty, degree), problems), nullptr);
        return problems.items().empty() ? std::string() : problems.items().front().message;
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
