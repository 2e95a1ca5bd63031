// The main pass over all trials, and a second one for tails that were kept too short.
#include "core/propagation/monte_carlo.h"

#include <algorithm>
#include <memory>

#include "core/propagation/adaptive.h"
#include "core/propagation/stored_units.h"

namespace covaria::detail {
namespace {

/// Pilot for a second pass over the outputs whose tails proved too short.
Pilot widened(const Pilot& pilot, const std::vector<std::size_t>& outputs) {
    Pilot wide;
    for (std::size_t j : outputs) wide.outputs.push_back(widened(pilot.outputs[j]));
    wide.own = outputs.size();
    return wide;
}

class TailCollector {
public:
    TailCollector(const Pilot& pilot, std::size_t budget, double expected_trials) : budget_(budget) {
        for (std::size_t j = 0; j < pilot.own; ++j)
            tails_.push_back(
                {Tail(Side::low, pilot.outputs[j].low), Tail(Side::high, pilot.outputs[j].high)});
        const double expected =
            expected_trials * pilot.tail_fraction * 2.0 * static_cast<double>(tails_.size() * sizeof(double));
        if (expected > static_cast<double>(budget_)) to_cells();
    }

    void add(const std::vector<OutsideValues>& outside) {
        std::size_t bytes = 0;
        for (std::size_t j = 0; j < tails_.size(); ++j) {
            tails_[j].low.add(outside[j].values);
            tails_[j].high.add(outside[j].values);
            tails_[j].low.add_equal(outside[j].equal_low);
            tails_[j].high.add_equal(outside[j].equal_high);
            bytes += tails_[j].low.bytes() + tails_[j].high.bytes();
        }
        if (bytes > budget_) to_cells();
    }

    bool exact() const { return exact_; }
    std::vector<Tails>& tails() { return tails_; }

private:
    void to_cells() {
        for (Tails& t : tails_) {
            t.low.to_cells();
            t.high.to_cells();
        }
        exact_ = false;
    }

    std::size_t budget_;
    bool exact_ = true;
    std::vector<Tails> tails_;
};

/// Numbers of trials 1, 2, 5, 10 ... at which the running values are noted.
class ConvergenceLog {
public:
    explicit ConvergenceLog(std::size_t outputs) : outputs_(static_cast<Eigen::Index>(outputs)) {}
    void note(std::uint64_t trials, const Moments& moments, std::vector<ConvergencePoint>& points) {
        if (trials < next_) return;
        append(trials, moments, points);
        while (next_ <= trials) advance();
    }
    void append(std::uint64_t trials, const Moments& moments, std::vector<ConvergencePoint>& points) const {
        if (moments.count() < 2 || (!points.empty() && points.back().trials == trials)) return;
        const Eigen::VectorXd mean = moments.means().head(outputs_),
                              u = moments.standard_uncertainties().head(outputs_);
        points.push_back({trials, {mean.begin(), mean.end()}, {u.begin(), u.end()}});
    }

private:
    void advance() {
        next_ = mantissa_ == 2 ? next_ / 2 * 5 : next_ * 2;
        mantissa_ = mantissa_ == 1 ? 2 : mantissa_ == 2 ? 5 : 1;
    }
    Eigen::Index outputs_;
    std::uint64_t next_ = unit_trials;
    int mantissa_ = 1;
};

struct Partial {
    UnitStatistics statistics;
    BatchSummary summary;
};

/// Whether a partial result read from a file can be one of a unit of the run: more trials than it has would
/// be waited for without an end, values of other outputs be looked for where there are none.
bool is_possible(const Partial& partial, RunSize size, const WatchedStatistics& watched, bool in_batches,
                 std::size_t rows) {
    const std::size_t values = in_batches ? watched.values_of_batch() : 0;
    const std::size_t figures = in_batches && watched.figures_of_rows ? rows : 0;
    const BatchSummary& summary = partial.summary;
    const bool too_few = partial.statistics.moments.count() < 2;
    return partial.statistics.is_possible(size.per_unit) && summary.values.size() == (too_few ? 0 : values) &&
           summary.figures.size() == (too_few ? 0 : figures);
}

PartialBytes<Partial> bytes_of_partials(std::function<bool(const Partial&)> is_possible) {
    return {[](const Partial& partial, ByteWriter& writer) {
                partial.statistics.write(writer);
                partial.summary.write(writer);
            },
            [is_possible = std::move(is_possible)](ByteReader& reader, Partial& partial) {
                partial.statistics.read(reader);
                partial.summary.read(reader);
                if (!is_possible(partial)) reader.refuse();
            }};
}

/// A thread of the main pass.
class Worker {
public:
    Worker(const RunContext& context, const Pilot& pilot, RunSize size)
        : runner_(context.source),
          scratch_(context.source.rows()),
          pilot_(pilot),
          size_(size),
          monitor_(context.monitor) {}

    void summarise_with(std::unique_ptr<BatchSummariser> summariser) { summariser_ = std::move(summariser); }

    bool run(std::uint64_t unit, Partial& partial) {
        partial.statistics.clear();
        const std::uint64_t first = unit * size_.per_unit;
        const std::uint64_t last = std::min(first + size_.per_unit, size_.trials);
        if (summariser_) summariser_->begin(first, last);
        for (std::uint64_t t = first; t < last; t += block_trials) {
            runner_.run(t, std::min<std::uint64_t>(block_trials, last - t));
            partial.statistics.add(pilot_, runner_, scratch_);
            if (summariser_) summariser_->keep(runner_);
            if (!monitor_.advance(runner_.trials())) return false;
        }
        return !summariser_ || summariser_->summarise(partial.statistics, runner_, partial.summary);
    }

private:
    TrialBlockRunner runner_;
    TrialRows scratch_;
    const Pilot& pilot_;
    RunSize size_;
    RunMonitor& monitor_;
    std::unique_ptr<BatchSummariser> summariser_;
};

void merge(MonteCarloRun& run, const UnitStatistics& part) {
    run.moments.merge(part.moments);
    run.trials += part.trials;
    ++run.units;
    for (std::size_t j = 0; j < run.cells.size(); ++j)
        for (std::size_t i = 0; i < CellGrid::counters; ++i)
            run.cells[j][i] += part.cells[j * CellGrid::counters + i];
    auto next = part.parts.begin();
    for (std::vector<std::uint64_t>& parts : run.parts)
        for (std::uint64_t& count : parts) count += *next++;
}

/// Collects the tails of some outputs again, with the thresholds of `pilot` (one entry per such output).
WorkEnd collect_again(const RunContext& context, RunSize size, const std::vector<std::size_t>& outputs,
                      const Pilot& pilot, TailCollector& collector) {
    using Outside = std::vector<OutsideValues>;
    OrderedWork<Outside> work;
    work.units = size.units();
    work.make_partial = [&outputs] { return Outside(outputs.size()); };
    work.make_worker = [&] {
        return [&, runner = std::make_shared<TrialBlockRunner>(context.source)](std::uint64_t unit,
                                                                                Outside& part) {
            for (OutsideValues& o : part) o.clear();
            const std::uint64_t last = std::min((unit + 1) * size.per_unit, size.trials);
            for (std::uint64_t t = unit * size.per_unit; t < last; t += block_trials) {
                runner->run(t, std::min<std::uint64_t>(block_trials, last - t));
                for (std::size_t k = 0; k < outputs.size(); ++k)
                    part[k].add(pilot.outputs[k], runner->output(outputs[k]), runner->valid());
                if (!context.monitor.advance(0)) return false;
            }
            return true;
        };
    };
    work.merge = [&collector](std::uint64_t, Outside& part) {
        collector.add(part);
        return true;
    };
    return run_in_order(work, context.monitor);
}

/// The pilot may have been unlucky: checks the tails, and regenerates the trials for those too short.
WorkEnd complete_tails(const RunContext& context, std::uint64_t per_unit, MonteCarloRun& run) {
    const std::uint64_t needed = needed_tail(coverage_ranks(run.moments.count(), context.probability));
    std::vector<std::size_t> lacking;
    for (std::size_t j = 0; j < run.tails.size(); ++j)
        if (std::min(run.tails[j].low.count(), run.tails[j].high.count()) < needed) lacking.push_back(j);
    if (lacking.empty()) return WorkEnd::complete;
    const Pilot wide = widened(run.pilot, lacking);
    TailCollector collector(wide, context.settings.tail_bytes, static_cast<double>(run.trials));
    const RunSize size{run.trials, per_unit};
    const WorkEnd end = collect_again(context, size, lacking, wide, collector);
    for (std::size_t k = 0; k < lacking.size(); ++k) run.tails[lacking[k]] = std::move(collector.tails()[k]);
    run.exact = run.exact && collector.exact();
    return end;
}

void add_batch(const Partial& batch, RunSize size, BatchEstimates& estimates) {
    if (batch.statistics.moments.count() < batch.statistics.trials) estimates.forget_controls();
    const bool complete = batch.statistics.trials == size.per_unit;
    if (complete && !batch.summary.figures.empty()) estimates.add(batch.summary.figures);
}

WatchedStatistics watched_by(const BatchWatch& watch, double probability) {
    WatchedStatistics watched;
    if (watch.adaptive) return watch.adaptive->watched();
    watched.probability = probability;
    watched.figures_of_rows = watch.estimates != nullptr;
    return watched;
}

}  // namespace

Result<MonteCarloRun> run_monte_carlo(const RunContext& context, Pilot pilot, RunSize size,
                                      BatchWatch watch) {
    MonteCarloRun run{pilot.moments(), {}, {}, {}, std::move(pilot), 0, 0, true, {}};
    run.cells.assign(context.source.outputs(), std::vector<std::uint64_t>(CellGrid::counters, 0));
    for (std::size_t j = 0; j < context.source.outputs(); ++j)
        run.parts.emplace_back(parts_of(run.pilot.outputs[j].grid), 0);
    TailCollector collector(run.pilot, context.settings.tail_bytes,
                            watch.adaptive ? 0.0 : static_cast<double>(size.trials));
    ConvergenceLog log(context.source.outputs());
    const WatchedStatistics watched = watched_by(watch, context.probability);

    OrderedWork<Partial> work;
    work.units = size.units();
    work.ends_with_enough = watch.adaptive != nullptr;
    work.make_partial = [&run] { return Partial{UnitStatistics(run.pilot), {}}; };
    work.make_worker = [&] {
        auto worker = std::make_shared<Worker>(context, run.pilot, size);
        if (watch.adaptive || watch.estimates)
            worker->summarise_with(std::make_unique<BatchSummariser>(watched, context.source, run.pilot,
                                                                     context.settings.batch_bytes));
        return [worker](std::uint64_t unit, Partial& partial) { return worker->run(unit, partial); };
    };
    work.merge = [&](std::uint64_t, Partial& partial) {
        merge(run, partial.statistics);
        collector.add(partial.statistics.outside);
        log.note(run.trials, run.moments, run.convergence);
        if (watch.estimates) add_batch(partial, size, *watch.estimates);
        return !(watch.adaptive && watch.adaptive->stable_after(partial.summary, run.moments));
    };
    const bool in_batches = watch.adaptive || watch.estimates;
    const auto bytes = bytes_of_partials([&](const Partial& partial) {
        return is_possible(partial, size, watched, in_batches, context.source.rows());
    });
    WorkEnd end = run_units(work, bytes, context.monitor);
    log.append(run.trials, run.moments, run.convergence);
    run.exact = collector.exact();
    run.tails = std::move(collector.tails());
    if (end != WorkEnd::cancelled && run.moments.count() > 0)
        end = complete_tails(context, size.per_unit, run);
    if (end == WorkEnd::cancelled) return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    return run;
}

}  // namespace covaria::detail
