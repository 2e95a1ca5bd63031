// Force-proving instrument (ISO 376, EURAMET cg-4) against errors that are known by construction, and
// covariances computed here from the series one by one.
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <functional>

#include "core/base/resource_path.h"
#include "core/text/cell.h"
#include "tests/core/kinds/sheets/made_sheet.h"
#include "tests/core/made.h"

namespace covaria::sheets_test {
namespace {

constexpr const char* proving = "force-proving-instrument";

/// Deflections in mV/V at 10, 20 ... kN: X1 the mean, X3 and X5 beside it by `turned`, X2 beside X1 by
/// `again`, decreasing ones above the increasing by `back_3`, `back_5`; all relative.
struct Transducer {
    std::vector<double> mean{0.4, 0.8, 1.2, 1.6, 2.0};
    double turned = 3e-4, again = 1e-4, back_3 = 5e-4, back_5 = 9e-4, machine_U = 2e-4;

    double series(std::size_t rotation, std::size_t i) const {
        const std::array<double, 3> factor{1.0, 1.0 + turned, 1.0 - turned};
        return mean[i] * factor[rotation];
    }

    covaria::Setup setup() const {
        const Unit ratio = Unit::of("mV/V"), percent = Unit::of("%");
        const std::array<double, 4> zero{0.05, -0.02, 0.03, 0.01};
        SetupTable steps, unloaded;
        steps.units = {Unit::of("kN"), ratio, ratio, ratio, ratio, ratio, ratio, percent};
        for (std::size_t i = 0; i < mean.size(); ++i)
            steps.rows.push_back({10.0 * double(i + 1), zero[0] + mean[i], zero[1] + mean[i] * (1.0 + again),
                                  zero[2] + series(1, i), zero[2] + series(1, i) * (1.0 + back_3),
                                  zero[3] + series(2, i), zero[3] + series(2, i) * (1.0 + back_5),
                                  100.0 * machine_U});
        unloaded.units = {Unit{}, ratio, ratio};
        const std::array<double, 4> change{2e-4, -4e-4, 1e-4, 0.0};
        const std::array<const char*, 4> names{"X1", "X2", "X3", "X5"};
        for (std::size_t k = 0; k < 4; ++k)
            unloaded.rows.push_back({std::string(names[k]), zero[k], zero[k] + change[k]});
        covaria::Setup made;
        made.values["steps"] = steps;
        made.values["unloaded"] = unloaded;
        made.values["resolution"] = Quantity{2e-5, ratio};
        made.values["degree"] = Quantity{1.0, Unit{}};
        return made;
    }
};

double cell(const Table& table, const char* column, std::size_t row) {
    return value(table[column].cell(row));
}

/// All outputs of a group or symbol, first order.
std::vector<OutputResult> outputs_of(const MeasurementModel& model, const std::string& beginning) {
    const auto result = evaluate_first_order(model, model.inputs(), {});
    if (!result) throw std::runtime_error(result.error().message.english());
    std::vector<OutputResult> found;
    for (const OutputResult& y : result->outputs)
        if (y.quantity.symbol.starts_with(beginning)) found.push_back(y);
    return found;
}

TEST(ForceProving, ErrorsAreThoseOfTheConstruction) {
    const Transducer t;
    const auto model = made(proving, t.setup());
    const Table errors = table_of(model->evaluation(), "errors");
    ASSERT_EQ(errors.rows, 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(cell(errors, "mean deflection", i), 1e-3 * t.mean[i], 1e-15);
        EXPECT_NEAR(cell(errors, "b", i), 2.0 * t.turned, 1e-12);
        EXPECT_NEAR(cell(errors, "b'", i), t.again / (1.0 + 0.5 * t.again), 1e-12);
        EXPECT_NEAR(cell(errors, "f_c", i), 0.0, 1e-12) << "a line through a line";
        EXPECT_NEAR(cell(errors, "v", i), 0.5 * (t.back_3 + t.back_5), 1e-12);
    }
    const Table sheet = table_of(model->evaluation(), "sheet");
    EXPECT_NEAR(value(sheet.columns[1].cell(2)), -100.0 * 4e-4 / 2.0, 1e-9) << "f_0 in %, of X2";
}

// t^2 at 1 to 5 less its line 6 t - 7: 2, -1, -2, -1, 2.
TEST(ForceProving, InterpolationLeavesTheResidualsOfASquare) {
    Transducer t;
    const double q = 1e-4;
    for (std::size_t i = 0; i < 5; ++i) t.mean[i] += q * double((i + 1) * (i + 1));
    const std::array<double, 5> left{2.0, -1.0, -2.0, -1.0, 2.0};
    const auto model = made(proving, t.setup());
    const Table errors = table_of(model->evaluation(), "errors"),
                parts = table_of(model->evaluation(), "parts");
    const double s = q * std::sqrt(14.0 / 3.0);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(cell(errors, "f_c", i), q * left[i] / (t.mean[i] - q * left[i]), 1e-11);
        EXPECT_NEAR(cell(parts, "interpolation", i), s / t.mean[4], 1e-12);
    }
    covaria::Setup each = t.setup();
    each.values["interpolation"] = std::string("each");
    const Table grows = table_of(made(proving, each)->evaluation(), "parts");
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(cell(grows, "interpolation", i), s / t.mean[i], 1e-12);
    covaria::Setup square = t.setup();
    square.values["degree"] = Quantity{2.0, Unit{}};
    const auto exact = made(proving, square);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(cell(table_of(exact->evaluation(), "errors"), "f_c", i), 0.0, 1e-12);
    const std::vector<OutputResult> a = outputs_of(*exact, "A_");
    ASSERT_EQ(a.size(), 3u);
    EXPECT_NEAR(1e3 * a[0].estimate, 0.0, 1e-12);
    EXPECT_NEAR(1e3 * 1e4 * a[1].estimate, 0.4, 1e-12) << "per 10 kN";
    EXPECT_NEAR(1e3 * 1e8 * a[2].estimate, q, 1e-12);
}

TEST(ForceProving, WHasAllItsParts) {
    Transducer t;
    covaria::Setup setup = t.setup();
    setup.values["creep_30"] = Quantity{0.0508, Unit::of("mV/V")};
    setup.values["creep_300"] = Quantity{0.0504, Unit::of("mV/V")};
    setup.values["temperature_coefficient"] = Quantity{0.005, Unit::of("%/K")};
    setup.values["temperature_half_width"] = Quantity{2.0, Unit::of("K")};
    setup.values["used"] = std::string("both");
    setup.values["reversibility_divisor"] = Quantity{2.0, Unit{}};
    setup.values["coverage_factor"] = Quantity{2.5, Unit{}};
    const auto model = made(proving, setup);
    const Table parts = table_of(model->evaluation(), "parts");
    const std::vector<OutputResult> outputs = outputs_of(*model, "X_a");
    ASSERT_EQ(outputs.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        const std::array<double, 9> u{1e-4,
                                      t.turned / std::sqrt(3.0),
                                      t.again / (1.0 + 0.5 * t.again) / std::sqrt(3.0),
                                      2e-5 / t.mean[i] / std::sqrt(6.0),
                                      4e-4 / 2.0 / std::sqrt(3.0),
                                      4e-4 / 2.0,
                                      1e-4 / std::sqrt(3.0),
                                      0.0,
                                      7e-4 / 2.0};
        double squares = 0.0;
        for (std::size_t k = 0; k < 9; ++k) {
            EXPECT_NEAR(value(parts.columns[1 + k].cell(i)), u[k], 1e-12) << parts.columns[1 + k].key;
            squares += u[k] * u[k];
        }
        EXPECT_NEAR(cell(parts, "w", i), std::sqrt(squares), 1e-12);
        EXPECT_NEAR(cell(parts, "W", i), 2.5 * std::sqrt(squares), 1e-12);
        EXPECT_NEAR(outputs[i].first_order.standard_uncertainty, 1e-3 * t.mean[i] * std::sqrt(squares),
                    1e-15);
    }
}

// Rotations alone: the covariance of three separate fits over 6, with two degrees of freedom; all parts:
// what all forces share scales the curve, the rest is propagated by the gain.
TEST(ForceProving, CoefficientsHaveTheCovarianceOfTheSeries) {
    Transducer t;
    t.mean = {0.41, 0.79, 1.21, 1.62, 1.98};
    covaria::Setup setup = t.setup();
    auto& rows = std::get<SetupTable>(setup.values["steps"]).rows;
    const std::array<double, 5> bump{3e-4, -2e-4, 5e-4, 1e-4, -4e-4};
    Eigen::MatrixXd series(5, 3);
    Eigen::VectorXd again(5);
    for (std::size_t i = 0; i < 5; ++i) {
        rows[i][3] = std::get<double>(rows[i][3]) + bump[i];
        const auto k = Eigen::Index(i);
        series.row(k) << t.mean[i], t.series(1, i) + bump[i], t.series(2, i);
        again[k] = t.mean[i] * t.again / (1.0 + 0.5 * t.again);
    }
    Eigen::MatrixXd design(5, 2);
    design << 1, 1, 1, 2, 1, 3, 1, 4, 1, 5;
    const Eigen::MatrixXd gain = (design.transpose() * design).inverse() * design.transpose();
    const Eigen::MatrixXd fits = gain * series;
    const Eigen::VectorXd mean = fits.rowwise().mean();
    const Eigen::MatrixXd apart = fits.colwise() - mean, rotations = apart * apart.transpose() / 6.0;
    const double common = std::pow(0.5 * t.machine_U, 2) + std::pow(4e-4 / series.row(4).mean(), 2);
    const Eigen::VectorXd own =
        again.array().square() / 3.0 * (series.rowwise().mean().array() / series.col(0).array()).square() +
        2e-5 * 2e-5 / 6.0;
    const Eigen::MatrixXd all =
        rotations + common * mean * mean.transpose() + gain * own.asDiagonal() * gain.transpose();
    const auto covariance = [](const covaria::Setup& of) {
        const auto model = made(proving, of);
        const auto result = evaluate_first_order(*model, model->inputs(), {});
        const std::array<double, 2> unit{1e3, 1e3 * 1e4};  // mV/V, and that per 10 kN
        const OutputCovariance covariances = first_order_covariance(*result);
        Eigen::Matrix2d found;  // behind five deflections
        for (Eigen::Index i = 0; i < 2; ++i)
            for (Eigen::Index j = 0; j < 2; ++j)
                found(i, j) = covariances(5 + i, 5 + j) * unit[std::size_t(i)] * unit[std::size_t(j)];
        return Eigen::MatrixXd(found);
    };
    EXPECT_LT((covariance(setup) - all).cwiseAbs().maxCoeff(), 1e-9 * all.cwiseAbs().maxCoeff());
    setup.values.erase("unloaded");
    const std::array<double, 6> zero{0.05, -0.02, 0.03, 0.03, 0.01, 0.01};
    for (auto& row : rows) {
        for (std::size_t k = 0; k < 6; ++k) row[k + 1] = std::get<double>(row[k + 1]) - zero[k];
        row[2] = row[1];
        row[7] = 0.0;
    }
    setup.values["resolution"] = Quantity{0.0, Unit::of("mV/V")};
    EXPECT_LT((covariance(setup) - rotations).cwiseAbs().maxCoeff(), 1e-9 * rotations.cwiseAbs().maxCoeff());
    for (const OutputResult& a : outputs_of(*made(proving, setup), "A_"))
        EXPECT_NEAR(a.first_order.effective_degrees_of_freedom, 2.0, 1e-9);
}

TEST(ForceProving, MonteCarloAgrees) {
    Transducer t;
    t.mean = {0.4003, 0.7996, 1.2001, 1.6005, 2.0};
    covaria::Setup setup = t.setup();
    setup.values["creep_30"] = Quantity{0.0508, Unit::of("mV/V")};
    setup.values["creep_300"] = Quantity{0.0504, Unit::of("mV/V")};
    const auto model = made(proving, setup);
    EvaluationOptions options;
    options.trials = 200'000;
    const auto result = evaluate(*model, model->inputs(), options);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->failed_trials, 0u);
    for (const OutputResult& y : result->outputs) {
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty, y.first_order.standard_uncertainty,
                    4.0 * y.monte_carlo->standard_error_of_uncertainty)
            << y.quantity.symbol << " " << y.quantity.group;
        EXPECT_NEAR(y.monte_carlo->mean, y.first_order.estimate, 4.0 * y.monte_carlo->standard_error_of_mean);
    }
}

// With t draws and nothing but rotations the half width of the interval is t_.975(2) u = 4.3027 u. The
// standard error of a quantile is sqrt(p (1 - p)/M) over the density (2 + t^2)^(-3/2).
TEST(ForceProving, DrawsOfTheRotationsMayBeT) {
    Transducer t;
    t.again = t.machine_U = 0.0;
    covaria::Setup setup = t.setup();
    setup.values.erase("unloaded");
    for (auto& row : std::get<SetupTable>(setup.values["steps"]).rows) {
        const std::array<double, 6> zero{0.05, -0.02, 0.03, 0.03, 0.01, 0.01};
        for (std::size_t k = 0; k < 6; ++k) row[k + 1] = std::get<double>(row[k + 1]) - zero[k];
    }
    setup.values["resolution"] = Quantity{0.0, Unit::of("mV/V")};
    setup.values["type_a"] = std::string("student-t");
    const auto model = made(proving, setup);
    EvaluationOptions options;
    options.trials = 400'000;
    const auto result = evaluate(*model, model->inputs(), options);
    ASSERT_TRUE(result);
    const OutputResult& y = result->outputs.front();
    const double u = y.first_order.standard_uncertainty, density = std::pow(2.0 + 4.3027 * 4.3027, -1.5);
    EXPECT_NEAR(0.5 * (y.monte_carlo->symmetric.high - y.monte_carlo->symmetric.low), 4.3027 * u,
                4.0 * u * std::sqrt(0.025 * 0.975 / 4e5) / density);
}

SetupTable limits(const std::vector<std::vector<SetupCell>>& rows) {
    const Unit percent = Unit::of("%");
    SetupTable table;
    table.units = {Unit{}, percent, percent, percent, percent, percent, percent, percent};
    table.rows = rows;
    return table;
}

// b is 0.06 % but for the two smallest forces, where it is 0.2 % and 0.1 %.
TEST(ForceProving, ClassesFollowFromTheLimitsEntered) {
    Transducer t;
    covaria::Setup setup = t.setup();
    auto& rows = std::get<SetupTable>(setup.values["steps"]).rows;
    rows[0][3] = 0.03 + 0.4 * 1.001, rows[0][5] = 0.01 + 0.4 * 0.999;
    rows[1][3] = 0.03 + 0.8 * 1.0005, rows[1][5] = 0.01 + 0.8 * 0.9995;
    const SetupCell none;
    setup.values["classes"] = limits({{std::string("fine"), 0.07, 0.02, none, 0.03, none, none, 0.02},
                                      {std::string("middle"), 0.11, 0.02, none, 0.03, none, none, 0.02},
                                      {std::string("coarse"), 0.21, 0.02, none, 0.03, none, none, 0.02}});
    const auto verdicts = [](const covaria::Setup& of) {
        const Table classes = table_of(made(proving, of)->evaluation(), "classes");
        std::vector<double> from;
        for (std::size_t k = 0; k < classes.rows; ++k)
            from.push_back(english_of(classes.columns[3].cell(k)) == "conforms"
                               ? 1e-3 * value(classes.columns[1].cell(k))
                               : std::nan(""));
        return from;
    };
    const std::vector<double> from = verdicts(setup);
    EXPECT_NEAR(from[0], 30.0, 1e-9);
    EXPECT_NEAR(from[1], 20.0, 1e-9);
    EXPECT_NEAR(from[2], 10.0, 1e-9);
    // f_0 is -0.02 %: a limit below it leaves no force, whatever the others say.
    auto& first = std::get<SetupTable>(setup.values["classes"]).rows[0];
    first[4] = 0.019;
    EXPECT_TRUE(std::isnan(verdicts(setup)[0]));
    first[4] = none;
    first[7] = 0.019;
    EXPECT_TRUE(std::isnan(verdicts(setup)[0])) << "U of the force is 0.02 %";
    first[7] = none;
    first[5] = 0.069;
    EXPECT_TRUE(std::isnan(verdicts(setup)[0])) << "v is 0.07 %";
    first[5] = 0.071;
    EXPECT_NEAR(verdicts(setup)[0], 30.0, 1e-9);
}

// b of the first step is 0.2 %: it is of the class whose limit is wider, which says nothing of the other.
TEST(ForceProving, AClassIsHeldAgainstItsOwnLimitsInWhateverOrderTheyStand) {
    Transducer t;
    covaria::Setup setup = t.setup();
    auto& rows = std::get<SetupTable>(setup.values["steps"]).rows;
    rows[0][3] = 0.03 + 0.4 * 1.001, rows[0][5] = 0.01 + 0.4 * 0.999;
    const SetupCell none;
    setup.values["classes"] = limits({{std::string("wide"), 0.21, none, none, none, none, none, none},
                                      {std::string("narrow"), 0.07, none, none, none, none, none, none}});
    const Table classes = table_of(made(proving, setup)->evaluation(), "classes");
    EXPECT_NEAR(1e-3 * value(classes.columns[1].cell(0)), 10.0, 1e-9);
    EXPECT_NEAR(1e-3 * value(classes.columns[1].cell(1)), 20.0, 1e-9) << "the first step is beyond 0.07 %";
}

TEST(ForceProving, WithoutLimitsThereIsNoClass) {
    const auto model = made(proving, Transducer().setup());
    for (const Table& table : model->evaluation()) {
        EXPECT_NE(table.id, "classes");
        EXPECT_EQ(table.find("class"), nullptr);
    }
    EXPECT_TRUE(
        std::holds_alternative<std::monostate>(find_model(proving)->schema.find("classes")->default_value))
        << "no limit is built in";
}

// The curve of W runs through or above every step.
TEST(ForceProving, TheCurveOfWLiesBelowNoStep) {
    Transducer t;
    covaria::Setup setup = t.setup();
    for (const double degree : {0.0, 1.0, 2.0, 3.0}) {
        setup.values["uncertainty_degree"] = Quantity{degree, Unit{}};
        const auto model = made(proving, setup);
        const Table curves = table_of(model->evaluation(), "curves"),
                    parts = table_of(model->evaluation(), "parts");
        double nearest = 1.0;
        for (std::size_t i = 0; i < 5; ++i) {
            double w = 0.0;
            for (std::size_t row = 2; row < curves.rows; ++row)
                w += value(curves.columns[2].cell(row)) *
                     std::pow(10.0 * double(i + 1), value(curves.columns[1].cell(row)));
            const double above = w - 100.0 * cell(parts, "W", i);
            EXPECT_GT(above, -1e-9) << degree;
            nearest = std::min(nearest, above);
        }
        EXPECT_NEAR(nearest, 0.0, 1e-9) << "raised by no more than it takes";
        EXPECT_EQ(curves.rows, 2u + std::size_t(degree) + 1u);
    }
}

// Compression reads negative deflections: errors and w are the same, f_0 turns its sign with the deflection.
TEST(ForceProving, CompressionIsTensionTurned) {
    Transducer t;
    covaria::Setup tension = t.setup(), compression = tension;
    for (const char* table : {"steps", "unloaded"})
        for (auto& row : std::get<SetupTable>(compression.values[table]).rows)
            for (std::size_t k = 1; k < row.size() && k < 7; ++k) row[k] = -std::get<double>(row[k]);
    const auto a = made(proving, tension), b = made(proving, compression);
    const Table up = table_of(a->evaluation(), "parts"), down = table_of(b->evaluation(), "parts");
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(cell(up, "w", i), cell(down, "w", i), 1e-14);
    EXPECT_NEAR(outputs_of(*a, "X_a")[2].estimate, -outputs_of(*b, "X_a")[2].estimate, 1e-16);
    EXPECT_NEAR(outputs_of(*a, "X_a")[2].first_order.standard_uncertainty,
                outputs_of(*b, "X_a")[2].first_order.standard_uncertainty, 1e-16);
}

TEST(ForceProving, RefusesWhatCannotBe) {
    const auto refused = [](const std::function<void(covaria::Setup&, SetupTable&)>& spoil) {
        covaria::Setup setup = Transducer().setup();
        spoil(setup, std::get<SetupTable>(setup.values["steps"]));
        Problems problems;
        return !made(proving, setup, problems) && problems.has_errors();
    };
    EXPECT_FALSE(refused([](auto&, auto&) {}));
    EXPECT_TRUE(refused([](auto&, SetupTable& steps) { steps.rows[2][7] = SetupCell(); }))
        << "no U, no machine";
    EXPECT_TRUE(refused([](auto&, SetupTable& steps) { steps.rows[2][0] = 20.0; })) << "a force twice";
    EXPECT_TRUE(refused([](auto&, SetupTable& steps) { steps.rows[2][3] = 0.3; })) << "does not grow";
    EXPECT_TRUE(refused([](covaria::Setup& setup, auto&) {
        setup.values["creep_30"] = Quantity{0.05, Unit::of("mV/V")};
    })) << "half a creep test";
    EXPECT_TRUE(refused([](covaria::Setup& setup, auto&) {
        std::get<SetupTable>(setup.values["unloaded"]).rows.pop_back();
    })) << "a series without its zero";
    EXPECT_TRUE(refused([](covaria::Setup& setup, SetupTable& steps) {
        steps.rows.resize(3);
        setup.values["degree"] = Quantity{2.0, Unit{}};
    })) << "no degree of freedom";
    EXPECT_TRUE(refused([](covaria::Setup& setup, SetupTable& steps) {
        setup.values["used"] = std::string("both");
        steps.rows[1][4] = steps.rows[1][6] = SetupCell();
    })) << "decreasing forces that were not read";
}

// The machine of the example states U = 0.01 %, k = 2, for Fz: its share is one component of all forces.
TEST(ForceProving, TheMachineIsSharedByAllForces) {
    const LoadedProject loaded = load_project(data_directory() / "projects" / "force-transducer.covaria");
    Problems problems;
    const auto prepared = made_analysis(loaded.project, "calibration", problems);
    ASSERT_TRUE(prepared);
    const InputSet& inputs = prepared->inputs;
    std::size_t with_it = 0;
    for (const InputQuantity& q : inputs.quantities)
        for (const Share& share : q.shares) {
            const UncertaintyComponent& c = inputs.components[share.component];
            if (c.id != "machine") continue;
            ++with_it;
            EXPECT_EQ(c.contributor, "machine");
            EXPECT_NEAR(c.distribution.standard_uncertainty(), 5e-5, 1e-18);
            EXPECT_NEAR(share.factor, q.offset, 1e-12);
        }
    EXPECT_EQ(with_it, 8u);
}

}  // namespace
}  // namespace covaria::sheets_test
