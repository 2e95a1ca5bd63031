// The set-up of "calibration curve" and what follows from its fields.
#include "core/kinds/curve/setup.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>

#include "core/text/numbers.h"
#include "core/text/symbol.h"

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

/// Without x_1 and y_2 there is no fit by them; residuals say what is stated nowhere.
void check_correlations(const CurveSetup& setup, Problems& problems) {
    const bool common = setup.common_u_x > 0.0 || setup.common_u_y > 0.0;
    if (setup.from_residuals && common)
        problems.error(
            curve_fields().place(setup.common_u_x > 0.0 ? &CurveSetup::common_u_x : &CurveSetup::common_u_y),
            tell<"a common deviation is one of stated uncertainties: choose these, or leave it 0">());
    for (std::size_t row = 0; row < setup.correlations.size(); ++row) {
        const StatedCorrelation& stated = setup.correlations[row];
        const auto refuse = [&](std::string StatedCorrelation::*column, const Message& why) {
            problems.error(curve_fields().place(&CurveSetup::correlations, row, column), why);
        };
        if (setup.from_residuals)
            return refuse(
                &StatedCorrelation::first,
                tell<"correlations are those of stated uncertainties: choose these, or leave out the "
                     "correlations">());
        for (const auto column : {&StatedCorrelation::first, &StatedCorrelation::second}) {
            const auto place = coordinate_of(stated.*column, setup.points.size());
            if (!place)
                refuse(column, tell<"'%1' is no coordinate of a point: write y_1 for the y of the first one">(
                                   stated.*column));
            else if (!((place->is_y ? setup.points[place->point].u_y : setup.points[place->point].u_x) > 0.0))
                refuse(column, tell<"%1 has no standard uncertainty of its own that could be correlated">(
                                   stated.*column));
        }
        if (stated.first == stated.second)
            refuse(&StatedCorrelation::second, tell<"a coordinate is not correlated with itself">());
    }
}

/// Converts the figures of a set-up from the units of x and y to SI.
void convert(CurveSetup& setup) {
    const Unit &x = setup.x_unit, &y = setup.y_unit;
    setup.common_u_x = x.interval_to_si(setup.common_u_x);
    setup.common_u_y = y.interval_to_si(setup.common_u_y);
    setup.origin = x.to_si(setup.origin);
    for (const StatedPoint& p : setup.stated_points)
        setup.points.push_back({x.to_si(p.x), y.to_si(p.y), x.interval_to_si(p.u_x.value_or(0.0)),
                                y.interval_to_si(p.u_y.value_or(0.0))});
    for (StatedCorrelation& c : setup.correlations) {
        c.first = plain_symbol(c.first);
        c.second = plain_symbol(c.second);
    }
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
    if (from_residuals) return false;
    return common_u_x > 0.0 ||
           std::any_of(points.begin(), points.end(), [](const Point& p) { return p.u_x > 0.0; });
}

// The covariance of all x, then all y; left empty where no two are correlated.
void make_covariance(CurveSetup& setup) {
    const bool common = setup.common_u_x > 0.0 || setup.common_u_y > 0.0;
    if (setup.from_residuals || (setup.correlations.empty() && !common)) return;
    const auto n = Eigen::Index(setup.points.size());
    setup.covariance = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    setup.covariance.topLeftCorner(n, n).setConstant(setup.common_u_x * setup.common_u_x);
    setup.covariance.bottomRightCorner(n, n).setConstant(setup.common_u_y * setup.common_u_y);
    Eigen::VectorXd u(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Point& p = setup.points[std::size_t(i)];
        u[i] = p.u_x;
        u[n + i] = p.u_y;
    }
    setup.covariance.diagonal() += u.cwiseAbs2();
    for (const StatedCorrelation& stated : setup.correlations) {
        const auto a = coordinate_of(stated.first, setup.points.size());
        const auto b = coordinate_of(stated.second, setup.points.size());
        const Eigen::Index i = Eigen::Index(a->point) + (a->is_y ? n : 0);
        const Eigen::Index j = Eigen::Index(b->point) + (b->is_y ? n : 0);
        setup.covariance(i, j) += stated.coefficient * u[i] * u[j];
        setup.covariance(j, i) = setup.covariance(i, j);
    }
}

std::optional<CurveSetup> read_curve_setup(const SetupReader& reader, const AssetLibrary& assets,
                                           Problems& problems) {
    CurveSetup setup = curve_fields().read(reader, assets, problems);
    convert(setup);
    check_figures(setup, problems);
    check(setup, problems);
    check_correlations(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    make_covariance(setup);
    return setup;
}

std::optional<Coordinate> coordinate_of(const std::string& symbol, std::size_t points) {
    if (symbol.size() < 3 || (symbol[0] != 'x' && symbol[0] != 'y') || symbol[1] != '_') return std::nullopt;
    std::size_t number = 0;
    const char* const end = symbol.data() + symbol.size();
    const auto read = std::from_chars(symbol.data() + 2, end, number);
    if (read.ec != std::errc() || read.ptr != end || number < 1 || number > points) return std::nullopt;
    return Coordinate{symbol[0] == 'y', number - 1};
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
