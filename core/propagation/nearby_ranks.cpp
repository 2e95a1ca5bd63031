#include "core/propagation/nearby_ranks.h"

#include <Eigen/QR>
#include <algorithm>

#include "core/math/normal_quantile.h"

namespace covaria::detail {
namespace {

/// Score of the k-th of `count` values (Hyndman and Fan, The American Statistician 50 (1996) 361, definition
/// 8).
double normal_quantile_of_rank(std::uint64_t k, std::uint64_t count) {
    return normal_quantile((static_cast<double>(k) - 1.0 / 3.0) / (static_cast<double>(count) + 1.0 / 3.0));
}

}  // namespace

RankWeights weights_around(std::uint64_t rank, std::uint64_t count) {
    const std::uint64_t reach = std::min(rank / 2, count - rank);
    if (reach == 0) return {rank, {1.0}};  // a parabola through three values is the one in the middle
    RankWeights around{rank - reach, {}};
    const auto size = static_cast<Eigen::Index>(2 * reach + 1);
    const double z = normal_quantile_of_rank(rank, count);
    const double width = normal_quantile_of_rank(rank + reach, count) - z;
    Eigen::MatrixX3d powers(size, 3);
    for (Eigen::Index i = 0; i < size; ++i) {
        const double x =
            (normal_quantile_of_rank(around.first + static_cast<std::uint64_t>(i), count) - z) / width;
        powers.row(i) << 1.0, x, x * x;
    }
    // The value of the parabola at x = 0 is the first row of the pseudo-inverse times the values.
    const Eigen::MatrixXd q =
        Eigen::HouseholderQR<Eigen::MatrixX3d>(powers).householderQ() * Eigen::MatrixXd::Identity(size, 3);
    const Eigen::Matrix3d r = q.transpose() * powers;
    const Eigen::Vector3d at_zero =
        r.transpose().triangularView<Eigen::Lower>().solve(Eigen::Vector3d::UnitX());
    const Eigen::VectorXd weights = q * at_zero;
    around.weights.assign(weights.begin(), weights.end());
    return around;
}

}  // namespace covaria::detail
