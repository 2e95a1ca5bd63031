// Tails: exact values, sorted when asked for, or cells.
#include "core/propagation/tail.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/propagation/sorting.h"

namespace covaria::detail {
namespace {

constexpr std::size_t cell_count = std::size_t{1} << 15;

}  // namespace

Tail::Tail(Side side, TailShape shape)
    : sign_(side == Side::high ? 1.0 : -1.0),
      shape_{sign_ * shape.threshold, shape.scale},
      extreme_(-std::numeric_limits<double>::infinity()) {}

void Tail::add(std::span<const double> values) {
    for (const double y : values) {
        const double depth = sign_ * y;
        if (!(depth > shape_.threshold)) continue;
        ++beyond_;
        extreme_ = std::max(extreme_, depth);
        if (exact())
            values_.push_back(depth);
        else
            ++cells_[cell_of(depth)];
    }
}

void Tail::to_cells() {
    if (!exact()) return;
    cells_.assign(cell_count, 0);
    if (std::isinf(shape_.threshold) && !values_.empty()) {
        // Without a pilot to go by everything was kept: now these values are one.
        std::vector<double> sorted = values_;
        std::sort(sorted.begin(), sorted.end());
        shape_.threshold = sorted[sorted.size() / 8];
        shape_.scale = sorted[sorted.size() * 7 / 8] - shape_.threshold;
    }
    if (!(shape_.scale > 0)) shape_.scale = std::max(1e-12 * std::abs(shape_.threshold), 1e-280);
    beyond_ = 0;
    for (const double depth : values_) {
        if (!(depth > shape_.threshold)) continue;
        ++cells_[cell_of(depth)];
        ++beyond_;
    }
    values_ = {};
}

void Tail::finish() {
    if (exact()) {
        sort_descending(values_);
    } else {
        std::uint64_t sum = 0;
        for (std::size_t i = cell_count; i-- > 0;) cells_[i] = sum += cells_[i];
    }
}

// s = distance beyond the threshold / scale; cells divide s/(1+s) equally, so that a heavy tail fits too.
std::size_t Tail::cell_of(double depth) const {
    const double s = (depth - shape_.threshold) / shape_.scale;
    const double position = std::isinf(s) ? 1.0 : s / (1.0 + s);
    return std::min(cell_count - 1, static_cast<std::size_t>(position * cell_count));
}

double Tail::depth_at(double cell) const {
    const double position = cell / cell_count;
    if (position >= 1.0) return extreme_;
    return std::min(extreme_, shape_.threshold + shape_.scale * position / (1.0 - position));
}

double Tail::interpolated(std::uint64_t rank) const {
    if (rank == 1) return extreme_;
    // cells_[i] = values in cell i and beyond: falling in i. The cell sought is the last with cells_[i] >=
    // rank.
    const auto after =
        std::partition_point(cells_.begin(), cells_.end(), [rank](std::uint64_t sum) { return sum >= rank; });
    const auto i = static_cast<std::size_t>(after - cells_.begin()) - 1;
    const std::uint64_t beyond = i + 1 < cell_count ? cells_[i + 1] : 0;
    const double inside = static_cast<double>(cells_[i] - beyond);
    const double upper = depth_at(static_cast<double>(i + 1));
    const double lower = depth_at(static_cast<double>(i));
    return upper - (upper - lower) * (static_cast<double>(rank - beyond) - 0.5) / inside;
}

double Tail::value(std::uint64_t rank) const {
    if (rank > beyond_) return sign_ * shape_.threshold;
    return sign_ * (exact() ? values_[rank - 1] : interpolated(rank));
}

std::vector<std::uint64_t> Tail::corners(std::uint64_t last_rank) const {
    std::vector<std::uint64_t> ranks;
    if (exact()) {
        ranks.resize(last_rank);
        for (std::uint64_t r = 0; r < last_rank; ++r) ranks[r] = r + 1;
        return ranks;
    }
    ranks.push_back(1);
    for (std::size_t i = cell_count; i-- > 0;)
        if (cells_[i] > ranks.back() && cells_[i] < last_rank) ranks.push_back(cells_[i]);
    ranks.push_back(last_rank);
    return ranks;
}

}  // namespace covaria::detail
