// What an asset or an analysis of a project was made into.
#pragma once

#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/made/prepared_analysis.h"
#include "core/model/asset.h"

namespace covaria {

/// Immutable; later states of the project take it over while it stays what it is.
struct MadeEntry {
    virtual ~MadeEntry() = default;
    /// For each reference of the entry (EntryGraph::references): what it refers to; null: nothing, or it is
    /// refused because it refers back.
    std::vector<std::shared_ptr<const MadeEntry>> uses = {};
    /// That it uses, directly or through others, and itself if it is one; those with errors are left out.
    AssetLibrary assets = {};
    Problems problems = {};  ///< paths relative to the entry: "/setup/points/rows/2/x"
};

struct MadeAsset : MadeEntry {
    AssetLibrary::Entry made = {};  ///< its asset is null after an error
};

/// Made in steps, each kept while what it depends on stays: the model by set-up and references, the inputs by
/// that and the edits, the rest by that, options and requirements.
struct MadeAnalysis : MadeEntry {
    std::shared_ptr<const MeasurementModel> model = {};      ///< null after an error
    Problems of_model = {};                                  ///< relative to the set-up
    std::shared_ptr<const PropagatedModel> propagated = {};  ///< with edits applied; null after an error
    Problems of_edits = {};
    std::shared_ptr<const PreparedAnalysis> prepared = {};  ///< null after an error
    Problems of_studies = {};                               ///< not among `problems`
};

}  // namespace covaria
