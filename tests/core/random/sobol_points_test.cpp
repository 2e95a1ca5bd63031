// Sobol points: each dimension of a batch meets every cell once, whatever the shift; any trial by itself.
#include "core/random/sobol_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace covaria::sobol_points_test {
namespace {

constexpr std::size_t batch = 256;

std::vector<double> row(const SobolPoints& points, std::uint32_t address, std::uint64_t first,
                        std::size_t count) {
    std::vector<double> u(count);
    points.fill(DrawPurpose::trials, address, first, u);
    return u;
}

std::size_t cell(double u, std::size_t cells) {
    return static_cast<std::size_t>(u * static_cast<double>(cells));
}

TEST(SobolPoints, EachDimensionMeetsEveryCellOnce) {
    const SobolPoints points(7, 150, 2, batch);
    for (const std::uint32_t address : {0u, 1u, 2u, 77u, 149u})
        for (const std::uint64_t number : {0u, 1u, 5u}) {
            std::set<std::size_t> cells;
            for (const double u : row(points, address, number * batch, batch)) {
                EXPECT_TRUE(u > 0.0 && u < 1.0);
                cells.insert(cell(u, batch));
            }
            EXPECT_EQ(cells.size(), batch) << address;
        }
}

/// The first two dimensions are a (0, 2)-sequence: 16 x 16 cells, one point each.
TEST(SobolPoints, PairsOfTheFirstDimensionsMeetEverySquare) {
    const SobolPoints points(3, 2, 0, batch);
    const auto a = row(points, 0, batch, batch), b = row(points, 1, batch, batch);
    std::set<std::pair<std::size_t, std::size_t>> squares;
    for (std::size_t t = 0; t < batch; ++t) squares.insert({cell(a[t], 16), cell(b[t], 16)});
    EXPECT_EQ(squares.size(), batch);
}

TEST(SobolPoints, ATrialDependsOnItsAddressAlone) {
    const SobolPoints points(11, 4, 1, batch);
    const auto whole = row(points, 2, 0, 3 * batch);
    for (std::size_t first = 0; first < 3 * batch; first += 97) {
        const std::size_t count = std::min<std::size_t>(97, 3 * batch - first);
        const auto part = row(points, 2, first, count);
        for (std::size_t t = 0; t < count; ++t) EXPECT_EQ(part[t], whole[first + t]);
    }
    EXPECT_NE(row(points, 2, 0, 1), row(points, 2, batch, 1));                    // another shift
    EXPECT_NE(row(points, 2, 0, 1), row(SobolPoints(12, 4, 1, batch), 2, 0, 1));  // another seed
    std::vector<double> estimate(1), component(1);
    points.fill(DrawPurpose::variance_estimates, 0, 0, estimate);
    points.fill(DrawPurpose::trials, 0, 0, component);
    EXPECT_NE(estimate, component);
}

/// Beyond the table of direction numbers there are plain draws.
TEST(SobolPoints, HaveNoLimitOfDimensions) {
    const SobolPoints points(5, 5000, 0, batch);
    std::vector<double> plain(10);
    uniforms(5, DrawPurpose::trials, 4000, 20, plain);
    EXPECT_EQ(row(points, 4000, 20, 10), plain);
}

}  // namespace
}  // namespace covaria::sobol_points_test
