// Geometry from points: reference results of NIST, generated points whose least squares are known exactly,
// derivatives, covariances, and what is refused.
#include <cmath>
#include <numbers>

#include "tests/core/kinds/geometry/geometry_setups.h"

namespace covaria::geometry_test {
namespace {

using Eigen::Vector3d;

void expect_near(const Vector3d& found, const Vector3d& expected, double tolerance) {
    EXPECT_LT((found - expected).norm(), tolerance) << found.transpose() << " " << expected.transpose();
}

double scatter_of(const MeasurementModel& model) {
    return 1e3 * std::get<double>(model.evaluation()[0].rows[0][4]);
}

// NIST's reference results have 20 digits; those of a double are about 14. Cofactors: an independent solution
// by unit weights.
TEST(GeometryFromPoints, NistLine) {
    const auto model = made(setup_of({{"L", "line", lin12}}));
    const Results r = results_of(*model);
    expect_near(place_in(r, "L"), {491.09034066666666667, 57.722495333333333333, -177.38524866666666667},
                1e-11);
    expect_near(direction_in(r, "L"),
                {0.64019207207419047487, -0.16259354193138917386, 0.75081119529183906463}, 1e-13);
    EXPECT_NEAR(scatter_of(*model), 0.0247251825, 1e-10);
    for (const double u : column(*model, "condition", "across")) EXPECT_NEAR(u, 0.2581989, 1e-7);
    for (const double u : column(*model, "condition", "tilt")) EXPECT_NEAR(u, 12.37113, 1e-5);
}

TEST(GeometryFromPoints, NistPlane) {
    const auto model = made(setup_of({{"P", "plane", pla25}}));
    const Results r = results_of(*model);
    expect_near(place_in(r, "P"), {-1.0044566666666666667, -2.0125733333333333333, 0.0048733333333333333333},
                1e-14);
    expect_near(direction_in(r, "P"),
                {0.94053335499333179607, -0.20929606987242093331, 0.2675671192073981387}, 1e-14);
    EXPECT_NEAR(scatter_of(*model), 0.000612345001, 1e-12);
    EXPECT_NEAR(column(*model, "condition", "offset").at(0), 0.4082483, 1e-7);
    const std::vector<double> tilts = column(*model, "condition", "tilt");
    EXPECT_NEAR(tilts.at(0), 5825.817, 1e-3);
    EXPECT_NEAR(tilts.at(1), 713.4787, 1e-4);
}

TEST(GeometryFromPoints, NistCircle) {
    const auto model = made(setup_of({{"C", "circle", cir2}}));
    const Results r = results_of(*model);
    expect_near(place_in(r, "C"), {681.5549733770771716, -673.34977912239664663, 272.41240856437418627},
                2e-12);
    expect_near(direction_in(r, "C"), {0.2053818345066789328, 0.72876945459518842356, 0.65323302435172607058},
                1e-12);
    EXPECT_NEAR(1e3 * r.at("C.d"), 7.8812465477516351453, 3e-12);
    EXPECT_NEAR(scatter_of(*model), 0.00124745883, 1e-11);
    const std::vector<double> centre = column(*model, "condition", "place");
    EXPECT_NEAR(centre.at(0), 3.233737, 1e-6);
    EXPECT_NEAR(centre.at(1), 0.7433657, 1e-7);
    EXPECT_NEAR(column(*model, "condition", "diameter").at(0), 5.689147, 1e-6);
}

TEST(GeometryFromPoints, NistCylinder) {
    const auto model = made(setup_of({{"Z", "cylinder", cyl24}}));
    const Results r = results_of(*model);
    expect_near(place_in(r, "Z"), {-0.29897486630809583561, -0.20692103722129259813, 0.71421155699545107194},
                1e-13);
    expect_near(direction_in(r, "Z"),
                {-0.00079998933800503968457, 0.0038993954443938215034, 0.99999207733472934699}, 1e-13);
    EXPECT_NEAR(1e3 * r.at("Z.d"), 3.2877492601002778271, 1e-13);
    EXPECT_NEAR(scatter_of(*model), 0.00335679673, 1e-11);
    const std::vector<double> across = column(*model, "condition", "across"),
                              tilts = column(*model, "condition", "tilt");
    EXPECT_NEAR(across.at(0), 0.2182375, 1e-7);
    EXPECT_NEAR(across.at(1), 0.2181984, 1e-7);
    EXPECT_NEAR(tilts.at(0), 1623.545, 1e-3);
    EXPECT_NEAR(tilts.at(1), 1617.862, 1e-3);
    EXPECT_NEAR(column(*model, "condition", "diameter").at(0), 0.3088007, 1e-7);
}

/// A part somewhere in space: axes by columns, and its origin.
struct Frame {
    Eigen::Matrix3d R;
    Vector3d o;
    Vector3d at(double x, double y, double z) const { return o + R * Vector3d(x, y, z); }
    Vector3d z() const { return R.col(2); }
};

Frame frame_number(int k, double offset) {
    const double a = 0.7 + 1.3 * k, b = 0.4 + 2.1 * k, c = 0.2 + 0.9 * k;
    const Eigen::Matrix3d R =
        (Eigen::AngleAxisd(a, Vector3d::UnitZ()) * Eigen::AngleAxisd(b, Vector3d::UnitY()) *
         Eigen::AngleAxisd(c, Vector3d::UnitX()))
            .toRotationMatrix();
    return {R, offset * Vector3d(std::cos(a), std::sin(b), std::cos(c))};
}

/// Every place has a point outside and one inside by `e`: the sum of squares has its minimum where it would
/// have it without them.
Points sphere_cap(const Frame& f, double r, double half_angle, double e) {
    Points points;
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j < (i == 0 ? 1 : 7); ++j) {
            const double t = half_angle * i / 3.0, b = 2.0 * std::numbers::pi * j / 7.0 + 0.3 * i;
            for (const double d : {r + e, r - e})
                points.push_back(
                    f.at(d * std::sin(t) * std::cos(b), d * std::sin(t) * std::sin(b), d * std::cos(t)));
        }
    return points;
}

/// A cone of half the angle phi with radius r at z = 0; phi = 0 is a cylinder.
Points turned(const Frame& f, double r, double phi, double length, double arc, double e) {
    Points points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 7; ++j) {
            const double z = length * (i / 3.0 - 0.5), b = arc * (j / (arc > 6.0 ? 7.0 : 6.0) - 0.5);
            for (const double d : {e, -e}) {
                const double rho = r + z * std::tan(phi) + d * std::cos(phi), h = z - d * std::sin(phi);
                points.push_back(f.at(rho * std::cos(b), rho * std::sin(b), h));
            }
        }
    return points;
}

class Generated : public testing::TestWithParam<int> {};

TEST_P(Generated, SpheresAndCaps) {
    const int k = GetParam();
    for (const double half : {3.0, 1.5, 0.785, 0.35})
        for (const double offset : {0.0, 1e6}) {
            const Frame f = frame_number(k, offset);
            const Results r = results_of(*made(setup_of({{"S", "sphere", sphere_cap(f, 25.0, half, 0.01)}})));
            // Coordinates of 1e6 mm are given to 1e-10 mm.
            const double tolerance = (offset > 0.0 ? 1e-8 : 1e-11) / (half * half);
            expect_near(place_in(r, "S"), f.o, tolerance);
            EXPECT_NEAR(1e3 * r.at("S.d"), 50.0, 2.0 * tolerance);
            EXPECT_NEAR(1e3 * r.at("S.f_t"), 0.02, tolerance);
            EXPECT_NEAR(1e3 * r.at("S.f_q"), 0.01, tolerance);
        }
}

TEST_P(Generated, CylindersAndArcsOfThem) {
    const int k = GetParam();
    for (const double arc : {2.0 * std::numbers::pi, 2.5, 1.0})
        for (const double length : {100.0, 8.0})
            for (const double offset : {0.0, 1e6}) {
                const Frame f = frame_number(k, offset);
                const auto model =
                    made(setup_of({{"Z", "cylinder", turned(f, 20.0, 0.0, length, arc, 0.01)}}));
                const Results r = results_of(*model);
                const double tolerance = (offset > 0.0 ? 4e-8 : 1e-10) / (arc * arc);
                const Vector3d n = direction_in(r, "Z"), d = place_in(r, "Z") - f.o;
                EXPECT_LT(n.cross(f.z()).norm(), tolerance) << arc << " " << length;
                EXPECT_LT((d - n * n.dot(d)).norm(), tolerance);
                EXPECT_NEAR(1e3 * r.at("Z.d"), 40.0, 2.0 * tolerance);
                Eigen::Index largest;
                n.cwiseAbs().maxCoeff(&largest);
                EXPECT_GT(n[largest], 0.0);
            }
}

TEST_P(Generated, Cones) {
    const int k = GetParam();
    for (const double phi : {0.05, 0.4, 1.1})
        for (const double arc : {2.0 * std::numbers::pi, 2.0})
            for (const double offset : {0.0, 1e6}) {
                const Frame f = frame_number(k, offset);
                const Results r =
                    results_of(*made(setup_of({{"K", "cone", turned(f, 30.0, phi, 25.0, arc, 0.01)}})));
                const double tolerance = (offset > 0.0 ? 1e-7 : 1e-10) / phi;
                EXPECT_LT((direction_in(r, "K") - f.z()).norm(), tolerance) << phi << " " << arc;
                EXPECT_NEAR(r.at("K.alpha"), 2.0 * phi, tolerance);
                expect_near(place_in(r, "apex of K"), f.at(0.0, 0.0, -30.0 / std::tan(phi)),
                            30.0 * tolerance / phi);
            }
}

TEST_P(Generated, CirclesPlanesAndLines) {
    const Frame f = frame_number(GetParam(), 1e6);
    Points circle, plane, line;
    for (int j = 0; j < 9; ++j)
        for (const double e : {0.01, -0.01}) {
            const double b = 0.15 * j;
            circle.push_back(f.at((12.0 + e) * std::cos(b), (12.0 + e) * std::sin(b), 0.0));
            plane.push_back(f.at(10.0 * std::cos(2.3 * j), 6.0 * std::sin(1.7 * j), e));
            line.push_back(f.at(e, 0.0, 5.0 * j));
            line.push_back(f.at(0.0, e, 5.0 * j));
        }
    const auto model = made(setup_of({{"C", "circle", circle}, {"P", "plane", plane}, {"L", "line", line}}));
    const Results r = results_of(*model);
    expect_near(place_in(r, "C"), f.o, 2e-7);
    EXPECT_NEAR(1e3 * r.at("C.d"), 24.0, 4e-7);
    EXPECT_LT(direction_in(r, "C").cross(f.z()).norm(), 1e-8);
    EXPECT_LT(direction_in(r, "P").cross(f.z()).norm(), 1e-9);
    EXPECT_NEAR(1e3 * r.at("P.f_t"), 0.02, 1e-8);
    EXPECT_LT(direction_in(r, "L").cross(f.z()).norm(), 1e-10);
    EXPECT_NEAR(1e3 * r.at("L.f_t"), 0.02, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Frames, Generated, testing::Range(0, 6));

/// Deviations that no form takes up, the same in every run.
Points roughened(Points points, double amplitude) {
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int c = 0; c < 3; ++c)
            points[i][c] += amplitude * std::sin(12.9898 * double(i + 1) + 78.233 * c);
    return points;
}

std::vector<NamedPoints> all_forms(double roughness) {
    const Frame f = frame_number(1, 300.0);
    Points flat_circle, flat_line;
    for (int j = 0; j < 10; ++j) {
        flat_circle.push_back({5.0 + 8.0 * std::cos(0.3 * j), 8.0 * std::sin(0.3 * j), 1.0});
        flat_line.push_back({3.0 * j, 7.0 - 1.2 * j, 4.0});
    }
    Points plane, line;
    for (int j = 0; j < 9; ++j) {
        plane.push_back(f.at(10.0 * std::cos(2.3 * j), 6.0 * std::sin(1.7 * j), 0.0));
        line.push_back(f.at(0.0, 0.0, 5.0 * j));
    }
    std::vector<NamedPoints> all{{"Pt", "point", {f.at(1, 2, 3), f.at(1, 2, 3.1)}},
                                 {"L", "line", line},
                                 {"P", "plane", plane},
                                 {"C", "circle", turned(f, 12.0, 0.0, 0.0, 2.5, 0.0)},
                                 {"S", "sphere", sphere_cap(f, 25.0, 1.0, 0.0)},
                                 {"Z", "cylinder", turned(f, 20.0, 0.0, 30.0, 2.5, 0.0)},
                                 {"K", "cone", turned(f, 30.0, 0.4, 25.0, 2.5, 0.0)},
                                 {"L2", "line-2d", flat_line},
                                 {"C2", "circle-2d", flat_circle}};
    for (NamedPoints& feature : all) feature.points = roughened(feature.points, roughness);
    return all;
}

/// Over 10 nm to both sides: form deviations bend within the steps that suit other quantities, and at 0.1 µm
/// another point may be the highest.
Eigen::MatrixXd differences_of(const MeasurementModel& model) {
    constexpr double h = 1e-8;
    std::vector<double> x = estimates(model), high(model.outputs().size()), low(high);
    Eigen::MatrixXd D(Eigen::Index(high.size()), Eigen::Index(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double at = x[i];
        x[i] = at + h;
        const double above = x[i];
        EXPECT_TRUE(model.evaluate(x, high));
        x[i] = at - h;
        const double below = x[i];
        EXPECT_TRUE(model.evaluate(x, low));
        x[i] = at;
        for (std::size_t j = 0; j < high.size(); ++j)
            D(Eigen::Index(j), Eigen::Index(i)) = (high[j] - low[j]) / (above - below);
    }
    return D;
}

// Curvature counts where points are far from their form: first order must be that of the solution.
TEST(GeometryFromPoints, DerivativesAreThoseOfTheSolution) {
    for (const double roughness : {0.02, 1.0}) {
        const auto model = made(setup_of(all_forms(roughness)));
        const Eigen::MatrixXd differences = differences_of(*model);
        Eigen::MatrixXd exact;
        ASSERT_TRUE(model->jacobian(estimates(*model), exact));
        for (Eigen::Index j = 0; j < exact.rows(); ++j) {
            const OutputQuantity& output = model->outputs()[std::size_t(j)];
            EXPECT_LT((exact.row(j) - differences.row(j)).cwiseAbs().maxCoeff(),
                      2e-6 * exact.row(j).cwiseAbs().maxCoeff())
                << output.group << "." << output.symbol << " " << roughness;
        }
    }
}

TEST(GeometryFromPoints, MonteCarloAgreesWithTheLawOfPropagation) {
    const auto model = made(setup_of(all_forms(0.5), 1e-4));
    EvaluationOptions options;
    options.trials = 100'000;
    const UncertaintyResult result = evaluate(*model, model->inputs(), options).value();
    EXPECT_EQ(result.failed_trials, 0u);
    for (const OutputResult& y : result.outputs)
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty, y.first_order.standard_uncertainty,
                    4.0 * y.monte_carlo->standard_error_of_uncertainty)
            << y.quantity.group << "." << y.quantity.symbol;
}

const OutputResult& output(const UncertaintyResult& result, const std::string& group,
                           const std::string& symbol) {
    for (const OutputResult& y : result.outputs)
        if (y.quantity.group == group && y.quantity.symbol == symbol) return y;
    throw std::runtime_error("no output " + group + "." + symbol);
}

TEST(GeometryFromPoints, ACapOf45DegreesCorrelatesDiameterAndHeight) {
    const Frame f{Eigen::Matrix3d::Identity(), {10.0, 20.0, 30.0}};
    Problems problems;
    const auto model = model_of(setup_of({{"S", "sphere", sphere_cap(f, 20.0, 0.785, 0.002)}}), problems);
    ASSERT_TRUE(model);
    const double r = column(*model, "condition", "correlation").at(0);
    EXPECT_LT(r, -0.98);
    Eigen::MatrixXd J;
    ASSERT_TRUE(model->jacobian(estimates(*model), J));
    const double z_d = J.row(2).dot(J.row(3)) / (J.row(2).norm() * J.row(3).norm());
    EXPECT_NEAR(z_d, r, 1e-4);
    Problems of_narrow;
    model_of(setup_of({{"S", "sphere", sphere_cap(f, 20.0, 0.3, 0.002)}}), of_narrow);
    ASSERT_EQ(of_narrow.items().size(), 1u);
    EXPECT_NE(of_narrow.items()[0].message.english().find("correlates with the place"), std::string::npos);
}

TEST(GeometryFromPoints, ACommonDeviationMovesPlacesAndNothingElse) {
    covaria::Setup setup = setup_of({{"P", "plane", pla25}, {"Z", "cylinder", cyl24}}, 0.0);
    setup.values["u_common_x"] = Quantity{0.2, Unit::of("mm")};
    const auto model = made(setup);
    EvaluationOptions options;
    options.method = Method::first_order;
    const UncertaintyResult result = evaluate(*model, model->inputs(), options).value();
    EXPECT_NEAR(output(result, "P", "x").first_order.standard_uncertainty, 2e-4, 1e-12);
    EXPECT_NEAR(output(result, "Z", "x").first_order.standard_uncertainty, 2e-4, 1e-9);
    for (const char* symbol : {"n_x", "n_y", "n_z", "f_t", "f_q"}) {
        EXPECT_LT(output(result, "P", symbol).first_order.standard_uncertainty, 1e-10) << symbol;
        EXPECT_LT(output(result, "Z", symbol).first_order.standard_uncertainty, 1e-10) << symbol;
    }
    EXPECT_LT(output(result, "Z", "d").first_order.standard_uncertainty, 1e-12);
}

// The offset of a plane has u^2 = sum of squares of the normal's components over m, whatever C is.
TEST(GeometryFromPoints, CorrelatedCoordinatesCountAlongTheNormal) {
    covaria::Setup setup = setup_of({{"P", "plane", pla25}}, 0.01);
    auto& rows = std::get<SetupTable>(setup.values["points"]).rows;
    for (auto& row : rows) row[8] = 0.9;
    const auto model = made(setup);
    EvaluationOptions options;
    options.method = Method::first_order;
    const UncertaintyResult result = evaluate(*model, model->inputs(), options).value();
    EXPECT_NEAR(output(result, "P", "x").first_order.standard_uncertainty, 1e-5 / std::sqrt(6.0), 1e-12);
    const auto independent = made(setup_of({{"P", "plane", pla25}}, 0.01));
    const UncertaintyResult other = evaluate(*independent, independent->inputs(), options).value();
    // n_x and n_y differ in sign: deviations of x and y that go together tilt it less
    EXPECT_LT(output(result, "P", "n_z").first_order.standard_uncertainty,
              output(other, "P", "n_z").first_order.standard_uncertainty);
}

TEST(GeometryFromPoints, TheScatterGivesItsDegreesOfFreedom) {
    covaria::Setup setup = setup_of({{"Z", "cylinder", cyl24}});
    setup.values["point_uncertainty"] = std::string("scatter");
    const auto model = made(setup);
    EvaluationOptions options;
    options.method = Method::first_order;
    const UncertaintyResult result = evaluate(*model, model->inputs(), options).value();
    const OutputResult& d = output(result, "Z", "d");
    EXPECT_NEAR(d.first_order.effective_degrees_of_freedom, 37.0, 1e-6);
    EXPECT_NEAR(1e3 * d.first_order.standard_uncertainty, 0.3088007 * 0.00335679673, 1e-7);
}

TEST(GeometryFromPoints, ReversedTurnsTheDirection) {
    const Results r = results_of(*made(setup_of({{"P", "plane", pla25, true}})));
    expect_near(direction_in(r, "P"),
                {-0.94053335499333179607, 0.20929606987242093331, -0.2675671192073981387}, 1e-14);
}

TEST(GeometryFromPoints, ExactPointsHaveNoFormDeviation) {
    const Frame f = frame_number(2, 1000.0);
    const Results r = results_of(*made(setup_of({{"S", "sphere", sphere_cap(f, 25.0, 1.0, 0.0)}})));
    EXPECT_FALSE(r.contains("S.f_t"));
    EXPECT_NEAR(1e3 * r.at("S.d"), 50.0, 1e-9);
}

TEST(GeometryFromPoints, RefusesWhatDeterminesNothing) {
    const Points straight{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {4, 4, 4}, {5, 5, 5}, {6, 6, 6}, {9, 9, 9}};
    for (const char* form : {"plane", "circle", "sphere", "cylinder", "cone"})
        EXPECT_NE(first_error(setup_of({{"F", form, straight}})).find("straight line"), std::string::npos)
            << form;
    Points flat;
    for (int j = 0; j < 9; ++j) flat.push_back({std::cos(j * 1.0), std::sin(j * 2.0), 5.0});
    EXPECT_NE(first_error(setup_of({{"F", "sphere", flat}})).find("lie on a plane"), std::string::npos);
    EXPECT_NE(first_error(setup_of({{"F", "plane", {flat[0], flat[1]}}})).find("needs 3"), std::string::npos);
    EXPECT_NE(first_error(setup_of({{"F", "line", {flat[0], flat[0]}}})).find("the same"), std::string::npos);
    covaria::Setup setup = setup_of({{"F", "plane", flat}});
    std::get<SetupTable>(setup.values["points"]).rows[3][0] = std::string("G");
    EXPECT_NE(first_error(setup).find("no feature 'G'"), std::string::npos);
    setup = setup_of({{"F", "plane", flat}, {"F", "plane", flat}});
    EXPECT_NE(first_error(setup).find("two features"), std::string::npos);
    setup = setup_of({{"F", "plane", {flat[0], flat[1], flat[3]}}});
    setup.values["point_uncertainty"] = std::string("scatter");
    EXPECT_NE(first_error(setup).find("do not scatter"), std::string::npos);
}

// Units from a file may be anything.
TEST(GeometryFromPoints, ScaleDoesNotMatter) {
    for (const double scale : {1e-60, 1e-9, 1e9, 1e60}) {
        Points points = cyl24;
        for (Vector3d& p : points) p *= scale;
        const Results r = results_of(*made(setup_of({{"Z", "cylinder", points}})));
        EXPECT_NEAR(1e3 * r.at("Z.d") / scale, 3.2877492601002778271, 1e-12) << scale;
    }
}

}  // namespace
}  // namespace covaria::geometry_test
