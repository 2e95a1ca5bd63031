// Groups of readings as candidates: the decrease of the sum of squares without a station, a round, a target.
#include "core/kinds/network/adjusted_groups.h"
#include "core/math/special_quantiles.h"
#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network::groups_test {
namespace {

constexpr auto found_one = CoordinateRole::unknown, held_one = CoordinateRole::fixed,
               no_one = CoordinateRole::none;

/// A levelling, which is linear, so that leaving out is exact.
StatedAdjustment levelling() {
    TrueNetwork net;
    for (const char* name : {"A", "B", "C", "D", "E"})
        net.point(name, {0, 0, 0}, no_one, name[0] == 'A' ? held_one : found_one, 0.0);
    double deviation = 0.3;
    for (const auto& [from, to, value] :
         {std::tuple("A", "B", 1.0), std::tuple("B", "C", 2.0), std::tuple("A", "C", 3.0),
          std::tuple("C", "D", 1.0), std::tuple("D", "E", 1.0), std::tuple("A", "E", 5.0),
          std::tuple("B", "E", 4.0), std::tuple("B", "D", 3.0), std::tuple("A", "D", 4.0)}) {
        deviation = std::fmod(deviation * 7.3 + 0.41, 1.0);
        net.stated.readings.push_back({.label = std::string(from) + to,
                                       .kind = ReadingKind::height_difference,
                                       .from = from,
                                       .to = to,
                                       .length = value + 4e-3 * (deviation - 0.5),
                                       .u_length = 1e-3});
    }
    net.stated.correlations = {{"AB", "AC", 0.4}};
    return net.stated;
}

TEST(GroupsOfReadings, WithoutOneTheSumOfSquaresFallsByItsTest) {
    const StatedAdjustment stated = levelling();
    const Adjusted all(stated);
    ASSERT_TRUE(all.network && all.network->adjusted) << all.words();
    const std::vector<GroupOfReadings> groups = groups_of(*all.network);
    std::size_t compared = 0;
    for (const GroupOfReadings& group : groups) {
        StatedAdjustment without = stated;
        for (const std::size_t i : group.readings)
            without.readings[all.network->readings[i].row].left_out = true;
        const Adjusted rest(without);
        if (!rest.network || !rest.network->adjusted) continue;
        ++compared;
        EXPECT_NEAR(group.test.statistic,
                    all.network->reliability.sum_of_squares - rest.network->reliability.sum_of_squares, 1e-8)
            << group.words.english();
        EXPECT_EQ(group.test.redundancy,
                  all.network->reliability.degrees_of_freedom - rest.network->reliability.degrees_of_freedom)
            << group.words.english();
        EXPECT_NEAR(group.test.p, chi_squared_upper_tail(group.test.statistic, group.test.redundancy), 1e-12);
    }
    EXPECT_GE(compared, 3U);
    for (std::size_t i = 1; i < groups.size(); ++i) EXPECT_LE(groups[i - 1].test.p, groups[i].test.p);
}

TEST(GroupsOfReadings, OneReadingIsItsW) {
    const Adjusted all(levelling());
    ASSERT_TRUE(all.network && all.network->adjusted);
    const adjustment::GroupTests tests(*all.network->adjusted, all.network->whitening,
                                       residuals_of(*all.network, all.network->state.data()));
    for (std::size_t i = 0; i < all.network->readings.size(); ++i) {
        const double w = all.network->reliability.readings[i].w;
        const adjustment::GroupTest test = tests.of({i});
        EXPECT_NEAR(test.statistic, w * w, 1e-9 * std::max(1.0, w * w));
        EXPECT_EQ(test.redundancy, 1);
    }
}

// All heights of one station's target are wrong alike: no reading alone says so as clearly as its target.
TEST(GroupsOfReadings, ATargetThatMovedComesFirst) {
    TrueNetwork net = hall(held_one, {});
    net.deviations = 0.2;
    for (StatedAdjustment::Reading& r : net.stated.readings)
        if (r.from == "T" && r.to == "B" && r.length) r.length = *r.length + 3e-3;
    for (StatedAdjustment::Reading& r : net.stated.readings)
        if (r.to == "B" && r.kind == ReadingKind::zenith_angle) r.angle = *r.angle + 2e-4;
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const std::vector<GroupOfReadings> groups = groups_of(*made.network);
    ASSERT_FALSE(groups.empty());
    EXPECT_EQ(groups.front().words.english(), "target B");
    EXPECT_LT(groups.front().test.p, 0.001);
}

}  // namespace
}  // namespace covaria::network::groups_test
