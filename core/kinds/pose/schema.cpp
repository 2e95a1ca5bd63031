// The fields of "pose from points".
#include "core/kinds/points/point_uncertainty.h"
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
    std::string third_point_default;
    std::string common_to;
};

const Words base_words{Side::base,    "base frame b", "Base frame",
                       "Base points", "negative-y",   "all base points"};
const Words moving_words{Side::moving,   "moving frame p",
                         "Moving frame", "Points of the moving frame",
                         "positive-y",   "all points of the moving frame, in all poses"};

ColumnSpec text_column(const char* key, const char* help) {
    return {.key = key, .title = key, .kind = FieldKind::text, .help = help};
}

ColumnSpec number_column(const char* key, const Unit& unit, const char* help) {
    return {.key = key, .title = key, .unit = unit, .help = help};
}

ColumnSpec uncertainty_column(const char* key, const char* help) {
    return {.key = key, .title = key, .unit = mm, .range = {.low = 0.0}, .optional = true, .help = help};
}

FieldSpec points_field(const Words& words) {
    FieldSpec field{.key = prefix_of(words.side) + "_points",
                    .title = words.points,
                    .kind = FieldKind::table,
                    .help =
                        "Nominal coordinates of the points in their own frame, and standard uncertainties of "
                        "single coordinates where they differ from the common ones.",
                    .min_rows = 3,
                    .section = words.section};
    field.columns = {text_column("name", "Name of the point."),
                     number_column("x", mm, "Nominal coordinate x in the point's own frame."),
                     number_column("y", mm, "Nominal coordinate y in the point's own frame."),
                     number_column("z", mm, "Nominal coordinate z in the point's own frame."),
                     uncertainty_column("u_x", "Standard uncertainty of this x; empty: as typed for all."),
                     uncertainty_column("u_y", "Standard uncertainty of this y; empty: as typed for all."),
                     uncertainty_column("u_z", "Standard uncertainty of this z; empty: as typed for all.")};
    return field;
}

std::vector<FieldSpec> frame_fields(const Words& words) {
    const std::string prefix = prefix_of(words.side);
    const Condition by_3_2_1{prefix + "_fit", {"three-two-one"}};
    std::vector<FieldSpec> fields{
        points_field(words),
        {.key = prefix + "_fit",
         .title = "Frame from its points",
         .kind = FieldKind::choice,
         .help =
             "3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points 1, 2 "
             "and 3. Least squares: the frame in which the nominal coordinates fit all points best.",
         .default_value = std::string("three-two-one"),
         .choices = {{"three-two-one", "3-2-1"}, {"least-squares", "least squares"}},
         .section = words.section},
        {.key = prefix + "_third_point",
         .title = "Side of point 3",
         .kind = FieldKind::choice,
         .help = "On which side of the x-axis point 3 lies in the " + words.frame + "; this directs z.",
         .default_value = words.third_point_default,
         .choices = {{"negative-y", "negative y: z = (q3 − q1) × x"},
                     {"positive-y", "positive y: z = x × (q3 − q1)"}},
         .shown_if = by_3_2_1,
         .section = words.section}};
    for (const std::string axis : {"x", "y", "z"})
        fields.push_back({.key = prefix + "_shift_" + axis,
                          .title = "Origin from point 1, " + axis,
                          .help = "Position of the origin from point 1 along " + axis + " of the " +
                                  words.frame + " (s of Eqs 17 and 18).",
                          .unit = mm,
                          .default_value = Quantity{0.0, mm},
                          .shown_if = by_3_2_1,
                          .section = words.section});
    return fields;
}

std::vector<FieldSpec> uncertainty_fields(const Words& words) {
    const std::string prefix = prefix_of(words.side);
    const std::string section = "Uncertainty: " + words.section;
    const Condition typed{prefix + "_uncertainty", {"typed"}};
    std::vector<FieldSpec> fields{{.key = prefix + "_uncertainty",
                                   .title = "Uncertainty of the points",
                                   .kind = FieldKind::choice,
                                   .help =
                                       "Standard uncertainties typed here, or those that an artefact or an "
                                       "instrument of the project gives.",
                                   .default_value = std::string("typed"),
                                   .choices = {{"typed", "typed"}, {"asset", "artefact or instrument"}},
                                   .section = section}};
    for (const std::string axis : {"x", "y", "z"}) {
        fields.push_back({.key = prefix + "_u_" + axis,
                          .title = "u_" + axis,
                          .help = "Standard uncertainty of the points' coordinates along " + axis +
                                  " of the " + words.frame + ".",
                          .unit = mm,
                          .range = {.low = 0.0},
                          .default_value = Quantity{0.0, mm},
                          .shown_if = typed,
                          .section = section});
        fields.push_back({.key = prefix + "_common_" + axis,
                          .title = "u_" + axis + " is common",
                          .kind = FieldKind::flag,
                          .help = "One and the same deviation along " + axis + " for " + words.common_to +
                                  ", instead of independent ones.",
                          .default_value = false,
                          .shown_if = typed,
                          .section = section});
    }
    FieldSpec distribution =
        distribution_field(prefix + "_distribution", "typed deviations of the points", section);
    distribution.shown_if = typed;
    fields.push_back(distribution);
    fields.push_back(
        {.key = prefix + "_asset",
         .title = "Artefact or instrument",
         .kind = FieldKind::reference,
         .help = "Gives the uncertainty of the coordinates of the points of the " + words.frame + ".",
         .capabilities = {PointUncertaintySource::capability},
         .shown_if = Condition{prefix + "_uncertainty", {"asset"}},
         .section = section});
    return fields;
}

std::vector<FieldSpec> evaluation_fields() {
    FieldSpec poses{.key = "poses",
                    .title = "Poses",
                    .kind = FieldKind::table,
                    .help =
                        "Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) "
                        "Rx(α). All poses share the measurement of the base.",
                    .min_rows = 1,
                    .section = "Poses"};
    poses.columns = {text_column("name", "Name of the pose; groups its results."),
                     number_column("x", mm, "Position x in the base frame."),
                     number_column("y", mm, "Position y in the base frame."),
                     number_column("z", mm, "Position z in the base frame."),
                     number_column("alpha", deg, "Rotation about x."),
                     number_column("beta", deg, "Rotation about y."),
                     number_column("gamma", deg, "Rotation about z.")};
    FieldSpec measured{
        .key = "measured_points",
        .title = "Measured points",
        .kind = FieldKind::table,
        .help =
            "Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; "
            "the mean of the repeats is the estimate.",
        .optional = true,
        .shown_if = Condition{"evaluation", {"a-posteriori"}},
        .section = "Poses"};
    measured.columns = {
        text_column("set", "\"base\", or the name of a pose."),
        text_column("point", "Name of the point."),
        {.key = "repeat", .title = "repeat", .kind = FieldKind::integer, .help = "Number of the repetition."},
        number_column("x", mm, "Measured coordinate x in frame 0."),
        number_column("y", mm, "Measured coordinate y in frame 0."),
        number_column("z", mm, "Measured coordinate z in frame 0.")};
    return {poses, measured};
}

FieldSpec evaluation_field() {
    return {
        .key = "evaluation",
        .title = "Evaluation",
        .kind = FieldKind::choice,
        .help = "A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.",
        .default_value = std::string("a-priori"),
        .choices = {{"a-priori", "a priori (nominal poses)"},
                    {"a-posteriori", "a posteriori (measured points)"}},
        .section = "Poses"};
}

FieldSpec orientation_field() {
    FieldSpec field{.key = "orientation",
                    .title = "Orientation stated as",
                    .kind = FieldKind::choice,
                    .help =
                        "Numbers in which the result states the orientation of the moving frame. Angles are "
                        "undefined in gimbal lock; rotation vector and quaternion are not.",
                    .default_value = std::string("zyx"),
                    .section = "Poses"};
    for (const RotationConventionInfo& info : rotation_conventions())
        field.choices.push_back({std::string(info.key), std::string(info.title)});
    return field;
}

FieldSpec uncertainty_axes_field() {
    return {
        .key = "moving_uncertainty_axes",
        .title = "Uncertainties along",
        .kind = FieldKind::choice,
        .help =
            "Along which axes the typed uncertainties of the moving points lie: those of the moving frame, "
            "which turn with it, or those of the base frame, the same in all poses.",
        .default_value = std::string("own"),
        .choices = {{"own", "the axes of the moving frame"}, {"base", "the axes of the base frame"}},
        .shown_if = Condition{"moving_uncertainty", {"typed"}},
        .section = "Uncertainty: " + moving_words.section};
}

FieldSpec base_pose_field() {
    return {.key = "base_pose",
            .title = "Pose of the base in frame 0",
            .kind = FieldKind::pose,
            .help =
                "Where the base stands in the frame of the measurement (frame 0, the world of the picture). "
                "It matters only for an instrument that stands somewhere.",
            .default_value = PoseValue{},
            .shown_if = Condition{"evaluation", {"a-priori"}},
            .section = "Base frame"};
}

}  // namespace

std::string prefix_of(Side side) {
    return side == Side::base ? "base" : "moving";
}

std::string letter_of(Side side) {
    return side == Side::base ? "b" : "p";
}

SetupSchema pose_schema() {
    std::vector<FieldSpec> fields = frame_fields(base_words);
    fields.push_back(base_pose_field());
    const auto append = [&](const std::vector<FieldSpec>& more) {
        fields.insert(fields.end(), more.begin(), more.end());
    };
    append(frame_fields(moving_words));
    fields.push_back(evaluation_field());
    append(evaluation_fields());
    fields.push_back(orientation_field());
    append(uncertainty_fields(base_words));
    append(uncertainty_fields(moving_words));
    fields.push_back(uncertainty_axes_field());
    return SetupSchema(std::move(fields));
}

}  // namespace covaria::pose
