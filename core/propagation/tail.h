// One tail of the distribution of an output: its most extreme values in order, or counts of them in fine
// cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace covaria::detail {

enum class Side { low, high };

/// Threshold of a tail, where it begins, and the scale of its cells (both from the pilot).
struct TailShape {
    double threshold = 0.0;
    double scale = 1.0;
};

/// Keeps values beyond the threshold; values equal to it are only counted, so that a discrete output costs
/// nothing. Depth is measured outward: internally values of the low side are negated (exactly).
class Tail {
public:
    Tail(Side side, TailShape shape);

    void add(std::span<const double> values);  ///< ignores values that are not beyond the threshold
    void add_equal(std::uint64_t count) { equal_ += count; }
    std::uint64_t count() const { return beyond_ + equal_; }
    std::size_t bytes() const { return values_.size() * sizeof(double); }
    bool exact() const { return cells_.empty(); }
    /// Replaces the values by counts in cells over the whole half line; cells are finest at the threshold.
    void to_cells();
    /// Sorts or sums what was added; to be called before `value`.
    void finish();
    /// The rank-th most extreme value, rank = 1 ... count(). In cells: interpolated linearly.
    double value(std::uint64_t rank) const;
    /// Ranks at which `value` has a corner: all of them when exact, cell boundaries otherwise.
    std::vector<std::uint64_t> corners(std::uint64_t last_rank) const;

private:
    std::size_t cell_of(double depth) const;
    double depth_at(double cell) const;
    double interpolated(std::uint64_t rank) const;

    double sign_;
    TailShape shape_;  ///< threshold as depth
    std::uint64_t beyond_ = 0;
    std::uint64_t equal_ = 0;
    double extreme_;                    ///< greatest depth seen
    std::vector<double> values_;        ///< depths
    std::vector<std::uint64_t> cells_;  ///< counts; after `finish` cumulative from the extreme
};

}  // namespace covaria::detail
