#include "core/adjustment/reliability.h"

#include <cmath>
#include <limits>

#include "core/math/normal_quantile.h"

namespace covaria::adjustment {

namespace {

constexpr double least_redundancy = 1e-6;

/// The parts of P v, P Q_vv P and Q_vv P for readings that have a covariance in common.
struct BlockSums {
    Eigen::MatrixXd tested;
    Eigen::VectorXd redundancy;
};

BlockSums sums_of(const Adjustment& adjustment, const SparseRows& whitening,
                  const std::vector<std::size_t>& readings) {
    const auto n = static_cast<Eigen::Index>(readings.size());
    Eigen::MatrixXd W(n, n), C(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const std::size_t a = readings[static_cast<std::size_t>(i)],
                              b = readings[static_cast<std::size_t>(j)];
            W(i, j) = whitening.coeff(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
            C(i, j) = adjustment.cofactor_of_readings(a, b);
        }
    const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(n, n) - C;
    const Eigen::MatrixXd by_left = left * W;
    return {W.transpose() * by_left, W.triangularView<Eigen::Lower>().solve(by_left).diagonal()};
}

}  // namespace

double outlier_limit(std::size_t tests) {
    return normal_quantile(1.0 - 0.5 * significance / static_cast<double>(tests));
}

double non_centrality() {
    return outlier_limit() + normal_quantile(power);
}

Reliability reliability_of(const Adjustment& adjustment, const SparseRows& whitening,
                           const std::vector<CovarianceBlock>& blocks, const Eigen::VectorXd& residuals) {
    Reliability found;
    const Eigen::VectorXd whitened = whitening * residuals;
    found.sum_of_squares = whitened.squaredNorm();
    found.degrees_of_freedom = adjustment.degrees_of_freedom();
    if (found.degrees_of_freedom > 0) found.s0 = std::sqrt(found.sum_of_squares / found.degrees_of_freedom);
    const Eigen::VectorXd weighted = whitening.transpose() * whitened;
    found.readings.resize(adjustment.readings());
    const double sure_to_be_found = non_centrality();
    const auto put = [&](std::size_t i, double tested, double redundancy) {
        ReadingReliability& reading = found.readings[i];
        const auto at = static_cast<Eigen::Index>(i);
        reading.residual = residuals[at];
        reading.redundancy = redundancy;
        reading.controlled = redundancy > least_redundancy && tested > 0.0;
        reading.detectable = std::numeric_limits<double>::infinity();
        if (!reading.controlled) return;
        reading.w = weighted[at] / std::sqrt(tested);
        reading.tau = found.s0 > 0.0 ? reading.w / found.s0 : 0.0;
        reading.detectable = sure_to_be_found / std::sqrt(tested);
    };
    const Eigen::VectorXd cofactors = adjustment.cofactors_of_readings();
    std::vector<char> in_block(adjustment.readings(), 0);
    for (const CovarianceBlock& block : blocks) {
        const BlockSums sums = sums_of(adjustment, whitening, block.readings);
        for (std::size_t k = 0; k < block.readings.size(); ++k) {
            in_block[block.readings[k]] = 1;
            put(block.readings[k], sums.tested(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)),
                sums.redundancy[static_cast<Eigen::Index>(k)]);
        }
    }
    for (std::size_t i = 0; i < in_block.size(); ++i) {
        if (in_block[i]) continue;
        const double redundancy = 1.0 - cofactors[static_cast<Eigen::Index>(i)],
                     weight = whitening.coeff(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
        put(i, redundancy * weight * weight, redundancy);
    }
    return found;
}

Eigen::VectorXd effect_of(const Adjustment& adjustment, const SparseRows& whitening, std::size_t reading) {
    Eigen::VectorXd e = Eigen::VectorXd::Zero(whitening.rows());
    e[static_cast<Eigen::Index>(reading)] = 1.0;
    return adjustment.step(adjustment.whitened().transpose() * (whitening * e));
}

}  // namespace covaria::adjustment
