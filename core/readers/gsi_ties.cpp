#include "core/readers/gsi_ties.h"

#include <cmath>
#include <set>

#include "core/base/disjoint_sets.h"

namespace covaria {

namespace {

/// A difference by which two set-ups must not have two points apart, m.
constexpr double most_apart = 0.1;
/// A height by which sights there and back must not miss, m; pairs of set-ups that are looked at.
constexpr double most_height = 0.02;
constexpr std::size_t most_pairs = 100'000;

double across(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(b[0] - a[0], b[1] - a[1]);
}

}  // namespace

GsiTies::GsiTies(const GsiContent& content) : content_(content) {
    for (const GsiPoint& point : content.points)
        if (!point.is_of_sight) control_.try_emplace(point.name, &point);
    name_stations();
    find_ties();
}

/// Set-ups that the file gives no name, or that of another place, are points of their own.
void GsiTies::name_stations() {
    std::set<std::string> taken;
    for (const GsiSetUp& set_up : content_.set_ups) {
        taken.insert(set_up.station);
        for (const GsiSight& sight : set_up.sights) taken.insert(sight.point);
    }
    for (std::size_t i = 0; i < content_.set_ups.size(); ++i) {
        std::string name = content_.set_ups[i].station;
        for (std::size_t k = i + 1; name.empty(); ++k)
            if (const std::string own = "station " + std::to_string(k); taken.insert(own).second) name = own;
        stations_.push_back(std::move(name));
    }
}

/// Places of the points that a set-up knows, in its own axes: its station, and the targets that it sees
/// whole.
GsiTies::Places GsiTies::places_from(std::size_t set_up) const {
    Places places;
    const GsiSetUp& from = content_.set_ups[set_up];
    if (from.sights.empty()) return places;
    places[stations_[set_up]] = {};
    for (const GsiSight& s : from.sights) {
        if (!s.is_whole()) continue;
        const double across = *s.distance * std::sin(*s.zenith);
        places.try_emplace(s.point,
                           std::array<double, 3>{across * std::sin(*s.azimuth), across * std::cos(*s.azimuth),
                                                 *s.distance * std::cos(*s.zenith)});
    }
    return places;
}

void GsiTies::find_ties() {
    const std::size_t n = content_.set_ups.size();
    std::vector<Places> places;
    for (std::size_t i = 0; i < n; ++i) places.push_back(places_from(i));
    DisjointSets sets(n + 1);  // the last are the points with coordinates of their own
    std::map<std::string, std::vector<std::size_t>> seen_from;
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t control = 0;
        for (const auto& [name, at] : places[i]) {
            seen_from[name].push_back(i);
            control += control_.contains(name);
        }
        if (control > 1) sets.join(i, n);
    }
    std::map<std::pair<std::size_t, std::size_t>, std::string> first;  // first common point of two set-ups
    std::size_t looked = 0;
    for (const auto& [name, set_ups] : seen_from)
        for (std::size_t a = 0; a < set_ups.size(); ++a)
            for (std::size_t b = a + 1; b < set_ups.size() && ++looked < most_pairs; ++b) {
                const std::size_t i = set_ups[a], j = set_ups[b];
                const auto [common, added] = first.try_emplace({i, j}, name);
                if (added || sets.leader_of(i) == sets.leader_of(j)) continue;
                const double here = across(places[i].at(common->second), places[i].at(name)),
                             there = across(places[j].at(common->second), places[j].at(name));
                if (std::abs(here - there) < most_apart + 1e-3 * here) sets.join(i, j);
            }
    std::vector<std::size_t> leaders;
    for (std::size_t i = 0; i <= n; ++i) leaders.push_back(sets.leader_of(i));
    take_largest(leaders);
}

void GsiTies::take_largest(const std::vector<std::size_t>& leaders) {
    const std::size_t n = content_.set_ups.size();
    std::map<std::size_t, std::size_t> sights, members;
    for (std::size_t i = 0; i < n; ++i) {
        sights[leaders[i]] += content_.set_ups[i].sights.size();
        members[leaders[i]] += !content_.set_ups[i].sights.empty();
    }
    std::size_t best = n + 1, most = 0;
    for (const auto& [leader, count] : sights)
        if (count > most && (members[leader] > 1 || leader == leaders[n])) best = leader, most = count;
    for (std::size_t i = 0; i < n; ++i)
        tied_.push_back(leaders[i] == best && !content_.set_ups[i].sights.empty());
}

/// Whether sights there and back close better with the heights of the file than without: where stations are
/// changed for reflectors on the same tribrachs, heights that were typed once are those of nothing.
bool GsiTies::are_heights_of_ground() const {
    std::map<std::pair<std::string, std::string>, std::array<double, 2>> rises;  // with heights, without
    double with = 0.0, without = 0.0;
    for (std::size_t i = 0; i < content_.set_ups.size(); ++i)
        for (const GsiSight& s : content_.set_ups[i].sights) {
            if (!tied_[i] || !s.is_whole()) continue;
            const double rise = *s.distance * std::cos(*s.zenith);
            rises.try_emplace({stations_[i], s.point},
                              std::array<double, 2>{rise + s.instrument_height - s.target_height, rise});
        }
    for (const auto& [ends, rise] : rises)
        if (const auto back = rises.find({ends.second, ends.first}); back != rises.end()) {
            with = std::max(with, std::abs(rise[0] + back->second[0]));
            without = std::max(without, std::abs(rise[1] + back->second[1]));
        }
    return !(with > 10.0 * without && with > most_height);
}

}  // namespace covaria
