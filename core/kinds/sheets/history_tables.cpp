// Tables and the chart of the history of an instrument: drift, component, next calibration, values.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/kinds/sheets/history_fit.h"
#include "core/math/special_quantiles.h"

namespace covaria::sheets {

namespace {

constexpr double chi_squared_probability = 0.95;
constexpr std::size_t drawn_points = 61;

std::string iso_text(Days day) {
    const std::chrono::year_month_day date(day);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", int(date.year()), unsigned(date.month()),
                  unsigned(date.day()));
    return text.data();
}

Quantity difference_in(const Unit& unit, double si) {
    return {unit.interval().interval_from_si(si), unit.interval()};
}

Table drift_table(const HistorySetup& setup, const HistoryFit& fit) {
    Table table{"drift", "Drift"};
    table.add("quantity");
    table.add("value").figure(4);
    const auto row = [&](const Message& name, double si) {
        table.row({name, difference_in(setup.unit, si)});
    };
    row(tell<"drift in a year">(), fit.rate);
    row(tell<"standard uncertainty of the drift in a year">(), fit.u_rate);
    if (setup.from_residuals) row(tell<"scatter of one value about the line">(), fit.s);
    if (setup.use) {
        const PredictedValue then = predicted(setup, fit, years_between(setup.values.back().day, *setup.use));
        row(tell<"drift from the last calibration to the date of use">(), then.drift);
        row(tell<"corrected: its standard uncertainty">(), then.u_drift);
        row(tell<"not corrected: half-width of a rectangular distribution">(), then.half_width);
        row(tell<"not corrected: standard uncertainty">(), then.u_rectangular);
    }
    if (fit.scatter_ratio > 0.0) {
        const double nu = setup.degrees_of_freedom();
        const double most = std::sqrt(chi_squared_quantile(chi_squared_probability, nu) / nu);
        if (fit.scatter_ratio > most)
            table.notes.push_back(
                tell<"The values scatter more about the line than their uncertainties say: state larger "
                     "ones, or take the uncertainty from the residuals.">());
    }
    return table;
}

Table due_table(const HistorySetup& setup, const DueDay& due) {
    Table table{"due", "Next calibration"};
    table.add("quantity");
    table.add("date");
    table.row({tell<"last calibration">(), iso_text(setup.values.back().day)});
    table.row({tell<"next calibration, at the latest">(), iso_text(due.day)});
    table.notes.push_back(due.at_once      ? tell<"The limit is not kept even on the day of the last "
                                                  "calibration.">()
                          : due.by_longest ? tell<"The limit would be kept for longer: the longest interval "
                                                  "decides.">()
                                           : tell<"The last day on which the figure of the rule, with k "
                                                  "times its u, is within the limit.">());
    return table;
}

Table values_table(const HistorySetup& setup, const HistoryFit& fit) {
    Table table{"values", "Calibrations and their residuals"};
    table.add("date");
    table.add("as found").in(setup.unit).figure(7);
    table.add("residual").in(setup.unit.interval()).figure(3);
    for (std::size_t i = 0; i < setup.values.size(); ++i)
        table.row({setup.rows[i].date, setup.unit.to_si(setup.rows[i].found), fit.residuals[i]});
    return table;
}

}  // namespace

std::vector<Table> history_tables(const HistorySetup& setup, const HistoryFit& fit) {
    std::vector<Table> tables{drift_table(setup, fit)};
    if (const auto due = due_day(setup, fit)) tables.push_back(due_table(setup, *due));
    tables.push_back(values_table(setup, fit));
    return tables;
}

/// The values without the adjustments, as changes since the first, and the line with its bounds.
std::vector<PlotSpecification> history_figures(const HistorySetup& setup, const HistoryFit& fit) {
    PlotSpecification plot;
    plot.id = "history";
    plot.title = "Change since the first calibration";
    plot.x.title = "years since the first calibration";
    plot.y.title = "change";
    plot.y.unit = setup.unit.interval().display();
    const Unit unit = setup.unit.interval();
    PlotSeries values{"as found", SeriesKind::points, SeriesRole::data, {}, {}, {}, 0.0};
    for (const HistoryValue& value : setup.values) {
        values.x.push_back(years_between(setup.values.front().day, value.day));
        values.y.push_back(unit.interval_from_si(value.value));
    }
    const double last = values.x.back();
    const auto due = due_day(setup, fit);
    double end = setup.use ? years_between(setup.values.front().day, *setup.use) : last;
    if (due) end = std::max(end, years_between(setup.values.front().day, due->day));
    const std::array<std::pair<const char*, double>, 3> lines{
        {{"line", 0.0}, {"line ± k u", -1.0}, {"", 1.0}}};
    plot.series.push_back(std::move(values));
    for (const auto& [name, sign] : lines) {
        PlotSeries line{
            name, SeriesKind::line, sign == 0.0 ? SeriesRole::fit : SeriesRole::reference, {}, {}, {}, 0.0};
        for (std::size_t i = 0; i < drawn_points; ++i) {
            const double year = end * double(i) / double(drawn_points - 1), arm = year - fit.middle;
            const double u = std::hypot(fit.u_level, arm * fit.u_rate, fit.s);
            line.x.push_back(year);
            line.y.push_back(unit.interval_from_si(fit.at(year) + sign * setup.factor * u));
        }
        plot.series.push_back(std::move(line));
    }
    return {plot};
}

}  // namespace covaria::sheets
