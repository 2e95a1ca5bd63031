// Capability "ballbars": telescopic ballbars that measure the lengths from their supports to one ball at
// once.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/math/multilateration.h"
#include "core/model/capability.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

inline constexpr std::size_t most_supports = 12;

/// A measured length between two supports (indices from 0).
struct SupportLength {
    std::size_t from = 0, to = 0;
    double length = 0.0;             ///< m
    UncertaintyComponent component;  ///< its id is completed by the model
};

/// Height of a support after the third above the plane of the first three.
struct SupportHeight {
    double z = 0.0;  ///< m
    UncertaintyComponent component;
};

/// A deviation that several lengths share: scale of all, constant of one bar.
struct SharedLengthDeviation {
    UncertaintyComponent component;
    bool is_scale = false;  ///< relative, of every length; else constant, of `bar` alone
    std::size_t bar = 0;
};

class BallbarSource : public Capability {
public:
    static constexpr const char* capability = "ballbars";
    virtual std::size_t supports() const = 0;  ///< number of supports and of bars: three or more
    /// 1-2, 1-3, 2-3, then 1-k, 2-k and 3-k for every further support.
    virtual const std::vector<SupportLength>& support_lengths() const = 0;
    virtual const std::vector<SupportHeight>& heights() const = 0;  ///< one for every support after the third
    /// Root of Eq 3 that holds: 1 = the ball is on the side to which z points, -1 = on the other.
    virtual double side() const = 0;
    /// The instrument's frame (origin support 1, x to support 2, z normal to the first three) in the robot's.
    virtual const Eigen::Isometry3d& placement() const = 0;
    /// Deviation of one reading, independent of all others.
    virtual UncertaintyComponent reading(std::size_t bar, double length) const = 0;
    virtual const std::vector<SharedLengthDeviation>& shared() const = 0;
};

/// Coordinates of all supports in the instrument's frame (Brosed et al., Eqs 4 to 7), the further ones by
/// least squares of their three lengths at the given height. `lengths` as support_lengths(); not finite for
/// impossible ones.
template <class Real>
void support_positions(std::span<const Real> lengths, std::span<const Real> heights, Vector3<Real>* found) {
    const SupportTriangle<Real> triangle = support_triangle<Real>(lengths[0], lengths[1], lengths[2]);
    const Real zero(0.0);
    found[0] = Vector3<Real>(zero, zero, zero);
    found[1] = Vector3<Real>(triangle.x2, zero, zero);
    found[2] = Vector3<Real>(triangle.x3, triangle.y3, zero);
    const Trilateration<Real> by_three(triangle);
    constexpr double equal[] = {1.0, 1.0, 1.0};
    for (std::size_t k = 0; k < heights.size(); ++k) {
        const Real* L = &lengths[3 + 3 * k];
        Vector3<Real> p = by_three.level(L[0] * L[0], L[1] * L[1], L[2] * L[2]);
        p[2] = heights[k];
        for (int step = 0; step < multilateration_steps; ++step)
            multilateration_step<Real>({found, 3}, L, equal, 2, p);
        found[3 + k] = p;
    }
}

/// The same at the estimates.
std::vector<Eigen::Vector3d> support_positions(const BallbarSource& ballbars);

}  // namespace covaria
