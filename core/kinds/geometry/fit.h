// Orthogonal least squares: the parameters of a form from points near it, once for every number type.
#pragma once

#include "core/kinds/geometry/shape.h"

namespace covaria::geometry {

/// A form with its local axes, and the parameters at the estimates of the points.
struct FittedForm {
    Form form = Form::plane;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< near the mean of the points
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< local axes by columns
    Parameters<double> v{};
    double size = 0.0;  ///< size of points and form: what rounding is judged by
    double sign = 1.0;  ///< sign of the direction that is stated

    template <class Real>
    Vector3<Real> to_local(const Vector3<Real>& p) const {
        const Vector3<Real> d(p[0] - Real(origin[0]), p[1] - Real(origin[1]), p[2] - Real(origin[2]));
        Vector3<Real> q;
        for (int i = 0; i < 3; ++i)
            q[i] = d[0] * Real(axes(0, i)) + d[1] * Real(axes(1, i)) + d[2] * Real(axes(2, i));
        return q;
    }
    template <class Real>
    Vector3<Real> turned(const Vector3<Real>& q) const {
        Vector3<Real> p;
        for (int i = 0; i < 3; ++i)
            p[i] = q[0] * Real(axes(i, 0)) + q[1] * Real(axes(i, 1)) + q[2] * Real(axes(i, 2));
        return p;
    }
    template <class Real>
    Vector3<Real> to_world(const Vector3<Real>& q) const {
        Vector3<Real> p = turned(q);
        for (int i = 0; i < 3; ++i) p[i] = p[i] + Real(origin[i]);
        return p;
    }
};

inline constexpr int most_steps = 60;

/// J^T J and J^T d of all rows.
template <class Real>
class Normal {
public:
    explicit Normal(Form form) : form_(form), count_(facts_of(form).parameters) {
        for (auto& row : M_) row.fill(Real(0.0));
        g_.fill(Real(0.0));
    }
    void add(const Rows<Real>& rows) {
        for (std::size_t r = 0; r < facts_of(form_).rows; ++r) {
            const RowRange range = range_of(form_, r);
            for (std::size_t i = range.first; i < range.last; ++i) {
                g_[i] = g_[i] + rows.J[r][i] * rows.d[r];
                for (std::size_t j = range.first; j <= i; ++j)
                    M_[i][j] = M_[i][j] + rows.J[r][i] * rows.J[r][j];
            }
        }
    }
    /// Lengthens the diagonal by this factor (Marquardt).
    void damp(double factor) {
        for (std::size_t i = 0; i < count_; ++i) M_[i][i] = M_[i][i] * Real(1.0 + factor);
    }
    const Parameters<Real>& gradient() const { return g_; }
    double entry(std::size_t i, std::size_t j) const { return i < j ? M_[j][i] : M_[i][j]; }

    /// The step that leads to the least sum of squares, as far as that is linear: scaled to a unit diagonal,
    /// then by Cholesky factors. Not finite where the matrix is singular.
    Parameters<Real> step() {
        using namespace real_functions;
        Parameters<Real> over, x;
        for (std::size_t i = 0; i < count_; ++i) over[i] = Real(1.0) / sqrt(M_[i][i]);
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t j = 0; j <= i; ++j) M_[i][j] = M_[i][j] * over[i] * over[j];
        for (std::size_t j = 0; j < count_; ++j) {
            for (std::size_t k = 0; k < j; ++k) M_[j][j] = M_[j][j] - M_[j][k] * M_[j][k];
            M_[j][j] = sqrt(M_[j][j]);
            for (std::size_t i = j + 1; i < count_; ++i) {
                for (std::size_t k = 0; k < j; ++k) M_[i][j] = M_[i][j] - M_[i][k] * M_[j][k];
                M_[i][j] = M_[i][j] / M_[j][j];
            }
        }
        for (std::size_t i = 0; i < count_; ++i) {
            x[i] = -g_[i] * over[i];
            for (std::size_t k = 0; k < i; ++k) x[i] = x[i] - M_[i][k] * x[k];
            x[i] = x[i] / M_[i][i];
        }
        for (std::size_t i = count_; i-- > 0;) {
            for (std::size_t k = i + 1; k < count_; ++k) x[i] = x[i] - M_[k][i] * x[k];
            x[i] = x[i] / M_[i][i];
        }
        for (std::size_t i = 0; i < count_; ++i) x[i] = x[i] * over[i];
        return x;
    }

private:
    Form form_;
    std::size_t count_;
    std::array<Parameters<Real>, most_parameters> M_;
    Parameters<Real> g_;
};

/// Gauss-Newton steps from the estimates until the deviations of the points stay as they are; then one more.
/// `q(k)`: the points in local axes. False where they do not settle.
template <class Real, class Points>
mask_of<Real> fit(const FittedForm& start, const Points& q, std::size_t points, Parameters<Real>& v) {
    using namespace real_functions;
    const std::size_t count = facts_of(start.form).parameters;
    for (std::size_t i = 0; i < count; ++i) v[i] = Real(start.v[i]);
    const double rounding = 1e-14 * start.size;
    const Real limit(static_cast<double>(points) * rounding * rounding);
    mask_of<Real> settled = Real(0.0) < Real(0.0);
    Rows<Real> rows;
    for (int k = 0, further = 0; k < most_steps && further < 2; ++k) {
        Normal<Real> normal(start.form);
        const Shape<Real> shape(start.form, v);
        for (std::size_t i = 0; i < points; ++i) {
            shape.rows(q(i), rows);
            normal.add(rows);
        }
        const Parameters<Real> gradient = normal.gradient(), step = normal.step();
        Real squares(0.0);  // change of the sum of squares
        for (std::size_t i = 0; i < count; ++i) {
            squares = squares - gradient[i] * step[i];
            v[i] = v[i] + step[i];
        }
        settled = squares <= limit;
        further = all(settled) ? further + 1 : 0;
    }
    return settled;
}

}  // namespace covaria::geometry
