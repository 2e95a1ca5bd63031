// The adaptive procedure: batches of trials until the results are stable (JCGM 101 7.9, JCGM 102 7.8).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/bytes.h"
#include "core/propagation/batch_estimates.h"
#include "core/propagation/coverage_regions.h"
#include "core/propagation/first_order.h"
#include "core/propagation/nearby_ranks.h"
#include "core/propagation/options.h"
#include "core/propagation/unit_statistics.h"

namespace covaria::detail {

/// The statistics of one batch whose scatter between batches is watched. Empty: too few trials had a value.
struct BatchSummary {
    std::vector<double> values;
    std::vector<BatchFigures> figures;  ///< those of each row of the source, where they are asked for
    void write(ByteWriter& writer) const;
    void read(ByteReader& reader);
};

/// Whether batches tell the mean of an output that a Student t of so few degrees of freedom reaches. With
/// four or fewer its fourth moment does not exist: the scatter of u between batches says nothing, however
/// many there are. With two or fewer there is no u, and the mean is no better. The ends always remain.
inline bool mean_settles(double degrees_of_freedom) {
    return degrees_of_freedom > 2.0;
}
inline bool uncertainty_settles(double degrees_of_freedom) {
    return degrees_of_freedom > 4.0;
}

/// The statistics that are watched. One measurand: y, u, y_low, y_high (JCGM 101 7.9.4). Several: these of
/// each, the greatest eigenvalue of their correlation matrix, k_p of each group (JCGM 102 7.8.3).
struct WatchedStatistics {
    std::vector<std::size_t> outputs;
    std::vector<Unit> units;              ///< units of the outputs as reported, which decide what a digit is
    std::vector<CoverageRegion> regions;  ///< regions that have an ellipsoid
    double probability = 0.95;
    std::vector<double> least_degrees_of_freedom;  ///< one for each output
    bool figures_of_rows = false;                  ///< figures of all rows, for BatchEstimates

    bool several() const { return outputs.size() > 1; }
    static constexpr std::size_t per_output = 4;
    bool has_settling_mean(std::size_t i) const { return mean_settles(least_degrees_of_freedom[i]); }
    bool has_settling_uncertainty(std::size_t i) const {
        return uncertainty_settles(least_degrees_of_freedom[i]);
    }
    /// Which values of a BatchSummary count for the decision.
    std::vector<bool> judged() const;
    std::size_t values_of_batch() const {
        return per_output * outputs.size() + (several() ? 1 : 0) + regions.size();
    }
};

/// Fewest degrees of freedom of the Student t distributions drawn for components that reach each output.
std::vector<double> least_degrees_of_freedom(const InputSet& inputs, const LawOfPropagation& law);

/// Makes the summaries of batches on one thread.
class BatchSummariser {
public:
    BatchSummariser(const WatchedStatistics& watched, const TrialSource& source, const Pilot& pilot,
                    std::size_t kept_bytes);
    void begin(std::uint64_t first, std::uint64_t last);
    void keep(const TrialBlockRunner& runner);
    /// `runner` serves to make trials again that were too many to keep. Always true: the batch is complete.
    bool summarise(const UnitStatistics& statistics, TrialBlockRunner& runner, BatchSummary& summary);

private:
    void add_values(const UnitStatistics& statistics, TrialBlockRunner& runner, BatchSummary& summary);
    void add_figures(const UnitStatistics& statistics, TrialBlockRunner& runner, BatchSummary& summary);
    template <class Use>
    void each_block(TrialBlockRunner& runner, Use use);
    double tail_value(const UnitStatistics& statistics, TrialBlockRunner& runner, std::size_t row,
                      std::uint64_t rank, Side side);
    void gather_tail(const UnitStatistics& statistics, TrialBlockRunner& runner, std::size_t row,
                     std::uint64_t ranks, Side side);
    struct NearRank {
        double value = 0.0;     ///< value at the rank
        double smoothed = 0.0;  ///< mean by the weights of the ranks around it
    };
    NearRank near_rank(const UnitStatistics& statistics, TrialBlockRunner& runner, std::size_t row,
                       std::uint64_t rank, const RankWeights& around, Side side);
    const RankWeights& weights_for(std::uint64_t rank, std::uint64_t count);
    std::uint64_t rank_of_figures(std::uint64_t count) const;
    double ellipsoid_factor(const CoverageRegion& region, const UnitStatistics& statistics,
                            TrialBlockRunner& runner);

    const WatchedStatistics& watched_;
    const Pilot& pilot_;
    std::size_t rows_;
    std::size_t kept_numbers_limit_;
    std::uint64_t first_ = 0, last_ = 0;
    bool keeping_ = false;
    std::vector<double> kept_;             ///< blocks of rows, as in the runner
    std::vector<std::size_t> kept_valid_;  ///< trials with a value in each block
    std::vector<double> scratch_;
    /// Row of the linear part of each output that explains almost all of it; 0: there is none.
    std::vector<std::size_t> close_linear_;
    struct KnownWeights {
        std::uint64_t rank = 0, count = 0;
        RankWeights around;
    };
    std::vector<KnownWeights> known_weights_;
};

class AdaptiveProcedure {
public:
    AdaptiveProcedure(const EvaluationOptions& options, WatchedStatistics watched);

    /// M = max(J, 10^4) with J = smallest integer >= 100/(1-p), in whole blocks.
    static std::uint64_t batch_trials(double probability);

    const WatchedStatistics& watched() const { return watched_; }
    /// Stability is then judged by these standard errors, where there are any.
    void judge_by(const BatchEstimates* estimates);
    /// Called in the order of batches. True: every watched statistic is stable.
    bool stable_after(const BatchSummary& summary, const Moments& all);
    bool stabilised() const { return stabilised_; }

private:
    double standard_error(std::size_t value) const;
    double watched_uncertainty(const Moments& all, std::size_t i) const;
    std::vector<double> tolerances(const Moments& all) const;

    EvaluationOptions options_;
    WatchedStatistics watched_;
    std::vector<bool> judged_;
    const BatchEstimates* estimates_ = nullptr;
    std::uint64_t batches_ = 0;
    std::vector<double> mean_, squares_;  ///< Welford sums of the summaries
    bool stabilised_ = false;
};

}  // namespace covaria::detail
