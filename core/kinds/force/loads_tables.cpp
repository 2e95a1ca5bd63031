// Calibration matrix and decoupled loads as tables; what compensation changes, as bars.
#include <Eigen/LU>
#include <cmath>

#include "core/kinds/force/loads_setup.h"
#include "core/text/numbers.h"

namespace covaria::force_loads {

namespace {

std::string key_of(const LoadsSetup& setup, std::size_t c) {
    return setup.channels()[c].kind().key;
}

Table matrix_table(const LoadsSetup& setup) {
    Table table{"matrix", "Calibration matrix: reading by load"};
    table.add("channel");
    for (std::size_t c = 0; c < setup.size(); ++c) {
        const bool moment = setup.channels()[c].kind().is_moment;
        table.add("load " + key_of(setup, c))
            .in(Unit::of(moment ? "mV/V/N/m" : "uV/V/N"))
            .fixed(moment ? 6 : 5);
    }
    for (std::size_t h = 0; h < setup.size(); ++h) {
        std::vector<Cell> row{key_of(setup, h)};
        for (std::size_t c = 0; c < setup.size(); ++c)
            row.push_back(setup.element(h, c).a * setup.scale(h, c));
        table.row(std::move(row));
    }
    const Message condition = Message::number(format_significant(setup.condition, 5));
    table.notes.push_back(
        setup.quadratic ? tell<"Condition number, by rated outputs and rated loads: %1; with quadratic terms "
                               "beside these slopes.">(condition)
                        : tell<"Condition number, by rated outputs and rated loads: %1.">(condition));
    return table;
}

Table inverse_table(const LoadsSetup& setup) {
    Table table{"decoupling", "Decoupling matrix: load by reading"};
    table.add("load");
    for (std::size_t h = 0; h < setup.size(); ++h) table.add("channel " + key_of(setup, h)).figure(5);
    const Eigen::MatrixXd inverse = setup.A().inverse();
    for (std::size_t c = 0; c < setup.size(); ++c) {
        const ForceChannel& load = setup.channels()[c];
        const Unit unit = Unit::of(load.kind().is_moment ? "N*m*V/mV" : "N*V/mV");
        std::vector<Cell> row{key_of(setup, c)};
        for (std::size_t h = 0; h < setup.size(); ++h) {
            const double element = inverse(Eigen::Index(c), Eigen::Index(h)) * load.rated_load /
                                   setup.channels()[h].rated_output;
            row.push_back(Quantity{unit.from_si(element), unit});
        }
        table.row(std::move(row));
    }
    return table;
}

/// Load that the channel alone would tell, by its rated load.
double uncompensated(const LoadsSetup& setup, const Case& one, std::size_t h) {
    return one.v[Eigen::Index(h)] / setup.element(h, h).a;
}

Table loads_table(const LoadsSetup& setup) {
    Table table{"loads", "Loads with and without compensation of interference"};
    table.add("case");
    table.add("load");
    table.add("reading").in(Unit::of("mV/V")).fixed(5);
    table.add("compensated").figure(6);
    table.add("uncompensated").figure(6);
    table.add("difference");
    table.add("by rated load").in(Unit::of("%")).fixed(2);
    for (const Case& one : setup.cases)
        for (std::size_t h = 0; h < setup.size(); ++h) {
            const ForceChannel& channel = setup.channels()[h];
            const Unit unit = channel.load_unit();
            const double l = one.l[Eigen::Index(h)], alone = uncompensated(setup, one, h);
            const auto load = [&](double relative, int digits) {
                const double step = std::pow(10.0, digits);
                return Quantity{std::round(unit.from_si(relative * channel.rated_load) * step) / step, unit};
            };
            table.row({one.name, key_of(setup, h), one.v[Eigen::Index(h)] * channel.rated_output, load(l, 6),
                       load(alone, 6), load(alone - l, 5), alone - l});
        }
    table.notes.push_back(
        tell<"Uncompensated: by the slope of the channel's own axis. The uncertainties of both are among the "
             "results.">());
    return table;
}

}  // namespace

std::vector<Table> tables(const LoadsSetup& setup) {
    return {matrix_table(setup), inverse_table(setup), loads_table(setup)};
}

std::vector<PlotSpecification> figures(const LoadsSetup& setup) {
    constexpr SeriesRole family[] = {SeriesRole::family_1, SeriesRole::family_2, SeriesRole::family_3,
                                     SeriesRole::family_4};
    PlotSpecification plot;
    plot.id = "uncompensated";
    plot.title = "What interference adds without compensation";
    plot.x.title = "per cent of rated load";
    plot.horizontal_bars = true;
    const std::size_t n = setup.size(), shown = std::min(std::size(family), setup.cases.size());
    const double width = 0.8 / static_cast<double>(shown);
    for (std::size_t k = 0; k < shown; ++k) {
        const Case& one = setup.cases[k];
        PlotSeries bars{one.name, SeriesKind::bars, family[k], {}, {}, {}, width, true};
        for (std::size_t h = 0; h < n; ++h) {
            bars.x.push_back(100.0 * (uncompensated(setup, one, h) - one.l[Eigen::Index(h)]));
            bars.y.push_back(static_cast<double>(h) +
                             (static_cast<double>(k) - 0.5 * static_cast<double>(shown - 1)) * width);
        }
        plot.series.push_back(std::move(bars));
    }
    for (std::size_t h = 0; h < n; ++h) plot.y.categories.push_back(key_of(setup, h));
    return {plot};
}

}  // namespace covaria::force_loads
