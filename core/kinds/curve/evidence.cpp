#include "core/kinds/curve/evidence.h"

#include <algorithm>
#include <cmath>

#include "core/kinds/points/component_evidence.h"

namespace covaria::curve {

namespace {

constexpr const char *of_x = "x", *of_y = "y";

class PointsAsReadings {
public:
    PointsAsReadings(const CurveSetup& setup, const Fit& fit) : setup_(setup), fit_(fit) {
        add_axis(of_y, setup.common_u_y, [](const Point& p) { return p.u_y; });
        add_axis(of_x, setup.common_u_x, [](const Point& p) { return p.u_x; });
    }

    std::shared_ptr<const evidence::RedundantReadings> readings() const {
        std::vector<FitsWithSharedComponents::Row> rows;
        for (std::size_t i = 0; i < setup_.points.size(); ++i) rows.push_back(row(i));
        FitsWithSharedComponents fits(inputs_);
        fits.add(rows);
        return fits.evidence(figures_).readings;
    }

private:
    template <class U>
    void add_axis(const char* axis, double common, U u_of) {
        const std::size_t n = setup_.points.size();
        const Unit unit = (axis == of_y ? setup_.y_unit : setup_.x_unit).interval();
        const std::size_t shared = inputs_.add(UncertaintyComponent{
            .id = std::string(axis) + ".common", .unit = unit, .distribution = Distribution::normal(common)});
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t own = inputs_.add(
                UncertaintyComponent{.id = std::string(axis) + "_" + std::to_string(i + 1),
                                     .unit = unit,
                                     .distribution = Distribution::normal(u_of(setup_.points[i]))});
            figures_[own] = {axis, axis == of_y ? tell<"y of the points">() : tell<"x of the points">(), unit,
                             curve_fields().place(&CurveSetup::stated_points)};
            inputs_.quantities.push_back(
                {.symbol = inputs_.components[own].id, .shares = {{own, 1.0}, {shared, 1.0}}});
        }
    }

    /// The residual along y in units of what is stated of the point.
    FitsWithSharedComponents::Row row(std::size_t i) const {
        const Point& p = setup_.points[i];
        const Polynomials& polynomials = fit_.polynomials;
        Values<double> phi, slopes;
        polynomials.at(polynomials.t_of(p.x), phi, slopes);
        double slope = 0.0;
        for (std::size_t j = 0; j < polynomials.count; ++j)
            slope += fit_.q[j] * slopes[j] / polynomials.half_width;
        const double u = std::hypot(p.u_y, slope * p.u_x);
        FitsWithSharedComponents::Row row{tell<"point %1">(i + 1),
                                          Eigen::VectorXd(Eigen::Index(polynomials.count)),
                                          fit_.residuals[i] / u,
                                          {{i, 1.0 / u}, {setup_.points.size() + i, -slope / u}}};
        for (std::size_t j = 0; j < polynomials.count; ++j) row.design[Eigen::Index(j)] = phi[j] / u;
        return row;
    }

    const CurveSetup& setup_;
    const Fit& fit_;
    InputSet inputs_;
    std::map<std::size_t, FigureOfComponent> figures_;
};

}  // namespace

std::shared_ptr<const evidence::RedundantReadings> redundant_readings(const CurveSetup& setup,
                                                                      const Fit& fit) {
    if (setup.from_residuals || !setup.correlations.empty() || !(setup.degrees_of_freedom() > 0.0))
        return nullptr;
    return PointsAsReadings(setup, fit).readings();
}

void take_as_seen(CurveSetup& setup, const evidence::RedundantReadings* readings, Problems& problems) {
    if (setup.from_residuals) return;
    const evidence::AsSeen taken = evidence::as_seen(
        readings, setup.uncertainties, curve_fields().place(&CurveSetup::uncertainties), problems);
    if (!taken.has_any()) return;
    // Figures stand in the order of their keys, x before y; y has one wherever x has.
    const bool has_x = std::ranges::count_if(setup.points, [](const Point& p) { return p.u_x > 0.0; }) > 1;
    if (has_x) setup.seen_x = taken.factors.front();
    setup.seen_y = taken.factors.back();
    for (Point& p : setup.points) {
        p.u_x *= setup.seen_x.factor;
        p.u_y *= setup.seen_y.factor;
    }
    make_covariance(setup);
}

}  // namespace covaria::curve
