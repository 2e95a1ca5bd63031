// Least squares of points whose coordinates are correlated, over any number type (ISO/TS 28037:2010, 10).
#pragma once

#include <vector>

#include "core/kinds/curve/equations.h"

namespace covaria::curve {

/// The whole covariance matrix of a set-up's points, with t in place of x.
struct PointCovariance {
    Eigen::MatrixXd tt, ty, yy;  ///< ty(i, j): of t_i and y_j

    PointCovariance(const CurveSetup& setup, const Polynomials& polynomials) {
        const auto n = Eigen::Index(setup.points.size());
        const double width = polynomials.half_width;
        tt = setup.covariance.topLeftCorner(n, n) / (width * width);
        ty = setup.covariance.topRightCorner(n, n) / width;
        yy = setup.covariance.bottomRightCorner(n, n);
    }
};

/// Scratch of one thread, kept between trials: the hot loop allocates nothing.
template <class Real>
struct CovarianceWorkspace {
    std::vector<Real> t, y, place, slope, residual, matrix, multiplier;
    std::vector<Values<Real>> phi;

    void resize(std::size_t n) {
        for (auto* list : {&t, &y, &place, &slope, &residual, &multiplier})
            if (list->size() < n) list->resize(n);
        if (matrix.size() < n * n) matrix.resize(n * n);
        if (phi.size() < n) phi.resize(n);
    }
};

/// Gauss-Newton steps for the curve and the true places of the points together. With the places eliminated,
/// the residuals r = y - curve - slope (t - place) have the covariance matrix
/// M = V_yy - S V_ty - V_yt S + S V_tt S = L L^T, S the slopes.
template <class Real>
class CovarianceSteps {
public:
    CovarianceSteps(const PointCovariance& covariance, const Polynomials& polynomials,
                    CovarianceWorkspace<Real>& work, std::size_t points)
        : v_(covariance), polynomials_(polynomials), w_(work), n_(points) {}

    /// A step of the q from where they are; the sum of squares r^T M^-1 r before it. `settled` says of each
    /// number whether neither q nor a place has moved by what matters.
    Real step(Values<Real>& q, mask_of<Real>& settled) {
        using namespace real_functions;
        linearise(q);
        factorise();
        whiten();
        NormalEquations<Real> normal(polynomials_.count);
        Real squares(0.0);
        for (std::size_t i = 0; i < n_; ++i) {
            normal.add(w_.phi[i], w_.residual[i], Real(1.0));
            squares = squares + w_.residual[i] * w_.residual[i];
        }
        Values<Real> root;  // 1/u(q_j)
        Real limit(settled_limit);
        for (std::size_t j = 0; j < polynomials_.count; ++j) {
            root[j] = sqrt(normal.matrix[j][j]);
            limit = max(limit, Real(rounding) * abs(root[j] * q[j]));
        }
        const Values<Real> change = normal.solve();
        settled = Real(0.0) == Real(0.0);
        for (std::size_t j = 0; j < polynomials_.count; ++j) {
            q[j] = q[j] + change[j];
            settled = settled && is_settled(Real(root[j] * change[j]), Real(root[j] * q[j]), limit);
        }
        settled = move_places(change) && settled;
        return squares;
    }

private:
    Real& at(std::size_t i, std::size_t j) { return w_.matrix[i * n_ + j]; }
    static double entry(const Eigen::MatrixXd& of, std::size_t i, std::size_t j) {
        return of(Eigen::Index(i), Eigen::Index(j));
    }

    void linearise(const Values<Real>& q) {
        for (std::size_t i = 0; i < n_; ++i) {
            Values<Real> slopes;
            polynomials_.at(w_.place[i], w_.phi[i], slopes);
            w_.slope[i] = sum_of(q, slopes, polynomials_.count);
            w_.residual[i] =
                w_.y[i] - sum_of(q, w_.phi[i], polynomials_.count) - w_.slope[i] * (w_.t[i] - w_.place[i]);
        }
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                at(i, j) = Real(entry(v_.yy, i, j)) - w_.slope[i] * Real(entry(v_.ty, i, j)) -
                           w_.slope[j] * Real(entry(v_.ty, j, i)) +
                           w_.slope[i] * w_.slope[j] * Real(entry(v_.tt, i, j));
    }

    void factorise() {
        using namespace real_functions;
        for (std::size_t j = 0; j < n_; ++j) {
            for (std::size_t k = 0; k < j; ++k) at(j, j) = at(j, j) - at(j, k) * at(j, k);
            at(j, j) = sqrt(at(j, j));
            for (std::size_t i = j + 1; i < n_; ++i) {
                for (std::size_t k = 0; k < j; ++k) at(i, j) = at(i, j) - at(i, k) * at(j, k);
                at(i, j) = at(i, j) / at(j, j);
            }
        }
    }

    void whiten() {
        for (std::size_t i = 0; i < n_; ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                w_.residual[i] = w_.residual[i] - at(i, k) * w_.residual[k];
                for (std::size_t c = 0; c < polynomials_.count; ++c)
                    w_.phi[i][c] = w_.phi[i][c] - at(i, k) * w_.phi[k][c];
            }
            w_.residual[i] = w_.residual[i] / at(i, i);
            for (std::size_t c = 0; c < polynomials_.count; ++c) w_.phi[i][c] = w_.phi[i][c] / at(i, i);
        }
    }

    /// place = t - (V_ty - V_tt S) M^-1 (r - Phi change)
    mask_of<Real> move_places(const Values<Real>& change) {
        for (std::size_t i = n_; i-- > 0;) {
            Real sum = w_.residual[i] - sum_of(change, w_.phi[i], polynomials_.count);
            for (std::size_t k = i + 1; k < n_; ++k) sum = sum - at(k, i) * w_.multiplier[k];
            w_.multiplier[i] = sum / at(i, i);
        }
        mask_of<Real> settled = Real(0.0) == Real(0.0);
        for (std::size_t i = 0; i < n_; ++i) {
            Real next = w_.t[i];
            for (std::size_t j = 0; j < n_; ++j)
                next = next -
                       (Real(entry(v_.ty, i, j)) - Real(entry(v_.tt, i, j)) * w_.slope[j]) * w_.multiplier[j];
            const double limit = std::max(settled_limit * std::sqrt(entry(v_.tt, i, i)), rounding);
            settled = settled && is_settled(Real(next - w_.place[i]), next, Real(limit));
            w_.place[i] = next;
        }
        return settled;
    }

    const PointCovariance& v_;
    const Polynomials& polynomials_;
    CovarianceWorkspace<Real>& w_;
    std::size_t n_;
};

/// q that minimise v^T V^-1 v, v the deviations of the points from their true places on the curve. `x(i)` and
/// `y(i)` give the coordinates. False where the steps have not settled; `squares` gets the least sum.
template <class Real, class X, class Y>
mask_of<Real> fit_with_covariance(const PointCovariance& covariance, const Polynomials& polynomials,
                                  std::size_t points, X x, Y y, Values<Real>& q, Real& squares) {
    using namespace real_functions;
    static thread_local CovarianceWorkspace<Real> work;
    work.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
        work.t[i] = work.place[i] = Real((x(i) - Real(polynomials.centre)) / Real(polynomials.half_width));
        work.y[i] = Real(y(i));
    }
    CovarianceSteps<Real> steps(covariance, polynomials, work, points);
    mask_of<Real> settled = Real(0.0) < Real(0.0);
    for (int step = 0; step < most_steps && !all(settled); ++step) squares = steps.step(q, settled);
    return settled;
}

}  // namespace covaria::curve
