// Statistics of one unit of trials, made by one thread and merged in order into those of the run.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/bytes.h"
#include "core/propagation/moments.h"
#include "core/propagation/pilot.h"

namespace covaria::detail {

/// Values of one output that belong to its tails.
struct OutsideValues {
    std::vector<double> values;  ///< below the low threshold or above the high one
    std::uint64_t equal_low = 0;
    std::uint64_t equal_high = 0;
    void clear();
    void add(const OutputPilot& pilot, const double* values, std::size_t n);
};

struct UnitStatistics {
    explicit UnitStatistics(const Pilot& pilot);
    void clear();
    /// Adds the runner's block. Allocates only while `outside` grows to its steady size.
    void add(const Pilot& pilot, const TrialBlockRunner& runner, TrialRows& scratch);
    void write(ByteWriter& writer) const;
    void read(ByteReader& reader);  ///< into statistics made for the same pilot
    /// Whether a unit of `most` trials can have counted this: files may say anything.
    bool is_possible(std::uint64_t most) const;

    Moments moments;
    std::vector<OutsideValues> outside;
    std::vector<std::uint32_t> cells;  ///< CellGrid::counters for each output of the model
    std::vector<std::uint32_t> parts;  ///< counts of their divided cells, one output after the other
    std::uint64_t trials = 0;
};

}  // namespace covaria::detail
