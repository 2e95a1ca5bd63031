// Both faces of sights: readings of face two, index and collimation from pairs, and what contradicts them.
#include <numbers>

#include "core/kinds/network/adjusted_closures.h"
#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network::faces_test {
namespace {

constexpr double true_index = 3e-5, true_collimation = 5e-5, pi = std::numbers::pi;

/// The hall without deviations, read in both faces by an instrument with index and collimation.
StatedAdjustment two_faces() {
    TrueNetwork net = hall(CoordinateRole::fixed, {});
    const std::size_t count = net.stated.readings.size();
    net.deviations = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const StatedAdjustment::Reading typed = net.stated.readings[i];
        net.read(typed.kind, typed.from, typed.to);
    }
    net.stated.readings.erase(net.stated.readings.begin(),
                              net.stated.readings.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<StatedAdjustment::Reading> second;
    for (StatedAdjustment::Reading& r : net.stated.readings) {
        if (!r.angle) continue;
        const Eigen::Vector3d v = net.places.at(r.to) - net.places.at(r.from);
        StatedAdjustment::Reading two = r;
        if (r.kind == ReadingKind::zenith_angle) {
            two.angle = 2.0 * pi - *r.angle + true_index;
            *r.angle += true_index;
        } else {
            const double by = true_collimation * v.norm() / v.head<2>().norm();
            two.angle = *r.angle + pi - by;
            two.face_two = true;
            *r.angle += by;
        }
        second.push_back(two);
    }
    net.stated.readings.insert(net.stated.readings.end(), second.begin(), second.end());
    return net.stated;
}

StatedAdjustment::Figure figure(FigureKind kind, FigureKnowledge knowledge, std::optional<double> value = {},
                                std::optional<double> u = {}) {
    StatedAdjustment::Figure row;
    row.kind = kind;
    row.knowledge = knowledge;
    row.angle = value;
    row.u_angle = u;
    return row;
}

std::vector<Closure> faces_of(const StatedAdjustment& stated) {
    Problems problems;
    const std::optional<AdjustedNetwork> network = adjusted_network(stated, problems);
    std::vector<Closure> found = network ? closures(*network) : std::vector<Closure>();
    std::erase_if(found,
                  [](const Closure& c) { return c.words.english().find("faces") == std::string::npos; });
    return found;
}

const Closure& called(const std::vector<Closure>& all, const std::string& words) {
    for (const Closure& closure : all)
        if (closure.words.english() == words) return closure;
    ADD_FAILURE() << words;
    static const Closure none;
    return none;
}

// Index and collimation, as unknowns, take the opposite sign in face two: both are found as they are.
TEST(Faces, TheAdjustmentFindsIndexAndCollimation) {
    StatedAdjustment stated = two_faces();
    stated.figures = {figure(FigureKind::index, FigureKnowledge::unknown),
                      figure(FigureKind::collimation, FigureKnowledge::unknown)};
    const Adjusted made(stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(made.words(), "");
    EXPECT_LT(made.network->reliability.sum_of_squares, 1e-9);
    const auto& state = made.network->state;
    EXPECT_NEAR(state[static_cast<Eigen::Index>(made.network->figure(0))], true_index, 1e-10);
    EXPECT_NEAR(state[static_cast<Eigen::Index>(made.network->figure(1))], true_collimation, 1e-10);
}

// Without a row of figures the mean of both faces bears the index, and the pairs agree with each other.
TEST(Faces, PairsTellTheIndexThatNobodyStated) {
    const std::vector<Closure> all = faces_of(two_faces());
    const Closure& index = called(all, "the vertical index of all instruments from both faces of 13 sights");
    EXPECT_NEAR(index.misclosure, true_index, 1e-12);
    EXPECT_NEAR(index.u, 1e-5 / std::sqrt(2.0 * 13.0), 1e-15) << "13 halves of differences of 1e-5 each";
    const Closure& collimation =
        called(all, "the collimation of all instruments from both faces of 13 sights");
    EXPECT_NEAR(collimation.misclosure, true_collimation, 1e-8);
    std::size_t pairs = 0;
    for (const Closure& c : all)
        if (c.words.english().find("in both faces, as") != std::string::npos) {
            EXPECT_NEAR(c.misclosure, 0.0, 1e-8) << c.words.english() << ": sin z is of z with its index";
            ++pairs;
        }
    EXPECT_EQ(pairs, 24U) << "twelve of thirteen zenith angles and directions";
    const Adjusted made(two_faces());
    EXPECT_NE(
        made.words().find("the vertical index of all instruments from both faces of 13 sights closes with"),
        std::string::npos)
        << made.words();
}

// A stated index is one more reading of the pair: u² = 2 · (1e-5)² + (2 · 2e-5)².
TEST(Faces, PairsAreHeldAgainstWhatIsStated) {
    StatedAdjustment stated = two_faces();
    stated.figures = {figure(FigureKind::index, FigureKnowledge::stated, 1e-5, 2e-5),
                      figure(FigureKind::collimation, FigureKnowledge::fixed, true_collimation)};
    std::vector<Closure> all = faces_of(stated);
    const Closure& pair = called(all, "zenith angle S – P in both faces");
    EXPECT_NEAR(pair.misclosure, 2.0 * (true_index - 1e-5), 1e-12);
    EXPECT_NEAR(pair.u, std::sqrt(18.0) * 1e-5, 1e-14);
    EXPECT_EQ(pair.rows.size(), 2U);
    EXPECT_NEAR(called(all, "direction S – P in both faces").misclosure, 0.0, 1e-8);
    const std::optional<Table> table = faces_table(*Adjusted(stated).network);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rows, 2U);
}

TEST(Faces, AReadingThatContradictsItsOtherFaceIsSaidWithItsRows) {
    StatedAdjustment stated = two_faces();
    stated.figures = {figure(FigureKind::index, FigureKnowledge::unknown),
                      figure(FigureKind::collimation, FigureKnowledge::unknown)};
    std::size_t row = 0;
    while (stated.readings[row].to != "P" || stated.readings[row].kind != ReadingKind::zenith_angle) ++row;
    *stated.readings[row].angle += 3e-4;
    const std::string said = Adjusted(stated).words();
    EXPECT_NE(said.find("before the adjustment: zenith angle S – P in both faces, as zenith angle"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("(rows "), std::string::npos);
    EXPECT_NE(said.find(std::to_string(row + 1) + ", "), std::string::npos) << said;
}

// A zenith angle brought to face one deviates the other way, so that its correlations change their sign.
TEST(Faces, CorrelationsAreThoseOfTheReadingsAsTyped) {
    StatedAdjustment one = hall(CoordinateRole::fixed, {}).stated;
    std::vector<std::size_t> zenith;
    for (std::size_t i = 0; i < one.readings.size() && zenith.size() < 2; ++i)
        if (one.readings[i].kind == ReadingKind::zenith_angle) zenith.push_back(i);
    one.readings[zenith[0]].label = "a";
    one.readings[zenith[1]].label = "b";
    one.correlations = {{"a", "b", 0.7}};
    StatedAdjustment two = one;
    two.readings[zenith[1]].angle = 2.0 * pi - *one.readings[zenith[1]].angle;
    two.correlations = {{"a", "b", -0.7}};
    const Adjusted in_one(one), in_two(two);
    ASSERT_TRUE(in_one.network && in_two.network);
    EXPECT_LT((in_one.network->state - in_two.network->state).norm(), 1e-12);
    EXPECT_NEAR(in_one.network->reliability.sum_of_squares, in_two.network->reliability.sum_of_squares, 1e-9);
    two.correlations = {{"a", "b", 0.7}};
    EXPECT_GT(std::abs(Adjusted(two).network->reliability.sum_of_squares -
                       in_one.network->reliability.sum_of_squares),
              1e-3);
}

}  // namespace
}  // namespace covaria::network::faces_test
