// Tables and charts of the sheet of a theodolite beside its results: tests, series, readings.
#include <cmath>

#include "core/kinds/sheets/theodolite_fit.h"
#include "core/kinds/sheets/verdict.h"
#include "core/math/special_quantiles.h"

namespace covaria::sheets {

namespace {

const Unit sheet_arcsec = Unit::of("arcsec");

Quantity in_arcsec(double si) {
    return {sheet_arcsec.interval_from_si(si), sheet_arcsec};
}

/// Tests a and b of one s.
void add_deviation_tests(Table& table, const DeviationTests& against, const PooledScatter& found, double p,
                         const Message& what) {
    if (!found) return;
    const double nu = found.degrees_of_freedom, upper = 0.5 * (1.0 + p);
    if (against.stated)
        add_test(table, {.question = tell<"a: s of %1 is not larger than the stated σ">(what),
                         .figure = found.s(),
                         .high = *against.stated * std::sqrt(chi_squared_quantile(p, nu) / nu),
                         .unit = sheet_arcsec});
    if (!against.other) return;
    const double other_nu = double(against.other_degrees_of_freedom);
    add_test(table, {.question = tell<"b: s of %1 and that of the other campaign are of one σ, s²/s²">(what),
                     .figure = std::pow(found.s() / *against.other, 2),
                     .low = 1.0 / f_quantile(upper, other_nu, nu),
                     .high = f_quantile(upper, nu, other_nu),
                     .unit = Unit{}});
}

void add_index_tests(Table& table, const TheodoliteFit& fit, double p) {
    if (!fit.index.scatter) return;
    const double nu = fit.index.scatter.degrees_of_freedom;
    const double limit = t_quantile(0.5 * (1.0 + p), nu) * fit.u_index();
    add_test(table, {.question = tell<"c: the index error is not different from zero">(),
                     .figure = fit.index.mean,
                     .low = -limit,
                     .high = limit,
                     .unit = sheet_arcsec});
    if (std::abs(fit.index.mean) > limit)
        table.notes.push_back(tell<"An index error is seen: it leaves the mean of both faces; take it off "
                                   "readings in face I alone, or adjust the instrument.">());
    const auto ratio = fit.index_ratio();
    if (!ratio) return;
    const double high = f_quantile(p, fit.series_with_index() - 1.0, nu);
    add_test(table, {.question = tell<"the index error is the same in all series, s²/s²">(),
                     .figure = *ratio,
                     .high = high,
                     .unit = Unit{}});
    if (*ratio > high)
        table.notes.push_back(tell<"The index error changed between the series: it is not one figure, and "
                                   "its u holds for the mean of these series only.">());
}

Table theodolite_tests(const TheodoliteSetup& setup, const TheodoliteFit& fit) {
    Table table = table_of_tests("tests", "Statistical tests");
    add_deviation_tests(table, setup.direction_tests, fit.directions_pooled, setup.probability,
                        tell<"a direction">());
    add_deviation_tests(table, setup.zenith_tests, fit.zeniths_pooled, setup.probability,
                        tell<"a zenith angle">());
    add_index_tests(table, fit, setup.probability);
    return table;
}

Table theodolite_sheet(const TheodoliteFit& fit) {
    Table table{"sheet", "Sheet"};
    table.add("quantity");
    table.add("value").figure(4);
    table.add("standard uncertainty").figure(2);
    table.add(known_text<"relative">()).figure(2);
    table.add("degrees of freedom").fixed(0);
    const auto deviation = [&](const Message& name, const PooledScatter& of) {
        if (!of) return;
        const Cell part = of.s() > 0.0 ? Cell(Quantity{100.0 * of.u_s() / of.s(), Unit::of("%")}) : Cell();
        table.row({name, in_arcsec(of.s()), in_arcsec(of.u_s()), part, of.degrees_of_freedom});
    };
    deviation(tell<"s of a direction, measured once in both faces">(), fit.directions_pooled);
    deviation(tell<"s of a zenith angle, measured once in both faces">(), fit.zeniths_pooled);
    if (fit.index.scatter)
        table.row({tell<"index error of the vertical circle">(),
                   in_arcsec(fit.index.mean),
                   in_arcsec(fit.u_index()),
                   {},
                   fit.index.scatter.degrees_of_freedom});
    return table;
}

Table series_table(const TheodoliteFit& fit) {
    Table table{"series", "Series"};
    table.add("series");
    table.add(known_text<"s of a direction">()).in(sheet_arcsec).fixed(2);
    table.add(known_text<"its degrees of freedom">()).fixed(0);
    table.add(known_text<"s of a zenith angle">()).in(sheet_arcsec).fixed(2);
    table.add(known_text<"degrees of freedom of that">()).fixed(0);
    table.add(known_text<"index error">()).in(sheet_arcsec).fixed(2);
    const auto cells = [](const PooledScatter& of) {
        return of ? std::pair<Cell, Cell>{of.s(), of.degrees_of_freedom} : std::pair<Cell, Cell>{};
    };
    for (const TheodoliteSeries& one : fit.series) {
        const auto [s_direction, nu_direction] = cells(one.directions);
        const auto [s_zenith, nu_zenith] = cells(one.zeniths);
        table.row({one.name, s_direction, nu_direction, s_zenith, nu_zenith,
                   one.index.count > 0 ? Cell(one.index.mean) : Cell()});
    }
    return table;
}

Table rounds_table(const TheodoliteSetup& setup, const TheodoliteFit& fit) {
    Table table{"readings", "Readings and their residuals"};
    for (const char* head : {"series", "set", "target"}) table.add(head);
    table.add(known_text<"residual Hz">()).in(sheet_arcsec).fixed(2);
    table.add(known_text<"residual V">()).in(sheet_arcsec).fixed(2);
    table.add(known_text<"index">()).in(sheet_arcsec).fixed(2);
    const auto cell = [](const std::optional<double>& residual) {
        return residual ? Cell(*residual) : Cell();
    };
    for (std::size_t i = 0; i < setup.readings.size(); ++i) {
        const FaceReadings& r = setup.readings[i];
        table.row({r.series, r.set, r.target, cell(fit.direction_residuals[i]), cell(fit.zenith_residuals[i]),
                   r.has_zeniths() ? Cell(r.index()) : Cell()});
    }
    return table;
}

PlotSpecification residuals_plot(const char* id, const char* title,
                                 const std::vector<std::optional<double>>& residuals, double s) {
    PlotSpecification plot;
    plot.id = id;
    plot.title = title;
    plot.x.title = "reading";
    plot.y.title = "residual";
    plot.y.unit = sheet_arcsec.display();
    PlotSeries series{"", SeriesKind::points, SeriesRole::data, {}, {}, {}, 0.0};
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        if (!residuals[i]) continue;
        series.x.push_back(double(i + 1));
        series.y.push_back(sheet_arcsec.interval_from_si(*residuals[i]));
    }
    plot.series.push_back(std::move(series));
    for (const double sign : {-1.0, 1.0})
        plot.marks.push_back(
            {sign < 0.0 ? "−s" : "s", sign * sheet_arcsec.interval_from_si(s), true, SeriesRole::reference});
    return plot;
}

}  // namespace

std::vector<Table> theodolite_tables(const TheodoliteSetup& setup, const TheodoliteFit& fit) {
    return {theodolite_sheet(fit), theodolite_tests(setup, fit), series_table(fit), rounds_table(setup, fit)};
}

std::vector<PlotSpecification> theodolite_figures(const TheodoliteFit& fit) {
    std::vector<PlotSpecification> plots;
    if (fit.directions_pooled)
        plots.push_back(residuals_plot("directions", "Residuals of the directions", fit.direction_residuals,
                                       fit.directions_pooled.s()));
    if (fit.zeniths_pooled)
        plots.push_back(residuals_plot("zenith-angles", "Residuals of the zenith angles",
                                       fit.zenith_residuals, fit.zeniths_pooled.s()));
    return plots;
}

}  // namespace covaria::sheets
