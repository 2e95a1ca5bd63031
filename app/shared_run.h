// A run that is shared by several processes: its computations, their units, who computes which.
#pragma once

#include "app/evaluation.h"
#include "core/parts/parts_folder.h"
#include "core/study/study.h"

namespace covaria {

/// A project opened for a shared run, with the computations whose units are shared, in order of evaluation.
struct SharedRun {
    RunRequest request;
    MadeProject::Pointer opened;
    MadeProject::Pointer made;  ///< the project with the changes of the request
    std::vector<UnitWork> works;

    PartRequest part_request() const;
};

/// Works of a run that processes can share; analyses without model or trials are left to whoever merges.
Result<SharedRun> open_shared_run(const RunRequest& request);

/// The arguments of `covaria run` (without the file) that give this request, but for threads.
std::vector<std::string> arguments_of(const RunRequest& request);
/// The request of a part, for this project file if one is named.
Result<RunRequest> request_of(const PartRequest& part, const std::string& project);

/// Computes the units that the store asks for. Errors: stopped; why the computation has no results.
Result<void> compute_units(const SharedRun& run, const UnitWork& work, UnitStore& store,
                           const std::stop_token& stop);

/// Units first ... last of `units` in part k of n (k = 1 ... n): all parts together have each unit once.
UnitRange range_of_part(std::uint64_t units, std::uint64_t k, std::uint64_t n);

}  // namespace covaria
