// Tables of the sheet of a distance meter beside its results: tests, lengths, readings.
#include <algorithm>
#include <cmath>

#include "core/kinds/sheets/distance_meter_fit.h"
#include "core/kinds/sheets/verdict.h"
#include "core/math/special_quantiles.h"

namespace covaria::sheets {

namespace {

Quantity in_mm(double si) {
    const Unit mm = Unit::of("mm");
    return {mm.interval_from_si(si), mm};
}

/// Tests a to c with limits computed for the degrees of freedom that there are.
Table tests_table(const DistanceMeterSetup& setup, const DistanceMeterFit& fit) {
    const Unit mm = Unit::of("mm");
    Table table = table_of_tests("tests", "Statistical tests");
    const double nu = fit.degrees_of_freedom, p = setup.probability;
    if (setup.stated_s)
        add_test(table, {.question = tell<"a: s is not larger than the stated σ">(),
                         .figure = fit.s,
                         .high = *setup.stated_s * std::sqrt(chi_squared_quantile(p, nu) / nu),
                         .unit = mm});
    if (setup.other_s) {
        const double other_nu = double(setup.other_degrees_of_freedom), upper = 0.5 * (1.0 + p);
        add_test(table, {.question = tell<"b: s and the s of the other campaign are of one σ, s²/s²">(),
                         .figure = fit.s * fit.s / (*setup.other_s * *setup.other_s),
                         .low = 1.0 / f_quantile(upper, other_nu, nu),
                         .high = f_quantile(upper, nu, other_nu),
                         .unit = Unit{}});
    }
    const double limit = t_quantile(0.5 * (1.0 + p), nu) * fit.u_zero_offset();
    add_test(table, {.question = tell<"c: the zero offset is not different from zero">(),
                     .figure = fit.zero_offset(),
                     .low = -limit,
                     .high = limit,
                     .unit = mm});
    if (std::abs(fit.zero_offset()) > limit)
        table.notes.push_back(tell<"A zero offset is seen: add it to readings, or enter it in the "
                                   "instrument.">());
    return table;
}

Table summary_table(const DistanceMeterSetup& setup, const DistanceMeterFit& fit) {
    const auto zero = fit.unknowns.size() - 1;
    Table table{"sheet", "Sheet"};
    table.add("quantity");
    table.add("value").figure(4);
    table.row({tell<"pillars">(), double(setup.pillars.size())});
    table.row({tell<"distances">(), double(setup.readings.size())});
    table.row({tell<"degrees of freedom">(), fit.degrees_of_freedom});
    table.columns.back().rule.by_row.assign(table.rows, 0);  // counts, which have no decimals
    table.row({tell<"s of one distance">(), in_mm(fit.s)});
    table.row({tell<"standard uncertainty of s">(), in_mm(fit.u_s())});
    table.row({tell<"zero offset, added to a reading">(), in_mm(fit.zero_offset())});
    table.row({tell<"standard uncertainty of the zero offset">(), in_mm(fit.u_zero_offset())});
    table.row({tell<"cofactor of the zero offset">(), fit.cofactors(zero, zero)});
    return table;
}

Table lengths_table(const DistanceMeterSetup& setup, const DistanceMeterFit& fit) {
    Table table{"lengths", "Lengths of the baseline"};
    table.add("pillar");
    table.add("distance").in(Unit::of("m")).fixed(5);
    table.add("u").in(Unit::of("mm")).symbol().uncertainty();
    table.row({setup.pillars.front(), 0.0, {}});
    for (Eigen::Index k = 0; k + 1 < fit.unknowns.size(); ++k)
        table.row({setup.pillars[std::size_t(k) + 1], fit.unknowns[k], fit.u(k)});
    return table;
}

Table readings_table(const DistanceMeterSetup& setup, const DistanceMeterFit& fit) {
    Table table{"readings", "Readings and their residuals"};
    table.add("from");
    table.add("to");
    table.add("distance").in(Unit::of("m")).fixed(5);
    table.add("residual").in(Unit::of("mm")).fixed(3);
    table.add(known_text<"residual over its s">()).fixed(2);
    for (std::size_t i = 0; i < setup.readings.size(); ++i) {
        const BaselineReading& r = setup.readings[i];
        const double v = fit.residuals[Eigen::Index(i)], redundancy = fit.redundancy[Eigen::Index(i)];
        const bool has_scatter = redundancy > 1e-9 && fit.s > 0.0;
        table.row(
            {r.from, r.to, r.distance, v, has_scatter ? Cell(v / (fit.s * std::sqrt(redundancy))) : Cell()});
    }
    return table;
}

}  // namespace

std::vector<Table> distance_meter_tables(const DistanceMeterSetup& setup, const DistanceMeterFit& fit) {
    return {summary_table(setup, fit), tests_table(setup, fit), lengths_table(setup, fit),
            readings_table(setup, fit)};
}

std::vector<PlotSpecification> distance_meter_figures(const DistanceMeterSetup& setup,
                                                      const DistanceMeterFit& fit) {
    PlotSpecification plot;
    plot.id = "residuals";
    plot.title = "Residuals of the distances";
    plot.x.title = "distance";
    plot.x.unit = "m";
    plot.y.title = "residual";
    plot.y.unit = "mm";
    PlotSeries series{"", SeriesKind::points, SeriesRole::data, {}, {}, {}, 0.0};
    for (std::size_t i = 0; i < setup.readings.size(); ++i) {
        series.x.push_back(setup.readings[i].distance);
        series.y.push_back(1e3 * fit.residuals[Eigen::Index(i)]);
    }
    plot.series.push_back(std::move(series));
    for (const double sign : {-1.0, 1.0})
        plot.marks.push_back({sign < 0.0 ? "−s" : "s", sign * 1e3 * fit.s, true, SeriesRole::reference});
    return {plot};
}

}  // namespace covaria::sheets
