// Best measurement capability of a laboratory: the smallest U that it may state for a quantity.
#pragma once

#include <optional>
#include <string>

#include "core/model/capability.h"
#include "core/model/output_quantity.h"

namespace covaria {

/// Offered by an asset; documents and checks ask for it, models do not.
class BestCapability : public Capability {
public:
    static constexpr const char* capability = "smallest-uncertainty";

    /// Whether it is for results of this symbol and unit.
    virtual bool is_about(const OutputQuantity& output) const = 0;
    /// Symbol of the quantity of which the value decides, as the length in a + b L; empty: the result itself.
    virtual const std::string& over() const = 0;
    /// The smallest expanded uncertainty (SI, for about 95 %) at a value (SI) of that quantity; nullopt: the
    /// value is in none of its ranges.
    virtual std::optional<double> smallest(double value) const = 0;
    /// Whether a smaller U is raised to it; else it may not be stated.
    virtual bool raises() const = 0;
};

}  // namespace covaria
