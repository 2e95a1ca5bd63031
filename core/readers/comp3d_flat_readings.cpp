#include "core/readers/comp3d_flat_readings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/in_quotes.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

/// The share of its u below which a reading is not worth a reduction.
constexpr double worth_of_u = 1e-4;

}  // namespace

std::optional<Message> Comp3dFlatReadings::objection(const NetworkReading& reading) const {
    const Message what = reading.to.empty() ? Message(reading.kind + " " + reading.from)
                                            : Message(reading.kind + " " + reading.from + " – " + reading.to);
    for (const std::string& name : {reading.from, reading.to}) {
        const auto found = ground_.points().find(name);
        if (found == ground_.points().end()) continue;
        const Comp3dCode code = found->second->code;
        if (code.is_ignored())
            return tell<"%1: the file says that %2 is not to be used">(what, in_quotes(name));
        if ((reading.needs_plane() && !code.has(0)) || (reading.needs_height() && !code.has(2)))
            return tell<"%1: %2 has no such coordinate, as its code says">(what, in_quotes(name));
    }
    if (!(reading.u > 0.0) || !std::isfinite(reading.u))
        return tell<"%1: it has no standard deviation">(what);
    if ((reading.kind == "slope-distance" || reading.kind == "horizontal-distance") && !(reading.value > 0.0))
        return tell<"%1: it is not positive">(what);
    return std::nullopt;
}

void Comp3dFlatReadings::add(NetworkReading reading, const Comp3dPlace& at, double change) {
    if (const auto refused = objection(reading)) return files_.leave_out(at, *refused);
    reduce_by(reading, change);
    off_ += !reading.is_used;
    entry_.readings.push_back(std::move(reading));
}

double Comp3dFlatReadings::change_of(const NetworkReading& reading) const {
    const auto sight = ground_.sight_of(reading);
    // Instruments of own frames have no refraction.
    const double refraction = reading.instrument.empty() ? settings_.refraction : 0.0;
    return sight ? -ground_.site().larger(reading.kind, *sight, refraction) : 0.0;
}

/// Adds a change, m or rad, that is worth it.
void Comp3dFlatReadings::reduce_by(NetworkReading& reading, double change) {
    const bool angle = reading.is_of_angle();
    const double u = angle ? settings_.angle_unit.to_si(reading.u) : reading.u;
    if (!std::isfinite(change) || !(std::abs(change) > worth_of_u * u)) return;
    reading.value += angle ? settings_.angle_unit.from_si(change) : change;
    Reduced& of = angle ? angles_ : lengths_;
    ++of.count;
    of.most = std::max(of.most, std::abs(change));
}

void Comp3dFlatReadings::say_what_was_done(Proposals& proposals) {
    const auto shown = [](double value) { return Message::number(format_significant(value, 2)); };
    if (lengths_.count + angles_.count > 0)
        proposals.found.push_back(
            tell<"readings are reduced to the plane of the coordinates, from a sphere of %1 km on which "
                 "heights stand: %2 lengths by up to %3 mm, %4 angles by up to %5 mgon">(
                Message::number(format_short(1e-3 * ground_.site().radius(), 7)), lengths_.count,
                shown(1e3 * lengths_.most), angles_.count, shown(angles_.most * 200e3 / std::numbers::pi)));
    if (off_ > 0)
        proposals.found.push_back(
            tell<"%1 readings are switched off in the file: they are in the table as left out">(off_));
    if (std::ranges::any_of(entry_.readings,
                            [](const NetworkReading& r) { return r.kind == "zenith-angle"; })) {
        entry_.earth_radius = ground_.site().radius();
        entry_.refraction = settings_.refraction;
        proposals.found.push_back(
            tell<"the curvature of the Earth counts in zenith angles, with a refraction coefficient of %1">(
                Message::number(format_short(settings_.refraction, 4))));
    }
}

}  // namespace covaria
