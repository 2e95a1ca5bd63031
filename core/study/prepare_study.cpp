// The snapshot of a study.
#include <algorithm>

#include "core/project/kind_lookup.h"
#include "core/project/links.h"
#include "core/project/project_file.h"
#include "core/study/study.h"

namespace covaria {

namespace {

// What is varied has to be in the set-up, not only a default of the schema.
void give_default(const SetupSchema* schema, const std::string& key, Setup& setup) {
    const FieldSpec* field = schema ? schema->find(key) : nullptr;
    if (field && !setup.values.contains(key)) setup.values[key] = value_of(*field, setup);
}

/// Targets of the axes in the part, which gets the defaults that they change; false: not found.
bool find_targets(const InputSet& inputs, Project& part, PreparedStudy& prepared) {
    AnalysisEntry& entry = part.analyses.front();
    for (const StudyAxis& axis : prepared.study.axes) {
        auto target = find_study_target(part, entry, &inputs, axis);
        if (!target) return false;  // of an asset that the analysis does not use; said by the caller
        if (target->in_setup() && target->asset == StudyTarget::analysis)
            give_default(schema_of(entry), target->key, entry.setup);
        else if (target->in_setup())
            give_default(schema_of(part.assets[target->asset]), target->key,
                         part.assets[target->asset].setup);
        prepared.targets.push_back(std::move(*target));
    }
    return true;
}

// What a grid point needs no check of.
Project without_choices(Project part) {
    AnalysisEntry& entry = part.analyses.front();
    entry.studies.clear();
    entry.requirements.clear();
    entry.options = {};
    return part;
}

void refuse_idle_assets(const MadeProject& made, const std::string& analysis, const Study& study,
                        const std::string& path, Problems& problems) {
    const auto used = made.assets_used_by(analysis);
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const std::string& asset = study.axes[i].asset;
        if (!asset.empty() && std::find(used.begin(), used.end(), asset) == used.end())
            problems.error(path + "/axes/" + std::to_string(i) + "/asset",
                           "the analysis does not use the asset '" + asset + "': varying it changes nothing");
    }
}

/// Of one study of an analysis, paths relative to it.
Problems problems_of(const MadeProject& made, const PreparedAnalysis& analysis, const Study& study) {
    AnalysisEntry only = *made.project().find_analysis(analysis.id);
    only.studies = {study};
    Problems found, own;
    check_studies(made.project(), only, &analysis.inputs, &analysis.model->outputs(), found);
    const std::string first = "/studies/0";
    refuse_idle_assets(made, analysis.id, study, first, found);
    for (Problem problem : found.items()) {
        problem.path = problem.path.substr(first.size());
        own.add(problem);
    }
    return own;
}

}  // namespace

Project study_part(const Project& project, const AnalysisEntry& entry, const Study& study) {
    Project part;
    part.directory = project.directory;
    for (const std::string& id : assets_used_by(project, entry))
        part.assets.push_back(*project.find_asset(id));
    part.analyses.push_back(entry);
    part.analyses.back().studies = {study};
    add_used_analyses(project, entry, part);
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
        problems.error(path, "the analysis has no study '" + study_id + "'");
        return nullptr;
    }
    const Problems found = problems_of(*made, *prepared->analysis, *study);
    problems.take(found, path + "/" + std::to_string(study - entry.studies.begin()));
    if (found.has_errors()) return nullptr;
    prepared->study = *study;
    Project part = study_part(project, entry, *study);
    prepared->fingerprint = fingerprint(part);
    if (!find_targets(prepared->analysis->inputs, part, *prepared)) return nullptr;
    prepared->made = MadeProject::make(without_choices(std::move(part)), made);
    return prepared;
}

}  // namespace covaria
