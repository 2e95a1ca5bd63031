// Tables of a network adjustment: its figures, and its readings with their residuals and their reliability.
#include <algorithm>
#include <cmath>

#include "core/kinds/network/adjusted_setup.h"
#include "core/math/special_quantiles.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

constexpr std::size_t most_effects = 4'000'000;  ///< readings times unknowns of which effects are computed

Message test_words(const adjustment::Reliability& found) {
    return tell<"Chi-square of the residuals: %1 with %2 degrees of freedom, p = %3.">(
        Message::number(format_short(found.sum_of_squares, 6)), found.degrees_of_freedom,
        Message::number(
            format_short(chi_squared_upper_tail(found.sum_of_squares, found.degrees_of_freedom), 2)));
}

bool is_too_large(const adjustment::Reliability& found) {
    return found.degrees_of_freedom > 0 &&
           chi_squared_upper_tail(found.sum_of_squares, found.degrees_of_freedom) < 0.01;
}

DataTable figures_table(const AdjustedNetwork& network, const adjustment::Reliability& found) {
    DataTable table;
    table.id = "adjustment";
    table.title = known_text<"Adjustment">();
    table.columns = {{.header = known_text<"Figure">()}, {.header = known_text<"Value">(), .digits = 8}};
    const auto add = [&](const Message& words, double value) { table.rows.push_back({words, value}); };
    add(tell<"readings">(), static_cast<double>(network.readings.size()));
    add(tell<"unknowns">(), static_cast<double>(network.place_of.size()));
    add(tell<"what no reading tells (datum defect)">(), static_cast<double>(network.adjusted->defect()));
    add(tell<"degrees of freedom f">(), found.degrees_of_freedom);
    add(tell<"sum of squares vᵀ C⁻¹ v">(), found.sum_of_squares);
    if (found.degrees_of_freedom > 0) add(tell<"s₀ a posteriori">(), found.s0);
    add(tell<"δ₀ of smallest detectable errors (0.1 %, 80 %)">(), adjustment::non_centrality());
    if (found.degrees_of_freedom == 0) {
        table.notes.push_back(
            tell<"No redundancy: as many readings as unknowns, so nothing can be checked.">());
        return table;
    }
    table.notes.push_back(test_words(found));
    const double p = chi_squared_upper_tail(found.sum_of_squares, found.degrees_of_freedom);
    table.notes.push_back(p < 0.01 ? tell<"The residuals are larger than the uncertainties allow.">()
                          : p > 0.99
                              ? tell<"The residuals are smaller than the uncertainties lead to expect.">()
                              : tell<"The residuals agree with the uncertainties.">());
    return table;
}

struct LargestEffect {
    double size = 0.0;
    std::size_t place = 0;
};

/// What the smallest detectable error of a reading does to a coordinate, at most.
LargestEffect largest_effect(const AdjustedNetwork& network, std::size_t reading, double error) {
    const Eigen::VectorXd effect =
        adjustment::effect_of(*network.adjusted, network.whitening, reading) * error;
    LargestEffect largest;
    for (std::size_t k = 0; k < network.place_of.size(); ++k) {
        if (network.place_of[k] >= 3 * network.points.size()) continue;
        const double size = std::abs(effect[static_cast<Eigen::Index>(k)]);
        if (size > largest.size) largest = {size, network.place_of[k]};
    }
    return largest;
}

DataTable readings_table(const AdjustedNetwork& network, const adjustment::Reliability& found) {
    DataTable table;
    table.id = "residuals";
    table.title = known_text<"Residuals of the readings">();
    table.columns = {{.header = known_text<"Reading">()},
                     {.header = "residual", .digits = 3},
                     {.header = known_text<"u of the reading">(), .digits = 2},
                     {.header = known_text<"redundancy">(), .digits = 3},
                     {.header = "w", .is_symbol = true, .digits = 3},
                     {.header = "tau", .is_symbol = true, .digits = 3},
                     {.header = known_text<"smallest detectable error">(), .digits = 4},
                     {.header = known_text<"its largest effect">(), .unit = Unit::of("mm"), .digits = 4},
                     {.header = known_text<"on">()},
                     {.header = known_text<"remark">()}};
    const bool effects = network.readings.size() * network.place_of.size() <= most_effects;
    std::vector<std::size_t> order(network.readings.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(found.readings[a].w) > std::abs(found.readings[b].w);
    });
    std::size_t outliers = 0;
    for (const std::size_t i : order) {
        const AdjustedReading& reading = network.readings[i];
        const adjustment::ReadingReliability& r = found.readings[i];
        const Unit unit = unit_of_residual(reading.kind);
        std::vector<TableCell> row{words_of(network, reading), Quantity{unit.from_si(r.residual), unit},
                                   Quantity{unit.from_si(reading.u), unit}, std::max(0.0, r.redundancy)};
        if (!r.controlled) {
            row.insert(row.end(), {TableCell(), TableCell(), TableCell(), TableCell(), TableCell(),
                                   tell<"not controlled">()});
            table.rows.push_back(std::move(row));
            continue;
        }
        const bool outlier = std::abs(r.w) > adjustment::outlier_limit();
        outliers += outlier;
        row.insert(row.end(), {r.w, r.tau, Quantity{unit.from_si(r.detectable), unit}});
        const LargestEffect effect = effects ? largest_effect(network, i, r.detectable) : LargestEffect{};
        row.push_back(effects ? TableCell(effect.size) : TableCell());
        row.push_back(effects && effect.size > 0.0
                          ? TableCell(tell<"%1, coordinate %2">(network.points[effect.place / 3].name,
                                                                std::string(along_axes[effect.place % 3])))
                          : TableCell());
        constexpr std::size_t most_compared = 30;
        const Message alike = outlier && outliers <= most_compared ? alike_words(network, i) : Message();
        row.push_back(!outlier        ? Message()
                      : alike.empty() ? tell<"outlier?">()
                                      : tell<"outlier? it cannot be told apart from %1">(alike));
        table.rows.push_back(std::move(row));
    }
    if (outliers > 0)
        table.notes.push_back(
            tell<"%1 readings have |w| > 3.29 (0.1 %); where several do, look at the largest first.">(
                outliers));
    return table;
}

DataTable left_out_table(const AdjustedNetwork& network) {
    DataTable table;
    table.id = "left-out";
    table.title = known_text<"What is left out">();
    table.columns = {{.header = known_text<"What">()}, {.header = known_text<"Reason">()}};
    for (const LeftOut& out : network.left_out) table.rows.push_back({out.what, out.why});
    return table;
}

}  // namespace

adjustment::Reliability reliability_of(const AdjustedNetwork& network) {
    return adjustment::reliability_of(*network.adjusted, network.whitening, network.blocks,
                                      residuals_of(network, network.state.data()));
}

std::vector<DataTable> adjustment_tables(const AdjustedNetwork& network) {
    const adjustment::Reliability found = reliability_of(network);
    std::vector<DataTable> tables{figures_table(network, found), readings_table(network, found)};
    if (!network.left_out.empty()) tables.push_back(left_out_table(network));
    return tables;
}

void check_adjustment(const AdjustedNetwork& network, Problems& problems) {
    const adjustment::Reliability found = reliability_of(network);
    if (!is_too_large(found)) return;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < found.readings.size(); ++i)
        if (std::abs(found.readings[i].w) > std::abs(found.readings[worst].w)) worst = i;
    for (Message& words : exchanged_names(network))
        problems.warning(adjustment_fields().place(&StatedAdjustment::readings), std::move(words));
    problems.warning(
        network.readings[worst].source,
        tell<"%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty "
             "is the %2. Look for mistyped or exchanged readings, or uncertainties that are too small">(
            test_words(found), words_of(network, network.readings[worst])));
}

}  // namespace covaria::network
