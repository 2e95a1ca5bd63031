// Laser tracker or total station: a distance and two angles, from where it stands.
#include <cmath>
#include <numbers>

#include "core/assets/kinds.h"
#include "core/assets/specification.h"

namespace covaria {

namespace {

struct Specification {
    double distance_constant = 0.0;  ///< a, m
    double distance_scale = 0.0;     ///< b of a + b L
    double azimuth = 0.0;            ///< rad
    double elevation = 0.0;          ///< rad
    std::string meaning;
};

FieldSpec figure(const char* key, const char* title, const char* unit, const char* help) {
    return {.key = key,
            .title = title,
            .help = help,
            .unit = Unit::of(unit),
            .range = {.low = 0.0},
            .default_value = Quantity{0.0, Unit::of(unit)},
            .section = "Specification"};
}

SetupSchema instrument_schema() {
    return SetupSchema(
        {{.key = "station",
          .title = "Station",
          .kind = FieldKind::pose,
          .help = "Where the instrument stands in the world frame: the point where its axes meet, "
                  "z along its vertical axis.",
          .default_value = PoseValue{},
          .section = "Station"},
         {.key = "kind",
          .title = "Instrument",
          .kind = FieldKind::choice,
          .help = "How the instrument is drawn.",
          .default_value = std::string("total-station"),
          .choices = {{"total-station", "total station"}, {"tracker", "laser tracker"}},
          .section = "Station"},
         figure("distance_constant", "Distance: constant part a", "mm",
                "Part of the distance's figure that does not depend on the distance."),
         figure("distance_scale", "Distance: part b per length", "ppm",
                "Part of the distance's figure in proportion to the distance."),
         figure("angle_azimuth", "Azimuth", "arcsec", "Figure for the horizontal angle."),
         figure("angle_elevation", "Elevation", "arcsec", "Figure for the vertical angle."),
         meaning_field("Specification")});
}

class SphericalSource : public PointUncertaintySource {
public:
    SphericalSource(const Eigen::Isometry3d& X_WS, Specification specification)
        : X_WS_(X_WS), specification_(std::move(specification)) {}

    Axes axes() const override { return Axes::world; }

    std::vector<PointDeviation> deviations(const Eigen::Vector3d& p) const override {
        const Eigen::Vector3d r = p - X_WS_.translation();
        const double length = r.norm();
        const Eigen::Vector3d vertical = X_WS_.linear().col(2);
        Eigen::Vector3d line_of_sight = X_WS_.linear().col(0);
        if (length > 0.0) line_of_sight = r / length;
        // Per radian: the azimuth moves the point on a circle of the horizontal distance, the elevation on
        // one of the whole distance.
        const Eigen::Vector3d along_azimuth = vertical.cross(r);
        Eigen::Vector3d along_elevation = length * X_WS_.linear().col(0);  // straight above: any direction
        if (along_azimuth.norm() > 1e-9 * length)
            along_elevation = length * line_of_sight.cross(along_azimuth.normalized());
        const double distance_figure =
            specification_.distance_constant + specification_.distance_scale * length;
        return {deviation("range", "distance", line_of_sight, distance_figure, "mm"),
                deviation("azimuth", "azimuth", along_azimuth, specification_.azimuth, "arcsec"),
                deviation("elevation", "elevation", along_elevation, specification_.elevation, "arcsec")};
    }

private:
    PointDeviation deviation(const char* id, const char* name, const Eigen::Vector3d& direction,
                             double figure_si, const char* unit) const {
        UncertaintyComponent component{
            .id = id,
            .name = name,
            .unit = Unit::of(unit),
            .distribution = specified_distribution(specification_.meaning, figure_si),
            .origin = "instrument: " + meaning_words(specification_.meaning)};
        return {id, name, direction, std::move(component), false};
    }

    Eigen::Isometry3d X_WS_;
    Specification specification_;
};

class SphericalInstrument : public Asset {
public:
    SphericalInstrument(const Eigen::Isometry3d& X_WS, const Specification& specification, std::string glyph)
        : X_WS_(X_WS),
          specification_(specification),
          source_(X_WS, specification),
          glyph_(std::move(glyph)) {}

    const PointUncertaintySource* point_uncertainty() const override { return &source_; }

    std::vector<DataTable> evaluation() const override {
        const Unit mm = Unit::of("mm");
        DataTable table;
        table.id = "distances";
        table.title = "Standard uncertainty along and across the line of sight";
        table.columns = {{.header = "distance", .unit = Unit::of("m")},
                         {.header = "along", .unit = mm, .digits = 3},
                         {.header = "across, by azimuth", .unit = mm, .digits = 3},
                         {.header = "across, by elevation", .unit = mm, .digits = 3}};
        for (double distance : {1.0, 2.0, 5.0, 10.0, 20.0}) {
            const Eigen::Vector3d p = X_WS_ * Eigen::Vector3d(distance, 0.0, 0.0);
            std::vector<TableCell> row{distance};
            for (const PointDeviation& d : source_.deviations(p))
                row.push_back(d.direction.norm() * d.component.distribution.standard_uncertainty());
            table.rows.push_back(std::move(row));
        }
        table.notes.push_back("For a target at the height of the instrument. The figures are taken as: " +
                              meaning_words(specification_.meaning) + ".");
        return {table};
    }

    Layout layout() const override {
        Layout layout;
        const LayoutSource source{"/station", true};
        layout.bodies.push_back({.name = "instrument",
                                 .kind = BodyKind::instrument,
                                 .X_WB = X_WS_,
                                 .glyph = glyph_,
                                 .source = source});
        layout.points.push_back(
            {.name = "station", .kind = PointKind::station, .p_W = X_WS_.translation(), .source = source});
        return layout;
    }

private:
    Eigen::Isometry3d X_WS_;
    Specification specification_;
    SphericalSource source_;
    std::string glyph_;
};

std::unique_ptr<Asset> create_instrument(const SetupReader& setup, Problems&) {
    const Specification specification{setup.number("distance_constant"), setup.number("distance_scale"),
                                      setup.number("angle_azimuth"), setup.number("angle_elevation"),
                                      setup.text("meaning")};
    return std::make_unique<SphericalInstrument>(setup.pose("station"), specification, setup.text("kind"));
}

}  // namespace

AssetDescriptor spherical_instrument_kind() {
    AssetDescriptor d;
    d.kind = "spherical-instrument";
    d.title = "Laser tracker or total station";
    d.category = AssetCategory::instrument;
    d.summary =
        "An instrument that measures a distance and two angles; its uncertainty lies along and across the "
        "line of sight from where it stands.";
    d.references = {{"ISO 17123-4, ISO 10360-10"}};
    d.notes = {
        "The distance has the figure a + b L, each angle its own. All readings are independent: a common "
        "scale or index error of the instrument is not part of this description."};
    d.capabilities = {"point-uncertainty"};
    d.schema = instrument_schema();
    d.create = create_instrument;
    return d;
}

}  // namespace covaria
