// Coverage interval of one output from trials that come by on one thread and are not kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/propagation/internal_sizes.h"
#include "core/propagation/order_statistics.h"
#include "core/propagation/unit_statistics.h"

namespace covaria::detail {

/// The first 10 000 values say where the tails begin; from then on only the tails are kept. The interval is
/// that of a run with the same trials.
class IntervalCollector {
public:
    /// `bytes`: of tails kept, beyond which cells take over.
    IntervalCollector(double probability, std::size_t bytes) : probability_(probability), bytes_(bytes) {}

    void add(const double* values, std::size_t count);
    /// Empty: the tails proved too short for so many values. Then all trials have to be added once more.
    std::optional<CoverageInterval> interval();

private:
    CoverageInterval interval_of_first(const CoverageRanks& ranks);
    void begin_tails(const OutputPilot& pilot);
    void add_to_tails(const double* values, std::size_t count);

    double probability_;
    std::size_t bytes_;
    std::uint64_t count_ = 0;
    std::vector<double> first_;  ///< until the tails begin
    OutputPilot pilot_;
    OutsideValues outside_;
    std::optional<Tails> tails_;
};

}  // namespace covaria::detail
