// Vectors of random direction: laws of the length, distributions of a coordinate, joint draws.
#include "core/quantity/isotropic_vector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random/uniforms.h"

namespace covaria::isotropic_vector_test {
namespace {

constexpr RadialLaw laws[] = {RadialLaw::uniform_length, RadialLaw::ball, RadialLaw::sphere};
constexpr std::size_t trials = 200'000;

/// Rows x, y, z.
std::array<std::vector<double>, 3> drawn(const VectorLength& length) {
    std::array<std::vector<double>, 3> rows;
    std::array<std::span<double>, 3> spans;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        rows[axis].resize(trials);
        spans[axis] = rows[axis];
        uniforms(7, DrawPurpose::trials, axis, 0, spans[axis]);
    }
    draw_directions(length, spans);
    return rows;
}

TEST(IsotropicVector, CoordinatesHaveTheVarianceOfTheLaw) {
    const double expected[] = {1.0 / 9.0, 1.0 / 5.0, 1.0 / 3.0};
    for (std::size_t k = 0; k < 3; ++k) {
        const double u = coordinate_distribution({laws[k], 2.0}).standard_uncertainty();
        EXPECT_NEAR(u * u, 4.0 * expected[k], 1e-14);
    }
}

TEST(IsotropicVector, TheDistributionOfACoordinateTellsTheLaw) {
    for (const RadialLaw law : laws) {
        const auto found = length_law_of(coordinate_distribution({law, 0.02}));
        ASSERT_TRUE(found);
        EXPECT_EQ(found->law, law);
        EXPECT_DOUBLE_EQ(found->largest, 0.02);
    }
    EXPECT_FALSE(length_law_of(Distribution::normal(1.0)));
    EXPECT_FALSE(length_law_of(Distribution::of(Rectangular{-1.0, 2.0})));
    EXPECT_FALSE(length_law_of(Distribution::of(Rectangular{0.0, 0.0})));
}

TEST(IsotropicVector, DrawnCoordinatesFollowTheirDistribution) {
    for (const RadialLaw law : laws) {
        const VectorLength length{law, 3.0};
        const Distribution expected = coordinate_distribution(length);
        const auto rows = drawn(length);
        for (const std::vector<double>& row : rows)
            for (const double p : {0.02, 0.2, 0.5, 0.7, 0.95}) {
                std::size_t below = 0;
                for (const double x : row) below += x < expected.quantile(p);
                EXPECT_NEAR(static_cast<double>(below) / trials, p, 4.0 * std::sqrt(p * (1.0 - p) / trials));
            }
    }
}

TEST(IsotropicVector, LengthsFollowTheLawAndCoordinatesAreUncorrelated) {
    for (const RadialLaw law : laws) {
        const VectorLength length{law, 3.0};
        const auto rows = drawn(length);
        double sum = 0.0, squares = 0.0, product = 0.0, largest = 0.0, fourth = 0.0;
        for (std::size_t t = 0; t < trials; ++t) {
            const double r = std::hypot(rows[0][t], rows[1][t], rows[2][t]);
            sum += r;
            squares += r * r;
            largest = std::max(largest, r);
            product += rows[0][t] * rows[1][t];
            fourth += std::pow(rows[0][t] * rows[1][t], 2);
        }
        const double mean = sum / trials,
                     deviation = std::sqrt(std::max(0.0, squares / trials - mean * mean));
        const double error = length.standard_deviation() / std::sqrt(trials);
        EXPECT_NEAR(mean, length.mean(), 4.0 * error + 1e-12);
        EXPECT_NEAR(deviation, length.standard_deviation(), 4.0 * error + 1e-6);
        EXPECT_LE(largest, 3.0 * (1.0 + 1e-14));
        EXPECT_NEAR(product / trials, 0.0, 4.0 * std::sqrt(fourth / trials / trials));
    }
}

TEST(IsotropicVector, EditedCoordinatesAreNoVectorAnyMore) {
    InputSet inputs;
    for (const char* const id : {"x", "y", "z"})
        inputs.add({.id = id, .distribution = coordinate_distribution({RadialLaw::ball, 1.0})});
    inputs.vectors.push_back({{0, 1, 2}});
    EXPECT_EQ(vectors_of_random_direction(inputs).size(), 1u);
    inputs.correlations.push_back({0, 1, 0.5});
    const auto refused = resolved_correlations(inputs);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.english().find("random direction"), std::string::npos);
    inputs.components[0].distribution = Distribution::normal(1.0);
    EXPECT_TRUE(vectors_of_random_direction(inputs).empty());
    EXPECT_TRUE(resolved_correlations(inputs));
}

}  // namespace
}  // namespace covaria::isotropic_vector_test
