// Fields of the identification from distances, planes and targets.
#include "core/kinds/robot_identification/from_readings.h"

namespace covaria::reading_identification {

namespace {

using Stated = StatedIdentification;
const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");
const std::vector<ChoiceOf<bool>> found_or_known{{true, "found", "found by the fit"},
                                                 {false, "known", "known"}};
const std::vector<ChoiceOf<bool>> fit_or_check{{false, "fit", "fit"}, {true, "check", "check"}};
constexpr const char* use_help =
    "fit: taken into the fit. check: held back, to see how well the identified arm tells it. Empty: fit.";

Columns<StatedTarget> target_columns() {
    return Columns<StatedTarget>()
        .add(&StatedTarget::name, "name", "name", "Name, unique.")
        .each(&StatedTarget::p,
              by_axis(along_axes, "Coordinate * in the frame of the last link; of one that is found: about.",
                      {.unit = mm}))
        .choice(&StatedTarget::found, "place", "place is", "Found by the fit, or known. Empty: found.",
                found_or_known, {.optional = true})
        .add(&StatedTarget::u, "u", "u", "Standard uncertainty of each coordinate, where it is known.",
             {.unit = mm, .range = {.low = 0.0}, .optional = true});
}

Columns<StatedPlace> place_columns() {
    return Columns<StatedPlace>()
        .add(&StatedPlace::name, "name", "name", "Name, unique.")
        .choice(&StatedPlace::plane, "what", "is a",
                "A point: the centre of a ball, a wire's or a distance meter's zero. Or a plane.",
                {{false, "point", "point"}, {true, "plane", "plane"}})
        .each(
            &StatedPlace::p,
            by_axis(along_axes,
                    "Coordinate * in the measuring frame, of the point or of any point of the plane; may be "
                    "empty where it is found.",
                    {.unit = mm, .optional = true}))
        .each(
            &StatedPlace::normal,
            by_axis({"n_x", "n_y", "n_z"},
                    "Coordinate * of the normal of a plane, to the side on which distances are positive; may "
                    "be empty where it is found.",
                    {.unit = Unit(), .optional = true}))
        .choice(&StatedPlace::found, "place", "place is", "Found by the fit, or known. Empty: known.",
                found_or_known, {.optional = true})
        .add(
            &StatedPlace::u, "u", "u",
            "Standard uncertainty of each coordinate of a known point, or of a known plane along its normal.",
            {.unit = mm, .range = {.low = 0.0}, .optional = true});
}

std::array<ColumnSpec, most_joints> torque_columns() {
    std::array<ColumnSpec, most_joints> columns;
    for (std::size_t i = 0; i < most_joints; ++i) {
        const std::string number = std::to_string(i + 1);
        columns[i] = {.key = "tau_" + number,
                      .title = "tau_" + number,
                      .unit = Unit::of("N*m"),
                      .optional = true,
                      .help = "Torque of the load about the axis of joint " + number +
                              ", where compliances are found; empty: none."};
    }
    return columns;
}

Columns<StatedPose> pose_columns() {
    return Columns<StatedPose>()
        .add(&StatedPose::name, "name", "name", "Name, unique.")
        .each(&StatedPose::q, reading_columns("q", deg, ", if it turns."))
        .each(&StatedPose::s, reading_columns("s", mm, ", if it slides."))
        .each(&StatedPose::torque, torque_columns());
}

Columns<StatedDistance> distance_columns() {
    return Columns<StatedDistance>()
        .add(&StatedDistance::pose, "pose", "pose", "Name of the pose in which the arm stood.")
        .add(&StatedDistance::target, "target", "target",
             "Name of the ball or reflector that was measured. Empty: the first.", {.optional = true})
        .choice(
            &StatedDistance::from, "what", "from a",
            "Distance of the target from a point; from a plane, on the side of its normal; or from where "
            "the same target is in another pose.",
            {{From::point, "point", "point"}, {From::plane, "plane", "plane"}, {From::pose, "pose", "pose"}})
        .add(&StatedDistance::to, "to", "called", "Name of the point, the plane or the other pose.")
        .add(&StatedDistance::value, "value", "distance",
             "Measured distance; 0 where the ball touches the plane. Not needed of a plan.",
             {.unit = mm, .optional = true})
        .add(&StatedDistance::u, "u", "u",
             "Standard uncertainty of this distance. Empty: that of all distances.",
             {.unit = mm, .range = {.low = 0.0}, .optional = true})
        .add(&StatedDistance::zero, "zero", "zero",
             "Name of an unknown that all distances of that name contain: zero of a wire sensor, length of a "
             "ballbar, radius of a ball. Empty: none.",
             {.optional = true})
        .choice(&StatedDistance::check, "use", "use", use_help, fit_or_check, {.optional = true});
}

Columns<StatedPosition> position_columns() {
    return Columns<StatedPosition>()
        .add(&StatedPosition::pose, "pose", "pose", "Name of the pose in which the arm stood.")
        .add(&StatedPosition::target, "target", "target",
             "Name of the ball or reflector that was measured. Empty: the first.", {.optional = true})
        .each(&StatedPosition::p,
              by_axis(along_axes, "Measured coordinate * in the measuring frame. Not needed of a plan.",
                      {.unit = mm, .optional = true}))
        .choice(&StatedPosition::check, "use", "use", use_help, fit_or_check, {.optional = true});
}

void add_readings(Fields<Stated>& fields) {
    fields.section("Readings")
        .table(&Stated::distances, "distances", "Distances",
               "Distances of a target in one pose from a point, a plane, or its place in another pose: laser "
               "tracer, wire sensors, ballbar, dial gauge, probe on a ball plate.",
               distance_columns(), {.optional = true, .measured = true})
        .add(&Stated::u_distance, "u_distance", "Standard uncertainty of a distance",
             "Of each distance that states none of its own, independent of all others.",
             {.unit = mm, .range = {.low = 0.0}, .default_value = Quantity{0.01, mm}})
        .add(
            &Stated::u_scale, "u_scale", "Relative standard uncertainty of their scale",
            "All distances from points and between poses share it: the length standard, its temperature.",
            {.unit = Unit::of("ppm"), .range = {.low = 0.0}, .default_value = Quantity{0.0, Unit::of("ppm")}})
        .table(&Stated::positions, "positions", "Positions",
               "Coordinates of targets that an instrument measured, one or more targets in a pose.",
               position_columns(), {.optional = true, .measured = true})
        .part(&Stated::locator, locator_fields());
}

void add_method(Fields<Stated>& fields) {
    fields.section("Method")
        .choice(&Stated::base_found, "base_place", "Place of the base is",
                "Found by the fit: points, planes and the instrument stand anywhere. Known: the base stands "
                "where the robot says it stands, and places are given or found relative to it.",
                found_or_known, true)
        .choice(&Stated::compliant, "compliance", "Compliance of the joints",
                "Found: each joint gives way in proportion to the torque of the load about it. Not in the "
                "model.",
                {{true, "found", "found by the fit"}, {false, "none", "not in the model"}}, false)
        .table(&Stated::held_by_user, "held", "Parameters held",
               "Parameters that stay nominal although the readings could tell them.",
               Columns<Stated::Held>().add(&Stated::Held::parameter, "parameter", "parameter",
                                           "A parameter by its symbol, such as d_3 or alpha_4."),
               {.optional = true})
        .choice(&Stated::uncertainties, uncertainties_key, "Uncertainties of the readings",
                "As stated; or as the residuals of this fit see them: stated ones times one common factor, "
                "or times the factor of each figure (variance components). Either has the degrees of freedom "
                "of its estimate. What all readings share stays as stated.",
                choices_of_uncertainties(), evidence::UncertaintiesFrom::stated)
        .shown_where(&Stated::simulated, {false}, &Stated::uncertainties);
}

}  // namespace

const Fields<StatedIdentification>& fields() {
    static const auto fields = [] {
        Fields<Stated> made;
        made.section("Robot")
            .add(
                &Stated::nominal, "nominal", "Nominal robot",
                "The arm as designed: start of the fit, values of what the readings cannot tell, uncertainty "
                "of the readings of its joints, and the arm of a plan.")
            .choice(&Stated::simulated, "data", "Readings are",
                    "Measured. Or a plan: readings are those of the nominal robot, to see what an experiment "
                    "would give.",
                    {{false, "measured", "measured"}, {true, "simulated", "a plan"}}, false)
            .table(&Stated::targets, "targets", "Balls and reflectors", "What is measured on the last link.",
                   target_columns(), {.min_rows = 1})
            .table(&Stated::places, "places", "Points and planes", "What distances are measured from.",
                   place_columns(), {.optional = true})
            .table(&Stated::stated_poses, "poses", "Poses", "Readings of the joints.", pose_columns(),
                   {.min_rows = 1, .measured = true});
        add_readings(made);
        add_method(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::reading_identification
