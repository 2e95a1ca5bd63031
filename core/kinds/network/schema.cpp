// Fields of "points from sensors".
#include "core/kinds/instruments/sensor.h"
#include "core/kinds/network/setup.h"
#include "core/kinds/points/stated_figure.h"

namespace covaria::network {

namespace {

FieldSpec sensors_table() {
    FieldSpec table{
        .key = "sensors",
        .title = "Sensors",
        .kind = FieldKind::table,
        .help = "The instruments of the network, each an instrument of the project that stands somewhere.",
        .min_rows = 1,
        .section = "Network"};
    table.columns = {{.key = "sensor",
                      .title = "sensor",
                      .kind = FieldKind::reference,
                      .help = "An instrument of the project.",
                      .capabilities = {SensorSource::capability}}};
    return table;
}

FieldSpec targets_table() {
    const Unit mm = Unit::of("mm");
    FieldSpec table{.key = "targets",
                    .title = "Targets",
                    .kind = FieldKind::table,
                    .help = "Points to be localised, at their nominal coordinates.",
                    .min_rows = 1,
                    .section = "Network"};
    table.columns = {
        {.key = "name", .title = "name", .kind = FieldKind::text, .help = "Name of the target, unique."},
        {.key = "x", .title = "x", .unit = mm, .help = "Nominal coordinate x."},
        {.key = "y", .title = "y", .unit = mm, .help = "Nominal coordinate y."},
        {.key = "z", .title = "z", .unit = mm, .help = "Nominal coordinate z."},
        {.key = "new_set_up",
         .title = "new set-up",
         .kind = FieldKind::flag,
         .optional = true,
         .help =
             "The sensors were located anew before this target: it and those below share the deviations of "
             "the stations with each other, not with the targets above."}};
    return table;
}

FieldSpec distances_table() {
    FieldSpec table{.key = "distances",
                    .title = "Distances",
                    .kind = FieldKind::table,
                    .help = "Distances between targets that are measurands too, for instance of a scale bar.",
                    .optional = true,
                    .section = "Network"};
    table.columns = {
        {.key = "from", .title = "from", .kind = FieldKind::text, .help = "Name of a target."},
        {.key = "to", .title = "to", .kind = FieldKind::text, .help = "Name of another target."}};
    return table;
}

FieldSpec scale_bars_table() {
    const Unit mm = Unit::of("mm");
    FieldSpec table{.key = "scale_bars",
                    .title = "Calibrated lengths",
                    .kind = FieldKind::table,
                    .help =
                        "Scale bars and other calibrated distances between two targets: compared with the "
                        "network, or a constraint of the estimation.",
                    .optional = true,
                    .section = "Network"};
    table.columns = {
        {.key = "from", .title = "from", .kind = FieldKind::text, .help = "Name of a target."},
        {.key = "to", .title = "to", .kind = FieldKind::text, .help = "Name of another target."},
        {.key = "length",
         .title = "length",
         .unit = mm,
         .range = {.low = 0.0, .low_open = true},
         .optional = true,
         .help = "Calibrated length; empty in a design: the distance of the nominal targets."},
        {.key = "u",
         .title = "u",
         .unit = mm,
         .range = {.low = 0.0, .low_open = true},
         .help = "Standard uncertainty of the length as it is during the measurement, with temperature."},
        {.key = "role",
         .title = "role",
         .kind = FieldKind::choice,
         .choices = {{"check", "check"}, {"constraint", "constraint"}},
         .help = "Check: the difference between network and calibration is a measurand. Constraint: the "
                 "length is adjusted with the readings."},
        distribution_column()};
    return table;
}

ColumnSpec target_column(const char* key, const char* title, const char* help) {
    return {.key = key, .title = title, .kind = FieldKind::text, .help = help};
}

FieldSpec angles_table() {
    FieldSpec table{.key = "angles",
                    .title = "Angles",
                    .kind = FieldKind::table,
                    .help = "Angles at a target between the directions to two others, measurands too.",
                    .optional = true,
                    .section = "Network"};
    table.columns = {target_column("from", "from", "Name of a target."),
                     target_column("at", "at", "Name of the target where the angle is."),
                     target_column("to", "to", "Name of a third target.")};
    return table;
}

FieldSpec frames_table() {
    FieldSpec table{.key = "frames",
                    .title = "Frames",
                    .kind = FieldKind::table,
                    .help =
                        "Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world "
                        "are measurands too.",
                    .optional = true,
                    .section = "Network"};
    table.columns = {target_column("name", "name", "Name of the frame, unique."),
                     target_column("origin", "origin", "Target at its origin."),
                     target_column("on_x", "on x", "Target on its positive x-axis."),
                     target_column("in_xy", "in xy", "Target in its xy-plane, at positive y.")};
    return table;
}

FieldSpec readings_table() {
    FieldSpec table{.key = "readings",
                    .title = "Readings",
                    .kind = FieldKind::table,
                    .help =
                        "What the sensors read, one row for a sensor and a target, typed or from a CSV file; "
                        "leave empty what was not read.",
                    .optional = true,
                    .shown_if = Condition{"evaluation", {"a-posteriori"}},
                    .section = "Readings"};
    table.columns = {
        {.key = "target", .title = "target", .kind = FieldKind::text, .help = "Name of the target."},
        {.key = "sensor",
         .title = "sensor",
         .kind = FieldKind::reference,
         .help = "The instrument that read it.",
         .capabilities = {SensorSource::capability}},
        {.key = "distance",
         .title = "distance",
         .unit = Unit::of("mm"),
         .optional = true,
         .help = "Slope distance."},
        {.key = "azimuth",
         .title = "azimuth",
         .unit = Unit::of("rad"),
         .optional = true,
         .help = "Horizontal angle from the sensor's x-axis, positive towards y; whole turns do not matter."},
        {.key = "elevation",
         .title = "elevation",
         .unit = Unit::of("rad"),
         .optional = true,
         .help = "Vertical angle above the sensor's xy-plane."}};
    return table;
}

}  // namespace

SetupSchema network_schema() {
    return SetupSchema(
        {sensors_table(),
         targets_table(),
         distances_table(),
         angles_table(),
         frames_table(),
         scale_bars_table(),
         {.key = "evaluation",
          .title = "Evaluation",
          .kind = FieldKind::choice,
          .help = "A priori: the readings are those of the nominal targets. A posteriori: the "
                  "readings are given.",
          .default_value = std::string("a-priori"),
          .choices = {{"a-priori", "a priori (design: nominal targets)"},
                      {"a-posteriori", "a posteriori (given readings)"}},
          .section = "Readings"},
         readings_table(),
         {.key = "estimator",
          .title = "Estimator",
          .kind = FieldKind::choice,
          .help = "How a target's coordinates follow from its readings.",
          .default_value = std::string("nonlinear"),
          .choices = {{"nonlinear", "non-linear weighted least squares"},
                      {"linear", "linearised equations: OLS, then GLS (Eqs 1-4 of the paper)"},
                      {"linear-start", "linearised equations: OLS alone (Eq 3 of the paper)"}},
          .section = "Estimation"},
         {.key = "weights",
          .title = "Weights",
          .kind = FieldKind::choice,
          .help = "What the weights of the equations account for. Weights from the readings "
                  "alone, as in the paper, "
                  "are not the best where the stations are uncertain.",
          .default_value = std::string("with-stations"),
          .choices = {{"with-stations", "readings and stations, all targets of a set-up at once"},
                      {"observations", "readings alone, each target by itself (the paper)"}},
          .shown_if = Condition{"estimator", {"nonlinear"}},
          .section = "Estimation"}});
}

}  // namespace covaria::network
