// Observations of a set-up and their Type A evaluation, as a table and as charts.
#include <algorithm>

#include "core/kinds/equation/setup.h"
#include "core/quantity/type_a.h"
#include "core/text/symbol.h"

namespace covaria::equation_model {

namespace {

/// Colour of a series, in the order of the chart and its legend, from the first of several series.
SeriesRole role_of_series(std::size_t index, std::size_t count) {
    if (count == 1) return SeriesRole::data;
    constexpr auto first = static_cast<int>(SeriesRole::family_1);
    constexpr int colours = static_cast<int>(SeriesRole::family_6) - first + 1;
    return static_cast<SeriesRole>(first + static_cast<int>(index) % colours);
}

PlotSeries series_of(const ObservedQuantity& quantity, std::size_t index) {
    const ObservedQuantity::Series& observed = quantity.series[index];
    PlotSeries series;
    series.kind = SeriesKind::points;
    series.role = role_of_series(index, quantity.series.size());
    if (quantity.series.size() > 1)
        series.name = observed.name.empty() ? known_text<"present series">() : observed.name;
    series.is_named = !observed.name.empty();
    for (std::size_t i = 0; i < observed.values.size(); ++i) series.x.push_back(static_cast<double>(i + 1));
    series.y = observed.values;
    return series;
}

/// Mean and one standard deviation of an observation to both sides, of the series that is measured now.
void mark_mean(const ObservedQuantity& quantity, PlotSpecification& plot) {
    const auto present = std::find_if(quantity.series.begin(), quantity.series.end(),
                                      [](const auto& series) { return series.name.empty(); });
    if (present == quantity.series.end() && quantity.series.size() > 1) return;
    const auto& values = (present == quantity.series.end() ? quantity.series.front() : *present).values;
    const auto a = type_a_evaluation(values);
    if (!a) return;
    plot.marks.push_back({"mean", a->mean, true, SeriesRole::fit});
    if (!(a->standard_deviation > 0.0)) return;
    plot.marks.push_back({"mean + s", a->mean + a->standard_deviation, true, SeriesRole::reference});
    plot.marks.push_back({"mean − s", a->mean - a->standard_deviation, true, SeriesRole::reference});
}

PlotSpecification figure_of(const ObservedQuantity& quantity) {
    PlotSpecification plot;
    plot.id = "observations-" + quantity.symbol;
    plot.quantity = quantity.symbol;
    plot.title = Text("Observations of ") + symbol_text(quantity.symbol);
    std::size_t longest = 1;
    for (std::size_t i = 0; i < quantity.series.size(); ++i) {
        plot.series.push_back(series_of(quantity, i));
        longest = std::max(longest, quantity.series[i].values.size());
    }
    plot.x = {"number of the observation", 0.5, static_cast<double>(longest) + 0.5};
    plot.y.title = symbol_text(quantity.symbol);
    if (quantity.unit.text() != "1") plot.y.unit = quantity.unit.display();
    mark_mean(quantity, plot);
    return plot;
}

/// "V, day 2"
std::string words_of(const ObservedQuantity& quantity, const ObservedQuantity::Series& series) {
    const std::string symbol = symbol_to_unicode(quantity.symbol);
    return series.name.empty() ? symbol : symbol + ", " + series.name;
}

std::vector<Cell> row_of(const ObservedQuantity& quantity, const ObservedQuantity::Series& series,
                         const TypeA& a) {
    const Unit unit = quantity.unit.interval();
    return {words_of(quantity, series),
            static_cast<double>(series.values.size()),
            Quantity{a.mean, quantity.unit},
            Quantity{a.standard_deviation, unit},
            Quantity{a.standard_uncertainty, unit},
            a.degrees_of_freedom};
}

}  // namespace

std::vector<Table> observation_tables(const std::vector<ObservedQuantity>& observed) {
    Table table{"type-a", "Type A evaluation of observations"};
    table.add("quantity");
    table.add("n").symbol().fixed(0);
    table.add("mean").estimate_of("u of the mean");
    table.add("s of one observation").figure(3);
    table.add("u of the mean").figure(3);
    table.add("nu").symbol().fixed(0);
    for (const ObservedQuantity& quantity : observed)
        for (const ObservedQuantity::Series& series : quantity.series)
            if (const auto a = type_a_evaluation(series.values)) table.row(row_of(quantity, series, *a));
    if (table.rows == 0) return {};
    table.notes = {tell<
        "s is the experimental standard deviation, u = s/√n (JCGM 100 4.2). A quantity that is stated as "
        "pooled observations has the u of all its series together (JCGM 100 4.2.4).">()};
    return {std::move(table)};
}

std::vector<PlotSpecification> observation_figures(const std::vector<ObservedQuantity>& observed) {
    std::vector<PlotSpecification> plots;
    for (const ObservedQuantity& quantity : observed)
        if (!quantity.series.empty()) plots.push_back(figure_of(quantity));
    return plots;
}

}  // namespace covaria::equation_model
