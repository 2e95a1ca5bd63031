#include "core/readers/gsi_network.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/in_quotes.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

constexpr double earth = 6371e3;  ///< radius, m
/// Figures of an instrument of which the file says nothing: 1 mgon, 2 mm and 2 ppm.
constexpr double usual_angle = 1e-3 * std::numbers::pi / 200.0, usual_distance = 2e-3, usual_ppm = 2e-6;
/// Standard deviations from which on readings are no repetitions, rad and m; and the difference up to which a
/// lone direction belongs to the round before.
constexpr double most_angle = 1e-3, most_distance = 0.1;
/// Figures below which a repetition says no more than how many digits the file has, rad and m.
constexpr double least_angle = 5e-7, least_distance = 5e-5;

struct PooledSquares {
    double sum = 0.0;
    int degrees_of_freedom = 0;
    void add(const PooledFigure& figure, double factor) {
        sum += figure.degrees_of_freedom * std::pow(factor * figure.s, 2);
        degrees_of_freedom += figure.degrees_of_freedom;
    }
    double s() const { return degrees_of_freedom > 0 ? std::sqrt(sum / degrees_of_freedom) : 0.0; }
    /// The figure, or the usual one where nothing was repeated.
    double or_usual(double usual, double least, double most) const {
        return degrees_of_freedom > 0 && s() < most ? std::max(s(), least) : usual;
    }
};

/// The sights in rounds: one begins where a target comes again in the same face. A round of one target whose
/// direction is as in the round before is none of its own.
std::vector<std::size_t> rounds_of_sights(const std::vector<GsiSight>& sights) {
    std::vector<std::size_t> rounds(sights.size(), 0);
    std::map<std::pair<std::string, bool>, double> seen;
    std::size_t first = 0, round = 0;
    std::map<std::pair<std::string, bool>, double> before;
    const auto join_if_alone = [&](std::size_t end) {
        if (round == 0 || end - first != 1 || !sights[first].azimuth) return;
        const auto known = before.find({sights[first].point, sights[first].is_face_two()});
        if (known == before.end() || !(std::abs(std::remainder(*sights[first].azimuth - known->second,
                                                               2.0 * std::numbers::pi)) < most_angle))
            return;
        rounds[first] = --round;
        seen = before;
    };
    for (std::size_t i = 0; i < sights.size(); ++i) {
        const std::pair key{sights[i].point, sights[i].is_face_two()};
        if (seen.contains(key)) {
            join_if_alone(i);
            before = std::move(seen);
            seen.clear();
            first = i;
            ++round;
        }
        if (sights[i].azimuth) seen[key] = *sights[i].azimuth;
        rounds[i] = round;
    }
    join_if_alone(sights.size());
    return rounds;
}

enum class GsiDatum { control, stations, all };

Message words_of_datum(GsiDatum datum) {
    if (datum == GsiDatum::control) return tell<"points with coordinates of their own are fixed">();
    if (datum == GsiDatum::stations)
        return tell<
            "coordinates of stations are what the instrument was told: they are the datum, by which "
            "readings are not pressed">();
    return tell<
        "no coordinates tell where the network is and how it is turned: it is free, all of its "
        "points are the datum">();
}

}  // namespace

/// Figures of one reading from what rounds repeat, pooled over all set-ups.
void GsiNetwork::take_figures() {
    PooledSquares direction, zenith, distance;
    for (std::size_t i = 0; i < content_.set_ups.size(); ++i) {
        const std::vector<PolarReading> readings = content_.set_ups[i].readings();
        if (readings.empty() || !ties_.is_tied(i)) continue;
        const Rounds rounds = rounds_of(readings);
        const double of_one = rounds.two_faces ? std::numbers::sqrt2 : 1.0;  // a round is a mean of two
        direction.add(rounds.azimuth, of_one);
        zenith.add(rounds.zenith, of_one);
        distance.add(rounds.distance, of_one);
    }
    figures_ = {.direction = direction.or_usual(usual_angle, least_angle, most_angle),
                .zenith = zenith.or_usual(usual_angle, least_angle, most_angle),
                .distance = distance.or_usual(usual_distance, least_distance, most_distance)};
    const bool repeats = direction.degrees_of_freedom > 0 && direction.s() < most_angle &&
                         zenith.s() < most_angle && distance.s() < most_distance;
    if (!repeats) figures_.of_distance = usual_ppm;
    const auto mgon = [](double angle) {
        return Message::number(format_short(angle * 200e3 / std::numbers::pi, 2));
    };
    if (repeats)
        proposals_.found.push_back(tell<"rounds repeat: one reading has s = %1 mgon in directions, %2 mgon "
                                        "in zenith angles, %3 mm in "
                                        "distances (nu = %4, %5, %6). What all rounds have in common is not "
                                        "in that: centring, weather, the "
                                        "instrument's own errors">(
            mgon(figures_.direction), mgon(figures_.zenith),
            Message::number(format_short(1e3 * figures_.distance, 2)), direction.degrees_of_freedom,
            zenith.degrees_of_freedom, distance.degrees_of_freedom));
    else
        proposals_.found.push_back(
            tell<"nothing is repeated, and the file does not say what the instrument is worth: 1 mgon "
                 "of an angle, 2 mm + 2 ppm of a distance are taken; type what its data sheet says">());
}

void GsiNetwork::add(const GsiSetUp& set_up, const GsiSight& sight, const char* kind, double value, double u,
                     const std::string& round) {
    NetworkReading reading{.kind = kind};
    reading.from = ties_.station(static_cast<std::size_t>(&set_up - content_.set_ups.data()));
    reading.to = sight.point;
    reading.round = round;
    reading.value = value;
    reading.u = u;
    if (has_heights_) reading.height_from = sight.instrument_height;
    if (has_heights_) reading.height_to = sight.target_height;
    reading.face_two = !round.empty() && sight.is_face_two();
    names_.insert({reading.from, reading.to});
    entry_.readings.push_back(std::move(reading));
}

void GsiNetwork::take_set_up(std::size_t number) {
    const GsiSetUp& set_up = content_.set_ups[number];
    const double gon = 200.0 / std::numbers::pi;
    const std::vector<std::size_t> rounds = rounds_of_sights(set_up.sights);
    std::set<std::pair<std::string, bool>> faces;
    for (std::size_t i = 0; i < set_up.sights.size(); ++i) {
        const GsiSight& sight = set_up.sights[i];
        if (sight.point.empty() || sight.point == ties_.station(number)) {
            proposals_.leave_out(sight.line, tell<"a sight of %1 to itself">(in_quotes(sight.point)));
            continue;
        }
        faces.insert({sight.point, sight.is_face_two()});
        has_pairs_ =
            has_pairs_ || (faces.contains({sight.point, true}) && faces.contains({sight.point, false}));
        if (sight.azimuth)
            add(set_up, sight, "direction", *sight.azimuth * gon, figures_.direction * gon,
                std::to_string(number + 1) + "." + std::to_string(rounds[i] + 1));
        if (sight.zenith) add(set_up, sight, "zenith-angle", *sight.zenith * gon, figures_.zenith * gon, "");
        if (sight.distance && *sight.distance > 0.0)
            add(set_up, sight, "slope-distance", *sight.distance,
                figures_.distance + figures_.of_distance * *sight.distance, "");
        else
            without_distance_ += sight.azimuth || sight.zenith;
    }
    if (!rounds.empty()) rounds_ += rounds.back() + 1;
}

/// Whether the coordinates of stations are such: those that were never told are all alike.
bool GsiNetwork::are_stations_told() const {
    std::map<std::array<double, 3>, std::string> at;
    for (std::size_t i = 0; i < content_.set_ups.size(); ++i)
        if (content_.set_ups[i].located && ties_.is_tied(i) &&
            at.try_emplace(content_.set_ups[i].position, ties_.station(i)).first->second != ties_.station(i))
            return false;
    return !at.empty();
}

void GsiNetwork::take_points() {
    std::map<std::string, NetworkPoint> points;
    for (const std::string& name : names_) points[name].name = name;
    for (const GsiPoint& point : content_.points)
        if (const auto found = points.find(point.name); found != points.end() && !found->second.p[0])
            for (std::size_t i = 0; i < 3; ++i) found->second.p[i] = point.p[i];
    std::size_t fixed = 0;
    for (const auto& [name, point] : ties_.control())
        if (const auto found = points.find(name); found != points.end()) {
            for (std::size_t i = 0; i < 3; ++i) found->second.p[i] = point->p[i];
            found->second.plane = found->second.height = "fixed";
            ++fixed;
        }
    const bool told = are_stations_told();
    std::size_t stations = 0;
    for (std::size_t i = 0; i < content_.set_ups.size() && told; ++i) {
        const GsiSetUp& set_up = content_.set_ups[i];
        const auto found = points.find(ties_.station(i));
        if (!set_up.located || found == points.end() || found->second.plane == "fixed") continue;
        for (std::size_t k = 0; k < 3; ++k) found->second.p[k] = set_up.position[k];
        if (fixed < 2) found->second.plane = found->second.height = "datum";
        ++stations;
    }
    const GsiDatum datum = fixed > 1              ? GsiDatum::control
                           : stations + fixed > 1 ? GsiDatum::stations
                                                  : GsiDatum::all;
    for (auto& [name, point] : points)
        if (datum == GsiDatum::all && point.plane == "unknown") point.plane = point.height = "datum";
    for (auto& [name, point] : points) entry_.points.push_back(std::move(point));
    if (told && fixed > 1 && stations > 0)
        proposals_.found.push_back(tell<"coordinates of stations are what the instrument was told: they "
                                        "are approximate ones beside %1 points with coordinates of "
                                        "their own, which are fixed">(fixed));
    proposals_.found.push_back(words_of_datum(datum));
}

void GsiNetwork::propose(const std::string& title, const std::string& source) {
    take_figures();
    has_heights_ = ties_.are_heights_of_ground();
    for (std::size_t i = 0; i < content_.set_ups.size(); ++i)
        if (ties_.is_tied(i)) take_set_up(i);
    take_points();
    entry_.clockwise = true;
    entry_.leaves_undetermined = true;
    entry_.earth_radius = earth;
    std::size_t heights = 0;
    for (const NetworkReading& r : entry_.readings) heights += r.height_from != 0.0 || r.height_to != 0.0;
    if (has_pairs_) entry_.figures = {{"", "index", "unknown"}, {"", "collimation", "unknown"}};
    proposals_.found.push_back(tell<"a network of %1 points with %2 readings from %3 set-ups in %4 rounds, "
                                    "which is adjusted: x east, "
                                    "y north; points that nothing tells are left out">(
        entry_.points.size(), entry_.readings.size(),
        std::ranges::count_if(content_.set_ups, [](const GsiSetUp& s) { return !s.sights.empty(); }),
        rounds_));
    if (has_pairs_)
        proposals_.found.push_back(
            tell<"sights in both faces: index and collimation are unknown, and follow from the readings">());
    if (!has_heights_)
        proposals_.leave_out(
            0,
            tell<"heights of instrument and targets: sights there and back close without them, and not with "
                 "them; points are where the axes and the reflectors were">());
    else if (heights == 0)
        proposals_.found.push_back(
            tell<"the file has no heights of instrument and targets: points are where the axes and the "
                 "reflectors were">());
    proposals_.found.push_back(
        tell<"the curvature of the Earth counts in zenith angles, with a refraction coefficient of %1">(
            Message::number("0.13")));
    if (without_distance_ > 0)
        proposals_.found.push_back(
            tell<"%1 sights have no distance: their angles are taken">(without_distance_));
    proposals_.analyses.push_back(
        entry_.analysis(title, "From " + source +
                                   ". Uncertainties: see what the import said; what several "
                                   "rounds see is a lower bound."));
}

}  // namespace covaria
