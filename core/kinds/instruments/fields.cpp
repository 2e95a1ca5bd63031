#include "core/kinds/instruments/fields.h"

#include <numbers>

#include "core/kinds/points/stated_figure.h"

namespace covaria {

namespace {

const std::vector<std::string> with_distance{"total-station", "tracker", "scanner", "distance-meter",
                                             "generic"};
const std::vector<std::string> with_angles{"total-station", "tracker", "scanner", "camera", "generic"};

FieldSpec figure(const char* key, const char* title, const char* unit, const char* help,
                 const char* section) {
    return {.key = key,
            .title = title,
            .help = help,
            .unit = Unit::of(unit),
            .range = {.low = 0.0},
            .default_value = Quantity{0.0, Unit::of(unit)},
            .section = section};
}

FieldSpec figure(const char* key, const char* title, const char* unit, const char* help, const char* section,
                 const std::vector<std::string>& kinds) {
    FieldSpec field = figure(key, title, unit, help, section);
    field.shown_if = Condition{"kind", kinds};
    return field;
}

FieldSpec generic_flag(const char* key, const char* title, const char* help) {
    return {.key = key,
            .title = title,
            .kind = FieldKind::flag,
            .help = help,
            .default_value = true,
            .shown_if = Condition{"kind", {"generic"}},
            .section = "Station"};
}

std::vector<FieldSpec> station_fields() {
    return {
        {.key = "station",
         .title = "Station",
         .kind = FieldKind::pose,
         .help = "Where the instrument stands in the world frame: the point where its axes meet. x is the "
                 "zero of the azimuth (the optical axis of a camera), z the vertical axis.",
         .default_value = PoseValue{},
         .section = "Station"},
        {.key = "station_angles",
         .title = "The angles are",
         .kind = FieldKind::choice,
         .help = "How the three angles of the station turn its axes.",
         .default_value = std::string("zyx"),
         .choices = {{"zyx", "α, β, γ: R = Rz(γ) Ry(β) Rx(α)"},
                     {"xyz", "ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric"}},
         .section = "Station"},
        {.key = "kind",
         .title = "Instrument",
         .kind = FieldKind::choice,
         .help = "What the instrument reads, and how it is drawn.",
         .default_value = std::string("total-station"),
         .choices = {{"total-station", "total station: distance and two angles"},
                     {"tracker", "laser tracker: distance and two angles"},
                     {"scanner", "laser scanner: distance and two angles"},
                     {"camera", "camera: two angles"},
                     {"distance-meter", "distance meter: distance only"},
                     {"generic", "other: chosen readings"}},
         .section = "Station"},
        generic_flag("reads_distance", "Reads the distance", "Whether the sensor reads a distance."),
        generic_flag("reads_azimuth", "Reads the azimuth", "Whether the sensor reads a horizontal angle."),
        generic_flag("reads_elevation", "Reads the elevation", "Whether the sensor reads a vertical angle.")};
}

std::vector<FieldSpec> specification_fields() {
    const char* section = "Specification";
    return {
        figure("distance_constant", "Distance: constant part a", "mm",
               "Part of the distance's figure that does not depend on the distance.", section, with_distance),
        figure("distance_scale", "Distance: part b per length", "ppm",
               "Part of the distance's figure in proportion to the distance.", section, with_distance),
        figure("angle_azimuth", "Azimuth", "arcsec", "Figure for the horizontal angle.", section,
               with_angles),
        figure("angle_elevation", "Elevation", "arcsec", "Figure for the vertical angle.", section,
               with_angles),
        figure("across_constant", "Angles: constant part across", "mm",
               "Part of both angles' figures that is a length across the line of sight, as trackers state it "
               "(15 µm + 6 µm/m); an angle's figure is this over the distance plus its own.",
               section, with_angles),
        meaning_field(section)};
}

/// Range and field of view: blank where there is no limit.
std::vector<FieldSpec> view_fields() {
    const char* section = "Range and field of view";
    const auto limit = [&](const char* key, const char* title, const char* unit, double high,
                           const char* help) {
        return FieldSpec{.key = key,
                         .title = title,
                         .help = help,
                         .unit = Unit::of(unit),
                         .range = {.low = 0.0, .high = high, .low_open = true},
                         .optional = true,
                         .section = section};
    };
    constexpr double turn = 2.0 * std::numbers::pi;
    return {figure("view_nearest", "Shortest distance", "m", "Targets nearer than this are not measured.",
                   section),
            limit("view_farthest", "Longest distance", "m", Range::infinity_value,
                  "Targets farther than this are not measured; empty: no limit."),
            limit("view_azimuth", "Horizontal field of view", "deg", turn,
                  "Full angle, half of it to either side of the sensor's x-axis; empty: all round."),
            limit("view_elevation", "Vertical field of view", "deg", 0.5 * turn,
                  "Full angle, half of it above the sensor's xy-plane and half below; empty: no limit.")};
}

std::vector<FieldSpec> systematic_fields() {
    const char* section = "Shared by all readings";
    return {
        figure("u_scale", "Scale of distances", "ppm",
               "Standard uncertainty of the scale, which all distances share: wavelength, refractive index, "
               "temperature of a scale.",
               section, with_distance),
        figure("u_zero", "Zero offset of distances", "mm",
               "Standard uncertainty of the constant offset of all distances: home position, reflector.",
               section, with_distance),
        figure("u_index", "Index of the elevation", "arcsec",
               "Standard uncertainty of the zero of the vertical circle.", section, with_angles),
        figure(
            "u_collimation", "Collimation", "arcsec",
            "Standard uncertainty of the angle between beam and tilting axis off square: the azimuth changes "
            "by it over the cosine of the elevation.",
            section, with_angles),
        figure("u_axis_tilt", "Squareness of the axes", "arcsec",
               "Standard uncertainty of the angle between the two axes off square: the azimuth changes by it "
               "times "
               "the tangent of the elevation.",
               section, with_angles),
        figure(
            "u_beam_offset", "Offset of the beam", "mm",
            "Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the "
            "azimuth changes by it over the horizontal distance.",
            section, with_angles),
        figure("u_refraction", "Coefficient of refraction", "1",
               "Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.",
               section, with_angles),
        distribution_field("distribution", "what all readings share", section)};
}

std::vector<FieldSpec> station_uncertainty_fields() {
    const char* section = "Uncertainty of the station";
    std::vector<FieldSpec> fields;
    for (const StationCoordinate& c : station_coordinates())
        fields.push_back(
            figure(c.key, c.name, c.unit,
                   "Standard uncertainty of this coordinate of the station, shared by everything "
                   "measured from it.",
                   section));
    fields.push_back(distribution_field("station_distribution", "the coordinates of the station", section));
    FieldSpec correlation{
        .key = "station_correlation",
        .title = "Correlation of the station's coordinates",
        .kind = FieldKind::table,
        .help =
            "Correlation coefficients from the adjustment that located the station; pairs left out are "
            "uncorrelated.",
        .optional = true,
        .section = section};
    std::vector<Choice> coordinates;
    for (const StationCoordinate& c : station_coordinates()) coordinates.push_back({c.symbol, c.name});
    const auto coordinate = [&](const char* key) {
        return ColumnSpec{.key = key,
                          .title = key,
                          .kind = FieldKind::choice,
                          .choices = coordinates,
                          .help = "A coordinate of the station."};
    };
    correlation.columns = {
        coordinate("first"),
        coordinate("second"),
        {.key = "r", .title = "r", .range = {.low = -1.0, .high = 1.0}, .help = "Correlation coefficient."}};
    fields.push_back(correlation);
    return fields;
}

}  // namespace

const std::array<StationCoordinate, 6>& station_coordinates() {
    static const std::array<StationCoordinate, 6> coordinates{
        {{"u_station_x", "x_0", "position x", "mm"},
         {"u_station_y", "y_0", "position y", "mm"},
         {"u_station_z", "z_0", "position z", "mm"},
         {"u_station_omega", "omega", "rotation about x", "arcsec"},
         {"u_station_phi", "phi", "rotation about y", "arcsec"},
         {"u_station_kappa", "kappa", "rotation about z", "arcsec"}}};
    return coordinates;
}

SetupSchema sensor_schema() {
    std::vector<FieldSpec> fields = station_fields();
    for (const std::vector<FieldSpec>& more :
         {specification_fields(), view_fields(), systematic_fields(), station_uncertainty_fields()})
        fields.insert(fields.end(), more.begin(), more.end());
    return SetupSchema(std::move(fields));
}

}  // namespace covaria
