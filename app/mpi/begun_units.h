// The units that a rank is computing: a note in the journal, which outlives the rank where one ends it.
#pragma once

#include <filesystem>
#include <mutex>
#include <set>
#include <vector>

#include "core/parts/part_file.h"

namespace covaria {

/// The note of one rank. It is removed when the rank ends as it should.
class BegunUnits {
public:
    BegunUnits(std::filesystem::path journal, int rank);
    ~BegunUnits() { clear(); }
    void begins(const UnitWork& work, std::uint64_t unit);
    void ends(const UnitWork& work, std::uint64_t unit);
    void clear();

private:
    void write() const;
    std::filesystem::path file_;
    std::mutex mutex_;
    std::set<std::string> lines_;
};

struct DeadlyUnit {
    std::string analysis, study;
    std::uint64_t unit = 0;
    int times = 0;  ///< how often it was being computed when a rank was ended
};

/// The units in the notes of ranks that were ended.
std::vector<DeadlyUnit> left_units(const std::filesystem::path& journal);
/// Counts what is left, and removes the notes. All units that have ever ended a rank of this journal.
Result<std::vector<DeadlyUnit>> counted_deadly_units(const std::filesystem::path& journal);

}  // namespace covaria
