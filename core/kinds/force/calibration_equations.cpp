// Results of the readings of a calibration (Kim, Eqs 1 to 12).
#include <algorithm>
#include <cmath>
#include <set>

#include "core/kinds/force/calibration.h"
#include "core/quantity/type_a.h"
#include "core/setup/message_text.h"

namespace covaria::force {

namespace {

Eigen::Index at(std::size_t i) {
    return static_cast<Eigen::Index>(i);
}

std::string text_in_millivolts(double ratio) {
    return readable_number(std::round(1e8 * ratio) / 1e5) + " mV/V";
}

double mean_of(const std::vector<double>& values) {
    if (values.empty()) return std::nan("");
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Steps of all runs by rising load, still without figures.
std::vector<StepStatistics> steps_of(const std::vector<Run>& runs) {
    std::vector<StepStatistics> steps;
    for (const Run& run : runs)
        for (const StepReading& reading : run.increasing)
            if (std::ranges::find(steps, reading.step, &StepStatistics::step) == steps.end())
                steps.push_back({reading.step, reading.load, 0.0, 0.0, 0.0, 0.0});
    std::ranges::sort(steps, {}, &StepStatistics::load);
    return steps;
}

class SeriesEvaluation {
public:
    SeriesEvaluation(Calibration& calibration, std::size_t channel, Problems& problems)
        : calibration_(calibration), c_(channel), problems_(problems) {}

    void run() {
        if (!check_runs()) return;
        steps() = steps_of(series().runs);
        statistics();
        check_steps();
        if (!check_rated_load()) return;
        rated_outputs();
        channel().zero = largest_zero();
        channel().hysteresis = largest_hysteresis();
        check_saturation();
        check_times();
    }

private:
    ForceChannel& channel() { return calibration_.channels[c_]; }
    Series& series() { return calibration_.series[c_]; }
    std::vector<StepStatistics>& steps() { return calibration_.steps[c_]; }
    std::string name() { return channel().kind().key; }

    bool check_runs() {
        std::vector<Run>& runs = series().runs;
        std::erase_if(runs, [&](const Run& run) {
            if (!run.increasing.empty() && run.zero_before) return false;
            warn(tell<"run %1 of %2 has no %3: it is left out">(
                run.number, name(),
                (run.zero_before ? tell<"increasing loads">() : tell<"unloaded reading before">())));
            return true;
        });
        const std::size_t planned = static_cast<std::size_t>(calibration_.plan.runs);
        if (runs.empty())
            return refuse(tell<"%1 was not calibrated: there are no runs with its axis loaded">(name()));
        if (runs.size() == 1)
            return refuse(tell<"%1 has one run only: its repeatability needs two or more">(name()));
        if (runs.size() < planned)
            warn(tell<"%1 has %2 runs, %3 are planned: its means have %4 degrees of freedom">(
                name(), runs.size(), planned, runs.size() - 1));
        if (series().preloads.size() < static_cast<std::size_t>(calibration_.plan.preloads))
            warn(tell<"%1 has %2 preloads, %3 are planned">(name(), series().preloads.size(),
                                                            calibration_.plan.preloads));
        return true;
    }

    bool refuse(const Message& message) {
        problems_.error(sensor_fields().place(&StatedSensor::readings), message);
        return false;
    }
    void warn(const Message& message) {
        problems_.warning(sensor_fields().place(&StatedSensor::readings), message);
    }

    /// Eqs 2 to 4, and the deviations of all steps pooled.
    void statistics() {
        double squares = 0.0, freedom = 0.0;
        for (StepStatistics& step : steps()) {
            std::vector<double> up, down;
            for (const Run& run : series().runs) {
                for (const StepReading& r : run.increasing)
                    if (r.step == step.step) up.push_back(r.net[c_]);
                if (const StepReading* r = run.decreasing_at(step.step)) down.push_back(r->net[c_]);
            }
            step.n = static_cast<double>(up.size());
            step.mean = mean_of(up);
            step.decreasing_mean = mean_of(down);
            const auto type_a = type_a_evaluation(up);
            if (!type_a) continue;
            step.s = type_a->standard_deviation;
            squares += type_a->degrees_of_freedom * step.s * step.s;
            freedom += type_a->degrees_of_freedom;
            if (type_a->standard_uncertainty < channel().u_a) continue;
            channel().u_a = type_a->standard_uncertainty;
            channel().degrees_of_freedom = type_a->degrees_of_freedom;
            channel().runs = step.n;
        }
        channel().pooled_degrees_of_freedom = freedom;
        channel().s_pooled = freedom > 0.0 ? std::sqrt(squares / freedom) : 0.0;
    }

    void check_steps() {
        for (const StepStatistics& step : steps()) {
            if (step.n >= static_cast<double>(series().runs.size())) continue;
            warn(tell<"step %1 of %2 is missing in %3 of %4 runs: its mean is that of %5%6">(
                step.step, name(), series().runs.size() - static_cast<std::size_t>(step.n),
                series().runs.size(), readable_number(step.n),
                (step.n < 2.0 ? tell<", and it says nothing about repeatability">() : Message())));
        }
        if (steps().size() < static_cast<std::size_t>(calibration_.plan.steps))
            warn(tell<"%1 was loaded in %2 steps, %3 are planned">(name(), steps().size(),
                                                                   calibration_.plan.steps));
    }

    bool check_rated_load() {
        const ForceChannel& h = channel();
        const double largest = steps().back().load;
        if (std::abs(largest - h.rated_load) > 1e-3 * h.rated_load)
            return refuse(tell<"the largest load on %1 is %2; the rated output needs the rated load, %3">(
                name(), quantity_words(h.load_unit().from_si(largest), h.load_unit()),
                quantity_words(h.load_unit().from_si(h.rated_load), h.load_unit())));
        if (!(h.u_a > 0.0))
            warn(tell<"%1 has the same reading in all runs: its repeatability is evaluated as zero">(name()));
        return true;
    }

    /// Column of e(h, c): means of all channels at the rated load.
    void rated_outputs() {
        const int rated = steps().back().step;
        for (std::size_t h = 0; h < calibration_.size(); ++h) {
            std::vector<double> net;
            for (const Run& run : series().runs)
                for (const StepReading& r : run.increasing)
                    if (r.step == rated) net.push_back(r.net[h]);
            calibration_.rated_outputs(at(h), at(c_)) = mean_of(net);
        }
        channel().rated_output = calibration_.rated_outputs(at(c_), at(c_));
    }

    double largest_zero() {
        double largest = 0.0;
        bool any = false;
        for (const Run& run : series().runs) {
            if (!run.zero_after) continue;
            any = true;
            largest = std::max(largest, std::abs((*run.zero_after)[c_] - (*run.zero_before)[c_]));
        }
        if (!any)
            warn(
                tell<"%1 has no unloaded readings after a run: its non-zero error is taken as zero">(name()));
        return largest;
    }

    double largest_hysteresis() {
        double largest = 0.0;
        bool any = false;
        for (const Run& run : series().runs)
            for (const StepReading& up : run.increasing)
                if (const StepReading* down = run.decreasing_at(up.step)) {
                    any = true;
                    largest = std::max(largest, std::abs(up.net[c_] - down->net[c_]));
                }
        if (!any)
            warn(
                tell<"%1 has no decreasing loads: its hysteresis is not known and is taken as zero">(name()));
        return largest;
    }

    /// A reading that stands still while the load rises by a step.
    void check_saturation() {
        const double slope = std::abs(channel().rated_output) / channel().rated_load;
        for (const Run& run : series().runs)
            for (std::size_t i = 1; i < run.increasing.size(); ++i) {
                const StepReading &before = run.increasing[i - 1], &now = run.increasing[i];
                const double expected = slope * (now.load - before.load);
                if (std::abs(now.net[c_] - before.net[c_]) > 0.1 * expected ||
                    expected <= 20.0 * calibration_.resolution)
                    continue;
                refuse(tell<"run %1 of %2 reads the same at steps %3 and %4 although the load rises: the "
                            "indicator is saturated or the channel is stuck">(run.number, name(), before.step,
                                                                              now.step));
                return;
            }
    }

    /// Fig. 2: the first wait of each sort that is too short is warned of.
    void check_times() {
        for (const Run& run : series().runs)
            for (std::size_t i = 1; i < run.increasing.size(); ++i) {
                const StepReading &before = run.increasing[i - 1], &now = run.increasing[i];
                const double wait = now.time - before.time;
                if (!(wait < 0.9 * calibration_.plan.load_time)) continue;
                warn(tell<"run %1 of %2: only %3 s between steps %4 and %5, %6 s are planned">(
                    run.number, name(), readable_number(wait), before.step, now.step,
                    readable_number(calibration_.plan.load_time)));
                return check_free_times();
            }
        check_free_times();
    }

    void check_free_times() {
        const std::vector<Run>& runs = series().runs;
        for (std::size_t i = 1; i < runs.size(); ++i) {
            const double wait = runs[i].time_before - runs[i - 1].time_after;
            if (!runs[i - 1].zero_after || !(wait < 0.9 * calibration_.plan.free_time)) continue;
            warn(tell<"run %1 of %2 begins %3 s after the one before was unloaded, %4 s are planned">(
                runs[i].number, name(), readable_number(wait), readable_number(calibration_.plan.free_time)));
            return;
        }
    }

    Calibration& calibration_;
    std::size_t c_;
    Problems& problems_;
};

/// A channel must respond to its own load, and to no other more than to it.
void check_response(const Calibration& calibration, Problems& problems) {
    for (std::size_t h = 0; h < calibration.size(); ++h) {
        const double own = std::abs(calibration.channels[h].rated_output);
        const std::string name = calibration.channels[h].kind().key;
        if (own <= 20.0 * calibration.resolution || own == 0.0) {
            problems.error(sensor_fields().place(&StatedSensor::readings),
                           tell<"channel %1 does not respond to its load: %2 at the rated load; look at its "
                                "cable and its column">(name, text_in_millivolts(own)));
            continue;
        }
        for (std::size_t c = 0; c < calibration.size(); ++c)
            if (c != h && std::abs(calibration.rated_outputs(at(h), at(c))) >= own) {
                problems.error(
                    sensor_fields().place(&StatedSensor::readings),
                    tell<"channel %1 responds to %2 more than to its own load: are columns exchanged?">(
                        name, calibration.channels[c].kind().key));
                break;
            }
    }
}

}  // namespace

void evaluate_series(Calibration& calibration, Problems& problems) {
    const auto n = static_cast<Eigen::Index>(calibration.size());
    calibration.rated_outputs.setZero(n, n);
    calibration.steps.assign(calibration.size(), {});
    for (std::size_t c = 0; c < calibration.size(); ++c) SeriesEvaluation(calibration, c, problems).run();
    if (!problems.has_errors()) check_response(calibration, problems);
}

std::optional<std::size_t> Calibration::channel_of(std::size_t axis) const {
    for (std::size_t h = 0; h < channels.size(); ++h)
        if (channels[h].axis == axis) return h;
    return {};
}

double Calibration::u_calibrator(std::size_t h) const {
    return channels[h].u_calibrator * std::abs(channels[h].rated_output);
}

double Calibration::u_resolution() const {
    return resolution / std::sqrt(12.0);
}

double Calibration::u_zero(std::size_t h) const {
    return channels[h].zero / std::sqrt(12.0);
}

double Calibration::u_b_computed(std::size_t h) const {
    return std::hypot(u_calibrator(h), u_resolution(), u_zero(h));
}

double Calibration::u_b(std::size_t h) const {
    return stated_u_b[h].value_or(u_b_computed(h));
}

double Calibration::u_c(std::size_t h) const {
    return std::hypot(channels[h].u_a, u_b(h));
}

double Calibration::largest_interference(std::size_t h) const {
    double largest = 0.0;
    for (std::size_t c = 0; c < size(); ++c)
        if (c != h) largest = std::max(largest, std::abs(rated_outputs(at(h), at(c))));
    return largest;
}

double Calibration::U(std::size_t h) const {
    return channels[h].hysteresis + largest_interference(h) + k * u_c(h);
}

}  // namespace covaria::force
