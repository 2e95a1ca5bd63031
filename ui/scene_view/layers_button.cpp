#include "ui/scene_view/layers_button.h"

#include <QMenu>
#include <QToolButton>
#include <memory>
#include <utility>

#include "ui/scene_view/scene_panel.h"
#include "ui/theme/icons.h"

namespace covaria::ui {

QToolButton* layers_button(SceneView& view, QWidget* parent) {
    const std::pair<Layer, QString> layers[] = {
        {Layer::frames, ScenePanel::tr("Frames")},
        {Layer::points, ScenePanel::tr("Points")},
        {Layer::bodies, ScenePanel::tr("Bodies")},
        {Layer::links, ScenePanel::tr("Links and Sight Lines")},
        {Layer::vectors, ScenePanel::tr("Vectors")},
        {Layer::ellipsoids, ScenePanel::tr("Ellipsoids")},
        {Layer::clouds, ScenePanel::tr("Clouds")},
        {Layer::wall_histograms, ScenePanel::tr("Histograms on the Walls")},
        {Layer::labels, ScenePanel::tr("Labels")},
        {Layer::axes, ScenePanel::tr("Axes")},
        {Layer::legend, ScenePanel::tr("Legend")},
        {Layer::map, ScenePanel::tr("Map of a Study or Design")},
        {Layer::ellipsoids_before, ScenePanel::tr("Ellipsoids of the Kept State")},
        {Layer::meshes, ScenePanel::tr("Context Meshes")}};
    auto* button = new QToolButton(parent);
    auto* menu = new QMenu(button);
    const auto chosen = std::make_shared<LayerVisibility>();
    for (const auto& [layer, text] : layers) {
        QAction* action = menu->addAction(text);
        action->setCheckable(true);
        action->setChecked((*chosen)[layer]);
        QObject::connect(action, &QAction::toggled, &view, [&view, chosen, layer = layer](bool shown) {
            (*chosen)[layer] = shown;
            view.set_layers(*chosen);
        });
    }
    button->setAccessibleName(ScenePanel::tr("Layers"));
    button->setIcon(icon(QStringLiteral("layers")));
    button->setToolTip(ScenePanel::tr("Layers: what the picture shows"));
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    return button;
}

}  // namespace covaria::ui
