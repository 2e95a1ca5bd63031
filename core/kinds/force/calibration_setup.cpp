// Reads the table of readings into series and says what is missing or cannot be.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/kinds/force/calibration.h"
#include "core/setup/message_text.h"

namespace covaria::force {

namespace {

constexpr int most_messages = 8;

std::string path_of(std::size_t row) {
    return "/readings/rows/" + std::to_string(row);
}

/// "Nm" is what indicators write; the program's units are products.
std::string unit_text(std::string text) {
    std::erase(text, ' ');
    static const std::map<std::string, std::string> products{
        {"Nm", "N*m"}, {"N.m", "N*m"}, {"Nmm", "N*mm"}, {"kNm", "kN*m"}, {"mNm", "mN*m"}};
    const auto known = products.find(text);
    return known == products.end() ? text : known->second;
}

class SeriesReader {
public:
    SeriesReader(const SetupReader& setup, Calibration& calibration, Problems& problems)
        : setup_(setup), calibration_(calibration), problems_(problems) {}

    void read() {
        calibration_.series.assign(calibration_.size(), {});
        for (std::size_t row = 0; row < setup_.rows("readings"); ++row) {
            if (messages_ >= most_messages) return;
            read_row(row);
        }
        if (setup_.rows("readings") == 0)
            problems_.error("/readings",
                            "there are no readings: import them from a CSV file, or choose summary tables");
        for (Series& series : calibration_.series)
            for (std::vector<Run>* runs : {&series.preloads, &series.runs})
                for (Run& run : *runs) finish(run);
    }

private:
    void refuse(std::size_t row, const std::string& column, const std::string& message) {
        problems_.error(path_of(row) + "/" + column, message);
        ++messages_;
    }

    std::string text(std::size_t row, const char* column) const {
        return setup_.cell_text("readings", row, column);
    }

    void read_row(std::size_t row) {
        const std::string axis = text(row, "loaded_axis");
        const auto channel = calibration_.channel_of(axis_index(axis));
        if (!channel)
            return refuse(row, "loaded_axis",
                          "the sensor has no channel " + axis + ": list it among its channels");
        const auto load = load_of(row, calibration_.channels[*channel]);
        const auto readings = readings_of(row);
        if (!load || !readings) return;
        Series& series = calibration_.series[*channel];
        const bool preload = text(row, "series") == "preload";
        const int number = static_cast<int>(setup_.cell_number("readings", row, "run"));
        put(row, run_of(preload ? series.preloads : series.runs, number), *load, *readings);
    }

    static Run& run_of(std::vector<Run>& runs, int number) {
        for (Run& run : runs)
            if (run.number == number) return run;
        runs.push_back({});
        runs.back().number = number;
        return runs.back();
    }

    std::optional<double> load_of(std::size_t row, const ForceChannel& channel) {
        Unit unit = channel.load_unit();
        const std::string name = channel.kind().key;
        if (!setup_.cell_empty("readings", row, "load_unit")) {
            const std::string given = text(row, "load_unit");
            const Result<Unit> parsed = Unit::parse(unit_text(given));
            if (!parsed) {
                refuse(row, "load_unit", "'" + given + "' is no unit of a load: " + parsed.error().message);
                return {};
            }
            if (parsed->dimension() != unit.dimension()) {
                refuse(row, "load_unit",
                       name + (channel.kind().is_moment ? " is a moment" : " is a force") +
                           ", but its load is in " + given +
                           ": are forces and moments, or their units, exchanged?");
                return {};
            }
            unit = *parsed;
        }
        const double load = unit.to_si(setup_.cell_number("readings", row, "load"));
        if (std::abs(load) > 1.2 * channel.rated_load) {
            refuse(row, "load",
                   "a load of " + quantity_words(channel.load_unit().from_si(load), channel.load_unit()) +
                       " is more than 1.2 times the rated load of " + name + ", " +
                       quantity_words(channel.load_unit().from_si(channel.rated_load), channel.load_unit()) +
                       ": is its unit right?");
            return {};
        }
        return load;
    }

    std::optional<Readings> readings_of(std::size_t row) {
        Readings readings{};
        for (std::size_t h = 0; h < calibration_.size(); ++h) {
            const char* const key = calibration_.channels[h].kind().key;
            if (setup_.cell_empty("readings", row, key)) {
                refuse(row, key, std::string("channel ") + key + " has no reading in this row");
                return {};
            }
            readings[h] = setup_.cell_number("readings", row, key);
            if (calibration_.range && std::abs(readings[h]) >= *calibration_.range) {
                refuse(row, key,
                       std::string("channel ") + key + " indicates " + readable_number(1e3 * readings[h]) +
                           " mV/V, which is the end of the indicator's range: the reading is saturated");
                return {};
            }
        }
        return readings;
    }

    void put(std::size_t row, Run& run, double load, const Readings& readings) {
        const std::string phase = text(row, "phase");
        const double time =
            setup_.cell_empty("readings", row, "t") ? std::nan("") : setup_.cell_number("readings", row, "t");
        if (phase == "zero_before" || phase == "zero_after") {
            auto& zero = phase == "zero_before" ? run.zero_before : run.zero_after;
            if (zero) return refuse(row, "phase", "this run has its unloaded reading already");
            zero = readings;
            (phase == "zero_before" ? run.time_before : run.time_after) = time;
            return;
        }
        StepReading reading;
        reading.step = static_cast<int>(setup_.cell_number("readings", row, "step"));
        reading.load = load;
        reading.net = readings;
        reading.time = time;
        std::vector<StepReading>& steps = phase == "decreasing" ? run.decreasing : run.increasing;
        for (const StepReading& known : steps)
            if (known.step == reading.step)
                return refuse(row, "step",
                              "step " + std::to_string(reading.step) + " of this run is given twice");
        steps.push_back(std::move(reading));
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

    const SetupReader& setup_;
    Calibration& calibration_;
    Problems& problems_;
    int messages_ = 0;
};

}  // namespace

const StepReading* Run::decreasing_at(int step) const {
    for (const StepReading& reading : decreasing)
        if (reading.step == step) return &reading;
    return nullptr;
}

void read_series(const SetupReader& setup, Calibration& calibration, Problems& problems) {
    SeriesReader(setup, calibration, problems).read();
}

void read_summary(const SetupReader& setup, Calibration& calibration, Problems& problems) {
    const std::size_t n = calibration.size();
    calibration.rated_outputs.setZero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    std::vector<bool> stated(n, false), crossed(n, false);
    for (std::size_t row = 0; row < setup.rows("summary"); ++row) {
        const auto h = calibration.channel_of(axis_index(setup.cell_text("summary", row, "axis")));
        if (!h) continue;
        stated[*h] = true;
        ForceChannel& channel = calibration.channels[*h];
        channel.rated_output = setup.cell_number("summary", row, "rated_output");
        channel.zero = setup.cell_number("summary", row, "zero_error");
        channel.u_a = setup.cell_number("summary", row, "u_A");
        channel.hysteresis = setup.cell_number("summary", row, "hysteresis");
        if (!setup.cell_empty("summary", row, "u_B"))
            calibration.stated_u_b[*h] = setup.cell_number("summary", row, "u_B");
        const auto i = static_cast<Eigen::Index>(*h);
        calibration.rated_outputs(i, i) = channel.rated_output;
    }
    for (std::size_t row = 0; row < setup.rows("interference"); ++row) {
        const auto h = calibration.channel_of(axis_index(setup.cell_text("interference", row, "axis")));
        if (!h) continue;
        crossed[*h] = true;
        for (std::size_t c = 0; c < n; ++c) {
            const char* const key = calibration.channels[c].kind().key;
            if (c == *h || setup.cell_empty("interference", row, key)) continue;
            const auto i = static_cast<Eigen::Index>(*h), j = static_cast<Eigen::Index>(c);
            (calibration.rows_are_loads ? calibration.rated_outputs(j, i) : calibration.rated_outputs(i, j)) =
                setup.cell_number("interference", row, key);
        }
    }
    for (std::size_t h = 0; h < n; ++h) {
        const std::string name = calibration.channels[h].kind().key;
        if (!stated[h]) problems.error("/summary", "channel " + name + " has no row in the summary");
        if (!crossed[h])
            problems.warning("/interference",
                             name + " has no row in the table of interference: taken as zero");
    }
}

namespace {

Stated stated_values(const SetupReader& setup, const std::string& table, const FieldSpec& field,
                     const Calibration& calibration) {
    Stated stated;
    for (std::size_t c = 1; c < field.columns.size(); ++c) {
        stated.headers.push_back(field.columns[c].key);
        stated.titles.push_back(field.columns[c].title);
        stated.units.push_back(field.columns[c].unit);
    }
    for (std::size_t row = 0; row < setup.rows(table); ++row) {
        const auto h = calibration.channel_of(axis_index(setup.cell_text(table, row, "axis")));
        if (!h) continue;
        StatedRow values{*h, {}};
        for (const std::string& key : stated.headers)
            values.values.push_back(setup.cell_empty(table, row, key) ? std::nan("")
                                                                      : setup.cell_number(table, row, key));
        stated.rows.push_back(std::move(values));
    }
    return stated;
}

}  // namespace

void read_stated(const SetupReader& setup, Calibration& calibration) {
    static const SetupSchema schema = sensor_schema();
    calibration.stated = stated_values(setup, "stated", *schema.find("stated"), calibration);
    calibration.stated_interference =
        stated_values(setup, "stated_interference", *schema.find("stated_interference"), calibration);
}

}  // namespace covaria::force
