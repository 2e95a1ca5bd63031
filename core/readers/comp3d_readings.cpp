#include "core/readers/comp3d_readings.h"

#include <cmath>

namespace covaria {

namespace {

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

void Comp3dReadings::take_all() {
    for (const Comp3dObservation& o : survey_.observations) take(o);
    for (const Comp3dEquality& equality : survey_.equalities) take(equality);
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
                                                                          : ground_.distance_of(o.from, o.to);
    if (!distance || !(*distance > 0.0))
        files_.leave_out(
            o.at,
            tell<"%1 – %2: the part of its standard deviation that depends on the distance">(o.from, o.to));
    else if (reading.is_of_angle())
        reading.u += settings_.angle_unit.from_si(std::abs(o.sigma_relative) / *distance);
    else
        reading.u += std::abs(o.sigma_relative) * *distance;
    const double change = readings_.change_of(reading);
    readings_.add(std::move(reading), o.at, change);
}

/// A centring is two readings of 0; where its second standard deviation is 0 it is the first.
void Comp3dReadings::take_centring(const Comp3dObservation& o) {
    for (const bool is_y : {false, true}) {
        const double sigma = is_y && o.sigma_relative != 0.0 ? o.sigma_relative : o.sigma;
        NetworkReading reading{.kind = is_y ? "dy" : "dx", .from = o.from, .to = o.to};
        reading.u = std::abs(sigma);
        reading.is_used = o.is_used && sigma >= 0.0;
        readings_.add(std::move(reading), o.at);
    }
}

/// Distances whose common length nobody knows are read by an instrument whose zero nobody knows.
void Comp3dReadings::take(const Comp3dEquality& equality) {
    if (equality.pairs.empty()) return;
    const auto& first = equality.pairs.front();
    const double length = ground_.distance_of(first.from, first.to).value_or(1.0);
    const std::string instrument =
        equality.name + " " + std::to_string(1 + (&equality - survey_.equalities.data()));
    bool any = false;
    for (const Comp3dEquality::Pair& pair : equality.pairs) {
        NetworkReading reading{
            .kind = "slope-distance", .from = pair.from, .to = pair.to, .instrument = instrument};
        reading.value = length;
        reading.u = std::abs(pair.sigma);
        reading.is_used = pair.sigma >= 0.0;
        const double change = readings_.change_of(reading);
        const bool is_used = reading.is_used;
        const std::size_t before = entry_.readings.size();
        readings_.add(std::move(reading), pair.at, change);
        any = any || (is_used && entry_.readings.size() > before);
    }
    if (any) entry_.figures.push_back({instrument, "zero", "unknown"});
}

}  // namespace covaria
