// Coordinates in frames whose pose nobody stated, with and without their scale; points on planes and lines.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network::own_frame_test {
namespace {

constexpr auto found_one = CoordinateRole::unknown, held_one = CoordinateRole::fixed,
               datum_one = CoordinateRole::datum, no_one = CoordinateRole::none;
constexpr double u = 1e-3;

struct Pose {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double scale = 1.0;
};
Pose turned(double x, double y, double z, const Eigen::Vector3d& origin, double scale = 1.0) {
    return {(Eigen::AngleAxisd(z, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(y, Eigen::Vector3d::UnitY()) *
             Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX()))
                .toRotationMatrix(),
            origin, scale};
}

/// Reads points in a frame, with deviations of a fixed sequence.
void read_in(TrueNetwork& net, const std::string& frame, const Pose& pose,
             const std::vector<std::string>& points, double deviation = 0.0) {
    static int count = 0;
    for (const std::string& name : points) {
        const Eigen::Vector3d l = pose.scale * pose.axes.transpose() * (net.places.at(name) - pose.origin);
        for (const auto& [kind, axis] :
             {std::pair(ReadingKind::frame_x, 0), std::pair(ReadingKind::frame_y, 1),
              std::pair(ReadingKind::frame_z, 2)})
            net.stated.readings.push_back({.kind = kind,
                                           .from = name,
                                           .frame = frame,
                                           .length = l[axis] + deviation * std::sin(7.7 * ++count),
                                           .u_length = u});
    }
}

const std::vector<std::pair<std::string, Eigen::Vector3d>> five{{"A", {0.0, 0.0, 0.2}},
                                                                {"B", {3.0, 0.4, 0.0}},
                                                                {"C", {2.6, 2.5, 1.9}},
                                                                {"D", {-0.5, 2.0, 0.7}},
                                                                {"E", {1.1, 1.0, 2.4}}};
std::vector<std::string> names_of_five() {
    return {"A", "B", "C", "D", "E"};
}
TrueNetwork with_five(CoordinateRole role, std::optional<double> approximate) {
    TrueNetwork net;
    for (const auto& [name, at] : five) net.point(name, at, role, role, approximate);
    return net;
}

double u_of(const AdjustedNetwork& network, std::size_t place) {
    const auto k = static_cast<Eigen::Index>(network.unknown_of[place]);
    const auto n = static_cast<Eigen::Index>(network.place_of.size());
    return std::sqrt(network.adjusted->cofactors(Eigen::VectorXd::Unit(n, k))[k]);
}

double distance(const Adjusted& made, std::size_t a, std::size_t b) {
    return (made.network->position(a) - made.network->position(b)).norm();
}

// The closed form of S. Umeyama (IEEE Trans. PAMI 13 (1991) 376) is of the same least squares.
TEST(OwnFrame, PoseAndScaleOfKnownPointsAreThoseOfTheClosedForm) {
    for (const double steep : {0.4, 1.5707}) {
        TrueNetwork net = with_five(held_one, 0.0);
        read_in(net, "F", turned(0.3, steep, -2.0, {1.0, 2.0, 3.0}, 1.001), names_of_five(), 2e-3);
        net.stated.frames = {{.name = "F", .scale = FigureKnowledge::unknown}};
        const Adjusted made(net.stated);
        ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
        Eigen::Matrix<double, 3, 5> there, here;
        for (Eigen::Index i = 0; i < 5; ++i) {
            here.col(i) = five[static_cast<std::size_t>(i)].second;
            for (Eigen::Index c = 0; c < 3; ++c)
                there(c, i) = *net.stated.readings[static_cast<std::size_t>(3 * i + c)].length;
        }
        const Eigen::Matrix4d closed = Eigen::umeyama(here, there, true);
        const Eigen::Matrix<double, 3, 5> rest = there - (closed * here.colwise().homogeneous()).topRows<3>();
        const adjustment::Reliability& found = reliability_of(*made.network);
        EXPECT_NEAR(found.sum_of_squares, rest.squaredNorm() / (u * u), 1e-6);
        EXPECT_EQ(found.degrees_of_freedom, 15 - 7);
        const double scale = std::cbrt(closed.topLeftCorner<3, 3>().determinant());
        EXPECT_NEAR(made.network->state[static_cast<Eigen::Index>(made.network->frame(0, 6))], scale - 1.0,
                    1e-9);
        const Eigen::Vector3d origin =
            closed.topLeftCorner<3, 3>().inverse() * -closed.topRightCorner<3, 1>();
        EXPECT_LT(
            (made.network->state.segment<3>(static_cast<Eigen::Index>(made.network->frame(0, 0))) - origin)
                .norm(),
            1e-9);
        const Eigen::Vector3d middle = here.rowwise().mean();
        EXPECT_NEAR(u_of(*made.network, made.network->frame(0, 6)) * (here.colwise() - middle).norm(), u,
                    1e-8);
    }
}

// The uncertainty of a point that the frame alone tells has three parts: its own u, that of the centroid, and
// that of the turns by its arm.
TEST(OwnFrame, APointReadInItHasTheUncertaintyOfItsPoseToo) {
    TrueNetwork net = with_five(held_one, 0.0);
    net.point("P", {4.0, 3.0, 1.0}, found_one, found_one, {});
    std::vector<std::string> all = names_of_five();
    all.insert(all.begin(), "P");
    read_in(net, "F", turned(0.3, -0.4, 2.0, {1.0, 2.0, 3.0}), all);
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_LT((made.network->position(5) - net.places.at("P")).norm(), 1e-10);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& [name, at] : five) middle += 0.2 * at;
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (const auto& [name, at] : five) {
        const Eigen::Vector3d q = at - middle;
        inertia += q.squaredNorm() * Eigen::Matrix3d::Identity() - q * q.transpose();
    }
    const Eigen::Vector3d r = net.places.at("P") - middle;
    Eigen::Matrix3d cross;
    cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    const Eigen::Matrix3d Q =
        1.2 * Eigen::Matrix3d::Identity() + cross * inertia.inverse() * cross.transpose();
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(u_of(*made.network, made.network->at(5, c)),
                    u * std::sqrt(Q(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(c))), 1e-9);
}

// Nothing is approximate: the frames place each other, one after the other, and a bar tells their scale.
TEST(OwnFrame, FramesAloneAreANetworkAndABarTellsTheirScale) {
    TrueNetwork net = with_five(datum_one, {});
    net.point("P", {4.0, 3.0, 1.0}, found_one, found_one, {});
    net.point("Q", {-2.0, 3.0, 0.4}, found_one, found_one, {});
    read_in(net, "small", turned(3.0, 1.5, 1.0, {9.0, 2.0, 3.0}, 1.02), {"Q", "D", "E", "P"});
    read_in(net, "large", turned(0.1, 0.2, 0.3, {1.0, 2.0, 3.0}, 0.98), names_of_five());
    read_in(net, "third", turned(-2.0, -1.5, 0.3, {1.0, 2.0, 3.0}, 1.0), {"P", "A", "E", "C", "Q"});
    for (const char* name : {"small", "large", "third"})
        net.stated.frames.push_back({.name = name, .scale = FigureKnowledge::unknown});
    const Adjusted open(net.stated);
    ASSERT_TRUE(open.network && open.network->adjusted) << open.words();
    EXPECT_EQ(open.network->adjusted->defect(), 7U) << "the datum takes the scale too";
    net.deviations = 0.0;
    net.read(ReadingKind::slope_distance, "A", "B");
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(made.network->adjusted->defect(), 6U);
    EXPECT_NEAR(distance(made, 5, 6), (net.places.at("P") - net.places.at("Q")).norm(), 1e-9);
    EXPECT_LT(reliability_of(*made.network).sum_of_squares, 1e-9);
}

TEST(OwnFrame, AnArmAndATotalStationAreOneNetwork) {
    TrueNetwork net = hall(held_one, {});
    net.deviations = 0.0;
    net.point("K", {9.0, 6.0, 1.0}, found_one, found_one, {});
    net.point("L", {10.0, 5.0, 1.4}, found_one, found_one, {});
    read_in(net, "arm", turned(1.0, 0.7, 0.3, {8.0, 6.0, 1.0}), {"K", "L", "P", "Q", "B"});
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(made.words(), "");
    for (const char* name : {"K", "L"})
        for (std::size_t p = 0; p < made.network->points.size(); ++p)
            if (made.network->points[p].name == name) {
                EXPECT_LT((made.network->position(p) - net.places.at(name)).norm(), 4e-3);
            }
}

TEST(OwnFrame, ScalesAndTiltsWithPriorsOfNoOrAllKnowledgeAreUnknownOrFixed) {
    TrueNetwork net = with_five(held_one, 0.0);
    read_in(net, "F", turned(1e-4, -2e-4, 2.0, {1.0, 2.0, 3.0}, 1.0005), names_of_five(), 1e-3);
    const auto with = [&](FigureKnowledge scale, std::optional<double> u_ratio,
                          std::optional<double> u_tilt) {
        net.stated.frames = {
            {.name = "F", .scale = scale, .ratio = 1e-4, .u_ratio = u_ratio, .u_tilt = u_tilt}};
        return Adjusted(net.stated);
    };
    const Adjusted none = with(FigureKnowledge::unknown, {}, {}),
                   large = with(FigureKnowledge::stated, 1e6, 1e6),
                   small = with(FigureKnowledge::stated, 1e-12, {}),
                   held = with(FigureKnowledge::fixed, {}, {}),
                   level = with(FigureKnowledge::fixed, {}, 1e-9);
    for (const Adjusted* made : {&none, &large, &small, &held, &level})
        ASSERT_TRUE(made->network && made->network->adjusted) << made->words();
    EXPECT_LT((none.network->state - large.network->state).norm(), 1e-9);
    EXPECT_LT((held.network->state - small.network->state).norm(), 1e-9);
    EXPECT_NEAR(held.network->state[static_cast<Eigen::Index>(held.network->frame(0, 6))], 1e-4, 1e-15);
    EXPECT_LT(std::abs(level.network->state[static_cast<Eigen::Index>(level.network->frame(0, 3))]), 1e-9);
    EXPECT_GT(std::abs(held.network->state[static_cast<Eigen::Index>(held.network->frame(0, 3))]), 1e-6);
}

TEST(OwnFrame, APlaneNetworkHasFlatFrames) {
    TrueNetwork net;
    for (const auto& [name, at] : five) net.point(name, {at.x(), at.y(), 0.0}, held_one, no_one, 0.0);
    net.point("P", {5.0, 2.0, 0.0}, found_one, no_one, {});
    std::vector<std::string> all = names_of_five();
    all.push_back("P");
    read_in(net, "F", turned(0.0, 0.0, 2.0, {1.0, 2.0, 0.0}), all);
    std::erase_if(net.stated.readings, [](const auto& r) { return r.kind == ReadingKind::frame_z; });
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(reliability_of(*made.network).degrees_of_freedom, 12 - 5);
    EXPECT_LT((made.network->position(5) - net.places.at("P")).head<2>().norm(), 1e-10);
}

TEST(OwnFrame, TooFewPointsAreSaidByTheNameOfTheFrame) {
    TrueNetwork net = with_five(held_one, 0.0);
    read_in(net, "F", turned(0.2, 0.1, 2.0, {1.0, 2.0, 3.0}), {"A", "B"});
    const Adjusted made(net.stated);
    EXPECT_NE(made.words().find("nothing tells how frame F lies"), std::string::npos) << made.words();
}

TEST(OwnFrame, AFrameWithoutADatumMovesAsAWhole) {
    TrueNetwork net = with_five(found_one, {});
    read_in(net, "F", turned(0.2, 0.1, 2.0, {1.0, 2.0, 3.0}), names_of_five());
    const Adjusted made(net.stated);
    for (const char* words : {"nothing tells where the whole network is along x", "may tilt about x",
                              "may turn about the vertical", "nothing tells the height of the whole network"})
        EXPECT_NE(made.words().find(words), std::string::npos) << words << ":\n" << made.words();
    EXPECT_EQ(made.words().find("scale"), std::string::npos) << made.words();
}

Eigen::Vector3d scatter_of_five() {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& [name, at] : five) middle += 0.2 * at;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& [name, at] : five) scatter += (at - middle) * (at - middle).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues();
}

// The least sum of squared distances from the plane and the line follows from principal components.
TEST(OwnFrame, PlanesAndLinesOfKnownPointsFitBest) {
    for (const FrameShape shape : {FrameShape::plane, FrameShape::line}) {
        TrueNetwork net = with_five(held_one, 0.0);
        const bool plane = shape == FrameShape::plane;
        for (const std::string& name : names_of_five())
            for (const ReadingKind kind : {ReadingKind::frame_y, ReadingKind::frame_z})
                if (!plane || kind == ReadingKind::frame_z)
                    net.stated.readings.push_back(
                        {.kind = kind, .from = name, .frame = "F", .length = 0.0, .u_length = 0.5});
        net.stated.frames = {{.name = "F", .shape = shape}};
        const Adjusted made(net.stated);
        ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
        const Eigen::Vector3d scatter = scatter_of_five();
        const double sum = plane ? scatter[0] : scatter[0] + scatter[1];
        EXPECT_NEAR(reliability_of(*made.network).sum_of_squares, sum / 0.25, 1e-9);
        EXPECT_EQ(reliability_of(*made.network).degrees_of_freedom, plane ? 5 - 3 : 10 - 4);
    }
}

// The height of the target is told by its plane alone.
TEST(OwnFrame, APlaneTellsWhatIsMissing) {
    TrueNetwork net;
    for (const auto& [name, x, y] :
         {std::tuple("A", 0.0, 0.0), std::tuple("B", 4.0, 0.0), std::tuple("C", 0.0, 3.0)})
        net.point(name, {x, y, 1.0 + 0.1 * x - 0.2 * y}, held_one, held_one, 0.0);
    net.point("P", {2.0, 2.5, 1.0 + 0.2 - 0.5}, held_one, found_one, 0.0);
    net.called("P").p[2] = {};
    for (const char* name : {"A", "B", "C", "P"})
        net.stated.readings.push_back(
            {.kind = ReadingKind::frame_z, .from = name, .frame = "floor", .length = 0.0, .u_length = u});
    net.stated.frames = {{.name = "floor", .shape = FrameShape::plane}};
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_NEAR(made.network->position(3).z(), 0.7, 1e-9);
}

TEST(OwnFrame, DerivativesAreThoseOfThePrediction) {
    TrueNetwork net = with_five(found_one, 0.0);
    read_in(net, "F", turned(0.2, 1.4, 2.0, {1.0, 2.0, 3.0}), names_of_five());
    net.stated.readings.push_back(
        {.kind = ReadingKind::frame_z, .from = "A", .frame = "E", .length = 0.1, .u_length = u});
    net.stated.frames = {{.name = "E", .shape = FrameShape::plane}};
    Problems problems;
    std::optional<AdjustedNetwork> network = adjusted_network(net.stated, problems);
    ASSERT_TRUE(network);
    find_start(*network, problems);
    for (std::size_t f = 0; f < 2; ++f)
        for (std::size_t k = 0; k < 7; ++k)
            network->state[static_cast<Eigen::Index>(network->frame(f, k))] += 0.1 + 0.02 * double(k);
    StateTerms terms;
    for (const AdjustedReading& reading : network->readings) {
        derivatives(*network, reading, network->state.data(), terms);
        Eigen::VectorXd by = Eigen::VectorXd::Zero(network->state.size());
        for (const StateTerm& term : terms) by[static_cast<Eigen::Index>(term.place)] += term.coefficient;
        for (Eigen::Index place = 0; place < by.size(); ++place) {
            constexpr double h = 1e-5;
            Eigen::VectorXd up = network->state, down = network->state;
            up[place] += h, down[place] -= h;
            const double slope =
                (predicted(*network, reading, up.data()) - predicted(*network, reading, down.data())) /
                (2.0 * h);
            EXPECT_NEAR(by[place], slope, 1e-8 * std::max(1.0, std::abs(slope)))
                << words_of(*network, reading).english() << ", place " << place;
        }
    }
}

}  // namespace
}  // namespace covaria::network::own_frame_test
