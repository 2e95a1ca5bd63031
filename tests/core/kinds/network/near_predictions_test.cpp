// Residuals of trials near the estimates, against the whole predictions.
#include "core/kinds/network/near_predictions.h"

#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network::near_predictions_test {
namespace {

void expect_whole_residuals(const StatedAdjustment& stated, double size) {
    const Adjusted made(stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const AdjustedNetwork& network = *made.network;
    const NearPredictions near(network);
    std::vector<double> x, begun, residuals, moved(static_cast<std::size_t>(network.state.size())), state;
    double next = 0.3;
    const auto draw = [&] { return (next = std::fmod(next * 997.13 + 0.317, 1.0)) - 0.5; };
    for (const AdjustedReading& r : network.readings) x.push_back(r.value + size * draw());
    for (std::size_t k = 0; k < moved.size(); ++k) {
        if (network.unknown_of[k] != AdjustedNetwork::known) moved[k] = size * draw();
        state.push_back(network.state[static_cast<Eigen::Index>(k)] + moved[k]);
    }
    near.at_estimates(x, begun);
    near.at_state(x, begun, state, moved, residuals);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const AdjustedReading& r = network.readings[i];
        EXPECT_NEAR(begun[i], residual_of(network, r, x[i], network.state.data()), 1e-13)
            << words_of(network, r).english();
        EXPECT_NEAR(residuals[i], residual_of(network, r, x[i], state.data()), 1e-13 + 1e-12 * size)
            << words_of(network, r).english();
    }
}

// Moves of a micrometre take series, those of metres arctangents; both senses, tilts and heights of targets.
TEST(NearPredictions, AreThePredictionsNearAndFar) {
    for (const double size : {1e-6, 1e-3, 2.0})
        for (const bool clockwise : {false, true}) {
            StatedAdjustment stated = hall(CoordinateRole::fixed, {}).stated;
            stated.clockwise = clockwise;
            if (clockwise)
                for (StatedAdjustment::Reading& r : stated.readings)
                    if (r.kind == ReadingKind::direction) r.angle = -*r.angle;
            for (StatedAdjustment::Reading& r : stated.readings)
                if (r.kind == ReadingKind::zenith_angle && r.to == "P") r.height_to = 1e-4;
            stated.readings.push_back({.kind = ReadingKind::height_difference,
                                       .from = "P",
                                       .to = "Q",
                                       .length = 2.8,
                                       .u_length = 1e-3});
            expect_whole_residuals(stated, size);
            stated.stations = {{.point = "S", .stated = true, .u = 1e-5}};
            expect_whole_residuals(stated, size);
        }
}

}  // namespace
}  // namespace covaria::network::near_predictions_test
