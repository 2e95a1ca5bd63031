#include "core/kinds/network/adjustment.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "core/math/decompositions.h"

namespace covaria {

Eigen::MatrixXd estimate_of_shared(const Eigen::MatrixXd& A) {
    // QR of (A; I) solves it, never AᵀA: beside a figure of 10 m one of 10 um would be lost among roundings.
    // The smaller of the decompositions of A and Aᵀ is taken.
    const bool by_deviations = A.cols() <= A.rows();
    const Eigen::Index rows = by_deviations ? A.rows() : A.cols(), n = by_deviations ? A.cols() : A.rows();
    Eigen::MatrixXd stacked(rows + n, n);
    if (by_deviations)
        stacked.topRows(rows) = A;
    else
        stacked.topRows(rows) = A.transpose();
    stacked.bottomRows(n).setIdentity();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(stacked);
    Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(rows + n, n);
    Q.applyOnTheLeft(qr.householderQ());
    const auto R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd found = R.solve(Eigen::MatrixXd(Q.topRows(rows).transpose()));
    if (by_deviations) return found;
    return found.transpose();
}

bool localises(const Eigen::MatrixXd& to_point) {
    if (to_point.rows() < 3) return false;
    const Eigen::MatrixXd directions = to_point.rowwise().normalized();
    const Eigen::VectorXd values = singular_values(directions).singularValues();
    return values[2] > 1e-9 * values[0];
}

Eigen::VectorXd weighting_uncertainties(const Eigen::MatrixXd& to_points, const Eigen::VectorXd& u,
                                        const Eigen::MatrixXd& shared) {
    constexpr double least_share = 1e-5;
    // Squares of weights must not differ by more than the digits of a double: with what is shared small, the
    // floor is a share of that; with it large, at most a hundredth of the smallest figure that is stated.
    constexpr double most_of_smallest = 1e3;
    const Eigen::VectorXd total = (u.cwiseAbs2() + shared.rowwise().squaredNorm()).cwiseSqrt();
    const Eigen::VectorXd per_metre = to_points.rowwise().norm();
    // A reading without any uncertainty is compared with the others as a displacement.
    const double largest = total.cwiseQuotient(per_metre).maxCoeff();
    double smallest = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < u.size(); ++i)
        if (u[i] > 0.0) smallest = std::min(smallest, u[i] / per_metre[i]);
    Eigen::VectorXd weighting = u;
    for (Eigen::Index i = 0; i < u.size(); ++i) {
        if (u[i] > 0.0) continue;
        const double own = total[i] > 0.0 ? total[i] : per_metre[i] * (largest > 0.0 ? largest : 1.0);
        weighting[i] = least_share * std::min(own, most_of_smallest * per_metre[i] * smallest);
    }
    return weighting;
}

Eigen::MatrixXd least_squares_gain(const Eigen::MatrixXd& to_points, const Eigen::VectorXd& u,
                                   const Eigen::MatrixXd& shared) {
    const Eigen::VectorXd by_u = u.cwiseInverse();
    const Eigen::MatrixXd J = by_u.asDiagonal() * to_points;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(J);
    const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(J.rows(), J.cols());
    // The gain is first that of the points with the shared deviations known ...
    Eigen::MatrixXd gain =
        qr.matrixQR().topRows(J.cols()).triangularView<Eigen::Upper>().solve(Eigen::MatrixXd(Q.transpose()));
    if (shared.cols() > 0) {
        // ... and these from what the points leave over, each with a standard uncertainty of one beforehand.
        const Eigen::MatrixXd F = by_u.asDiagonal() * shared;
        Eigen::MatrixXd left = F - Q * (Q.transpose() * F);
        left -= Q * (Q.transpose() * left);  // without redundancy nothing is left, not even rounding
        gain -= (gain * F) * estimate_of_shared(left);
    }
    return gain * by_u.asDiagonal();
}

}  // namespace covaria
