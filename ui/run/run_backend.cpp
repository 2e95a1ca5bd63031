// Preparing makes the assets once for all analyses.
#include "ui/run/run_backend.h"

#include "core/propagation/engine.h"

namespace covaria::ui {

namespace {

std::map<std::string, Preparation> prepare_all(const Project& project) {
    std::map<std::string, Preparation> prepared;
    Problems asset_problems;
    const AssetLibrary assets = make_assets(project, asset_problems);
    for (const AnalysisEntry& entry : project.analyses) {
        Problems problems;
        Preparation& item = prepared[entry.id];
        item.analysis = prepare_analysis(project, entry.id, assets, problems);
        item.warnings = warnings_of(project, entry.id, asset_problems, problems);
        for (const Problem& problem : problems.items())
            if (problem.severity == Severity::error && item.message.empty()) item.message = problem.message;
    }
    return prepared;
}

Result<UncertaintyResult> first_order(const PreparedAnalysis& analysis) {
    auto result = evaluate_first_order(*analysis.model, analysis.inputs, analysis.options);
    if (result) result->provenance.project_fingerprint = analysis.fingerprint;
    return result;
}

}  // namespace

RunBackend core_backend() {
    return {prepare_all, first_order, run_analysis};
}

}  // namespace covaria::ui
