#include "ui/models/category_icon.h"

namespace covaria::ui {

QString category_icon(AssetCategory category) {
    switch (category) {
        case AssetCategory::artefact:
            return QStringLiteral("artefact");
        case AssetCategory::instrument:
            return QStringLiteral("instrument");
        case AssetCategory::robot:
            return QStringLiteral("robot");
        case AssetCategory::points:
            return QStringLiteral("points");
        case AssetCategory::context:
            return QStringLiteral("layers");
        case AssetCategory::laboratory:
            return QStringLiteral("units");
    }
    return {};
}

}  // namespace covaria::ui
