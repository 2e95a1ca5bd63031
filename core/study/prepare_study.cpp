// The snapshot of a study.
#include <algorithm>

#include "core/project/kind_lookup.h"
#include "core/project/links.h"
#include "core/project/project_file.h"
#include "core/study/study.h"

namespace covaria {

namespace {

// The parts of a project that one analysis needs, with one of its studies.
Project part_of(const Project& project, const AnalysisEntry& entry, const Study& study) {
    Project part;
    part.directory = project.directory;
    for (const std::string& id : assets_used_by(project, entry))
        part.assets.push_back(*project.find_asset(id));
    part.analyses.push_back(entry);
    part.analyses.back().studies = {study};
    add_used_analyses(project, entry, part);
    return part;
}

// What is varied has to be in the set-up, not only a default of the schema.
void give_default(const SetupSchema* schema, const std::string& key, Setup& setup) {
    const FieldSpec* field = schema ? schema->find(key) : nullptr;
    if (field && !setup.values.contains(key)) setup.values[key] = value_of(*field, setup);
}

bool find_targets(PreparedStudy& prepared) {
    AnalysisEntry& entry = prepared.project.analyses.front();
    for (const StudyAxis& axis : prepared.study.axes) {
        auto target = find_study_target(prepared.project, entry, &prepared.analysis->inputs, axis);
        if (!target) return false;  // of an asset that the analysis does not use; said by the caller
        if (target->in_setup() && target->asset == StudyTarget::analysis)
            give_default(schema_of(entry), target->key, entry.setup);
        else if (target->in_setup())
            give_default(schema_of(prepared.project.assets[target->asset]), target->key,
                         prepared.project.assets[target->asset].setup);
        prepared.targets.push_back(std::move(*target));
    }
    return true;
}

void refuse_idle_assets(const Project& project, const AnalysisEntry& entry, const Study& study,
                        const std::string& path, Problems& problems) {
    const auto used = assets_used_by(project, entry);
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const std::string& asset = study.axes[i].asset;
        if (!asset.empty() && std::find(used.begin(), used.end(), asset) == used.end())
            problems.error(path + "/axes/" + std::to_string(i) + "/asset",
                           "the analysis does not use the asset '" + asset + "': varying it changes nothing");
    }
}

}  // namespace

std::string study_fingerprint(const Project& project, const AnalysisEntry& entry, const Study& study) {
    return fingerprint(part_of(project, entry, study));
}

std::shared_ptr<const PreparedStudy> prepare_study(const Project& project, const std::string& analysis_id,
                                                   const std::string& study_id, const AssetLibrary& assets,
                                                   Problems& problems) {
    auto prepared = std::make_shared<PreparedStudy>();
    prepared->analysis = prepare_analysis(project, analysis_id, assets, problems);
    if (!prepared->analysis) return nullptr;
    const AnalysisEntry& entry = *project.find_analysis(analysis_id);
    const auto study = std::find_if(entry.studies.begin(), entry.studies.end(),
                                    [&](const Study& candidate) { return candidate.id == study_id; });
    const std::string path = "/analyses/" + std::to_string(&entry - project.analyses.data());
    if (study == entry.studies.end()) {
        problems.error(path + "/studies", "the analysis has no study '" + study_id + "'");
        return nullptr;
    }
    Problems found;
    AnalysisEntry only = entry;
    only.studies = {*study};
    check_studies(project, only, &prepared->analysis->inputs, &prepared->analysis->model->outputs(), found);
    refuse_idle_assets(project, entry, *study, "/studies/0", found);
    const std::string first = "/studies/0";
    for (Problem problem : found.items()) {
        problem.path = path + "/studies/" + std::to_string(study - entry.studies.begin()) +
                       problem.path.substr(first.size());
        problems.add(problem);
    }
    if (found.has_errors()) return nullptr;
    prepared->study = *study;
    prepared->project = part_of(project, entry, *study);
    prepared->fingerprint = fingerprint(prepared->project);
    prepared->assets = prepared->analysis->assets;
    return find_targets(*prepared) ? prepared : nullptr;
}

}  // namespace covaria
