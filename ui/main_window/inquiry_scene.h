// What the scene shows besides the result of an analysis: the study or design that is on the stage, or the
// selected asset.
#pragma once

namespace covaria::ui {

class ResultsPane;
class ScenePanel;
class Selection;

/// From now on the scene shows the study and the design of which the stage has the view, or none.
void show_inquiries_in_scene(ResultsPane& results, ScenePanel& scene);
/// From now on the scene shows the asset that is selected, while there is no analysis.
void show_assets_in_scene(Selection& selection, ScenePanel& scene);

}  // namespace covaria::ui
