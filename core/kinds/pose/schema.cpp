// The fields of "pose from points".
#include "core/kinds/points/component_evidence.h"
#include "core/kinds/points/stated_figure.h"
#include "core/kinds/pose/setup.h"

namespace covaria::pose {

namespace {

const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");

// Words that differ between the two frames.
struct Words {
    Side side;
    std::string frame;    ///< "base frame b"
    std::string section;  ///< "Base frame"
    std::string points;   ///< "Base points"
    ThirdPoint third_point_default;
    std::string common_to;
};

const Words base_words{Side::base,    "base frame b",         "Base frame",
                       "Base points", ThirdPoint::negative_y, "all base points"};
const Words moving_words{Side::moving,           "moving frame p",
                         "Moving frame",         "Points of the moving frame",
                         ThirdPoint::positive_y, "all points of the moving frame, in all poses"};

Columns<NominalPoint> point_columns() {
    return Columns<NominalPoint>()
        .add(&NominalPoint::name, "name", "name", "Name of the point.")
        .each(&NominalPoint::local,
              by_axis(along_axes, "Nominal coordinate * in the point's own frame.", {.unit = mm}))
        .each(&NominalPoint::u,
              by_axis({"u_x", "u_y", "u_z"}, "Standard uncertainty of this *; empty: as typed for all.",
                      {.unit = mm, .range = {.low = 0.0}, .optional = true}));
}

Fields<FrameRule> declared_frame(const Words& words) {
    const std::string prefix = prefix_of(words.side);
    Fields<FrameRule> fields;
    fields.section(words.section)
        .table(&FrameRule::points, prefix + "_points", words.points,
               "Nominal coordinates of the points in their own frame, and standard uncertainties of "
               "single coordinates where they differ from the common ones.",
               point_columns(), {.min_rows = 3})
        .choice(&FrameRule::least_squares, prefix + "_fit", "Frame from its points",
                "3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points "
                "1, 2 "
                "and 3. Least squares: the frame in which the nominal coordinates fit all points best.",
                {{false, "three-two-one", "3-2-1"}, {true, "least-squares", "least squares"}}, false)
        .choice(&FrameRule::third_point, prefix + "_third_point", "Side of point 3",
                "On which side of the x-axis point 3 lies in the " + words.frame + "; this directs z.",
                {{ThirdPoint::negative_y, "negative-y", "negative y: z = (q3 − q1) × x"},
                 {ThirdPoint::positive_y, "positive-y", "positive y: z = x × (q3 − q1)"}},
                words.third_point_default);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string axis = along_axes[i];
        fields.element(&FrameRule::shift, i,
                       {.key = prefix + "_shift_" + axis,
                        .title = "Origin from point 1, " + axis,
                        .help = "Position of the origin from point 1 along " + axis + " of the " +
                                words.frame + " (s of Eqs 17 and 18).",
                        .unit = mm,
                        .default_value = Quantity{0.0, mm}});
    }
    fields.shown_where(&FrameRule::least_squares, {false}, &FrameRule::third_point, &FrameRule::shift);
    return fields;
}

void add_typed(Fields<UncertaintyRule>& fields, const Words& words) {
    const std::string prefix = prefix_of(words.side);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string axis = along_axes[i];
        fields
            .element(&UncertaintyRule::u, i,
                     {.key = prefix + "_u_" + axis,
                      .title = "u_" + axis,
                      .help = "Standard uncertainty of the points' coordinates along " + axis + " of the " +
                              words.frame + ".",
                      .unit = mm,
                      .range = {.low = 0.0},
                      .default_value = Quantity{0.0, mm}})
            .element(&UncertaintyRule::common, i,
                     {.key = prefix + "_common_" + axis,
                      .title = "u_" + axis + " is common",
                      .help = "One and the same deviation along " + axis + " for " + words.common_to +
                              ", instead of independent ones.",
                      .default_value = false});
    }
}

Fields<UncertaintyRule> declared_uncertainty(const Words& words) {
    const std::string prefix = prefix_of(words.side);
    const std::string section = "Uncertainty: " + words.section;
    Fields<UncertaintyRule> fields;
    fields.section(section).choice(
        &UncertaintyRule::typed, prefix + "_uncertainty", "Uncertainty of the points",
        "Standard uncertainties typed here, or those that an artefact or an instrument of the project "
        "gives.",
        {{true, "typed", "typed"}, {false, "asset", "artefact or instrument"}}, true);
    add_typed(fields, words);
    fields
        .add(&UncertaintyRule::distribution,
             distribution_field(prefix + "_distribution", "typed deviations of the points", section))
        .add(&UncertaintyRule::source, prefix + "_asset", "Artefact or instrument",
             "Gives the uncertainty of the coordinates of the points of the " + words.frame + ".");
    if (words.side == Side::moving)
        fields
            .choice(&UncertaintyRule::along_base, prefix + "_uncertainty_axes", "Uncertainties along",
                    "Along which axes the typed uncertainties of the moving points lie: those of the moving "
                    "frame, "
                    "which turn with it, or those of the base frame, the same in all poses.",
                    {{false, "own", "the axes of the moving frame"},
                     {true, "base", "the axes of the base frame"}},
                    false)
            .shown_where(&UncertaintyRule::typed, {true}, &UncertaintyRule::along_base);
    fields
        .shown_where(&UncertaintyRule::typed, {true}, &UncertaintyRule::u, &UncertaintyRule::common,
                     &UncertaintyRule::distribution)
        .shown_where(&UncertaintyRule::typed, {false}, &UncertaintyRule::source);
    return fields;
}

Columns<Pose> pose_columns() {
    return Columns<Pose>()
        .add(&Pose::name, "name", "name", "Name of the pose; groups its results.")
        .each(&Pose::position, by_axis(along_axes, "Position * in the base frame.", {.unit = mm}))
        .each(&Pose::angles, by_axis(zyx_angles, "Rotation about *.", {.unit = deg}));
}

Columns<Repeat> repeat_columns() {
    return Columns<Repeat>()
        .add(&Repeat::set, "set", "set", "\"base\", or the name of a pose.")
        .add(&Repeat::point, "point", "point", "Name of the point.")
        .add(&Repeat::number, "repeat", "repeat", "Number of the repetition.")
        .each(&Repeat::p_0, by_axis(along_axes, "Measured coordinate * in frame 0.", {.unit = mm}));
}

void add_poses(Fields<PoseSetup>& fields) {
    std::vector<ChoiceOf<RotationConvention>> orientations;
    for (const RotationConventionInfo& info : rotation_conventions())
        orientations.push_back({info.convention, info.key.data(), std::string(info.title)});
    fields.section("Poses")
        .choice(&PoseSetup::a_posteriori, "evaluation", "Evaluation",
                "A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.",
                {{false, "a-priori", "a priori (nominal poses)"},
                 {true, "a-posteriori", "a posteriori (measured points)"}},
                false)
        .table(&PoseSetup::poses, "poses", "Poses",
               "Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) "
               "Rx(α). All poses share the measurement of the base.",
               pose_columns(), {.min_rows = 1})
        .table(&PoseSetup::measured, "measured_points", "Measured points",
               "Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; "
               "the mean of the repeats is the estimate.",
               repeat_columns(), {.optional = true, .measured = true})
        .choice(&PoseSetup::orientation, "orientation", "Orientation stated as",
                "Numbers in which the result states the orientation of the moving frame. Angles are "
                "undefined in gimbal lock; rotation vector and quaternion are not.",
                orientations, RotationConvention::zyx)
        .choice(&PoseSetup::uncertainties, uncertainties_key, "Uncertainties of the points are used",
                "As stated; or as the residuals of least-squares frames see them: stated ones times one "
                "common factor, or times the factor of each figure (variance components). Either has the "
                "degrees of freedom of its estimate. What all points share stays as stated.",
                choices_of_uncertainties(), evidence::UncertaintiesFrom::stated)
        .shown_where(&PoseSetup::a_posteriori, {true}, &PoseSetup::measured, &PoseSetup::uncertainties)
        .shown_where(&PoseSetup::a_posteriori, {false}, &PoseSetup::X_0b);
}

Fields<PoseSetup> declared() {
    Fields<PoseSetup> fields;
    fields.part(&PoseSetup::base, frame_fields(Side::base))
        .section(base_words.section)
        .add(&PoseSetup::X_0b, "base_pose", "Pose of the base in frame 0",
             "Where the base stands in the frame of the measurement (frame 0, the world of the picture). "
             "It matters only for an instrument that stands somewhere.",
             {.default_value = PoseValue{}})
        .part(&PoseSetup::moving, frame_fields(Side::moving));
    add_poses(fields);
    return fields.part(&PoseSetup::base_uncertainty, uncertainty_fields(Side::base))
        .part(&PoseSetup::moving_uncertainty, uncertainty_fields(Side::moving));
}

}  // namespace

std::string prefix_of(Side side) {
    return side == Side::base ? "base" : "moving";
}

std::string letter_of(Side side) {
    return side == Side::base ? "b" : "p";
}

const Fields<FrameRule>& frame_fields(Side side) {
    static const Fields<FrameRule> base = declared_frame(base_words), moving = declared_frame(moving_words);
    return side == Side::base ? base : moving;
}

const Fields<UncertaintyRule>& uncertainty_fields(Side side) {
    static const Fields<UncertaintyRule> base = declared_uncertainty(base_words),
                                         moving = declared_uncertainty(moving_words);
    return side == Side::base ? base : moving;
}

const Fields<PoseSetup>& pose_fields() {
    static const Fields<PoseSetup> fields = declared();
    return fields;
}

}  // namespace covaria::pose
