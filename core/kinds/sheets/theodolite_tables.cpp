// Tables and charts of the sheet of a theodolite beside its results: tests, series, readings.
#include <algorithm>
#include <cmath>
#include <utility>

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

constexpr std::size_t targets_abreast = 8;  ///< as many columns as a page takes

/// Residuals as a field book has them: a row for each set, a column for each target; more tables where there
/// are more targets than a page takes.
class ResidualTables {
public:
    ResidualTables(const TheodoliteSetup& setup, const std::vector<std::optional<double>>& residuals)
        : setup_(setup), residuals_(residuals) {
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            if (!residuals[i]) continue;
            const FaceReadings& r = setup.readings[i];
            if (std::ranges::find(targets_, r.target) == targets_.end()) targets_.push_back(r.target);
            const std::pair set{r.series, r.set};
            if (std::ranges::find(sets_, set) == sets_.end()) sets_.push_back(set);
        }
    }

    void add_to(std::vector<Table>& tables, const std::string& id, const char* title) const {
        for (std::size_t begin = 0; begin < targets_.size(); begin += targets_abreast) {
            Table table{begin == 0 ? id : id + "-" + std::to_string(begin / targets_abreast + 1), title};
            table.add("series");
            table.add("set");
            const std::size_t end = std::min(begin + targets_abreast, targets_.size());
            for (std::size_t t = begin; t < end; ++t) table.add(targets_[t]).in(sheet_arcsec).fixed(2);
            for (const auto& [series, set] : sets_) {
                std::vector<Cell> cells{series, set};
                for (std::size_t t = begin; t < end; ++t) cells.push_back(cell(series, set, targets_[t]));
                table.row(std::move(cells));
            }
            tables.push_back(std::move(table));
        }
    }

private:
    Cell cell(const std::string& series, const std::string& set, const std::string& target) const {
        for (std::size_t i = 0; i < residuals_.size(); ++i) {
            const FaceReadings& r = setup_.readings[i];
            if (residuals_[i] && r.series == series && r.set == set && r.target == target)
                return *residuals_[i];
        }
        return {};
    }

    const TheodoliteSetup& setup_;
    const std::vector<std::optional<double>>& residuals_;
    std::vector<std::string> targets_;
    std::vector<std::pair<std::string, std::string>> sets_;
};

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
    std::vector<Table> tables{theodolite_sheet(fit), theodolite_tests(setup, fit), series_table(fit)};
    ResidualTables(setup, fit.direction_residuals)
        .add_to(tables, "directions", "Residuals of the directions");
    ResidualTables(setup, fit.zenith_residuals)
        .add_to(tables, "zenith-angles", "Residuals of the zenith angles");
    return tables;
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
