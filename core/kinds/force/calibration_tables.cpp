// Tables 1 to 4 of Kim, the steps they follow from, the plan.
#include <cmath>

#include "core/kinds/force/calibration.h"
#include "core/quantity/distribution.h"
#include "core/setup/message_text.h"

namespace covaria::force {

namespace {

const Unit ratio = Unit::of("mV/V");
const Unit percent = Unit::of("%");
constexpr int ratio_decimals = 5;  // decimals of mV/V, as indicators show it

std::string key_of(const Calibration& calibration, std::size_t h) {
    return calibration.channels[h].kind().key;
}

Quantity in_load_unit(const ForceChannel& channel, double si) {
    return {channel.load_unit().from_si(si), channel.load_unit()};
}

Column ratio_column(const char* header, bool is_symbol = false) {
    return Column{header}.in(ratio).symbol(is_symbol).fixed(ratio_decimals);
}

Table plan_table(const Calibration& calibration) {
    const Plan& plan = calibration.plan;
    Table table{"plan", "Calibration as planned and as read"};
    table.add("axis");
    table.add("preloads");
    table.add("runs");
    table.add("steps");
    table.add("decreasing steps");
    table.add("spread of the preloads").in(ratio).fixed(ratio_decimals);
    table.row({tell<"planned">(), double(plan.preloads), double(plan.runs), double(plan.steps),
               plan.decreasing ? double(plan.steps - 1) : 0.0, std::monostate{}});
    for (std::size_t c = 0; c < calibration.series.size(); ++c) {
        const Series& series = calibration.series[c];
        double low = infinity, high = -infinity;
        for (const Run& run : series.preloads)
            for (const StepReading& r : run.increasing) {
                low = std::min(low, r.net[c]);
                high = std::max(high, r.net[c]);
            }
        std::size_t down = 0;
        for (const Run& run : series.runs) down = std::max(down, run.decreasing.size());
        table.row({key_of(calibration, c), double(series.preloads.size()), double(series.runs.size()),
                   double(calibration.steps[c].size()), double(down),
                   high >= low ? Cell(high - low) : Cell()});
    }
    table.notes.push_back(tell<"Fig. 2: %1 s without load before a series, %2 s at each load.">(
        Message::number(readable_number(plan.free_time)), Message::number(readable_number(plan.load_time))));
    return table;
}

Table steps_table(const Calibration& calibration) {
    Table table{"steps", "Means and standard deviations of the net values (Eqs 1 to 4)"};
    table.add("axis");
    table.add("load").figure(3);
    table.add(ratio_column("mean"));
    table.add(ratio_column("s", true));
    table.add(ratio_column("u_A", true));
    table.add("n").symbol();
    table.add(ratio_column("mean, decreasing"));
    for (std::size_t c = 0; c < calibration.size(); ++c)
        for (const StepStatistics& step : calibration.steps[c])
            table.row({key_of(calibration, c), in_load_unit(calibration.channels[c], step.load), step.mean,
                       step.s, step.s / std::sqrt(step.n), step.n,
                       std::isnan(step.decreasing_mean) ? Cell() : Cell(step.decreasing_mean)});
    return table;
}

Table table_1(const Calibration& calibration) {
    Table table{"table-1", "Rated output and non-zero error of each sensor (Kim, Table 1)"};
    table.add("sensor");
    table.add("rated load");
    table.add(ratio_column("rated output"));
    table.add(ratio_column("non-zero error"));
    for (std::size_t h = 0; h < calibration.size(); ++h) {
        const ForceChannel& channel = calibration.channels[h];
        table.row({key_of(calibration, h), in_load_unit(channel, channel.rated_load), channel.rated_output,
                   channel.zero});
    }
    return table;
}

/// Tables 2 and 4: in mV/V, or by the rated output of the sensor.
class InterferenceTable {
public:
    InterferenceTable(const Calibration& calibration, bool relative)
        : calibration_(calibration), relative_(relative) {}

    Table build() {
        Table table{relative_ ? "table-4" : "table-2",
                    relative_ ? "Interference error in per cent of the rated output (Kim, Table 4)"
                              : "Interference error of each sensor (Kim, Table 2)"};
        const bool loads = calibration_.rows_are_loads;
        table.add(loads ? "load" : "sensor");
        for (std::size_t c = 0; c < calibration_.size(); ++c) table.add(column(key_of(calibration_, c)));
        if (!loads) table.add(column("largest"));
        for (std::size_t r = 0; r < calibration_.size(); ++r) table.row(row(r, !loads));
        if (loads) table.row(largest_row());
        table.notes.push_back(
            loads ? tell<"A row is a load, a column the sensor that answers to it.">()
                  : tell<"A row is a sensor, a column the load under which it gives this output.">());
        if (!calibration_.has_signs) table.notes.push_back(tell<"Magnitudes: the signs are not known.">());
        return table;
    }

private:
    Column column(const std::string& header) const {
        return Column{header}.in(relative_ ? percent : ratio).fixed(relative_ ? 2 : ratio_decimals);
    }

    double cell(std::size_t sensor, std::size_t load) const {
        const double e = calibration_.rated_outputs(Eigen::Index(sensor), Eigen::Index(load));
        return relative_ ? e / std::abs(calibration_.channels[sensor].rated_output) : e;
    }

    std::vector<Cell> row(std::size_t r, bool with_largest) const {
        std::vector<Cell> cells{key_of(calibration_, r)};
        double largest = 0.0;
        for (std::size_t c = 0; c < calibration_.size(); ++c) {
            const double e = calibration_.rows_are_loads ? cell(c, r) : cell(r, c);
            if (c != r) largest = std::max(largest, std::abs(e));
            cells.push_back(c == r ? Cell() : Cell(e));
        }
        if (with_largest) cells.push_back(largest);
        return cells;
    }

    std::vector<Cell> largest_row() const {
        std::vector<Cell> cells{tell<"largest">()};
        for (std::size_t h = 0; h < calibration_.size(); ++h)
            cells.push_back(calibration_.largest_interference(h) /
                            (relative_ ? std::abs(calibration_.channels[h].rated_output) : 1.0));
        return cells;
    }

    const Calibration& calibration_;
    bool relative_;
};

Table table_3(const Calibration& calibration) {
    Table table{"table-3", "Uncertainty of the sensors by the paper (Kim, Table 3, Eqs 4 to 12)"};
    table.add("sensor");
    table.add(ratio_column("u_A", true));
    table.add(ratio_column("u_B", true));
    table.add(ratio_column("hysteresis"));
    table.add(ratio_column("interference"));
    table.add(ratio_column("u_c", true));
    table.add(ratio_column("U", true));
    table.add("U").in(percent).symbol().fixed(2);
    table.add("U, load").fixed(4);
    for (std::size_t h = 0; h < calibration.size(); ++h) {
        const ForceChannel& channel = calibration.channels[h];
        const double relative = calibration.U(h) / std::abs(channel.rated_output);
        table.row({key_of(calibration, h), channel.u_a, calibration.u_b(h), channel.hysteresis,
                   calibration.largest_interference(h), calibration.u_c(h), calibration.U(h), relative,
                   in_load_unit(channel, relative * channel.rated_load)});
    }
    const ForceChannel& first = calibration.channels.front();
    table.notes.push_back(
        tell<"U = hysteresis + interference + k u_c with k = %1: a linear sum of two largest values and an "
             "expanded uncertainty. Type A: n = %2 runs, %3 degrees of freedom.">(
            readable_number(calibration.k), readable_number(first.runs),
            readable_number(first.degrees_of_freedom)));
    return table;
}

Table parts_table(const Calibration& calibration) {
    Table table{"type-b", "Parts of the Type B standard uncertainty (Eqs 5 to 8)"};
    table.add("sensor");
    for (const char* const header : {"u_CM", "u_r", "u_z", "u_B"})
        table.add(header).in(ratio).symbol().fixed(6);
    bool any_stated = false;
    for (std::size_t h = 0; h < calibration.size(); ++h) {
        table.row({key_of(calibration, h), calibration.u_calibrator(h), calibration.u_resolution(),
                   calibration.u_zero(h), calibration.u_b_computed(h)});
        any_stated = any_stated || calibration.stated_u_b[h].has_value();
    }
    table.notes.push_back(tell<"Calibration machine: %1.">(calibration.calibrator.name));
    if (any_stated)
        table.notes.push_back(
            tell<"Table 3 takes the Type B standard uncertainties that are stated, not these.">());
    return table;
}

}  // namespace

std::vector<Table> calibration_tables(const Calibration& calibration) {
    std::vector<Table> tables;
    if (calibration.from_readings) tables.push_back(plan_table(calibration));
    tables.push_back(table_1(calibration));
    tables.push_back(InterferenceTable(calibration, false).build());
    tables.push_back(table_3(calibration));
    tables.push_back(InterferenceTable(calibration, true).build());
    tables.push_back(parts_table(calibration));
    if (calibration.from_readings) tables.push_back(steps_table(calibration));
    if (!calibration.stated.empty() || !calibration.stated_interference.empty())
        tables.push_back(stated_table(calibration));
    return tables;
}

}  // namespace covaria::force
