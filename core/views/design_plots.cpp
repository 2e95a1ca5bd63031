#include "core/views/design_plots.h"

#include <algorithm>

#include "core/base/name.h"
#include "core/text/symbol.h"
#include "core/views/plot_words.h"

namespace covaria {

namespace {

Text capital(std::string words) {
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = char(words[0] - 'a' + 'A');
    return words;
}

PlotSpecification plot_of(const DesignResult& result, const char* chart, const std::string& title) {
    PlotSpecification plot;
    plot.id = "design-" + result.id + "-" + chart;
    plot.title = title;
    return plot;
}

/// The ratios of U to the targets, or to U of the present design where there is no target.
std::vector<double> ratios(const DesignResult& result, bool before) {
    std::vector<double> ratios;
    for (const DesignGoal& goal : result.goals) {
        const std::optional<double> reference = goal.target ? goal.target : goal.before;
        const std::optional<double> U = before ? goal.before : std::optional<double>(goal.after);
        if (reference && U) ratios.push_back(*U / *reference);
    }
    return ratios;
}

PlotSpecification outputs_plot(const DesignResult& result, const DocumentLanguage& language) {
    PlotSpecification plot = plot_of(result, "outputs", language.say(plot_words::before_and_after));
    const bool targets = !result.goals.empty() && result.goals.front().target;
    plot.y.title = language.say(targets ? plot_words::relative_to_target : plot_words::relative_to_present);
    for (const DesignGoal& goal : result.goals) {
        Text name =
            goal.output.group.empty() ? Text() : Text(language.say(said_name(goal.output.group)) + ": ");
        name += symbol_text(goal.output.symbol);
        plot.x.categories.push_back(std::move(name));
    }
    for (const bool before : {true, false}) {
        PlotSeries series;
        series.name = language.say(before ? plot_words::before : plot_words::designed);
        series.kind = SeriesKind::points;
        series.role = before ? SeriesRole::reference : SeriesRole::emphasis;
        series.y = ratios(result, before);
        if (series.y.size() != result.goals.size()) continue;
        for (std::size_t i = 0; i < series.y.size(); ++i) series.x.push_back(double(i));
        plot.y.high = std::max(plot.y.high, 1.1 * *std::ranges::max_element(series.y));
        plot.series.push_back(std::move(series));
    }
    if (targets) plot.marks.push_back({language.say(plot_words::target), 1.0, true, SeriesRole::reference});
    plot.y.high = std::max(plot.y.high, 1.1);
    return plot;
}

/// The chart of the objective against the number of rows, which tells what the last of so many rows has
/// given: "3: −38 %".
PlotSpecification curve_plot(const DesignResult& result, const DocumentLanguage& language) {
    PlotSpecification plot = plot_of(result, "curve", language.say(plot_words::more_rows));
    plot.x.title = language.say(plot_words::rows);
    plot.y.title = capital(language.say_declared(result.objective_words));
    PlotSeries line;
    line.name = language.say(plot_words::best_found);
    for (const DesignCount& count : result.curve) {
        line.x.push_back(static_cast<double>(count.rows));
        line.y.push_back(count.objective);
    }
    PlotSeries points = line;
    points.name = Text();
    points.kind = SeriesKind::points;
    const auto [low, high] = std::ranges::minmax(line.y);
    plot.y.logarithmic = low > 0.0 && high > 30.0 * low;
    if (!plot.y.logarithmic) plot.y.high = 1.06 * high;
    plot.series = {std::move(line), std::move(points)};
    plot.marks.push_back({language.say(plot_words::kept), static_cast<double>(result.rows.size()), false,
                          SeriesRole::emphasis});
    return plot;
}

PlotSpecification rows_plot(const DesignResult& result, const DocumentLanguage& language) {
    constexpr std::size_t most = 40;
    PlotSpecification plot = plot_of(result, "rows", language.say(plot_words::worth_of_rows));
    plot.x.title = language.say(plot_words::growth_without);
    plot.x.unit = "%";
    plot.horizontal_bars = true;
    std::vector<const DesignRow*> rows;
    for (const DesignRow& row : result.rows)
        if (row.without) rows.push_back(&row);
    std::ranges::stable_sort(
        rows, [](const DesignRow* a, const DesignRow* b) { return *a->without > *b->without; });
    if (rows.size() > most) rows.resize(most);
    PlotSeries bars;
    bars.kind = SeriesKind::bars;
    bars.bar_width = 0.8;
    for (const DesignRow* row : rows) {
        bars.y.push_back(static_cast<double>(bars.y.size()));
        bars.x.push_back(100.0 * (*row->without / result.objective - 1.0));
        plot.y.categories.push_back(language.say(row->name));
    }
    if (!bars.x.empty()) plot.series.push_back(std::move(bars));
    return plot;
}

PlotSpecification front_plot(const DesignResult& result, const DocumentLanguage& language) {
    PlotSpecification plot = plot_of(result, "front", language.say(plot_words::front));
    plot.x.title = language.say(plot_words::largest_ratio);
    plot.y.title = language.say(plot_words::cost);
    PlotSeries line;
    line.name =
        language.say(result.rows.empty() ? plot_words::cheapest_reductions : plot_words::cheapest_rows);
    for (const DesignCost& cost : result.front) {
        line.x.push_back(cost.largest_ratio);
        line.y.push_back(cost.cost);
    }
    plot.series.push_back(std::move(line));
    plot.marks.push_back({language.say(plot_words::targets), 1.0, false, SeriesRole::emphasis});
    return plot;
}

PlotSpecification path_plot(const DesignResult& result, const DocumentLanguage& language) {
    PlotSpecification plot = plot_of(result, "path", language.say(plot_words::way));
    plot.x.title = language.say(plot_words::evaluations);
    plot.y.title =
        capital(result.cost ? language.say(plot_words::cost) : language.say_declared(result.objective_words));
    PlotSeries line;
    line.name = language.say(plot_words::best_so_far);
    for (const DesignStep& step : result.path) {
        const auto at = static_cast<double>(step.evaluation);
        if (!line.y.empty()) {
            line.x.push_back(at);
            line.y.push_back(line.y.back());
        }
        line.x.push_back(at);
        line.y.push_back(step.objective);
    }
    line.x.push_back(static_cast<double>(result.evaluations));
    line.y.push_back(line.y.back());
    plot.series.push_back(std::move(line));
    if (result.before && result.why_not_before.empty() && !result.cost)
        plot.marks.push_back({language.say(plot_words::before), *result.before, true, SeriesRole::reference});
    return plot;
}

}  // namespace

std::vector<PlotSpecification> design_plots(const DesignResult& result, const DocumentLanguage& language) {
    std::vector<PlotSpecification> plots;
    if (!result.found) return plots;
    if (result.curve.size() > 1) plots.push_back(curve_plot(result, language));
    if (!result.rows.empty()) plots.push_back(rows_plot(result, language));
    if (!result.front.empty()) plots.push_back(front_plot(result, language));
    plots.push_back(outputs_plot(result, language));
    if (result.path.size() > 1) plots.push_back(path_plot(result, language));
    std::erase_if(plots, [](const PlotSpecification& plot) { return plot.series.empty(); });
    return plots;
}

}  // namespace covaria
