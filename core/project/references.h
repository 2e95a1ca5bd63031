// References from set-ups to assets.
#pragma once

#include <string>
#include <vector>

#include "core/setup/setup_schema.h"

namespace covaria {

struct AssetReference {
    std::string path;   ///< place relative to the set-up: "/base_uncertainty"
    std::string title;  ///< title of the field
    std::string id;     ///< id of the asset
    std::vector<std::string> capabilities;
};

/// The references of the fields that are shown, and of the cells of tables, in the order of the schema; empty
/// references are left out.
std::vector<AssetReference> references_of(const SetupSchema& schema, const Setup& setup);

}  // namespace covaria
