#include "core/adjustment/group_test.h"

#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"

namespace covaria::adjustment {

GroupTest test_of_group(const Adjustment& adjustment, const SparseRows& whitening,
                        const Eigen::VectorXd& residuals, const std::vector<std::size_t>& readings) {
    constexpr double least_controlled = 1e-6;
    const auto k = static_cast<Eigen::Index>(readings.size());
    const Eigen::VectorXd weighted = whitening * residuals;
    // The matrix E selects the readings, at a size of one each: S = Eᵀ C⁻¹ Q_vv C⁻¹ E and t = Eᵀ C⁻¹ v.
    Eigen::MatrixXd S(k, k);
    Eigen::VectorXd t(k);
    std::vector<Eigen::VectorXd> columns, by_unknowns;
    for (const std::size_t i : readings) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(whitening.rows(), static_cast<Eigen::Index>(i));
        columns.push_back((whitening * unit).normalized());
        by_unknowns.push_back(adjustment.whitened().transpose() * columns.back());
    }
    for (Eigen::Index j = 0; j < k; ++j) {
        const auto b = static_cast<std::size_t>(j);
        const Eigen::VectorXd changes = adjustment.step(by_unknowns[b]);
        t[j] = columns[b].dot(weighted);
        for (Eigen::Index i = 0; i < k; ++i) {
            const auto a = static_cast<std::size_t>(i);
            S(i, j) = columns[a].dot(columns[b]) - by_unknowns[a].dot(changes);
        }
    }
    const auto svd = singular_values(Eigen::MatrixXd(0.5 * (S + S.transpose())), Eigen::ComputeFullU);
    GroupTest test;
    for (Eigen::Index j = 0; j < k; ++j) {
        if (!(svd.singularValues()[j] > least_controlled)) continue;
        const double along = svd.matrixU().col(j).dot(t);
        test.statistic += along * along / svd.singularValues()[j];
        ++test.redundancy;
    }
    if (test.redundancy > 0) test.p = chi_squared_upper_tail(test.statistic, test.redundancy);
    return test;
}

}  // namespace covaria::adjustment
