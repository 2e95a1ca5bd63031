// Pilot: thresholds of the tails and grids of the cells.
#include "core/propagation/pilot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {
namespace {

constexpr std::size_t enough_values = 1000;
using Columns = std::vector<std::vector<double>>;  // values of each output

WorkEnd append_trials(const RunContext& context, std::uint64_t first, std::uint64_t count, Columns& columns) {
    OrderedWork<Columns> work;
    work.units = (count + block_trials - 1) / block_trials;
    work.make_partial = [&context] { return Columns(context.source.rows()); };
    work.make_worker = [&] {
        return [&, runner = std::make_shared<TrialBlockRunner>(context.source)](std::uint64_t block,
                                                                                Columns& part) {
            const std::uint64_t begin = block * block_trials;
            runner->run(first + begin, std::min<std::uint64_t>(block_trials, count - begin));
            for (std::size_t j = 0; j < part.size(); ++j)
                part[j].assign(runner->output(j), runner->output(j) + runner->valid());
            return context.monitor.advance(0);
        };
    };
    work.merge = [&columns](std::uint64_t, Columns& part) {
        for (std::size_t j = 0; j < part.size(); ++j)
            columns[j].insert(columns[j].end(), part[j].begin(), part[j].end());
        return true;
    };
    return run_in_order(work, context.monitor);
}

/// Five standard uncertainties about the mean, or to the end of a bounded distribution. With heavy tails
/// the spread is taken from the central 95 %.
CellGrid grid_of(const std::vector<double>& sorted) {
    const auto n = static_cast<double>(sorted.size());
    const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / n;
    double squares = 0.0;
    for (double y : sorted) squares += (y - mean) * (y - mean);
    const double central =
        sorted[static_cast<std::size_t>(0.975 * (n - 1))] - sorted[static_cast<std::size_t>(0.025 * (n - 1))];
    const double spread = std::min(std::sqrt(squares / n), central > 0 ? central / 2.6 : infinity);
    const double centre = std::clamp(mean, sorted.front(), sorted.back());
    if (!(sorted.back() > sorted.front()) || !(spread > 0)) return {centre, centre};
    const double pad = 0.005 * (sorted.back() - sorted.front());
    CellGrid grid{centre - 5 * spread, centre + 5 * spread};
    if (sorted.front() > centre - 2.6 * spread) grid.low = sorted.front() - pad;
    if (sorted.back() < centre + 2.6 * spread) grid.high = sorted.back() + pad;
    return grid;
}

std::vector<RepeatedValue> repeated_values(const std::vector<double>& sorted) {
    std::vector<RepeatedValue> repeated;
    for (auto from = sorted.begin(); from != sorted.end();) {
        const auto to = std::upper_bound(from, sorted.end(), *from);
        if (to - from > 1)
            repeated.push_back({*from, static_cast<double>(to - from) / static_cast<double>(sorted.size())});
        from = to;
    }
    return repeated;
}

double squared_correlation(const std::vector<double>& y, const std::vector<double>& linear) {
    const auto n = static_cast<double>(y.size());
    const double mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
    const double mean_of_linear = std::accumulate(linear.begin(), linear.end(), 0.0) / n;
    double yy = 0.0, ll = 0.0, yl = 0.0;
    for (std::size_t t = 0; t < y.size(); ++t) {
        const double a = y[t] - mean, b = linear[t] - mean_of_linear;
        yy += a * a;
        ll += b * b;
        yl += a * b;
    }
    return yl * yl / (yy * ll);
}

/// Thresholds only; nothing else is made of linear parts.
OutputPilot look_at_linear_part(std::vector<double>& values, double tail_fraction) {
    OutputPilot pilot;
    const auto rank = static_cast<std::size_t>(tail_fraction * static_cast<double>(values.size()));
    if (rank >= values.size() || 2 * rank >= values.size()) {
        pilot.low = {infinity, 0.0};
        pilot.high = {-infinity, 0.0};
        return pilot;
    }
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(rank);
    const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), low, values.end());
    pilot.low.threshold = *low;
    std::nth_element(low, high, values.end());
    pilot.high.threshold = *high;
    return pilot;
}

}  // namespace

OutputPilot look_at(std::vector<double>& values, double tail_fraction) {
    std::sort(values.begin(), values.end());
    OutputPilot pilot;
    pilot.median = values[values.size() / 2];
    pilot.minimum = values.front();
    pilot.maximum = values.back();
    pilot.grid = grid_of(values);
    pilot.repeated = repeated_values(values);
    const auto rank = static_cast<std::size_t>(tail_fraction * static_cast<double>(values.size()));
    if (rank >= values.size()) {
        pilot.low = {infinity, 0.0};
        pilot.high = {-infinity, 0.0};
    } else {
        pilot.low = {values[rank], pilot.median - values[rank]};
        pilot.high = {values[values.size() - 1 - rank], values[values.size() - 1 - rank] - pilot.median};
        pilot.low.scale = std::abs(pilot.low.scale);
        pilot.high.scale = std::abs(pilot.high.scale);
    }
    return pilot;
}

OutputPilot widened(const OutputPilot& pilot) {
    OutputPilot wide = pilot;
    const double scale = std::max(pilot.maximum - pilot.minimum, std::abs(pilot.median) * 1e-12);
    wide.low = {pilot.maximum, scale};
    wide.high = {pilot.minimum, scale};
    return wide;
}

double tail_fraction_of(std::size_t values, double probability, double margin) {
    const double f = 1.0 - probability;
    const auto n = static_cast<double>(values);
    return std::clamp(f + margin * (std::sqrt(f * (1 - f) / n) + 1 / n), 0.0, 1.0);
}

Eigen::VectorXd Pilot::shift() const {
    Eigen::VectorXd shift(static_cast<Eigen::Index>(outputs.size()));
    for (std::size_t j = 0; j < outputs.size(); ++j) shift(static_cast<Eigen::Index>(j)) = outputs[j].median;
    return shift;
}

void Pilot::drop_linear_parts(const std::vector<bool>& dropped) {
    std::vector<OutputPilot> kept(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(own));
    std::vector<double> kept_explained;
    for (std::size_t k = 0; k < dropped.size(); ++k) {
        if (dropped[k]) continue;
        kept.push_back(outputs[own + k]);
        kept_explained.push_back(explained[k]);
    }
    outputs = std::move(kept);
    explained = std::move(kept_explained);
    std::vector<OutputBlocks::Block> kept_blocks;
    for (const OutputBlocks::Block& block : linear_blocks.list()) {
        Eigen::Index size = 0;
        for (Eigen::Index k = block.first; k < block.first + block.size; ++k)
            size += !dropped[static_cast<std::size_t>(k)];
        const Eigen::Index first =
            kept_blocks.empty() ? 0 : kept_blocks.back().first + kept_blocks.back().size;
        if (size > 0) kept_blocks.push_back({first, size});
    }
    linear_blocks = OutputBlocks(std::move(kept_blocks));
}

namespace {

/// Linear parts are in the order of their outputs.
OutputBlocks blocks_of(const LinearRows& rows, const OutputBlocks& of_outputs) {
    std::vector<OutputBlocks::Block> blocks;
    std::optional<std::size_t> block;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const std::size_t own = of_outputs.block_of(static_cast<Eigen::Index>(rows[k].output));
        if (block != own) blocks.push_back({static_cast<Eigen::Index>(k), 0});
        ++blocks.back().size;
        block = own;
    }
    return OutputBlocks(std::move(blocks));
}

}  // namespace

Result<Pilot> run_pilot(const RunContext& context, std::uint64_t limit) {
    Columns columns(context.source.rows());
    for (std::uint64_t first = 0; first < limit && columns.front().size() < enough_values;
         first += unit_trials) {
        const std::uint64_t count = std::min(unit_trials, limit - first);
        if (append_trials(context, first, count, columns) == WorkEnd::cancelled)
            return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    }
    const std::size_t n = columns.front().size();
    if (n == 0)
        return fail(
            ErrorCode::numeric,
            tell<"none of the trials has a value: the measurement model cannot be evaluated within the "
                 "uncertainties of its inputs; check the standard uncertainties and the geometry">());
    Pilot pilot;
    if (n >= enough_values)
        pilot.tail_fraction = tail_fraction_of(n, context.probability, context.settings.tail_margin);
    pilot.own = context.source.outputs();
    pilot.blocks = OutputBlocks::of(context.source.model->outputs());
    if (context.source.linear) pilot.linear_blocks = blocks_of(*context.source.linear, pilot.blocks);
    for (std::size_t k = 0; context.source.linear && k < context.source.linear->size(); ++k)
        pilot.explained.push_back(
            squared_correlation(columns[(*context.source.linear)[k].output], columns[pilot.own + k]));
    for (std::size_t j = 0; j < columns.size(); ++j) {
        pilot.outputs.push_back(j < pilot.own ? look_at(columns[j], pilot.tail_fraction)
                                              : look_at_linear_part(columns[j], pilot.tail_fraction));
        if (j < pilot.own) divide_cells(columns[j], pilot.outputs.back().grid);
    }
    return pilot;
}

}  // namespace covaria::detail
