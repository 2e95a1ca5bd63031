// Units in which results are shown, chosen per dimension.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/base/unit.h"
#include "core/result/uncertainty_result.h"

namespace covaria::ui {

class DisplayUnits {
public:
    void choose(const Unit& unit);
    void clear() { chosen_.clear(); }
    const std::vector<Unit>& chosen() const { return chosen_; }
    /// The chosen unit of the dimension of `unit`, or `unit` itself.
    const Unit& of(const Unit& unit) const;

    /// Usual units of the same dimension, always in the same order; `unit` first if it is not among them.
    static std::vector<Unit> choices(const Unit& unit);

private:
    std::vector<Unit> chosen_;
};

/// The same result with its output quantities in the chosen units: for charts. Null stays null.
std::shared_ptr<const UncertaintyResult> in_units(const std::shared_ptr<const UncertaintyResult>& result,
                                                  const DisplayUnits& units);

}  // namespace covaria::ui
