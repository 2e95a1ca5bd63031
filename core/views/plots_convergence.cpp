// The chart of the standard uncertainty of an output as trials accumulate.
#include <algorithm>
#include <cmath>

#include "core/base/name.h"
#include "core/views/plot_words.h"
#include "core/views/plots.h"
#include "core/views/plots_parts.h"

namespace covaria {

using plot_parts::nothing_to_show;
using plot_parts::PlottedOutput;

namespace {
constexpr int digits_of_u = 3;
}

PlotSpecification convergence_plot(const UncertaintyResult& result, std::size_t output,
                                   const DisplayUnits& units, const DocumentLanguage& language) {
    const PlottedOutput y(result, output, units, language);
    const std::string id = y.id("convergence");
    if (!y.trials() || result.convergence.empty())
        return nothing_to_show(id, language.say_text(plot_words::run_for_convergence, {y.label()}));
    const MonteCarloOutput& mc = *y.trials();
    PlotSpecification plot;
    plot.id = id;
    const Text u = "u(" + y.symbol() + ")", group = language.say(said_name(y.output().quantity.group));
    plot.title = language.say_text(plot_words::against_trials, {group.empty() ? u : u + ", " + group});
    if (!result.stabilised) plot.title = language.say_text(plot_words::not_stabilised, {plot.title});
    plot.x.title = language.say(plot_words::trials);
    plot.x.logarithmic = true;
    plot.y.title = u;
    plot.y.unit = y.unit();
    const bool single = result.convergence.size() == 1;
    PlotSeries running{
        u, single ? SeriesKind::points : SeriesKind::line, SeriesRole::monte_carlo, {}, {}, {}, 0.0};
    PlotSeries low{
        language.say(plot_words::standard_errors), SeriesKind::line, SeriesRole::reference, {}, {}, {}, 0.0};
    PlotSeries high = low;
    high.name = {};
    // The standard error of u falls with the root of the number of trials.
    const auto used = static_cast<double>(result.convergence.back().trials);
    for (const ConvergencePoint& point : result.convergence) {
        const auto trials = static_cast<double>(point.trials);
        const double error = y.interval(mc.standard_error_of_uncertainty) * std::sqrt(used / trials);
        const double shown = y.interval(point.standard_uncertainty.at(output));
        for (PlotSeries* series : {&running, &low, &high}) series->x.push_back(trials);
        running.y.push_back(shown);
        low.y.push_back(std::max(0.0, shown - 2.0 * error));
        high.y.push_back(shown + 2.0 * error);
    }
    plot.series.push_back(std::move(running));
    if (std::isfinite(mc.standard_uncertainty)) {  // otherwise no number of trials leads anywhere
        const int exponent = y.exponent_of_uncertainties(mc.standard_uncertainty, digits_of_u,
                                                         *std::ranges::max_element(high.y));
        plot.series.insert(plot.series.end(), {std::move(low), std::move(high)});
        plot.y.exponent = exponent;
        plot.marks.push_back({language.say(plot_words::final_u, {y.uncertainty_text(mc.standard_uncertainty,
                                                                                    digits_of_u, exponent)}),
                              y.interval(mc.standard_uncertainty), true, SeriesRole::emphasis});
    }
    return plot;
}

}  // namespace covaria
