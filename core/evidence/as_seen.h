// The standard uncertainties that readings are used with: as stated, or as their own residuals see them.
#pragma once

#include <limits>
#include <vector>

#include "core/evidence/seen.h"

namespace covaria::evidence {

enum class UncertaintiesFrom {
    stated,
    one_factor,  ///< the stated ones of all figures times one factor
    seen,        ///< the stated ones times what the residuals see of each figure
};

/// Of one figure; infinite degrees of freedom: it stays as stated.
struct TakenFactor {
    double factor = 1.0;
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
    bool is_seen() const { return degrees_of_freedom < std::numeric_limits<double>::infinity(); }
};

struct AsSeen {
    std::vector<TakenFactor> factors = {};  ///< of each figure
    Message kept = {};                      ///< what stays as stated, and why; empty: nothing does
    bool has_any() const;
};

/// One factor has the degrees of freedom of all figures together, however few; of figures by themselves only
/// those are taken that `is_known` says. Readings that rest on no figure stay as stated.
AsSeen as_seen(const RedundantReadings& readings, UncertaintiesFrom from);

}  // namespace covaria::evidence
