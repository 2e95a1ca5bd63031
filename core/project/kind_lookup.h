// The registries by the questions asked of them here: the schema of a kind, the known names for messages.
#pragma once

#include <string>

#include "core/project/project.h"
#include "core/setup/setup_schema.h"

namespace covaria {

const SetupSchema* schema_of(const AssetEntry& asset);        ///< null for an unknown kind
const SetupSchema* schema_of(const AnalysisEntry& analysis);  ///< null for an unknown model
/// A message such as "there is no kind of asset 'robto' (did you mean 'robot'?); known are ...".
Message unknown_kind(const AssetEntry& asset);
Message unknown_model(const AnalysisEntry& analysis);

}  // namespace covaria
