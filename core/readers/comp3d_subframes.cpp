#include "core/readers/comp3d_subframes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/registration.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

constexpr double exact_reading = 1e-7;  ///< u of what the file takes as exact and a network as a reading, m
constexpr double level_tilt = 1e-8;     ///< u of the tilt of a frame that is level, rad

}  // namespace

void Comp3dSubframes::take_all(Proposals& proposals) {
    for (const Comp3dSubframe& subframe : survey_.subframes) take(subframe);
    if (bent_ > 0.0)
        proposals.found.push_back(
            tell<"own frames whose targets have no coordinates are taken as they are: the curvature of the "
                 "Earth and heights change them by up to %1 mm">(
                Message::number(format_significant(1e3 * bent_, 2))));
}

/// A network has one instrument at a point, levelled or not.
bool Comp3dSubframes::is_levelled_at(const Comp3dSubframe& subframe) const {
    const auto here = [&](const Comp3dSubframe& other) {
        return &other != &subframe && other.is_polar && other.origin == subframe.origin;
    };
    return std::ranges::any_of(survey_.subframes, here) ||
           std::ranges::any_of(survey_.observations, [&](const Comp3dObservation& o) {
               return o.from == subframe.origin && o.code != 4 && o.code != 9 && o.code < 14;
           });
}

void Comp3dSubframes::take(const Comp3dSubframe& subframe) {
    const std::string name =
        subframe.origin + " " + std::to_string(1 + (&subframe - survey_.subframes.data()));
    if (!subframe.is_polar) return take_coordinates(subframe, name);
    if (!subframe.is_level && is_levelled_at(subframe))
        return files_.leave_out(
            subframe.at, tell<"%1: an instrument that leans at a point with other readings">(subframe.name));
    take_polar(subframe, name);
}

std::optional<Comp3dSite::Sight> Comp3dSubframes::sight_of(const Comp3dSubframe& subframe,
                                                           const Comp3dSighting& sighting) const {
    const Comp3dPoint *a = ground_.placed(subframe.origin), *b = ground_.placed(sighting.target);
    if (!a || !b) return std::nullopt;
    return Comp3dSite::Sight{.from = Eigen::Vector3d(a->p.data()),
                             .to = Eigen::Vector3d(b->p.data()),
                             .height_to = sighting.height};
}

/// A sighting as a vector in its frame. Polar angles count from x towards y, and from there upwards; what was
/// sighted without a distance is as far as its coordinates say.
Eigen::Vector3d Comp3dSubframes::vector_of(const Comp3dSubframe& subframe,
                                           const Comp3dSighting& sighting) const {
    if (!subframe.is_polar) return Eigen::Vector3d(sighting.value.data());
    const double a = settings_.angle_unit.to_si(sighting.value[0]),
                 b = settings_.angle_unit.to_si(sighting.value[1]);
    const double distance = sighting.value[2] > 0.0
                                ? sighting.value[2]
                                : ground_.distance_of(subframe.origin, sighting.target).value_or(1.0);
    return distance * Eigen::Vector3d(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
}

/// The turn from east, north, up at the origin to the axes of the frame, by targets that have coordinates.
Comp3dSubframes::Turn Comp3dSubframes::turn_of(const Comp3dSubframe& subframe) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero(), turn = Eigen::Matrix3d::Identity();
    std::size_t targets = 0;
    for (const Comp3dSighting& s : subframe.sightings)
        if (const auto sight = sight_of(subframe, s)) {
            sum += vector_of(subframe, s).normalized() * ground_.site().seen(*sight).normalized().transpose();
            ++targets;
        }
    return targets > 1 && sum.allFinite() && registration<double>(sum, turn) ? std::optional(turn)
                                                                             : std::nullopt;
}

Eigen::Vector3d Comp3dSubframes::flat_vector_of(const Comp3dSubframe& subframe,
                                                const Comp3dSighting& sighting, const Turn& turn,
                                                bool is_curved) {
    const Eigen::Vector3d v = vector_of(subframe, sighting);
    const Comp3dPoint* origin = ground_.placed(subframe.origin);
    if (subframe.is_level && !subframe.is_polar)
        return ground_.site().flat_of_level(v, origin ? origin->p[2] : 0.0) -
               sighting.height * Eigen::Vector3d::UnitZ();
    const auto sight = sight_of(subframe, sighting);
    if (!turn || !sight) {
        const double height = origin ? std::abs(origin->p[2]) : 0.0;
        bent_ = std::max(bent_, (0.5 * v.norm() + height) * v.norm() / ground_.site().radius());
        return v;
    }
    // The network has heights of targets in readings, but not in coordinates of a frame.
    Comp3dSite::Sight at_point = *sight;
    if (!subframe.is_polar) at_point.height_to = 0.0;
    const Eigen::Vector3d there =
        is_curved ? ground_.site().curved(at_point, 0.0) : Comp3dSite::flat(at_point);
    return v + *turn * (there - ground_.site().seen(*sight));
}

/// Coordinates in a frame that begins at its origin.
void Comp3dSubframes::take_coordinates(const Comp3dSubframe& subframe, const std::string& frame) {
    const char* const kinds[] = {"frame-x", "frame-y", "frame-z"};
    entry_.frames.push_back(
        {.name = frame, .u_of_tilt = subframe.is_level ? std::optional(level_tilt) : std::nullopt});
    for (const char* kind : kinds) {
        NetworkReading begins{.kind = kind, .from = subframe.origin, .frame = frame, .u = exact_reading};
        readings_.add(std::move(begins), subframe.at);
    }
    const auto turn = turn_of(subframe);
    for (const Comp3dSighting& s : subframe.sightings) {
        if (s.height != 0.0 && !subframe.is_level && !turn) {
            files_.leave_out(s.at, tell<"%1: a target above its point in a frame that leans">(s.target));
            continue;
        }
        const Eigen::Vector3d flat = flat_vector_of(subframe, s, turn, false);
        const double distance = std::hypot(s.value[0], s.value[1], s.value[2]);
        for (std::size_t i = 0; i < 3; ++i) {
            NetworkReading reading{.kind = kinds[i], .from = s.target, .frame = frame, .value = s.value[i]};
            reading.u = std::abs(s.sigma[i]) + std::abs(s.sigma_relative[i]) * distance;
            reading.is_used = s.sigma[i] >= 0.0;
            readings_.add(std::move(reading), s.at, flat[static_cast<Eigen::Index>(i)] - s.value[i]);
        }
    }
}

/// Two angles and a distance. A level instrument has readings like any other, but without refraction.
void Comp3dSubframes::take_polar(const Comp3dSubframe& subframe, const std::string& instrument) {
    const auto angle = [&](double si) { return settings_.angle_unit.from_si(si); };
    if (!subframe.is_level) entry_.leaning.push_back(subframe.origin);
    const auto turn = subframe.is_level ? std::nullopt : turn_of(subframe);
    bool is_bent = false;
    for (const Comp3dSighting& s : subframe.sightings) {
        const Eigen::Vector3d read = vector_of(subframe, s),
                              flat = subframe.is_level ? read : flat_vector_of(subframe, s, turn, false),
                              bent = subframe.is_level ? read : flat_vector_of(subframe, s, turn, true);
        const double d = read.norm(), two_pi = 2.0 * std::numbers::pi;
        const std::array<double, 3> change{
            -std::remainder(std::atan2(flat.y(), flat.x()) - std::atan2(read.y(), read.x()), two_pi),
            std::atan2(bent.head<2>().norm(), bent.z()) - std::atan2(read.head<2>().norm(), read.z()),
            flat.norm() - d};
        const std::array<const char*, 3> kinds{"direction", "zenith-angle", "slope-distance"};
        for (std::size_t i = 0; i < 3; ++i) {
            if (i == 2 && !(s.value[2] > 0.0)) continue;  // angles alone, of photographs
            NetworkReading reading{
                .kind = kinds[i], .from = subframe.origin, .to = s.target, .instrument = instrument};
            reading.value = i == 0   ? -s.value[0]
                            : i == 1 ? angle(0.5 * std::numbers::pi) - s.value[1]
                                     : s.value[2];
            if (i == 0) reading.round = instrument;
            reading.height_to = s.height;
            reading.u = std::abs(s.sigma[i]) + (i == 2 ? std::abs(s.sigma_relative[i]) * d
                                                       : angle(std::abs(s.sigma_relative[i]) / d));
            reading.is_used = s.sigma[i] >= 0.0;
            is_bent = is_bent || (i == 1 && reading.is_used);
            const double by = subframe.is_level ? readings_.change_of(reading) : change[i];
            readings_.add(std::move(reading), s.at, by);
        }
    }
    if (is_bent) entry_.figures.push_back({instrument, "refraction", "fixed"});
}

}  // namespace covaria
