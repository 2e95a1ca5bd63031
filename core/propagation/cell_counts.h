// Counts of an output's values in equal cells over the body of its distribution.
#pragma once

#include <cstdint>
#include <vector>

#include "core/propagation/order_statistics.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// 1000 cells between low and high, and one on each side for what lies outside.
struct CellGrid {
    static constexpr std::size_t cells = 1000;
    static constexpr std::size_t counters = cells + 2;
    double low = 0.0;
    double high = 0.0;  ///< equal to low: an output without spread
    double cells_per_unit() const { return high > low ? cells / (high - low) : 0.0; }
    double edge(std::size_t i) const {
        return low + (high - low) * static_cast<double>(i) / static_cast<double>(cells);
    }
};

/// Adds the values to `counts` (of size CellGrid::counters).
void count_cells(const CellGrid& grid, const double* values, std::size_t n, std::uint32_t* counts);

/// 100 cells for people.
Histogram histogram_of(const CellGrid& grid, const std::vector<std::uint64_t>& counts);

/// Quantiles at (i - 1/2)/n: exact where the tails reach, else interpolated linearly in the cells.
std::vector<double> quantile_list(const CellGrid& grid, const std::vector<std::uint64_t>& counts,
                                  const Tails& tails, std::size_t n);

}  // namespace covaria::detail
