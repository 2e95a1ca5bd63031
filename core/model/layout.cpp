// Layouts of assets as parts of other layouts.
#include "core/model/layout.h"

namespace covaria {

Layout as_part(Layout layout, const std::string& asset) {
    const auto mark = [&](LayoutSource& source) {
        if (!source.path.empty() && source.asset.empty()) source.asset = asset;
    };
    for (LayoutFrame& frame : layout.frames) mark(frame.source);
    for (LayoutPoint& point : layout.points) mark(point.source);
    for (LayoutBody& body : layout.bodies) mark(body.source);
    return layout;
}

}  // namespace covaria
