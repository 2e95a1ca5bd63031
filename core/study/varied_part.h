// The part of a project that an analysis needs, with numbers of it to be varied: what studies and designs
// start from.
#pragma once

#include <vector>

#include "core/made/made_project.h"
#include "core/project/study_target.h"

namespace covaria {

/// The assets that the analysis uses, the analysis, which comes first, and those that it takes inputs from.
Project analysis_part(const Project& project, const AnalysisEntry& entry);

/// Schema of the set-up that `varied_setup` gives.
const SetupSchema* schema_of(const StudyTarget& target, std::size_t own, const Project& project);

/// Finds the target of each axis in the part, whose set-ups get the defaults that are varied; false: one is
/// not found (of an asset that the analysis does not use).
bool find_targets(const InputSet& inputs, const std::vector<StudyAxis>& axes, Project& part,
                  std::vector<StudyTarget>& targets);
/// Value in the unchanged project, in the axis' unit, or the factor or difference that changes nothing.
double present_value(const StudyAxis& axis, const StudyTarget& target);
/// Writes the default of a field into the set-up, where what is varied, or chosen from, has to be.
void give_default(const SetupSchema* schema, const std::string& key, Setup& setup);

/// Without what a changed state needs no check of: studies, designs, requirements, options.
Project without_choices(Project part);

/// A problem for an asset that the analysis does not use: changing it changes nothing. `path` is of `asset`.
void refuse_idle_asset(const MadeProject& made, const std::string& analysis, const std::string& asset,
                       const std::string& path, Problems& problems);

}  // namespace covaria
