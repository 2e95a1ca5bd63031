// Fields of the identification by joint trajectories.
#include "core/kinds/robot_identification/from_trajectories.h"

namespace covaria::circle_points {

namespace {

using Stated = StatedIdentification;
const Unit deg = Unit::of("deg");

Columns<StatedPoint> point_columns() {
    return Columns<StatedPoint>()
        .add(&StatedPoint::joint, "joint", "joint", "Number of the joint that turned.",
             {.range = {.low = 1.0, .high = double(most_joints)}})
        .add(&StatedPoint::q, "q", "q",
             "Reading of that joint; says which way round the points run. Empty: with the "
             "joint's positive direction.",
             {.unit = deg, .optional = true})
        .each(&StatedPoint::p, by_axis(along_axes, "Coordinate *.", {.unit = Unit::of("mm")}));
}

void add_points(Fields<Stated>& fields) {
    fields.section("Robot")
        .add(&Stated::nominal, "nominal", "Nominal robot",
             "The arm as designed: directions of the frames, definitions of base and last link, and the arm "
             "of a simulation.")
        .section("Points")
        .choice(&Stated::simulated, "data", "Points are",
                "Measured: a table. Simulated: those of the nominal robot, to see what an experiment would "
                "give.",
                {{false, "measured", "measured"}, {true, "simulated", "simulated"}}, true)
        .table(&Stated::points, "points", "Measured points",
               "Points of the ball at the flange in the order in which they were measured, joint by "
               "joint, in the frame of the instrument's world; typed or from a CSV file.",
               point_columns(), {.optional = true, .measured = true})
        .shown_where(&Stated::simulated, {false}, &Stated::points);
}

void add_simulation(Fields<Stated>& fields) {
    fields.section("Points")
        .add(&Stated::half_range, "half_range", "Range of each joint, ±",
             "Each joint turns from its zero reading less this to its zero reading plus this.",
             {.unit = deg,
              .range = {.low = 0.0, .high = 3.1415, .low_open = true},
              .default_value = Quantity{60.0, deg}})
        .add(&Stated::point_count, "point_count", "Points for each joint",
             "Number of points, evenly spaced over the range.",
             {.range = {.low = 3.0, .high = 1000.0}, .default_value = Quantity{50.0, Unit()}})
        .add(&Stated::ball, "ball", "Ball",
             "Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.",
             {.default_value = PoseValue{.position = {80.0, 60.0, 40.0}}})
        .shown_where(&Stated::simulated, {true}, &Stated::half_range, &Stated::point_count, &Stated::ball);
}

void add_method(Fields<Stated>& fields) {
    fields.section("Method")
        .choice(&Stated::plane, "plane", "Plane of a circle",
                "Total least squares fits any plane. Eq 1 of the paper has no plane through the origin "
                "and fails near it.",
                {{PlaneFit::total_least_squares, "total", "total least squares"},
                 {PlaneFit::equation_1, "equation-1", "A x + B y + C z + 1 = 0 (Eq 1)"}},
                PlaneFit::total_least_squares)
        .add(&Stated::parallel_limit, "parallel_limit", "Axes are parallel below",
             "Angle between two axes below which they are described by beta and not by their common "
             "perpendicular, whose place is then hardly determined.",
             {.unit = deg, .range = {.low = 0.0, .high = 0.5}, .default_value = Quantity{1.0, deg}})
        .choice(&Stated::uncertainties, uncertainties_key, "Uncertainties of the points",
                "As stated; or as the distances of the points from their circles see them: stated ones times "
                "one common factor, or times the factor of each figure (variance components). Either has the "
                "degrees of freedom of its estimate. What all points share stays as stated.",
                choices_of_uncertainties(), evidence::UncertaintiesFrom::stated)
        .shown_where(&Stated::simulated, {false}, &Stated::uncertainties);
}

}  // namespace

const Fields<StatedIdentification>& fields() {
    static const auto fields = [] {
        Fields<Stated> made;
        add_points(made);
        add_simulation(made);
        made.part(&Stated::locator, locator_fields());
        add_method(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::circle_points
