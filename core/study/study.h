// Evaluates a study: the analysis at every point of a grid of changed values.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/run_control.h"
#include "core/made/made_project.h"
#include "core/project/study_target.h"
#include "core/result/study_result.h"

namespace covaria {

/// An immutable snapshot of what a study needs: safe to hand to a worker thread.
struct PreparedStudy {
    Study study;
    MadeProject::Pointer made;  ///< the assets that the analysis uses, and the analysis, without changes
    std::shared_ptr<const PreparedAnalysis> analysis;  ///< analysis of the project
    std::vector<StudyTarget> targets;                  ///< per axis
    std::string fingerprint;
};

/// Null after an error; paths from the project's root ("/analyses/0/studies/1/axes/0/target").
std::shared_ptr<const PreparedStudy> prepare_study(const MadeProject::Pointer& made,
                                                   const std::string& analysis_id,
                                                   const std::string& study_id, Problems& problems);

/// The assets that the analysis uses, and the analysis with this study: everything that influences its
/// numbers.
Project study_part(const Project& project, const AnalysisEntry& entry, const Study& study);

/// Runs a study. Grid points use the seed of the analysis, so that neighbours differ by what was changed, not
/// by other draws. A point whose model cannot be made or evaluated keeps the reason. Same bits for any number
/// of threads. Error: cancelled, within 100 ms of a stop request (between two trials' blocks or grid points).
/// Progress counts trials, and grid points at first order.
Result<StudyResult> run_study(const PreparedStudy& study, const RunControl& control = {});

/// Grid points: what several processes may share (`RunControl::units`).
std::uint64_t units_of_study(const PreparedStudy& study);

}  // namespace covaria
