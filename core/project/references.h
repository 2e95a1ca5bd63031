// References from set-ups to assets.
#pragma once

#include <string>
#include <vector>

#include "core/model/asset.h"
#include "core/project/project.h"

namespace covaria {

struct AssetReference {
    std::string path;   ///< relative to the set-up: "/base_uncertainty"
    std::string title;  ///< of the field
    std::string id;     ///< of the asset
    std::vector<std::string> capabilities;
};

/// Of the fields that are shown, and of the cells of tables, in the order of the schema; empty references are
/// left out.
std::vector<AssetReference> references_of(const SetupSchema& schema, const Setup& setup);

/// Reports references to assets that do not exist, have errors of their own, or lack the capability; an
/// analysis whose model offers it may stand for an asset.
void check_references(const Project& project, const AssetLibrary& assets, const SetupSchema& schema,
                      const Setup& setup, Problems& problems);

}  // namespace covaria
