// Fields of the identification from measured poses.
#include "core/kinds/robot_identification/from_poses.h"

namespace covaria::pose_calibration {

namespace {

using Stated = StatedCalibration;
const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");

Columns<StatedPose> pose_columns() {
    return Columns<StatedPose>()
        .add(&StatedPose::name, "name", "name", "Name, unique.")
        .choice(&StatedPose::check, "use", "use",
                "fit: taken into the fit. check: held back, to see how well the fit tells a "
                "pose that it has not seen. Empty: fit.",
                {{false, "fit", "fit"}, {true, "check", "check"}}, {.optional = true})
        .each(&StatedPose::q, reading_columns("q", deg, "; empty: its zero reading."))
        .each(&StatedPose::p,
              by_axis(along_axes, "Measured coordinate * in the frame of the instrument's world.",
                      {.unit = mm}))
        .each(&StatedPose::angles, by_axis(zyx_angles,
                                           "Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where "
                                           "poses "
                                           "are measured.",
                                           {.unit = deg, .optional = true}))
        .each(&StatedPose::s, reading_columns("s", mm, ", if it slides."));
}

void add_robot(Fields<Stated>& fields) {
    fields.section("Robot").add(
        &Stated::nominal, "nominal", "Nominal robot",
        "The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of "
        "the readings of its joints, and the arm of a simulation.");
}

void add_poses(Fields<Stated>& fields) {
    fields.section("Poses")
        .choice(&Stated::simulated, "data", "Poses are",
                "Measured: a table. Simulated: those of the nominal robot, to see what an experiment would "
                "give.",
                {{false, "measured", "measured"}, {true, "simulated", "simulated"}}, true)
        .choice(&Stated::with_orientation, "quantity", "Measured is",
                "The position of a ball alone, or position and orientation of the tool.",
                {{false, "positions", "the position"}, {true, "poses", "position and orientation"}}, false)
        .table(&Stated::measured, "poses", "Measured poses",
               "Readings of the joints and the place of the ball or tool that was measured there; "
               "typed or from a CSV file.",
               pose_columns(), {.optional = true, .measured = true})
        .add(&Stated::pose_count, "pose_count", "Number of poses",
             "Poses of the simulated experiment, spread over the range of all joints, always the same.",
             {.range = {.low = 3.0, .high = 1000.0}, .default_value = Quantity{50.0, Unit()}})
        .add(&Stated::half_range, "half_range", "Range of each joint, ±",
             "From the zero reading on, as far as the limits of the joint allow.",
             {.unit = deg,
              .range = {.low = 0.0, .high = 3.1416, .low_open = true},
              .default_value = Quantity{90.0, deg}})
        .shown_where(&Stated::simulated, {false}, &Stated::measured)
        .shown_where(&Stated::simulated, {true}, &Stated::pose_count, &Stated::half_range);
}

void add_points(Fields<Stated>& fields) {
    fields.part(&Stated::locator, locator_fields())
        .section("Points")
        .add(&Stated::u_angle, "u_angle", "Standard uncertainty of an orientation",
             "Of the rotation of the measured tool about each of its axes, independent.",
             {.unit = deg, .range = {.low = 0.0}, .default_value = Quantity{0.005, deg}})
        .shown_where(&Stated::with_orientation, {true}, &Stated::u_angle);
}

void add_method(Fields<Stated>& fields) {
    const std::vector<ChoiceOf<bool>> fitted_or_known{{true, "fitted", "found by the fit"},
                                                      {false, "known", "known exactly"}};
    fields.section("Method")
        .add(&Stated::ball, "ball", "Ball or tool",
             "Where it is in the frame of the last link: exactly, or as a start of the fit.",
             {.default_value = PoseValue{.position = {80.0, 60.0, 40.0}}})
        .choice(&Stated::tool_fitted, "tool_place", "Place of the ball or tool is",
                "Found by the fit together with the parameters, or known.", fitted_or_known, true)
        .choice(&Stated::base_fitted, "base_place", "Place of the base is",
                "Found by the fit: the instrument stands anywhere. Known: the base stands where the "
                "robot says it stands in the world.",
                fitted_or_known, true)
        .table(&Stated::held_by_user, "held", "Parameters held",
               "Parameters that stay nominal although the poses could tell them.",
               Columns<HeldByUser>().add(&HeldByUser::parameter, "parameter", "parameter",
                                         "A parameter by its symbol, such as d_3 or alpha_4."),
               {.optional = true})
        .choice(&Stated::uncertainties, uncertainties_key, "Uncertainties of points and readings",
                "As stated; or as the residuals of this fit see them: stated ones times one common factor, "
                "or times the factor of each figure (variance components). Either has the degrees of freedom "
                "of its estimate. What all poses share stays as stated.",
                choices_of_uncertainties(), evidence::UncertaintiesFrom::stated)
        .shown_where(&Stated::simulated, {false}, &Stated::uncertainties);
}

}  // namespace

const Fields<StatedCalibration>& fields() {
    static const auto fields = [] {
        Fields<Stated> made;
        add_robot(made);
        add_poses(made);
        add_points(made);
        add_method(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::pose_calibration
