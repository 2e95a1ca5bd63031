// The file of a part: partial results of units, exactly, with who made them of what.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit_store.h"
#include "core/parts/program.h"

namespace covaria {

/// A computation whose units are shared: an analysis, or one of its studies.
struct UnitWork {
    std::string analysis, study;  ///< ids; the study's is empty for the trials of the analysis
    std::string fingerprint;      ///< hash of everything that influences its numbers
    std::uint64_t units = 0;
    /// Number of units that parts share, from the first: in an adaptive run as many as it should need.
    /// Whoever merges computes what it needs beyond them.
    std::uint64_t shared = units;

    std::string name() const { return study.empty() ? analysis : analysis + "/" + study; }
};

/// Units of one computation that follow each other.
struct PartSection {
    UnitWork work;
    UnitRange range;
    std::vector<std::string> partials;  ///< partial result of each unit of the range
};

/// Request for an evaluation: the project file and the arguments of `covaria run` that change its results.
struct PartRequest {
    std::string project;  ///< absolute path
    std::vector<std::string> arguments;
};

struct Part {
    PartRequest request;
    std::vector<PartSection> sections;
};

inline constexpr const char* part_extension = ".part";

/// Atomically. Error{io}; Error{numeric} if it would be larger than a file that can be read again.
Result<void> write_part(const std::filesystem::path& file, const Part& part,
                        const ProgramIdentity& by = this_program());
/// Errors name the file: it cannot be read, is damaged, or was made by another program or for other
/// instructions. `with_partials` false: sections without their partial results.
Result<Part> read_part(const std::filesystem::path& file, bool with_partials = true);

}  // namespace covaria
