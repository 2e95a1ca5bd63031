#include "core/kinds/points/located_points.h"

#include "core/kinds/points/point_uncertainty.h"
#include "core/kinds/points/stated_figure.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

void add_typed(const PointLocator& locator, const LocatedPoint& point, InputSet& inputs) {
    for (std::size_t c = 0; c < 3; ++c) {
        const std::string symbol = inputs.quantities[point.x_input + c].symbol;
        inputs.quantities[point.x_input + c].shares = {
            {inputs.add({.id = symbol + ".point",
                         .name = "measured coordinate",
                         .unit = Unit::of("mm"),
                         .distribution = distribution_of_shape(locator.distribution, locator.u_point),
                         .origin = "typed standard uncertainty"}),
             1.0}};
    }
}

void take_outputs(const PointOutputSource& outputs, const std::vector<LocatedPoint>& points, InputSet& inputs,
                  Problems& problems) {
    for (const LocatedPoint& point : points) {
        const std::string& name = point.name.empty() ? point.label : point.name;
        for (std::size_t c = 0; c < 3; ++c)
            inputs.quantities[point.x_input + c].taken_from = outputs.coordinate(name, c);
        if (!outputs.coordinate(name, 0))
            problems.error("/instrument", "the analysis has no point called '" + name + "'");
    }
}

void add_deviation(const PointLocator& locator, const JointDeviation& d,
                   const std::vector<LocatedPoint>& points, InputSet& inputs) {
    UncertaintyComponent component = d.component;
    component.id = (d.owner.empty() ? locator.instrument_id : d.owner) + "." + d.id +
                   (d.point ? "." + points[*d.point].label : "");
    component.name = locator.instrument_name + ", " + d.name;
    component.local = d.point.has_value();
    if (!d.point) component.identity = component.id;
    component.origin = locator.instrument_name + " (" + component.origin + ")";
    const std::size_t index = inputs.add(std::move(component));
    if (!d.estimate.empty()) inputs.rest_on_estimate(locator.instrument_id + "." + d.estimate, index, true);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (const double f = d.directions[i][static_cast<Eigen::Index>(c)]; f != 0.0)
                inputs.quantities[points[i].x_input + c].shares.push_back({index, f});
}

}  // namespace

std::optional<PointLocator> read_locator(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    PointLocator locator;
    if (setup.text("point_uncertainty") == "typed") {
        locator.u_point = setup.number("u_point");
        locator.distribution = setup.text("distribution");
        return locator;
    }
    locator.instrument_id = setup.text("instrument");
    const AssetLibrary::Entry* instrument = assets.find(locator.instrument_id);
    if (!offers<PointUncertaintySource>(instrument)) {
        problems.error("/instrument", "'" + locator.instrument_id + "' does not locate points by itself");
        return {};
    }
    locator.instrument = instrument->asset;
    locator.instrument_name = instrument->name.empty() ? locator.instrument_id : instrument->name;
    return locator;
}

std::vector<FieldSpec> locator_fields() {
    FieldSpec distribution = distribution_field("distribution", "the coordinates' deviations", "Points");
    distribution.shown_if = Condition{"point_uncertainty", {"typed"}};
    return {
        {.key = "point_uncertainty",
         .title = "Uncertainty of the points",
         .kind = FieldKind::choice,
         .help = "A standard uncertainty of every coordinate, or an instrument of the project that stands "
                 "somewhere.",
         .default_value = std::string("typed"),
         .choices = {{"typed", "typed: alike for all coordinates"}, {"asset", "an instrument"}},
         .section = "Points"},
        {.key = "u_point",
         .title = "Standard uncertainty of a coordinate",
         .help = "Of every coordinate of every point, independent of all others.",
         .unit = Unit::of("mm"),
         .range = {.low = 0.0},
         .default_value = Quantity{0.015, Unit::of("mm")},
         .shown_if = Condition{"point_uncertainty", {"typed"}},
         .section = "Points"},
        distribution,
        {.key = "instrument",
         .title = "Instrument",
         .kind = FieldKind::reference,
         .help = "What measured the points: each reading deviates by itself, its scale and its station alike "
                 "for all points.",
         .capabilities = {PointUncertaintySource::capability},
         .shown_if = Condition{"point_uncertainty", {"asset"}},
         .section = "Points"}};
}

void add_point_components(const PointLocator& locator, const std::vector<LocatedPoint>& points,
                          InputSet& inputs, Problems& problems) {
    if (!locator.instrument) {
        for (const LocatedPoint& point : points) add_typed(locator, point, inputs);
        return;
    }
    if (const auto* outputs = offers<PointOutputSource>(locator.instrument))
        return take_outputs(*outputs, points, inputs, problems);
    const PointUncertaintySource& source = *offers<PointUncertaintySource>(locator.instrument);
    std::vector<Eigen::Vector3d> places;
    for (const LocatedPoint& point : points) {
        if (const std::string objection = source.objection(point.p); !objection.empty())
            return problems.error("/instrument", "point " + point.label + ": " + objection);
        places.push_back(point.p);
    }
    for (const JointDeviation& d : source.joint_deviations(places)) add_deviation(locator, d, points, inputs);
}

}  // namespace covaria
