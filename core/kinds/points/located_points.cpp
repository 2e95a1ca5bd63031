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
                         .name = tell<"measured coordinate">(),
                         .unit = Unit::of("mm"),
                         .distribution = distribution_of_shape(locator.distribution, locator.u_point),
                         .origin = tell<"typed standard uncertainty">()}),
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
            problems.error(locator_fields().place(&PointLocator::instrument),
                           tell<"the analysis has no point called '%1'">(name));
    }
}

void add_deviation(const PointLocator& locator, const JointDeviation& d,
                   const std::vector<LocatedPoint>& points, InputSet& inputs) {
    UncertaintyComponent component = d.component;
    component.id = (d.owner.empty() ? locator.instrument.id : d.owner) + "." + d.id +
                   (d.point ? "." + points[*d.point].label : "");
    component.name = tell<"%1, %2">(locator.instrument.name, d.name);
    component.local = d.point.has_value();
    if (!d.point) component.identity = component.id;
    component.origin = tell<"%1 (%2)">(locator.instrument.name, component.origin);
    const std::size_t index = inputs.add(std::move(component));
    if (!d.estimate.empty()) inputs.rest_on_estimate(locator.instrument.id + "." + d.estimate, index, true);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (const double f = d.directions[i][static_cast<Eigen::Index>(c)]; f != 0.0)
                inputs.quantities[points[i].x_input + c].shares.push_back({index, f});
}

}  // namespace

const Fields<PointLocator>& locator_fields() {
    static const auto fields =
        Fields<PointLocator>()
            .section("Points")
            .choice(&PointLocator::typed, "point_uncertainty", "Uncertainty of the points",
                    "A standard uncertainty of every coordinate, or an instrument of the project that "
                    "stands somewhere.",
                    {{true, "typed", "typed: alike for all coordinates"}, {false, "asset", "an instrument"}},
                    true)
            .add(&PointLocator::u_point, "u_point", "Standard uncertainty of a coordinate",
                 "Of every coordinate of every point, independent of all others.",
                 {.unit = Unit::of("mm"),
                  .range = {.low = 0.0},
                  .default_value = Quantity{0.015, Unit::of("mm")}})
            .add(&PointLocator::distribution,
                 distribution_field("distribution", "the coordinates' deviations", "Points"))
            .add(&PointLocator::instrument, "instrument", "Instrument",
                 "What measured the points: each reading deviates by itself, its scale and its station "
                 "alike for all points.")
            .shown_where(&PointLocator::typed, {true}, &PointLocator::u_point, &PointLocator::distribution)
            .shown_where(&PointLocator::typed, {false}, &PointLocator::instrument);
    return fields;
}

void add_point_components(const PointLocator& locator, const std::vector<LocatedPoint>& points,
                          InputSet& inputs, Problems& problems) {
    if (locator.typed) {
        for (const LocatedPoint& point : points) add_typed(locator, point, inputs);
        return;
    }
    if (const auto* outputs = offers<PointOutputSource>(locator.instrument.asset))
        return take_outputs(*outputs, points, inputs, problems);
    std::vector<Eigen::Vector3d> places;
    for (const LocatedPoint& point : points) {
        if (const Message objection = locator.instrument->objection(point.p); !objection.empty())
            return problems.error(locator_fields().place(&PointLocator::instrument),
                                  tell<"point %1: %2">(point.label, objection));
        places.push_back(point.p);
    }
    for (const JointDeviation& d : locator.instrument->joint_deviations(places))
        add_deviation(locator, d, points, inputs);
}

}  // namespace covaria
