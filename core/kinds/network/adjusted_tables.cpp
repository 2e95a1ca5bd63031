// Tables of a network adjustment: its figures, and its readings with their residuals and their reliability.
#include <algorithm>
#include <cmath>

#include "core/kinds/network/adjusted_checks.h"
#include "core/kinds/network/adjusted_closures.h"
#include "core/kinds/network/adjusted_datum_fit.h"
#include "core/kinds/network/adjusted_groups.h"
#include "core/kinds/network/adjusted_images.h"
#include "core/kinds/points/component_evidence.h"
#include "core/math/special_quantiles.h"
#include "core/text/numbers.h"
#include "core/text/row_links.h"

namespace covaria::network {

namespace {

/// Product of readings and unknowns up to which effects are computed.
constexpr std::size_t most_effects = 4'000'000;

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

Table figures_table(const AdjustedNetwork& network, const adjustment::Reliability& found) {
    Table table{"adjustment", known_text<"Adjustment">()};
    table.add(known_text<"Figure">());
    table.add(known_text<"Value">()).figure(8);
    const auto add = [&](const Message& words, double value) { table.row({words, value}); };
    add(tell<"readings">(), static_cast<double>(network.readings.size()));
    add(tell<"unknowns">(), static_cast<double>(network.place_of.size()));
    add(tell<"what no reading tells (datum defect)">(), static_cast<double>(network.adjusted->defect()));
    add(tell<"degrees of freedom f">(), found.degrees_of_freedom);
    table.columns.back().rule.by_row.assign(table.rows, 0);  // counts, which have no decimals
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

/// The largest change of a coordinate by the smallest detectable error of a reading (external reliability).
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

/// Places of typed readings in that order; empty for what is stated elsewhere.
std::vector<std::string> places_of(const AdjustedNetwork& network, const std::vector<std::size_t>& order) {
    std::vector<std::string> places;
    for (const std::size_t i : order) {
        const AdjustedReading& reading = network.readings[i];
        places.push_back(reading.row == AdjustedReading::no_round ? std::string() : reading.source);
    }
    return places;
}

Table readings_table(const AdjustedNetwork& network, const adjustment::Reliability& found) {
    Table table{"residuals", known_text<"Residuals of the readings">()};
    table.add(known_text<"Reading">());
    table.add("residual").figure(3);
    table.add(known_text<"u of the reading">()).figure(2);
    table.add(known_text<"redundancy">()).figure(3);
    table.add("w").symbol().figure(3);
    table.add("tau").symbol().figure(3);
    table.add(known_text<"smallest detectable error">()).figure(4);
    table.add(known_text<"its largest effect">()).in(Unit::of("mm")).figure(4);
    table.add(known_text<"on">());
    table.add(known_text<"remark">());
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
        std::vector<Cell> row{words_of(network, reading), Quantity{unit.from_si(r.residual), unit},
                              Quantity{unit.from_si(reading.u), unit}, std::max(0.0, r.redundancy)};
        if (!r.controlled) {
            row.insert(row.end(), {Cell(), Cell(), Cell(), Cell(), Cell(), tell<"not controlled">()});
            table.row(std::move(row));
            continue;
        }
        const bool outlier = std::abs(r.w) > adjustment::outlier_limit();
        outliers += outlier;
        row.insert(row.end(), {r.w, r.tau, Quantity{unit.from_si(r.detectable), unit}});
        const LargestEffect effect = effects ? largest_effect(network, i, r.detectable) : LargestEffect{};
        row.push_back(effects ? Cell(effect.size) : Cell());
        row.push_back(effects && effect.size > 0.0
                          ? Cell(tell<"%1, coordinate %2">(network.points[effect.place / 3].name,
                                                           std::string(along_axes[effect.place % 3])))
                          : Cell());
        constexpr std::size_t most_compared = 30;
        const Message alike = outlier && outliers <= most_compared ? alike_words(network, i) : Message();
        row.push_back(!outlier        ? Message()
                      : alike.empty() ? tell<"outlier?">()
                                      : tell<"outlier? it cannot be told apart from %1">(alike));
        table.row(std::move(row));
    }
    add_row_links(table, [places = places_of(network, order)](std::size_t row) {
        const std::string& place = places[row];
        return place.empty() ? RowLink() : RowLink{place, place + "/use", "left-out", tell<"leave out">()};
    });
    if (outliers > 0)
        table.notes.push_back(
            tell<"%1 readings have |w| > 3.29 (0.1 %); where several do, look at the largest first.">(
                outliers));
    return table;
}

Table left_out_table(const AdjustedNetwork& network) {
    Table table{"left-out", known_text<"What is left out">()};
    table.add(known_text<"What">());
    table.add(known_text<"Reason">());
    for (const LeftOut& out : network.left_out) table.row({out.what, out.why});
    add_row_links(table, [&network](std::size_t row) {
        const LeftOut& out = network.left_out[row];
        return out.is_by_hand ? RowLink{out.source, out.source + "/use", "used", tell<"use again">()}
                              : RowLink{out.source};
    });
    return table;
}

}  // namespace

std::vector<Table> adjustment_tables(const AdjustedNetwork& network) {
    const adjustment::Reliability& found = reliability_of(network);
    std::vector<Table> tables{figures_table(network, found)};
    if (const auto held = held_lengths(network); !held.empty())
        tables.push_back(held_lengths_table(network, held));
    tables.push_back(readings_table(network, found));
    if (const auto groups = groups_of(network); !groups.empty()) tables.push_back(groups_table(groups));
    if (const auto closed = closures(network); !closed.empty()) tables.push_back(closures_table(closed));
    if (auto faces = faces_table(network)) tables.push_back(std::move(*faces));
    if (!network.left_out.empty()) tables.push_back(left_out_table(network));
    return tables;
}

void check_adjustment(const AdjustedNetwork& network, Problems& problems) {
    const adjustment::Reliability& found = reliability_of(network);
    check_held_lengths(network, problems);
    check_images(network, problems);
    if (!is_too_large(found)) return check_datum(network, problems);
    std::size_t worst = 0;
    for (std::size_t i = 0; i < found.readings.size(); ++i)
        if (std::abs(found.readings[i].w) > std::abs(found.readings[worst].w)) worst = i;
    constexpr double far_too_large = 3.0;  // s₀, from which a mistake is likely that concerns many readings
    std::vector<Message> mistakes;
    if (found.s0 > far_too_large) mistakes = likely_mistakes(network);
    if (mistakes.empty()) mistakes = exchanged_names(network);
    for (Message& words : mistakes)
        problems.warning(adjustment_fields().place(&StatedAdjustment::readings), std::move(words));
    const AdjustedReading& largest = network.readings[worst];
    std::vector<Remedy> remedies;
    if (mistakes.empty() && largest.row != AdjustedReading::no_round)
        remedies.push_back({tell<"leave it out">(), {{largest.source + "/use", "left-out"}}});
    remedies.push_back(remedy_as_seen(adjustment_fields().place(&StatedAdjustment::uncertainties)));
    problems.add(
        {.severity = Severity::warning,
         .path = largest.source,
         .message =
             tell<"%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty "
                  "is the %2. Look for mistyped or exchanged readings, or uncertainties that are too small">(
                 test_words(found), words_of(network, largest)),
         .remedies = std::move(remedies)});
}

}  // namespace covaria::network
