// Datum by single coordinates (3-2-1), and zenith angles that were typed as elevations.
#include <gtest/gtest.h>

#include <numbers>

#include "core/adjustment/adjustment.h"
#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network {
namespace {

/// The hall by two instruments that are not levelled, with nothing known but what the datum needs.
TrueNetwork leaning_hall(CoordinateRole known, std::optional<double> approximate) {
    TrueNetwork net = hall(known, approximate, {{"S", {0.3, -0.2}}, {"T", {-0.1, 0.4}}});
    net.stated.stations = {{"S", false, {}}, {"T", false, {}}};
    return net;
}

/// A has all three of its coordinates, B its y and z, C its z.
TrueNetwork by_three_two_one(std::optional<double> approximate) {
    TrueNetwork net = leaning_hall(CoordinateRole::unknown, approximate);
    using enum CoordinateRole;
    const auto fix = [&](const char* name, CoordinateRole plane, CoordinateRole height,
                         std::initializer_list<std::size_t> axes) {
        StatedAdjustment::Point& point = net.called(name);
        point.plane = plane;
        point.height = height;
        for (const std::size_t c : axes) point.p[c] = net.places[name][static_cast<Eigen::Index>(c)];
    };
    fix("A", fixed, fixed, {0, 1, 2});
    fix("B", y_fixed, fixed, {1, 2});
    fix("C", unknown, fixed, {2});
    return net;
}

double distance(const AdjustedNetwork& network, const char* a, const char* b) {
    const auto place = [&](const std::string& name) {
        for (std::size_t p = 0; p < network.points.size(); ++p)
            if (network.points[p].name == name) return network.position(p);
        throw std::out_of_range(name);
    };
    return (place(a) - place(b)).norm();
}

TEST(Datum, ByThreeTwoAndOneCoordinatesIsThatOfTheFreeNetworkMoved) {
    const Adjusted free(leaning_hall(CoordinateRole::datum, 0.0).stated);
    ASSERT_TRUE(free.network) << free.words();
    for (const double approximate : {0.05, 0.3}) {
        const Adjusted held(by_three_two_one(approximate).stated);
        ASSERT_TRUE(held.network) << held.words();
        EXPECT_EQ(held.network->adjusted->defect(), 0u);
        EXPECT_EQ(held.network->adjusted->degrees_of_freedom(), free.network->adjusted->degrees_of_freedom());
        for (const auto& [a, b] : {std::pair("A", "B"), std::pair("P", "Q"), std::pair("S", "T"),
                                   std::pair("B", "C"), std::pair("D", "Q")})
            EXPECT_NEAR(distance(*held.network, a, b), distance(*free.network, a, b), 1e-9);
        const AdjustedNetwork& network = *held.network;
        EXPECT_EQ(network.points[1].role[0], CoordinateRole::unknown);
        EXPECT_EQ(network.points[1].role[1], CoordinateRole::fixed);
        EXPECT_NEAR(network.position(1).x(), 24.0, 0.02);
        EXPECT_EQ(network.position(1).y(), 1.5);
    }
}

TEST(Elevations, AreZenithAnglesFromTheHorizon) {
    const TrueNetwork zenith = hall(CoordinateRole::fixed, {});
    TrueNetwork elevation = zenith;
    for (std::size_t i = 0; i < elevation.stated.readings.size(); ++i) {
        StatedAdjustment::Reading& reading = elevation.stated.readings[i];
        reading.label = "r" + std::to_string(i);
        if (reading.kind != ReadingKind::zenith_angle) continue;
        reading.kind = StatedAdjustment::Reading::elevation;
        reading.angle = 0.5 * std::numbers::pi - *reading.angle;
    }
    TrueNetwork labelled = zenith;
    for (std::size_t i = 0; i < labelled.stated.readings.size(); ++i)
        labelled.stated.readings[i].label = "r" + std::to_string(i);
    labelled.stated.correlations = {{"r1", "r4", 0.5}, {"r1", "r2", 0.3}};
    elevation.stated.correlations = {{"r1", "r4", 0.5}, {"r1", "r2", -0.3}};
    const Adjusted a(labelled.stated), b(elevation.stated);
    ASSERT_TRUE(a.network && b.network) << a.words() << b.words();
    EXPECT_LT((a.network->state - b.network->state).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_GT((a.network->state - Adjusted(zenith.stated).network->state).cwiseAbs().maxCoeff(), 1e-7)
        << "the correlations count";
}

TEST(Datum, ByThreeTwoAndOneCoordinatesAsksForApproximateOnes) {
    const Adjusted held(by_three_two_one({}).stated);
    EXPECT_FALSE(held.network);
    EXPECT_NE(held.words().find("state approximate coordinates"), std::string::npos) << held.words();
}

}  // namespace
}  // namespace covaria::network
