#include "viz/scene/context_meshes.h"

namespace covaria {

std::vector<LayoutMesh> context_meshes(const MadeProject& made) {
    std::vector<LayoutMesh> meshes;
    for (const AssetEntry& entry : made.project().assets) {
        const AssetLibrary::Entry* found = made.assets().find(entry.id);
        if (!found || !found->asset) continue;
        for (LayoutMesh& mesh : as_part(found->asset->layout(), entry.id).meshes) {
            mesh.name = entry.name.empty() ? entry.id : entry.name;
            meshes.push_back(std::move(mesh));
        }
    }
    return meshes;
}

}  // namespace covaria
