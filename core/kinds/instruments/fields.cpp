#include "core/kinds/instruments/fields.h"

#include <numbers>

#include "core/kinds/points/stated_figure.h"

namespace covaria {

namespace {

using S = StatedInstrument;
using Kind = InstrumentKind;

Further figure(const char* unit) {
    return {.unit = Unit::of(unit), .range = {.low = 0.0}, .default_value = Quantity{0.0, Unit::of(unit)}};
}

void add_station(Fields<S>& fields) {
    fields.section("Station")
        .add(&S::placement, "station", "Station",
             "Where the instrument stands in the world frame: the point where its axes meet. x is the zero "
             "of the azimuth (the optical axis of a camera), z the vertical axis.",
             {.default_value = PoseValue{}})
        .choice(&S::angles, "station_angles", "The angles are",
                "How the three angles of the station turn its axes.",
                {{StationAngles::zyx, "zyx", "α, β, γ: R = Rz(γ) Ry(β) Rx(α)"},
                 {StationAngles::xyz, "xyz", "ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric"}},
                StationAngles::zyx)
        .photogrammetric_where(&S::angles, StationAngles::xyz, &S::placement)
        .choice(&S::kind, "kind", "Instrument", "What the instrument reads, and how it is drawn.",
                {{Kind::total_station, "total-station", "total station: distance and two angles"},
                 {Kind::tracker, "tracker", "laser tracker: distance and two angles"},
                 {Kind::scanner, "scanner", "laser scanner: distance and two angles"},
                 {Kind::camera, "camera", "camera: two angles"},
                 {Kind::distance_meter, "distance-meter", "distance meter: distance only"},
                 {Kind::generic, "generic", "other: chosen readings"}},
                Kind::total_station)
        .add(&S::reads_distance, "reads_distance", "Reads the distance",
             "Whether the sensor reads a distance.", {.default_value = true})
        .add(&S::reads_azimuth, "reads_azimuth", "Reads the azimuth",
             "Whether the sensor reads a horizontal angle.", {.default_value = true})
        .add(&S::reads_elevation, "reads_elevation", "Reads the elevation",
             "Whether the sensor reads a vertical angle.", {.default_value = true})
        .shown_where(&S::kind, {Kind::generic}, &S::reads_distance, &S::reads_azimuth, &S::reads_elevation);
}

/// Range and field of view: blank where there is no limit.
void add_view(Fields<S>& fields) {
    const auto limit = [](const char* unit, double high) {
        return Further{
            .unit = Unit::of(unit), .range = {.low = 0.0, .high = high, .low_open = true}, .optional = true};
    };
    constexpr double turn = 2.0 * std::numbers::pi;
    fields.section("Range and field of view")
        .add(&S::view_nearest, "view_nearest", "Shortest distance",
             "Targets nearer than this are not measured.", figure("m"))
        .add(&S::view_farthest, "view_farthest", "Longest distance",
             "Targets farther than this are not measured; empty: no limit.",
             limit("m", Range::infinity_value))
        .add(&S::view_azimuth, "view_azimuth", "Horizontal field of view",
             "Full angle, half of it to either side of the sensor's x-axis; empty: all round.",
             limit("deg", turn))
        .add(&S::view_elevation, "view_elevation", "Vertical field of view",
             "Full angle, half of it above the sensor's xy-plane and half below; empty: no limit.",
             limit("deg", 0.5 * turn));
}

void add_specification(Fields<S>& fields) {
    fields.section("Specification")
        .add(&S::distance_constant, "distance_constant", "Distance: constant part a",
             "Part of the distance's figure that does not depend on the distance.", figure("mm"))
        .add(&S::distance_scale, "distance_scale", "Distance: part b per length",
             "Part of the distance's figure in proportion to the distance.", figure("ppm"))
        .add(&S::angle_azimuth, "angle_azimuth", "Azimuth", "Figure for the horizontal angle.",
             figure("arcsec"))
        .add(&S::angle_elevation, "angle_elevation", "Elevation", "Figure for the vertical angle.",
             figure("arcsec"))
        .add(&S::across_constant, "across_constant", "Angles: constant part across",
             "Part of both angles' figures that is a length across the line of sight, as trackers state it "
             "(15 µm + 6 µm/m); an angle's figure is this over the distance plus its own.",
             figure("mm"))
        .add(&S::meaning, meaning_field("Specification"));
}

void add_shared(Fields<S>& fields) {
    fields.section("Shared by all readings")
        .add(&S::u_scale, "u_scale", "Scale of distances",
             "Standard uncertainty of the scale, which all distances share: wavelength, refractive index, "
             "temperature of a scale.",
             figure("ppm"))
        .add(&S::u_zero, "u_zero", "Zero offset of distances",
             "Standard uncertainty of the constant offset of all distances: home position, reflector.",
             figure("mm"))
        .add(&S::u_index, "u_index", "Index of the elevation",
             "Standard uncertainty of the zero of the vertical circle.", figure("arcsec"))
        .add(&S::u_collimation, "u_collimation", "Collimation",
             "Standard uncertainty of the angle between beam and tilting axis off square: the azimuth "
             "changes by it over the cosine of the elevation.",
             figure("arcsec"))
        .add(&S::u_axis_tilt, "u_axis_tilt", "Squareness of the axes",
             "Standard uncertainty of the angle between the two axes off square: the azimuth changes by it "
             "times the tangent of the elevation.",
             figure("arcsec"))
        .add(&S::u_beam_offset, "u_beam_offset", "Offset of the beam",
             "Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the "
             "azimuth changes by it over the horizontal distance.",
             figure("mm"))
        .add(&S::u_refraction, "u_refraction", "Coefficient of refraction",
             "Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.",
             figure("1"))
        .add(&S::distribution,
             distribution_field("distribution", "what all readings share", "Shared by all readings"));
}

void add_station_uncertainty(Fields<S>& fields) {
    const char* const section = "Uncertainty of the station";
    std::array<FieldSpec, 6> specs;
    std::vector<ChoiceOf<std::size_t>> coordinates;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const StationCoordinate& c = station_coordinates()[i];
        coordinates.push_back({i, c.symbol, c.name});
        specs[i] = {.key = c.key,
                    .title = c.name,
                    .help =
                        "Standard uncertainty of this coordinate of the station, shared by everything "
                        "measured from it.",
                    .unit = Unit::of(c.unit),
                    .range = {.low = 0.0},
                    .default_value = Quantity{0.0, Unit::of(c.unit)}};
    }
    const char* const help = "A coordinate of the station.";
    fields.section(section)
        .each(&S::u_station, specs)
        .add(&S::station_distribution,
             distribution_field("station_distribution", "the coordinates of the station", section))
        .table(&S::correlations, "station_correlation", "Correlation of the station's coordinates",
               "Correlation coefficients from the adjustment that located the station; pairs left out are "
               "uncorrelated.",
               Columns<StationCorrelation>()
                   .choice(&StationCorrelation::first, "first", "first", help, coordinates)
                   .choice(&StationCorrelation::second, "second", "second", help, coordinates)
                   .add(&StationCorrelation::coefficient, "r", "r", "Correlation coefficient.",
                        {.range = {.low = -1.0, .high = 1.0}}),
               {.optional = true});
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

const Fields<StatedInstrument>& sensor_fields() {
    static const auto fields = [] {
        Fields<S> made;
        add_station(made);
        add_specification(made);
        add_view(made);
        add_shared(made);
        add_station_uncertainty(made);
        made.shown_where(
                &S::kind,
                {Kind::total_station, Kind::tracker, Kind::scanner, Kind::distance_meter, Kind::generic},
                &S::distance_constant, &S::distance_scale, &S::u_scale, &S::u_zero)
            .shown_where(&S::kind,
                         {Kind::total_station, Kind::tracker, Kind::scanner, Kind::camera, Kind::generic},
                         &S::angle_azimuth, &S::angle_elevation, &S::across_constant, &S::u_index,
                         &S::u_collimation, &S::u_axis_tilt, &S::u_beam_offset, &S::u_refraction);
        return made;
    }();
    return fields;
}

}  // namespace covaria
