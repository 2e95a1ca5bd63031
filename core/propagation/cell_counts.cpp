// Histograms and quantiles from cells.
#include "core/propagation/cell_counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/propagation/trial_rows.h"

namespace covaria::detail {
namespace {

constexpr std::size_t shown_cells = 100;

double quantile_in_cells(const CellGrid& grid, const std::vector<std::uint64_t>& counts, double position) {
    double before = static_cast<double>(counts[0]);
    if (position <= before) return grid.low;
    for (std::size_t i = 0; i < CellGrid::cells; ++i) {
        const auto inside = static_cast<double>(counts[i + 1]);
        if (position <= before + inside)
            return grid.edge(i) + (grid.edge(i + 1) - grid.edge(i)) * (position - before) / inside;
        before += inside;
    }
    return grid.high;
}

}  // namespace

void count_cells(const CellGrid& grid, const double* values, std::size_t n, std::uint32_t* counts) {
    // Indices first (vector code), then the counters. NaN cannot occur: trials without a value are out.
    alignas(64) std::int32_t index[block_trials];
    const double factor = grid.cells_per_unit();
    constexpr double last = CellGrid::counters - 1;
    for (std::size_t t = 0; t < n; ++t) {
        double position = (values[t] - grid.low) * factor + 1.0;
        position = position > 0.0 ? position : 0.0;
        position = position < last ? position : last;
        index[t] = static_cast<std::int32_t>(position);
    }
    for (std::size_t t = 0; t < n; ++t) ++counts[index[t]];
}

Histogram histogram_of(const CellGrid& grid, const std::vector<std::uint64_t>& counts) {
    Histogram histogram;
    histogram.low = grid.low;
    histogram.high = grid.high;
    if (!(grid.high > grid.low)) {
        histogram.counts = {std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})};
        return histogram;
    }
    histogram.counts.assign(shown_cells, 0);
    for (std::size_t i = 0; i < CellGrid::cells; ++i)
        histogram.counts[i * shown_cells / CellGrid::cells] += counts[i + 1];
    histogram.below = counts.front();
    histogram.above = counts.back();
    return histogram;
}

std::vector<double> quantile_list(const CellGrid& grid, const std::vector<std::uint64_t>& counts,
                                  const Tails& tails, std::size_t n) {
    const std::uint64_t trials = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    std::vector<double> quantiles(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double position =
            (static_cast<double>(i) + 0.5) / static_cast<double>(n) * static_cast<double>(trials);
        const std::uint64_t rank =
            std::clamp<std::uint64_t>(static_cast<std::uint64_t>(std::ceil(position)), 1, trials);
        if (rank <= tails.low.count())
            quantiles[i] = tails.low.value(rank);
        else if (trials - rank + 1 <= tails.high.count())
            quantiles[i] = tails.high.value(trials - rank + 1);
        else
            quantiles[i] = quantile_in_cells(grid, counts, position);
    }
    return quantiles;
}

}  // namespace covaria::detail
