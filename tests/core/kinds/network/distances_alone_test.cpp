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

}  // namespace
}  // namespace covaria::network
