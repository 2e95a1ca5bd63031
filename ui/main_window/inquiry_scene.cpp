#include "ui/main_window/inquiry_scene.h"

#include "ui/document/selection.h"
#include "ui/pages/design_tab.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/stage.h"
#include "ui/pages/study_tab.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

void show_inquiry(ResultsPane& results, ScenePanel& scene) {
    const StudyTab& tab = results.study_tab();
    const bool on_top = results.stage().shows(tab);
    StudySceneOptions wanted;
    wanted.quantity = tab.view().quantity;
    wanted.ellipsoids = tab.wants_ellipsoids();
    if (on_top && tab.study() && tab.study()->axes.size() == 3 && tab.wants_slice()) {
        wanted.slice_axis = tab.view().fixed_axis;
        wanted.slice = tab.view().slice;
    }
    scene.show_study(on_top ? tab.study() : nullptr, wanted);
    const DesignTab& designs = results.design_tab();
    const bool design_on_top = results.stage().shows(designs);
    const bool in_space = design_on_top && designs.result() && stands_in_space(*designs.result());
    scene.show_design(in_space ? designs.result() : nullptr,
                      designs.is_current() ? QString() : tr("out of date"));
}

}  // namespace

void show_inquiries_in_scene(ResultsPane& results, ScenePanel& scene) {
    const auto show = [&results, &scene] { show_inquiry(results, scene); };
    QObject::connect(&results.study_tab(), &StudyTab::shown_changed, &scene, show);
    QObject::connect(&results.design_tab(), &DesignTab::shown_changed, &scene, show);
    QObject::connect(&results.stage(), &Stage::changed, &scene, show);
}

void show_assets_in_scene(Selection& selection, ScenePanel& scene) {
    QObject::connect(&selection, &Selection::entry_changed, &scene, [&selection, &scene] {
        const SetupAddress& entry = selection.entry();
        scene.show_asset(entry.owner == SetupOwner::asset ? entry.id : std::string());
    });
}

}  // namespace covaria::ui
