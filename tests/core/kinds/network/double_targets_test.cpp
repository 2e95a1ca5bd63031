// Double targets and loops of distances before the adjustment.
#include <numbers>

#include "core/kinds/network/adjusted_closures.h"
#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network::double_targets_test {
namespace {

constexpr auto free_one = CoordinateRole::unknown, fixed_one = CoordinateRole::fixed,
               no_one = CoordinateRole::none, datum_one = CoordinateRole::datum;
constexpr auto slope_reading = ReadingKind::slope_distance, level_reading = ReadingKind::horizontal_distance;

std::vector<Closure> closures_called(const StatedAdjustment& stated, const std::string& part) {
    Problems problems;
    const std::optional<AdjustedNetwork> network = adjusted_network(stated, problems);
    std::vector<Closure> found = network ? closures(*network) : std::vector<Closure>();
    std::erase_if(found, [&](const Closure& c) { return c.words.english().find(part) == std::string::npos; });
    return found;
}

const std::vector<ReadingKind> polar{ReadingKind::direction, ReadingKind::zenith_angle,
                                     ReadingKind::slope_distance};

// Two prisms on a bar across the line of sight, 10 m away: their directions count with 10 m each, the
// distance of the far one with 1/101, that of the near one and the zenith angles not at all.
TEST(DoubleTargets, TwoPrismsOnABarAreHeldAgainstItsLength) {
    TrueNetwork net;
    net.deviations = 0.0;
    for (const auto& [name, x, y] :
         {std::tuple("S", 0.0, 0.0), std::tuple("P", 10.0, 0.0), std::tuple("Q", 10.0, 1.0)})
        net.point(name, {x, y, 0.0}, free_one, free_one, 0.0);
    net.read_all(polar, "S", {"P", "Q"});
    net.read(slope_reading, "P", "Q");
    net.stated.readings.back().length = 1.002;
    net.stated.readings.back().u_length = 5e-4;
    const std::vector<Closure> all = closures_called(net.stated, "and the sights of both from S");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].words.english(), "slope distance P – Q and the sights of both from S");
    EXPECT_NEAR(all[0].misclosure, 0.002, 1e-12);
    EXPECT_NEAR(all[0].u, std::sqrt(5e-4 * 5e-4 + 2.0 * 1e-8 + 1e-6 / 101.0), 1e-9);
    EXPECT_EQ(all[0].rows.size(), 7U);
    EXPECT_NE(
        Adjusted(net.stated).words().find("slope distance P – Q and the sights of both from S closes with"),
        std::string::npos);
}

// A zero of the distance meter lengthens both sights alike; stated it is taken off, unknown nothing is
// closed.
TEST(DoubleTargets, FiguresOfTheInstrumentCount) {
    TrueNetwork net;
    net.deviations = 0.0;
    for (const auto& [name, x, y] :
         {std::tuple("S", 0.0, 0.0), std::tuple("P", 6.0, 3.0), std::tuple("Q", 8.0, -4.0)})
        net.point(name, {x, y, 1.0}, free_one, free_one, 0.0);
    net.read_all(polar, "S", {"P", "Q"});
    net.read(slope_reading, "P", "Q");
    for (StatedAdjustment::Reading& r : net.stated.readings)
        if (r.from == "S") {
            r.instrument = "T";
            if (r.length) *r.length = *r.length * 1.0001 + 0.02;
        }
    StatedAdjustment::Figure zero, scale;
    zero.instrument = scale.instrument = "T";
    zero.knowledge = scale.knowledge = FigureKnowledge::stated;
    zero.length = 0.02, zero.u_length = 1e-3;
    scale.kind = FigureKind::scale;
    scale.ratio = 1e-4, scale.u_ratio = 1e-6;
    net.stated.figures = {zero, scale};
    std::vector<Closure> all = closures_called(net.stated, "and the sights of both from S");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_NEAR(all[0].misclosure, 0.0, 1e-12);
    const double without_u = all[0].u;
    net.stated.figures[0].u_length = 1e-2;
    EXPECT_GT(closures_called(net.stated, "and the sights of both from S")[0].u, 2.0 * without_u);
    net.stated.figures[0].knowledge = FigureKnowledge::unknown;
    EXPECT_TRUE(closures_called(net.stated, "and the sights of both from S").empty());
}

TEST(DoubleTargets, StationsAndCoordinatesAreComparedByDistances) {
    TrueNetwork net = hall(fixed_one, {});
    const StatedAdjustment good = net.stated;
    for (const std::string part : {"by coordinates and the sights", "by the sights from S and from T"}) {
        const std::vector<Closure> all = closures_called(good, part);
        ASSERT_GE(all.size(), 3U) << part;
        for (const Closure& c : all) EXPECT_LT(c.ratio(), 3.29) << c.words.english();
    }
    StatedAdjustment bad = good;
    for (StatedAdjustment::Reading& r : bad.readings)
        if (r.kind == slope_reading && r.from == "T" && r.to == "B") *r.length += 0.05;
    EXPECT_GT(closures_called(bad, "distance A – B by the sights from S and from T").at(0).ratio(), 3.29);
    EXPECT_GT(
        closures_called(bad, "distance A – B by coordinates and the sights of both from T").at(0).ratio(),
        3.29);
}

/// A free network of distances alone, all between `at`, with deviations of some u.
StatedAdjustment all_distances(ReadingKind kind, const std::vector<Eigen::Vector3d>& at) {
    TrueNetwork net;
    net.deviations = 2.0;
    for (std::size_t i = 0; i < at.size(); ++i)
        net.point(std::string(1, char('A' + i)), at[i], datum_one, kind == level_reading ? no_one : datum_one,
                  0.0);
    for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t k = i + 1; k < at.size(); ++k)
            net.read(kind, std::string(1, char('A' + i)), std::string(1, char('A' + k)));
    return net.stated;
}

// One condition between the readings is all the redundancy: the square of each closure over its u is the sum
// of squares of the free adjustment.
TEST(DistanceLoops, TheOneConditionIsTheWholeSumOfSquares) {
    const std::vector<Eigen::Vector3d> quadrangle{{0, 0, 0}, {30, 2, 0}, {28, 25, 0}, {-3, 21, 0}},
        five{{0, 0, 0}, {30, 2, 1}, {28, 25, -2}, {-3, 21, 3}, {12, 14, 19}};
    for (const auto& [kind, at] : {std::pair(level_reading, quadrangle), std::pair(slope_reading, five)}) {
        const StatedAdjustment stated = all_distances(kind, at);
        const Adjusted made(stated);
        ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
        ASSERT_EQ(made.network->adjusted->degrees_of_freedom(), 1);
        const double sum = made.network->reliability.sum_of_squares;
        ASSERT_GT(sum, 1e-4);
        const std::vector<Closure> all = closures_called(stated, "loop of distances");
        EXPECT_EQ(all.size(), at.size() * (at.size() - 1) / 2) << "one by each distance";
        for (const Closure& c : all) {
            EXPECT_NEAR(c.ratio() * c.ratio(), sum, 2e-3 * sum) << c.words.english();
            EXPECT_EQ(c.rows.size(), stated.readings.size());
        }
    }
}

// Three distances close where one is longer than the two others; on a line of the set-up always.
TEST(DistanceLoops, TrianglesAndLines) {
    TrueNetwork net;
    net.deviations = 0.0;
    for (const auto& [name, x, y] :
         {std::tuple("A", 0.0, 0.0), std::tuple("B", 40.0, 0.0), std::tuple("C", 90.0, 30.0)})
        net.point(name, {x, y, 0.0}, datum_one, no_one, 0.0);
    net.read(level_reading, "A", "B");
    net.read(level_reading, "B", "C");
    net.read(level_reading, "A", "C");
    EXPECT_TRUE(closures_called(net.stated, "loop of distances").empty())
        << "any three lengths that make a triangle";
    *net.stated.readings[2].length = 99.0;
    const std::vector<Closure> any = closures_called(net.stated, "loop of distances");
    ASSERT_EQ(any.size(), 1U);
    EXPECT_NEAR(any[0].misclosure, 99.0 - 40.0 - std::hypot(50.0, 30.0), 1e-9);
    EXPECT_NEAR(any[0].u, std::sqrt(3.0) * 1e-3, 1e-12);
    EXPECT_NE(Adjusted(net.stated).words().find("loop of distances"), std::string::npos);

    TrueNetwork line;
    line.deviations = 0.0;
    for (const auto& [name, x] : {std::pair("A", 0.0), std::pair("B", 40.0), std::pair("C", 90.0)})
        line.point(name, {x, 0.0, 0.0}, free_one, no_one, 0.0);
    line.read(level_reading, "A", "B");
    line.read(level_reading, "B", "C");
    line.read(level_reading, "A", "C");
    *line.stated.readings[2].length -= 0.004;
    for (const char* name : {"A", "B", "C"})
        line.stated.readings.push_back(
            {.kind = ReadingKind::frame_y, .from = name, .frame = "L", .length = 0.0, .u_length = 1e-4});
    line.stated.frames = {{.name = "L", .shape = FrameShape::line}};
    const std::vector<Closure> on_line = closures_called(line.stated, "loop of distances");
    ASSERT_EQ(on_line.size(), 1U);
    EXPECT_NEAR(on_line[0].misclosure, -0.004, 1e-12);
}

}  // namespace
}  // namespace covaria::network::double_targets_test
