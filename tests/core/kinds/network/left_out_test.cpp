// Readings and points that an adjustment leaves out: by hand, gross readings, unknown points, outliers.
#include "tests/core/kinds/network/adjusted_network.h"

#include <algorithm>

namespace covaria::network {
namespace {

constexpr auto unknown_role = CoordinateRole::unknown, fixed_role = CoordinateRole::fixed;

StatedAdjustment::Reading& row_of(StatedAdjustment& stated, ReadingKind kind, const std::string& from,
                                  const std::string& to) {
    for (StatedAdjustment::Reading& r : stated.readings)
        if (r.kind == kind && r.from == from && r.to == to) return r;
    throw std::out_of_range(from + to);
}

std::string left_out(const Adjusted& made) {
    std::string words;
    if (made.network)
        for (const LeftOut& out : made.network->left_out)
            words += out.what.english() + ": " + out.why.english() + "\n";
    return words;
}

TEST(LeftOut, AReadingLeftOutByHandIsAsIfItWereNotThere) {
    StatedAdjustment stated = hall(fixed_role, {}).stated, without = stated;
    row_of(stated, ReadingKind::slope_distance, "S", "C").left_out = true;
    std::erase_if(without.readings, [](const StatedAdjustment::Reading& r) {
        return r.kind == ReadingKind::slope_distance && r.from == "S" && r.to == "C";
    });
    const Adjusted made(stated), other(without);
    ASSERT_TRUE(made.network && other.network) << made.words();
    EXPECT_LT((made.network->state - other.network->state).norm(), 1e-12);
    EXPECT_EQ(left_out(made), "slope distance S – C: by hand\n");
    EXPECT_EQ(made.words(), "") << "who left it out knows";
}

TEST(LeftOut, GrossReadingsAreLeftOutWhereThatIsAskedFor) {
    StatedAdjustment stated = hall(fixed_role, 0.0).stated;
    *row_of(stated, ReadingKind::slope_distance, "S", "P").length += 15.0;
    *row_of(stated, ReadingKind::direction, "T", "B").angle += 1.0;
    EXPECT_NE(Adjusted(stated).words().find("larger than the uncertainties allow"), std::string::npos);
    stated.gross_limit = 1.0;
    const Adjusted made(stated);
    ASSERT_TRUE(made.network) << made.words();
    EXPECT_EQ(made.network->left_out.size(), 2u) << left_out(made);
    EXPECT_NE(left_out(made).find("slope distance S – P: it misses what the others agree on by 15"),
              std::string::npos)
        << left_out(made);
    EXPECT_NE(made.words().find("direction T – B is left out"), std::string::npos) << made.words();
    EXPECT_EQ(made.words().find("larger than"), std::string::npos) << made.words();
}

TEST(LeftOut, PointsThatNothingTellsAreLeftOutWhereThatIsAskedFor) {
    TrueNetwork net = hall(fixed_role, {});
    net.point("E", {9, 9, 1}, unknown_role, unknown_role, {});
    net.read_all({ReadingKind::direction, ReadingKind::horizontal_distance}, "S", {"E"});
    net.point("F", {1, 2, 1}, unknown_role, unknown_role, {});
    net.read_all({ReadingKind::direction}, "T", {"F"});
    EXPECT_NE(Adjusted(net.stated).words().find("do not place point F"), std::string::npos);
    net.stated.leaves_undetermined = true;
    const Adjusted made(net.stated), hall_alone(hall(fixed_role, {}).stated);
    ASSERT_TRUE(made.network) << made.words();
    const std::string words = left_out(made);
    for (const char* said : {"x and y of F: nothing tells them", "the height of F: nothing tells it",
                             "the height of E: nothing tells it", "direction T – F: its point F is left out"})
        EXPECT_NE(words.find(said), std::string::npos) << said << " in\n" << words;
    EXPECT_EQ(made.network->adjusted->degrees_of_freedom(),
              hall_alone.network->adjusted->degrees_of_freedom())
        << "E has two coordinates from two readings";
    // A network without a datum is none that a point could be left out of.
    StatedAdjustment floating = hall(unknown_role, 0.0).stated;
    floating.leaves_undetermined = true;
    EXPECT_NE(Adjusted(floating).words().find("where the whole network is along x"), std::string::npos)
        << Adjusted(floating).words();
}

// Bad approximate coordinates are no gross readings: a robust adjustment leads away from them.
TEST(LeftOut, ReadingsThatAgreeStayWhereApproximateCoordinatesAreBad) {
    StatedAdjustment stated = hall(fixed_role, 0.0).stated;
    for (StatedAdjustment::Point& point : stated.points)
        if (point.name == "P") point.p = {*point.p[0] + 3.0, *point.p[1] - 2.0, point.p[2]};
    *row_of(stated, ReadingKind::slope_distance, "S", "Q").length += 15.0;
    stated.gross_limit = 1.0;
    const Adjusted made(stated);
    ASSERT_TRUE(made.network) << made.words();
    ASSERT_EQ(made.network->left_out.size(), 1u) << left_out(made);
    EXPECT_EQ(made.network->left_out[0].what.english(), "slope distance S – Q");
}

// Four of 39 readings are wrong at one station: the largest residuals of least squares are not all theirs.
TEST(LeftOut, ARobustStartFindsSeveralErrorsAtOnce) {
    StatedAdjustment stated = hall(fixed_role, {}).stated;
    std::vector<std::string> wrong;
    const auto spoil = [&](ReadingKind kind, const char* from, const char* to, double by) {
        StatedAdjustment::Reading& r = row_of(stated, kind, from, to);
        *(r.length ? r.length : r.angle) += by;
    };
    spoil(ReadingKind::slope_distance, "S", "A", 0.05);
    spoil(ReadingKind::direction, "S", "B", 0.004);
    spoil(ReadingKind::zenith_angle, "S", "C", -0.003);
    spoil(ReadingKind::slope_distance, "T", "C", -0.08);
    stated.robust = true;
    const Adjusted made(stated);
    ASSERT_TRUE(made.network) << made.words();
    const std::string words = left_out(made);
    for (const char* said :
         {"slope distance S – A", "direction S – B", "zenith angle S – C", "slope distance T – C"})
        EXPECT_NE(words.find(said), std::string::npos) << said << " in\n" << words;
    EXPECT_EQ(made.network->left_out.size(), 4u) << words;
    EXPECT_EQ(made.words().find("larger than"), std::string::npos) << made.words();
    // A robust adjustment of readings without errors is that of all of them.
    StatedAdjustment right = hall(fixed_role, {}).stated;
    const Adjusted plain(right);
    right.robust = true;
    const Adjusted robust(right);
    ASSERT_TRUE(plain.network && robust.network);
    EXPECT_EQ(robust.network->left_out.size(), 0u);
    EXPECT_LT((plain.network->state - robust.network->state).norm(), 1e-8);
}

// A spur of two distances: an error of either shows in both alike.
TEST(LeftOut, ReadingsThatCannotBeToldApartAreNamedBoth) {
    TrueNetwork net;
    net.point("A", {0, 0, 0}, fixed_role, CoordinateRole::none, 0.0);
    net.point("B", {30, 0, 0}, fixed_role, CoordinateRole::none, 0.0);
    net.point("C", {12, 9, 0}, unknown_role, CoordinateRole::none, 0.001);
    net.read(ReadingKind::horizontal_distance, "A", "C");
    net.read(ReadingKind::horizontal_distance, "B", "C");
    net.read(ReadingKind::azimuth, "A", "C");
    *net.stated.readings[0].length += 0.05;
    net.stated.robust = true;
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network) << made.words();
    EXPECT_NE((left_out(made) + made.words()).find("it cannot be told apart from"), std::string::npos)
        << left_out(made) << made.words();
}

}  // namespace
}  // namespace covaria::network
