// The adaptive procedure.
#include "core/propagation/adaptive.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/math/decompositions.h"
#include "core/math/normal_quantile.h"
#include "core/propagation/numerical_tolerance.h"

namespace covaria::detail {
namespace {

/// Share of the variance of an output above which its linear part stands in for it: what is left is too
/// little for a shift between both that is not smooth.
constexpr double almost_all = 0.999;

/// Greatest eigenvalue of the covariance; of thousands of outputs that of their blocks. NaN: variances of the
/// trials are not finite.
double greatest_eigenvalue(const OutputCovariance& covariance, const std::vector<std::size_t>& outputs) {
    double greatest = 0.0;
    for (std::size_t k = 0; k < outputs.size();) {
        const auto block_of = [&](std::size_t i) {
            return covariance.blocks().block_of(static_cast<Eigen::Index>(outputs[i]));
        };
        std::vector<std::size_t> members;
        for (const std::size_t block = block_of(k); k < outputs.size() && block_of(k) == block; ++k)
            members.push_back(outputs[k]);
        const Eigen::MatrixXd correlation = correlation_of(covariance.among(members));
        if (!correlation.allFinite()) return std::numeric_limits<double>::quiet_NaN();
        greatest = std::max(
            greatest, eigen_decomposition(correlation, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff());
    }
    return greatest;
}

}  // namespace

std::vector<bool> WatchedStatistics::judged() const {
    std::vector<bool> judged;
    bool all = true;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        judged.insert(judged.end(), {has_settling_mean(i), has_settling_uncertainty(i), true, true});
        all = all && has_settling_uncertainty(i);
    }
    if (several()) judged.push_back(all);
    for (const CoverageRegion& region : regions) {
        bool settles = true;
        for (std::size_t i = 0; i < outputs.size(); ++i)
            if (std::find(region.outputs.begin(), region.outputs.end(), outputs[i]) != region.outputs.end())
                settles = settles && has_settling_uncertainty(i);
        judged.push_back(settles);
    }
    return judged;
}

std::vector<double> least_degrees_of_freedom(const InputSet& inputs, const LawOfPropagation& law) {
    std::vector<double> of_component{infinity}, least;
    for (const UncertaintyComponent& c : inputs.components)
        of_component.push_back(c.held ? infinity : drawn_distribution(c).degrees_of_freedom());
    for (std::size_t j = 0; j < law.differentiable.size(); ++j) {
        least.push_back(infinity);
        const bool is_known = law.differentiable[j] && !law.condensed;
        if (!is_known)  // any of them may reach it
            least.back() = *std::min_element(of_component.begin(), of_component.end());
        for (const PropagationTerm& term : is_known ? law.terms[j] : std::vector<PropagationTerm>())
            if (term.contribution != 0.0)
                least.back() = std::min(least.back(), of_component[term.component + 1]);
    }
    return least;
}

BatchSummariser::BatchSummariser(const WatchedStatistics& watched, const TrialSource& source,
                                 const Pilot& pilot, std::size_t kept_bytes)
    : watched_(watched),
      pilot_(pilot),
      rows_(source.rows()),
      kept_numbers_limit_(kept_bytes / sizeof(double)),
      close_linear_(source.outputs(), 0) {
    for (std::size_t k = 0; source.linear && k < source.linear->size(); ++k)
        if (pilot.explained[k] > almost_all) close_linear_[(*source.linear)[k].output] = source.outputs() + k;
}

void BatchSummariser::begin(std::uint64_t first, std::uint64_t last) {
    first_ = first;
    last_ = last;
    kept_.clear();
    kept_valid_.clear();
    const std::uint64_t blocks = (last - first + block_trials - 1) / block_trials;
    keeping_ = !watched_.regions.empty() && blocks * block_trials * rows_ <= kept_numbers_limit_;
}

void BatchSummariser::keep(const TrialBlockRunner& runner) {
    if (!keeping_) return;
    kept_.insert(kept_.end(), runner.output(0), runner.output(0) + rows_ * block_trials);
    kept_valid_.push_back(runner.valid());
}

template <class Use>
void BatchSummariser::each_block(TrialBlockRunner& runner, Use use) {
    if (keeping_) {
        for (std::size_t b = 0; b < kept_valid_.size(); ++b)
            use(kept_.data() + b * rows_ * block_trials, kept_valid_[b]);
        return;
    }
    for (std::uint64_t t = first_; t < last_; t += block_trials) {
        runner.run(t, std::min<std::uint64_t>(block_trials, last_ - t));
        use(runner.output(0), runner.valid());
    }
}

/// The smallest values of the row (of its negative for the high side) into `scratch_`: at least `ranks`.
void BatchSummariser::gather_tail(const UnitStatistics& statistics, TrialBlockRunner& runner, std::size_t row,
                                  std::uint64_t ranks, Side side) {
    const double sign = side == Side::low ? 1.0 : -1.0;
    const OutputPilot& pilot = pilot_.outputs[row];
    const OutsideValues& outside = statistics.outside[row];
    const double threshold = sign * (side == Side::low ? pilot.low : pilot.high).threshold;
    const std::uint64_t equal = side == Side::low ? outside.equal_low : outside.equal_high;
    scratch_.clear();
    for (double y : outside.values)
        if (sign * y < threshold) scratch_.push_back(sign * y);
    if (ranks <= scratch_.size()) return;
    if (ranks <= scratch_.size() + equal) return scratch_.resize(ranks, threshold);
    scratch_.clear();  // the tail is too short: look at all values of the batch
    each_block(runner, [&](const double* rows, std::size_t valid) {
        const double* y = rows + row * block_trials;
        for (std::size_t t = 0; t < valid; ++t) scratch_.push_back(sign * y[t]);
    });
}

double BatchSummariser::tail_value(const UnitStatistics& statistics, TrialBlockRunner& runner,
                                   std::size_t row, std::uint64_t rank, Side side) {
    gather_tail(statistics, runner, row, rank, side);
    const auto nth = scratch_.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(scratch_.begin(), nth, scratch_.end());
    return side == Side::low ? *nth : -*nth;
}

BatchSummariser::NearRank BatchSummariser::near_rank(const UnitStatistics& statistics,
                                                     TrialBlockRunner& runner, std::size_t row,
                                                     std::uint64_t rank, const RankWeights& around,
                                                     Side side) {
    const auto size = static_cast<std::ptrdiff_t>(around.weights.size());
    const auto before = static_cast<std::ptrdiff_t>(around.first - 1);
    gather_tail(statistics, runner, row, around.first - 1 + around.weights.size(), side);
    const auto first = scratch_.begin() + before, last = first + size - 1;
    std::nth_element(scratch_.begin(), last, scratch_.end());
    std::nth_element(scratch_.begin(), first, last);
    std::sort(first, last);
    const double sign = side == Side::low ? 1.0 : -1.0;
    return {sign * scratch_[rank - 1],
            sign * std::inner_product(around.weights.begin(), around.weights.end(), first, 0.0)};
}

double BatchSummariser::ellipsoid_factor(const CoverageRegion& region, const UnitStatistics& statistics,
                                         TrialBlockRunner& runner) {
    const RegionDistances distances(region.outputs, statistics.moments.means(),
                                    statistics.moments.covariance());
    if (!distances.has_ellipsoid()) return std::numeric_limits<double>::quiet_NaN();
    scratch_.clear();
    each_block(runner, [&](const double* rows, std::size_t valid) {
        const std::size_t before = scratch_.size();
        scratch_.resize(before + valid);
        distances.ellipsoid_squared(rows, valid, scratch_.data() + before);
    });
    return std::sqrt(factor_of(scratch_, watched_.probability));
}

bool BatchSummariser::summarise(const UnitStatistics& statistics, TrialBlockRunner& runner,
                                BatchSummary& summary) {
    summary.values.clear();
    summary.figures.clear();
    if (statistics.moments.count() < 2) return true;
    add_values(statistics, runner, summary);
    if (watched_.figures_of_rows) add_figures(statistics, runner, summary);
    return true;
}

void BatchSummariser::add_values(const UnitStatistics& statistics, TrialBlockRunner& runner,
                                 BatchSummary& summary) {
    const Moments& moments = statistics.moments;
    const CoverageRanks ranks = coverage_ranks(moments.count(), watched_.probability);
    for (std::size_t j : watched_.outputs) {
        const auto index = static_cast<Eigen::Index>(j);
        const std::uint64_t from_above = ranks.trials - ranks.q - ranks.r + 1;
        summary.values.push_back(moments.mean(index));
        summary.values.push_back(std::sqrt(moments.variance(index)));
        summary.values.push_back(tail_value(statistics, runner, j, ranks.r, Side::low));
        summary.values.push_back(tail_value(statistics, runner, j, from_above, Side::high));
    }
    if (watched_.several())
        summary.values.push_back(greatest_eigenvalue(moments.covariance(), watched_.outputs));
    for (const CoverageRegion& region : watched_.regions)
        summary.values.push_back(ellipsoid_factor(region, statistics, runner));
}

/// The rank of least bias for any continuous distribution (Hyndman and Fan, The American Statistician 50
/// (1996) 361, definition 8) is not whole: on average over the batches it is taken. Were it the same whole
/// one in each, all would be wrong by the same fraction of a rank; between two values a curve would be cut
/// short.
std::uint64_t BatchSummariser::rank_of_figures(std::uint64_t count) const {
    constexpr double golden = 0.6180339887498949;  // its multiples fill the interval from 0 to 1 evenly
    const double batch = static_cast<double>(first_ / (last_ - first_));
    const double p = 0.5 * (1.0 - watched_.probability);
    const double rank = (static_cast<double>(count) + 1.0 / 3.0) * p + 1.0 / 3.0;
    const double moved = std::floor(rank + (golden * batch - std::floor(golden * batch)));
    return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(moved), 1, count);
}

/// Made once: batches have as many values and one of two ranks, unless trials are lost.
const RankWeights& BatchSummariser::weights_for(std::uint64_t rank, std::uint64_t count) {
    for (const KnownWeights& known : known_weights_)
        if (known.rank == rank && known.count == count) return known.around;
    if (known_weights_.size() >= 2) known_weights_.clear();
    return known_weights_.emplace_back(KnownWeights{rank, count, weights_around(rank, count)}).around;
}

/// Adds the figures of a batch. Where the linear part is almost the output, an end is that of the part plus
/// the shift between both, a smooth function of the rank: the neighbours of a rank tell the shift better
/// than that rank alone, at which other trials stand in the output and in the part.
void BatchSummariser::add_figures(const UnitStatistics& statistics, TrialBlockRunner& runner,
                                  BatchSummary& summary) {
    const Moments& moments = statistics.moments;
    const std::uint64_t rank = rank_of_figures(moments.count());
    const auto end = [&](std::size_t row, Side side) {
        if (row >= close_linear_.size() || close_linear_[row] == 0)
            return tail_value(statistics, runner, row, rank, side);
        const RankWeights& around = weights_for(rank, moments.count());
        const NearRank y = near_rank(statistics, runner, row, rank, around, side);
        const NearRank linear = near_rank(statistics, runner, close_linear_[row], rank, around, side);
        return linear.value + (y.smoothed - linear.smoothed);
    };
    for (std::size_t j = 0; j < rows_; ++j) {
        const auto index = static_cast<Eigen::Index>(j);
        summary.figures.push_back(
            {{moments.mean(index), moments.variance(index), end(j, Side::low), end(j, Side::high)}});
    }
}

void BatchSummary::write(ByteWriter& writer) const {
    writer.put_list(values);
    writer.put(static_cast<std::uint64_t>(figures.size()));
    for (const BatchFigures& f : figures) writer.put_all(std::span<const double>(f.values));
}

void BatchSummary::read(ByteReader& reader) {
    reader.get_list(values);
    figures.clear();
    std::array<double, BatchFigures::count> values_of_row{};
    for (auto left = reader.get<std::uint64_t>(); left > 0 && !reader.is_short(); --left) {
        reader.get_all(std::span<double>(values_of_row));
        figures.push_back({values_of_row});
    }
}

AdaptiveProcedure::AdaptiveProcedure(const EvaluationOptions& options, WatchedStatistics watched)
    : options_(options), watched_(std::move(watched)), judged_(watched_.judged()) {}

std::uint64_t AdaptiveProcedure::batch_trials(double probability) {
    const double j = std::ceil(100.0 / (1.0 - probability) * (1.0 - 1e-12));
    const auto trials = static_cast<std::uint64_t>(std::max(j, 10'000.0));
    return (trials + block_trials - 1) / block_trials * block_trials;
}

void AdaptiveProcedure::judge_by(const BatchEstimates* estimates) {
    estimates_ = estimates;
    watched_.figures_of_rows = estimates != nullptr;
}

/// Standard error of the mean over the batches so far, or the one that BatchEstimates states.
double AdaptiveProcedure::standard_error(std::size_t value) const {
    const auto h = static_cast<double>(batches_);
    const std::size_t i = value / WatchedStatistics::per_output;
    if (estimates_ && i < watched_.outputs.size()) {
        const std::size_t figure = value % WatchedStatistics::per_output;
        const auto estimate = estimates_->estimate(watched_.outputs[i], figure);
        if (estimate.controlled)
            return figure == 1 ? estimate.standard_error / (2.0 * std::sqrt(std::max(0.0, estimate.value)))
                               : estimate.standard_error;
    }
    return std::sqrt(squares_[value] / (h * (h - 1.0)));
}

/// u, or where it does not settle what the interval would be k times, were the output normal.
double AdaptiveProcedure::watched_uncertainty(const Moments& all, std::size_t i) const {
    if (watched_.has_settling_uncertainty(i))
        return std::sqrt(all.variance(static_cast<Eigen::Index>(watched_.outputs[i])));
    const std::size_t low = i * WatchedStatistics::per_output + 2;
    return 0.5 * (mean_[low + 1] - mean_[low]) / normal_quantile(0.5 * (1.0 + watched_.probability));
}

std::vector<double> AdaptiveProcedure::tolerances(const Moments& all) const {
    std::vector<double> result;
    for (std::size_t i = 0; i < watched_.outputs.size(); ++i) {
        const double u = watched_uncertainty(all, i);
        const double delta =
            options_.tolerance_for(watched_.units[i])
                .value_or(numerical_tolerance(u, watched_.units[i], options_.significant_digits));
        result.insert(result.end(), WatchedStatistics::per_output, delta);
    }
    if (watched_.several())
        result.push_back(numerical_tolerance(greatest_eigenvalue(all.covariance(), watched_.outputs),
                                             options_.significant_digits));
    // The mean of the batches stands for k_p of all trials: only its decimal position matters here.
    while (result.size() < mean_.size())
        result.push_back(numerical_tolerance(mean_[result.size()], options_.significant_digits));
    return result;
}

bool AdaptiveProcedure::stable_after(const BatchSummary& summary, const Moments& all) {
    if (summary.values.empty()) return false;
    if (mean_.empty()) {
        mean_.assign(summary.values.size(), 0.0);
        squares_.assign(summary.values.size(), 0.0);
    }
    const auto h = static_cast<double>(++batches_);
    for (std::size_t i = 0; i < mean_.size(); ++i) {
        // A joint figure has no value where outputs depend on each other in the trials of a batch.
        if (i >= watched_.outputs.size() * WatchedStatistics::per_output && std::isnan(summary.values[i]))
            judged_[i] = false;
        const double difference = summary.values[i] - mean_[i];
        mean_[i] += difference / h;
        squares_[i] += difference * (summary.values[i] - mean_[i]);
    }
    if (batches_ < std::max<std::uint64_t>(2, options_.minimum_batches)) return false;
    const std::vector<double> tolerance = tolerances(all);
    for (std::size_t i = 0; i < mean_.size(); ++i)
        if (judged_[i] && !(2.0 * standard_error(i) <= tolerance[i])) return false;
    stabilised_ = true;
    return true;
}

}  // namespace covaria::detail
