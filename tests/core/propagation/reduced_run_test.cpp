// Variance reduction: estimates against what is known exactly, standard errors against the scatter over
// seeds, the same bits on any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/math/normal_quantile.h"
#include "core/math/special_quantiles.h"
#include "core/propagation/engine.h"
#include "core/propagation/nearby_ranks.h"
#include "test_models.h"
#include "tests/core/quantity/distribution_cases.h"

namespace covaria::test::reduced_run_test {
namespace {

EvaluationOptions options_with(VarianceReduction reduction, std::uint64_t trials, std::uint64_t seed = 1) {
    EvaluationOptions options;
    options.variance_reduction = reduction;
    options.trials = trials;
    options.seed = seed;
    return options;
}

UncertaintyResult evaluated(const MeasurementModel& model, const EvaluationOptions& options,
                            int threads = 1) {
    auto result = evaluate(model, model.inputs(), options, {{}, {}, threads});
    EXPECT_TRUE(result) << (result ? "" : result.error().message.english());
    return result ? *result : UncertaintyResult{};
}

const MonteCarloOutput& output_of(const UncertaintyResult& result, std::size_t j = 0) {
    return *result.outputs.at(j).monte_carlo;
}

/// y = x1 + c x2^2 with standard normal x: the linear part is x1.
FunctionModel bent_model(double c = 0.1) {
    return FunctionModel(
        normal_inputs({{0.0, 1.0}, {0.0, 1.0}}), outputs_named({"y"}),
        [c](std::span<const double> x, std::span<double> y) {
            y[0] = x[0] + c * x[1] * x[1];
            return true;
        },
        [c](std::span<const double> x, Eigen::MatrixXd& jacobian) {
            jacobian << 1.0, 2.0 * c * x[1];
            return true;
        });
}

/// Mean c, variance 1 + 2 c^2, and P(y <= q) by integration over x2.
double bent_distribution_function(double q, double c) {
    constexpr double step = 0.05;
    double sum = 0.0;
    for (int k = -180; k <= 180; ++k) {
        const double z = k * step;
        sum += step * normal_density(z) * normal_distribution_function(q - c * z * z);
    }
    return sum;
}

double bent_quantile(double p, double c = 0.1) {
    double low = -10.0, high = 100.0;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (bent_distribution_function(middle, c) < p ? low : high) = middle;
    }
    return low;
}

/// Theory for large batches: 1/(1 - r^2), r the correlation of "y is below its p-quantile" with "x1 is
/// below its own".
double bent_gain_of_quantile(double p) {
    constexpr double step = 0.05;
    const double q = bent_quantile(p), of_linear = normal_quantile(p);
    double both = 0.0;
    for (int k = -180; k <= 180; ++k) {
        const double z = k * step;
        both += step * normal_density(z) * normal_distribution_function(std::min(of_linear, q - 0.1 * z * z));
    }
    const double r = (both - p * p) / (p * (1.0 - p));
    return 1.0 / (1.0 - r * r);
}

/// `gain`, a ratio of two scatters over `batches`, the second about a regression of `terms` terms: one in
/// 10^5 would fail by chance.
void expect_gain(double gain, double expected, double batches, double terms) {
    EXPECT_GT(gain, expected * f_quantile(0.5e-5, batches - 1.0, batches - terms));
    EXPECT_LT(gain, expected * f_quantile(1.0 - 0.5e-5, batches - 1.0, batches - terms));
}

/// Number of seeds for which two reported standard errors hold the true mean, u and ends of the interval.
struct Coverage {
    int seeds = 0;
    std::array<int, 4> inside{};

    // Two standard errors hold 95.4 % of a normal deviate; 2,000 seeds know that to 0.5 %, 500 to 1 %.
    void expect_honest(std::size_t figures = 4) const {
        for (std::size_t f = 0; f < figures; ++f) {
            EXPECT_GE(inside[f], 0.93 * seeds) << f;
            EXPECT_LE(inside[f], 0.97 * seeds) << f;
        }
    }
};

Coverage coverage_of(double c, EvaluationOptions options, int seeds, bool controlled) {
    const FunctionModel model = bent_model(c);
    const std::array<double, 4> truth{c, std::sqrt(1.0 + 2.0 * c * c), bent_quantile(0.025, c),
                                      bent_quantile(0.975, c)};
    Coverage coverage{seeds};
    for (int seed = 1; seed <= seeds; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        const UncertaintyResult result = evaluated(model, options);
        const MonteCarloOutput& y = output_of(result);
        std::array<double, 4> errors{y.standard_error_of_mean, y.standard_error_of_uncertainty};
        if (y.reduced) {
            EXPECT_EQ(y.reduced->plain_because.empty(), controlled);
            const OutputFigures& e = y.reduced->standard_errors;
            errors = {e.mean, e.standard_uncertainty, e.low, e.high};
        }
        const std::array<double, 4> values{y.mean, y.standard_uncertainty, y.symmetric.low, y.symmetric.high};
        for (std::size_t f = 0; f < truth.size(); ++f)
            coverage.inside[f] += std::abs(values[f] - truth[f]) <= 2.0 * errors[f];
    }
    return coverage;
}

TEST(ControlVariate, TwoStandardErrorsHoldTheTrueValue) {
    coverage_of(0.1, options_with(VarianceReduction::control_variate, 50'000), 2000, true).expect_honest();
}

/// The ranks around that of an interval end are checked, too.
TEST(ControlVariate, TwoStandardErrorsHoldTheTrueValueOfAnAlmostLinearModel) {
    coverage_of(0.02, options_with(VarianceReduction::control_variate, 100'000), 1000, true).expect_honest();
}

/// Plain trials know standard errors of mean and u.
TEST(ControlVariate, TwoStandardErrorsOfPlainTrialsHoldTheTrueValue) {
    coverage_of(0.1, options_with(VarianceReduction::none, 20'000), 2000, false).expect_honest(2);
}

/// The linear part explains 18 % of the variance: batches without a control.
TEST(ControlVariate, TwoStandardErrorsOfPlainBatchesHoldTheTrueValue) {
    coverage_of(1.5, options_with(VarianceReduction::control_variate, 200'000), 500, false).expect_honest();
}

/// Who stops when standard errors are small might stop when they are too small.
TEST(ControlVariate, TwoStandardErrorsHoldTheTrueValueAfterTheAdaptiveProcedure) {
    EvaluationOptions options = options_with(VarianceReduction::control_variate, 10'000);
    options.method = Method::adaptive;
    options.tolerance = Quantity{0.006, Unit()};
    coverage_of(0.1, options, 500, true).expect_honest();
}

/// An output that is a curve of its linear part: read without the bias that a batch has by curvature.
TEST(ControlVariate, IntervalEndsFollowACurve) {
    const auto curve = [](double x) { return x + 0.1 * x * x; };
    const FunctionModel model(
        normal_inputs({{0.0, 1.0}}), outputs_named({"y"}),
        [&](std::span<const double> x, std::span<double> y) {
            y[0] = curve(x[0]);
            return true;
        },
        [](std::span<const double> x, Eigen::MatrixXd& jacobian) {
            jacobian(0, 0) = 1.0 + 0.2 * x[0];
            return true;
        });
    const UncertaintyResult result =
        evaluated(model, options_with(VarianceReduction::control_variate, 50'000));
    EXPECT_NEAR(output_of(result).symmetric.low, curve(normal_quantile(0.025)), 1e-6);
    EXPECT_NEAR(output_of(result).symmetric.high, curve(normal_quantile(0.975)), 1e-6);
}

/// A smooth function of its linear part alone leaves no scatter about a curve, but the curve's own cube: the
/// residuals are no noise, and an error made of them is too small.
TEST(ControlVariate, ErrorsOfFunctionsOfTheLinearPartHoldTheTrueEnds) {
    struct Case {
        double (*value)(double);
        double (*slope)(double);
    };
    const Case cases[] = {
        {[](double x) { return std::exp(x); }, [](double x) { return std::exp(x); }},
        {[](double x) { return std::atan(x + 0.5); },
         [](double x) { return 1.0 / (1.0 + (x + 0.5) * (x + 0.5)); }},
        {[](double x) { return std::log(4.0 + x); }, [](double x) { return 1.0 / (4.0 + x); }},
        {[](double x) { return x + 0.05 * x * x * x; }, [](double x) { return 1.0 + 0.15 * x * x; }}};
    constexpr double u = 0.7;
    for (const Case& f : cases) {
        const FunctionModel model(
            normal_inputs({{0.0, u}}), outputs_named({"y"}),
            [f](std::span<const double> x, std::span<double> y) {
                y[0] = f.value(x[0]);
                return true;
            },
            [f](std::span<const double> x, Eigen::MatrixXd& jacobian) {
                jacobian(0, 0) = f.slope(x[0]);
                return true;
            });
        constexpr int seeds = 200;
        std::array<int, 2> outside{};
        for (int seed = 1; seed <= seeds; ++seed) {
            const UncertaintyResult result = evaluated(
                model,
                options_with(VarianceReduction::control_variate, 50'000, static_cast<std::uint64_t>(seed)));
            const MonteCarloOutput& y = output_of(result);
            const OutputFigures& e = y.reduced->standard_errors;
            const double z = u * normal_quantile(0.975);
            outside[0] += std::abs(y.symmetric.low - f.value(-z)) > 2.0 * e.low;
            outside[1] += std::abs(y.symmetric.high - f.value(z)) > 2.0 * e.high;
            EXPECT_GT(*least_gain(result), 1e3);  // and is not made honest by being useless
        }
        // 4.6 % of 200 are 9, and more than 20 of them are there once in 1,500.
        for (const int n : outside) EXPECT_LE(n, 20);
    }
}

/// Distributions that are not known exactly: the ends are held by their errors all the same.
TEST(ControlVariate, ErrorsHoldTheEndsOfSumsThatAreHardToInvert) {
    InputSet lognormal, rectangle;
    add_quantity(lognormal, "x", Distribution::of(Lognormal{0.0, 2.0}));
    add_quantity(lognormal, "w", Distribution::normal(0.5));
    add_quantity(rectangle, "x", Distribution::of(Rectangular{-1.0, 1.0}));
    add_quantity(rectangle, "w", Distribution::normal(0.001));
    EvaluationOptions options = options_with(VarianceReduction::control_variate, 500'000, 4);
    const MonteCarloOutput of_lognormal = output_of(evaluated(sum_model(lognormal), options));
    EXPECT_NEAR(of_lognormal.symmetric.low, -0.5874, 4.0 * of_lognormal.reduced->standard_errors.low + 5e-5);
    options.coverage_probability = 0.999;
    const MonteCarloOutput of_rectangle = output_of(evaluated(sum_model(rectangle), options));
    EXPECT_NEAR(of_rectangle.symmetric.high, 0.9991005,
                4.0 * of_rectangle.reduced->standard_errors.high + 1e-7);
    EXPECT_GT(of_rectangle.reduced->standard_errors.high, 1e-8);
}

TEST(ControlVariate, GainsWhatTheLinearPartExplains) {
    const UncertaintyResult result =
        evaluated(bent_model(), options_with(VarianceReduction::control_variate, 200'000));
    const OutputFigures& gains = output_of(result).reduced->gains;
    constexpr double batches = 200'000 / 1024;
    // The mean is left with the variance of 0.1 x2^2, 0.02 of 1.02.
    expect_gain(gains.mean, 1.02 / 0.02, batches, 2.0);
    expect_gain(gains.low, bent_gain_of_quantile(0.025), batches, 3.0);
    expect_gain(gains.high, bent_gain_of_quantile(0.975), batches, 3.0);
    EXPECT_EQ(result.variance_reduction, VarianceReduction::control_variate);
    EXPECT_EQ(*least_gain(result), std::min(gains.low, gains.high));
    EXPECT_EQ(least_gain(evaluated(bent_model(), options_with(VarianceReduction::none, 200'000))),
              std::nullopt);
}

/// c = 0.01: the linear part explains all but 2e-4 of the variance; an end alone, without its neighbours,
/// gains 50.
TEST(ControlVariate, AlmostLinearModelsGainMoreThanAHundredAtTheEnds) {
    const UncertaintyResult result =
        evaluated(bent_model(0.01), options_with(VarianceReduction::control_variate, 200'000));
    const OutputFigures& gains = output_of(result).reduced->gains;
    EXPECT_GT(std::min(gains.low, gains.high), 100.0);
    EXPECT_NEAR(output_of(result).symmetric.high, bent_quantile(0.975, 0.01),
                4.0 * output_of(result).reduced->standard_errors.high);
}

TEST(NearbyRanks, ReadAParabolaExactly) {
    for (const auto& [rank, count] : {std::pair(1, 100), {2, 100}, {25, 1024}, {50, 2000}, {60, 100}}) {
        const detail::RankWeights around = detail::weights_around(std::uint64_t(rank), std::uint64_t(count));
        const auto parabola = [n = count](std::uint64_t k) {
            const double z = normal_quantile((double(k) - 1.0 / 3.0) / (double(n) + 1.0 / 3.0));
            return 1.0 - 2.0 * z + 3.0 * z * z;
        };
        double sum = 0.0, squares = 0.0;
        for (std::size_t i = 0; i < around.weights.size(); ++i) {
            sum += around.weights[i] * parabola(around.first + i);
            squares += around.weights[i] * around.weights[i];
        }
        EXPECT_NEAR(sum, parabola(std::uint64_t(rank)), 1e-10);
        EXPECT_LE(around.first + around.weights.size() - 1, std::uint64_t(count));
        EXPECT_LE(squares, 1.0 + 1e-12);  // never more noise than that of the rank alone
        if (rank == 25) {
            EXPECT_LT(squares, 0.1);
        }
    }
}

TEST(ControlVariate, IsExactForLinearModels) {
    InputSet inputs;
    add_quantity(inputs, "x1", Distribution::of(Rectangular{-1.0, 1.0}));
    add_quantity(inputs, "x2", Distribution::of(Rectangular{2.0, 4.0}));
    const UncertaintyResult result =
        evaluated(sum_model(inputs), options_with(VarianceReduction::control_variate, 20'000));
    const MonteCarloOutput& y = output_of(result);
    EXPECT_NEAR(y.mean, 3.0, 1e-12);
    EXPECT_NEAR(y.standard_uncertainty, std::sqrt(2.0 / 3.0), 1e-12);
    const double end = 2.0 - std::sqrt(8.0 * 0.025);  // triangle of width 4
    EXPECT_NEAR(y.symmetric.low, 3.0 - end, 1e-7);
    EXPECT_NEAR(y.symmetric.high, 3.0 + end, 1e-7);
    // The mean is exact; the quantile of the linear part is computed, and its error is stated.
    EXPECT_LT(y.reduced->standard_errors.mean, 1e-12);
    EXPECT_LT(y.reduced->standard_errors.high, 1e-5);
    EXPECT_LE(std::abs(y.symmetric.high - 3.0 - end), y.reduced->standard_errors.high);
    EXPECT_LE(std::abs(y.symmetric.low - 3.0 + end), y.reduced->standard_errors.low);
    EXPECT_GT(*least_gain(result), 1e6);
    EXPECT_NEAR(result.covariance(0, 0), 2.0 / 3.0, 1e-12);
}

/// Everything that makes components dependent, in a linear model: what is known exactly against plain trials.
TEST(ControlVariate, KnowsTheDistributionOfDependentComponents) {
    const auto correlated = [] {
        InputSet inputs = normal_inputs({{0.0, 1.0}, {0.0, 2.0}});
        inputs.correlations = {{0, 1, 0.7}};
        return inputs;
    };
    const auto one_estimate = [] {
        InputSet inputs = normal_inputs({{0.0, 1.0}, {0.0, 2.0}});
        for (std::size_t c : {0, 1}) {
            inputs.components[c].degrees_of_freedom = 5.0;
            inputs.rest_on_estimate("s", c);
        }
        inputs.correlations = {{0, 1, -0.3}};
        return inputs;
    };
    const auto direction = [] {
        InputSet inputs;
        for (const char* name : {"x", "y", "z"})
            add_quantity(inputs, name, Distribution::of(Rectangular{-1.0, 1.0}));
        inputs.vectors.push_back({{0, 1, 2}});
        return inputs;
    };
    for (InputSet inputs : {correlated(), one_estimate(), direction()}) {
        add_quantity(inputs, "t", Distribution::of(StudentT{1.0, 0.5, 6.0}));
        add_quantity(inputs, "gamma", Distribution::of(Exponential{0.5}));
        const FunctionModel model = sum_model(inputs);
        constexpr std::uint64_t trials = 400'000;
        const UncertaintyResult plain = evaluated(model, options_with(VarianceReduction::none, trials));
        const UncertaintyResult known =
            evaluated(model, options_with(VarianceReduction::control_variate, 20'000, 2));
        ASSERT_TRUE(output_of(known).reduced->plain_because.empty());
        EXPECT_LT(output_of(known).reduced->standard_errors.high, 1e-6);
        const MonteCarloOutput &a = output_of(plain), &b = output_of(known);
        const double error = a.standard_uncertainty / std::sqrt(double(trials));
        EXPECT_NEAR(a.mean, b.mean, 4.0 * error);
        EXPECT_NEAR(a.standard_uncertainty, b.standard_uncertainty, 4.0 * a.standard_error_of_uncertainty);
        // sqrt(q(1 - q))/density: 2.67 for a normal distribution, up to 4 with the upper tail of these.
        EXPECT_NEAR(a.symmetric.low, b.symmetric.low, 4.0 * 4.0 * error);
        EXPECT_NEAR(a.symmetric.high, b.symmetric.high, 4.0 * 4.0 * error);
    }
}

TEST(ControlVariate, CovarianceIsNearerToTheTruth) {
    InputSet inputs = normal_inputs({{3.0, 0.02}, {4.0, 0.03}});
    inputs.correlations = {{0, 1, 0.5}};
    const FunctionModel model = polar_model(inputs);
    const UncertaintyResult plain = evaluated(model, options_with(VarianceReduction::none, 1'000'000));
    const UncertaintyResult reduced =
        evaluated(model, options_with(VarianceReduction::control_variate, 20'000, 3));
    for (Eigen::Index i = 0; i < 2; ++i)
        for (Eigen::Index j = 0; j < 2; ++j) {
            const double scale = std::sqrt(plain.covariance(i, i) * plain.covariance(j, j));
            EXPECT_NEAR(reduced.covariance(i, j), plain.covariance(i, j), 4.0 * 1.42e-3 * scale);
        }
    for (std::size_t j : {0, 1}) {
        EXPECT_EQ(reduced.outputs[j].standard_uncertainty, output_of(reduced, j).standard_uncertainty);
        EXPECT_NEAR(reduced.outputs[j].standard_uncertainty,
                    std::sqrt(reduced.covariance(Eigen::Index(j), Eigen::Index(j))), 1e-15);
    }
}

/// y = x1^2 + x2^2 at zero (JCGM 101 9.4): nothing to go by. The numbers are those of plain trials.
TEST(ControlVariate, FallsBackWhereThereIsNoLinearPart) {
    const FunctionModel model(normal_inputs({{0.0, 0.005}, {0.0, 0.005}}), outputs_named({"y"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = x[0] * x[0] + x[1] * x[1];
                                  return true;
                              });
    const UncertaintyResult plain = evaluated(model, options_with(VarianceReduction::none, 100'000));
    const UncertaintyResult fallen =
        evaluated(model, options_with(VarianceReduction::control_variate, 100'000));
    EXPECT_FALSE(output_of(fallen).reduced->plain_because.empty());
    EXPECT_EQ(output_of(fallen).symmetric.high, output_of(plain).symmetric.high);
    EXPECT_NEAR(output_of(fallen).standard_uncertainty, output_of(plain).standard_uncertainty, 1e-17);
    EXPECT_EQ(*least_gain(fallen), 1.0);
    ASSERT_EQ(fallen.warnings.size(), 1u);
    EXPECT_NE(fallen.warnings[0].english().find("Without control variate: y"), std::string::npos)
        << fallen.warnings[0];
}

TEST(ControlVariate, IsNotUsedWhereTrialsAreLost) {
    const FunctionModel model(normal_inputs({{1.0, 0.3}}), outputs_named({"y"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = x[0];
                                  return x[0] < 1.5;
                              });
    const UncertaintyResult plain = evaluated(model, options_with(VarianceReduction::none, 50'000));
    const UncertaintyResult lost = evaluated(model, options_with(VarianceReduction::control_variate, 50'000));
    EXPECT_EQ(output_of(lost).symmetric.high, output_of(plain).symmetric.high);
    EXPECT_NEAR(output_of(lost).mean, output_of(plain).mean, 1e-14);
    EXPECT_NE(lost.warnings.back().english().find("Control variates are not used"), std::string::npos);
}

TEST(ControlVariate, TooFewTrialsAreSaidToBe) {
    const UncertaintyResult few =
        evaluated(bent_model(), options_with(VarianceReduction::control_variate, 5'000));
    EXPECT_TRUE(std::isnan(output_of(few).reduced->standard_errors.mean));
    EXPECT_NE(few.warnings.back().english().find("fewer than 10 batches"), std::string::npos);
}

TEST(ControlVariate, AdaptiveRunsStopEarlier) {
    EvaluationOptions options = options_with(VarianceReduction::none, 0);
    options.method = Method::adaptive;
    options.significant_digits = 3;
    const UncertaintyResult plain = evaluated(bent_model(), options);
    options.variance_reduction = VarianceReduction::control_variate;
    const UncertaintyResult reduced = evaluated(bent_model(), options);
    EXPECT_TRUE(plain.stabilised && reduced.stabilised);
    // An end of the interval settles last, with the square of its standard error.
    const double gain = std::min(bent_gain_of_quantile(0.025), bent_gain_of_quantile(0.975));
    EXPECT_GT(gain, 2.0);
    EXPECT_LT(2 * reduced.trials, plain.trials);
    EXPECT_NEAR(output_of(reduced).symmetric.high, bent_quantile(0.975), 0.01);
}

/// A model that is not linear, and yet has the tails of x1.
FunctionModel bounded_curve(const Distribution& x1) {
    InputSet inputs;
    add_quantity(inputs, "x1", x1);
    add_quantity(inputs, "x2", Distribution::normal(1.0));
    return FunctionModel(std::move(inputs), outputs_named({"y"}),
                         [](std::span<const double> x, std::span<double> y) {
                             y[0] = x[0] + x[1] + 0.1 * std::sin(x[0] + x[1]);
                             return true;
                         });
}

// A scatter between batches says nothing of a mean without a variance, or of a variance without a fourth
// moment.
TEST(VarianceReduction, StatesNothingWhereAVarianceIsInfinite) {
    std::vector<Distribution> cases = distribution_cases();
    for (const double nu : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 4.5, 30.0})
        for (const double scale : {0.1, 1.0, 30.0})
            cases.push_back(Distribution::of(StudentT{2.0, scale, nu}));
    for (const auto reduction : {VarianceReduction::control_variate, VarianceReduction::sobol})
        for (const Distribution& x1 : cases) {
            SCOPED_TRACE(described(x1) + " " + std::string(key_of(reduction)));
            const UncertaintyResult result = evaluated(bounded_curve(x1), options_with(reduction, 40'000));
            const MonteCarloOutput& y = output_of(result);
            const OutputFigures &errors = y.reduced->standard_errors, &gains = y.reduced->gains;
            const bool finite = std::isfinite(result.outputs[0].standard_uncertainty);
            const bool settled = x1.degrees_of_freedom() > 4.0;
            EXPECT_EQ(finite, std::isfinite(x1.standard_deviation()));
            EXPECT_EQ(std::isfinite(errors.mean), finite);
            EXPECT_EQ(std::isfinite(gains.mean), finite);
            EXPECT_EQ(std::isfinite(y.standard_error_of_mean), finite);
            EXPECT_EQ(std::isfinite(errors.standard_uncertainty), settled);
            EXPECT_EQ(std::isfinite(gains.standard_uncertainty), settled);
            EXPECT_EQ(std::isfinite(y.standard_error_of_uncertainty), settled);
            EXPECT_EQ(least_gain(result).has_value(), finite);
            for (const double gain : {gains.low, gains.high}) EXPECT_EQ(gain > 0.0, finite) << gain;
            // Quantiles have a variance whatever the tails.
            for (const double error : {errors.low, errors.high})
                EXPECT_TRUE(std::isfinite(error) && error > 0.0) << error;
        }
}

bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(VarianceReduction, GivesTheSameBitsOnAnyNumberOfThreads) {
    InputSet inputs = normal_inputs({{3.0, 0.02}, {4.0, 0.03}});
    add_quantity(inputs, "offset", Distribution::of(Rectangular{-0.01, 0.01}));
    inputs.correlations = {{0, 1, 0.4}};
    const FunctionModel model(inputs, outputs_named({"r", "q"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = std::hypot(x[0], x[1]) + x[2];
                                  y[1] = x[0] * x[1];
                                  return true;
                              });
    for (const auto reduction : {VarianceReduction::control_variate, VarianceReduction::sobol})
        for (const Method method : {Method::monte_carlo, Method::adaptive}) {
            EvaluationOptions options = options_with(reduction, 123'456);
            options.method = method;
            const UncertaintyResult one = evaluated(model, options, 1);
            for (const int threads : {2, 3, 5}) {
                const UncertaintyResult many = evaluated(model, options, threads);
                EXPECT_EQ(one.trials, many.trials);
                for (std::size_t j : {0, 1}) {
                    const MonteCarloOutput &a = output_of(one, j), &b = output_of(many, j);
                    EXPECT_TRUE(same_bits(a.mean, b.mean));
                    EXPECT_TRUE(same_bits(a.standard_uncertainty, b.standard_uncertainty));
                    EXPECT_TRUE(same_bits(a.symmetric.low, b.symmetric.low));
                    EXPECT_TRUE(same_bits(a.shortest.high, b.shortest.high));
                    EXPECT_TRUE(same_bits(a.reduced->standard_errors.high, b.reduced->standard_errors.high));
                    EXPECT_TRUE(same_bits(a.reduced->gains.low, b.reduced->gains.low));
                }
                EXPECT_EQ(std::memcmp(one.covariance.whole().data(), many.covariance.whole().data(),
                                      4 * sizeof(double)),
                          0);
                EXPECT_EQ(one.regions[0].ellipsoid_monte_carlo, many.regions[0].ellipsoid_monte_carlo);
            }
        }
}

TEST(SobolPoints, GainOnASmoothModelOfFewInputs) {
    const UncertaintyResult result = evaluated(bent_model(), options_with(VarianceReduction::sobol, 200'000));
    const MonteCarloOutput& y = output_of(result);
    const OutputFigures &errors = y.reduced->standard_errors, &gains = y.reduced->gains;
    EXPECT_NEAR(y.mean, 0.1, 5.0 * errors.mean);
    EXPECT_NEAR(y.standard_uncertainty, std::sqrt(1.02), 5.0 * errors.standard_uncertainty);
    EXPECT_NEAR(y.symmetric.low, bent_quantile(0.025), 5.0 * errors.low + 1e-3);
    EXPECT_NEAR(y.symmetric.high, bent_quantile(0.975), 5.0 * errors.high + 1e-3);
    // Each input has one point in each of n equal cells of probability: a monotone function of one of them
    // comes within its span over n of its mean. The spans to the outermost cells are about 8 and 0.1 * 16.
    constexpr double n = 4096.0;
    EXPECT_GT(gains.mean, 1.02 * n / std::pow(8.0 + 2.0 * 1.6, 2));
    EXPECT_GT(gains.low, 1.0);
    EXPECT_GT(gains.high, 1.0);
}

}  // namespace
}  // namespace covaria::test::reduced_run_test
