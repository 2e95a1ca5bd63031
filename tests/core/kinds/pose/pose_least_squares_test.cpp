// Least-squares frames in the model: against a registration of each trial by Eigen, and what must not matter
// (the order of the rows, where frame 0 is).
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "core/math/rotation.h"
#include "core/propagation/engine.h"
#include "tests/core/kinds/pose/pose_case.h"
#include "tests/core/kinds/pose/stewart.h"

namespace covaria::pose_least_squares_test {
namespace {

using namespace stewart;

constexpr double deg = std::numbers::pi / 180.0;

struct Frames {
    Points base, platform;
    std::array<double, 6> pose{};
    double u = 0.1;
};

Frames random_frames(unsigned seed, const std::array<double, 3>& size, std::size_t n, double u) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto points = [&](const std::array<double, 3>& s, std::size_t count) {
        Points p;
        for (std::size_t i = 0; i < count; ++i)
            p.push_back({s[0] * uniform(generator), s[1] * uniform(generator), s[2] * uniform(generator)});
        return p;
    };
    Frames f{points({600, 500, 200}, 5), points(size, n), {}, u};
    for (std::size_t k = 0; k < 6; ++k) f.pose[k] = (k < 3 ? 800.0 : 60.0) * uniform(generator);
    return f;
}

covaria::Setup setup_of(const Frames& f) {
    covaria::Setup s = setup(f.base, f.platform, {f.u, 1.5 * f.u, 2 * f.u}, f.u);
    s.values["poses"] = poses_table({f.pose});
    for (const char* key : {"base_fit", "moving_fit"}) s.values[key] = std::string("least-squares");
    s.values["moving_u_z"] = mm(2 * f.u);
    return s;
}

UncertaintyResult monte_carlo(const MeasurementModel& model, const InputSet& inputs, std::uint64_t trials) {
    EvaluationOptions options;
    options.trials = trials;
    options.seed = 7;
    return evaluate(model, inputs, options).value();
}

/// Standard deviations of x, y, z, alpha, beta, gamma by trials of its own and Eigen's registration.
std::array<double, 6> by_eigen(const Frames& f, const MeasurementModel& model, int trials, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    const InputSet& inputs = model.inputs();
    const auto columns = [](const Points& points) {
        Eigen::Matrix3Xd m(3, points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            m.col(static_cast<Eigen::Index>(i)) = 1e-3 * Eigen::Vector3d(points[i].data());
        return m;
    };
    const Eigen::Matrix3Xd base = columns(f.base), platform = columns(f.platform);
    std::array<double, 6> sum{}, squares{}, first{};
    for (int t = 0; t < trials; ++t) {
        std::vector<double> e;
        for (const UncertaintyComponent& c : inputs.components)
            e.push_back(c.distribution.standard_uncertainty() * normal(generator));
        Eigen::Matrix3Xd q(3, inputs.quantities.size() / 3);
        for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
            double x = inputs.quantities[i].offset;
            for (const Share& share : inputs.quantities[i].shares) x += share.factor * e[share.component];
            q(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(i / 3)) = x;
        }
        const Eigen::Isometry3d X_0b(Eigen::umeyama(base, q.leftCols(base.cols()).eval(), false)),
            X_0p(Eigen::umeyama(platform, q.rightCols(platform.cols()).eval(), false));
        const Eigen::Isometry3d X = X_0b.inverse() * X_0p;
        const Vector3<double> angles = zyx_from_rotation<double>(X.linear());
        for (std::size_t k = 0; k < 6; ++k) {
            const auto axis = static_cast<Eigen::Index>(k % 3);
            const double y = k < 3 ? X.translation()[axis] : angles[axis];
            if (t == 0) first[k] = y;
            const double d = k < 3 ? y - first[k] : std::remainder(y - first[k], 2 * std::numbers::pi);
            sum[k] += d;
            squares[k] += d * d;
        }
    }
    std::array<double, 6> u{};
    for (std::size_t k = 0; k < 6; ++k)
        u[k] = std::sqrt((squares[k] - sum[k] * sum[k] / trials) / (trials - 1));
    return u;
}

TEST(PoseLeastSquares, AgreesWithARegistrationOfEachTrial) {
    struct Shape {
        std::array<double, 3> size;
        std::size_t points;
        double u;
    };
    const Shape shapes[] = {{{300, 200, 100}, 5, .2},
                            {{300, 200, 0}, 4, .2},
                            {{1500, 20, 0}, 12, .5},
                            {{500, 8, 0}, 40, 1.0},
                            {{200, 10, 10}, 6, 0.8}};
    unsigned seed = 11;
    for (const Shape& shape : shapes)
        for (int repeat = 0; repeat < 2; ++repeat) {
            const Frames f = random_frames(seed++, shape.size, shape.points, shape.u);
            const auto model = make(setup_of(f));
            constexpr int trials = 20000;
            const UncertaintyResult result = monte_carlo(*model, model->inputs(), 4 * trials);
            const std::array<double, 6> expected = by_eigen(f, *model, trials, seed);
            EXPECT_EQ(result.failed_trials, 0u);
            for (std::size_t k = 0; k < 6; ++k) {
                const MonteCarloOutput& found = *result.outputs[k].monte_carlo;
                // a quarter of the trials: twice the standard error
                const double combined = std::sqrt(5.0) * found.standard_error_of_uncertainty;
                EXPECT_NEAR(found.standard_uncertainty, expected[k], 4 * combined)
                    << shape.size[1] << " " << k;
            }
        }
}

double u_of(const UncertaintyResult& result, std::size_t j) {
    return result.outputs[j].monte_carlo->standard_uncertainty;
}

TEST(PoseLeastSquares, TheRailHasItsUncertaintyInEveryOrder) {
    const Project rail = pose_case::project("railorder");
    for (const AnalysisEntry& entry : rail.analyses) {
        Problems problems;
        const auto prepared = pose_case::prepared(rail, entry.id, problems);
        ASSERT_TRUE(prepared);
        const UncertaintyResult result = monte_carlo(*prepared->model, prepared->inputs, 200000);
        EXPECT_EQ(result.failed_trials, 0u);
        EXPECT_NEAR(u_of(result, 3) / deg, .4136, 4 * .4136 / std::sqrt(2 * 2e5)) << entry.id;
    }
}

TEST(PoseLeastSquares, TheStripLosesNoTrial) {
    const Project strips = pose_case::project("att12");
    Problems problems;
    const auto prepared = pose_case::prepared(strips, "w8", problems);
    ASSERT_TRUE(prepared);
    const UncertaintyResult result = monte_carlo(*prepared->model, prepared->inputs, 100000);
    EXPECT_EQ(result.failed_trials, 0u);
    EXPECT_NEAR(u_of(result, 3) / deg, 1.133, 4 * 1.133 / std::sqrt(2 * 1e5) + 5e-4);
}

/// First-order results: estimates and standard uncertainties of all outputs.
std::vector<std::array<double, 2>> numbers(const covaria::Setup& s) {
    const auto model = make(s);
    const UncertaintyResult result = evaluate_first_order(*model, model->inputs(), {}).value();
    std::vector<std::array<double, 2>> all;
    for (const OutputResult& out : result.outputs)
        all.push_back({out.first_order.estimate, out.first_order.standard_uncertainty});
    return all;
}

void expect_same(const std::vector<std::array<double, 2>>& a, const std::vector<std::array<double, 2>>& b,
                 const char* what) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t j = 0; j < a.size(); ++j) {
        EXPECT_NEAR(std::remainder(a[j][0] - b[j][0], 2 * std::numbers::pi), 0.0, 1e-9) << what << " " << j;
        EXPECT_NEAR(b[j][1] / a[j][1], 1.0, 1e-7) << what << " " << j;
    }
}

/// Every way to make the frames and to state their uncertainty.
std::vector<covaria::Setup> variants(const Frames& f) {
    std::vector<covaria::Setup> all;
    for (const char* fit : {"least-squares", "three-two-one"})
        for (const char* axes : {"own", "base"})
            for (const char* orientation : {"zyx", "rotation-vector"})
                for (bool common : {false, true}) {
                    covaria::Setup s = setup_of(f);
                    s.values["base_fit"] = s.values["moving_fit"] = std::string(fit);
                    s.values["moving_uncertainty_axes"] = std::string(axes);
                    s.values["orientation"] = std::string(orientation);
                    s.values["moving_common_x"] = common;
                    s.values["base_common_z"] = common;
                    all.push_back(std::move(s));
                }
    return all;
}

TEST(PoseLeastSquares, WhereFrameZeroIsDoesNotMatter) {
    unsigned seed = 90;
    for (int k = 0; k < 3; ++k)
        for (covaria::Setup& s : variants(random_frames(seed++, {300, 200, 100}, 5, .2))) {
            const auto here = numbers(s);
            PoseValue elsewhere;
            elsewhere.position = {4000.0, -2500.0, 900.0};
            elsewhere.angles = {25.0 * k, 90.0 - 40.0 * k, -130.0};
            s.values["base_pose"] = elsewhere;
            expect_same(here, numbers(s), "moved");
        }
}

TEST(PoseLeastSquares, TheOrderOfTheRowsDoesNotMatter) {
    unsigned seed = 120;
    for (const std::array<double, 3>& size : {std::array{300.0, 200.0, 100.0}, std::array{1500.0, 20.0, 0.0}})
        for (covaria::Setup& s : variants(random_frames(seed++, size, 7, .1))) {
            if (std::get<std::string>(s.values["base_fit"]) != "least-squares") continue;
            const auto here = numbers(s);
            for (const char* key : {"base_points", "moving_points"}) {
                auto& rows = std::get<SetupTable>(s.values[key]).rows;
                std::reverse(rows.begin(), rows.end());
                std::swap(rows[0], rows[2]);
            }
            expect_same(here, numbers(s), "permuted");
        }
}

TEST(PoseInputs, UncertaintiesAlongTheBaseStayThereInEveryPose) {
    covaria::Setup s = setup();
    s.values["moving_uncertainty_axes"] = std::string("base");
    s.values["moving_u_x"] = mm(1.0);
    s.values["moving_u_y"] = mm(2.0);
    s.values["moving_u_z"] = mm(3.0);
    const auto model = make(s);
    for (std::size_t i = 9; i < model->inputs().quantities.size(); ++i)
        EXPECT_NEAR(standard_uncertainty_of(model->inputs(), i), 1e-3 * double(i % 3 + 1), 1e-12) << i;
}

TEST(PoseInputs, AnEditReplacesWhetherThePoseIsTurnedOrNot) {
    Project project = pose_case::project("edit");
    for (bool turned : {true, false}) {
        auto& row = std::get<SetupTable>(project.analyses[0].setup.values["poses"]).rows[0];
        if (!turned)
            for (std::size_t c = 4; c < 7; ++c) row[c] = 0.0;
        Problems problems;
        const auto prepared = pose_case::prepared(project, "x", problems);
        ASSERT_TRUE(prepared);
        for (const char* symbol : {"p_1x_1", "b_1x"})
            EXPECT_NEAR(standard_uncertainty_of(prepared->inputs, prepared->inputs.find(symbol)), 1e-3, 1e-15)
                << symbol << turned;
        InputSet as_stated = prepared->model->inputs();
        for (const char* symbol : {"p_1y_1", "p_1z_1", "p_2x_1", "b_1y"})
            EXPECT_EQ(standard_uncertainty_of(prepared->inputs, prepared->inputs.find(symbol)),
                      standard_uncertainty_of(as_stated, as_stated.find(symbol)))
                << symbol << turned;
    }
}

}  // namespace
}  // namespace covaria::pose_least_squares_test
