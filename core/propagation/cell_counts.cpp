// Histograms and quantiles from cells.
#include "core/propagation/cell_counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/propagation/trial_rows.h"

namespace covaria::detail {
namespace {

constexpr std::size_t shown_cells = 100;

/// The values of one cell in the pilot.
class CellOfPilot {
public:
    CellOfPilot(std::vector<double>::const_iterator first, std::vector<double>::const_iterator last)
        : first_(first), size_(static_cast<std::size_t>(last - first)) {}

    /// Whether the distribution function of the values leaves the straight line through the cell by more than
    /// chance explains (Kolmogorov and Smirnov, once in 1,500), or so many lie here that a curve of it would
    /// be seen.
    bool is_uneven(double low, double high, std::size_t all) const {
        constexpr std::size_t fewest = 20, crowded = 100;  // values, one in so many of all
        if (size_ < fewest) return false;
        if (size_ * crowded > all) return true;
        double distance = 0.0;
        for (std::size_t k = 0; k < size_; ++k)
            distance = std::max(distance, std::abs(static_cast<double>(k) + 0.5 -
                                                   (first_[static_cast<std::ptrdiff_t>(k)] - low) /
                                                       (high - low) * static_cast<double>(size_)));
        return distance > 2.0 * std::sqrt(static_cast<double>(size_));
    }

    /// Edges at every tenth value, and more of them at both ends, beyond which there may be a gap.
    std::vector<double> edges(double low, double high) const {
        std::vector<double> edges;
        for (std::size_t k = 0; k < size_; ++k) {
            const std::size_t from_end = std::min(k, size_ - 1 - k);
            const double value = first_[static_cast<std::ptrdiff_t>(k)];
            const bool recurs = k + 1 < size_ && first_[static_cast<std::ptrdiff_t>(k) + 1] == value;
            if (!recurs && k % 10 != 0 && from_end > 2 && from_end != 5) continue;
            if (value > low && value < high && (edges.empty() || value > edges.back()))
                edges.push_back(value);
            const double next = std::nextafter(value, infinity);
            if (recurs && next < high && (edges.empty() || next > edges.back())) edges.push_back(next);
        }
        return edges;
    }

private:
    std::vector<double>::const_iterator first_;
    std::size_t size_;
};

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

void divide_cells(const std::vector<double>& sorted, CellGrid& grid) {
    grid.divided.clear();
    if (!(grid.high > grid.low)) return;
    auto first = std::lower_bound(sorted.begin(), sorted.end(), grid.low);
    for (std::size_t i = 0; i < CellGrid::cells; ++i) {
        const double low = grid.edge(i), high = grid.edge(i + 1);
        const auto last = std::lower_bound(first, sorted.end(), high);
        const CellOfPilot cell(first, last);
        if (cell.is_uneven(low, high, sorted.size())) grid.divided.push_back({i, cell.edges(low, high)});
        first = last;
    }
}

std::size_t parts_of(const CellGrid& grid) {
    std::size_t parts = 0;
    for (const DividedCell& divided : grid.divided) parts += divided.parts();
    return parts;
}

void count_cells(const CellGrid& grid, const double* values, std::size_t n, std::uint32_t* counts,
                 std::uint32_t* parts) {
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
    for (const DividedCell& divided : grid.divided) {
        const auto counter = static_cast<std::int32_t>(divided.cell + 1);
        for (std::size_t t = 0; t < n; ++t)
            if (index[t] == counter)
                ++parts[std::upper_bound(divided.edges.begin(), divided.edges.end(), values[t]) -
                        divided.edges.begin()];
        parts += divided.parts();
    }
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
