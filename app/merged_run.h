// The process that merges the units of a shared run, from a folder of parts.
#pragma once

#include <map>

#include "app/shared_run.h"

namespace covaria {

/// A source of units that no part in the folder has: other processes, who are asked here.
class UnitSource {
public:
    virtual ~UnitSource() = default;
    /// Waits until the folder has this unit. False: stopped, or it will never have it.
    virtual bool wait_for(std::size_t work, std::uint64_t unit) = 0;
};

struct MissingUnits {
    enum class Rule { refuse, compute } rule = Rule::refuse;
    UnitSource* source = nullptr;  ///< null: nobody else computes
};

/// Results of a shared run. What is computed here is kept in the folder too. Errors: as `evaluate_analyses`;
/// units that are missing; parts of something else.
Result<Evaluation> merge_units(const SharedRun& run, PartsFolder& folder, MissingUnits missing,
                               const std::stop_token& stop);

/// Units of a computation in one part, where nobody says how many.
std::uint64_t units_per_part(std::uint64_t units);

}  // namespace covaria
