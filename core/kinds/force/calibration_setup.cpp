// Reads the table of readings into series and says what is missing or cannot be.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/kinds/force/calibration.h"
#include "core/setup/message_text.h"

namespace covaria::force {

namespace {

constexpr int most_messages = 8;

/// "Nm" is what indicators write; the program's units are products.
std::string unit_text(std::string text) {
    std::erase(text, ' ');
    static const std::map<std::string, std::string> products{
        {"Nm", "N*m"}, {"N.m", "N*m"}, {"Nmm", "N*mm"}, {"kNm", "kN*m"}, {"mNm", "mN*m"}};
    const auto known = products.find(text);
    return known == products.end() ? text : known->second;
}

using Reading = StatedSensor::Reading;
using Phase = StatedSensor::Phase;

class SeriesReader {
public:
    SeriesReader(Calibration& calibration, Problems& problems)
        : calibration_(calibration), problems_(problems) {}

    void read() {
        calibration_.series.assign(calibration_.size(), {});
        for (row_ = 0; row_ < calibration_.readings.size(); ++row_) {
            if (messages_ >= most_messages) return;
            read_row(calibration_.readings[row_]);
        }
        if (calibration_.readings.empty())
            problems_.error(
                sensor_fields().place(&StatedSensor::readings),
                tell<"there are no readings: import them from a CSV file, or choose summary tables">());
        for (Series& series : calibration_.series)
            for (std::vector<Run>* runs : {&series.preloads, &series.runs})
                for (Run& run : *runs) finish(run);
    }

private:
    template <class M>
    void refuse(M Reading::*column, const Message& message, std::size_t element = 0) {
        problems_.error(sensor_fields().place(&StatedSensor::readings, row_, column, element), message);
        ++messages_;
    }

    void read_row(const Reading& row) {
        const auto channel = calibration_.channel_of(row.loaded_axis);
        if (!channel)
            return refuse(&Reading::loaded_axis,
                          tell<"the sensor has no channel %1: list it among its channels">(
                              force_axes[row.loaded_axis].key));
        const auto load = load_of(row, calibration_.channels[*channel]);
        const auto readings = readings_of(row);
        if (!load || !readings) return;
        Series& series = calibration_.series[*channel];
        put(row, run_of(row.preload ? series.preloads : series.runs, row.run), *load, *readings);
    }

    static Run& run_of(std::vector<Run>& runs, int number) {
        for (Run& run : runs)
            if (run.number == number) return run;
        runs.push_back({});
        runs.back().number = number;
        return runs.back();
    }

    std::optional<double> load_of(const Reading& row, const ForceChannel& channel) {
        Unit unit = channel.load_unit();
        const std::string name = channel.kind().key;
        if (const std::string& given = row.load_unit; !given.empty()) {
            const Result<Unit> parsed = Unit::parse(unit_text(given));
            if (!parsed) {
                refuse(&Reading::load_unit,
                       tell<"'%1' is no unit of a load: %2">(given, parsed.error().message));
                return {};
            }
            if (parsed->dimension() != unit.dimension()) {
                refuse(&Reading::load_unit, channel.kind().is_moment
                                                ? tell<"%1 is a moment, but its load is in %2: are forces "
                                                       "and moments, or their units, exchanged?">(name, given)
                                                : tell<"%1 is a force, but its load is in %2: are forces and "
                                                       "moments, or their units, exchanged?">(name, given));
                return {};
            }
            unit = *parsed;
        }
        const double load = unit.to_si(row.load);
        if (std::abs(load) > 1.2 * channel.rated_load) {
            refuse(&Reading::load,
                   tell<"a load of %1 is more than 1.2 times the rated load of %2, %3: is its unit right?">(
                       quantity_words(channel.load_unit().from_si(load), channel.load_unit()), name,
                       quantity_words(channel.load_unit().from_si(channel.rated_load), channel.load_unit())));
            return {};
        }
        return load;
    }

    std::optional<Readings> readings_of(const Reading& row) {
        Readings readings{};
        for (std::size_t h = 0; h < calibration_.size(); ++h) {
            const ForceChannel& channel = calibration_.channels[h];
            const std::optional<double>& indicated = row.indicated[channel.axis];

            if (!indicated) {
                refuse(&Reading::indicated, tell<"channel %1 has no reading in this row">(channel.kind().key),
                       channel.axis);
                return {};
            }
            readings[h] = *indicated;
            if (calibration_.range && std::abs(readings[h]) >= *calibration_.range) {
                refuse(&Reading::indicated,
                       tell<"channel %1 indicates %2 mV/V, which is the end of the indicator's range: the "
                            "reading is saturated">(channel.kind().key, readable_number(1e3 * readings[h])),
                       channel.axis);
                return {};
            }
        }
        return readings;
    }

    void put(const Reading& row, Run& run, double load, const Readings& readings) {
        const double time = row.time.value_or(std::nan(""));
        if (row.phase == Phase::zero_before || row.phase == Phase::zero_after) {
            const bool before = row.phase == Phase::zero_before;
            auto& zero = before ? run.zero_before : run.zero_after;
            if (zero) return refuse(&Reading::phase, tell<"this run has its unloaded reading already">());
            zero = readings;
            (before ? run.time_before : run.time_after) = time;
            return;
        }
        const StepReading reading{row.step, load, readings, time};
        std::vector<StepReading>& steps = row.phase == Phase::decreasing ? run.decreasing : run.increasing;
        for (const StepReading& known : steps)
            if (known.step == reading.step)
                return refuse(&Reading::step, tell<"step %1 of this run is given twice">(reading.step));
        steps.push_back(reading);
    }

    /// Net values (Eq 1), in the order of the loads.
    static void finish(Run& run) {
        const auto by_load = [](const StepReading& a, const StepReading& b) { return a.load < b.load; };
        for (std::vector<StepReading>* steps : {&run.increasing, &run.decreasing}) {
            std::sort(steps->begin(), steps->end(), by_load);
            if (!run.zero_before) continue;
            for (StepReading& step : *steps)
                for (std::size_t h = 0; h < most_channels; ++h) step.net[h] -= (*run.zero_before)[h];
        }
    }

    Calibration& calibration_;
    Problems& problems_;
    std::size_t row_ = 0;  ///< row that is being read
    int messages_ = 0;
};

}  // namespace

const StepReading* Run::decreasing_at(int step) const {
    for (const StepReading& reading : decreasing)
        if (reading.step == step) return &reading;
    return nullptr;
}

void read_series(Calibration& calibration, Problems& problems) {
    SeriesReader(calibration, problems).read();
}

void read_summary(Calibration& calibration, Problems& problems) {
    const std::size_t n = calibration.size();
    Eigen::MatrixXd& outputs = calibration.rated_outputs;
    outputs.setZero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    std::vector<bool> stated(n, false), crossed(n, false);
    for (const StatedSensor::Summary& row : calibration.summary) {
        const auto h = calibration.channel_of(row.axis);
        if (!h) continue;
        stated[*h] = true;
        ForceChannel& channel = calibration.channels[*h];
        channel.rated_output = row.rated_output;
        channel.zero = row.zero_error;
        channel.u_a = row.u_A;
        channel.hysteresis = row.hysteresis;
        calibration.stated_u_b[*h] = row.u_B;
        const auto i = static_cast<Eigen::Index>(*h);
        outputs(i, i) = channel.rated_output;
    }
    for (const Interference& row : calibration.interference) {
        const auto h = calibration.channel_of(row.axis);
        if (!h) continue;
        crossed[*h] = true;
        for (std::size_t c = 0; c < n; ++c) {
            const std::optional<double>& figure = row.figures[calibration.channels[c].axis];
            if (c == *h || !figure) continue;
            const auto i = static_cast<Eigen::Index>(*h), j = static_cast<Eigen::Index>(c);
            (calibration.rows_are_loads ? outputs(j, i) : outputs(i, j)) = *figure;
        }
    }
    for (std::size_t h = 0; h < n; ++h) {
        const std::string name = calibration.channels[h].kind().key;
        if (!stated[h])
            problems.error(sensor_fields().place(&StatedSensor::summary),
                           tell<"channel %1 has no row in the summary">(name));
        if (!crossed[h])
            problems.warning(sensor_fields().place(&StatedSensor::interference),
                             tell<"%1 has no row in the table of interference: taken as zero">(name));
    }
}

}  // namespace covaria::force
