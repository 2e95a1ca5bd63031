// Designs: where to stand, what to measure. The numbers and rows of a project that make the expanded
// uncertainties of an analysis smallest, by the law of propagation, verified by Monte Carlo.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/run_control.h"
#include "core/project/design_check.h"
#include "core/result/design_result.h"
#include "core/study/changed_project.h"

namespace covaria {

/// An output that the objective looks at.
struct DesignedOutput {
    StudyOutput wanted;
    OutputQuantity quantity;
    std::optional<double> target;  ///< SI
};

/// An immutable snapshot of what a design needs: safe to hand to a worker thread.
struct PreparedDesign {
    Design design;
    detail::ChangedNumbers numbers;  ///< its analysis is that of the project
    std::optional<DesignTable> table;
    /// Indices of the assets that the analysis uses without any row of the table, and those that each row
    /// adds.
    std::vector<std::size_t> assets_without_rows;
    std::vector<std::vector<std::size_t>> assets_of_rows;
    std::vector<DesignedOutput> outputs;
    std::vector<double> present;  ///< values of the variables now, in their units
    std::string fingerprint;      ///< fingerprint of the analysis
};

/// Null after an error; paths from the project's root ("/analyses/0/designs/1/variables/0/target").
std::shared_ptr<const PreparedDesign> prepare_design(const MadeProject::Pointer& made,
                                                     const std::string& analysis_id,
                                                     const std::string& design_id, Problems& problems);

/// The assets that the analysis uses, and the analysis with this design: everything that influences what it
/// finds. The candidates of a file are rows of the table here, as the file has them now.
Project design_part(const Project& project, const AnalysisEntry& entry, const Design& design);
/// Whether the same design would be found in two such parts.
bool same_search(Project a, Project b);

/// First the rows (at the present values), then the values, then both in turn. Same bits for any number of
/// threads. Errors: cancelled, within 100 ms of a stop request (between two evaluations; progress counts
/// them); bad_input: without target uncertainties U is looked at relative to that of the present design,
/// which has no result.
Result<DesignResult> run_design(const PreparedDesign& design, const RunControl& control = {});

/// The project with the chosen rows and values in it. Error: a component of uncertainty that several
/// quantities share, or of another analysis, cannot be written there.
Result<Project> take_over(const Project& project, const PreparedDesign& design, const DesignResult& result);

}  // namespace covaria
