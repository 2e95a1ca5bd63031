#include "core/report/design_plots.h"

#include <algorithm>

#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria {

namespace {

Text capital(std::string words) {
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = char(words[0] - 'a' + 'A');
    return words;
}

PlotSpecification plot_of(const DesignResult& result, const char* chart, const char* title) {
    PlotSpecification plot;
    plot.id = "design-" + result.id + "-" + chart;
    plot.title = title;
    return plot;
}

/// What the ratios are relative to: the targets, or U of the present design.
std::vector<double> ratios(const DesignResult& result, bool before) {
    std::vector<double> ratios;
    for (const DesignGoal& goal : result.goals) {
        const std::optional<double> reference = goal.target ? goal.target : goal.before;
        const std::optional<double> U = before ? goal.before : std::optional<double>(goal.after);
        if (reference && U) ratios.push_back(*U / *reference);
    }
    return ratios;
}

PlotSpecification outputs_plot(const DesignResult& result) {
    PlotSpecification plot = plot_of(result, "outputs", "Uncertainties before and after");
    const bool targets = !result.goals.empty() && result.goals.front().target;
    plot.y.title = targets ? "U / target" : "U relative to the present design";
    for (const DesignGoal& goal : result.goals) {
        Text name = goal.output.group.empty() ? Text() : Text(goal.output.group + ": ");
        name += symbol_text(goal.output.symbol);
        plot.x.categories.push_back(std::move(name));
    }
    for (const bool before : {true, false}) {
        PlotSeries series;
        series.name = before ? "before" : "designed";
        series.kind = SeriesKind::points;
        series.role = before ? SeriesRole::reference : SeriesRole::emphasis;
        series.y = ratios(result, before);
        if (series.y.size() != result.goals.size()) continue;
        for (std::size_t i = 0; i < series.y.size(); ++i) series.x.push_back(double(i));
        plot.y.high = std::max(plot.y.high, 1.1 * *std::ranges::max_element(series.y));
        plot.series.push_back(std::move(series));
    }
    if (targets) plot.marks.push_back({"target", 1.0, true, SeriesRole::reference});
    plot.y.high = std::max(plot.y.high, 1.1);
    return plot;
}

/// "3: −38 %": what the last of so many rows has given.
PlotSpecification curve_plot(const DesignResult& result) {
    PlotSpecification plot = plot_of(result, "curve", "What more rows give");
    plot.x.title = "rows";
    plot.y.title = capital(result.objective_words);
    PlotSeries line;
    line.name = "best found";
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
    plot.marks.push_back({"kept", static_cast<double>(result.rows.size()), false, SeriesRole::emphasis});
    return plot;
}

PlotSpecification rows_plot(const DesignResult& result) {
    constexpr std::size_t most = 40;
    PlotSpecification plot = plot_of(result, "rows", "What each row kept is worth");
    plot.x.title = "growth of the objective without it (%)";
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
        plot.y.categories.push_back(row->name);
    }
    if (!bars.x.empty()) plot.series.push_back(std::move(bars));
    return plot;
}

PlotSpecification front_plot(const DesignResult& result) {
    PlotSpecification plot = plot_of(result, "front", "What a smaller uncertainty costs");
    plot.x.title = "largest U / target";
    plot.y.title = "cost";
    PlotSeries line;
    line.name = result.rows.empty() ? "cheapest reductions" : "cheapest rows";
    for (const DesignCost& cost : result.front) {
        line.x.push_back(cost.largest_ratio);
        line.y.push_back(cost.cost);
    }
    plot.series.push_back(std::move(line));
    plot.marks.push_back({"targets", 1.0, false, SeriesRole::emphasis});
    return plot;
}

PlotSpecification path_plot(const DesignResult& result) {
    PlotSpecification plot = plot_of(result, "path", "The way of the search");
    plot.x.title = "evaluations";
    plot.y.title = result.cost ? "Cost" : capital(result.objective_words);
    PlotSeries line;
    line.name = "best so far";
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
        plot.marks.push_back({"before", *result.before, true, SeriesRole::reference});
    return plot;
}

}  // namespace

std::vector<PlotSpecification> design_plots(const DesignResult& result) {
    std::vector<PlotSpecification> plots;
    if (!result.found) return plots;
    if (result.curve.size() > 1) plots.push_back(curve_plot(result));
    if (!result.rows.empty()) plots.push_back(rows_plot(result));
    if (!result.front.empty()) plots.push_back(front_plot(result));
    plots.push_back(outputs_plot(result));
    if (result.path.size() > 1) plots.push_back(path_plot(result));
    std::erase_if(plots, [](const PlotSpecification& plot) { return plot.series.empty(); });
    return plots;
}

}  // namespace covaria
