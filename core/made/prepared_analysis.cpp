#include "core/made/prepared_analysis.h"

#include "core/base/guarded.h"
#include "core/base/version.h"
#include "core/project/entry_graph.h"
#include "core/project/project_file.h"
#include "core/propagation/engine.h"

namespace covaria {

AnalysisNumbers::AnalysisNumbers(std::shared_ptr<const Project> project, std::string analysis)
    : project_(std::move(project)), analysis_(std::move(analysis)) {}

Project AnalysisNumbers::part() const {
    const AnalysisEntry& entry = *project_->find_analysis(analysis_);
    Project part;
    for (const std::string& id : assets_used_by(*project_, entry))
        part.assets.push_back(*project_->find_asset(id));
    part.analyses.push_back(entry);
    part.analyses.back().options = effective_options(*project_, entry);
    part.analyses.back().studies.clear();  // they have results, and fingerprints, of their own
    part.analyses.back().designs.clear();
    part.analyses.back().views.clear();
    part.analyses.back().quantity_notes.clear();
    add_used_analyses(*project_, entry, part);
    return part;
}

const std::string& AnalysisNumbers::fingerprint() const {
    std::call_once(once_, [&] { fingerprint_ = covaria::fingerprint(part()); });
    return fingerprint_;
}

bool AnalysisNumbers::operator==(const AnalysisNumbers& other) const {
    return this == &other || same_numbers(part(), other.part());
}

bool same_numbers(const PreparedAnalysis& a, const PreparedAnalysis& b) {
    return *a.numbers == *b.numbers;
}

namespace {

Result<UncertaintyResult> run_unguarded(const PreparedAnalysis& analysis, const RunControl& control) {
    auto result = evaluate(*analysis.propagated, analysis.options, control);
    if (!result) return result;
    result->provenance.project_fingerprint = analysis.fingerprint();
    result->provenance.covaria_version = version();
    result->provenance.seed = analysis.options.seed;
    take_style(*result, analysis.style);
    return result;
}

}  // namespace

Result<UncertaintyResult> run_analysis(const PreparedAnalysis& analysis, const RunControl& control) {
    auto result = guarded([&] { return run_unguarded(analysis, control); });
    if (!result) return fail(result.error());
    return *std::move(result);
}

}  // namespace covaria
