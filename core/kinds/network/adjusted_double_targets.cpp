// Double targets before the adjustment: two sights of one station tell the distance and the height difference
// of their targets, which a bar, coordinates or another station tell too.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/kinds/network/closure_sums.h"

namespace covaria::network {

namespace {

constexpr std::size_t none = ClosureSums::none;

/// The readings of a sight: direction, distance, and the zenith angle to the same height of the target.
struct SightReadings {
    std::size_t direction = none, zenith = none, distance = none;
    bool is_in_space() const { return zenith != none; }
};

/// The sights from one station in one round, by target.
using SightsOfRound = std::map<std::size_t, SightReadings>;

/// Places by readings of sights, with the figures of instruments as far as they are stated.
class SightGeometry {
public:
    using Values = ClosureSums::Values;
    explicit SightGeometry(const ClosureSums& sums) : sums_(sums), network_(sums.network) {}

    /// Whether index, zero, scale and refraction of the reading are known before the adjustment, in an
    /// instrument that is levelled.
    bool is_known(const AdjustedReading& r) const {
        if (r.tilt != AdjustedReading::no_tilt) return false;
        return std::ranges::all_of(r.figures, [&](std::size_t f) {
            if (network_.figures[f].kind == FigureKind::refraction) return !network_.figures[f].is_found;
            return !network_.figures[f].is_found || sums_.stated(f) != none;
        });
    }

    double distance(const Values& values, std::size_t i) const {
        const AdjustedReading& r = network_.readings[i];
        return (values[i] - figure(values, r, FigureKind::zero)) /
               (1.0 + figure(values, r, FigureKind::scale));
    }

    /// The place of the target seen from the station, in axes that are turned about the vertical.
    Eigen::Vector3d place(const Values& values, const SightReadings& sight) const {
        const AdjustedReading &direction = network_.readings[sight.direction],
                              &of_distance = network_.readings[sight.distance];
        const double d = distance(values, sight.distance);
        double z = 0.5 * std::numbers::pi, fall = 0.0, raised = 0.0;
        if (sight.is_in_space()) {
            const AdjustedReading& zenith = network_.readings[sight.zenith];
            z = values[sight.zenith] -
                (zenith.face_two ? -1.0 : 1.0) * figure(values, zenith, FigureKind::index);
            fall = 0.5 * network_.curvature * (1.0 - refraction(zenith));
            raised = zenith.height_from - zenith.height_to;
        }
        const bool slope = of_distance.kind == ReadingKind::slope_distance;
        const double level = slope ? d * std::sin(z) : d, up = level / std::tan(z);
        const double a = values[sight.direction] - (direction.face_two ? -1.0 : 1.0) *
                                                       figure(values, direction, FigureKind::collimation) /
                                                       std::sin(z);
        return {level * std::cos(a), level * std::sin(a), up + fall * level * level + raised};
    }

    /// Adds the readings of the sight, and what states the figures of their instrument.
    void use(const SightReadings& sight, std::vector<std::size_t>& used) const {
        for (const std::size_t i : {sight.direction, sight.zenith, sight.distance})
            if (i != none) use(i, used);
    }
    void use(std::size_t reading, std::vector<std::size_t>& used) const {
        const auto add = [&](std::size_t i) {
            if (std::ranges::find(used, i) == used.end()) used.push_back(i);
        };
        for (const std::size_t f : network_.readings[reading].figures)
            if (sums_.stated(f) != none) add(sums_.stated(f));
        add(reading);
    }

private:
    double figure(const Values& values, const AdjustedReading& r, FigureKind kind) const {
        for (const std::size_t f : r.figures)
            if (network_.figures[f].kind == kind)
                return sums_.stated(f) != none
                           ? values[sums_.stated(f)]
                           : network_.state[static_cast<Eigen::Index>(network_.figure(f))];
        return 0.0;
    }

    double refraction(const AdjustedReading& zenith) const {
        for (const std::size_t f : zenith.figures)
            if (network_.figures[f].kind == FigureKind::refraction)
                return network_.state[static_cast<Eigen::Index>(network_.figure(f))];
        return network_.refraction;
    }

    const ClosureSums& sums_;
    const AdjustedNetwork& network_;
};

class DoubleTargets {
public:
    explicit DoubleTargets(ClosureSums& sums) : sums_(sums), network_(sums.network), sights_(sums) {
        collect();
        for (std::size_t i = 0; i < rounds_.size(); ++i)
            for (const auto& [target, sight] : rounds_[i]) seen_in_[target].push_back(i);
    }

    void compare() {
        for (std::size_t i = 0; i < network_.readings.size(); ++i) compare_with_reading(i);
        for (std::size_t k = 0; k < rounds_.size(); ++k) {
            compare_with_coordinates(k);
            compare_with_station(k);
        }
    }

private:
    using Values = ClosureSums::Values;

    void collect() {
        using Sight = std::tuple<std::size_t, std::size_t, double, double>;
        std::map<Sight, std::size_t> zeniths;
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> distances;
        const auto sight_of = [](const AdjustedReading& r) {
            return Sight{r.from, r.to, r.height_from, r.height_to};
        };
        for (std::size_t i = 0; i < network_.readings.size(); ++i) {
            const AdjustedReading& r = network_.readings[i];
            if (r.kind <= ReadingKind::z && r.kind >= ReadingKind::x)
                stated_.try_emplace(
                    {r.from, static_cast<std::size_t>(r.kind) - static_cast<std::size_t>(ReadingKind::x)}, i);
            if (!sights_.is_known(r)) continue;
            if (r.kind == ReadingKind::zenith_angle) zeniths.try_emplace(sight_of(r), i);
            if (r.kind == ReadingKind::slope_distance || r.kind == ReadingKind::horizontal_distance)
                distances.try_emplace({r.from, r.to}, i);
        }
        rounds_.resize(network_.rounds.size());
        for (std::size_t i = 0; i < network_.readings.size(); ++i) {
            const AdjustedReading& r = network_.readings[i];
            if (r.kind != ReadingKind::direction || !sights_.is_known(r)) continue;
            SightReadings sight{.direction = i};
            const auto read = distances.find({r.from, r.to});
            if (read == distances.end()) continue;
            sight.distance = read->second;
            const AdjustedReading& distance = network_.readings[sight.distance];
            if (const auto zenith = zeniths.find(sight_of(distance)); zenith != zeniths.end())
                sight.zenith = zenith->second;
            if (distance.kind == ReadingKind::slope_distance && !sight.is_in_space()) continue;
            rounds_[r.round].try_emplace(r.to, sight);
        }
    }

    const std::string& name(std::size_t point) const { return network_.points[point].name; }
    std::size_t station(std::size_t round) const { return network_.rounds[round].station; }

    /// Compares a length or height difference between two targets with the first round that sees both.
    void compare_with_reading(std::size_t i) {
        const AdjustedReading& r = network_.readings[i];
        const bool distance =
                       r.kind == ReadingKind::slope_distance || r.kind == ReadingKind::horizontal_distance,
                   rise = r.kind == ReadingKind::height_difference || r.kind == ReadingKind::dz;
        if ((!distance && !rise) || !sights_.is_known(r)) return;
        const auto a = seen_in_.find(r.from), b = seen_in_.find(r.to);
        if (a == seen_in_.end() || b == seen_in_.end()) return;
        for (const std::size_t k : a->second) {
            if (std::ranges::find(b->second, k) == b->second.end()) continue;
            const SightReadings p = rounds_[k].at(r.from), q = rounds_[k].at(r.to);
            const bool level = r.kind == ReadingKind::horizontal_distance;
            if (!level && !(p.is_in_space() && q.is_in_space())) continue;
            std::vector<std::size_t> used;
            sights_.use(p, used);
            sights_.use(q, used);
            sights_.use(i, used);
            return sums_.add(
                tell<"%1 and the sights of both from %2">(words_of(network_, r), name(station(k))), used,
                [=, this](const Values& values) {
                    Eigen::Vector3d v = sights_.place(values, q) - sights_.place(values, p);
                    v.z() += network_.readings[i].height_to - network_.readings[i].height_from;
                    if (rise) return values[i] - v.z();
                    return sights_.distance(values, i) - (level ? v.head<2>().norm() : v.norm());
                });
        }
    }

    /// The distance of the targets of two sights; in the plane, if not all of them are in space.
    double between(const Values& values, const SightReadings& p, const SightReadings& q,
                   bool in_space) const {
        const Eigen::Vector3d v = sights_.place(values, q) - sights_.place(values, p);
        return in_space ? v.norm() : v.head<2>().norm();
    }

    /// The reading that states this coordinate, or `none` of a fixed one; nothing of an unknown one.
    std::optional<std::size_t> known(std::size_t point, std::size_t axis) const {
        const auto found = stated_.find({point, axis});
        if (found != stated_.end()) return found->second;
        if (network_.points[point].role[axis] == CoordinateRole::fixed) return none;
        return {};
    }

    /// Compares distances of targets that are known with those of their sights in the round.
    void compare_with_coordinates(std::size_t k) {
        const SightsOfRound& round = rounds_[k];
        std::size_t first = none;
        for (const auto& [target, sight] : round) {
            const bool in_plane = known(target, 0) && known(target, 1);
            if (!in_plane) continue;
            if (first == none) {
                first = target;
                continue;
            }
            const SightReadings p = round.at(first), q = sight;
            const std::array<std::size_t, 2> ends{first, target};
            const bool in_space = p.is_in_space() && q.is_in_space() && known(first, 2) && known(target, 2);
            std::vector<std::size_t> used;
            for (const std::size_t end : ends)
                for (std::size_t c = 0; c < (in_space ? 3 : 2); ++c)
                    if (*known(end, c) != none) used.push_back(*known(end, c));
            sights_.use(p, used);
            sights_.use(q, used);
            sums_.add(tell<"distance %1 – %2 by coordinates and the sights of both from %3">(
                          name(first), name(target), name(station(k))),
                      used, [=, this](const Values& values) {
                          Eigen::Vector3d v = Eigen::Vector3d::Zero();
                          for (std::size_t c = 0; c < (in_space ? 3U : 2U); ++c)
                              v[static_cast<Eigen::Index>(c)] =
                                  coordinate(values, ends[1], c) - coordinate(values, ends[0], c);
                          return between(values, p, q, in_space) - v.norm();
                      });
        }
    }

    double coordinate(const Values& values, std::size_t point, std::size_t axis) const {
        const std::size_t reading = *known(point, axis);
        return reading == none ? network_.state[static_cast<Eigen::Index>(network_.at(point, axis))]
                               : values[reading];
    }

    /// Compares distances of targets with those of the first other station that sees two of them.
    void compare_with_station(std::size_t k) {
        for (std::size_t before = 0; before < k; ++before) {
            if (station(before) == station(k)) continue;
            std::vector<std::size_t> common;
            for (const auto& [target, sight] : rounds_[k])
                if (rounds_[before].contains(target)) common.push_back(target);
            if (common.size() < 2) continue;
            for (std::size_t t = 1; t < common.size(); ++t) compare_distance(k, before, common[0], common[t]);
            return;
        }
    }

    void compare_distance(std::size_t k, std::size_t before, std::size_t a, std::size_t b) {
        const std::array<SightReadings, 4> s{rounds_[before].at(a), rounds_[before].at(b), rounds_[k].at(a),
                                             rounds_[k].at(b)};
        const bool in_space = std::ranges::all_of(s, &SightReadings::is_in_space);
        std::vector<std::size_t> used;
        for (const SightReadings& sight : s) sights_.use(sight, used);
        sums_.add(tell<"distance %1 – %2 by the sights from %3 and from %4">(
                      name(a), name(b), name(station(before)), name(station(k))),
                  used, [=, this](const Values& values) {
                      return between(values, s[2], s[3], in_space) - between(values, s[0], s[1], in_space);
                  });
    }

    ClosureSums& sums_;
    const AdjustedNetwork& network_;
    SightGeometry sights_;
    std::vector<SightsOfRound> rounds_;
    std::map<std::size_t, std::vector<std::size_t>> seen_in_;  ///< rounds in which each target is sighted
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> stated_;
};

}  // namespace

void compare_double_targets(ClosureSums& sums) {
    constexpr std::size_t most_compared = 5000;
    if (sums.network.readings.size() <= most_compared) DoubleTargets(sums).compare();
}

}  // namespace covaria::network
