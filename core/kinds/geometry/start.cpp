#include "core/kinds/geometry/start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/math/decompositions.h"

namespace covaria::geometry {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double least_extent = 1e-9;   // across, to the largest: less is rounding
constexpr double largest_radius = 1e5;  // relative to the extent of the points: more is a plane, or a line
constexpr std::size_t most_sampled = 150;
constexpr int tried_directions = 240;
constexpr std::size_t refined_starts = 12;

Vector3d mean_of_points(const Points& points) {
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& p : points) mean += (p - points.front()) / double(points.size());
    return points.front() + mean;
}

/// Any unit vector across.
Vector3d across(const Vector3d& n) {
    Index least;
    n.cwiseAbs().minCoeff(&least);
    return n.cross(Vector3d::Unit(least)).normalized();
}

Matrix3d frame_along(const Vector3d& z, const Vector3d& towards_x) {
    Matrix3d R;
    R.col(2) = z;
    const Vector3d x = towards_x - z * z.dot(towards_x);
    R.col(0) = x.norm() > 0.0 ? Vector3d(x.normalized()) : across(z);
    R.col(1) = z.cross(R.col(0));
    return R;
}

/// A form by what it is in space. Points are seen from their mean and divided by their extent.
struct InSpace {
    Vector3d place = Vector3d::Zero(), n = Vector3d::UnitZ();
    double radius = 0.0, half_angle = 0.0;
};

/// Across the direction of `form`: |q - c|^2 = r^2, linear in c and r^2 - c^2.
bool algebraic_circle(const Points& q, InSpace& form) {
    const Matrix3d R = frame_along(form.n, Vector3d::Zero());
    MatrixXd A(Index(q.size()), 3);
    Eigen::VectorXd b(Index(q.size()));
    for (std::size_t i = 0; i < q.size(); ++i) {
        const Vector3d t = R.transpose() * q[i];
        A.row(Index(i)) << 2.0 * t.x(), 2.0 * t.y(), 1.0;
        b[Index(i)] = t.head<2>().squaredNorm();
    }
    const Vector3d s = A.colPivHouseholderQr().solve(b);
    form.place = R * Vector3d(s[0], s[1], 0.0);
    form.radius = std::sqrt(std::max(0.0, s[2] + s.head<2>().squaredNorm()));
    return s.allFinite() && form.radius > 0.0;
}

bool algebraic_sphere(const Points& q, InSpace& form) {
    MatrixXd A(Index(q.size()), 4);
    Eigen::VectorXd b(Index(q.size()));
    for (std::size_t i = 0; i < q.size(); ++i) {
        A.row(Index(i)) << 2.0 * q[i].transpose(), 1.0;
        b[Index(i)] = q[i].squaredNorm();
    }
    const Eigen::VectorXd s = A.colPivHouseholderQr().solve(b);
    form.place = s.head<3>();
    form.radius = std::sqrt(std::max(0.0, s[3] + form.place.squaredNorm()));
    return s.allFinite() && form.radius > 0.0;
}

/// Across the direction: |q - c|^2 = (r + k z)^2, linear in c, k^2, 2 r k and r^2 - c^2.
bool algebraic_cone(const Points& q, InSpace& form) {
    const Matrix3d R = frame_along(form.n, Vector3d::Zero());
    MatrixXd A(Index(q.size()), 5);
    Eigen::VectorXd b(Index(q.size()));
    for (std::size_t i = 0; i < q.size(); ++i) {
        const Vector3d t = R.transpose() * q[i];
        A.row(Index(i)) << 2.0 * t.x(), 2.0 * t.y(), t.z() * t.z(), t.z(), 1.0;
        b[Index(i)] = t.head<2>().squaredNorm();
    }
    const Eigen::VectorXd s = A.colPivHouseholderQr().solve(b);
    if (!s.allFinite()) return false;
    const double r2 = s[4] + s[0] * s[0] + s[1] * s[1];
    form.radius = std::sqrt(std::max(1e-6, r2));
    const double k = std::clamp(s[3] / (2.0 * form.radius), -20.0, 20.0);
    if (k < 0.0) form.n = -form.n;
    form.half_angle = std::atan(std::max(1e-3, std::abs(k)));
    form.place = R * Vector3d(s[0], s[1], 0.0);
    return true;
}

/// A spiral over the half sphere, and the principal axes.
std::vector<Vector3d> directions(const Matrix3d& principal) {
    std::vector<Vector3d> all{principal.col(0), principal.col(1), principal.col(2)};
    for (int k = 0; k < tried_directions; ++k) {
        const double z = (k + 0.5) / tried_directions, turn = k * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double rho = std::sqrt(1.0 - z * z);
        all.push_back(principal * Vector3d(rho * std::cos(turn), rho * std::sin(turn), z));
    }
    return all;
}

/// The form in axes that lie in it; `place` may be anywhere on an axis.
FittedForm local_form(Form which, const InSpace& form) {
    FittedForm local;
    local.form = which;
    local.size = 1.0 + form.radius;
    const Vector3d foot = form.place - form.n * form.n.dot(form.place);  // next to the mean of the points
    const double apart = foot.norm();
    switch (which) {
        case Form::line_2d: {
            const Vector3d n = Vector3d(form.n.x(), form.n.y(), 0.0).normalized();
            local.axes << n.x(), -n.y(), 0.0, n.y(), n.x(), 0.0, 0.0, 0.0, 1.0;
            break;
        }
        case Form::line:
        case Form::plane:
            local.axes = frame_along(form.n, Vector3d::Zero());
            break;
        case Form::circle_2d:
        case Form::circle:
        case Form::cylinder:
        case Form::cone: {
            local.axes = frame_along(form.n, -foot);
            const std::size_t h = which == Form::circle ? 3 : 0;
            const std::size_t r = which == Form::circle ? 5 : which == Form::circle_2d ? 2 : 4;
            // of a cone at the mean of the points
            const double radius = form.radius - form.n.dot(form.place) * std::tan(form.half_angle);
            local.v[h] = radius - apart;
            local.v[r] = radius;
            if (which == Form::cone) local.v[5] = form.half_angle;
            break;
        }
        case Form::sphere: {
            const double away = form.place.norm();
            const Vector3d z = away > 1e-6 ? Vector3d(-form.place / away) : Vector3d(Vector3d::UnitZ());
            local.axes = frame_along(z, Vector3d::Zero());
            const Vector3d centre = local.axes.transpose() * form.place;
            local.v = {centre.x(), centre.y(), centre.z() + form.radius, form.radius};
            break;
        }
        case Form::point:
            break;
    }
    return local;
}

InSpace in_space(const FittedForm& local) {
    const Form which = local.form;
    const Shape<double> shape(which, local.v);
    InSpace form;
    const Vector3d zero = Vector3d::Zero();
    form.n = local.turned<double>(shape.direction());
    form.place = local.turned<double>(shape.place(zero));
    form.radius = shape.radius(zero);
    if (which == Form::cone) form.half_angle = local.v[5];
    return form;
}

double cost_of(const FittedForm& local, const Points& q) {
    const Shape<double> shape(local.form, local.v);
    Rows<double> rows;
    double sum = 0.0;
    for (const Vector3d& p : q) {
        shape.rows(local.axes.transpose() * p, rows);
        sum += square_of<double>(local.form, rows);
    }
    return sum;
}

/// A step that makes the cost smaller; false: there is none worth it.
bool improve(FittedForm& local, const Points& q, double& damping, double& cost) {
    const Form which = local.form;
    Normal<double> normal(which);
    const Shape<double> shape(which, local.v);
    Rows<double> rows;
    for (const Vector3d& p : q) {
        shape.rows(local.axes.transpose() * p, rows);
        normal.add(rows);
    }
    for (; damping < 1e12; damping *= 10.0) {
        Normal<double> damped = normal;
        damped.damp(damping);
        const Parameters<double> step = damped.step();
        FittedForm moved = local;
        for (std::size_t i = 0; i < facts_of(which).parameters; ++i) moved.v[i] += step[i];
        const double found = cost_of(moved, q);
        if (!(found < cost)) continue;
        const bool worth = found < (1.0 - 1e-12) * cost;
        local.v = moved.v;
        cost = found;
        damping = std::max(1e-12, damping / 10.0);
        return worth;
    }
    return false;
}

/// Levenberg-Marquardt; the axes follow the form between rounds, so that slopes stay small.
bool refine(Form which, InSpace& form, const Points& q) {
    constexpr int rounds = 6, steps = 40;
    double cost = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
        FittedForm local = local_form(which, form);
        const double before = cost;
        cost = cost_of(local, q);
        double damping = 1e-3;
        for (int k = 0; k < steps && damping < 1e12; ++k)
            if (!improve(local, q, damping, cost)) break;
        if (!std::isfinite(cost)) return false;
        const InSpace found = in_space(local);
        if (!found.place.allFinite() || !found.n.allFinite()) return false;
        form = found;
        if (which == Form::cone && form.half_angle < 0.0) {
            form.half_angle = -form.half_angle;
            form.n = -form.n;
        }
        if (round > 1 && cost > 0.999 * before) break;
    }
    return true;
}

class Search {
public:
    Search(Form form, const Points& points) : form_(form), origin_(mean_of_points(points)) {
        for (const Vector3d& p : points) {
            Vector3d q = p - origin_;
            if (facts_of(form).is_flat) q.z() = 0.0;
            extent_ = std::max(extent_, q.norm());
            q_.push_back(q);
        }
        if (extent_ > 0.0)
            for (Vector3d& q : q_) q /= extent_;
        Matrix3d S = Matrix3d::Zero();
        for (const Vector3d& q : q_) S += q * q.transpose() / double(q_.size());
        const auto solver = eigen_decomposition(S);
        principal_ = solver.eigenvectors();
        // The eigenvalues themselves would keep only half the digits.
        for (Index k = 0; k < 3; ++k)
            for (const Vector3d& q : q_)
                extents_[k] = std::max(extents_[k], std::abs(principal_.col(k).dot(q)));
    }

    Result<FittedForm> find() {
        if (const Message objection = objection_to_points(); !objection.empty())
            return fail(ErrorCode::bad_input, objection);
        if (!closed() && !refined()) return refused();
        FittedForm fitted = in_metres(local_form(form_, best_));
        if (!settle(fitted)) return refused();
        if (const double r = radius_of(fitted); facts_of(form_).has_diameter) {
            if (!(std::abs(r) < largest_radius * extent_))
                return fail(ErrorCode::bad_input,
                            tell<"they are so nearly flat or straight that they determine no radius">());
            if (!(r > 0.0)) return refused();
        }
        set_sign(fitted);
        return fitted;
    }

private:
    Result<FittedForm> refused() const {
        return fail(ErrorCode::bad_input, tell<"no %1 that fits them was found">(words_of(form_)));
    }

    Message objection_to_points() const {
        if (form_ == Form::point) return {};
        if (extent_ == 0.0) return tell<"all of them are the same">();
        if (!std::isfinite(extent_)) return tell<"they are too far from each other">();
        if (form_ == Form::line || form_ == Form::line_2d) return {};
        const Index second = 1;
        if (extents_[second] < least_extent) return tell<"they lie on a straight line">();
        const bool solid = form_ == Form::sphere || form_ == Form::cylinder || form_ == Form::cone;
        if (solid && extents_[0] < least_extent) return tell<"they lie on a plane">();
        return {};
    }

    /// Forms that need no search.
    bool closed() {
        switch (form_) {
            case Form::point:
                return true;
            case Form::line:
            case Form::line_2d:
                best_.n = principal_.col(2);
                return true;
            case Form::plane:
                best_.n = principal_.col(0);
                return true;
            default:
                return false;
        }
    }

    bool refined() {
        switch (form_) {
            case Form::circle_2d:
                best_.n = Vector3d::UnitZ();
                return refine_circle(q_);
            case Form::circle: {
                best_.n = principal_.col(0);
                Points projected;
                for (const Vector3d& q : q_) projected.push_back(q - best_.n * best_.n.dot(q));
                return refine_circle(projected);
            }
            case Form::sphere:
                return algebraic_sphere(q_, best_) && refine(form_, best_, q_);
            default:
                return search_directions();
        }
    }

    bool refine_circle(const Points& q) {
        if (!algebraic_circle(q, best_)) return false;
        InSpace found = best_;
        const Matrix3d R = frame_along(best_.n, Vector3d::Zero());
        Points turned;
        for (const Vector3d& p : q) turned.push_back(R.transpose() * p);
        InSpace flat{R.transpose() * found.place, Vector3d::UnitZ(), found.radius, 0.0};
        const bool is_found = refine(Form::circle_2d, flat, turned);
        best_.place = R * flat.place;
        best_.radius = flat.radius;
        return is_found;
    }

    bool search_directions() {
        Points sample;
        const std::size_t every = std::max<std::size_t>(1, q_.size() / most_sampled);
        for (std::size_t i = 0; i < q_.size(); i += every) sample.push_back(q_[i]);
        std::vector<std::pair<double, InSpace>> starts;
        for (const Vector3d& n : directions(principal_)) {
            InSpace start{.n = n};
            if (!(form_ == Form::cone ? algebraic_cone(sample, start) : algebraic_circle(sample, start)))
                continue;
            const double cost = cost_of(local_form(form_, start), sample);
            if (std::isfinite(cost)) starts.emplace_back(cost, start);
        }
        std::stable_sort(starts.begin(), starts.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < std::min(refined_starts, starts.size()); ++i) {
            InSpace found = starts[i].second;
            if (!refine(form_, found, sample)) continue;
            const double cost = cost_of(local_form(form_, found), sample);
            if (!(cost < least)) continue;
            least = cost;
            best_ = found;
        }
        return std::isfinite(least) && refine(form_, best_, q_);
    }

    FittedForm in_metres(FittedForm local) const {
        local.origin = origin_;
        for (std::size_t i = 0; i < most_parameters; ++i)
            if (is_length(i)) local.v[i] *= extent_;
        local.size *= extent_;
        return local;
    }
    bool is_length(std::size_t i) const {
        switch (form_) {
            case Form::line_2d:
                return i != 1;
            case Form::line:
                return i < 2;
            case Form::plane:
            case Form::circle:
                return i != 1 && i != 2;
            case Form::cylinder:
            case Form::cone:
                return i < 2 || i == 4;
            default:
                return true;
        }
    }

    /// Gauss-Newton steps as in every trial, in axes that lie in the form that they lead to.
    bool settle(FittedForm& fitted) const {
        Points local;
        for (const Vector3d& q : q_) local.push_back(fitted.axes.transpose() * (q * extent_));
        Parameters<double> v{};
        if (!fit<double>(
                fitted, [&](std::size_t k) { return local[k]; }, q_.size(), v))
            return false;
        fitted.v = v;
        if (form_ != Form::cone) return true;
        return v[5] > 0.0 && v[5] < std::numbers::pi / 2.0;
    }

    static double radius_of(const FittedForm& fitted) {
        return Shape<double>(fitted.form, fitted.v).radius(Vector3d::Zero());
    }

    void set_sign(FittedForm& fitted) const {
        if (form_ == Form::cone || !facts_of(form_).has_direction) return;
        const Vector3d n = fitted.turned<double>(Shape<double>(form_, fitted.v).direction());
        Index largest;
        n.cwiseAbs().maxCoeff(&largest);
        fitted.sign = n[largest] < 0.0 ? -1.0 : 1.0;
    }

    Form form_;
    Vector3d origin_;
    double extent_ = 0.0;
    Points q_;  ///< points from the origin, in extents
    Matrix3d principal_;
    Vector3d extents_ = Vector3d::Zero();  ///< along them, rising
    InSpace best_;
};

}  // namespace

Message words_of(Form form) {
    switch (form) {
        case Form::point:
            return tell<"point">();
        case Form::line_2d:
            return tell<"line in the xy-plane">();
        case Form::line:
            return tell<"line">();
        case Form::plane:
            return tell<"plane">();
        case Form::circle_2d:
            return tell<"circle in the xy-plane">();
        case Form::circle:
            return tell<"circle">();
        case Form::sphere:
            return tell<"sphere">();
        case Form::cylinder:
            return tell<"cylinder">();
        case Form::cone:
            break;
    }
    return tell<"cone">();
}

Result<FittedForm> fitted_form(Form form, const std::vector<Vector3d>& points) {
    return Search(form, points).find();
}

MatrixXd cofactors(const FittedForm& fitted, const std::vector<Vector3d>& points) {
    Normal<double> normal(fitted.form);
    const Shape<double> shape(fitted.form, fitted.v);
    Rows<double> rows;
    for (const Vector3d& p : points) {
        shape.rows(fitted.to_local<double>(p), rows);
        normal.add(rows);
    }
    const auto n = Index(facts_of(fitted.form).parameters);
    MatrixXd M(n, n);
    Eigen::VectorXd scale(n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) M(i, j) = normal.entry(std::size_t(i), std::size_t(j));
    for (Index i = 0; i < n; ++i) scale[i] = 1.0 / std::sqrt(M(i, i));
    M = scale.asDiagonal() * M * scale.asDiagonal();
    return scale.asDiagonal() * cholesky(M).solve(MatrixXd::Identity(n, n)) * scale.asDiagonal();
}

}  // namespace covaria::geometry
