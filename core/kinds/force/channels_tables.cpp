// The paper's evaluation and the GUM's side by side, as a table and as bars.
#include <cmath>

#include "core/kinds/force/channels_setup.h"
#include "core/math/special_quantiles.h"

namespace covaria::force_channels {

namespace {

/// The evaluations of one channel, as parts of its rated output.
struct Comparison {
    std::string sensor;
    double paper, all, largest, alone, degrees_of_freedom, k_alone, worst;
};

std::vector<Comparison> comparisons(const ChannelSetup& setup) {
    std::vector<Comparison> rows;
    for (std::size_t h = 0; h < setup.size(); ++h) {
        const ForceChannel& channel = setup.channels()[h];
        const double output = std::abs(channel.rated_output);
        const Single single = single_component(setup, h);
        const double k95 = t_quantile(0.975, single.degrees_of_freedom);
        rows.push_back({channel.kind().key, setup.sensor->paper_expanded_uncertainty(h) / output,
                        setup.k * combined(setup, h, OtherLoads::all) / output,
                        setup.k * combined(setup, h, OtherLoads::largest) / output, k95 * single.u / output,
                        single.degrees_of_freedom, k95, worst_case(setup, h) / output});
    }
    return rows;
}

Table comparison_table(const ChannelSetup& setup) {
    const auto percent = [](const char* header, int decimals = 3) {
        return Column{header}.in(Unit::of("%")).fixed(decimals);
    };
    Table table{"paper-and-gum", "The paper's U and the GUM's, per cent of rated output"};
    table.add("sensor");
    table.add(percent("paper, linear sum"));
    table.add(percent("GUM, unknown loads on all other axes"));
    table.add(percent("GUM, unknown load on one axis"));
    table.add(percent("GUM, one component alone, 95 %"));
    table.add("nu_eff").symbol().fixed(0);
    table.add("k").symbol().fixed(2);
    table.add(percent("all other axes at rated load, worst signs"));
    table.add("interference alone exceeds the paper's U");
    std::size_t exceeding = 0;
    for (const Comparison& c : comparisons(setup)) {
        exceeding += c.worst > c.paper ? 1 : 0;
        table.row({c.sensor, c.paper, c.all, c.largest, c.alone,
                   std::isfinite(c.degrees_of_freedom) ? Cell(c.degrees_of_freedom) : Cell(std::string("∞")),
                   c.k_alone, c.worst, c.worst > c.paper ? tell<"yes">() : tell<"no">()});
    }
    table.notes = {
        tell<"The paper adds the largest hysteresis and the largest interference to k times u_c. It counts "
             "one other load only: with several loads their interference adds up, and exceeds the paper's U "
             "for %1 of %2 sensors when all act fully.">(exceeding, setup.size()),
        tell<"So the linear sum is no bound under combined load, and for one component alone it is far too "
             "large. As hysteresis and interference are limits and no standard uncertainties, it is no "
             "coverage interval either.">(),
        tell<"GUM: hysteresis, non-zero error and resolution are rectangular, each unknown load is "
             "rectangular between minus and plus its rated load, root sum of squares. One component alone: k "
             "from the t-distribution with the effective degrees of freedom.">()};
    return table;
}

Table parts_table(const ChannelSetup& setup) {
    Table table{"gum-parts", "Standard uncertainties by the GUM"};
    table.add("sensor");
    for (const char* const header :
         {"repeatability", "machine", "resolution", "non-zero", "hysteresis", "interference", "all"})
        table.add(header).in(Unit::of("mV/V")).fixed(6);
    for (std::size_t h = 0; h < setup.size(); ++h) {
        const ForceChannel& channel = setup.channels()[h];
        const double single = single_component(setup, h).u, all = combined(setup, h, setup.others);
        const double root12 = std::sqrt(12.0);
        const double u_a = setup.pooled ? channel.s_single(true) / std::sqrt(channel.runs) : channel.u_a;
        table.row({std::string(channel.kind().key), u_a,
                   channel.u_calibrator * std::abs(channel.rated_output), setup.sensor->resolution() / root12,
                   channel.zero / root12, channel.hysteresis / root12,
                   std::sqrt(std::max(0.0, all * all - single * single)), all});
    }
    if (!setup.pooled)
        table.notes.push_back(
            tell<"Repeatability: the largest of the steps; its degrees of freedom are those of one "
                 "step. Pooled over the steps it has more of them.">());
    return table;
}

}  // namespace

std::vector<Table> tables(const ChannelSetup& setup) {
    return {comparison_table(setup), parts_table(setup)};
}

std::vector<PlotSpecification> figures(const ChannelSetup& setup) {
    PlotSpecification plot;
    plot.id = "paper-and-gum";
    plot.title = "U by the paper and by the GUM";
    plot.x.title = "per cent of rated output";
    plot.horizontal_bars = true;
    struct Bar {
        const char* name;
        double Comparison::*value;
        SeriesRole role;
    };
    const Bar bars[] = {{"paper, linear sum", &Comparison::paper, SeriesRole::family_1},
                        {"GUM, unknown loads on all other axes", &Comparison::all, SeriesRole::family_2},
                        {"all others at rated load, worst signs", &Comparison::worst, SeriesRole::family_3}};
    const std::vector<Comparison> rows = comparisons(setup);
    const std::size_t n = rows.size();
    constexpr double width = 0.26;
    double place = -width;
    for (const Bar& bar : bars) {
        PlotSeries series{bar.name, SeriesKind::bars, bar.role, {}, {}, {}, width};
        for (std::size_t h = 0; h < n; ++h) {
            series.x.push_back(100.0 * rows[h].*bar.value);
            series.y.push_back(static_cast<double>(h) + place);
        }
        plot.series.push_back(std::move(series));
        place += width;
    }
    for (const Comparison& row : rows) plot.y.categories.push_back(row.sensor);
    return {plot};
}

}  // namespace covaria::force_channels
