// The snapshot of a study.
#include <algorithm>

#include "core/project/project_file.h"
#include "core/study/study.h"
#include "core/study/varied_part.h"

namespace covaria {

namespace {

/// Problems of one study of an analysis, paths relative to it.
Problems problems_of(const MadeProject& made, const PreparedAnalysis& analysis, const Study& study) {
    AnalysisEntry only = *made.project().find_analysis(analysis.id);
    only.studies = {study};
    Problems found, own;
    check_studies(made.project(), only, &analysis.inputs, &analysis.model->outputs(), found);
    const std::string first = "/studies/0";
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        refuse_idle_asset(made, analysis.id, study.axes[i].asset,
                          first + "/axes/" + std::to_string(i) + "/asset", found);
    for (Problem problem : found.items()) {
        problem.path = problem.path.substr(first.size());
        own.add(problem);
    }
    return own;
}

}  // namespace

Project study_part(const Project& project, const AnalysisEntry& entry, const Study& study) {
    Project part = analysis_part(project, entry);
    part.analyses.front().studies = {study};
    return part;
}

std::shared_ptr<const PreparedStudy> prepare_study(const MadeProject::Pointer& made,
                                                   const std::string& analysis_id,
                                                   const std::string& study_id, Problems& problems) {
    problems.take(made->problems_of_analysis(analysis_id), "");
    auto prepared = std::make_shared<PreparedStudy>();
    prepared->analysis = made->analysis(analysis_id);
    if (!prepared->analysis) return nullptr;
    const Project& project = made->project();
    const AnalysisEntry& entry = *project.find_analysis(analysis_id);
    const auto study = std::find_if(entry.studies.begin(), entry.studies.end(),
                                    [&](const Study& candidate) { return candidate.id == study_id; });
    const std::string path = "/analyses/" + std::to_string(&entry - project.analyses.data()) + "/studies";
    if (study == entry.studies.end()) {
        problems.error(path, tell<"the analysis has no study '%1'">(study_id));
        return nullptr;
    }
    const Problems found = problems_of(*made, *prepared->analysis, *study);
    problems.take(found, path + "/" + std::to_string(study - entry.studies.begin()));
    if (found.has_errors()) return nullptr;
    prepared->study = *study;
    Project part = study_part(project, entry, *study);
    prepared->fingerprint = fingerprint(part);
    if (!find_targets(prepared->analysis->inputs, study->axes, part, prepared->targets)) return nullptr;
    prepared->made = MadeProject::make(without_choices(std::move(part)), made);
    return prepared;
}

}  // namespace covaria
