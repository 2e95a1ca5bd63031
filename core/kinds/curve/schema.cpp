// The fields of "calibration curve".
#include "core/kinds/curve/setup.h"
#include "core/kinds/points/component_evidence.h"

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
        .add(&StatedPoint::x, "x", "x", "Independent quantity, in its unit.")
        .add(&StatedPoint::u_x, "u_x", "u_x",
             "Standard uncertainty of x; empty: none. Used with stated uncertainties.",
             {.range = {.low = 0.0}, .optional = true})
        .add(&StatedPoint::y, "y", "y", "Observed quantity, in its unit.")
        .add(&StatedPoint::u_y, "u_y", "u_y",
             "Standard uncertainty of y. Used, and needed, with stated uncertainties.",
             {.range = {.low = 0.0}, .optional = true});
}

Columns<StatedCorrelation> correlation_columns() {
    return Columns<StatedCorrelation>()
        .add(&StatedCorrelation::first, "first", "first",
             "A coordinate of a point by its number: y_1 is the y of the first point.")
        .add(&StatedCorrelation::second, "second", "second",
             "Another one: y_2, or the x_1 of the same point.")
        .add(&StatedCorrelation::coefficient, "coefficient", "coefficient",
             "Correlation coefficient of their stated uncertainties.", {.range = {.low = -1.0, .high = 1.0}});
}

Columns<Prediction> prediction_columns() {
    return Columns<Prediction>()
        .add(&Prediction::x, "x", "x", "In the unit of x.")
        .add(&Prediction::name, "name", "name", "What it is, for tables and reports.", {.optional = true});
}

Columns<Observation> inverse_columns() {
    return Columns<Observation>()
        .add(&Observation::y, "y", "y", "Observed, in the unit of y.")
        .add(&Observation::u_y, "u_y", "u_y",
             "Standard uncertainty of the observed y; empty: none beside that of the readings.",
             {.range = {.low = 0.0}, .optional = true})
        .add(&Observation::readings, "readings", "readings",
             "The observed y is the mean of so many readings, which scatter as the points of the "
             "calibration do. With the uncertainty from the residuals only.",
             {.range = {.low = 1.0}, .optional = true})
        .add(&Observation::near, "near", "near",
             "Of several x that give this y, the one nearest to here, in the unit of x. Needed where "
             "the curve reaches y more than once between its points.",
             {.optional = true})
        .add(&Observation::name, "name", "name", "What it is, for tables and reports.", {.optional = true});
}

void add_points(Fields<CurveSetup>& fields) {
    fields.add(&CurveSetup::x_unit, unit_of("x_unit", "x"))
        .add(&CurveSetup::y_unit, unit_of("y_unit", "y"))
        .section("Points")
        .table(&CurveSetup::stated_points, "points", "Points",
               "Points of the calibration, typed, pasted or from a CSV file.", point_columns(),
               {.min_rows = 2, .measured = true});
}

void add_covariance(Fields<CurveSetup>& fields) {
    fields.section("Covariance of the points")
        .add(&CurveSetup::common_u_x, "common_u_x", "Common u of x",
             "Standard uncertainty of a deviation that all x share beside their own (one standard, one "
             "temperature), in the unit of x. Used with stated uncertainties, in the weights too.",
             {.range = {.low = 0.0}, .default_value = Quantity{0.0, Unit{}}})
        .add(&CurveSetup::common_u_y, "common_u_y", "Common u of y", "Likewise of all y, in the unit of y.",
             {.range = {.low = 0.0}, .default_value = Quantity{0.0, Unit{}}})
        .table(&CurveSetup::correlations, "correlations", "Correlations of the points",
               "Correlation coefficients between coordinates of the points (ISO/TS 28037): they change the "
               "curve, which minimises v^T V^-1 v, and its uncertainty. Used with stated uncertainties.",
               correlation_columns(), {.optional = true});
}

void add_curve(Fields<CurveSetup>& fields) {
    fields.section("Curve")
        .add(&CurveSetup::degree, "degree", "Degree", "Of the polynomial: 1 is a straight line.",
             {.range = {.low = 1.0, .high = double(most_coefficients - 1)},
              .default_value = Quantity{1.0, Unit{}}})
        .add(&CurveSetup::origin, "origin", "Origin x_0",
             "The polynomial is one of x - x_0, in the unit of x. In the middle of the points the "
             "coefficients "
             "are hardly correlated.",
             {.default_value = Quantity{0.0, Unit{}}})
        .add(&CurveSetup::through_origin, "through_origin", "Through the origin",
             "No constant term: the curve is zero at x_0.", {.default_value = false})
        .choice(&CurveSetup::from_residuals, "uncertainty", "Uncertainty",
                "From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for "
                "each point.",
                {{true, "residuals", "from the residuals"}, {false, "stated", "as stated for x and y"}}, true)
        .choice(
            &CurveSetup::uncertainties, uncertainties_key, "Uncertainties of the points",
            "Stated ones weigh the points and are used as they are; or they are used as the residuals see "
            "them: times one common factor, or times one of x and one of y. Either has the degrees of "
            "freedom of its estimate. What all points share stays as stated.",
            choices_of_uncertainties(), evidence::UncertaintiesFrom::stated)
        .shown_where(&CurveSetup::from_residuals, {false}, &CurveSetup::uncertainties);
}

void add_use(Fields<CurveSetup>& fields) {
    fields.section("Use")
        .table(&CurveSetup::predictions, "predictions", "Use of the curve",
               "Where the value of the curve is wanted, with its uncertainty.", prediction_columns(),
               {.optional = true})
        .table(&CurveSetup::observations, "inverse", "Inverse use",
               "Observed values of y whose x is wanted, with its uncertainty.", inverse_columns(),
               {.optional = true, .measured = true});
}

}  // namespace

const Fields<CurveSetup>& curve_fields() {
    static const Fields<CurveSetup> fields = [] {
        Fields<CurveSetup> made;
        add_points(made);
        add_curve(made);
        add_covariance(made);
        add_use(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::curve
