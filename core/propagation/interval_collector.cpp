#include "core/propagation/interval_collector.h"

#include <algorithm>

namespace covaria::detail {

namespace {

constexpr std::size_t first_values = 10'000;

}  // namespace

void IntervalCollector::add(const double* values, std::size_t count) {
    count_ += count;
    if (tails_) return add_to_tails(values, count);
    first_.insert(first_.end(), values, values + count);
    if (first_.size() < first_values) return;
    const double fraction = tail_fraction_of(first_.size(), probability_, EngineSettings{}.tail_margin);
    std::vector<double> sorted = first_;
    begin_tails(look_at(sorted, fraction));
}

void IntervalCollector::begin_tails(const OutputPilot& pilot) {
    pilot_ = pilot;
    tails_ = Tails{Tail(Side::low, pilot.low), Tail(Side::high, pilot.high)};
    for (std::size_t i = 0; i < first_.size(); i += block_trials)
        add_to_tails(first_.data() + i, std::min<std::size_t>(block_trials, first_.size() - i));
    first_ = {};
}

void IntervalCollector::add_to_tails(const double* values, std::size_t count) {
    outside_.clear();
    outside_.add(pilot_, values, count);
    tails_->low.add(outside_.values);
    tails_->high.add(outside_.values);
    tails_->low.add_equal(outside_.equal_low);
    tails_->high.add_equal(outside_.equal_high);
    if (tails_->low.bytes() + tails_->high.bytes() <= bytes_) return;
    tails_->low.to_cells();
    tails_->high.to_cells();
}

/// Two values in their order, without all others in theirs.
CoverageInterval IntervalCollector::interval_of_first(const CoverageRanks& ranks) {
    const auto place = [this](std::uint64_t rank) {
        return first_.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    };
    const auto low = place(ranks.r), high = place(ranks.r + ranks.q);
    std::nth_element(first_.begin(), high, first_.end());
    std::nth_element(first_.begin(), low, high);
    return {*low, *high};
}

std::optional<CoverageInterval> IntervalCollector::interval() {
    const CoverageRanks ranks = coverage_ranks(count_, probability_);
    if (!tails_ && count_ >= 2) return interval_of_first(ranks);
    if (!tails_) {
        std::vector<double> sorted = first_;
        begin_tails(look_at(sorted, 1.0));
    }
    const std::uint64_t needed = needed_tail(ranks);
    if (tails_->low.count() < needed || tails_->high.count() < needed) {
        begin_tails(widened(pilot_));
        count_ = 0;
        return std::nullopt;
    }
    tails_->low.finish();
    tails_->high.finish();
    return symmetric_interval(*tails_, ranks);
}

}  // namespace covaria::detail
