#include "core/adjustment/group_test.h"

#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"

namespace covaria::adjustment {

GroupTests::GroupTests(const Adjustment& adjustment, const SparseRows& whitening,
                       const Eigen::VectorXd& residuals)
    : errors_(whitening) {
    for (Eigen::Index i = 0; i < errors_.cols(); ++i) errors_.col(i) /= errors_.col(i).norm();
    along_ = errors_.transpose() * (whitening * residuals);
    by_unknowns_ = adjustment.whitened().transpose() * errors_;
    changes_.resize(by_unknowns_.rows(), by_unknowns_.cols());
    for (Eigen::Index i = 0; i < changes_.cols(); ++i) changes_.col(i) = adjustment.step(by_unknowns_.col(i));
}

GroupTest GroupTests::of(const std::vector<std::size_t>& readings) const {
    constexpr double least_controlled = 1e-6;
    const auto k = static_cast<Eigen::Index>(readings.size());
    // S = Eᵀ C⁻¹ Q_vv C⁻¹ E of these readings.
    Eigen::MatrixXd S(k, k);
    Eigen::VectorXd t(k);
    for (Eigen::Index j = 0; j < k; ++j) {
        const auto b = static_cast<Eigen::Index>(readings[static_cast<std::size_t>(j)]);
        t[j] = along_[b];
        for (Eigen::Index i = 0; i < k; ++i) {
            const auto a = static_cast<Eigen::Index>(readings[static_cast<std::size_t>(i)]);
            S(i, j) = errors_.col(a).dot(errors_.col(b)) - by_unknowns_.col(a).dot(changes_.col(b));
        }
    }
    const auto axes = eigen_decomposition(0.5 * (S + S.transpose()));
    GroupTest test;
    for (Eigen::Index j = k - 1; j >= 0; --j) {
        if (!(axes.eigenvalues()[j] > least_controlled)) continue;
        const double along = axes.eigenvectors().col(j).dot(t);
        test.statistic += along * along / axes.eigenvalues()[j];
        ++test.redundancy;
    }
    if (test.redundancy > 0) test.p = chi_squared_upper_tail(test.statistic, test.redundancy);
    return test;
}

}  // namespace covaria::adjustment
