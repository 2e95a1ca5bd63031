// Loading and evaluating a project for the subcommands.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/made/made_project.h"
#include "core/report/report.h"

namespace covaria {

/// Changes that the command line makes to a project's analyses.
struct RunRequest {
    std::string file;
    std::vector<std::string> analyses = {};  ///< ids; empty = all
    std::optional<std::uint64_t> trials = {};
    bool adaptive = false;
    bool first_order = false;
    bool studies = true;      ///< evaluate the studies of the analyses too
    std::string study = {};   ///< only the one with this id; empty = all
    bool designs = false;     ///< search the designs of the analyses too
    std::string design = {};  ///< only the one with this id; empty = all
    std::optional<std::uint64_t> seed = {};
    std::optional<VarianceReduction> variance_reduction = {};
    int threads = 0;
    std::vector<std::string> values =
        {};  ///< "/assets/0/setup/temperature=23.5": the file is read as if they stood there
};

/// Prints every problem; an error of the project becomes Error{bad_input}. `values`, `analyses`: see
/// RunRequest. Where analyses are named, what is wrong with others and with what only those use keeps nothing
/// from being evaluated.
Result<MadeProject::Pointer> open_project(const std::string& file,
                                          const std::vector<std::string>& values = {},
                                          const std::vector<std::string>& analyses = {});
/// The errors at which `open_project` would stop, none of them printed.
Result<Problems> errors_of_project(const std::string& file, const std::vector<std::string>& values,
                                   const std::vector<std::string>& analyses);

/// Warns of what a certificate must say and the project does not.
void say_what_is_missing(const ReportSource& source);

/// The stores through which other processes share the units of analyses and studies.
class UnitStores {
public:
    virtual ~UnitStores() = default;
    /// Store of the trials of an analysis (`study` empty) or of the points of its study.
    virtual UnitStore* of(const std::string& analysis, const std::string& study) = 0;
};

/// Analyses with their results, and those that failed.
struct Evaluation {
    MadeProject::Pointer made;  ///< the project that was evaluated, with the changes of the request
    std::vector<EvaluatedAnalysis> analyses;
    std::vector<FailedAnalysis> failed;
};

/// Evaluates the requested analyses one after the other, with progress on a terminal. One that fails is said
/// and does not keep the others from being evaluated. Errors: an unknown analysis, stopped.
Result<Evaluation> evaluate_analyses(const MadeProject::Pointer& opened, const RunRequest& request,
                                     const std::stop_token& stop, UnitStores* stores = nullptr);
/// Puts the results of the same analyses of another project, by the same method, beside these. Errors: a file
/// without one of them, one that fails.
Result<void> compare_with(const std::string& file, RunRequest request, Evaluation& evaluation,
                          const std::stop_token& stop);
/// The project with the changes of this request.
MadeProject::Pointer requested(const MadeProject::Pointer& opened, const RunRequest& request);
/// Ids of the requested analyses. Error{not_found}: an analysis that the project has not.
Result<std::vector<std::string>> requested_analyses(const Project& project, const RunRequest& request);
/// Error{numeric} that names what failed, if anything did: the command ends with status 1.
Result<void> check_complete(const Evaluation& evaluation);

}  // namespace covaria
