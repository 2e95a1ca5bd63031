// Input quantities of "network adjustment": one for each reading, and for each stated coordinate; and the
// places of its points and sights.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/name.h"
#include "core/kinds/network/adjusted_setup.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

constexpr std::size_t most_drawn = 600;  ///< sights that can be told apart in one picture

std::string group_of(const AdjustedNetwork& network, const AdjustedReading& reading) {
    if (reading.frame != AdjustedReading::no_frame) return network.frames[reading.frame].name;
    if (is_read(reading.kind) || reading.tilt != AdjustedReading::no_tilt)
        return network.points[reading.from].name;
    return network.figures[reading.figures.front()].instrument;
}

/// Whether each reading contradicts the others, and not only because one that is further off pulls at it.
std::vector<char> outliers_in(const AdjustedNetwork& network) {
    constexpr double by_another = 0.5;  // of the largest |w|
    const adjustment::Reliability& found = reliability_of(network);
    double limit = adjustment::outlier_limit();
    for (const adjustment::ReadingReliability& r : found.readings)
        if (r.controlled) limit = std::max(limit, by_another * std::abs(r.w));
    std::vector<char> is_outlier(network.readings.size(), 0);
    for (std::size_t i = 0; i < found.readings.size(); ++i)
        is_outlier[i] = found.readings[i].controlled && std::abs(found.readings[i].w) > limit;
    return is_outlier;
}

}  // namespace

InputSet adjustment_inputs(const AdjustedNetwork& network) {
    InputSet inputs;
    for (const AdjustedReading& reading : network.readings) {
        const bool ratio = reading.kind == ReadingKind::figure_ratio;
        const Unit unit = Unit::of(ratio ? "1" : is_of_angle(reading.kind) ? "gon" : "m");
        UncertaintyComponent component{
            .id = reading.symbol,
            .name = words_of(network, reading),
            .unit = ratio ? Unit::of("ppm") : Unit::of(is_of_angle(reading.kind) ? "gon" : "mm"),
            .distribution = Distribution::of(Normal{0.0, reading.u}),
            .origin = tell<"as stated">(),
            .source = reading.source};
        const bool seen = reading.estimate != AdjustedReading::no_round;
        if (seen) {
            component.type = EvaluationType::type_a;
            component.degrees_of_freedom = reading.degrees_of_freedom;
            const Message factor = Message::number(format_significant(reading.factor, 3));
            component.origin = reading.seen_in.empty() ? tell<"as seen: %1 times what was stated">(factor)
                                                       : tell<"as seen in %1: %2 times what is stated here">(
                                                             reading.seen_in_name, factor);
            if (reading.between > 0.0)
                component.origin = tell<"%1; from one campaign to the next it changes by %2 %">(
                    component.origin, Message::number(format_significant(100.0 * reading.between, 2)));
        }
        InputQuantity quantity{.symbol = reading.symbol,
                               .name = words_of(network, reading),
                               .unit = unit,
                               .offset = reading.value,
                               .group = group_of(network, reading),
                               .source = reading.source};
        const std::size_t added = inputs.add(std::move(component));
        const std::string estimate = "seen." + std::to_string(reading.estimate);
        // The figures of another analysis are the same wherever they are used.
        if (seen && reading.seen_in.empty()) inputs.rest_on_estimate(estimate, added);
        if (seen && !reading.seen_in.empty())
            inputs.rest_on_estimate(reading.seen_in + "." + estimate, added, true);
        quantity.shares.push_back({added, 1.0});
        inputs.quantities.push_back(std::move(quantity));
    }
    for (const ReadingCorrelation& c : network.correlations)
        inputs.correlations.push_back({c.first, c.second, c.coefficient});
    return inputs;
}

Layout adjustment_layout(const AdjustedNetwork& network) {
    Layout layout;
    std::vector<char> is_station(network.points.size(), 0);
    for (const AdjustedReading& reading : network.readings)
        if (reading.from != reading.to) is_station[reading.from] = 1;
    for (std::size_t p = 0; p < network.points.size(); ++p) {
        const AdjustedPoint& point = network.points[p];
        LayoutPoint drawn{.name = point.name,
                          .kind = is_station[p] ? PointKind::station : PointKind::target,
                          .p_W = network.position(p),
                          .source = {adjustment_fields().place(&StatedAdjustment::points, point.row), false}};
        std::array<std::size_t, 3> outputs{};
        bool all = true;
        for (std::size_t c = 0; c < 3; ++c) {
            outputs[c] = network.unknown_of[network.at(p, c)];
            all = all && outputs[c] != AdjustedNetwork::known;
        }
        if (all) drawn.outputs = outputs;
        layout.points.push_back(std::move(drawn));
    }
    const std::vector<char> is_outlier = outliers_in(network);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;  // numbers of sights
    for (std::size_t i = 0; i < network.readings.size(); ++i) {
        const AdjustedReading& reading = network.readings[i];
        if (reading.from == reading.to) continue;
        for (const std::size_t to : {reading.to, reading.second}) {
            if (to != reading.to && reading.kind != ReadingKind::angle) continue;
            const auto sight = known.find({reading.from, to});
            if (sight != known.end()) {
                LayoutLink& link = layout.links[sight->second];
                link.is_doubtful = link.is_doubtful || is_outlier[i] != 0;
                continue;
            }
            if (known.size() >= most_drawn && !is_outlier[i]) continue;
            known.try_emplace({reading.from, to}, layout.links.size());
            layout.links.push_back(
                {.name = network.points[reading.from].name + " – " + network.points[to].name,
                 .kind = LinkKind::sight_line,
                 .from_W = network.position(reading.from),
                 .to_W = network.position(to),
                 .is_doubtful = is_outlier[i] != 0});
        }
    }
    return layout;
}

}  // namespace covaria::network
