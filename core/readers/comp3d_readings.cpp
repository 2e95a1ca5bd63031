#include "core/readers/comp3d_readings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/in_quotes.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

/// Standard uncertainty of what the file takes as exact and a network takes as a reading, m; and the share of
/// its u below which a reading is not worth a reduction.
constexpr double exact_reading = 1e-7, worth_of_u = 1e-4;
constexpr double level_tilt = 1e-8;  ///< u of the tilt of a frame that is level, rad

const char* comp3d_kind_of(int code) {
    switch (code) {
        case 1:
        case 3:
            return "slope-distance";
        case 2:
            return "horizontal-distance";
        case 4:
            return "height-difference";
        case 5:
        case 7:
            return "direction";
        case 6:
            return "zenith-angle";
        case 8:
            return "azimuth";
        case 14:
            return "dx";
        default:
            return "dy";
    }
}

bool is_read_distance(const std::string& kind) {
    return kind == "slope-distance" || kind == "horizontal-distance";
}

}  // namespace

Comp3dReadings::Comp3dReadings(const Comp3dSurvey& survey, const Comp3dPoints& points,
                               const Comp3dSettings& settings, Comp3dSurveyReader& files,
                               Proposals& proposals, NetworkEntry& entry)
    : survey_(survey),
      points_(points),
      settings_(settings),
      files_(files),
      proposals_(proposals),
      entry_(entry),
      site_(Comp3dSite::radius_at(settings.latitude * std::numbers::pi / 180.0), settings.centre) {}

void Comp3dReadings::take_all() {
    for (const Comp3dObservation& o : survey_.observations)
        if (is_read_distance(comp3d_kind_of(o.code)) && o.value > 0.0)
            read_distances_.try_emplace(std::minmax(o.from, o.to), o.value);
    for (const Comp3dObservation& o : survey_.observations) take(o);
    for (const Comp3dSubframe& subframe : survey_.subframes) take(subframe);
    tell_of_all();
}

const Comp3dPoint* Comp3dReadings::placed(const std::string& name) const {
    const auto found = points_.find(name);
    return found == points_.end() || found->second->code.is_ignored() ? nullptr : found->second;
}

/// The distance that standard deviations depend on: that of the coordinates, or as it was read.
std::optional<double> Comp3dReadings::distance_of(const std::string& from, const std::string& to) const {
    const Comp3dPoint *a = placed(from), *b = placed(to);
    if (a && b) return std::hypot(b->p[0] - a->p[0], b->p[1] - a->p[1], b->p[2] - a->p[2]);
    const auto read = read_distances_.find(std::minmax(from, to));
    return read == read_distances_.end() ? std::nullopt : std::optional(read->second);
}

/// The round of a direction. Code 7 begins one, as does the first direction of a station.
std::string Comp3dReadings::round_of(const Comp3dObservation& o) {
    int& rounds = rounds_[o.from];
    if (o.code == 7 || rounds == 0) ++rounds;
    return std::to_string(rounds);
}

void Comp3dReadings::take(const Comp3dObservation& o) {
    if (o.code == 9) return take_centring(o);
    NetworkReading reading{.kind = comp3d_kind_of(o.code), .from = o.from, .to = o.to};
    if (reading.kind == "direction") reading.round = round_of(o);
    reading.value = o.value;
    reading.height_from = o.height_from;
    reading.height_to = o.height_to;
    reading.is_used = o.is_used && o.sigma >= 0.0;
    reading.u = std::abs(o.sigma);
    const auto distance = is_read_distance(reading.kind) && o.value > 0.0 ? std::optional(o.value)
                          : o.sigma_relative == 0.0                       ? std::optional(1.0)
                                                                          : distance_of(o.from, o.to);
    if (!distance || !(*distance > 0.0))
        files_.leave_out(
            o.at,
            tell<"%1 – %2: the part of its standard deviation that depends on the distance">(o.from, o.to));
    else if (reading.is_of_angle())
        reading.u += settings_.angle_unit.from_si(std::abs(o.sigma_relative) / *distance);
    else
        reading.u += std::abs(o.sigma_relative) * *distance;
    add(std::move(reading), o.at, true);
}

/// A centring is two readings of 0; where its second standard deviation is 0 it is the first.
void Comp3dReadings::take_centring(const Comp3dObservation& o) {
    for (const bool is_y : {false, true}) {
        const double sigma = is_y && o.sigma_relative != 0.0 ? o.sigma_relative : o.sigma;
        NetworkReading reading{.kind = is_y ? "dy" : "dx", .from = o.from, .to = o.to};
        reading.u = std::abs(sigma);
        reading.is_used = o.is_used && sigma >= 0.0;
        add(std::move(reading), o.at, false);
    }
}

/// A network has one instrument at a point, levelled or not.
bool Comp3dReadings::is_levelled_at(const Comp3dSubframe& subframe) const {
    const auto here = [&](const Comp3dSubframe& other) {
        return &other != &subframe && other.is_polar && other.origin == subframe.origin;
    };
    return std::ranges::any_of(survey_.subframes, here) ||
           std::ranges::any_of(survey_.observations, [&](const Comp3dObservation& o) {
               return o.from == subframe.origin && o.code != 4 && o.code != 9 && o.code < 14;
           });
}

void Comp3dReadings::take(const Comp3dSubframe& subframe) {
    const std::string name =
        subframe.origin + " " + std::to_string(1 + (&subframe - survey_.subframes.data()));
    if (!subframe.is_polar) return take_coordinates(subframe, name);
    if (!subframe.is_level && is_levelled_at(subframe))
        return files_.leave_out(
            subframe.at, tell<"%1: an instrument that leans at a point with other readings">(subframe.name));
    take_polar(subframe, name);
}

/// Coordinates in a frame that begins at its origin. What heights do to its scale, and in a level frame the
/// curvature of the Earth, is taken off.
void Comp3dReadings::take_coordinates(const Comp3dSubframe& subframe, const std::string& frame) {
    const char* const kinds[] = {"frame-x", "frame-y", "frame-z"};
    const Comp3dPoint* origin = placed(subframe.origin);
    NetworkFrame known{.name = frame, .scale_beyond_one = (origin ? origin->p[2] : 0.0) / site_.radius()};
    if (subframe.is_level) known.u_of_tilt = level_tilt;
    entry_.frames.push_back(known);
    for (const char* kind : kinds) {
        NetworkReading begins{.kind = kind, .from = subframe.origin, .frame = frame, .u = exact_reading};
        add(std::move(begins), subframe.at, false);
    }
    for (const Comp3dSighting& s : subframe.sightings) {
        const double distance = std::hypot(s.value[0], s.value[1], s.value[2]),
                     fall = 0.5 * (s.value[0] * s.value[0] + s.value[1] * s.value[1]) / site_.radius();
        if (s.height != 0.0 && !subframe.is_level) {
            files_.leave_out(s.at, tell<"%1: a target above its point in a frame that leans">(s.target));
            continue;
        }
        if (!subframe.is_level) bent_ = std::max(bent_, 0.5 * distance * distance / site_.radius());
        for (std::size_t i = 0; i < 3; ++i) {
            NetworkReading reading{.kind = kinds[i], .from = s.target, .frame = frame, .value = s.value[i]};
            reading.u = std::abs(s.sigma[i]) + std::abs(s.sigma_relative[i]) * distance;
            reading.is_used = s.sigma[i] >= 0.0;
            if (i == 2 && subframe.is_level) reading.value += fall - s.height;
            add(std::move(reading), s.at, false);
        }
    }
}

/// Two angles and a distance; the angles count from x towards y, and from there upwards.
void Comp3dReadings::take_polar(const Comp3dSubframe& subframe, const std::string& instrument) {
    const double quarter = settings_.angle_unit.from_si(0.5 * std::numbers::pi);
    if (!subframe.is_level) entry_.leaning.push_back(subframe.origin);
    bool is_bent = false;
    for (const Comp3dSighting& s : subframe.sightings) {
        const auto known =
            s.value[2] > 0.0 ? std::optional(s.value[2]) : distance_of(subframe.origin, s.target);
        for (std::size_t i = 0; i < 3; ++i) {
            if (i == 2 && !(s.value[2] > 0.0)) continue;  // angles alone, of photographs
            NetworkReading reading{.kind = i == 0   ? "direction"
                                           : i == 1 ? "zenith-angle"
                                                    : "slope-distance",
                                   .from = subframe.origin,
                                   .to = s.target,
                                   .instrument = instrument};
            reading.value = i == 0 ? -s.value[0] : i == 1 ? quarter - s.value[1] : s.value[2];
            if (i == 0) reading.round = instrument;
            reading.height_to = s.height;
            reading.u = std::abs(s.sigma[i]);
            if (i == 2)
                reading.u += std::abs(s.sigma_relative[i]) * s.value[2];
            else if (known && *known > 0.0)
                reading.u += settings_.angle_unit.from_si(std::abs(s.sigma_relative[i]) / *known);
            reading.is_used = s.sigma[i] >= 0.0;
            is_bent = is_bent || (i == 1 && reading.is_used);
            add(std::move(reading), s.at, subframe.is_level || i == 2);
        }
    }
    if (is_bent) entry_.unbent.push_back(instrument);
}

std::optional<Message> Comp3dReadings::objection(const NetworkReading& reading) const {
    const Message what = reading.to.empty() ? Message(reading.kind + " " + reading.from)
                                            : Message(reading.kind + " " + reading.from + " – " + reading.to);
    for (const std::string& name : {reading.from, reading.to}) {
        const auto found = points_.find(name);
        if (found == points_.end()) continue;
        const Comp3dCode code = found->second->code;
        if (code.is_ignored())
            return tell<"%1: the file says that %2 is not to be used">(what, in_quotes(name));
        if ((reading.needs_plane() && !code.has(0)) || (reading.needs_height() && !code.has(2)))
            return tell<"%1: %2 has no such coordinate, as its code says">(what, in_quotes(name));
    }
    if (!(reading.u > 0.0) || !std::isfinite(reading.u))
        return tell<"%1: it has no standard deviation">(what);
    if (is_read_distance(reading.kind) && !(reading.value > 0.0)) return tell<"%1: it is not positive">(what);
    return std::nullopt;
}

void Comp3dReadings::add(NetworkReading reading, const Comp3dPlace& at, bool is_reduced) {
    if (const auto refused = objection(reading)) return files_.leave_out(at, *refused);
    if (is_reduced) reduce(reading);
    off_ += !reading.is_used;
    entry_.readings.push_back(std::move(reading));
}

void Comp3dReadings::reduce(NetworkReading& reading) {
    const Comp3dPoint *a = placed(reading.from), *b = placed(reading.to);
    if (!a && !b) return;
    Comp3dSite::Sight sight{.from = Eigen::Vector3d(a ? a->p.data() : b->p.data()),
                            .to = Eigen::Vector3d(b ? b->p.data() : a->p.data()),
                            .height_from = reading.height_from,
                            .height_to = reading.height_to};
    if (!a || !b) {
        // Where one end has no coordinates yet, the height of the other tells nearly all of it.
        const auto distance = distance_of(reading.from, reading.to);
        if (!distance) return;
        (a ? sight.to : sight.from).x() += *distance;
    }
    const bool angle = reading.is_of_angle();
    const double larger = site_.larger(reading.kind, sight),
                 u = angle ? settings_.angle_unit.to_si(reading.u) : reading.u;
    if (!std::isfinite(larger) || !(std::abs(larger) > worth_of_u * u)) return;
    reading.value -= angle ? settings_.angle_unit.from_si(larger) : larger;
    Reduced& of = angle ? angles_ : lengths_;
    ++of.count;
    of.most = std::max(of.most, std::abs(larger));
}

void Comp3dReadings::tell_of_all() {
    const auto shown = [](double value) { return Message::number(format_significant(value, 2)); };
    if (lengths_.count + angles_.count > 0)
        proposals_.found.push_back(
            tell<"readings are reduced to the plane of the coordinates, from a sphere of %1 km on which "
                 "heights stand: %2 lengths by up to %3 mm, %4 angles by up to %5 mgon">(
                Message::number(format_short(1e-3 * site_.radius(), 7)), lengths_.count,
                shown(1e3 * lengths_.most), angles_.count, shown(angles_.most * 200e3 / std::numbers::pi)));
    if (bent_ > 0.0)
        proposals_.found.push_back(
            tell<"own frames that lean are taken as flat: the curvature of the Earth is up to %1 mm in "
                 "them">(shown(1e3 * bent_)));
    if (off_ > 0)
        proposals_.found.push_back(
            tell<"%1 readings are switched off in the file: they are in the table as left out">(off_));
    if (std::ranges::any_of(entry_.readings,
                            [](const NetworkReading& r) { return r.kind == "zenith-angle"; })) {
        entry_.earth_radius = site_.radius();
        entry_.refraction = settings_.refraction;
        proposals_.found.push_back(
            tell<"the curvature of the Earth counts in zenith angles, with a refraction coefficient of %1">(
                Message::number(format_short(settings_.refraction, 4))));
    }
}

}  // namespace covaria
