// Vectors of random direction: the law of their length, the distribution of one coordinate, joint draws.
//
// The direction is uniform on the sphere, so each coordinate is the length times a number rectangular in
// [-1, 1] (Archimedes), the coordinates are uncorrelated, and the distribution of one of them determines the
// law of the length. The law of propagation needs the coordinates alone; Monte Carlo draws all three
// together.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/quantity/input_quantity.h"

namespace covaria {

/// Law of the length r of the vector, for a largest length a.
enum class RadialLaw {
    uniform_length,  ///< r rectangular in [0, a]; u of a coordinate a/3
    ball,            ///< every point of the ball equally probable; u of a coordinate a/sqrt(5)
    sphere,          ///< r = a; u of a coordinate a/sqrt(3)
};

struct VectorLength {
    RadialLaw law = RadialLaw::sphere;
    double largest = 0.0;
    double mean() const;                ///< mean length
    double standard_deviation() const;  ///< standard deviation of the length
};

/// Distribution of one coordinate: curvilinear trapezoid with a triangle-like peak, beta (2, 2), rectangular.
Distribution coordinate_distribution(const VectorLength& length);
/// The law whose coordinates are distributed so; empty: none, or a length of zero.
std::optional<VectorLength> length_law_of(const Distribution& coordinate);

/// A vector of the set whose components (all three the same) have such a distribution.
struct DrawnVector {
    std::array<std::size_t, 3> components{};
    VectorLength length;
};
std::vector<DrawnVector> vectors_of_random_direction(const InputSet& inputs);

/// Turns three rows of numbers from (0, 1) into x, y and z. Trial t depends on its own three numbers only;
/// the rows have the same length, a multiple of the lanes of vector code. No allocation.
void draw_directions(const VectorLength& length, std::array<std::span<double>, 3> rows);

}  // namespace covaria
