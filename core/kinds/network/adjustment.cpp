#include "core/kinds/network/adjustment.h"

#include <Eigen/QR>

#include "core/math/decompositions.h"

namespace covaria {

Eigen::MatrixXd estimate_of_shared(const Eigen::MatrixXd& A) {
    if (A.cols() <= A.rows()) {  // the smaller of two matrices
        Eigen::MatrixXd N = A.transpose() * A;
        N.diagonal().array() += 1.0;
        return cholesky(N).solve(A.transpose());
    }
    Eigen::MatrixXd N = A * A.transpose();
    N.diagonal().array() += 1.0;
    return cholesky(N).solve(A).transpose();
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
    const Eigen::VectorXd total = (u.cwiseAbs2() + shared.rowwise().squaredNorm()).cwiseSqrt();
    const Eigen::VectorXd per_metre = to_points.rowwise().norm();
    // What is known without any uncertainty is compared with the others as a displacement.
    const double displacement = total.cwiseQuotient(per_metre).maxCoeff();
    Eigen::VectorXd least(u.size());
    for (Eigen::Index i = 0; i < u.size(); ++i)
        least[i] = total[i] > 0.0 ? total[i] : per_metre[i] * (displacement > 0.0 ? displacement : 1.0);
    return u.cwiseMax(least_share * least);
}

Eigen::MatrixXd least_squares_gain(const Eigen::MatrixXd& to_points, const Eigen::VectorXd& u,
                                   const Eigen::MatrixXd& shared) {
    const Eigen::VectorXd by_u = u.cwiseInverse();
    const Eigen::MatrixXd J = by_u.asDiagonal() * to_points;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(J);
    const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(J.rows(), J.cols());
    // Of the points with the shared deviations known ...
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
