// Names that were exchanged: sights of one station that contradict the others, and agree with them when the
// names of two targets change places.
#include <cmath>
#include <map>

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

namespace {

/// Readings of one station, by their targets.
using SightsByTarget = std::map<std::size_t, std::vector<std::size_t>>;

/// The largest offset of the readings in units of their u, if they were readings of the point `target`.
double misfit(const AdjustedNetwork& network, const std::vector<std::size_t>& readings, std::size_t target) {
    double largest = 0.0;
    for (const std::size_t i : readings) {
        AdjustedReading as_read = network.readings[i];
        as_read.to = as_read.second = target;
        largest =
            std::fmax(largest, std::abs(residual_of(network, as_read, as_read.value, network.state.data())) /
                                   as_read.u);
    }
    return largest;
}

void say_exchanged(const AdjustedNetwork& network, std::size_t station, const SightsByTarget& sights,
                   std::vector<Message>& said) {
    const double limit = 2.0 * adjustment::outlier_limit();
    std::vector<std::size_t> wrong;
    for (const auto& [target, readings] : sights)
        if (misfit(network, readings, target) > limit) wrong.push_back(target);
    for (std::size_t a = 0; a < wrong.size(); ++a)
        for (std::size_t b = a + 1; b < wrong.size(); ++b)
            if (misfit(network, sights.at(wrong[a]), wrong[b]) < limit &&
                misfit(network, sights.at(wrong[b]), wrong[a]) < limit)
                said.push_back(words_of_exchange(network, station, wrong[a], wrong[b]));
}

}  // namespace

Message words_of_exchange(const AdjustedNetwork& network, std::size_t station, std::size_t a, std::size_t b) {
    return tell<"the readings from %1 agree if the names %2 and %3 are exchanged there">(
        network.points[station].name, network.points[a].name, network.points[b].name);
}

std::vector<Message> exchanged_names(const AdjustedNetwork& adjusted) {
    constexpr std::size_t most_readings = 1000, most_wrong = 100;
    if (adjusted.readings.size() > most_readings) return {};
    AdjustedNetwork network = adjusted;
    start_robustly(network);
    std::map<std::size_t, SightsByTarget> stations;
    for (std::size_t i = 0; i < network.readings.size(); ++i)
        if (const AdjustedReading& r = network.readings[i];
            is_read(r.kind) && r.from != r.to && r.kind != ReadingKind::angle)
            stations[r.from][r.to].push_back(i);
    std::vector<Message> said;
    for (const auto& [station, sights] : stations)
        if (sights.size() <= most_wrong) say_exchanged(network, station, sights, said);
    return said;
}

}  // namespace covaria::network
