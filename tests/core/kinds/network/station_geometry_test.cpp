// Where a station stands, and what its coordinates do to what it sees.
#include <gtest/gtest.h>

#include "core/kinds/instruments/sensor.h"
#include "core/math/dual.h"

namespace covaria {
namespace {

/// d(R' (p − o))/d(coordinates of the station), by dual numbers.
Eigen::Matrix<double, 3, 6> exact_effect(const Station& station, const Eigen::Vector3d& p) {
    std::array<Dual, 6> at;
    for (std::size_t i = 0; i < 6; ++i) at[i] = Dual::variable(station.coordinates[i], i);
    const Vector3<Dual> seen =
        station_rotation<Dual>(station.angles, Vector3<Dual>(at[3], at[4], at[5])).transpose() *
        (p.cast<Dual>() - Vector3<Dual>(at[0], at[1], at[2]));
    Eigen::Matrix<double, 3, 6> effect;
    for (int row = 0; row < 3; ++row)
        for (std::size_t i = 0; i < 6; ++i) effect(row, static_cast<int>(i)) = seen[row].partials()[i];
    return effect;
}

TEST(StationGeometry, TheEffectOfAStationIsExactInBothConventionsOfItsAngles) {
    const Eigen::Vector3d p(4.2, -1.7, 0.9);
    for (const StationAngles angles : {StationAngles::zyx, StationAngles::xyz}) {
        const Station station{{-3.0, 2.6, 0.4, 0.3, -0.8, 2.1}, angles};
        const Eigen::Matrix<double, 3, 6> effect = StationGeometry(station).effect_on(p);
        EXPECT_LT((effect - exact_effect(station, p)).cwiseAbs().maxCoeff(), 1e-14);
    }
}

}  // namespace
}  // namespace covaria
