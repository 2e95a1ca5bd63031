// Checks before "TCP from ballbars" is evaluated: errors and warnings; the flange from given
// points.
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/kinds/ballbar/equations.h"
#include "core/math/decompositions.h"
#include "core/text/numbers.h"

namespace covaria::tcp {

namespace {

constexpr double short_arc = 60.0 * std::numbers::pi / 180.0;

Message about(const Sequence& sequence) {
    return tell<"the rotation about %1">(axis_letters[sequence.axis]);
}

void check_sequence(const TcpSetup& setup, const Sequence& sequence, Problems& problems) {
    const double degrees = sequence.span * 180.0 / std::numbers::pi;
    if (sequence.count < 3)
        return problems.error(sequence.source,
                              tell<"%1 has %2 points; a plane needs three, and some more to be checked">(
                                  about(sequence), sequence.count));
    if (!(sequence.span > 1e-6))
        return problems.error(sequence.source,
                              tell<"%1 has a span of zero: all its points coincide">(about(sequence)));
    if (!(sequence.radius > 1e-3 * setup.tool_F.norm()) || !(sequence.radius > 1e-6))
        return problems.error(sequence.source,
                              tell<"the tool centre point lies on the axis of %1 (or the tool has no "
                                   "length): it traces no circle; turn about another axis">(about(sequence)));
    if (sequence.span < short_arc) {
        const double factor = std::pow(std::numbers::pi / sequence.span, 2);
        problems.warning(sequence.source,
                         tell<"the arc of %1 spans only %2°: uncertainties grow as the inverse square of the "
                              "span and may be %3 times those of half a turn">(
                             about(sequence), Message::number(format_short(degrees)),
                             Message::number(format_decimals(factor, 0))));
    }
}

/// u(z) by the readings of the first three bars: dz/dL_i = w_i L_i/z with w the barycentric weights.
double height_uncertainty(const TcpSetup& setup, const Point& point) {
    const auto& s = setup.supports;
    const Eigen::Vector3d& p = point.p_B;
    const auto area = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    };
    const double whole = area(s[0], s[1], s[2]);
    const double weights[] = {area(p, s[1], s[2]) / whole, area(s[0], p, s[2]) / whole,
                              area(s[0], s[1], p) / whole};
    double variance = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double u = setup.ballbars->reading(i, point.length[i]).distribution.standard_uncertainty();
        variance += std::pow(weights[i] * point.length[i] / p.z() * u, 2);
    }
    return std::sqrt(variance);
}

void check_points(const TcpSetup& setup, Problems& problems) {
    const double side = setup.ballbars->side();
    for (const Point& point : setup.points) {
        const double height = side * point.p_B.z();
        if (!(height > 0.0)) {
            problems.error(point.source,
                           tell<"point %1 is %2 mm on the other side of the supports' plane, where the "
                                "ballbars look for no solution; change their placement or their side">(
                               point.name, Message::number(format_decimals(-1e3 * height, 3))));
            continue;
        }
        const double u = height_uncertainty(setup, point);
        if (height < 10.0 * u)
            problems.warning(point.source,
                             tell<"point %1 is only %2 mm from the supports' plane, with a standard "
                                  "uncertainty of %3 mm in that direction: in some trials the lengths will "
                                  "not meet (negative root), and u is not to be trusted">(
                                 point.name, Message::number(format_short(1e3 * height)),
                                 Message::number(format_short(1e3 * u, 2))));
    }
}

/// Normal of the points of a sequence, directed so that they turn about it by the commanded angles: of
/// p = a + b cos(angle) + c sin(angle) by least squares, b × c is along it.
Eigen::Vector3d fitted_normal(const TcpSetup& setup, const Sequence& sequence) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero(), normal_equations = scatter, right = scatter;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = sequence.first; i < sequence.first + sequence.count; ++i)
        mean += setup.points[i].p_B / static_cast<double>(sequence.count);
    for (std::size_t i = sequence.first; i < sequence.first + sequence.count; ++i) {
        const Point& point = setup.points[i];
        const Eigen::Vector3d d = point.p_B - mean, basis(1.0, point.cosine, point.sine);
        scatter += d * d.transpose();
        normal_equations += basis * basis.transpose();
        right += basis * d.transpose();
    }
    const Eigen::Matrix3d coefficients = normal_equations.fullPivLu().solve(right);
    const Eigen::Vector3d b = coefficients.row(1), c = coefficients.row(2);
    const auto solver = eigen_decomposition(scatter);
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    return normal.dot(b.cross(c)) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace

void check_tcp_setup(const TcpSetup& setup, Problems& problems) {
    for (const Sequence& sequence : setup.sequences) check_sequence(setup, sequence, problems);
    if (!problems.has_errors()) check_points(setup, problems);
}

void fit_measured_points(TcpSetup& setup, Problems& problems) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Point& point : setup.points) mean += point.p_B / static_cast<double>(setup.points.size());
    setup.X_BF.setIdentity();
    setup.X_BF.translation() = mean;
    for (const Sequence& sequence : setup.sequences)
        setup.X_BF.linear().col(sequence.axis) = fitted_normal(setup, sequence);
    std::vector<Eigen::Vector3d> q;
    for (const Point& point : setup.points) q.push_back(point.p_B - mean);
    const Flange<double> flange = fit_flange<double>(setup, q);
    if (!flange.tool.allFinite() || !flange.axes.allFinite())
        return problems.error(tcp_fields().place(&StatedTcp::measured),
                              tell<"the measured points determine no sphere and no axes: they lie on one "
                                   "circle, or coincide; check their axes and angles">());
    setup.X_BF.linear() = flange.axes;
    setup.X_BF.translation() += flange.centre;
    setup.tool_F = flange.tool;
}

}  // namespace covaria::tcp
