// Networks of slope distances alone, which nobody gave an approximate coordinate: stations, targets, and some
// of both whose places are known.
#include <random>

#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network {
namespace {

struct Size {
    std::size_t stations, targets, known;
    double missing = 0.0;  ///< share of the distances that were not read, but from the first four stations
};

StatedAdjustment multilateration(const Size& size, std::uint64_t seed) {
    constexpr auto fixed = CoordinateRole::fixed;
    constexpr double u = 1e-3;  // m
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::normal_distribution<double> normal;
    std::vector<Eigen::Vector3d> places;
    StatedAdjustment stated;
    for (std::size_t p = 0; p < size.stations + size.targets; ++p) {
        places.emplace_back(20.0 * unit(engine), 20.0 * unit(engine), 6.0 * unit(engine));
        const CoordinateRole role = size.known == 0 ? CoordinateRole::datum : CoordinateRole::unknown;
        stated.points.push_back({.name = (p < size.stations ? "S" : "P") + std::to_string(p),
                                 .p = {},
                                 .plane = role,
                                 .height = role,
                                 .u = {}});
    }
    for (std::size_t left = size.known; left > 0;) {
        const std::size_t p = engine() % places.size();
        if (stated.points[p].plane == fixed) continue;
        stated.points[p].plane = stated.points[p].height = fixed;
        for (std::size_t c = 0; c < 3; ++c) stated.points[p].p[c] = places[p][static_cast<Eigen::Index>(c)];
        --left;
    }
    for (std::size_t s = 0; s < size.stations; ++s)
        for (std::size_t t = size.stations; t < places.size(); ++t)
            if (0.5 * (1.0 + unit(engine)) >= size.missing || s < 4)
                stated.readings.push_back({.kind = ReadingKind::slope_distance,
                                           .from = stated.points[s].name,
                                           .to = stated.points[t].name,
                                           .length = (places[t] - places[s]).norm() + u * normal(engine),
                                           .u_length = u});
    return stated;
}

bool agrees(const Adjusted& made) {
    if (!made.network || !made.network->adjusted) return false;
    const adjustment::Reliability& found = made.network->reliability;
    return found.sum_of_squares < found.degrees_of_freedom + 6.0 * std::sqrt(2.0 * found.degrees_of_freedom);
}

TEST(DistancesAlone, AreEnoughForThePlacesOfStationsAndTargets) {
    constexpr int seeds = 20;
    int found = 0, all = 0;
    for (const Size& size :
         {Size{4, 8, 0}, Size{5, 6, 0}, Size{6, 12, 0, 0.1}, Size{4, 8, 3}, Size{5, 10, 3, 0.05},
          Size{4, 7, 4}, Size{6, 10, 4, 0.1}, Size{5, 12, 5}, Size{8, 30, 6, 0.15}, Size{8, 30, 0, 0.15}})
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const Adjusted made(multilateration(size, 1000 * size.stations + seed));
            ++all;
            if (agrees(made))
                ++found;
            else
                std::cout << size.stations << " x " << size.targets << ", " << size.known << " known, seed "
                          << seed << ": " << made.words();
        }
    EXPECT_GE(found, all - all / 100) << "of " << all;
}

/// Four known points in a plane, and one whose distances from them were read, so many m above it.
StatedAdjustment over_a_plane(double above, std::optional<std::array<double, 3>> approximate, double error) {
    TrueNetwork net;
    for (const auto& [name, x, y] : {std::tuple("A", 0.0, 0.0), std::tuple("B", 9.0, 0.0),
                                     std::tuple("C", 8.0, 7.0), std::tuple("D", 1.0, 8.0)})
        net.point(name, {x, y, 1.0}, CoordinateRole::fixed, CoordinateRole::fixed, 0.0);
    net.point("P", {4.0, 3.0, 1.0 + above}, CoordinateRole::unknown, CoordinateRole::unknown, {});
    for (const char* from : {"A", "B", "C", "D"}) net.read(ReadingKind::slope_distance, from, "P");
    if (approximate)
        for (std::size_t c = 0; c < 3; ++c) net.called("P").p[c] = (*approximate)[c];
    for (StatedAdjustment::Reading& r : net.stated.readings) *r.length += error;
    return net.stated;
}

double height_of(const Adjusted& made) {
    EXPECT_TRUE(made.network && made.network->adjusted) << made.words();
    return made.network ? made.network->position(4).z() : 0.0;
}

TEST(DistancesAlone, SayThatAPointMayBeOnTheOtherSideOfAPlane) {
    const std::string said =
        "the distances fit as well with P on the other side of the plane of A, B, C, D, at (4, ";
    const Adjusted alone(over_a_plane(1.5, {}, 0.0));
    EXPECT_NEAR(std::abs(height_of(alone) - 1.0), 1.5, 5e-3);
    EXPECT_NE(alone.words().find(said), std::string::npos) << alone.words();
    const Adjusted above(over_a_plane(1.5, {{4.2, 2.9, 2.0}}, 0.0)),
        below(over_a_plane(1.5, {{4.2, 2.9, -0.2}}, 0.0));
    EXPECT_NEAR(height_of(above), 2.5, 5e-3);
    EXPECT_NEAR(height_of(below), -0.5, 5e-3);
    EXPECT_EQ(above.words() + below.words(), "");
    const Adjusted flat(over_a_plane(1.5, {{4.2, 2.9, 1.0}}, 0.0));  // a height that tells no side
    EXPECT_NEAR(std::abs(height_of(flat) - 1.0), 1.5, 5e-3);
    EXPECT_NE(flat.words().find(said), std::string::npos) << flat.words();
    StatedAdjustment by_height = over_a_plane(1.5, {}, 0.0);
    by_height.points[4].p[2] = -1.5;
    const Adjusted told(by_height);
    EXPECT_NEAR(height_of(told), -0.5, 5e-3);
    EXPECT_EQ(told.words(), "");
}

/// Whether P's height over the plane is more than a few times its u.
bool is_clear_of_the_plane(const Adjusted& made) {
    if (!made.network || !made.network->adjusted) return false;
    const std::size_t k = made.network->unknown_of[made.network->at(4, 2)];
    return std::abs(height_of(made) - 1.0) > 3.0 * std::sqrt(made.network->adjusted->cofactor(k, k));
}

TEST(DistancesAlone, SayThatAPointNextToAPlaneHardlyHasAHeight) {
    using Place = std::array<double, 3>;
    for (const double error : {-2e-3, -5e-4, 0.0, 5e-4, 2e-3})
        for (const double above : {0.0, 1e-3, 0.01, 0.03})
            for (const auto& approximate : {std::optional<Place>(), std::optional(Place{4.0, 3.0, 1.0}),
                                            std::optional(Place{4.1, 2.9, 1.2})}) {
                const Adjusted made(over_a_plane(above, approximate, error));
                const std::string said = made.words();
                EXPECT_TRUE(
                    is_clear_of_the_plane(made) ||
                    said.find("nothing tells the height of P") != std::string::npos ||
                    said.find("P lies so near to the plane of A, B, C, D that the distances hardly tell") !=
                        std::string::npos)
                    << above << " m, " << error << ": " << said;
                EXPECT_TRUE(error > 0.0 || !is_clear_of_the_plane(made)) << above << " m, " << error;
            }
}

TEST(DistancesAlone, SayThatANetworkOverThreeKnownPointsMayBeMirrored) {
    const Adjusted three(multilateration({5, 10, 3}, 7)), none(multilateration({5, 10, 0}, 7)),
        four(multilateration({5, 10, 4}, 7));
    EXPECT_TRUE(agrees(three) && agrees(none) && agrees(four));
    EXPECT_NE(three.words().find("are mirrored in the plane of"), std::string::npos) << three.words();
    EXPECT_NE(none.words().find("do not tell the network of S0, S1, S2, S3, … from its mirror image"),
              std::string::npos)
        << none.words();
    EXPECT_EQ(four.words(), "");
}

}  // namespace
}  // namespace covaria::network
