// The study or design that is on the stage, in the scene: its map, its places.
#pragma once

namespace covaria::ui {

class ResultsPane;
class ScenePanel;

/// Shows the study and the design of which the stage has the view, or none.
void show_inquiry_in_scene(ResultsPane& results, ScenePanel& scene);

}  // namespace covaria::ui
