// A form with the values of its parameters: how far a point is from it, and how that depends on them. Once
// for every number type.
#pragma once

#include "core/kinds/geometry/form.h"
#include "core/math/dual.h"
#include "core/math/real.h"

namespace covaria::geometry {

template <class Real>
using Parameters = std::array<Real, most_parameters>;

/// Deviations of one point, and their derivatives by the parameters.
template <class Real>
struct Rows {
    std::array<Real, most_rows> d;
    std::array<Parameters<Real>, most_rows> J;
};

/// A form in local axes near it: z along its direction (x for a line in a plane); x from the middle of an
/// arc outwards. Parameters are
///   point (x, y, z); line in the plane (h, a); line (x, y, a, b); plane (h, a, b);
///   circle in the plane (h, y, r); circle (h of its plane, a, b; h, y, r); sphere (x, y, h, r);
///   cylinder (h, y, a, b, r); cone (h, y, a, b, r, half its angle).
/// (a, b, 1) is along the direction, (-a, 1) across a line in the plane. h is the height of the middle of
/// the arc, not of the centre, which is h - r: a cap determines its height well and its radius badly, and
/// the normal equations stay regular however small it is.
template <class Real>
class Shape {
public:
    Shape(Form form, const Parameters<Real>& v) : form_(form), v_(v) {
        using namespace real_functions;
        n_ = Vector3<Real>(Real(0.0), Real(0.0), Real(1.0));
        P_ = Vector3<Real>(Real(0.0), Real(0.0), Real(0.0));
        over_N_ = c_ = Real(1.0);
        s_ = Real(0.0);
        switch (form) {
            case Form::point:
                P_ = Vector3<Real>(v[0], v[1], v[2]);
                break;
            case Form::line_2d:
                over_N_ = Real(1.0) / sqrt(Real(Real(1.0) + v[1] * v[1]));
                n_ = Vector3<Real>(over_N_, Real(v[1] * over_N_), Real(0.0));
                break;
            case Form::line:
                set_direction(v[2], v[3]);
                P_ = Vector3<Real>(v[0], v[1], Real(0.0));
                break;
            case Form::plane:
                set_direction(v[1], v[2]);
                break;
            case Form::circle_2d:
                P_ = Vector3<Real>(Real(v[0] - v[2]), v[1], Real(0.0));
                break;
            case Form::circle:
                set_direction(v[1], v[2]);
                P_ = Vector3<Real>(Real(v[3] - v[5]), v[4], Real(0.0));
                break;
            case Form::sphere:
                P_ = Vector3<Real>(v[0], v[1], Real(v[2] - v[3]));
                break;
            case Form::cone:
                c_ = cos(v[5]);
                s_ = sin(v[5]);
                [[fallthrough]];
            case Form::cylinder:
                set_direction(v[2], v[3]);
                P_ = Vector3<Real>(Real(v[0] - v[4]), v[1], Real(0.0));
                break;
        }
    }

    void rows(const Vector3<Real>& q, Rows<Real>& out) const {
        switch (form_) {
            case Form::point:
                return point_rows(q, out);
            case Form::line_2d:
                out.d[0] = n_[0] * q[1] - n_[1] * q[0] - v_[0];
                out.J[0][0] = Real(-1.0);
                out.J[0][1] = -(q.dot(n_) * over_N_ * over_N_);
                return;
            case Form::line:
                return line_rows(q, out);
            case Form::plane:
                return plane_row(q, out);
            case Form::circle_2d:
            case Form::circle:
                return circle_rows(q, out);
            case Form::sphere:
                return sphere_row(q, out);
            case Form::cylinder:
            case Form::cone:
                return axis_row(q, out);
        }
    }

    const Vector3<Real>& direction() const { return n_; }
    /// The point that stands for the form: the centre, or the foot of the points' mean.
    Vector3<Real> place(const Vector3<Real>& mean) const {
        switch (form_) {
            case Form::line_2d: {
                const Real along = mean.dot(n_);
                return Vector3<Real>(Real(n_[0] * along - n_[1] * v_[0]), Real(n_[1] * along + n_[0] * v_[0]),
                                     Real(0.0));
            }
            case Form::plane:
                return mean - n_ * Real(n_.dot(mean) - v_[0]);
            case Form::line:
            case Form::cylinder:
            case Form::cone:
                return P_ + n_ * Real(n_.dot(mean - P_));
            case Form::circle:
                return P_ + n_ * Real(v_[0] - n_.dot(P_));
            default:
                return P_;
        }
    }
    /// Radius, of a cone at `place`.
    Real radius(const Vector3<Real>& mean) const {
        switch (form_) {
            case Form::circle_2d:
                return v_[2];
            case Form::sphere:
                return v_[3];
            case Form::circle:
                return v_[5];
            case Form::cone:
                return v_[4] + n_.dot(mean - P_) * s_ / c_;
            default:
                return v_[4];
        }
    }
    Vector3<Real> apex() const { return P_ - n_ * Real(v_[4] * c_ / s_); }

private:
    void set_direction(const Real& a, const Real& b) {
        using namespace real_functions;
        over_N_ = Real(1.0) / sqrt(Real(Real(1.0) + a * a + b * b));
        n_ = Vector3<Real>(Real(a * over_N_), Real(b * over_N_), over_N_);
    }

    void point_rows(const Vector3<Real>& q, Rows<Real>& out) const {
        for (std::size_t r = 0; r < 3; ++r) {
            out.d[r] = q[static_cast<Eigen::Index>(r)] - v_[r];
            for (std::size_t c = 0; c < 3; ++c) out.J[r][c] = Real(r == c ? -1.0 : 0.0);
        }
    }

    void plane_row(const Vector3<Real>& q, Rows<Real>& out) const {
        const Real height = n_.dot(q);
        out.d[0] = height - v_[0];
        out.J[0][0] = Real(-1.0);
        out.J[0][1] = (q[0] - n_[0] * height) * over_N_;
        out.J[0][2] = (q[1] - n_[1] * height) * over_N_;
    }

    /// Vector from the axis to the point, across; `z` is how far along the axis the point is.
    Vector3<Real> across(const Vector3<Real>& q, Real& z) const {
        const Vector3<Real> w = q - P_;
        z = n_.dot(w);
        return w - n_ * z;
    }

    void line_rows(const Vector3<Real>& q, Rows<Real>& out) const {
        Real z;
        const Vector3<Real> w = across(q, z);
        for (std::size_t r = 0; r < 3; ++r) {
            const auto i = static_cast<Eigen::Index>(r);
            out.d[r] = w[i];
            for (std::size_t c = 0; c < 2; ++c) {
                const auto k = static_cast<Eigen::Index>(c);
                const Real one(r == c ? 1.0 : 0.0);
                out.J[r][c] = n_[i] * n_[k] - one;  // moves P
                // turns n by (e_k - n n_k)/N, of which e_k.w/N lengthens z
                out.J[r][2 + c] = -((one - n_[i] * n_[k]) * z + n_[i] * w[k]) * over_N_;
            }
        }
    }

    void circle_rows(const Vector3<Real>& q, Rows<Real>& out) const {
        using namespace real_functions;
        const bool in_space = form_ == Form::circle;
        if (in_space) plane_row(q, out);
        const std::size_t row = in_space ? 1 : 0, first = in_space ? 3 : 0;
        Real z;
        const Vector3<Real> w = across(q, z);
        const Real rho = sqrt(Real(w.dot(w))), over = Real(1.0) / rho;
        out.d[row] = rho - v_[first + 2];
        out.J[row][first] = -w[0] * over;
        out.J[row][first + 1] = -w[1] * over;
        out.J[row][first + 2] = w[0] * over - Real(1.0);
    }

    void sphere_row(const Vector3<Real>& q, Rows<Real>& out) const {
        using namespace real_functions;
        const Vector3<Real> w = q - P_;
        const Real rho = sqrt(Real(w.dot(w))), over = Real(1.0) / rho;
        out.d[0] = rho - v_[3];
        for (std::size_t c = 0; c < 3; ++c) out.J[0][c] = -w[static_cast<Eigen::Index>(c)] * over;
        out.J[0][3] = w[2] * over - Real(1.0);
    }

    /// Cylinder and cone: (rho - r) cos - z sin.
    void axis_row(const Vector3<Real>& q, Rows<Real>& out) const {
        using namespace real_functions;
        Real z;
        const Vector3<Real> w = across(q, z);
        const Real rho = sqrt(Real(w.dot(w))), over = Real(1.0) / rho;
        out.d[0] = (rho - v_[4]) * c_ - z * s_;
        for (std::size_t c = 0; c < 2; ++c) {
            const auto k = static_cast<Eigen::Index>(c);
            const Real e = w[k] * over;
            out.J[0][c] = n_[k] * s_ - e * c_;
            out.J[0][2 + c] = -(z * e * c_ + w[k] * s_) * over_N_;
        }
        out.J[0][4] = -out.J[0][0] - c_;
        if (form_ == Form::cone) out.J[0][5] = -((rho - v_[4]) * s_ + z * c_);
    }

    Form form_;
    const Parameters<Real>& v_;
    Vector3<Real> n_, P_;
    Real over_N_, c_, s_;  ///< 1/|(a, b, 1)|, cosine and sine of half a cone's angle
};

/// Square of the deviation that counts as one of form: of a circle the one in its plane.
template <class Real>
Real square_of(Form form, const Rows<Real>& rows) {
    if (form == Form::circle) return rows.d[1] * rows.d[1];
    Real sum = rows.d[0] * rows.d[0];
    for (std::size_t r = 1; r < facts_of(form).rows; ++r) sum = sum + rows.d[r] * rows.d[r];
    return sum;
}

/// Positive outside, on the side of the normal; of points and lines in space the distance.
template <class Real>
Real deviation_of(Form form, const Rows<Real>& rows) {
    using namespace real_functions;
    if (form == Form::circle) return rows.d[1];
    if (facts_of(form).rows == 1) return rows.d[0];
    return sqrt(square_of(form, rows));
}

}  // namespace covaria::geometry
