// Charts of a calibration: its plan in time, curves, residuals, hysteresis loops, interference, U.
#include <algorithm>
#include <cmath>

#include "core/kinds/force/calibration.h"

namespace covaria::force {

namespace {

constexpr double millivolts = 1e3, microvolts = 1e6;
constexpr SeriesRole family[] = {SeriesRole::family_1, SeriesRole::family_2, SeriesRole::family_3,
                                 SeriesRole::family_4, SeriesRole::family_5, SeriesRole::family_6};

std::string lower_key(const ForceChannel& channel) {
    std::string key = channel.kind().key;
    key[0] = static_cast<char>(key[0] - 'A' + 'a');
    return key;
}

PlotAxis load_axis(const ForceChannel& channel) {
    PlotAxis axis;
    axis.title = std::string("load ") + channel.kind().key;
    axis.unit = channel.load_unit().display();
    axis.low = 0.0;
    axis.high = 1.04 * channel.rated_load;
    return axis;
}

/// Fig. 2 of the paper, from the planned times.
PlotSpecification plan_figure(const Calibration& calibration) {
    const Plan& plan = calibration.plan;
    PlotSpecification plot;
    plot.id = "plan";
    plot.title = "Loads of one axis against time";
    plot.x.title = "time";
    plot.x.unit = "min";
    plot.y = {"per cent of rated load", 0.0, 108.0, false, {}};
    PlotSeries line{"", SeriesKind::line, SeriesRole::data, {}, {}, {}, 0.0};
    double now = 0.0;
    const auto hold = [&](double percent, double seconds) {
        line.x.insert(line.x.end(), {now / 60.0, (now + seconds) / 60.0});
        line.y.insert(line.y.end(), {percent, percent});
        now += seconds;
    };
    for (int k = 0; k < plan.preloads; ++k) {
        hold(0.0, plan.free_time);
        hold(100.0, plan.load_time);
        hold(0.0, plan.load_time);
    }
    plot.marks.push_back({"calibration", now / 60.0, false, SeriesRole::reference});
    for (int run = 0; run < plan.runs; ++run) {
        hold(0.0, plan.free_time);
        for (int i = 1; i <= plan.steps; ++i) hold(100.0 * i / plan.steps, plan.load_time);
        for (int i = plan.steps - 1; plan.decreasing && i > 0; --i)
            hold(100.0 * i / plan.steps, plan.load_time);
        hold(0.0, plan.load_time);
    }
    plot.series.push_back(std::move(line));
    return plot;
}

/// Charts of the readings of one channel under its own load.
class ChannelFigures {
public:
    ChannelFigures(const Calibration& calibration, std::size_t c)
        : calibration_(calibration), channel_(calibration.channels[c]), c_(c), slope_(fitted_slope()) {}

    PlotSpecification curve() const {
        PlotSpecification plot = empty("curve", "Calibration curve of ");
        plot.y.title = "net reading";
        plot.y.unit = "mV/V";
        PlotSeries up{"increasing, mean", SeriesKind::line, SeriesRole::data, {0.0}, {0.0}, {}, 0.0};
        PlotSeries down{"decreasing, mean", SeriesKind::points, SeriesRole::emphasis, {}, {}, {}, 0.0};
        for (const StepStatistics& step : calibration_.steps[c_]) {
            up.x.push_back(step.load);
            up.y.push_back(millivolts * step.mean);
            if (std::isnan(step.decreasing_mean)) continue;
            down.x.push_back(step.load);
            down.y.push_back(millivolts * step.decreasing_mean);
        }
        plot.series = {up, down};
        return plot;
    }

    PlotSpecification residuals() const {
        PlotSpecification plot = empty("residuals", "Residuals from the line through zero of ");
        plot.y.title = "residual";
        plot.y.unit = "µV/V";
        PlotSeries up{"increasing", SeriesKind::points, SeriesRole::data, {}, {}, {}, 0.0};
        PlotSeries down{"decreasing", SeriesKind::points, SeriesRole::emphasis, {}, {}, {}, 0.0};
        for (const Run& run : calibration_.series[c_].runs) {
            add(up, run.increasing, slope_);
            add(down, run.decreasing, slope_);
        }
        plot.series = {up, down};
        plot.marks.push_back({"", 0.0, true, SeriesRole::reference});
        return plot;
    }

    /// Deviation from the straight line between zero and rated load, so that the loop is wide.
    PlotSpecification loop() const {
        PlotSpecification plot = empty("loop", "Hysteresis loop, magnified, of ");
        plot.y.title = "deviation from the line";
        plot.y.unit = "µV/V";
        const double line = channel_.rated_output / channel_.rated_load;
        PlotSeries up{"increasing", SeriesKind::line, SeriesRole::data, {0.0}, {0.0}, {}, 0.0};
        PlotSeries down{"decreasing", SeriesKind::line, SeriesRole::emphasis, {}, {}, {}, 0.0};
        for (const StepStatistics& step : calibration_.steps[c_]) {
            up.x.push_back(step.load);
            up.y.push_back(microvolts * (step.mean - line * step.load));
            const bool is_top = &step == &calibration_.steps[c_].back();
            const double mean = is_top ? step.mean : step.decreasing_mean;
            if (std::isnan(mean)) continue;
            down.x.push_back(step.load);
            down.y.push_back(microvolts * (mean - line * step.load));
        }
        if (down.x.size() > 1) {
            down.x.insert(down.x.begin(), 0.0);
            down.y.insert(down.y.begin(), microvolts * mean_zero_after());
            plot.series = {up, down};
        } else {
            plot.series = {up};
        }
        return plot;
    }

private:
    PlotSpecification empty(const std::string& id, const std::string& title) const {
        PlotSpecification plot;
        plot.id = id + "-" + lower_key(channel_);
        plot.title = title + channel_.kind().key;
        plot.x = load_axis(channel_);
        return plot;
    }

    double fitted_slope() const {
        double products = 0.0, squares = 0.0;
        for (const Run& run : calibration_.series[c_].runs)
            for (const StepReading& r : run.increasing) {
                products += r.load * r.net[c_];
                squares += r.load * r.load;
            }
        return squares > 0.0 ? products / squares : 0.0;
    }

    void add(PlotSeries& series, const std::vector<StepReading>& readings, double slope) const {
        for (const StepReading& r : readings) {
            series.x.push_back(r.load);
            series.y.push_back(microvolts * (r.net[c_] - slope * r.load));
        }
    }

    double mean_zero_after() const {
        double sum = 0.0, n = 0.0;
        for (const Run& run : calibration_.series[c_].runs)
            if (run.zero_after) {
                sum += (*run.zero_after)[c_] - (*run.zero_before)[c_];
                n += 1.0;
            }
        return n > 0.0 ? sum / n : 0.0;
    }

    const Calibration& calibration_;
    const ForceChannel& channel_;
    std::size_t c_;
    double slope_;
};

PlotSpecification interference_figure(const Calibration& calibration) {
    PlotSpecification plot;
    plot.id = "interference";
    plot.title = "Interference at rated loads (% of the sensor's rated output)";
    plot.x.title = "load";
    plot.y.title = "sensor";
    PlotSeries cells;
    cells.kind = SeriesKind::heat_map;
    cells.name = "interference";
    cells.unit = "%";
    const std::size_t n = calibration.size();
    double largest = 0.0;
    for (std::size_t c = 0; c < n; ++c) {
        plot.x.categories.push_back(calibration.channels[c].kind().key);
        plot.y.categories.push_back(calibration.channels[c].kind().key);
    }
    for (std::size_t h = 0; h < n; ++h)
        for (std::size_t c = 0; c < n; ++c) {
            const double e = 100.0 * calibration.rated_outputs(Eigen::Index(h), Eigen::Index(c)) /
                             std::abs(calibration.channels[h].rated_output);
            cells.z.push_back(h == c ? std::nan("") : e);
            if (h != c) largest = std::max(largest, std::abs(e));
        }
    plot.z_high = largest > 0.0 ? largest : 1.0;
    plot.z_low = calibration.has_signs ? -plot.z_high : 0.0;
    plot.series = {std::move(cells)};
    return plot;
}

/// The parts of Eq 12a, one bar each, of every sensor.
PlotSpecification parts_figure(const Calibration& calibration) {
    PlotSpecification plot;
    plot.id = "parts";
    plot.title = "Parts of U by the paper (% of rated output)";
    plot.x.title = "per cent of rated output";
    plot.horizontal_bars = true;
    const std::size_t n = calibration.size();
    struct Part {
        const char* name;
        double (*value)(const Calibration&, std::size_t);
    };
    const Part parts[] = {
        {"interference", [](const Calibration& c, std::size_t h) { return c.largest_interference(h); }},
        {"hysteresis", [](const Calibration& c, std::size_t h) { return c.channels[h].hysteresis; }},
        {"k u_c", [](const Calibration& c, std::size_t h) { return c.k * c.u_c(h); }}};
    constexpr double width = 0.26;
    for (std::size_t p = 0; p < std::size(parts); ++p) {
        PlotSeries bars{parts[p].name, SeriesKind::bars, family[p], {}, {}, {}, width};
        for (std::size_t h = 0; h < n; ++h) {
            bars.x.push_back(100.0 * parts[p].value(calibration, h) /
                             std::abs(calibration.channels[h].rated_output));
            bars.y.push_back(static_cast<double>(h) + (static_cast<double>(p) - 1.0) * width);
        }
        plot.series.push_back(std::move(bars));
    }
    for (const ForceChannel& channel : calibration.channels) plot.y.categories.push_back(channel.kind().key);
    return plot;
}

}  // namespace

std::vector<PlotSpecification> calibration_figures(const Calibration& calibration) {
    std::vector<PlotSpecification> plots;
    if (calibration.size() > 1) plots.push_back(interference_figure(calibration));
    plots.push_back(parts_figure(calibration));
    if (!calibration.from_readings) return plots;
    plots.push_back(plan_figure(calibration));
    for (std::size_t c = 0; c < calibration.size(); ++c) {
        const ChannelFigures figures(calibration, c);
        for (PlotSpecification& plot :
             std::vector<PlotSpecification>{figures.curve(), figures.residuals(), figures.loop()})
            plots.push_back(std::move(plot));
    }
    return plots;
}

}  // namespace covaria::force
