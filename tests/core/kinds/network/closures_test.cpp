// Closures of readings before the adjustment: repeated readings, distances there and back, rounds, loops of
// heights.
#include "core/kinds/network/adjusted_closures.h"
#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network::closures_test {
namespace {

constexpr auto found_one = CoordinateRole::unknown, held_one = CoordinateRole::fixed,
               no_one = CoordinateRole::none;

StatedAdjustment::Reading height(const std::string& from, const std::string& to, double value, double u,
                                 const std::string& label = {}) {
    return {.label = label,
            .kind = ReadingKind::height_difference,
            .from = from,
            .to = to,
            .length = value,
            .u_length = u};
}

TrueNetwork levels() {
    TrueNetwork net;
    for (const char* name : {"A", "B", "C", "D"})
        net.point(name, {0, 0, 0}, no_one, std::string(name) == "A" ? held_one : found_one, 0.0);
    return net;
}

std::vector<Closure> closures_of(const StatedAdjustment& stated) {
    Problems problems;
    const std::optional<AdjustedNetwork> network = adjusted_network(stated, problems);
    return network ? closures(*network) : std::vector<Closure>();
}

const Closure* called(const std::vector<Closure>& all, const std::string& words) {
    for (const Closure& closure : all)
        if (closure.words.english() == words) return &closure;
    return nullptr;
}

// The loop by hand is 1.000 + 2.000 - 2.993 = 0.007 with u = sqrt(1 + 4 + 4) mm; D hangs on C by two
// readings.
TEST(Closures, LoopsOfHeightsCloseWithTheirSumAndItsU) {
    TrueNetwork net = levels();
    net.stated.readings = {height("A", "B", 1.000, 1e-3), height("B", "C", 2.000, 2e-3),
                           height("A", "C", 2.993, 2e-3), height("C", "D", 0.500, 1e-3),
                           height("D", "C", -0.499, 1e-3)};
    const std::vector<Closure> all = closures_of(net.stated);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_NEAR(std::abs(all[0].misclosure), 7e-3, 1e-12);
    EXPECT_NEAR(all[0].u, 3e-3, 1e-12);
    EXPECT_NEAR(all[0].ratio(), 7.0 / 3.0, 1e-9) << "the largest for its u first";
    EXPECT_NEAR(std::abs(all[1].misclosure), 1e-3, 1e-12);
    EXPECT_NEAR(all[1].u, std::sqrt(2.0) * 1e-3, 1e-12);
    EXPECT_NE(all[1].words.english().find("D – C – D"), std::string::npos) << all[1].words.english();
    EXPECT_EQ(closures_table(all).rows, 2U);
}

// Heights of instrument and target belong to the way; u of correlated readings is that of their difference.
TEST(Closures, HeightsAboveThePointsAndCorrelationsCount) {
    TrueNetwork net = levels();
    net.stated.readings = {height("A", "B", 1.0, 1e-3, "there"), height("A", "B", 1.2, 1e-3, "again"),
                           height("A", "C", 1.0, 1e-3), height("A", "D", 1.0, 1e-3)};
    net.stated.readings[1].height_to = 0.2;
    net.stated.correlations = {{"there", "again", 0.5}};
    const std::vector<Closure> all = closures_of(net.stated);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_NEAR(all[0].misclosure, 0.0, 1e-12);
    EXPECT_NEAR(all[0].u, 1e-3, 1e-12) << "sqrt(1 + 1 - 2 · 0.5) mm";
}

TEST(Closures, DistancesThereAndBackAndRoundsAreCompared) {
    TrueNetwork net = hall(held_one, {});
    net.deviations = 0.0;
    const std::size_t before = net.stated.readings.size();
    for (const char* target : {"A", "C", "D"}) {
        net.read(ReadingKind::direction, "S", target);
        net.stated.readings.back().round = "2";
        net.stated.readings.back().angle = *net.stated.readings.back().angle + 1.0;  // the circle was turned
    }
    net.stated.readings[before + 2].angle = *net.stated.readings[before + 2].angle + 9e-5;
    for (std::size_t i = 0; i < before; ++i)
        if (net.stated.readings[i].kind == ReadingKind::direction) {
            const auto& r = net.stated.readings[i];
            const Eigen::Vector3d v = net.places.at(r.to) - net.places.at(r.from);
            net.stated.readings[i].angle = std::atan2(v.y(), v.x());
        }
    const std::vector<Closure> all = closures_of(net.stated);
    const Closure *good = called(all, "angle at S from A to C, in two rounds"),
                  *bad = called(all, "angle at S from A to D, in two rounds"),
                  *back = called(all, "slope distance T – S, there and back");
    ASSERT_TRUE(good && bad && back);
    EXPECT_NEAR(good->misclosure, 0.0, 1e-12);
    EXPECT_NEAR(bad->misclosure, 9e-5, 1e-12);
    EXPECT_NEAR(bad->u, 2e-5, 1e-15) << "four directions of 1e-5";
    EXPECT_NEAR(back->u, std::sqrt(2.0) * 1e-3, 1e-12);
    const Adjusted made(net.stated);
    EXPECT_NE(made.words().find("before the adjustment: angle at S from A to D, in two rounds closes with"),
              std::string::npos)
        << made.words();
    EXPECT_EQ(made.words().find("from A to C, in two rounds"), std::string::npos);
}

// A network that cannot be adjusted says its closures too.
TEST(Closures, AreSaidWhereNothingCanBeAdjusted) {
    TrueNetwork net = levels();
    net.called("A").height = found_one;
    net.stated.readings = {height("A", "B", 1.0, 1e-3), height("B", "A", 1.0, 1e-3),
                           height("A", "C", 1.0, 1e-3), height("A", "D", 1.0, 1e-3)};
    const Adjusted made(net.stated);
    EXPECT_NE(made.words().find("loop of height differences"), std::string::npos) << made.words();
    EXPECT_NE(made.words().find("nothing tells the height of the whole network"), std::string::npos);
}

}  // namespace
}  // namespace covaria::network::closures_test
