// Networks that find their own stations: without approximate coordinates, in any order, free and held.
#include "tests/core/kinds/network/adjusted_network.h"

#include <algorithm>

namespace covaria::network {
namespace {

TEST(AdjustedNetwork, PlacesStationsAndTargetsWithoutApproximateCoordinatesInAnyOrder) {
    TrueNetwork net = hall(CoordinateRole::fixed, {});
    const Adjusted first(net.stated);
    ASSERT_TRUE(first.network && first.network->adjusted) << first.words();
    EXPECT_EQ(first.words(), "");
    for (std::size_t p = 0; p < first.network->points.size(); ++p) {
        const Eigen::Vector3d& at = net.places.at(first.network->points[p].name);
        EXPECT_LT((first.network->position(p) - at).norm(), 3e-3) << first.network->points[p].name;
    }
    EXPECT_EQ(first.network->adjusted->degrees_of_freedom(), 39 - 14);
    std::reverse(net.stated.readings.begin(), net.stated.readings.end());
    for (int k = 0; k < 3; ++k) {
        std::rotate(net.stated.readings.begin(), net.stated.readings.begin() + 7, net.stated.readings.end());
        const Adjusted again(net.stated);
        ASSERT_TRUE(again.network && again.network->adjusted) << again.words();
        EXPECT_LT((again.network->state.head(24) - first.network->state.head(24)).norm(), 1e-9);
    }
}

TEST(AdjustedNetwork, EveryReadingIsWeighedByItsStatedUncertainty) {
    const Adjusted made(hall(CoordinateRole::fixed, {}).stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const AdjustedNetwork& net = *made.network;
    // Dense matrices of the same readings, differentiated by differences.
    const auto n = static_cast<Eigen::Index>(net.place_of.size()),
               m = static_cast<Eigen::Index>(net.readings.size());
    Eigen::MatrixXd J(m, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        constexpr double h = 1e-6;
        Eigen::VectorXd up = net.state, down = net.state;
        up[static_cast<Eigen::Index>(net.place_of[static_cast<std::size_t>(k)])] += h;
        down[static_cast<Eigen::Index>(net.place_of[static_cast<std::size_t>(k)])] -= h;
        J.col(k) = (residuals_of(net, down.data()) - residuals_of(net, up.data())) / (2.0 * h);
    }
    Eigen::MatrixXd P = Eigen::MatrixXd::Zero(m, m);
    for (Eigen::Index i = 0; i < m; ++i) P(i, i) = std::pow(net.readings[static_cast<std::size_t>(i)].u, -2);
    const Eigen::MatrixXd N = J.transpose() * P * J;
    const Eigen::VectorXd gradient = J.transpose() * P * residuals_of(net, net.state.data());
    EXPECT_LT(gradient.cwiseQuotient(N.diagonal().cwiseSqrt()).lpNorm<Eigen::Infinity>(), 1e-4)
        << "least squares";
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::VectorXd column = net.adjusted->cofactors(Eigen::VectorXd::Unit(n, k));
        EXPECT_LT((N * column - Eigen::VectorXd::Unit(n, k)).norm(),
                  1e-4 * std::max(1.0, N.col(k).norm() * column.norm()));
    }
    const adjustment::Reliability r = reliability_of(net);
    double sum = 0.0;
    for (const adjustment::ReadingReliability& of : r.readings) sum += of.redundancy;
    EXPECT_NEAR(sum, r.degrees_of_freedom, 1e-8);
}

TEST(AdjustedNetwork, WhatTheDatumDoesNotChangeStays) {
    TrueNetwork net = hall(CoordinateRole::unknown, 0.0);
    const auto with_datum = [&](const std::vector<std::string>& names) {
        StatedAdjustment stated = net.stated;
        for (StatedAdjustment::Point& point : stated.points)
            if (std::ranges::find(names, point.name) != names.end())
                point.plane = point.height = CoordinateRole::datum;
        return Adjusted(stated);
    };
    const Adjusted first = with_datum({"A", "B", "C", "D"});
    ASSERT_TRUE(first.network && first.network->adjusted) << first.words();
    EXPECT_EQ(first.network->adjusted->defect(), 4u) << "three of place, a turn";
    const adjustment::Reliability r = reliability_of(*first.network);
    for (const auto& names : {std::vector<std::string>{"A", "C"},
                              {"P", "Q", "S", "T"},
                              {"A", "B", "C", "D", "P", "Q", "S", "T"}}) {
        const Adjusted other = with_datum(names);
        ASSERT_TRUE(other.network && other.network->adjusted) << other.words();
        const adjustment::Reliability o = reliability_of(*other.network);
        EXPECT_NEAR(o.sum_of_squares, r.sum_of_squares, 1e-6 * r.sum_of_squares);
        for (std::size_t i = 0; i < r.readings.size(); ++i) {
            EXPECT_NEAR(o.readings[i].residual, r.readings[i].residual, 1e-9);
            EXPECT_NEAR(o.readings[i].redundancy, r.readings[i].redundancy, 1e-7);
        }
        EXPECT_NEAR((other.network->position(0) - other.network->position(6)).norm(),
                    (first.network->position(0) - first.network->position(6)).norm(), 1e-9);
    }
}

TEST(AdjustedNetwork, AStatedPointOfSmallUIsFixedAndOfLargeUUnknown) {
    TrueNetwork net = hall(CoordinateRole::fixed, 0.0);
    const auto with_u = [&](double u) {
        StatedAdjustment stated = net.stated;
        stated.points[3].plane = stated.points[3].height = CoordinateRole::stated;
        stated.points[3].u = {u, u, u};
        return Adjusted(stated);
    };
    const Adjusted fixed(net.stated), small = with_u(1e-9), large = with_u(1e6);
    StatedAdjustment without = net.stated;
    without.points[3].plane = without.points[3].height = CoordinateRole::unknown;
    const Adjusted unknown(without);
    for (const Adjusted* made : {&fixed, &small, &large, &unknown})
        ASSERT_TRUE(made->network && made->network->adjusted) << made->words();
    EXPECT_LT((fixed.network->state - small.network->state).norm(), 1e-9);
    EXPECT_LT((unknown.network->state - large.network->state).norm(), 1e-9);
}

// A laser tracker stands where nobody knows and as it likes: six unknowns of a pose.
TEST(AdjustedNetwork, AnInstrumentThatIsNotLevelledIsFoundWithItsTilt) {
    TrueNetwork net = hall(CoordinateRole::fixed, {}, {{"S", {0.03, -0.02}}});
    const Adjusted level(net.stated);
    EXPECT_NE(level.words().find("larger than the uncertainties allow"), std::string::npos) << level.words();
    StatedAdjustment leaning = net.stated;
    leaning.stations = {{.point = "S", .stated = false, .u = {}}};
    const Adjusted made(leaning);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(made.words(), "");
    EXPECT_EQ(made.network->adjusted->degrees_of_freedom(), 39 - 14 - 2);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::size_t place = made.network->tilt(0, axis);
        EXPECT_NEAR(made.network->state[static_cast<Eigen::Index>(place)], net.tilts.at("S")[axis], 1e-4);
    }
    for (std::size_t p = 4; p < 8; ++p)
        EXPECT_LT((made.network->position(p) - net.places.at(made.network->points[p].name)).norm(), 3e-3);
    // Levelled within a large u is the same; within a small one it contradicts the readings.
    leaning.stations = {{.point = "S", .stated = true, .u = 1e3}};
    const Adjusted loose(leaning);
    ASSERT_TRUE(loose.network && loose.network->adjusted) << loose.words();
    EXPECT_LT((loose.network->state - made.network->state).norm(), 1e-8);
    leaning.stations[0].u = 1e-4;
    EXPECT_NE(Adjusted(leaning).words().find("larger than the uncertainties allow"), std::string::npos);
    // Distances alone cannot tell how the instrument stood.
    std::erase_if(leaning.readings, [](const StatedAdjustment::Reading& r) {
        return r.from == "S" && r.kind != ReadingKind::slope_distance;
    });
    leaning.stations = {{.point = "S", .stated = false, .u = {}}};
    for (StatedAdjustment::Point& point : leaning.points)
        for (std::size_t c = 0; c < 3; ++c)
            point.p[c] = net.places.at(point.name)[static_cast<Eigen::Index>(c)];
    EXPECT_NE(Adjusted(leaning).words().find("nothing tells how the instrument at S stood"),
              std::string::npos)
        << Adjusted(leaning).words();
}

TEST(AdjustedNetwork, ALevellingIsTheSameAdjustment) {
    TrueNetwork net;
    const auto none = CoordinateRole::none;
    for (const auto& [name, z] :
         {std::pair("A", 10.0), std::pair("B", 12.5), std::pair("C", 9.1), std::pair("D", 11.7)})
        net.point(name, {0.0, 0.0, z}, none, name[0] == 'A' ? CoordinateRole::fixed : CoordinateRole::unknown,
                  name[0] == 'A' ? std::optional(0.0) : std::nullopt);
    for (const auto& [a, b] : {std::pair("A", "B"), std::pair("B", "C"), std::pair("C", "D"),
                               std::pair("D", "A"), std::pair("A", "C")})
        net.read(ReadingKind::height_difference, a, b);
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(made.network->place_of.size(), 3u);
    EXPECT_EQ(made.network->adjusted->degrees_of_freedom(), 2);
    for (std::size_t p = 0; p < 4; ++p)
        EXPECT_NEAR(made.network->position(p).z(), net.places.at(made.network->points[p].name).z(), 3e-3);
}

}  // namespace
}  // namespace covaria::network
