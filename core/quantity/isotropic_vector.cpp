// Vectors of random direction: from the distribution of a coordinate to the law of the length, and draws.
#include "core/quantity/isotropic_vector.h"

#include <cmath>
#include <numbers>
#include <xsimd/xsimd.hpp>

#include "core/math/batch_transform.h"

namespace covaria {

namespace {

using Batch = xsimd::batch<double>;

std::optional<VectorLength> law_of(const CurvilinearTrapezoid& c) {
    // The density ln(a/|x|)/(2a) of a product of two rectangular variables is the limit without a flat top.
    const bool peaked = c.low == -c.high && c.inexactness == c.high;
    return peaked ? std::optional(VectorLength{RadialLaw::uniform_length, 2.0 * c.high}) : std::nullopt;
}
std::optional<VectorLength> law_of(const Beta& b) {
    const bool parabola = b.low == -b.high && b.alpha == 2.0 && b.beta == 2.0;
    return parabola ? std::optional(VectorLength{RadialLaw::ball, b.high}) : std::nullopt;
}
std::optional<VectorLength> law_of(const Rectangular& r) {
    return r.low == -r.high ? std::optional(VectorLength{RadialLaw::sphere, r.high}) : std::nullopt;
}
std::optional<VectorLength> law_of(const auto&) {
    return {};
}

struct Angle {
    Batch sine, cosine;
};

/// The angle 2 pi (v - 1/2), by a Taylor polynomial for a quarter of it: the library's functions may take
/// another route for a lane when its neighbours change.
Angle whole_turn(Batch v) {
    static constexpr std::array<double, 9> taylor{1.0,
                                                  -1.0 / 6,
                                                  1.0 / 120,
                                                  -1.0 / 5040,
                                                  1.0 / 362880,
                                                  -1.0 / 39916800,
                                                  1.0 / 6227020800,
                                                  -1.0 / 1307674368000,
                                                  1.0 / 355687428096000};
    const Batch quarter = Batch(0.5 * std::numbers::pi) * (v - Batch(0.5));
    Batch s = quarter * polynomial(taylor, quarter * quarter);
    Batch c = xsimd::sqrt(Batch(1.0) - s * s);
    for (int doubling = 0; doubling < 2; ++doubling) {
        const Batch cosine = Batch(1.0) - Batch(2.0) * s * s;
        s = Batch(2.0) * s * c;
        c = cosine;
    }
    return {s, c};
}

Batch length_at(RadialLaw law, Batch p) {
    switch (law) {
        case RadialLaw::uniform_length:
            return p;
        case RadialLaw::ball:
            return xsimd::exp(xsimd::log(p) * Batch(1.0 / 3.0));
        case RadialLaw::sphere:
            return Batch(1.0);
    }
    return p;
}

}  // namespace

double VectorLength::mean() const {
    static constexpr double of_one[] = {0.5, 0.75, 1.0};
    return largest * of_one[static_cast<int>(law)];
}

double VectorLength::standard_deviation() const {
    static constexpr double variance_of_one[] = {1.0 / 12.0, 3.0 / 80.0, 0.0};
    return largest * std::sqrt(variance_of_one[static_cast<int>(law)]);
}

Distribution coordinate_distribution(const VectorLength& length) {
    const double a = length.largest;
    switch (length.law) {
        case RadialLaw::uniform_length:
            return Distribution::of(CurvilinearTrapezoid{-0.5 * a, 0.5 * a, 0.5 * a});
        case RadialLaw::ball:
            return Distribution::of(Beta{-a, a, 2.0, 2.0});
        case RadialLaw::sphere:
            return Distribution::of(Rectangular{-a, a});
    }
    return {};
}

std::optional<VectorLength> length_law_of(const Distribution& coordinate) {
    if (coordinate.location() != 0.0 || coordinate.factor() != 1.0) return {};
    const auto found = std::visit([](const auto& p) { return law_of(p); }, coordinate.parameters());
    return found && found->largest > 0.0 ? found : std::nullopt;
}

std::vector<DrawnVector> vectors_of_random_direction(const InputSet& inputs) {
    std::vector<DrawnVector> drawn;
    for (const IsotropicVector& vector : inputs.vectors) {
        const auto distribution = [&](std::size_t axis) -> const Distribution& {
            return inputs.components.at(vector.components[axis]).distribution;
        };
        const bool alike = distribution(0) == distribution(1) && distribution(1) == distribution(2);
        if (const auto length = alike ? length_law_of(distribution(0)) : std::nullopt)
            drawn.push_back({vector.components, *length});
    }
    return drawn;
}

void draw_directions(const VectorLength& length, std::array<std::span<double>, 3> rows) {
    for (std::size_t t = 0; t < rows[0].size(); t += Batch::size) {
        const Batch r = Batch(length.largest) * length_at(length.law, Batch::load_unaligned(&rows[0][t]));
        const Batch z = Batch(2.0) * Batch::load_unaligned(&rows[1][t]) - Batch(1.0);
        const Angle azimuth = whole_turn(Batch::load_unaligned(&rows[2][t]));
        const Batch level = r * xsimd::sqrt(Batch(1.0) - z * z);
        (level * azimuth.cosine).store_unaligned(&rows[0][t]);
        (level * azimuth.sine).store_unaligned(&rows[1][t]);
        (r * z).store_unaligned(&rows[2][t]);
    }
}

}  // namespace covaria
