// Stated uncertainties against the residuals of a network, and a network that takes over what they see.
#include <algorithm>
#include <cmath>

#include "core/evidence/seen.h"
#include "tests/core/kinds/network/adjusted_network.h"

namespace covaria::network {
namespace {

using evidence::RedundantReadings;
using evidence::Seen;
using evidence::Verdict;

/// A hall with many targets, so that each kind of reading has redundancy enough; deviations of distances are
/// a third of what is stated.
TrueNetwork rich_hall() {
    TrueNetwork net;
    for (const auto& [name, x, y, z] : {std::tuple("A", 0.0, 0.0, 1.2), std::tuple("B", 24.0, 1.5, 1.4),
                                        std::tuple("C", 20.0, 16.0, 2.1), std::tuple("D", -2.0, 14.0, 0.9)})
        net.point(name, {x, y, z}, CoordinateRole::datum, CoordinateRole::datum, 0.0);
    std::vector<std::string> targets{"A", "B", "C", "D"};
    for (int k = 0; k < 10; ++k) {
        const std::string name = "P" + std::to_string(k);
        net.point(name, {4.0 + 1.3 * k, 9.0 + 4.0 * std::sin(2.0 * k), 1.5 + std::cos(3.0 * k)},
                  CoordinateRole::unknown, CoordinateRole::unknown);
        targets.push_back(name);
    }
    for (const auto& [name, x, y, z] : {std::tuple("S", 6.0, 9.0, 1.6), std::tuple("T", 16.0, 3.5, 1.65),
                                        std::tuple("U", 12.0, 14.0, 1.7)}) {
        net.point(name, {x, y, z}, CoordinateRole::unknown, CoordinateRole::unknown);
        net.deviations = 1.7;
        net.read_all({ReadingKind::direction, ReadingKind::zenith_angle}, name, targets);
        net.deviations = 0.5;
        net.read_all({ReadingKind::slope_distance}, name, targets);
    }
    return net;
}

Adjusted as_seen(StatedAdjustment stated, UncertaintiesFrom from) {
    Adjusted made(stated);
    if (!made.network || !made.network->adjusted) return made;
    take_as_seen(*made.network, from, made.problems);
    return made;
}

std::vector<std::string> names(const RedundantReadings& readings) {
    std::vector<std::string> names;
    for (const evidence::StatedFigure& figure : readings.figures) names.push_back(figure.name.english());
    return names;
}

TEST(AdjustedEvidence, ReadingsOfOneKindByOneInstrumentRestOnOneFigure) {
    TrueNetwork net = rich_hall();
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(names(redundant_readings(*made.network)),
              (std::vector<std::string>{"directions", "zenith angles", "slope distances"}));
    for (StatedAdjustment::Reading& reading : net.stated.readings)
        if (reading.kind == ReadingKind::slope_distance)
            reading.instrument = reading.from == "S" ? "old" : "new";
    const Adjusted parted(net.stated);
    EXPECT_EQ(names(redundant_readings(*parted.network)),
              (std::vector<std::string>{"directions", "zenith angles", "slope distances of old",
                                        "slope distances of new"}));
}

TEST(AdjustedEvidence, KindsThatAreCorrelatedRestOnOneFigureTogether) {
    TrueNetwork net = rich_hall();
    net.stated.readings[0].label = "a";
    net.stated.readings[1].label = "b";
    net.stated.correlations.push_back({"a", "b", 0.4});
    const Adjusted made(net.stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_EQ(names(redundant_readings(*made.network)),
              (std::vector<std::string>{"directions and zenith angles", "slope distances"}));
}

TEST(AdjustedEvidence, TheDataSeeWhatIsStatedTooLarge) {
    const Adjusted made(rich_hall().stated);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const Seen seen = evidence::see(redundant_readings(*made.network));
    ASSERT_TRUE(seen.found);
    EXPECT_EQ(seen.figures[2].verdict, Verdict::smaller);
    EXPECT_NEAR(seen.figures[2].factor, 0.25, 0.1);
    EXPECT_LT(seen.mean_u_seen, seen.mean_u_stated);
    double sum = 0.0;
    for (const evidence::SeenFigure& figure : seen.figures) sum += figure.redundancy;
    EXPECT_NEAR(sum, seen.degrees_of_freedom, 1e-7);
}

// Uncertainties taken over as seen give the network that states them by hand.
TEST(AdjustedEvidence, AsSeenIsTheSameAsStatingIt) {
    const TrueNetwork net = rich_hall();
    const Adjusted made = as_seen(net.stated, UncertaintiesFrom::seen);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    const Seen seen = evidence::see(*made.network->evidence);
    StatedAdjustment by_hand = net.stated;
    for (std::size_t i = 0; i < by_hand.readings.size(); ++i) {
        const evidence::SeenFigure& figure = seen.figures[made.network->evidence->figure_of[i]];
        StatedAdjustment::Reading& reading = by_hand.readings[i];
        if (reading.u_length) *reading.u_length *= figure.factor;
        if (reading.u_angle) *reading.u_angle *= figure.factor;
        EXPECT_EQ(made.network->readings[i].degrees_of_freedom, figure.degrees_of_freedom);
    }
    const Adjusted other(by_hand);
    ASSERT_TRUE(other.network && other.network->adjusted) << other.words();
    EXPECT_LT((made.network->state - other.network->state).norm(), 1e-9);
    for (std::size_t k = 0; k < made.network->place_of.size(); ++k) {
        const double u = std::sqrt(other.network->adjusted->cofactor(k, k));
        EXPECT_NEAR(std::sqrt(made.network->adjusted->cofactor(k, k)), u, 1e-9 * u);
    }
    const InputSet inputs = adjustment_inputs(*made.network);
    EXPECT_EQ(inputs.variance_estimates.size(), seen.figures.size());
    for (const UncertaintyComponent& component : inputs.components)
        EXPECT_EQ(component.type, EvaluationType::type_a);
}

TEST(AdjustedEvidence, OneFactorIsSNoughtWithItsDegreesOfFreedom) {
    const TrueNetwork net = rich_hall();
    const Adjusted stated(net.stated);
    ASSERT_TRUE(stated.network && stated.network->adjusted) << stated.words();
    const adjustment::Reliability& found = reliability_of(*stated.network);
    const Adjusted made = as_seen(net.stated, UncertaintiesFrom::one_factor);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_LT((made.network->state - stated.network->state).norm(), 1e-9);
    for (std::size_t k = 0; k < made.network->place_of.size(); ++k)
        EXPECT_NEAR(made.network->adjusted->cofactor(k, k),
                    found.s0 * found.s0 * stated.network->adjusted->cofactor(k, k),
                    1e-9 * made.network->adjusted->cofactor(k, k));
    for (const AdjustedReading& reading : made.network->readings)
        EXPECT_EQ(reading.degrees_of_freedom, found.degrees_of_freedom);
}

TEST(AdjustedEvidence, AFigureWithTooLittleRedundancyStaysAsStatedAndIsNamed) {
    const TrueNetwork net = hall(CoordinateRole::fixed, {});
    const Adjusted made = as_seen(net.stated, UncertaintiesFrom::seen);
    ASSERT_TRUE(made.network && made.network->adjusted) << made.words();
    EXPECT_NE(made.words().find("Too little redundancy to say, so they stay as stated:"), std::string::npos)
        << made.words();
    for (std::size_t i = 0; i < made.network->readings.size(); ++i)
        if (std::isinf(made.network->readings[i].degrees_of_freedom)) {
            EXPECT_EQ(made.network->readings[i].factor, 1.0);
        }
}

}  // namespace
}  // namespace covaria::network
