// Tables about the points of a calibration curve.
#include <cmath>

#include "core/kinds/curve/fit.h"
#include "core/kinds/groups/variance_table.h"
#include "core/math/special_quantiles.h"

namespace covaria::curve {

namespace {

Table points_table_of(const CurveSetup& setup, const Fit& fit) {
    Table points{"points", "Points and their residuals"};
    points.add("x").in(setup.x_unit).symbol();
    points.add("y").in(setup.y_unit).symbol();
    points.add("residual").in(setup.y_unit.interval()).figure(3);
    for (std::size_t i = 0; i < setup.points.size(); ++i)
        points.row({setup.points[i].x, setup.points[i].y, fit.residuals[i]});
    return points;
}

void judge_stated(const CurveSetup& setup, const Fit& fit, Table& summary) {
    const double nu = setup.degrees_of_freedom();
    const double limit = chi_squared_quantile(0.95, nu);
    summary.row({tell<"chi-squared">(), fit.chi_squared});
    summary.row({tell<"its 95 % quantile">(), limit});
    summary.notes.push_back(
        fit.chi_squared <= limit
            ? tell<"The residuals agree with the stated uncertainties.">()
            : tell<"The residuals are larger than the stated uncertainties explain: the curve or the "
                   "uncertainties do not describe these points.">());
}

Table fit_table_of(const CurveSetup& setup, const Fit& fit) {
    Table summary{"fit", "Fit"};
    summary.add("quantity");
    summary.add("value").figure(4);
    const Unit unit = setup.y_unit.interval();
    const double nu = setup.degrees_of_freedom();
    if (nu > 0.0)
        summary.row({tell<"standard deviation of the residuals">(),
                     Quantity{unit.interval_from_si(fit.standard_deviation), unit}});
    summary.row({tell<"degrees of freedom">(), nu});
    if (setup.from_residuals)
        summary.row({tell<"coefficient of determination R²">(),
                     fit.sum_of_squares_regression / (fit.sum_of_squares_regression + fit.sum_of_squares)});
    else if (nu > 0.0)
        judge_stated(setup, fit, summary);
    return summary;
}

Table inverse_table_of(const CurveSetup& setup, const Fit& fit, const std::vector<InversePlace>& inverse) {
    Table table{"inverse", "Inverse use"};
    table.add("y").in(setup.y_unit).symbol();
    table.add("x").in(setup.x_unit).symbol();
    table.add(known_text<"also reached at x">());
    for (std::size_t i = 0; i < inverse.size(); ++i) {
        std::string others;
        for (const double x : inverse[i].others)
            others += (others.empty() ? "" : ", ") + place_text(setup.x_unit, x);
        table.row({setup.observations[i].y, fit.polynomials.x_of(inverse[i].t), others});
        if (inverse[i].outside)
            table.notes.push_back(tell<"The x of y = %1 lies outside of the points of the calibration.">(
                place_text(setup.y_unit, setup.observations[i].y)));
    }
    return table;
}

}  // namespace

std::vector<Table> curve_evaluation(const CurveSetup& setup, const Fit& fit,
                                    const std::vector<InversePlace>& inverse) {
    std::vector<Table> tables{points_table_of(setup, fit), fit_table_of(setup, fit)};
    if (setup.from_residuals)
        tables.push_back(
            variance_table("variance", "Analysis of variance of the fit", setup.y_unit.interval(),
                           {tell<"curve">(), fit.sum_of_squares_regression, double(setup.degree)},
                           {tell<"residuals">(), fit.sum_of_squares, setup.degrees_of_freedom()}));
    if (!inverse.empty()) tables.push_back(inverse_table_of(setup, fit, inverse));
    return tables;
}

}  // namespace covaria::curve
