// What follows from the fields of "calibration curve".
#include "core/kinds/curve/setup.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "core/text/numbers.h"

namespace covaria::curve {

namespace {

std::string cell(std::size_t row, std::optional<double> StatedPoint::*column) {
    return curve_fields().place(&CurveSetup::stated_points, row, column);
}

/// Standard uncertainties of y are needed where residuals do not give them.
void check_figures(const CurveSetup& setup, Problems& problems) {
    for (std::size_t row = 0; row < setup.stated_points.size() && !setup.from_residuals; ++row) {
        const std::optional<double>& u_y = setup.stated_points[row].u_y;
        if (!u_y)
            problems.error(cell(row, &StatedPoint::u_y),
                           tell<"the standard uncertainty of y is missing in row %1">(row + 1));
        else if (!(*u_y > 0.0))
            problems.error(
                cell(row, &StatedPoint::u_y),
                tell<"the standard uncertainty of y must be greater than zero in row %1">(row + 1));
    }
    for (std::size_t row = 0; row < setup.observations.size(); ++row)
        if (setup.observations[row].readings > 0 && !setup.from_residuals)
            problems.error(curve_fields().place(&CurveSetup::observations, row, &Observation::readings),
                           tell<"readings have the scatter of the residuals, which stated uncertainties do "
                                "not use: give u_y in row %1">(row + 1));
}

/// From the units of x and y to SI.
void convert(CurveSetup& setup) {
    const Unit &x = setup.x_unit, &y = setup.y_unit;
    setup.origin = x.to_si(setup.origin);
    for (const StatedPoint& p : setup.stated_points)
        setup.points.push_back({x.to_si(p.x), y.to_si(p.y), x.interval_to_si(p.u_x.value_or(0.0)),
                                y.interval_to_si(p.u_y.value_or(0.0))});
    for (Prediction& p : setup.predictions) p.x = x.to_si(p.x);
    for (Observation& o : setup.observations) {
        o.y = y.to_si(o.y);
        o.u_y = y.interval_to_si(o.u_y);
        if (o.near) o.near = x.to_si(*o.near);
    }
}

void check(const CurveSetup& setup, Problems& problems) {
    const std::string points = curve_fields().place(&CurveSetup::stated_points);
    if (setup.through_origin && setup.y_unit.to_si(0.0) != 0.0)
        problems.error(curve_fields().place(&CurveSetup::y_unit),
                       tell<"a curve through the origin needs differences: give y in K">());
    std::set<double> places;
    for (const Point& p : setup.points)
        if (!setup.through_origin || p.x != setup.origin) places.insert(p.x);
    if (places.size() < setup.coefficients())
        problems.error(points,
                       setup.through_origin
                           ? tell<"a polynomial of this degree needs points at %1 different places or more "
                                  "beside the origin">(setup.coefficients())
                           : tell<"a polynomial of this degree needs points at %1 different places or more">(
                                 setup.coefficients()));
    if (setup.from_residuals && setup.points.size() <= setup.coefficients())
        problems.error(points, tell<"residuals say nothing about the uncertainty unless there are more "
                                    "points than coefficients: add points, or state u_y">());
}

}  // namespace

bool CurveSetup::has_u_x() const {
    return !from_residuals &&
           std::any_of(points.begin(), points.end(), [](const Point& p) { return p.u_x > 0.0; });
}

std::optional<CurveSetup> read_curve_setup(const SetupReader& reader, const AssetLibrary& assets,
                                           Problems& problems) {
    CurveSetup setup = curve_fields().read(reader, assets, problems);
    convert(setup);
    check_figures(setup, problems);
    check(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

Unit coefficient_unit(const CurveSetup& setup, std::size_t k) {
    const std::string y = setup.y_unit.interval().text();
    if (k == 0) return setup.y_unit.interval();
    const bool alike = setup.x_unit.interval() == setup.y_unit.interval();
    if (alike && k == 1) return Unit{};  // not "K/K"
    const std::string power = k == 1 ? "" : "^" + std::to_string(k);
    return Unit::parse(y + "/(" + setup.x_unit.interval().text() + ")" + power).value_or(Unit{});
}

std::string place_text(const Unit& unit, double si) {
    return format_short(unit.from_si(si), 12) + (unit == Unit{} ? "" : " " + unit.display());
}

}  // namespace covaria::curve
