#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/evidence/weighing.h"

namespace covaria::evidence {

namespace {

/// Readings share components of uncertainty, so that their matrices are full. The unknowns, which are all
/// determined, are left out once and for all: K spans what no unknown moves, and M = K (Kᵀ Q K)⁻¹ Kᵀ is a
/// matrix of the size of the redundancy, which is often much less than the number of readings.
class WeighingTogether : public Weighing {
public:
    explicit WeighingTogether(const RedundantReadings& readings)
        : readings_(readings), design_(readings.design) {
        const Eigen::VectorXd stated = ones();
        // Lengths and angles stand in one matrix: in units of their own standard uncertainties.
        by_ = covariance(stated).diagonal().cwiseSqrt().cwiseInverse();
        if (!by_.allFinite() || degrees_of_freedom() <= 0) return;
        const Eigen::MatrixXd free = left_free();
        if (!free.allFinite()) return;
        residuals_ = free.transpose() * by_.cwiseProduct(readings.residuals);
        for (const Eigen::MatrixXd& share : readings.shares) first_.push_back(add(share.cols()));
        first_.push_back(components_);
        parts_.resize(free.cols(), components_);
        for (std::size_t k = 0; k < readings.shares.size(); ++k)
            part(parts_, k) = free.transpose() * (by_.asDiagonal() * readings.shares[k]);
        others_ = Eigen::MatrixXd::Zero(free.cols(), free.cols());
        if (readings.others.size() > 0)
            others_.selfadjointView<Eigen::Lower>().rankUpdate(free.transpose() *
                                                               (by_.asDiagonal() * readings.others));
    }

    std::optional<Sums> sums(const Eigen::VectorXd& square) const override {
        const auto factors = factors_of(square);
        if (!factors) return std::nullopt;
        // Columns of components of standard uncertainty one with the components as they are now.
        Eigen::MatrixXd scaled = parts_;
        for (std::size_t k = 0; k < figures(); ++k)
            part(scaled, k) *= std::sqrt(square[static_cast<Eigen::Index>(k)]);
        const Eigen::MatrixXd B = factors->matrixL().solve(scaled);
        const Eigen::MatrixXd G = B.transpose() * B;
        const Eigen::VectorXd e = B.transpose() * factors->matrixL().solve(residuals_);
        Sums sums(square.size());
        for (std::size_t k = 0; k < figures(); ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            const auto of_k = e.segment(first_[k], count(k));
            sums.redundancy[at] = G.diagonal().segment(first_[k], count(k)).sum();
            sums.residuals[at] = of_k.squaredNorm();
            for (std::size_t l = 0; l < figures(); ++l) {
                const auto block = G.block(first_[k], first_[l], count(k), count(l));
                sums.squares(at, static_cast<Eigen::Index>(l)) = block.squaredNorm();
                sums.observed(at, static_cast<Eigen::Index>(l)) =
                    of_k.dot(block * e.segment(first_[l], count(l)));
            }
        }
        return sums;
    }

    std::optional<double> mean_u(const Eigen::VectorXd& square) const override {
        const auto cofactors = cofactors_of(square);
        if (!cofactors) return std::nullopt;
        double sum = 0.0;
        for (const std::size_t i : readings_.measurands)
            sum += (*cofactors)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
        return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, readings_.measurands.size())));
    }

    double sum_of_squares() const override {
        const auto factors = factors_of(ones());
        return factors ? factors->matrixL().solve(residuals_).squaredNorm() : 0.0;
    }
    int degrees_of_freedom() const override { return static_cast<int>(design_.rows() - design_.cols()); }

private:
    using Factors = Eigen::LLT<Eigen::MatrixXd>;
    template <class Matrix>
    using Columns = Eigen::Block<Matrix, Eigen::Dynamic, Eigen::Dynamic, true>;

    std::size_t figures() const { return readings_.shares.size(); }
    Eigen::VectorXd ones() const { return Eigen::VectorXd::Ones(static_cast<Eigen::Index>(figures())); }
    Eigen::Index count(std::size_t k) const { return first_[k + 1] - first_[k]; }
    Eigen::Index add(Eigen::Index columns) { return std::exchange(components_, components_ + columns); }
    /// Columns of a figure in a matrix of those of all.
    Columns<Eigen::MatrixXd> part(Eigen::MatrixXd& all, std::size_t k) const {
        return all.middleCols(first_[k], count(k));
    }
    Columns<const Eigen::MatrixXd> part(const Eigen::MatrixXd& all, std::size_t k) const {
        return all.middleCols(first_[k], count(k));
    }

    /// Q of the readings.
    Eigen::MatrixXd covariance(const Eigen::VectorXd& square) const {
        Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(design_.rows(), design_.rows());
        if (readings_.others.size() > 0) Q = readings_.others * readings_.others.transpose();
        for (std::size_t k = 0; k < figures(); ++k)
            Q += square[static_cast<Eigen::Index>(k)] * readings_.shares[k] * readings_.shares[k].transpose();
        return Q;
    }

    /// Orthonormal columns that span what no unknown moves of the readings over their u.
    Eigen::MatrixXd left_free() const {
        const Eigen::MatrixXd whitened = by_.asDiagonal() * design_;
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(whitened *
                                                       whitened.colwise().norm().cwiseInverse().asDiagonal());
        Eigen::MatrixXd last = Eigen::MatrixXd::Zero(design_.rows(), degrees_of_freedom());
        last.bottomRows(degrees_of_freedom()).setIdentity();
        return qr.householderQ() * last;
    }

    /// Factors of Kᵀ Q K.
    std::optional<Factors> factors_of(const Eigen::VectorXd& square) const {
        if (residuals_.size() == 0) return std::nullopt;
        Eigen::MatrixXd Q = others_;
        for (std::size_t k = 0; k < figures(); ++k)
            Q.selfadjointView<Eigen::Lower>().rankUpdate(part(parts_, k),
                                                         square[static_cast<Eigen::Index>(k)]);
        Factors factors(Q);
        if (factors.info() != Eigen::Success) return std::nullopt;
        return factors;
    }

    std::optional<Eigen::MatrixXd> cofactors_of(const Eigen::VectorXd& square) const {
        if (!by_.allFinite()) return std::nullopt;
        const Factors factors(by_.asDiagonal() * covariance(square) * by_.asDiagonal());
        if (factors.info() != Eigen::Success) return std::nullopt;
        const Eigen::MatrixXd L_A = factors.matrixL().solve(by_.asDiagonal() * design_);
        const Eigen::VectorXd scale = L_A.colwise().norm().cwiseInverse();
        if (!scale.allFinite()) return std::nullopt;
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(L_A * scale.asDiagonal());
        const Eigen::Index n = design_.cols();
        const Eigen::MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
        const Eigen::MatrixXd by_R = R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(n, n));
        const Eigen::MatrixXd root = scale.asDiagonal() * by_R;
        return root * root.transpose();
    }

    const RedundantReadings& readings_;
    const Eigen::MatrixXd design_;
    Eigen::VectorXd by_;               ///< of each reading, one over its u as stated
    Eigen::VectorXd residuals_;        ///< Kᵀ v
    Eigen::MatrixXd parts_;            ///< Kᵀ times the shares of all figures, in columns
    Eigen::MatrixXd others_;           ///< Kᵀ Q K of what is not asked about, its lower half
    std::vector<Eigen::Index> first_;  ///< column of each figure in `parts_`, and where they end
    Eigen::Index components_ = 0;
};

}  // namespace

std::unique_ptr<Weighing> weighing_together(const RedundantReadings& readings) {
    return std::make_unique<WeighingTogether>(readings);
}

}  // namespace covaria::evidence
