// Residuals of angles against their definition, near the reading and far from it.
#include "core/kinds/network/readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace covaria::network_readings_test {
namespace {

constexpr double pi = std::numbers::pi;

network::Sight sight_of_angles() {
    network::Sight sight;
    sight.has = {false, true, true};
    sight.input = {0, 0, 1};
    return sight;
}

/// A target in the direction (azimuth, elevation), read with an error of both angles.
void expect_errors_back(double azimuth, double elevation, double error) {
    const double distance = 7.3;
    const Vector3<double> X = distance * network::ReadDirections<double>(azimuth, elevation).r;
    const network::Place<double> place{Matrix3<double>::Identity(), Vector3<double>::Zero()};
    const network::View<double> view(place, X);
    const double x[] = {azimuth + error, elevation + error};
    const network::Sight sight = sight_of_angles();
    const network::ReadAngles<double> read(sight, x);
    constexpr double rounding = 1.5e-15;
    EXPECT_NEAR(network::residual<double>(sight, 1, view, x, read), error, rounding / std::cos(elevation))
        << azimuth << ' ' << elevation;
    EXPECT_NEAR(network::residual<double>(sight, 2, view, x, read), error, rounding)
        << azimuth << ' ' << elevation;
    Vector3<Batch> Y;
    for (int c = 0; c < 3; ++c) Y[c] = Batch(X[c]);
    const network::Place<Batch> wide_place{place.R.cast<Batch>(), place.o.cast<Batch>()};
    const network::View<Batch> wide_view(wide_place, Y);
    const Batch wide[] = {Batch(x[0]), Batch(x[1])};
    const network::ReadAngles<Batch> wide_read(sight, wide);
    for (const std::size_t o : {1u, 2u}) {
        const Batch found = network::residual<Batch>(sight, o, wide_view, wide, wide_read);
        EXPECT_NEAR(found.get(0), error, rounding / std::cos(elevation)) << azimuth << ' ' << elevation;
    }
}

TEST(NetworkReadings, ResidualsOfAnglesAreTheErrorsOfTheReadings) {
    const double edge = network::small_angle;
    for (const double azimuth : {-3.1, -1.0, 0.0, 0.7, 3.14})
        for (const double elevation : {-1.2, -0.3, 0.0, 0.9, 1.3})
            for (const double error : {0.0, 1e-9, 3e-5, -1e-3, 0.999 * edge, 1.001 * edge, -0.05, 0.2})
                expect_errors_back(azimuth, elevation, error);
}

TEST(NetworkReadings, TheResidualOfAnElevationKeepsWholeTurns) {
    const network::View<double> view({Matrix3<double>::Identity(), Vector3<double>::Zero()}, {1.0, 0.0, 1.0});
    const double x[] = {0.0, pi / 4 + 2 * pi};
    const network::Sight sight = sight_of_angles();
    const network::ReadAngles<double> read(sight, x);
    EXPECT_NEAR(network::residual<double>(sight, 2, view, x, read), 2 * pi, 1e-14);
}

}  // namespace
}  // namespace covaria::network_readings_test
