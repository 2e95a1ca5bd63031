// The button of the scene's tool bar with the layers that the picture shows.
#pragma once

class QToolButton;
class QWidget;

namespace covaria::ui {

class SceneView;

QToolButton* layers_button(SceneView& view, QWidget* parent);

}  // namespace covaria::ui
