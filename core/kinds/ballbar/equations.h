// The equations of "TCP from ballbars", once for every number type (Brosed et al., Eqs 1 to 8).
#pragma once

#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/ballbar/setup.h"

namespace covaria::tcp {

/// Upper triangle of a symmetric matrix.
template <class Real>
struct Symmetric {
    Real xx = Real(0.0), xy = Real(0.0), xz = Real(0.0), yy = Real(0.0), yz = Real(0.0), zz = Real(0.0);

    void add(const Vector3<Real>& v) {
        xx += v[0] * v[0];
        xy += v[0] * v[1];
        xz += v[0] * v[2];
        yy += v[1] * v[1];
        yz += v[1] * v[2];
        zz += v[2] * v[2];
    }
    /// This minus v vᵀ times `factor`.
    Symmetric less(const Vector3<Real>& v, const Real& factor) const {
        const Vector3<Real> w = v * factor;
        return {xx - v[0] * w[0], xy - v[0] * w[1], xz - v[0] * w[2],
                yy - v[1] * w[1], yz - v[1] * w[2], zz - v[2] * w[2]};
    }
    Symmetric plus(const Symmetric& b) const {
        return {xx + b.xx, xy + b.xy, xz + b.xz, yy + b.yy, yz + b.yz, zz + b.zz};
    }
    Symmetric cofactors() const {
        return {yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy,
                xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
    }
    /// The square of this over its trace.
    Symmetric squared_over_trace() const {
        const Real s = Real(1.0) / (xx + yy + zz), f = s * s;
        return {(xx * xx + xy * xy + xz * xz) * f, (xx * xy + xy * yy + xz * yz) * f,
                (xx * xz + xy * yz + xz * zz) * f, (xy * xy + yy * yy + yz * yz) * f,
                (xy * xz + yy * yz + yz * zz) * f, (xz * xz + yz * yz + zz * zz) * f};
    }
    Vector3<Real> times(const Vector3<Real>& v) const {
        return {Real(xx * v[0] + xy * v[1] + xz * v[2]), Real(xy * v[0] + yy * v[1] + yz * v[2]),
                Real(xz * v[0] + yz * v[1] + zz * v[2])};
    }
    Matrix3<Real> matrix() const {
        Matrix3<Real> M;
        M << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        return M;
    }
};

template <class Real>
Vector3<Real> unit(const Vector3<Real>& v) {
    using namespace real_functions;
    return v * Real(Real(1.0) / sqrt(Real(v.dot(v))));
}

/// Normal of the plane by total least squares: eigenvector of the least eigenvalue of the scatter matrix. The
/// matrix of cofactors has the same eigenvectors and the largest eigenvalue for it, even where the least is
/// 0; its eighth power leaves the others behind by the eighth power of the ratio of the two least
/// eigenvalues. The sign is that of `nominal`.
template <class Real>
Vector3<Real> plane_normal(const Symmetric<Real>& scatter, const Eigen::Vector3d& nominal) {
    Symmetric<Real> power = scatter.cofactors();
    for (int doubling = 0; doubling < 3; ++doubling) power = power.squared_over_trace();
    return unit<Real>(power.times(nominal.cast<Real>()));
}

/// Centre of the sphere through the points: linear least squares of |q|² = 2 q·c + const, `scatter` and
/// `mean` being those of the points.
template <class Real>
Vector3<Real> sphere_centre(std::span<const Vector3<Real>> q, const Symmetric<Real>& scatter,
                            const Vector3<Real>& mean) {
    Vector3<Real> g = Vector3<Real>::Zero();
    for (const Vector3<Real>& point : q) {
        const Vector3<Real> d = point - mean;
        g += d * Real(Real(0.5) * d.dot(d));
    }
    return mean + solved_symmetric<Real>(scatter.matrix(), g);
}

/// Geometric fit from there: Gauss-Newton steps for centre and radius. The error of a step is in proportion
/// to residuals over radius (1e-4), and the start is right to first order.
inline constexpr int sphere_steps = 2;
template <class Real>
void refine_sphere(std::span<const Vector3<Real>> q, Vector3<Real>& centre) {
    using namespace real_functions;
    const Real by_n(1.0 / static_cast<double>(q.size()));
    for (int step = 0; step < sphere_steps; ++step) {
        Symmetric<Real> directions;
        Vector3<Real> sum = Vector3<Real>::Zero(), moment = Vector3<Real>::Zero();
        Real lengths(0.0);
        for (const Vector3<Real>& point : q) {
            const Vector3<Real> d = point - centre;
            const Real r = sqrt(Real(d.dot(d)));
            const Vector3<Real> a = d * Real(Real(1.0) / r);
            directions.add(a);
            sum += a;
            moment += d;
            lengths += r;
        }
        const Vector3<Real> g = moment - sum * Real(lengths * by_n);
        centre += solved_symmetric<Real>(directions.less(sum, by_n).matrix(), g);
    }
}

/// Orthonormal matrix nearest to one that almost is: Newton's method on the polar decomposition.
template <class Real>
Matrix3<Real> nearest_axes(Matrix3<Real> F) {
    constexpr int steps = 4;
    for (int step = 0; step < steps; ++step) {
        Matrix3<Real> cofactors;
        cofactors.col(0) = F.col(1).cross(F.col(2));
        cofactors.col(1) = F.col(2).cross(F.col(0));
        cofactors.col(2) = F.col(0).cross(F.col(1));
        const Real by_determinant = Real(1.0) / Real(F.col(0).dot(cofactors.col(0)));
        F = ((F + cofactors * by_determinant) * Real(0.5)).eval();
    }
    return F;
}

/// Axes of the flange from the measured normals (columns; those not measured are not read).
template <class Real>
Matrix3<Real> flange_axes(const TcpSetup& setup, const Matrix3<Real>& normals) {
    const int f = setup.first_axis, s = setup.second_axis, t = 3 - f - s;
    const Real sign((s - f + 3) % 3 == 1 ? 1.0 : -1.0);
    Matrix3<Real> F = normals;
    const Vector3<Real> a = normals.col(f), b = normals.col(s);
    const Vector3<Real> third = unit<Real>(a.cross(b)) * sign;
    if (setup.frame.first < 0) {
        if (!setup.measures(t)) F.col(t) = third;
        return nearest_axes<Real>(F);
    }
    F.col(t) = third;
    F.col(s) = third.cross(a) * sign;
    return F;
}

/// Sums over the points of one sequence, counted from the nominal centre of the flange.
template <class Real>
struct SequenceSums {
    Symmetric<Real> squares;
    Vector3<Real> q, cosine_q, sine_q;
};

template <class Real>
SequenceSums<Real> sums_of(const TcpSetup& setup, const Sequence& sequence, const Vector3<Real>* q) {
    SequenceSums<Real> sums{{}, Vector3<Real>::Zero(), Vector3<Real>::Zero(), Vector3<Real>::Zero()};
    for (std::size_t i = sequence.first; i < sequence.first + sequence.count; ++i) {
        sums.squares.add(q[i]);
        sums.q += q[i];
        sums.cosine_q += q[i] * Real(setup.points[i].cosine);
        sums.sine_q += q[i] * Real(setup.points[i].sine);
    }
    return sums;
}

template <class Real>
struct Flange {
    Matrix3<Real> normals, axes;
    Vector3<Real> centre;  ///< centre, from the nominal one
    Vector3<Real> tool;    ///< tool in the flange's axes
};

/// Eq 8: every point turned back by its rotation gives the tool; their mean.
template <class Real>
Vector3<Real> mean_tool(const TcpSetup& setup, const SequenceSums<Real>* sums, const Flange<Real>& flange) {
    Vector3<Real> tool = Vector3<Real>::Zero();
    for (std::size_t k = 0; k < setup.sequences.size(); ++k) {
        const Sequence& s = setup.sequences[k];
        const Matrix3<Real> to_flange = flange.axes.transpose();
        const Real n(static_cast<double>(s.count));
        const Vector3<Real> v = to_flange * (sums[k].q - flange.centre * n);
        const Vector3<Real> cv = to_flange * (sums[k].cosine_q - flange.centre * Real(s.sum_cosine));
        const Vector3<Real> sv = to_flange * (sums[k].sine_q - flange.centre * Real(s.sum_sine));
        const int a = s.axis, b = (a + 1) % 3, c = (a + 2) % 3;
        tool[a] += v[a];
        tool[b] += cv[b] + sv[c];
        tool[c] += cv[c] - sv[b];
    }
    return tool * Real(1.0 / static_cast<double>(setup.points.size()));
}

/// Fits the flange: everything that follows from the measured points (q, from the nominal centre).
template <class Real>
Flange<Real> fit_flange(const TcpSetup& setup, std::span<const Vector3<Real>> q) {
    std::array<SequenceSums<Real>, 3> sums;
    Flange<Real> flange;
    flange.normals = Matrix3<Real>::Zero();
    Symmetric<Real> squares;
    Vector3<Real> total = Vector3<Real>::Zero();
    for (std::size_t k = 0; k < setup.sequences.size(); ++k) {
        const Sequence& s = setup.sequences[k];
        sums[k] = sums_of<Real>(setup, s, q.data());
        const Symmetric<Real> scatter =
            sums[k].squares.less(sums[k].q, Real(1.0 / static_cast<double>(s.count)));
        flange.normals.col(s.axis) = plane_normal<Real>(scatter, setup.X_BF.linear().col(s.axis));
        squares = squares.plus(sums[k].squares);
        total += sums[k].q;
    }
    const Real by_n(1.0 / static_cast<double>(q.size()));
    flange.centre = sphere_centre<Real>(q, squares.less(total, by_n), total * by_n);
    if (setup.geometric_sphere) refine_sphere<Real>(q, flange.centre);
    flange.axes = flange_axes<Real>(setup, flange.normals);
    flange.tool = mean_tool<Real>(setup, sums.data(), flange);
    return flange;
}

/// Supports as the instrument takes them to be in one trial.
template <class Real, class In>
void read_supports(const TcpSetup& setup, const In& x, Vector3<Real>* supports) {
    std::array<Real, 3 * (most_supports - 2)> lengths;
    std::array<Real, most_supports> heights;
    const std::size_t n = setup.supports.size(), count = 3 + 3 * (n - 3);
    for (std::size_t i = 0; i < count; ++i) lengths[i] = x[i];
    for (std::size_t k = 0; k < n - 3; ++k) heights[k] = x[count + k];
    support_positions<Real>({lengths.data(), count}, {heights.data(), n - 3}, supports);
}

/// Computes the readings of the bars at one point: the lengths to where the robot has really gone.
template <class Real, class In>
void read_lengths(const TcpSetup& setup, const Point& point, const PointInputs& inputs, const In& x,
                  Real* lengths) {
    using namespace real_functions;
    const std::size_t n = setup.supports.size();
    if (!setup.robot) {
        for (std::size_t j = 0; j < n; ++j) lengths[j] = x[inputs.reading + j];
        return;
    }
    const std::size_t first = inputs.position;
    auto e = Vector3<Real>(Real(x[first]), Real(x[first + 1]), Real(x[first + 2]));
    if (setup.turns) {
        const std::size_t turn = inputs.orientation;
        const auto w = Vector3<Real>(Real(x[turn]), Real(x[turn + 1]), Real(x[turn + 2]));
        e += point.lever.cast<Real>() * w;
    }
    const Vector3<Real> p = e + point.p_B.cast<Real>();
    for (std::size_t j = 0; j < n; ++j) {
        const Vector3<Real> d = p - setup.supports[j].cast<Real>();
        lengths[j] = x[inputs.reading + j] + (sqrt(Real(d.dot(d))) - Real(point.length[j]));
    }
}

/// Adjusts p to all lengths by least squares, each with the weight of its own uncertainty at this point, from
/// where the first three meet; in trials in which they do not, from the point's place at the estimates.
template <class Real>
void adjust_by_all(const Point& point, std::span<const Vector3<Real>> supports, const Real* lengths,
                   const mask_of<Real>& meets, Vector3<Real>& p) {
    using namespace real_functions;
    for (int c = 0; c < 3; ++c) p[c] = select(meets, p[c], Real(point.p_B[c]));
    for (int step = 0; step < multilateration_steps; ++step)
        multilateration_step<Real>(supports, lengths, point.weights.data(), 3, p);
}

/// Computes one trial. Inputs: lengths between supports, heights of further supports, then for every point
/// its readings, the robot's deviation and rotation. Outputs: see OutputPlaces.
template <class Real, class In, class Out>
mask_of<Real> procedure(const TcpSetup& setup, std::span<const PointInputs> inputs, const In& x, Out& y) {
    using namespace real_functions;
    const std::size_t n = setup.supports.size();
    std::array<Vector3<Real>, most_supports> supports;
    read_supports<Real>(setup, x, supports.data());
    const Trilateration<Real> by_three(SupportTriangle<Real>{supports[1][0], supports[2][0], supports[2][1]});
    const double side = setup.ballbars->side();
    const Vector3<Real> centre = setup.X_BF.translation().cast<Real>();
    const OutputPlaces places(setup);

    mask_of<Real> valid(true);
    std::array<Vector3<Real>, most_points> q;
    std::array<Real, most_supports> lengths;
    for (std::size_t i = 0; i < setup.points.size(); ++i) {
        read_lengths<Real>(setup, setup.points[i], inputs[i], x, lengths.data());
        Vector3<Real> p;
        const mask_of<Real> meets = by_three.locate(lengths.data(), side, p);
        if (n > 3)
            adjust_by_all<Real>(setup.points[i], {supports.data(), n}, lengths.data(), meets, p);
        else
            valid = valid && meets;
        for (int c = 0; c < 3; ++c) y.set(places.points + 3 * i + static_cast<std::size_t>(c), p[c]);
        q[i] = p - centre;
    }
    if (!setup.finds_tool()) return valid;

    const Flange<Real> flange = fit_flange<Real>(setup, {q.data(), setup.points.size()});
    for (int c = 0; c < 3; ++c) {
        y.set(static_cast<std::size_t>(c), flange.tool[c]);
        y.set(places.centre + static_cast<std::size_t>(c), flange.centre[c] + centre[c]);
    }
    const Matrix3<Real> nominal = setup.X_BF.linear().transpose().cast<Real>();
    std::size_t out = places.angles;
    for (const Sequence& s : setup.sequences) {
        const Vector3<Real> normal = flange.normals.col(s.axis);
        const Vector3<Real> v = nominal * normal;
        for (int other = 0; other < 3; ++other)
            if (other != s.axis) y.set(out++, atan2(v[other], v[s.axis]));
    }
    return valid;
}

}  // namespace covaria::tcp
