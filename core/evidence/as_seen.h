// The standard uncertainties that readings are used with: as stated, or as their own residuals see them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/evidence/seen.h"

namespace covaria::evidence {

enum class UncertaintiesFrom {
    stated,
    one_factor,  ///< the stated ones of all figures times one factor
    seen,        ///< the stated ones times what the residuals see of each figure
};

/// Factor taken for the u of one figure; infinite degrees of freedom: it stays as stated.
struct TakenFactor {
    double factor = 1.0;
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
    bool is_seen() const { return degrees_of_freedom < std::numeric_limits<double>::infinity(); }
};

struct AsSeen {
    std::vector<TakenFactor> factors = {};  ///< one for each figure
    Message kept = {};                      ///< says what stays as stated, and why; empty: nothing does
    bool has_any() const;
};

/// Takes factors from the residuals. One for all has the degrees of freedom of all figures together, however
/// few; of separate ones only those that `is_known` allows. Readings without a figure stay as stated.
AsSeen as_seen(const RedundantReadings& readings, UncertaintiesFrom from);
/// The same for a set-up, with a warning at `place` of what stays as stated. Null: nothing is redundant; then
/// there are no factors, as where uncertainties are asked for as stated.
AsSeen as_seen(const RedundantReadings* readings, UncertaintiesFrom from, const std::string& place,
               Problems& problems);

}  // namespace covaria::evidence
