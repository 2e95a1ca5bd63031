// Residuals of trials near the estimates, against the whole predictions.
#include "core/kinds/network/near_predictions.h"

#include <xsimd/memory/xsimd_aligned_allocator.hpp>

#include "core/kinds/network/adjusted_trials.h"
#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network::near_predictions_test {
namespace {

void expect_whole_residuals(const StatedAdjustment& stated, double size) {
    const Adjusted made(stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const AdjustedNetwork& network = *made.network;
    const NearPredictions near(network);
    std::vector<double> x, moved(static_cast<std::size_t>(network.state.size())), state;
    double next = 0.3;
    const auto draw = [&] { return (next = std::fmod(next * 997.13 + 0.317, 1.0)) - 0.5; };
    for (const AdjustedReading& r : network.readings) x.push_back(r.value + size * draw());
    for (std::size_t k = 0; k < moved.size(); ++k) {
        if (network.unknown_of[k] != AdjustedNetwork::known) moved[k] = size * draw();
        state.push_back(network.state[static_cast<Eigen::Index>(k)] + moved[k]);
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        const AdjustedReading& r = network.readings[i];
        const double begun = near.at_estimates(i, x[i]);
        EXPECT_NEAR(begun, residual_of(network, r, x[i], network.state.data()), 1e-13)
            << words_of(network, r).english();
        if (!near.is_plain(i)) continue;
        const auto moved_at = [&](std::size_t place) { return moved[place]; };
        EXPECT_NEAR(near.at_state(i, begun, moved_at), residual_of(network, r, x[i], state.data()),
                    1e-13 + 1e-12 * size)
            << words_of(network, r).english();
        const Batch four = near.at_state(i, Batch(begun), [&](std::size_t k) { return Batch(moved[k]); });
        double lanes[Batch::size];
        four.store_unaligned(lanes);
        for (const double lane : lanes)
            EXPECT_NEAR(lane, near.at_state(i, begun, moved_at), 1e-14) << words_of(network, r).english();
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

// Some trials are searched together, the last of a block more than once; readings far off take more steps.
TEST(AdjustedTrials, AreTheSameAloneAndInBlocks) {
    using Numbers = std::vector<double, xsimd::aligned_allocator<double, 64>>;
    StatedAdjustment stated = hall(CoordinateRole::fixed, {}).stated;
    stated.readings.push_back(
        {.kind = ReadingKind::height_difference, .from = "P", .to = "Q", .length = 2.8, .u_length = 1e-3});
    const Adjusted made(stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const AdjustedTrials of_network(*made.network);
    const std::size_t n = made.network->readings.size(), outputs = made.network->outputs();
    for (const std::size_t count : {1U, 8U, 13U, 16U, 21U, 40U}) {
        const std::size_t stride = (count + 7) / 8 * 8;
        Numbers in(n * stride), out(outputs * stride);
        std::vector<std::uint8_t> valid(stride, 0);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t t = 0; t < stride; ++t)
                in[i * stride + t] = made.network->readings[i].value +
                                     (t % 5 == 0 ? 100.0 : 1.0) * made.network->readings[i].u *
                                         std::sin(1.0 + 12.9898 * double(i) + 78.233 * double(t));
        of_network.evaluate(TrialBlock{in.data(), out.data(), valid.data(), stride, count});
        std::vector<double> x(n), y(outputs);
        for (std::size_t t = 0; t < count; ++t) {
            for (std::size_t i = 0; i < n; ++i) x[i] = in[i * stride + t];
            ASSERT_TRUE(of_network.evaluate(x, y));
            EXPECT_EQ(valid[t], 1);
            for (std::size_t j = 0; j < outputs; ++j)
                EXPECT_NEAR(out[j * stride + t], y[j], 1e-13 * std::max(1.0, std::abs(y[j]))) << count;
        }
    }
}

}  // namespace
}  // namespace covaria::network::near_predictions_test
