// The scene of a study: its grid points in space, coloured, with the layout of the analysis around them.
#pragma once

#include "core/made/prepared_analysis.h"
#include "core/result/study_result.h"
#include "viz/scene/build_scene.h"

namespace covaria {

struct StudySceneOptions {
    std::size_t quantity = 0;                    ///< index into study_quantities
    std::optional<std::size_t> slice_axis = {};  ///< only the points of one slice across this axis ...
    std::size_t slice = 0;                       ///< ... with this index are drawn as points
    bool ellipsoids = false;                     ///< draws ellipsoids at the drawn points
    bool surfaces = true;                        ///< iso-surfaces where the grid fills a volume
};

/// Pure data. A study whose outputs have no point in space, or none that moves, gives the layout alone with a
/// caption that says so. `options`: probability and magnification of the ellipsoids.
Scene study_scene(const PreparedAnalysis& analysis, const StudyResult& study, const StudySceneOptions& wanted,
                  const SceneOptions& options);

}  // namespace covaria
