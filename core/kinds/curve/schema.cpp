// The fields of "calibration curve".
#include "core/kinds/curve/setup.h"

namespace covaria::curve {

namespace {

FieldSpec unit_of(const char* key, const char* what) {
    return {.key = key,
            .title = std::string("Unit of ") + what,
            .help = std::string("Unit in which ") + what +
                    " is given. A difference of temperatures, a correction of a thermometer too, is given "
                    "in K.",
            .default_value = std::string("1"),
            .section = "Points"};
}

Columns<StatedPoint> point_columns() {
    return Columns<StatedPoint>()
        .add(&StatedPoint::x, {.key = "x", .title = "x", .help = "Independent quantity, in its unit."})
        .add(&StatedPoint::u_x,
             {.key = "u_x",
              .title = "u_x",
              .range = {.low = 0.0},
              .optional = true,
              .help = "Standard uncertainty of x; empty: none. Used with stated uncertainties."})
        .add(&StatedPoint::y, {.key = "y", .title = "y", .help = "Observed quantity, in its unit."})
        .add(&StatedPoint::u_y,
             {.key = "u_y",
              .title = "u_y",
              .range = {.low = 0.0},
              .optional = true,
              .help = "Standard uncertainty of y. Used, and needed, with stated uncertainties."});
}

Columns<Prediction> prediction_columns() {
    return Columns<Prediction>()
        .add(&Prediction::x, {.key = "x", .title = "x", .help = "In the unit of x."})
        .add(&Prediction::name, {.key = "name",
                                 .title = "name",
                                 .optional = true,
                                 .help = "What it is, for tables and reports."});
}

Columns<Observation> inverse_columns() {
    return Columns<Observation>()
        .add(&Observation::y, {.key = "y", .title = "y", .help = "Observed, in the unit of y."})
        .add(&Observation::u_y,
             {.key = "u_y",
              .title = "u_y",
              .range = {.low = 0.0},
              .optional = true,
              .help = "Standard uncertainty of the observed y; empty: none beside that of the readings."})
        .add(&Observation::readings,
             {.key = "readings",
              .title = "readings",
              .range = {.low = 1.0},
              .optional = true,
              .help = "The observed y is the mean of so many readings, which scatter as the points of the "
                      "calibration do. With the uncertainty from the residuals only."})
        .add(
            &Observation::near,
            {.key = "near",
             .title = "near",
             .optional = true,
             .help = "Of several x that give this y, the one nearest to here, in the unit of x. Needed where "
                     "the curve reaches y more than once between its points."})
        .add(&Observation::name, {.key = "name",
                                  .title = "name",
                                  .optional = true,
                                  .help = "What it is, for tables and reports."});
}

void add_points(Fields<CurveSetup>& fields) {
    fields.add(&CurveSetup::x_unit, unit_of("x_unit", "x"))
        .add(&CurveSetup::y_unit, unit_of("y_unit", "y"))
        .table(&CurveSetup::stated_points,
               {.key = "points",
                .title = "Points",
                .help = "Points of the calibration, typed, pasted or from a CSV file.",
                .min_rows = 2,
                .section = "Points"},
               point_columns());
}

void add_curve(Fields<CurveSetup>& fields) {
    fields
        .add(&CurveSetup::degree, {.key = "degree",
                                   .title = "Degree",
                                   .help = "Of the polynomial: 1 is a straight line.",
                                   .range = {.low = 1.0, .high = double(most_coefficients - 1)},
                                   .default_value = Quantity{1.0, Unit{}},
                                   .section = "Curve"})
        .add(&CurveSetup::origin,
             {.key = "origin",
              .title = "Origin x_0",
              .help = "The polynomial is one of x - x_0, in the unit of x. In the middle of the points the "
                      "coefficients "
                      "are hardly correlated.",
              .default_value = Quantity{0.0, Unit{}},
              .section = "Curve"})
        .add(&CurveSetup::through_origin, {.key = "through_origin",
                                           .title = "Through the origin",
                                           .help = "No constant term: the curve is zero at x_0.",
                                           .default_value = false,
                                           .section = "Curve"})
        .choice(&CurveSetup::from_residuals,
                {.key = "uncertainty",
                 .title = "Uncertainty",
                 .help = "From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for "
                         "each point.",
                 .section = "Curve"},
                {{true, "residuals", "from the residuals"}, {false, "stated", "as stated for x and y"}},
                true);
}

void add_use(Fields<CurveSetup>& fields) {
    fields
        .table(&CurveSetup::predictions,
               {.key = "predictions",
                .title = "Use of the curve",
                .help = "Where the value of the curve is wanted, with its uncertainty.",
                .optional = true,
                .section = "Use"},
               prediction_columns())
        .table(&CurveSetup::observations,
               {.key = "inverse",
                .title = "Inverse use",
                .help = "Observed values of y whose x is wanted, with its uncertainty.",
                .optional = true,
                .section = "Use"},
               inverse_columns());
}

}  // namespace

const Fields<CurveSetup>& curve_fields() {
    static const Fields<CurveSetup> fields = [] {
        Fields<CurveSetup> made;
        add_points(made);
        add_curve(made);
        add_use(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::curve
