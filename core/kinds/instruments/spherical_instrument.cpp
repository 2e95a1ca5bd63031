// A sensor that stands somewhere and reads a distance, angles, or some of them: laser tracker, total station,
// scanner, camera, distance meter.
#include <cmath>
#include <numbers>

#include "core/base/name.h"
#include "core/kinds/instruments/assets.h"
#include "core/kinds/instruments/fields.h"
#include "core/kinds/instruments/linear_reading.h"
#include "core/kinds/instruments/sensor.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/kinds/points/stated_figure.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

constexpr double earth_radius = 6.371e6;  // m

double figure_of(const StatedInstrument& stated, Observable observable, const Eigen::Vector3d& v) {
    const double distance = v.norm();
    const double level = std::max(v.head<2>().norm(), near_zenith * distance);
    switch (observable) {
        case Observable::distance:
            return stated.distance_constant + stated.distance_scale * distance;
        case Observable::azimuth:
            return stated.angle_azimuth + stated.across_constant / level;
        case Observable::elevation:
            return stated.angle_elevation + stated.across_constant / distance;
    }
    return 0.0;
}

// Effects of shared deviations on the readings of a target at v in the sensor's axes; on an azimuth in m
// across.
double effect_of_scale(Observable o, const Eigen::Vector3d& v) {
    return o == Observable::distance ? v.norm() : 0.0;
}
double effect_of_zero(Observable o, const Eigen::Vector3d&) {
    return o == Observable::distance ? 1.0 : 0.0;
}
double effect_of_index(Observable o, const Eigen::Vector3d&) {
    return o == Observable::elevation ? 1.0 : 0.0;
}
double effect_of_collimation(Observable o, const Eigen::Vector3d& v) {
    return o == Observable::azimuth ? v.norm() : 0.0;
}
double effect_of_axis_tilt(Observable o, const Eigen::Vector3d& v) {
    return o == Observable::azimuth ? v.z() : 0.0;
}
double effect_of_beam_offset(Observable o, const Eigen::Vector3d&) {
    return o == Observable::azimuth ? 1.0 : 0.0;
}
double effect_of_refraction(Observable o, const Eigen::Vector3d& v) {
    return o == Observable::elevation ? v.norm() / (2.0 * earth_radius) : 0.0;
}

struct SharedDeviation {
    double StatedInstrument::*u;
    const char* id;
    Message (*name)();
    const char* unit;
    double (*effect)(Observable, const Eigen::Vector3d&);
};
constexpr SharedDeviation shared_deviations[] = {
    {&StatedInstrument::u_scale, "scale", tell<"scale of distances">, "ppm", effect_of_scale},
    {&StatedInstrument::u_zero, "zero", tell<"zero offset of distances">, "mm", effect_of_zero},
    {&StatedInstrument::u_index, "index", tell<"index of the elevation">, "arcsec", effect_of_index},
    {&StatedInstrument::u_collimation, "collimation", tell<"collimation">, "arcsec", effect_of_collimation},
    {&StatedInstrument::u_axis_tilt, "axis_tilt", tell<"squareness of the axes">, "arcsec",
     effect_of_axis_tilt},
    {&StatedInstrument::u_beam_offset, "beam_offset", tell<"offset of the beam">, "mm",
     effect_of_beam_offset},
    {&StatedInstrument::u_refraction, "refraction", tell<"coefficient of refraction">, "1",
     effect_of_refraction}};

UncertaintyComponent typed_component(const std::string& id, Message name, const char* unit, double u,
                                     const std::string& shape) {
    return {.id = id,
            .name = std::move(name),
            .unit = Unit::of(unit),
            .distribution = distribution_of_shape(shape, u),
            .origin = tell<"instrument: standard uncertainty">()};
}

/// The set-up with what follows from it, in SI.
struct SensorData : StatedInstrument {
    explicit SensorData(StatedInstrument stated) : StatedInstrument(std::move(stated)) {}
    Station station;
    std::array<bool, 3> reads{};
    std::string glyph;
    std::array<UncertaintyComponent, 6> station_components;
    std::vector<SystematicDeviation> systematic;
    FieldOfView view;

    bool locates() const { return reads[0] && reads[1] && reads[2]; }
};

class PlacedSensor : public SensorSource {
public:
    explicit PlacedSensor(SensorData data) : data_(std::move(data)) {}
    std::string glyph() const override { return data_.glyph; }
    bool reads(Observable o) const override { return data_.reads[static_cast<std::size_t>(o)]; }
    const Station& station() const override { return data_.station; }
    const std::array<UncertaintyComponent, 6>& station_components() const override {
        return data_.station_components;
    }
    const std::vector<StationCorrelation>& station_correlations() const override {
        return data_.correlations;
    }
    const std::vector<SystematicDeviation>& systematic() const override { return data_.systematic; }
    bool sees(const Eigen::Vector3d& v) const override { return data_.view.contains(v); }
    const FieldOfView& field_of_view() const override { return data_.view; }

    UncertaintyComponent reading(Observable observable, const Eigen::Vector3d& v) const override {
        const char* const units[] = {"mm", "arcsec", "arcsec"};
        return {.id = words_of(observable).english(),
                .name = words_of(observable),
                .unit = Unit::of(units[static_cast<int>(observable)]),
                .distribution = specified_distribution(data_.meaning, figure_of(data_, observable, v)),
                .origin = tell<"instrument: %1">(meaning_words(data_.meaning))};
    }

private:
    SensorData data_;
};

/// A point that this sensor alone has measured: deviations along and across the line of sight, those of the
/// sensor and its station common to all points.
class SphericalSource : public PointUncertaintySource {
public:
    explicit SphericalSource(const PlacedSensor& sensor) : sensor_(sensor) {}

    Axes axes() const override { return Axes::world; }

    std::vector<PointDeviation> deviations(const Eigen::Vector3d& p) const override {
        const LinearReading reading = linear_reading(sensor_.station(), p);
        const Eigen::Matrix3d moves = reading.to_point.inverse();
        std::vector<PointDeviation> found;
        for (Observable o : observables) {
            UncertaintyComponent component = sensor_.reading(o, reading.v);
            const std::string id = o == Observable::distance ? "range" : component.id;
            const Message name = component.name;
            component.id = id;
            found.push_back(
                {id, name, moves.col(static_cast<int>(o)) * reading.scale(o), std::move(component), false});
        }
        const Eigen::Matrix3Xd shared = moves * shared_effects(sensor_, reading);
        Eigen::Index column = 0;
        for (UncertaintyComponent& component : shared_components(sensor_)) {
            const Eigen::Vector3d direction = shared.col(column++);
            if (!(component.distribution.standard_uncertainty() > 0.0)) continue;
            const std::string id = component.id;
            const Message name = component.name;
            found.push_back({id, name, direction, std::move(component), true});
        }
        return found;
    }

    std::vector<Eigen::Vector3d> stations_seeing(const Eigen::Vector3d&) const override {
        return {sensor_.station().X_WS().translation()};
    }

    Message objection(const Eigen::Vector3d& p) const override {
        const Eigen::Vector3d v = sensor_.station().X_WS().inverse() * p;
        if (v.norm() == 0.0) return tell<"it is at the place of the instrument">();
        return sensor_.sees(v) ? Message()
                               : tell<"it is out of the range or field of view of the instrument">();
    }

private:
    const PlacedSensor& sensor_;
};

class SphericalInstrument : public Asset {
public:
    explicit SphericalInstrument(SensorData data)
        : locates_(data.locates()), sensor_(std::move(data)), source_(sensor_) {
        offer(sensor_);
        if (locates_) offer(source_);
    }

    std::vector<Table> evaluation() const override {
        const Unit mm = Unit::of("mm");
        Table table{"distances", "Standard uncertainty of one reading, along and across the line of sight"};
        table.add("distance").in(Unit::of("m"));
        for (Observable o : observables)
            if (sensor_.reads(o))
                table
                    .add(o == Observable::distance ? std::string("along")
                                                   : "across, by " + words_of(o).english())
                    .in(mm)
                    .figure(3);
        for (double distance : {1.0, 2.0, 5.0, 10.0, 20.0}) {
            std::vector<Cell> row{distance};
            for (Observable o : observables) {
                if (!sensor_.reads(o)) continue;
                const double u = sensor_.reading(o, Eigen::Vector3d(distance, 0.0, 0.0))
                                     .distribution.standard_uncertainty();
                row.push_back(o == Observable::distance ? u : distance * u);
            }
            table.row(std::move(row));
        }
        table.notes.push_back(tell<"For a target at the height of the instrument.">());
        return {table};
    }

    Layout layout() const override {
        Layout layout;
        const LayoutSource source{sensor_fields().place(&StatedInstrument::placement), true};
        const Eigen::Isometry3d X_WS = sensor_.station().X_WS();
        layout.bodies.push_back({.name = own_name<"instrument">(),
                                 .kind = BodyKind::instrument,
                                 .X_WB = X_WS,
                                 .glyph = sensor_.glyph(),
                                 .source = source});
        layout.points.push_back({.name = own_name<"station">(),
                                 .kind = PointKind::station,
                                 .p_W = X_WS.translation(),
                                 .source = source});
        add_view(layout);
        return layout;
    }

private:
    /// Edges of a limited field of view, from the station to the end of the range (or 1 m).
    void add_view(Layout& layout) const {
        const FieldOfView& view = sensor_.field_of_view();
        if (!view.is_limited() || view.azimuth >= 0.5 * std::numbers::pi) return;
        const Eigen::Isometry3d X_WS = sensor_.station().X_WS();
        const double length = std::isfinite(view.farthest) ? view.farthest : 1.0;
        std::array<Eigen::Vector3d, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
            const double azimuth = i == 0 || i == 3 ? -view.azimuth : view.azimuth;
            const double elevation = i < 2 ? -view.elevation : view.elevation;
            corners[i] = X_WS * (length * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                                          std::cos(elevation) * std::sin(azimuth),
                                                          std::sin(elevation)));
        }
        for (std::size_t i = 0; i < 4; ++i) {
            layout.links.push_back(
                {own_name<"field of view">(), LinkKind::field_of_view, X_WS.translation(), corners[i], {}});
            layout.links.push_back(
                {own_name<"field of view">(), LinkKind::field_of_view, corners[i], corners[(i + 1) % 4], {}});
        }
    }

    bool locates_;
    PlacedSensor sensor_;
    SphericalSource source_;
};

std::array<bool, 3> readings_of(const StatedInstrument& stated) {
    if (stated.kind == InstrumentKind::camera) return {false, true, true};
    if (stated.kind == InstrumentKind::distance_meter) return {true, false, false};
    if (stated.kind == InstrumentKind::generic)
        return {stated.reads_distance, stated.reads_azimuth, stated.reads_elevation};
    return {true, true, true};
}

/// Name of the glyph in layouts.
std::string glyph_of(InstrumentKind kind) {
    constexpr const char* glyphs[] = {"total-station", "tracker",        "scanner",
                                      "camera",        "distance-meter", "total-station"};
    return glyphs[static_cast<std::size_t>(kind)];
}

void take_station(SensorData& data, Problems& problems) {
    data.station = {data.placement.coordinates_si(), data.angles};
    for (std::size_t i = 0; i < 6; ++i) {
        const StationCoordinate& c = station_coordinates()[i];
        data.station_components[i] = typed_component(std::string("station.") + c.symbol,
                                                     tell<"station, %1">(Message::declared(c.name)), c.unit,
                                                     data.u_station[i], data.station_distribution);
    }
    if (!data.correlations.empty() && data.station_distribution != "normal")
        problems.error(sensor_fields().place(&StatedInstrument::station_distribution),
                       tell<"correlated coordinates of a station are combinations of independent deviations, "
                            "which are normal: leave the distribution normal, or the correlation out">());
    for (std::size_t row = 0; row < data.correlations.size(); ++row)
        if (data.correlations[row].first == data.correlations[row].second) {
            data.correlations.resize(row);
            problems.error(
                sensor_fields().place(&StatedInstrument::correlations, row),
                tell<"a coordinate of the station is correlated with itself; name two different ones">());
        }
}

void take_view(SensorData& data, Problems& problems) {
    data.view.nearest = data.view_nearest;
    data.view.farthest = data.view_farthest;
    if (data.view_azimuth) data.view.azimuth = 0.5 * *data.view_azimuth;
    if (data.view_elevation) data.view.elevation = 0.5 * *data.view_elevation;
    if (!(data.view_nearest < data.view_farthest))
        problems.error(
            sensor_fields().place(&StatedInstrument::view_farthest),
            tell<
                "the range ends before it begins: the longest distance must be greater than the shortest">());
}

std::unique_ptr<Asset> create_instrument(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    SensorData data(sensor_fields().read(setup, assets, problems));
    data.reads = readings_of(data);
    if (!data.reads[0] && !data.reads[1] && !data.reads[2]) {
        problems.error(sensor_fields().place(&StatedInstrument::reads_distance),
                       tell<"the sensor reads nothing: choose a distance or an angle">());
        return nullptr;
    }
    data.glyph = glyph_of(data.kind);
    take_station(data, problems);
    take_view(data, problems);
    const bool angles = data.reads[1] || data.reads[2];
    for (const SharedDeviation& shared : shared_deviations) {
        const bool applies =
            shared.effect == effect_of_scale || shared.effect == effect_of_zero ? data.reads[0] : angles;
        const double u = data.*shared.u;
        if (!applies || u == 0.0) continue;
        data.systematic.push_back(
            {typed_component(shared.id, shared.name(), shared.unit, u, data.distribution), shared.effect});
    }
    auto instrument = std::make_unique<SphericalInstrument>(std::move(data));
    if (!has_valid_correlation(*offers<SensorSource>(instrument)))
        problems.error(
            sensor_fields().place(&StatedInstrument::correlations),
            tell<"these coefficients are not possible together: their matrix has a negative eigenvalue">());
    return instrument;
}

}  // namespace

AssetDescriptor spherical_instrument_kind() {
    AssetDescriptor d;
    d.kind = "spherical-instrument";
    d.title = "Tracker, total station, camera or distance meter";
    d.category = AssetCategory::instrument;
    d.summary =
        "A sensor that stands somewhere and reads a distance, two angles, or some of them. Its uncertainty: "
        "each "
        "reading for itself, what all its readings share, and where it stands.";
    d.references = {
        {"ISO 17123-4, ISO 10360-10"},
        {"M. Galetto, L. Mastrogiacomo, D. A. Maisano, F. Franceschini: Uncertainty evaluation of "
         "distributed Large-Scale-Metrology systems by a Monte Carlo approach"}};
    d.notes = {
        "The distance has the figure a + b L, each angle its own; these are independent from reading to "
        "reading. "
        "Scale, zero, index, collimation, squareness, beam offset and refraction are shared by all readings.",
        "Only a sensor that reads a distance and both angles can say by itself where a point is."};
    d.capabilities = {PointUncertaintySource::capability, SensorSource::capability};
    d.schema = sensor_fields().schema();
    d.create = create_instrument;
    return d;
}

}  // namespace covaria
