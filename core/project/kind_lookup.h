// The registries by what is asked of them here: the schema of a kind, the known names for messages.
#pragma once

#include <string>

#include "core/project/project.h"
#include "core/setup/setup_schema.h"

namespace covaria {

const SetupSchema* schema_of(const AssetEntry& asset);        ///< null: unknown kind
const SetupSchema* schema_of(const AnalysisEntry& analysis);  ///< null: unknown model
/// "there is no kind of asset 'robto' (did you mean 'robot'?); known are ..."
Message unknown_kind(const AssetEntry& asset);
Message unknown_model(const AnalysisEntry& analysis);

}  // namespace covaria
