// Units of a computation (blocks of trials, points of a grid) that are computed in several processes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace covaria {

struct UnitRange {
    std::uint64_t first = 0, last = 0;  ///< [first, last)
    std::uint64_t size() const { return last - first; }
};

/// Store of the partial results of one computation, kept unit by unit as exact bytes: they are merged by the
/// code that merges those of one process, in the same order, so that the result has the same bits.
class UnitStore {
public:
    virtual ~UnitStore() = default;

    /// True: here units are computed for others (`next_range`, `keep`) and no result comes of it: the
    /// computation ends as cancelled. False: here they are merged (`find`, `keep`, `lacks`).
    virtual bool only_computes() const = 0;
    /// Range of units to compute next; none: that was all. Called on the thread that began the computation.
    virtual std::optional<UnitRange> next_range() { return {}; }
    /// A unit begins to be computed, on any thread.
    virtual void begins(std::uint64_t /*unit*/) {}
    /// A unit was computed here. One call at a time, rising within a range; false: stop.
    virtual bool keep(std::uint64_t unit, std::string bytes) = 0;

    /// The partial result of a unit, if somebody has computed it. On any thread.
    virtual std::optional<std::string> find(std::uint64_t /*unit*/) { return {}; }
    /// Whether this unit, which was not found, is computed here.
    virtual bool computes_missing(std::uint64_t /*unit*/) const { return true; }
    /// A unit is needed for the result, not found and not to be computed: the computation ends as cancelled.
    virtual void lacks(std::uint64_t /*unit*/) {}
    /// The bytes found are not those of such a unit: the computation ends as cancelled, too.
    virtual void cannot_read(std::uint64_t /*unit*/) {}
};

}  // namespace covaria
