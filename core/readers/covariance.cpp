#include "core/readers/covariance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace covaria {

Result<TakenCovariance> take_covariance(const Eigen::MatrixXd& covariance) {
    TakenCovariance taken{covariance.diagonal().cwiseSqrt(), {}};
    if (!taken.u.allFinite())
        return fail(ErrorCode::bad_input, tell<"a variance of its covariance matrix is negative">());
    const Eigen::VectorXd inverse = taken.u.unaryExpr([](double u) { return u > 0.0 ? 1.0 / u : 0.0; });
    const Eigen::MatrixXd r = inverse.asDiagonal() * covariance * inverse.asDiagonal();
    if (!r.allFinite() || (r - r.transpose()).cwiseAbs().maxCoeff() > 1e-6)
        return fail(ErrorCode::bad_input, tell<"its covariance matrix is not symmetric">());
    // The eigenvalues may be a little below 0, because figures are rounded when they are written.
    if (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(r, Eigen::EigenvaluesOnly).eigenvalues().minCoeff() <
        -1e-6)
        return fail(ErrorCode::bad_input,
                    tell<"its matrix is no covariance matrix: a variance of some combination is negative">());
    for (Eigen::Index j = 0; j < r.cols(); ++j)
        for (Eigen::Index i = 0; i < j; ++i)
            if (r(i, j) != 0.0)
                taken.correlations.push_back({static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                                              std::clamp(r(i, j), -1.0, 1.0)});
    return taken;
}

}  // namespace covaria
