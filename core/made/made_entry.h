// Result of making an asset or an analysis of a project.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/made/prepared_analysis.h"
#include "core/model/asset.h"

namespace covaria {

/// Immutable; later states of the project take it over while it stays what it is.
struct MadeEntry {
    virtual ~MadeEntry() = default;
    /// Entries that each reference of the entry (EntryGraph::references) means; null: none, or it is
    /// refused because it refers back.
    std::vector<std::shared_ptr<const MadeEntry>> uses = {};
    /// Assets that it uses, directly or through others, and itself if it is one; not those with errors.
    AssetLibrary assets = {};
    Problems problems = {};  ///< paths relative to the entry: "/setup/points/rows/2/x"
};

struct MadeAsset : MadeEntry {
    AssetLibrary::Entry made = {};  ///< its asset is null after an error
    std::string files = {};         ///< files that its set-up names, and their state when it was made
};

/// An analysis that another one takes something from: a part of a chain.
struct UsedAnalysis {
    std::string id, name;
    std::vector<InputLink> links;
    std::shared_ptr<const MeasurementModel> model;
    std::shared_ptr<const InputSet> inputs;
    bool operator==(const UsedAnalysis&) const = default;
};

/// Made in steps, each kept while what it depends on stays: the model by set-up and references, the inputs by
/// that and the edits, the chain by that, the links and what is upstream, the rest by that, options and
/// requirements.
struct MadeAnalysis : MadeEntry {
    std::string name = {};
    // The analysis by itself, without what it takes from other analyses.
    std::shared_ptr<const MeasurementModel> model = {};  ///< null after an error
    Problems of_model = {};                              ///< relative to the set-up
    std::shared_ptr<const InputSet> inputs = {};         ///< have edits applied; null after an exception
    Problems of_edits = {};
    EvaluationOptions options = {};  ///< include what the project states for all
    ResultStyle style = {};
    Problems of_own = {};  ///< both, and an unknown model; relative to the analysis
    // Behind the analyses that it takes inputs from; for one without links, itself.
    std::vector<UsedAnalysis> upstream = {};
    std::shared_ptr<const PropagatedModel> propagated = {};  ///< null after an error
    Problems of_chain = {};
    std::shared_ptr<const PreparedAnalysis> prepared = {};  ///< null after an error
    Problems of_studies = {};                               ///< and of designs; not among `problems`
};

}  // namespace covaria
