// The engine over generated figures: what holds for every model, seed and number of trials.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "core/base/unit_store.h"
#include "core/math/normal_quantile.h"
#include "core/propagation/engine.h"
#include "core/propagation/requirements.h"
#include "test_models.h"

namespace covaria::test::random_figures_test {
namespace {

UncertaintyResult evaluated(const MeasurementModel& model, const EvaluationOptions& options) {
    auto result = evaluate(model, model.inputs(), options, {{}, {}, 1});
    EXPECT_TRUE(result) << (result ? "" : result.error().message.english());
    return result ? *result : UncertaintyResult{};
}

/// Figures of any size, the same on every machine.
class Figures {
public:
    explicit Figures(std::uint64_t seed) : bits_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    double of_size(double least, double most) {
        return std::exp(between(std::log(least), std::log(most))) * (bits_() % 2 == 0 ? 1.0 : -1.0);
    }
    std::size_t below(std::size_t n) { return bits_() % n; }
    std::uint64_t seed() { return bits_(); }

private:
    std::mt19937_64 bits_;
};

FunctionModel linear_model(const Eigen::MatrixXd& c, InputSet inputs) {
    std::vector<std::string> names;
    for (Eigen::Index j = 0; j < c.rows(); ++j) names.push_back("y" + std::to_string(j + 1));
    return FunctionModel(
        std::move(inputs), outputs_named(names),
        [c](std::span<const double> x, std::span<double> y) {
            Eigen::Map<Eigen::VectorXd>(y.data(), c.rows()) =
                c * Eigen::Map<const Eigen::VectorXd>(x.data(), c.cols());
            return true;
        },
        [c](std::span<const double>, Eigen::MatrixXd& jacobian) {
            jacobian = c;
            return true;
        });
}

/// Outputs that are sums of fewer quantities than there are outputs: rounding decides whether their
/// covariance has factors, so many seeds and numbers of trials are asked.
TEST(DependentOutputs, HaveResultsAndNoEllipsoid) {
    Figures figures(42);
    constexpr Method methods[] = {Method::monte_carlo, Method::adaptive};
    constexpr VarianceReduction reductions[] = {VarianceReduction::none, VarianceReduction::control_variate,
                                                VarianceReduction::sobol};
    for (int n = 0; n < 100; ++n) {
        SCOPED_TRACE(n);
        const auto outputs = static_cast<Eigen::Index>(2 + figures.below(4));
        const auto quantities =
            static_cast<Eigen::Index>(1 + figures.below(static_cast<std::size_t>(outputs) - 1));
        Eigen::MatrixXd c(outputs, quantities);
        for (double& coefficient : c.reshaped()) coefficient = figures.of_size(1e-3, 1e3);
        std::vector<std::pair<double, double>> inputs;
        for (Eigen::Index i = 0; i < quantities; ++i)
            inputs.emplace_back(figures.of_size(1e-3, 1e3), std::abs(figures.of_size(1e-6, 1.0)));
        EvaluationOptions options;
        options.method = methods[figures.below(2)];
        options.variance_reduction = reductions[figures.below(3)];
        options.trials = 2 + figures.below(5'000);
        options.maximum_trials = 20'000;
        options.seed = figures.seed();
        const UncertaintyResult result = evaluated(linear_model(c, normal_inputs(inputs)), options);
        ASSERT_EQ(result.outputs.size(), static_cast<std::size_t>(outputs));
        ASSERT_FALSE(result.regions.empty());
        const CoverageRegion& region = result.regions.front();
        EXPECT_TRUE(region.singular);
        EXPECT_FALSE(region.ellipsoid_monte_carlo);
        EXPECT_TRUE(region.rectangle_monte_carlo);
        if (result.trials <= 100) continue;
        for (const OutputResult& y : result.outputs)
            EXPECT_NEAR(y.standard_uncertainty / y.first_order.standard_uncertainty, 1.0,
                        6.0 / std::sqrt(2.0 * static_cast<double>(result.trials)));
    }
}

/// The distribution of a value that is one of some, far apart or near, with a normal deviation about it.
struct Peaks {
    std::vector<double> values, probabilities;
    double below(double limit) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < values.size(); ++k)
            sum += probabilities[k] * normal_distribution_function(limit - values[k]);
        return sum;
    }
};

Peaks random_peaks(Figures& figures) {
    Peaks peaks;
    double whole = 0.0;
    for (std::size_t k = 0, n = 2 + figures.below(3); k < n; ++k) {
        peaks.values.push_back(k == 0 ? 0.0 : peaks.values.back() + std::abs(figures.of_size(1.0, 1e6)));
        peaks.probabilities.push_back(figures.between(0.1, 1.0));
        whole += peaks.probabilities.back();
    }
    for (double& p : peaks.probabilities) p /= whole;
    return peaks;
}

TEST(Conformance, OfPeaksFarApartIsThatOfTheTrials) {
    Figures figures(7);
    constexpr std::uint64_t trials = 100'000;
    double squares = 0.0;
    constexpr int cases = 30, limits = 40;
    for (int n = 0; n < cases; ++n) {
        SCOPED_TRACE(n);
        const Peaks peaks = random_peaks(figures);
        InputSet inputs;
        add_quantity(inputs, "x", Distribution::of(Discrete{peaks.values, peaks.probabilities}));
        add_quantity(inputs, "w", Distribution::normal(1.0));
        EvaluationOptions options;
        options.trials = trials;
        options.seed = figures.seed();
        const UncertaintyResult result = evaluated(sum_model(inputs), options);
        double worst = 0.0;
        for (int l = 0; l < limits; ++l) {
            OutputRequirement requirement;
            requirement.guard_factor = 0.0;
            const double limit =
                peaks.values[figures.below(peaks.values.size())] + figures.between(-4.0, 4.0);
            requirement.upper_limit = limit;
            const double p = peaks.below(limit);
            const double scatter = std::sqrt(p * (1.0 - p) / static_cast<double>(trials)) + 1e-4;
            const double off = std::abs(judge(result, requirement).conformance - p) / scatter;
            worst = std::max(worst, off);
            squares += off * off;
        }
        EXPECT_LT(worst, 5.0);
    }
    EXPECT_LT(squares / (cases * limits), 1.3);
}

/// a + b.x + x.C x/2 + sum d_i x_i^3/6 + e x_1 x_2 x_3 with independent normal x about zero.
struct Cubic {
    double a = 0.0, e = 0.0;
    Eigen::Vector3d b, d;
    Eigen::Matrix3d c;

    double value(const Eigen::Vector3d& x) const {
        return a + b.dot(x) + 0.5 * x.dot(c * x) + d.dot(x.array().cube().matrix()) / 6.0 + e * x.prod();
    }
    Eigen::Vector3d gradient(const Eigen::Vector3d& x) const {
        return b + c * x + 0.5 * d.cwiseProduct(x.cwiseProduct(x)) +
               e * Eigen::Vector3d(x[1] * x[2], x[0] * x[2], x[0] * x[1]);
    }
};

TEST(SecondOrder, IsThatOfTheNoteToJcgm100ForCubics) {
    Figures figures(3);
    for (int n = 0; n < 100; ++n) {
        SCOPED_TRACE(n);
        Cubic f;
        f.a = figures.between(-1.0, 1.0);
        f.e = figures.between(-1.0, 1.0);
        for (double& v : f.b) v = figures.between(-1.0, 1.0);
        for (double& v : f.d) v = figures.between(-1.0, 1.0);
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index j = 0; j <= i; ++j) f.c(i, j) = f.c(j, i) = figures.between(-1.0, 1.0);
        const Eigen::Vector3d u(figures.between(0.1, 1.0), figures.between(0.1, 1.0),
                                figures.between(0.1, 1.0));
        const FunctionModel model(
            normal_inputs({{0.0, u[0]}, {0.0, u[1]}, {0.0, u[2]}}), outputs_named({"y"}),
            [f](std::span<const double> x, std::span<double> y) {
                y[0] = f.value({x[0], x[1], x[2]});
                return true;
            },
            [f](std::span<const double> x, Eigen::MatrixXd& jacobian) {
                jacobian = f.gradient({x[0], x[1], x[2]}).transpose();
                return true;
            });
        EvaluationOptions options;
        options.method = Method::first_order;
        options.second_order = true;
        const UncertaintyResult result = evaluated(model, options);
        double variance = 0.0, shift = 0.0;
        for (Eigen::Index i = 0; i < 3; ++i) {
            variance += f.b[i] * f.b[i] * u[i] * u[i];
            shift += 0.5 * f.c(i, i) * u[i] * u[i];
            for (Eigen::Index j = 0; j < 3; ++j)
                variance += (0.5 * f.c(i, j) * f.c(i, j) + (i == j ? f.b[i] * f.d[i] : 0.0)) * u[i] * u[i] *
                            u[j] * u[j];
        }
        const FirstOrderOutput& y = result.outputs[0].first_order;
        ASSERT_TRUE(y.second_order_estimate_shift);
        EXPECT_NEAR(*y.second_order_estimate_shift, shift, 1e-10);
        // A variance below zero is none, and is said to be.
        EXPECT_EQ(y.second_order_standard_uncertainty.has_value(), variance >= 0.0);
        EXPECT_EQ(result.warnings.size(), variance >= 0.0 ? 0u : 1u);
        if (y.second_order_standard_uncertainty) {
            EXPECT_NEAR(std::pow(*y.second_order_standard_uncertainty, 2), variance, 1e-9);
        }
    }
}

/// A model y = value(z), z = (x_1 + 2 x_2)/scale, of two normal quantities; `slope` is its derivative by z.
FunctionModel model_of(double scale, double (*value)(double), double (*slope)(double)) {
    return FunctionModel(
        normal_inputs({{0.0, scale}, {0.0, scale}}), outputs_named({"y"}),
        [=](std::span<const double> x, std::span<double> y) {
            y[0] = value((x[0] + 2.0 * x[1]) / scale);
            return std::isfinite(y[0]);
        },
        [=](std::span<const double> x, Eigen::MatrixXd& jacobian) {
            const double c = slope((x[0] + 2.0 * x[1]) / scale) / scale;
            jacobian << c, 2.0 * c;
            return std::isfinite(c);
        });
}

struct Shape {
    double (*value)(double);
    double (*slope)(double);
    bool kink;
};

TEST(Kinks, AreSaidAndLeaveTheFirstOrderEmpty) {
    const Shape shapes[] = {
        {[](double z) { return std::abs(z); }, [](double z) { return z < 0.0 ? -1.0 : 1.0; }, true},
        {[](double z) { return std::max(z, 3.0 * z); }, [](double z) { return z > 0.0 ? 3.0 : 1.0; }, true},
        {[](double z) { return z * z; }, [](double z) { return 2.0 * z; }, false},
        {[](double z) { return z * z * z; }, [](double z) { return 3.0 * z * z; }, false},
        {[](double z) { return z * std::abs(z); }, [](double z) { return 2.0 * std::abs(z); }, false},
        {[](double z) { return std::exp(0.3 * z); }, [](double z) { return 0.3 * std::exp(0.3 * z); }, false},
        {[](double z) { return std::atan(50.0 * z); }, [](double z) { return 50.0 / (1.0 + 2500.0 * z * z); },
         false},
        {[](double z) { return z; }, [](double) { return 1.0; }, false}};
    for (const Shape& shape : shapes)
        for (const double scale : {1e-150, 1e-9, 1.0, 1e9, 1e150}) {
            SCOPED_TRACE(scale);
            EvaluationOptions options;
            options.trials = 10'000;
            const FunctionModel model = model_of(scale, shape.value, shape.slope);
            const UncertaintyResult result = evaluated(model, options);
            ASSERT_EQ(result.outputs.size(), 1u);
            EXPECT_EQ(std::isnan(result.outputs[0].first_order.standard_uncertainty), shape.kink);
            EXPECT_EQ(result.warnings.size(), shape.kink ? 1u : 0u);
            EXPECT_GT(result.outputs[0].standard_uncertainty, 0.0);
            options.method = Method::first_order;
            EXPECT_EQ(evaluated(model, options).warnings.size(), shape.kink ? 1u : 0u);
        }
}

// Coefficients that the last digits of an estimate change have no kink; what they have is said instead.
TEST(Kinks, RoundingIsNone) {
    for (const double size : {1.0, 1e60}) {
        const FunctionModel model(
            normal_inputs({{5.0, 1.0}, {7.0, 1.0}}), outputs_named({"y"}),
            [=](std::span<const double> x, std::span<double> y) {
                y[0] = size * (x[0] + x[1]);
                return true;
            },
            [=](std::span<const double> x, Eigen::MatrixXd& jacobian) {
                jacobian << size * std::sin(1e17 * x[0]), size * std::sin(1e17 * x[1]);
                return true;
            });
        for (const Method method : {Method::first_order, Method::monte_carlo}) {
            EvaluationOptions options;
            options.method = method;
            options.trials = 10'000;
            const UncertaintyResult result = evaluated(model, options);
            ASSERT_EQ(result.warnings.size(), 1u);
            EXPECT_NE(result.warnings[0].english().find("the last digits"), std::string::npos)
                << result.warnings[0];
        }
    }
}

/// Monte Carlo answers without sensitivity coefficients, and says so; the law of propagation is refused.
TEST(Kinks, MonteCarloAnswersWhereThereIsNoDerivative) {
    const FunctionModel model = model_of(
        1.0, [](double z) { return std::cbrt(z); },
        [](double z) { return 1.0 / (3.0 * std::cbrt(z) * std::cbrt(z)); });
    for (const VarianceReduction reduction :
         {VarianceReduction::none, VarianceReduction::control_variate, VarianceReduction::sobol}) {
        EvaluationOptions options;
        options.trials = 100'000;
        options.variance_reduction = reduction;
        options.one_at_a_time_trials = options.contributor_trials = options.sobol_trials = 1000;
        const UncertaintyResult result = evaluated(model, options);
        ASSERT_EQ(result.outputs.size(), 1u);
        // The mean of |z|^(2/3) over a normal z of variance 5.
        const double exact =
            std::sqrt(std::pow(10.0, 1.0 / 3.0) * std::tgamma(5.0 / 6.0) / std::sqrt(3.141592653589793));
        EXPECT_NEAR(result.outputs[0].standard_uncertainty, exact, 0.01);
        EXPECT_FALSE(result.warnings.empty());
        EXPECT_FALSE(result.outputs[0].first_order.validation);
    }
    EvaluationOptions options;
    options.method = Method::first_order;
    EXPECT_FALSE(evaluate(model, model.inputs(), options, {{}, {}, 1}));
}

/// The variance of x^2 of Student's t with three degrees of freedom does not exist, that of a lognormal
/// quantity of great log-scale is not known from any number of trials; a wide normal one's is.
TEST(HeavyTails, NoErrorIsStatedOfAVarianceThatIsNotKnown) {
    struct Case {
        Distribution x;
        double power;
        bool heavy;
    };
    const Case cases[] = {{Distribution::of(StudentT{0.0, 1.0, 6.0}), 4.0, true},
                          {Distribution::of(StudentT{0.0, 1.0, 6.0}), 1.0, false},
                          {Distribution::of(Lognormal{0.0, 3.0}), 1.0, true},
                          {Distribution::of(Lognormal{0.0, 0.5}), 1.0, false},
                          {Distribution::normal(1.0), 3.0, false},
                          // Few values far out, of a variance that their number knows.
                          {Distribution::of(Discrete{{0.0, 1.0, 1000.0}, {0.4, 0.5995, 0.0005}}), 1.0, false},
                          {Distribution::of(Rectangular{-1.0, 1.0}), 8.0, false}};
    for (const Case& c : cases)
        for (const VarianceReduction reduction :
             {VarianceReduction::none, VarianceReduction::control_variate}) {
            SCOPED_TRACE(std::string(c.x.title()) + " to the power of " + std::to_string(c.power));
            InputSet inputs;
            add_quantity(inputs, "x", c.x);
            const double centre = c.x.mean() + c.x.standard_deviation();
            const FunctionModel model(
                std::move(inputs), outputs_named({"y"}), [&](std::span<const double> x, std::span<double> y) {
                    y[0] = c.power == 1.0 ? x[0] : std::pow(std::abs(x[0] / centre), c.power);
                    return true;
                });
            EvaluationOptions options;
            options.trials = 200'000;
            options.variance_reduction = reduction;
            const UncertaintyResult result = evaluated(model, options);
            EXPECT_EQ(std::isnan(result.outputs[0].monte_carlo->standard_error_of_uncertainty), c.heavy);
            const bool said =
                std::any_of(result.warnings.begin(), result.warnings.end(), [](const Message& m) {
                    return m.english().find("tails of its distribution are too heavy") != std::string::npos;
                });
            EXPECT_EQ(said, c.heavy);
        }
}

TEST(FewTrials, AreSaidToBe) {
    Figures figures(11);
    for (int n = 0; n < 40; ++n) {
        EvaluationOptions options;
        options.trials = 2 + figures.below(30'000);
        options.coverage_probability = 1.0 - std::abs(figures.of_size(1e-6, 0.5));
        const UncertaintyResult result = evaluated(sum_model(normal_inputs({{0.0, 1.0}})), options);
        const double least = std::max(1e4, 100.0 / (1.0 - options.coverage_probability));
        EXPECT_EQ(result.warnings.empty(), static_cast<double>(options.trials) >= least)
            << options.trials << " " << options.coverage_probability;
    }
}

/// Units of a run in memory: computed once, then merged, with one word of one of them changed.
class KeptUnits : public UnitStore {
public:
    bool only_computes() const override { return computing; }
    std::optional<UnitRange> next_range() override {
        if (given_) return {};
        given_ = true;
        return UnitRange{0, units};
    }
    bool keep(std::uint64_t unit, std::string bytes) override {
        EXPECT_EQ(unit, kept.size());
        kept.push_back(std::move(bytes));
        return true;
    }
    std::optional<std::string> find(std::uint64_t unit) override {
        return unit < kept.size() ? std::optional(kept[unit]) : std::nullopt;
    }
    bool computes_missing(std::uint64_t) const override { return false; }
    void cannot_read(std::uint64_t) override { ++refused; }
    void lacks(std::uint64_t) override { ++refused; }  // a run that is not stable asks for more

    bool computing = true;
    std::uint64_t units = 0;
    std::vector<std::string> kept;
    int refused = 0;

private:
    bool given_ = false;
};

/// A stored unit may say anything, with a fitting check sum: a number of trials that no run has
/// must not be waited for.
TEST(StoredUnits, AnyWordMayBeChanged) {
    Figures figures(23);
    const FunctionModel model = sum_model(normal_inputs({{1.0, 0.1}, {2.0, 0.3}}));
    for (const Method method : {Method::monte_carlo, Method::adaptive})
        for (const VarianceReduction reduction :
             {VarianceReduction::none, VarianceReduction::control_variate}) {
            EvaluationOptions options;
            options.method = method;
            options.variance_reduction = reduction;
            options.trials = 40'000;
            options.maximum_trials = 200'000;
            KeptUnits store;
            store.units = units_of_run(options);
            RunControl control{{}, {}, 1, &store};
            EXPECT_FALSE(evaluate(model, model.inputs(), options, control));
            ASSERT_FALSE(store.kept.empty());
            store.computing = false;
            const std::vector<std::string> whole = store.kept;
            const auto result = evaluate(model, model.inputs(), options, control);
            ASSERT_TRUE(result);
            EXPECT_EQ(result->outputs[0].estimate, evaluated(model, options).outputs[0].estimate);
            constexpr std::uint64_t words[] = {0, 1, 0x7fffffffffffffff, 0xffffffffffffffff, 20'000};
            for (int n = 0; n < 30; ++n) {
                store.kept = whole;
                std::string& unit = store.kept[figures.below(store.kept.size())];
                // Counts stand first; figures of any other place are figures.
                const std::size_t place =
                    n < 20 ? 8 * (static_cast<std::size_t>(n) % 4) : 8 * figures.below(unit.size() / 8);
                std::memcpy(unit.data() + place, &words[figures.below(5)], 8);
                store.refused = 0;
                const auto damaged = evaluate(model, model.inputs(), options, control);
                EXPECT_TRUE(damaged || store.refused > 0) << damaged.error().message.english();
            }
            EXPECT_TRUE(evaluate(model, model.inputs(), options, {{}, {}, 1}));
        }
}

// Caesium's frequency with the u of today: one step of double numbers there is 1.9 uHz.
TEST(FiguresOneStepApart, RoundedTrialsAreSaid) {
    const auto warned = [](double u) {
        InputSet inputs;
        add_quantity(inputs, "f", Distribution::of(Normal{9192631770.0, u}));
        add_quantity(inputs, "d", Distribution::of(Normal{0.0, u}));
        EvaluationOptions options;
        options.trials = 20'000;
        const auto result = evaluate(sum_model(inputs), inputs, options);
        EXPECT_TRUE(result);
        return result && std::ranges::any_of(result->warnings, [](const Message& warning) {
                   return warning.english().find("steps in which numbers") != std::string::npos;
               });
    };
    EXPECT_TRUE(warned(1e-6));
    EXPECT_TRUE(warned(1e-5));
    EXPECT_FALSE(warned(1e-3));
}

}  // namespace
}  // namespace covaria::test::random_figures_test
