// The pair that a place among the correlations of an analysis names.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/project/project.h"

namespace covaria::ui {

using CorrelatedPair = std::pair<std::string, std::string>;  ///< ids of components, or symbols

/// Part of an analysis under which the texts of correlations are kept that cannot be read.
inline constexpr const char* correlations_part = "/correlations/";
/// "/correlations/a.1|b.1", whatever the order of the two.
std::string part_of_pair(const std::string& first, const std::string& second);
/// Pair that such a part names. Empty: it names none.
std::optional<CorrelatedPair> pair_of(const std::string& part);

/// Pair that such a part names, or one that names a correlation by number ("/correlations/3/coefficient").
/// Empty: it names none.
std::optional<CorrelatedPair> pair_in(const AnalysisEntry& analysis, const std::string& part);

}  // namespace covaria::ui
