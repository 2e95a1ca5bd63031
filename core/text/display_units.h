// Units in which results are shown, chosen per dimension: an argument of every view.
#pragma once

#include <vector>

#include "core/base/unit.h"

namespace covaria {

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

}  // namespace covaria
