// From a project to things that can be evaluated: assets made, models created, edits applied; what depends on
// what.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/run_control.h"
#include "core/model/asset.h"
#include "core/model/model_descriptor.h"
#include "core/project/project.h"
#include "core/propagation/options.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// An input quantity of an analysis as its chain gives it, by the law of propagation.
struct LinkedInput {
    std::string symbol, name;
    Unit unit = {};
    std::string analysis, analysis_name;
    OutputQuantity output;
    bool linearised = false;
    double estimate = 0.0;
    double standard_uncertainty = 0.0;
    double degrees_of_freedom = 0.0;
};

/// An immutable snapshot of what one analysis needs: safe to hand to a worker thread.
struct PreparedAnalysis {
    std::string id;
    std::string name;
    const ModelDescriptor* descriptor = nullptr;
    AssetLibrary assets;  ///< kept alive for the model, which may refer to them
    std::shared_ptr<const MeasurementModel> model;
    InputSet inputs;                       ///< the model's, with the analysis' edits and correlations applied
    std::vector<LinkedInput> linked = {};  ///< inputs taken from other analyses: they are not in `inputs`
    EvaluationOptions options;
    std::string fingerprint;  ///< of everything that influences this analysis' numbers (its assets included)
    std::string forecast = {};  ///< how many trials an adaptive run needs, in words; empty for other methods
};

/// Makes all assets; those with errors are left out and reported under "/assets/N/...".
AssetLibrary make_assets(const Project& project, Problems& problems);
/// Null if the analysis has errors; problems under "/analyses/N/...".
std::shared_ptr<const PreparedAnalysis> prepare_analysis(const Project& project,
                                                         const std::string& analysis_id,
                                                         const AssetLibrary& assets, Problems& problems);

/// A model with its inputs, edits applied; no model after an error (paths relative to the analysis).
struct ModelOfAnalysis {
    std::shared_ptr<const MeasurementModel> model;
    InputSet inputs;
};
/// As `prepare_analysis` makes it, composed with what it takes from other analyses (links.h), for an entry
/// that is not in the project: a changed copy, of a study.
ModelOfAnalysis make_model_of(const Project& project, const AnalysisEntry& entry, const AssetLibrary& assets,
                              Problems& problems);
/// Null after an error (paths relative to the asset). `assets` has those it refers to, checked.
std::shared_ptr<const Asset> make_asset_of(const AssetEntry& entry, const AssetLibrary& assets,
                                           Problems& problems);
/// Those of the project's assets that are in `ids` or refer to one of them, directly or through another; each
/// after all that it refers to. Indices.
std::vector<std::size_t> assets_affected_by(const Project& project, const std::set<std::string>& ids);
/// Made of letters, digits, '-' and '_'.
bool is_project_id(const std::string& id);

/// Every problem of the project: setups, assets, models, edits, studies.
void check_project(const Project& project, Problems& problems);

/// Evaluates and fills in provenance.
Result<UncertaintyResult> run_analysis(const PreparedAnalysis& analysis, const RunControl& control = {});

/// All that is to be said beside the results of an analysis: warnings of the assets that it uses ("asset ID:
/// ...", `of_assets` from make_assets), then those of its own preparation.
std::vector<std::string> warnings_of(const Project& project, const std::string& analysis_id,
                                     const Problems& of_assets, const Problems& of_analysis);

/// Ids of analyses that use the asset, directly or through another asset.
std::vector<std::string> analyses_using(const Project& project, const std::string& asset_id);
/// Ids of assets the analysis refers to, itself or through assets and analyses.
std::vector<std::string> assets_used_by(const Project& project, const AnalysisEntry& analysis);

}  // namespace covaria
