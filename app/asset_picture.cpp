#include "app/asset_picture.h"

#include "core/made/made_project.h"
#include "viz/scene/asset_scene.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria {

Result<void> write_asset_picture(const AssetEntry& asset, const std::filesystem::path& file) {
    Project project;
    project.assets.push_back(asset);
    const MadeProject::Pointer made = MadeProject::make(std::move(project));
    const AssetLibrary::Entry* entry = made->assets().find(asset.id);
    if (!entry || !entry->asset)
        return fail(ErrorCode::bad_input, first_error(made->problems(), "the asset cannot be made"));
    SceneOptions options;
    options.labels = false;
    auto scene = asset_scene(*entry->asset, options);
    if (!scene) return fail(ErrorCode::bad_input, asset.name + " has no body to draw");
    SceneRenderer renderer;
    renderer.set_size(400, 250);
    renderer.set_scene(*std::move(scene));
    // An instrument's drawing has no size of its own: no axes and no scale.
    if (entry->asset->layout().links.empty()) {
        LayerVisibility layers = renderer.layers();
        for (const Layer layer : {Layer::axes, Layer::legend, Layer::labels}) layers[layer] = false;
        renderer.set_layers(layers);
    }
    renderer.set_view(*standard_view_from("iso"));
    const auto image = renderer.render(RenderQuality::fine);
    if (!image) return fail(image.error());
    return write_png(*image, file);
}

}  // namespace covaria
