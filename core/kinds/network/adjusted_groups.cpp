// Groups of readings as candidates for an error: all readings of a station, of a round, to a target, in a
// frame.
#include "core/kinds/network/adjusted_groups.h"

#include <algorithm>
#include <map>

namespace covaria::network {

namespace {

/// Product of readings and unknowns up to which groups are tested.
constexpr std::size_t most_products = 1'000'000;
constexpr std::size_t most_in_group = 300;

std::vector<GroupOfReadings> candidates(const AdjustedNetwork& network) {
    std::map<std::size_t, std::vector<std::size_t>> stations, rounds, targets, frames;
    for (std::size_t i = 0; i < network.readings.size(); ++i) {
        const AdjustedReading& r = network.readings[i];
        if (!is_read(r.kind)) continue;
        if (is_in_frame(r.kind)) frames[r.frame].push_back(i);
        if (r.kind == ReadingKind::direction) rounds[r.round].push_back(i);
        if (r.from == r.to) continue;
        stations[r.from].push_back(i);
        targets[r.to].push_back(i);
        if (r.second != r.to) targets[r.second].push_back(i);
    }
    std::vector<GroupOfReadings> groups;
    const auto add = [&](const auto& found, const auto& words) {
        for (const auto& [number, readings] : found)
            if (readings.size() > 1 && readings.size() < network.readings.size() &&
                readings.size() <= most_in_group)
                groups.push_back({words(number), readings, {}});
    };
    add(stations, [&](std::size_t p) { return tell<"station %1">(network.points[p].name); });
    add(targets, [&](std::size_t p) { return tell<"target %1">(network.points[p].name); });
    add(frames, [&](std::size_t f) { return words_of(network.frames[f]); });
    add(rounds, [&](std::size_t r) {
        const Round& round = network.rounds[r];
        const std::string& station = network.points[round.station].name;
        return round.name.empty() ? tell<"directions at %1">(station)
                                  : tell<"directions at %1, round %2">(station, round.name);
    });
    return groups;
}

}  // namespace

std::vector<GroupOfReadings> groups_of(const AdjustedNetwork& network) {
    if (network.readings.size() * network.place_of.size() > most_products) return {};
    if (network.adjusted->degrees_of_freedom() == 0) return {};
    std::vector<GroupOfReadings> groups = candidates(network);
    if (groups.empty()) return {};
    const adjustment::GroupTests tests(*network.adjusted, network.whitening,
                                       residuals_of(network, network.state.data()));
    for (GroupOfReadings& group : groups) group.test = tests.of(group.readings);
    std::erase_if(groups, [](const GroupOfReadings& group) { return group.test.redundancy == 0; });
    std::ranges::stable_sort(groups, {}, [](const GroupOfReadings& group) { return group.test.p; });
    return groups;
}

Table groups_table(const std::vector<GroupOfReadings>& groups) {
    Table table{"groups", known_text<"Groups of readings">()};
    table.add(known_text<"Group">());
    table.add(known_text<"readings">()).figure(8);
    table.add(known_text<"controlled">()).figure(8);
    table.add(known_text<"sum of squares falls by">()).figure(4);
    table.add("p").symbol().figure(2);
    table.add(known_text<"remark">());
    std::size_t wrong = 0;
    for (const GroupOfReadings& group : groups) {
        const bool contradicts = group.test.p < adjustment::significance;
        wrong += contradicts;
        table.row({group.words, static_cast<double>(group.readings.size()),
                   static_cast<double>(group.test.redundancy), group.test.statistic, group.test.p,
                   contradicts ? tell<"contradicts the others?">() : Message()});
    }
    table.notes.push_back(tell<"Without the group the sum of squares falls by as much, which is a chi-square "
                               "of as many degrees of "
                               "freedom as of its readings the others control; p is its probability.">());
    if (wrong > 0)
        table.notes.push_back(tell<"%1 groups have p < 0.1 %; where several do, look at the first.">(wrong));
    return table;
}

}  // namespace covaria::network
