// The icon of a category of assets, for those without one of their own.
#pragma once

#include <QString>

#include "core/model/asset.h"

namespace covaria::ui {

/// Name of the icon, as `icon` (ui/theme/icons.h) takes it.
QString category_icon(AssetCategory category);

}  // namespace covaria::ui
