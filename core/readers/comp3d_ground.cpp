#include "core/readers/comp3d_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace covaria {

Comp3dGround::Comp3dGround(const Comp3dSurvey& survey, const Comp3dPoints& points,
                           const Comp3dSettings& settings)
    : points_(points),
      settings_(settings),
      site_(Comp3dSite::radius_at(settings.latitude * std::numbers::pi / 180.0), settings.centre) {
    for (const Comp3dObservation& o : survey.observations)
        if (o.code >= 1 && o.code <= 3 && o.value > 0.0)
            read_distances_.try_emplace(std::minmax(o.from, o.to), o.value);
    find_heights(survey);
}

const Comp3dPoint* Comp3dGround::placed(const std::string& name) const {
    const auto found = points_.find(name);
    return found == points_.end() || found->second->code.is_ignored() ? nullptr : found->second;
}

/// The distance that standard deviations depend on: that of the coordinates, or as it was read.
std::optional<double> Comp3dGround::distance_of(const std::string& from, const std::string& to) const {
    const Comp3dPoint *a = placed(from), *b = placed(to);
    if (a && b) return std::hypot(b->p[0] - a->p[0], b->p[1] - a->p[1], b->p[2] - a->p[2]);
    const auto read = read_distances_.find(std::minmax(from, to));
    return read == read_distances_.end() ? std::nullopt : std::optional(read->second);
}

/// Heights of points that have no coordinates: by zenith angles with distances and by height differences,
/// from point to point.
void Comp3dGround::find_heights(const Comp3dSurvey& survey) {
    struct Rise {
        std::optional<double> zenith, distance, by = {};
        double heights = 0.0;  // of the instrument less that of the target
    };
    std::map<std::pair<std::string, std::string>, Rise> rises;
    for (const Comp3dObservation& o : survey.observations) {
        Rise& rise = rises[{o.from, o.to}];
        if (o.code == 6) rise.zenith = settings_.angle_unit.to_si(o.value);
        if (o.code == 6) rise.heights = o.height_from - o.height_to;
        if (o.code == 1 || o.code == 3) rise.distance = o.value;
        if (o.code == 4) rise.by = o.value + o.height_from - o.height_to;
        if (rise.zenith && rise.distance) rise.by = *rise.distance * std::cos(*rise.zenith) + rise.heights;
    }
    for (const auto& [name, point] : points_)
        if (!point->code.is_ignored()) heights_[name] = point->p[2];
    constexpr int most_passes = 100;
    bool more = true;
    for (int pass = 0; more && pass < most_passes; ++pass) {
        more = false;
        for (const auto& [ends, rise] : rises) {
            if (!rise.by) continue;
            const auto from = heights_.find(ends.first), to = heights_.find(ends.second);
            if ((from == heights_.end()) == (to == heights_.end())) continue;
            if (to == heights_.end())
                heights_[ends.second] = from->second + *rise.by;
            else
                heights_[ends.first] = to->second - *rise.by;
            more = true;
        }
    }
}

/// The ends of a reading. Of one without coordinates its height tells nearly all, whatever its azimuth is.
std::optional<Comp3dSite::Sight> Comp3dGround::sight_of(const NetworkReading& reading) const {
    const Comp3dPoint *a = placed(reading.from), *b = placed(reading.to);
    Comp3dSite::Sight sight{.from = Eigen::Vector3d(settings_.centre.x(), settings_.centre.y(), 0.0),
                            .to = Eigen::Vector3d::Zero(),
                            .height_from = reading.height_from,
                            .height_to = reading.height_to};
    if (a) sight.from = Eigen::Vector3d(a->p.data());
    if (b) sight.to = Eigen::Vector3d(b->p.data());
    if (a && b) return sight;
    const auto from = heights_.find(reading.from), to = heights_.find(reading.to);
    const auto distance = distance_of(reading.from, reading.to);
    if (!distance || (from == heights_.end() && to == heights_.end())) return std::nullopt;
    const double low = from == heights_.end() ? to->second : from->second,
                 high = to == heights_.end() ? low : to->second,
                 rise = high + reading.height_to - low - reading.height_from,
                 across = std::sqrt(std::max(0.0, *distance * *distance - rise * rise)) /
                          (1.0 + low / site_.radius());
    if (b)
        sight.from = sight.to - Eigen::Vector3d(across, 0.0, 0.0);
    else
        sight.to = sight.from + Eigen::Vector3d(across, 0.0, 0.0);
    sight.from.z() = low;
    sight.to.z() = high;
    return sight;
}

}  // namespace covaria
