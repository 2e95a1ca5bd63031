#include "core/propagation/kept_distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace covaria::detail {
namespace {

constexpr std::uint64_t every_rank_up_to = 32;

/// 1, 2, ... 32, and then 1/32 further each, up to `last`.
std::vector<std::uint64_t> kept_ranks(std::uint64_t last) {
    std::vector<std::uint64_t> ranks;
    for (std::uint64_t r = 1; r < last; r += std::max<std::uint64_t>(1, r / every_rank_up_to))
        ranks.push_back(r);
    if (last > 0) ranks.push_back(last);
    return ranks;
}

class Keeper {
public:
    Keeper(const OutputPilot& pilot, const std::vector<std::uint64_t>& counts,
           const std::vector<std::uint64_t>& parts, const Tails& tails)
        : pilot_(pilot),
          counts_(counts),
          parts_(parts),
          tails_(tails),
          trials_(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})) {}

    TrialDistribution keep() {
        const std::uint64_t half = trials_ / 2;
        const std::uint64_t below = std::min(tails_.low.count(), half);
        const std::uint64_t above = std::min(tails_.high.count(), trials_ - half);
        for (const std::uint64_t r : kept_ranks(below))
            add(tails_.low.value(r), static_cast<double>(r) - 0.5);
        if (below + above < trials_) add_body(above);
        const auto ranks = kept_ranks(above);
        for (auto r = ranks.rbegin(); r != ranks.rend(); ++r)
            add(tails_.high.value(*r), static_cast<double>(trials_ - *r) + 0.5);
        return std::move(kept_);
    }

private:
    void add(double value, double trials_below) {
        kept_.values.push_back(value);
        kept_.shares.push_back(trials_below / static_cast<double>(trials_));
    }

    /// Adds a value between the tails, where it rises with those before.
    void add_inner(double value, double trials_below) {
        const bool after =
            kept_.values.empty() || (value >= kept_.values.back() &&
                                     trials_below >= kept_.shares.back() * static_cast<double>(trials_));
        if (after && value <= last_ && trials_below <= most_below_) add(value, trials_below);
    }

    void add_body(std::uint64_t above) {
        last_ = tails_.high.value(above);
        most_below_ = static_cast<double>(trials_ - above) + 0.5;
        std::vector<std::vector<RepeatedValue>> repeated(CellGrid::cells);
        for (const RepeatedValue& r : pilot_.repeated)
            if (const std::size_t cell = cell_of(r.value); cell < CellGrid::cells)
                repeated[cell].push_back(r);
        double before = static_cast<double>(counts_.front());
        auto divided = pilot_.grid.divided.begin();
        std::size_t part = 0;
        for (std::size_t i = 0; i < CellGrid::cells; ++i) {
            const bool in_parts = divided != pilot_.grid.divided.end() && divided->cell == i;
            if (in_parts) {
                add_parts(*divided, part, before);
                part += divided++->parts();
            } else if (!repeated[i].empty()) {
                add_jumps(i, repeated, before);
            }
            before += static_cast<double>(counts_[i + 1]);
            if (i % 2 == 1 || in_parts || !repeated[i].empty()) add_inner(pilot_.grid.edge(i + 1), before);
        }
    }

    /// A value and the next number are the edges of a part that has nothing but that value: a jump.
    void add_parts(const DividedCell& divided, std::size_t part, double before) {
        add_inner(pilot_.grid.edge(divided.cell), before);
        const std::vector<double>& edges = divided.edges;
        for (std::size_t k = 0; k < edges.size(); ++k) {
            before += static_cast<double>(parts_[part + k]);
            const bool after_jump = k > 0 && edges[k] == std::nextafter(edges[k - 1], infinity);
            add_inner(after_jump ? edges[k - 1] : edges[k], before);
        }
    }

    /// Adds the values that recur in cell i. The rest beside a single one continues from the neighbours.
    void add_jumps(std::size_t i, const std::vector<std::vector<RepeatedValue>>& repeated, double before) {
        const auto inside = static_cast<double>(counts_[i + 1]);
        const auto continuous = [&](std::size_t cell) {
            const bool known = cell < CellGrid::cells && repeated[cell].empty();
            return known ? static_cast<double>(counts_[cell + 1]) : 0.0;
        };
        double left = 0.0, right = 0.0, weight = 0.0;
        if (repeated[i].size() == 1) {
            const double low = pilot_.grid.edge(i), high = pilot_.grid.edge(i + 1);
            const double part = std::clamp((repeated[i].front().value - low) / (high - low), 0.0, 1.0);
            left = std::min(inside, part * continuous(i - 1));
            right = std::min(inside - left, (1.0 - part) * continuous(i + 1));
        }
        for (const RepeatedValue& jump : repeated[i]) weight += jump.share;
        add_inner(pilot_.grid.edge(i), before);
        double within = before + left;
        for (const RepeatedValue& jump : repeated[i]) {
            add_inner(jump.value, within);
            within += (inside - left - right) * jump.share / weight;
            add_inner(jump.value, within);
        }
    }

    std::size_t cell_of(double value) const {
        const double cell = (value - pilot_.grid.low) * pilot_.grid.cells_per_unit();
        return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(CellGrid::cells)));
    }

    const OutputPilot& pilot_;
    const std::vector<std::uint64_t>& counts_;
    const std::vector<std::uint64_t>& parts_;
    const Tails& tails_;
    std::uint64_t trials_;
    double last_ = 0.0, most_below_ = 0.0;  ///< end of the body
    TrialDistribution kept_;
};

}  // namespace

TrialDistribution kept_distribution(const OutputPilot& pilot, const std::vector<std::uint64_t>& counts,
                                    const std::vector<std::uint64_t>& parts, const Tails& tails) {
    return Keeper(pilot, counts, parts, tails).keep();
}

}  // namespace covaria::detail
