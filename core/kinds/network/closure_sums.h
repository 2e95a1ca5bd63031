// Closures as they are collected: sums and functions of readings that would be 0 without deviations.
#pragma once

#include <functional>
#include <map>
#include <span>

#include "core/kinds/network/adjusted_closures.h"

namespace covaria::network {

/// A reading with its sign in a sum of readings that would be 0 without deviations.
struct SignedReading {
    std::size_t reading = 0;
    double sign = 1.0;
};

class ClosureSums {
public:
    explicit ClosureSums(const AdjustedNetwork& network);

    const AdjustedNetwork& network;

    /// Adds a sum of readings; what it is about is said by the last of them. Nothing is added where the sum
    /// has no uncertainty.
    void add(Message words, const std::vector<SignedReading>& readings, double misclosure);

    /// The value of each reading of the network, which a function may change while it is differentiated.
    using Values = std::vector<double>;
    const Values& values() const { return values_; }
    /// Adds a function of the readings, linearised over their u. Nothing is added where it has no value.
    void add(Message words, const std::vector<std::size_t>& readings,
             const std::function<double(const Values&)>& function);

    /// The standard uncertainty of a sum of readings, with their correlations.
    double u_of(const std::vector<SignedReading>& readings) const;
    /// The reading that states this figure of an instrument; `none` where none does.
    std::size_t stated(std::size_t figure) const { return stated_[figure]; }
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// All closures, the largest for its u first.
    std::vector<Closure> take();

private:
    std::map<std::pair<std::size_t, std::size_t>, double> correlations_;
    std::vector<std::size_t> stated_;
    Values values_;
    std::vector<Closure> found_;
};

/// Compares the readings of the two faces of a sight with each other, and with index and collimation as
/// stated.
void compare_faces(ClosureSums& sums);
/// Compares what two sights of one station say of their targets with what is known of the two: a length or
/// height difference that was read, coordinates, the sights from another station (double targets).
void compare_double_targets(ClosureSums& sums);
/// Closes loops of distances: three of which one is longer than the others together, or on a line; six
/// between four points of a plane, ten between five in space.
void close_distances(ClosureSums& sums);

}  // namespace covaria::network
