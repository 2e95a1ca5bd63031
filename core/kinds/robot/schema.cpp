// Fields of "robot pose".
#include "core/kinds/robot/setup.h"

namespace covaria::robot {

namespace {

const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");

Columns<StatedPose> pose_columns() {
    return Columns<StatedPose>()
        .add(&StatedPose::name, "name", "name", "Name of the pose, unique.")
        .each(&StatedPose::q, reading_columns("q", deg, ", if it turns."))
        .each(&StatedPose::s, reading_columns("s", mm, ", if it slides."));
}

Columns<StatedPlace> place_columns() {
    return Columns<StatedPlace>()
        .add(&StatedPlace::name, "name", "name", "Name, unique.")
        .each(&StatedPlace::position, by_axis(along_axes, "Coordinate * of the tool.", {.unit = mm}))
        .each(&StatedPlace::angles, by_axis(zyx_angles,
                                            "Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: "
                                            "any orientation.",
                                            {.unit = deg, .optional = true}));
}

void add_poses(Fields<PoseSetup>& fields) {
    fields.section("Poses")
        .table(&PoseSetup::stated, "poses", "Poses by joint readings",
               "Readings of the joints, typed or from a CSV file. An empty cell is the zero "
               "reading of the joint; a robot with fewer joints leaves the last columns empty.",
               pose_columns(), {.optional = true})
        .table(&PoseSetup::places, "targets", "Poses by place",
               "Places of the tool in the robot's base frame; the readings follow by inverse "
               "kinematics, within the limits and near those of the pose before.",
               place_columns(), {.optional = true});
}

void add_results(Fields<PoseSetup>& fields) {
    std::vector<ChoiceOf<std::optional<RotationConvention>>> orientations{
        {std::nullopt, "none", "none (position alone)"}};
    for (const RotationConventionInfo& info : rotation_conventions())
        orientations.push_back({info.convention, info.key.data(), std::string(info.title)});
    fields.section("Results")
        .choice(&PoseSetup::orientation, "orientation", "Orientation stated as",
                "Numbers that state the orientation of the tool; none: the position alone.", orientations,
                RotationConvention::zyx)
        .choice(&PoseSetup::in_world, "frame", "Results in",
                "The frame in which position and orientation are stated.",
                {{false, "base", "the base frame of the robot"}, {true, "world", "the world frame"}}, false);
}

Fields<PoseSetup> declared() {
    Fields<PoseSetup> fields;
    fields.section("Robot")
        .add(&PoseSetup::arm, "robot", "Robot", "The arm, with its parameters and their uncertainty.")
        .choice(&PoseSetup::combine, "components", "Components of a parameter",
                "Each by itself, so that the budget tells the sources apart; or combined into one normal "
                "deviation, which needs fewer draws.",
                {{false, "separate", "each by itself"}, {true, "combined", "combined into one"}}, false)
        .choice(&PoseSetup::correlated, "correlation", "Correlation of the parameters",
                "Used as the robot states it; or ignored, as in the paper, to see what that does.",
                {{true, "used", "used"}, {false, "ignored", "ignored (the paper)"}}, true);
    add_poses(fields);
    add_results(fields);
    return fields;
}

}  // namespace

const Fields<PoseSetup>& pose_fields() {
    static const Fields<PoseSetup> fields = declared();
    return fields;
}

}  // namespace covaria::robot
