// Reads the set-up of "calibration curve" and fits the curve once.
#include "core/models/curve_setup.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/special_quantiles.h"
#include "core/models/curve_equations.h"

namespace covaria::curve {

namespace {

class CurveReader {
public:
    CurveReader(const SetupReader& reader, Problems& problems) : reader_(reader), problems_(problems) {}

    std::optional<CurveSetup> run() {
        setup_.x_unit = unit("x_unit");
        setup_.y_unit = unit("y_unit");
        setup_.coefficients = static_cast<std::size_t>(reader_.integer("degree")) + 1;
        setup_.from_residuals = reader_.text("uncertainty") == "residuals";
        setup_.origin = setup_.x_unit.to_si(reader_.number("origin"));
        for (std::size_t row = 0; row < reader_.rows("points"); ++row) read_point(row);
        for (std::size_t row = 0; row < reader_.rows("predictions"); ++row)
            setup_.predictions.push_back({reader_.cell_empty("predictions", row, "name")
                                              ? ""
                                              : reader_.cell_text("predictions", row, "name"),
                                          setup_.x_unit.to_si(reader_.cell_number("predictions", row, "x"))});
        check();
        if (problems_.has_errors()) return std::nullopt;
        return std::move(setup_);
    }

private:
    Unit unit(const char* key) {
        const auto parsed = Unit::parse(reader_.text(key));
        if (!parsed) problems_.error(std::string("/") + key, parsed.error().message);
        return parsed.value_or(Unit{});
    }

    double figure(std::size_t row, const char* column, const Unit& unit) {
        const bool needed = !setup_.from_residuals && std::string(column) == "u_y";
        if (reader_.cell_empty("points", row, column)) {
            if (needed)
                problems_.error("/points/rows/" + std::to_string(row) + "/u_y",
                                "the standard uncertainty of y is missing in row " + std::to_string(row + 1));
            return 0.0;
        }
        const double u = unit.interval_to_si(reader_.cell_number("points", row, column));
        if (needed && !(u > 0.0))
            problems_.error(
                "/points/rows/" + std::to_string(row) + "/u_y",
                "the standard uncertainty of y must be greater than zero in row " + std::to_string(row + 1));
        return u;
    }

    void read_point(std::size_t row) {
        Point p;
        p.x = setup_.x_unit.to_si(reader_.cell_number("points", row, "x"));
        p.y = setup_.y_unit.to_si(reader_.cell_number("points", row, "y"));
        p.u_y = figure(row, "u_y", setup_.y_unit);
        p.u_x = figure(row, "u_x", setup_.x_unit);
        setup_.points.push_back(p);
    }

    void check() {
        if (setup_.points.size() > most_points)
            problems_.error("/points", "at most " + std::to_string(most_points) + " points can be fitted");
        std::set<double> places;
        for (const Point& p : setup_.points) places.insert(p.x);
        if (places.size() < setup_.coefficients)
            problems_.error("/points", "a polynomial of this degree needs points at " +
                                           std::to_string(setup_.coefficients) + " different places or more");
        if (setup_.from_residuals && setup_.points.size() <= setup_.coefficients)
            problems_.error("/points",
                            "residuals say nothing about the uncertainty unless there are more points than "
                            "coefficients: add points, or state u_y");
        setup_.scale = 0.0;
        for (const Point& p : setup_.points)
            setup_.scale = std::max(setup_.scale, std::abs(p.x - setup_.origin));
        if (!(setup_.scale > 0.0)) setup_.scale = 1.0;
    }

    const SetupReader& reader_;
    Problems& problems_;
    CurveSetup setup_;
};

Eigen::MatrixXd design_of(const CurveSetup& setup) {
    Eigen::MatrixXd design(setup.points.size(), setup.coefficients);
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        const double t = (setup.points[static_cast<std::size_t>(i)].x - setup.origin) / setup.scale;
        for (Eigen::Index k = 0; k < design.cols(); ++k) design(i, k) = std::pow(t, double(k));
    }
    return design;
}

}  // namespace

bool CurveSetup::has_u_x() const {
    return !from_residuals &&
           std::any_of(points.begin(), points.end(), [](const Point& p) { return p.u_x > 0.0; });
}

std::optional<CurveSetup> read_curve_setup(const SetupReader& reader, Problems& problems) {
    return CurveReader(reader, problems).run();
}

Fit fit_of(const CurveSetup& setup) {
    CurveSetup weighted = setup;
    if (setup.from_residuals)
        for (Point& p : weighted.points) p.u_y = 1.0, p.u_x = 0.0;
    const auto a = weighted_curve<double>(
        weighted, [&](std::size_t i) { return setup.points[i].x; },
        [&](std::size_t i) { return setup.points[i].y; });
    Fit fit;
    const auto n = static_cast<Eigen::Index>(setup.coefficients);
    const Eigen::MatrixXd design = design_of(setup);
    Eigen::VectorXd weights(design.rows());
    double squares = 0.0;
    for (std::size_t i = 0; i < setup.points.size(); ++i) {
        const double t = (setup.points[i].x - setup.origin) / setup.scale;
        const double slope = slope_at<double>(a, setup.coefficients, t) / setup.scale;
        const Point& p = weighted.points[i];
        weights[static_cast<Eigen::Index>(i)] = 1.0 / (p.u_y * p.u_y + slope * slope * p.u_x * p.u_x);
        fit.residuals.push_back(setup.points[i].y - polynomial_at<double>(a, setup.coefficients, t));
        squares += fit.residuals.back() * fit.residuals.back();
        fit.chi_squared +=
            fit.residuals.back() * fit.residuals.back() * weights[static_cast<Eigen::Index>(i)];
    }
    if (setup.degrees_of_freedom() > 0.0)
        fit.standard_deviation = std::sqrt(squares / setup.degrees_of_freedom());
    Eigen::MatrixXd scaling = Eigen::MatrixXd::Zero(n, n);
    fit.coefficients.resize(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        scaling(k, k) = std::pow(setup.scale, -double(k));
        fit.coefficients[k] = a[static_cast<std::size_t>(k)] * scaling(k, k);
    }
    const Eigen::MatrixXd normal = design.transpose() * weights.asDiagonal() * design;
    const double variance = setup.from_residuals ? fit.standard_deviation * fit.standard_deviation : 1.0;
    fit.covariance = variance * scaling * normal.llt().solve(Eigen::MatrixXd::Identity(n, n)) * scaling;
    return fit;
}

Unit coefficient_unit(const CurveSetup& setup, std::size_t k) {
    const std::string y = setup.y_unit.interval().text();
    if (k == 0) return setup.y_unit.interval();
    const std::string power = k == 1 ? "" : "^" + std::to_string(k);
    return Unit::parse(y + "/(" + setup.x_unit.interval().text() + ")" + power).value_or(Unit{});
}

std::vector<DataTable> curve_evaluation(const CurveSetup& setup, const Fit& fit) {
    DataTable points{"points", "Points and their residuals", {}, {}, {}};
    points.columns = {{"x", setup.x_unit, true},
                      {"y", setup.y_unit, true},
                      {"residual", setup.y_unit.interval(), false, 3}};
    for (std::size_t i = 0; i < setup.points.size(); ++i)
        points.rows.push_back({setup.points[i].x, setup.points[i].y, fit.residuals[i]});
    DataTable summary{"fit", "Fit", {{"what"}, {"value", {}, false, 4}}, {}, {}};
    const double nu = setup.degrees_of_freedom();
    summary.rows.push_back({std::string("standard deviation of the residuals"),
                            Quantity{setup.y_unit.interval().interval_from_si(fit.standard_deviation),
                                     setup.y_unit.interval()}});
    summary.rows.push_back({std::string("degrees of freedom"), nu});
    if (!setup.from_residuals && nu > 0.0) {
        summary.rows.push_back({std::string("chi-squared"), fit.chi_squared});
        const double limit = chi_squared_quantile(0.95, nu);
        summary.rows.push_back({std::string("its 95 % quantile"), limit});
        summary.notes.push_back(
            fit.chi_squared <= limit
                ? "The residuals agree with the stated uncertainties."
                : "The residuals are larger than the stated uncertainties explain: the curve or the "
                  "uncertainties do not describe these points.");
    }
    return {points, summary};
}

}  // namespace covaria::curve
