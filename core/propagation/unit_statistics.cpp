// Statistics of one unit of trials.
#include "core/propagation/unit_statistics.h"

#include <algorithm>
#include <numeric>

namespace covaria::detail {

void OutsideValues::clear() {
    values.clear();
    equal_low = equal_high = 0;
}

void OutsideValues::add(const OutputPilot& pilot, const double* y, std::size_t n) {
    // Written without branches: which values lie outside cannot be predicted.
    double found[block_trials];
    std::size_t count = 0;
    const double low = pilot.low.threshold, high = pilot.high.threshold;
    for (std::size_t t = 0; t < n; ++t) {
        found[count] = y[t];
        count += static_cast<std::size_t>((y[t] < low) | (y[t] > high));
    }
    std::uint64_t at_low = 0, at_high = 0;
    for (std::size_t t = 0; t < n; ++t) {
        at_low += y[t] == low;
        at_high += y[t] == high;
    }
    values.insert(values.end(), found, found + count);
    equal_low += at_low;
    equal_high += at_high;
}

UnitStatistics::UnitStatistics(const Pilot& pilot)
    : moments(pilot.moments()), outside(pilot.outputs.size()), cells(pilot.own * CellGrid::counters) {
    std::size_t all_parts = 0;
    for (std::size_t j = 0; j < pilot.own; ++j) all_parts += parts_of(pilot.outputs[j].grid);
    parts.resize(all_parts);
    const double expected = 2.2 * pilot.tail_fraction * static_cast<double>(unit_trials) + 500;
    for (OutsideValues& o : outside) o.values.reserve(static_cast<std::size_t>(expected));
}

void UnitStatistics::clear() {
    moments.clear();
    for (OutsideValues& o : outside) o.clear();
    std::fill(cells.begin(), cells.end(), 0u);
    std::fill(parts.begin(), parts.end(), 0u);
    trials = 0;
}

void UnitStatistics::add(const Pilot& pilot, const TrialBlockRunner& runner, TrialRows& scratch) {
    trials += runner.trials();
    moments.add(runner.output(0), runner.valid(), scratch);
    std::uint32_t* parts_of_output = parts.data();
    for (std::size_t j = 0; j < outside.size(); ++j) {
        outside[j].add(pilot.outputs[j], runner.output(j), runner.valid());
        if (j >= pilot.own) continue;
        count_cells(pilot.outputs[j].grid, runner.output(j), runner.valid(),
                    cells.data() + j * CellGrid::counters, parts_of_output);
        parts_of_output += parts_of(pilot.outputs[j].grid);
    }
}

void UnitStatistics::write(ByteWriter& writer) const {
    writer.put(trials);
    moments.write(writer);
    for (const OutsideValues& o : outside) {
        writer.put_list(o.values);
        writer.put(o.equal_low);
        writer.put(o.equal_high);
    }
    writer.put_all(std::span<const std::uint32_t>(cells));
    writer.put_all(std::span<const std::uint32_t>(parts));
}

void UnitStatistics::read(ByteReader& reader) {
    trials = reader.get<std::uint64_t>();
    moments.read(reader);
    for (OutsideValues& o : outside) {
        reader.get_list(o.values);
        o.equal_low = reader.get<std::uint64_t>();
        o.equal_high = reader.get<std::uint64_t>();
    }
    reader.get_all(std::span<std::uint32_t>(cells));
    reader.get_all(std::span<std::uint32_t>(parts));
}

bool UnitStatistics::is_possible(std::uint64_t most) const {
    if (trials == 0 || trials > most || moments.count() > trials) return false;
    for (const OutsideValues& o : outside) {
        const bool numbers = std::none_of(o.values.begin(), o.values.end(), [](double y) { return y != y; });
        if (!numbers || o.values.size() > trials || o.equal_low > trials || o.equal_high > trials)
            return false;
    }
    for (std::size_t j = 0; j < cells.size(); j += CellGrid::counters) {
        const auto first = cells.begin() + static_cast<std::ptrdiff_t>(j);
        if (std::accumulate(first, first + CellGrid::counters, std::uint64_t{0}) != moments.count())
            return false;
    }
    return std::all_of(parts.begin(), parts.end(), [this](std::uint32_t n) { return n <= trials; });
}

}  // namespace covaria::detail
