// Philox against published vectors; addressed uniforms: replay, blocking, range, first moments.
#include "core/random/uniforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random/philox.h"
#include "core/random/uniform_chunks.h"

namespace covaria::uniforms_test {
namespace {

constexpr DrawPurpose purpose = DrawPurpose::trials;

// Known-answer vectors of Random123 (kat_vectors, "philox4x32 10"): zeros, ones, digits of pi.
TEST(Philox, ReproducesPublishedVectors) {
    EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
              (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox4x32({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}),
              (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

/// The definition, one draw at a time.
double uniform_by_definition(std::uint64_t seed, std::uint32_t component, std::uint64_t trial) {
    const std::uint64_t c = trial / 2;
    const PhiloxCounter w =
        philox4x32({static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(c >> 32), component, 0},
                   {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
    const std::size_t half = 2 * (trial % 2);
    const std::uint64_t word = (std::uint64_t{w[half + 1]} << 32) | w[half];
    return (static_cast<double>(word >> 12) + 0.5) * 0x1p-52;
}

TEST(Uniforms, FollowTheirDefinitionAtAnyAddress) {
    for (std::uint64_t first : {0ull, 1ull, 127ull, 999'999ull, 0x1'FFFF'FFF1ull}) {
        std::vector<double> u(300);
        uniforms(0xDEADBEEF12345678u, purpose, 7, first, u);
        for (std::size_t t = 0; t < u.size(); ++t)
            ASSERT_EQ(u[t], uniform_by_definition(0xDEADBEEF12345678u, 7, first + t)) << first << " " << t;
    }
}

TEST(Uniforms, DoNotDependOnBlocking) {
    std::vector<double> whole(1000), pieces(1000);
    uniforms(3, purpose, 5, 10, whole);
    for (std::size_t done = 0, n = 1; done < pieces.size(); done += n, n = std::min(n + 7, 1000 - done))
        uniforms(3, purpose, 5, 10 + done, std::span(pieces).subspan(done, n));
    EXPECT_EQ(whole, pieces);
}

TEST(Uniforms, AreTheSameWithAnyWidthOfVectors) {
    if (!has_avx512()) GTEST_SKIP() << "a processor without AVX-512";
    for (const std::uint64_t counter : {0ull, 63ull, 0xFFFF'FFF0ull, 0xFFFF'FFFF'FFFF'FFF0ull}) {
        const detail::UniformStream stream{0xDEADBEEF12345678u, 0xFFFF'FFFDu, 3};
        std::vector<double> narrow(detail::chunk_trials), wide(detail::chunk_trials);
        detail::fill_chunk(stream, counter, narrow.data());
        detail::fill_chunk_avx512(stream, counter, wide.data());
        EXPECT_EQ(narrow, wide) << counter;
    }
}

TEST(Uniforms, SeedComponentAndPurposeSeparateTheStreams) {
    std::vector<double> a(8), b(8);
    uniforms(1, purpose, 0, 0, a);
    uniforms(2, purpose, 0, 0, b);
    EXPECT_NE(a, b);
    uniforms(1, purpose, 1, 0, b);
    EXPECT_NE(a, b);
    uniforms(1, DrawPurpose::observations, 0, 0, b);
    EXPECT_NE(a, b);
}

TEST(Uniforms, AreUniformAndUncorrelated) {
    const std::size_t n = 1'000'000;
    std::vector<double> u(n), v(n);
    uniforms(11, purpose, 0, 0, u);
    uniforms(11, purpose, 1, 0, v);
    double sum = 0, squares = 0, cross = 0, lag = 0;
    for (std::size_t t = 0; t < n; ++t) {
        ASSERT_GT(u[t], 0.0);
        ASSERT_LT(u[t], 1.0);
        const double d = u[t] - 0.5;
        sum += d;
        squares += d * d;
        cross += d * (v[t] - 0.5);
        if (t > 0) lag += d * (u[t - 1] - 0.5);
    }
    const double m = static_cast<double>(n);
    EXPECT_NEAR(sum / m, 0.0, 4 * std::sqrt(1.0 / 12 / m));
    EXPECT_NEAR(squares / m, 1.0 / 12, 4 * std::sqrt(1.0 / 180 / m));
    EXPECT_NEAR(cross / m, 0.0, 4 / 12.0 / std::sqrt(m));
    EXPECT_NEAR(lag / m, 0.0, 4 / 12.0 / std::sqrt(m));
}

}  // namespace
}  // namespace covaria::uniforms_test
