// The picture of an asset by itself, as the library shows it.
#pragma once

#include <filesystem>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria {

/// Draws its body, 400 x 250 pixels. Error{bad_input}: it has problems, or no body to draw.
Result<void> write_asset_picture(const AssetEntry& asset, const std::filesystem::path& file);

}  // namespace covaria
