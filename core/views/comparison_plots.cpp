// Charts of one result beside another.
#include <algorithm>
#include <cmath>

#include "core/views/comparison_columns.h"
#include "core/views/plot_words.h"
#include "core/views/plots_parts.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

using plot_parts::PlottedOutput;

/// The probability density as a line: through the middles of the cells of the trials, else of the law of
/// propagation. It is without x where the output has no distribution.
PlotSeries density_line(const PlottedOutput& y) {
    PlotSeries line;
    const FirstOrderOutput& first = y.output().first_order;
    const bool trials = plot_parts::has_histogram(y);
    if (trials) {
        line = plot_parts::histogram_bars(y);
        line.kind = SeriesKind::line;
        line.bar_width = 0.0;
        line.name = y.language().say(plot_words::monte_carlo);
    } else if (first.standard_uncertainty > 0.0 && std::isfinite(first.standard_uncertainty)) {
        const double mean = y.value(first.estimate), u = y.interval(first.standard_uncertainty);
        line = plot_parts::first_order_curve(y, mean - 4.0 * u, mean + 4.0 * u, 161);
    }
    return line;
}

/// Extends the axis to the middle of the distribution, without its extreme tails, which would squeeze the
/// rest.
void extend(PlotAxis& axis, const PlottedOutput& y, bool first) {
    const MonteCarloOutput* trials = y.trials();
    const double u = trials && std::isfinite(trials->standard_uncertainty)
                         ? trials->standard_uncertainty
                         : y.output().first_order.standard_uncertainty;
    const double low = y.value(y.output().estimate) - 4.5 * y.interval(u);
    const double high = y.value(y.output().estimate) + 4.5 * y.interval(u);
    axis.low = first ? low : std::min(axis.low, low);
    axis.high = first ? high : std::max(axis.high, high);
}

struct MarkedEstimate {
    PlottedOutput y;
    std::string words;
    SeriesRole role;
};

/// Marks the estimates with one power of ten, that of the axis.
void mark_estimates(PlotSpecification& plot, const std::vector<MarkedEstimate>& marked) {
    const double largest = std::max(std::abs(plot.x.low), std::abs(plot.x.high));
    const PlottedOutput& last = marked.back().y;
    const int exponent = last.exponent_of_results(largest);
    for (const auto& [y, words, role] : marked)
        plot.marks.push_back({words + " " + y.result_text(y.output().estimate, exponent),
                              y.value(y.output().estimate), false, role});
    plot.x.exponent = exponent;
}

}  // namespace

PlotSpecification compared_distributions_plot(const ResultComparison& comparison, std::size_t output,
                                              const DisplayUnits& units, const DocumentLanguage& language) {
    const ComparedOutput& at = comparison.outputs[output];
    PlotSpecification plot;
    std::vector<MarkedEstimate> marked;
    DisplayUnits shown = units;  // both have one unit
    if (at.in_both()) shown.choose(units.of(comparison.output_after(at)->quantity.unit));
    const auto add = [&](const UncertaintyResult& result, std::optional<std::size_t> index,
                         const Phrase& phrase, SeriesRole role) {
        if (!index) return;
        const PlottedOutput y(result, *index, shown, language);
        const std::string words = language.say(phrase);
        plot.id = y.id("compared");
        plot.title = language.say_text(plot_words::distributions, {y.label()});
        plot.x.title = y.symbol();
        plot.x.unit = y.unit();
        y.set_density_axis(plot.y);
        PlotSeries line = density_line(y);
        if (line.x.empty()) return;
        line.name = words + ": " + line.name;
        line.role = role;
        extend(plot.x, y, plot.series.empty());
        plot.series.push_back(std::move(line));
        marked.push_back({y, words, role});
    };
    add(*comparison.before, at.before, plot_words::before, SeriesRole::family_1);
    add(*comparison.after, at.after, plot_words::after, SeriesRole::family_2);
    if (plot.series.empty())
        return plot_parts::nothing_to_show(plot.id, language.say(plot_words::no_distribution));
    mark_estimates(plot, marked);
    return plot;
}

PlotSpecification budget_changes_plot(const ResultComparison& comparison, std::size_t output,
                                      const DocumentLanguage& language, std::size_t rows) {
    const ComparedOutput& at = comparison.outputs[output];
    const OutputResult* either = comparison.output_after(at);
    if (!either) either = comparison.output_before(at);
    const Text label = result_words::output_text(either->quantity, language);
    const std::string id =
        "budget-changes-" + result_words::id_part(either->quantity.symbol + " " + either->quantity.group);
    if (!at.in_both())
        return plot_parts::nothing_to_show(id, language.say_text(plot_words::in_one_only, {label}));
    std::vector<ComparedPlace> places = compared_places(comparison, output);
    std::erase_if(places, [&](const ComparedPlace& place) { return !has_changed(comparison, place); });
    const double u = comparison.output_before(at)->first_order.standard_uncertainty;
    if (places.empty() || !(u > 0.0))
        return plot_parts::nothing_to_show(id, language.say_text(plot_words::budget_unchanged, {label}));
    PlotSpecification plot;
    plot.id = id;
    plot.title = language.say_text(plot_words::budget_changes, {label});
    plot.horizontal_bars = true;
    plot.x.title = language.say(plot_words::change_of_variance);
    plot.x.unit = "%";
    PlotSeries bars{"", SeriesKind::bars, SeriesRole::data, {}, {}, {}, 0.72};
    const std::size_t shown = places.size() <= rows ? places.size() : rows - 1;
    double rest = 0.0;
    plot.y.categories = compared_labels(
        comparison, {places.begin(), places.begin() + static_cast<std::ptrdiff_t>(shown)}, language);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double change = 100.0 * places[i].component.change() / (u * u);
        if (i >= shown) {
            rest += change;
            continue;
        }
        bars.x.push_back(change);
    }
    if (shown < places.size()) {
        plot.y.categories.push_back(
            language.say(plot_words::others, {std::to_string(places.size() - shown)}));
        bars.x.push_back(rest);
    }
    for (std::size_t i = 0; i < bars.x.size(); ++i) bars.y.push_back(static_cast<double>(i));
    plot.series.push_back(std::move(bars));
    return plot;
}

}  // namespace covaria
