// Counts of an output's values in equal cells over the body of its distribution.
#pragma once

#include <cstdint>
#include <vector>

#include "core/propagation/order_statistics.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// A cell in which the values lie too unevenly for a straight line through it.
struct DividedCell {
    std::size_t cell = 0;
    std::vector<double>
        edges;  ///< rising, within the cell; after a value that recurs the next number follows
    std::size_t parts() const { return edges.size() + 1; }
};

/// 1000 cells between low and high, and one on each side for what lies outside.
struct CellGrid {
    static constexpr std::size_t cells = 1000;
    static constexpr std::size_t counters = cells + 2;
    double low = 0.0;
    double high = 0.0;                      ///< equal to low: an output without spread
    std::vector<DividedCell> divided = {};  ///< cells with parts of their own, rising
    double cells_per_unit() const { return high > low ? cells / (high - low) : 0.0; }
    double edge(std::size_t i) const {
        return low + (high - low) * static_cast<double>(i) / static_cast<double>(cells);
    }
};

/// Divides cells at values that the sorted ones of a pilot have: where narrow peaks stand far apart, a cell
/// is wider than a peak.
void divide_cells(const std::vector<double>& sorted, CellGrid& grid);
/// Number of parts of all divided cells.
std::size_t parts_of(const CellGrid& grid);

/// Adds the values to `counts` (of size CellGrid::counters) and those of divided cells to `parts` (of size
/// parts_of(grid)).
void count_cells(const CellGrid& grid, const double* values, std::size_t n, std::uint32_t* counts,
                 std::uint32_t* parts);

/// 100 cells for people.
Histogram histogram_of(const CellGrid& grid, const std::vector<std::uint64_t>& counts);

/// Quantiles at (i - 1/2)/n: exact where the tails reach, else interpolated linearly in the cells.
std::vector<double> quantile_list(const CellGrid& grid, const std::vector<std::uint64_t>& counts,
                                  const Tails& tails, std::size_t n);

}  // namespace covaria::detail
