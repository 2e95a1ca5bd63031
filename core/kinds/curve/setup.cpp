// Reads the set-up of "calibration curve".
#include "core/kinds/curve/setup.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <set>

namespace covaria::curve {

namespace {

class CurveReader {
public:
    CurveReader(const SetupReader& reader, Problems& problems) : reader_(reader), problems_(problems) {}

    std::optional<CurveSetup> run() {
        setup_.x_unit = unit("x_unit");
        setup_.y_unit = unit("y_unit");
        setup_.degree = static_cast<std::size_t>(reader_.integer("degree"));
        setup_.through_origin = reader_.flag("through_origin");
        setup_.from_residuals = reader_.text("uncertainty") == "residuals";
        setup_.origin = setup_.x_unit.to_si(reader_.number("origin"));
        for (std::size_t row = 0; row < reader_.rows("points"); ++row) read_point(row);
        for (std::size_t row = 0; row < reader_.rows("predictions"); ++row)
            setup_.predictions.push_back({name("predictions", row),
                                          setup_.x_unit.to_si(reader_.cell_number("predictions", row, "x"))});
        for (std::size_t row = 0; row < reader_.rows("inverse"); ++row) read_observation(row);
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

    std::string name(const char* table, std::size_t row) const {
        return reader_.cell_empty(table, row, "name") ? "" : reader_.cell_text(table, row, "name");
    }

    void read_observation(std::size_t row) {
        const auto given = [&](const char* column) { return !reader_.cell_empty("inverse", row, column); };
        Observation made{name("inverse", row), setup_.y_unit.to_si(reader_.cell_number("inverse", row, "y"))};
        if (given("u_y")) made.u_y = setup_.y_unit.interval_to_si(reader_.cell_number("inverse", row, "u_y"));
        if (given("readings")) made.readings = reader_.cell_number("inverse", row, "readings");
        if (given("near")) made.near = setup_.x_unit.to_si(reader_.cell_number("inverse", row, "near"));
        if (given("readings") && !setup_.from_residuals)
            problems_.error("/inverse/rows/" + std::to_string(row) + "/readings",
                            "readings have the scatter of the residuals, which stated uncertainties do not "
                            "use: give u_y in row " +
                                std::to_string(row + 1));
        setup_.observations.push_back(made);
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
        if (setup_.through_origin && setup_.y_unit.to_si(0.0) != 0.0)
            problems_.error("/y_unit", "a curve through the origin needs differences: give y in K");
        std::set<double> places;
        for (const Point& p : setup_.points)
            if (!setup_.through_origin || p.x != setup_.origin) places.insert(p.x);
        if (places.size() < setup_.coefficients())
            problems_.error("/points", "a polynomial of this degree needs points at " +
                                           std::to_string(setup_.coefficients()) +
                                           " different places or more" +
                                           (setup_.through_origin ? " beside the origin" : ""));
        if (setup_.from_residuals && setup_.points.size() <= setup_.coefficients())
            problems_.error("/points",
                            "residuals say nothing about the uncertainty unless there are more points than "
                            "coefficients: add points, or state u_y");
    }

    const SetupReader& reader_;
    Problems& problems_;
    CurveSetup setup_;
};

}  // namespace

bool CurveSetup::has_u_x() const {
    return !from_residuals &&
           std::any_of(points.begin(), points.end(), [](const Point& p) { return p.u_x > 0.0; });
}

std::optional<CurveSetup> read_curve_setup(const SetupReader& reader, Problems& problems) {
    return CurveReader(reader, problems).run();
}

Unit coefficient_unit(const CurveSetup& setup, std::size_t k) {
    const std::string y = setup.y_unit.interval().text();
    if (k == 0) return setup.y_unit.interval();
    const std::string power = k == 1 ? "" : "^" + std::to_string(k);
    return Unit::parse(y + "/(" + setup.x_unit.interval().text() + ")" + power).value_or(Unit{});
}

std::string place_text(const Unit& unit, double si) {
    char text[64];
    std::snprintf(text, sizeof text, "%.12g", unit.from_si(si));
    return text + (unit == Unit{} ? "" : " " + unit.display());
}

}  // namespace covaria::curve
