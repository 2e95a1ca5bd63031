// Capability of a robot: how far a robot misses a pose that it was sent to before, each time anew.
#pragma once

#include <array>
#include <optional>

#include "core/model/capability.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

class RepeatabilitySource : public Capability {
public:
    static constexpr const char* capability = "repeatability";
    /// Deviations of the position along three perpendicular axes, whatever these are, in m. They are the
    /// coordinates of a vector of random direction (IsotropicVector). Ids "x", "y", "z".
    virtual std::array<UncertaintyComponent, 3> position() const = 0;
    /// Rotations about the flange's axes in rad, independent of each other; empty: not stated.
    virtual std::optional<std::array<UncertaintyComponent, 3>> orientation() const = 0;
};

}  // namespace covaria
