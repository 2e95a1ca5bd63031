// The fields of "calibration curve".
#include "core/kinds/curve/setup.h"

namespace covaria::curve {

namespace {

FieldSpec unit_field(const char* key, const char* of) {
    return {
        .key = key,
        .title = std::string("Unit of ") + of,
        .kind = FieldKind::text,
        .help = std::string("Unit in which ") + of +
                " is given. A difference of temperatures, a correction of a thermometer too, is given in K.",
        .default_value = std::string("1"),
        .section = "Points"};
}

FieldSpec points_table() {
    FieldSpec table{.key = "points",
                    .title = "Points",
                    .kind = FieldKind::table,
                    .help = "Points of the calibration, typed, pasted or from a CSV file.",
                    .min_rows = 2,
                    .section = "Points"};
    table.columns = {{.key = "x", .title = "x", .help = "Independent quantity, in its unit."},
                     {.key = "u_x",
                      .title = "u_x",
                      .range = {.low = 0.0},
                      .optional = true,
                      .help = "Standard uncertainty of x; empty: none. Used with stated uncertainties."},
                     {.key = "y", .title = "y", .help = "Observed quantity, in its unit."},
                     {.key = "u_y",
                      .title = "u_y",
                      .range = {.low = 0.0},
                      .optional = true,
                      .help = "Standard uncertainty of y. Used, and needed, with stated uncertainties."}};
    return table;
}

FieldSpec predictions_table() {
    FieldSpec table{.key = "predictions",
                    .title = "Use of the curve",
                    .kind = FieldKind::table,
                    .help = "Where the value of the curve is wanted, with its uncertainty.",
                    .optional = true,
                    .section = "Use"};
    table.columns = {{.key = "x", .title = "x", .help = "In the unit of x."},
                     {.key = "name",
                      .title = "name",
                      .kind = FieldKind::text,
                      .optional = true,
                      .help = "What it is, for tables and reports."}};
    return table;
}

FieldSpec inverse_table() {
    FieldSpec table{.key = "inverse",
                    .title = "Inverse use",
                    .kind = FieldKind::table,
                    .help = "Observed values of y whose x is wanted, with its uncertainty.",
                    .optional = true,
                    .section = "Use"};
    table.columns = {
        {.key = "y", .title = "y", .help = "Observed, in the unit of y."},
        {.key = "u_y",
         .title = "u_y",
         .range = {.low = 0.0},
         .optional = true,
         .help = "Standard uncertainty of the observed y; empty: none beside that of the readings."},
        {.key = "readings",
         .title = "readings",
         .kind = FieldKind::integer,
         .range = {.low = 1.0},
         .optional = true,
         .help = "The observed y is the mean of so many readings, which scatter as the points of the "
                 "calibration do. With the uncertainty from the residuals only."},
        {.key = "near",
         .title = "near",
         .optional = true,
         .help = "Of several x that give this y, the one nearest to here, in the unit of x. Needed where the "
                 "curve reaches y more than once between its points."},
        {.key = "name",
         .title = "name",
         .kind = FieldKind::text,
         .optional = true,
         .help = "What it is, for tables and reports."}};
    return table;
}

}  // namespace

SetupSchema curve_schema() {
    return SetupSchema(
        {unit_field("x_unit", "x"),
         unit_field("y_unit", "y"),
         points_table(),
         {.key = "degree",
          .title = "Degree",
          .kind = FieldKind::integer,
          .help = "Of the polynomial: 1 is a straight line.",
          .range = {.low = 1.0, .high = double(most_coefficients - 1)},
          .default_value = Quantity{1.0, Unit{}},
          .section = "Curve"},
         {.key = "origin",
          .title = "Origin x_0",
          .kind = FieldKind::number,
          .help = "The polynomial is one of x - x_0, in the unit of x. In the middle of the points the "
                  "coefficients "
                  "are hardly correlated.",
          .default_value = Quantity{0.0, Unit{}},
          .section = "Curve"},
         {.key = "through_origin",
          .title = "Through the origin",
          .kind = FieldKind::flag,
          .help = "No constant term: the curve is zero at x_0.",
          .default_value = false,
          .section = "Curve"},
         {.key = "uncertainty",
          .title = "Uncertainty",
          .kind = FieldKind::choice,
          .help = "From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for each "
                  "point.",
          .default_value = std::string("residuals"),
          .choices = {{"residuals", "from the residuals"}, {"stated", "as stated for x and y"}},
          .section = "Curve"},
         predictions_table(),
         inverse_table()});
}

}  // namespace covaria::curve
