// Places from distances: of all pairs, between two sets, to held places, with noise.
#include "core/math/points_from_distances.h"

#include <gtest/gtest.h>

#include <random>

namespace covaria {
namespace {

struct Spread {
    std::vector<Eigen::Vector3d> places;
    PointsAndDistances given;
};

/// Points of two sets, so many of them held, with the distances between the sets.
Spread two_sets(std::size_t first, std::size_t second, std::size_t held, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> unit(-10.0, 10.0);
    Spread made;
    for (std::size_t p = 0; p < first + second; ++p) {
        made.places.emplace_back(unit(engine), unit(engine), unit(engine));
        made.given.holds.emplace_back().fill(p < held);
    }
    made.given.places = made.places;
    for (std::size_t a = 0; a < first; ++a)
        for (std::size_t b = first; b < made.places.size(); ++b)
            made.given.distances.push_back({a, b, (made.places[b] - made.places[a]).norm(), 1e-3});
    return made;
}

TEST(PointsFromDistances, AreThoseOfTheDistancesUpToAMoveOfAll) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Spread made = two_sets(6, 8, 0, seed);
        const PointsByDistances found = points_from_distances(made.given);
        EXPECT_LT(found.sum_of_squares, 1e-6) << seed;
        // Within a set too, which nobody measured.
        for (std::size_t a = 0; a < made.places.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_NEAR((found.places[a] - found.places[b]).norm(),
                            (made.places[a] - made.places[b]).norm(), 1e-4)
                    << seed;
    }
}

TEST(PointsFromDistances, KeepWhatIsHeld) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Spread made = two_sets(6, 8, 4, seed);
        const PointsByDistances found = points_from_distances(made.given);
        for (std::size_t p = 0; p < made.places.size(); ++p)
            EXPECT_LT((found.places[p] - made.places[p]).norm(), 1e-4) << seed;
    }
}

TEST(PointsFromDistances, AreTheSameInEveryRun) {
    const Spread made = two_sets(4, 8, 3, 5);
    EXPECT_EQ(points_from_distances(made.given).places, points_from_distances(made.given).places);
}

TEST(PointsFromDistances, NearbyAreThoseOfTheSideThatOneBeginsOn) {
    PointsAndDistances given;
    for (const auto& [x, y] :
         {std::pair(0.0, 0.0), std::pair(9.0, 0.0), std::pair(8.0, 7.0), std::pair(1.0, 8.0)}) {
        given.places.emplace_back(x, y, 0.0);
        given.holds.emplace_back().fill(true);
    }
    const Eigen::Vector3d place(4.0, 3.0, 1.5);
    for (std::size_t p = 0; p < 4; ++p)
        given.distances.push_back({p, 4, (place - given.places[p]).norm(), 1e-3});
    given.holds.emplace_back().fill(false);
    for (const double side : {1.0, -1.0}) {
        given.places.resize(4);
        given.places.emplace_back(5.0, 2.0, 0.5 * side);
        const Eigen::Vector3d found = nearest_by_distances(given).places[4];
        EXPECT_NEAR(found.z(), 1.5 * side, 1e-5);
    }
}

}  // namespace
}  // namespace covaria
