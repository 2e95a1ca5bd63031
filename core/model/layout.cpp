// Layouts of assets as parts of other layouts.
#include "core/model/layout.h"

namespace covaria {

bool LayoutMesh::looks_like(const LayoutMesh& other) const {
    return name == other.name && triangles == other.triangles && scale == other.scale &&
           X_WM.matrix() == other.X_WM.matrix() && colour == other.colour && opacity == other.opacity;
}

Layout as_part(Layout layout, const std::string& asset) {
    const auto mark = [&](LayoutSource& source) {
        if (!source.path.empty() && source.asset.empty()) source.asset = asset;
    };
    for (LayoutFrame& frame : layout.frames) mark(frame.source);
    for (LayoutPoint& point : layout.points) mark(point.source);
    for (LayoutBody& body : layout.bodies) mark(body.source);
    for (LayoutMesh& mesh : layout.meshes) mark(mesh.source);
    return layout;
}

}  // namespace covaria
