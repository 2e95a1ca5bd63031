// Parts of assets and analyses that no number depends on: names, notes, requirements, designs, certificates.
#pragma once

#include "core/project/project.h"

namespace covaria {

/// Gives an entry the asides of another. Studies are none: their own results are numbers.
void take_asides(AssetEntry& entry, const AssetEntry& from);
void take_asides(AnalysisEntry& entry, const AnalysisEntry& from);

}  // namespace covaria
