#include "core/study/varied_part.h"

#include <algorithm>

#include "core/project/kind_lookup.h"
#include "core/project/links.h"

namespace covaria {

void give_default(const SetupSchema* schema, const std::string& key, Setup& setup) {
    const FieldSpec* field = schema ? schema->find(key) : nullptr;
    if (field && !setup.values.contains(key)) setup.values[key] = value_of(*field, setup);
}

const SetupSchema* schema_of(const StudyTarget& target, std::size_t own, const Project& project) {
    if (target.asset != StudyTarget::analysis) return schema_of(project.assets[target.asset]);
    return schema_of(project.analyses[target.upstream == StudyTarget::analysis ? own : target.upstream]);
}

bool find_targets(const InputSet& inputs, const std::vector<StudyAxis>& axes, Project& part,
                  std::vector<StudyTarget>& targets) {
    AnalysisEntry& entry = part.analyses.front();
    for (const StudyAxis& axis : axes) {
        auto target = find_study_target(part, entry, &inputs, axis);
        if (!target) return false;
        if (target->in_setup())
            give_default(schema_of(*target, 0, part), target->key, varied_setup(*target, 0, part));
        targets.push_back(std::move(*target));
    }
    return true;
}

Project without_choices(Project part) {
    AnalysisEntry& entry = part.analyses.front();
    entry.studies.clear();
    entry.designs.clear();
    entry.requirements.clear();
    entry.options = {};
    return part;
}

Project analysis_part(const Project& project, const AnalysisEntry& entry) {
    Project part;
    part.directory = project.directory;
    for (const std::string& id : assets_used_by(project, entry))
        part.assets.push_back(*project.find_asset(id));
    part.analyses.push_back(entry);
    part.analyses.back().options = effective_options(project, entry);
    part.analyses.back().studies.clear();
    part.analyses.back().designs.clear();
    add_used_analyses(project, entry, part);
    return part;
}

void refuse_idle_asset(const MadeProject& made, const std::string& analysis, const std::string& asset,
                       const std::string& path, Problems& problems) {
    if (asset.empty()) return;
    const Project& project = made.project();
    const auto upstream = analyses_used_by(project, *project.find_analysis(analysis));
    if (std::find(upstream.begin(), upstream.end(), asset) != upstream.end()) return;
    const auto used = made.assets_used_by(analysis);
    if (std::find(used.begin(), used.end(), asset) == used.end())
        problems.error(path,
                       tell<"the analysis does not use the asset '%1': varying it changes nothing">(asset));
}

double present_value(const StudyAxis& axis, const StudyTarget& target) {
    if (axis.change == StudyChange::factor) return 1.0;
    if (axis.change == StudyChange::added) return 0.0;
    return axis.unit == target.unit ? target.current : axis.unit.from_si(target.unit.to_si(target.current));
}

}  // namespace covaria
