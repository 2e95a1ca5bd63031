#include <algorithm>
#include <cmath>

#include "core/adjustment/adjustment.h"
#include "core/evidence/weighing.h"

namespace covaria::evidence {

namespace {

using adjustment::Adjustment;
using adjustment::SparseRows;

constexpr std::size_t none = RedundantReadings::no_figure;

/// Weighing of readings with one figure each: in readings of standard uncertainty one, M is the residual
/// projector P = I - H, and a figure's part of it is some of its rows.
class WeighingApart : public Weighing {
public:
    explicit WeighingApart(const RedundantReadings& readings)
        : readings_(readings), stated_(readings.design, readings.whitening, readings.datum) {}

    std::optional<Sums> sums(const Eigen::VectorXd& square) const override {
        const SparseRows W = whitening(square);
        const Adjustment adjusted(readings_.design, W, readings_.datum);
        if (!adjusted.is_solved()) return std::nullopt;
        const SparseRows& A = adjusted.whitened();
        const Eigen::VectorXd before = W * readings_.residuals;
        const Eigen::VectorXd v = before - A * adjusted.step(A.transpose() * before);
        Sums sums(square.size());
        for (Eigen::Index i = 0; i < v.size(); ++i)
            if (const std::size_t of = figure_of(i); of != none)
                sums.residuals[static_cast<Eigen::Index>(of)] += v[i] * v[i];
        // As many solutions as readings, or as figures times unknowns.
        if (A.cols() * square.size() < A.rows())
            add_by_unknowns(adjusted, sums);
        else
            add_by_readings(adjusted, sums);
        const Eigen::MatrixXd parts = by_figures(v, square.size());
        for (Eigen::Index k = 0; k < square.size(); ++k)
            sums.observed.row(k) =
                (parts.col(k) - A * adjusted.step(A.transpose() * parts.col(k))).transpose() * parts;
        return sums;
    }

    std::optional<double> mean_u(const Eigen::VectorXd& square) const override {
        const Adjustment adjusted(readings_.design, whitening(square), readings_.datum);
        if (!adjusted.is_solved()) return std::nullopt;
        double sum = 0.0;
        for (const std::size_t i : readings_.measurands) sum += adjusted.cofactor(i, i);
        return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, readings_.measurands.size())));
    }

    double sum_of_squares() const override {
        return (readings_.whitening * readings_.residuals).squaredNorm();
    }
    int degrees_of_freedom() const override { return stated_.is_solved() ? stated_.degrees_of_freedom() : 0; }

private:
    /// Adds the squares of the rows of P.
    void add_by_readings(const Adjustment& adjusted, Sums& sums) const {
        const SparseRows& A = adjusted.whitened();
        for (Eigen::Index i = 0; i < A.rows(); ++i) {
            const std::size_t of = figure_of(i);
            if (of == none) continue;
            const auto k = static_cast<Eigen::Index>(of);
            Eigen::VectorXd row = -(A * adjusted.step(Eigen::VectorXd(A.row(i).transpose())));
            row[i] += 1.0;
            sums.redundancy[k] += row[i];
            for (Eigen::Index j = 0; j < row.size(); ++j)
                if (const std::size_t to = figure_of(j); to != none)
                    sums.squares(k, static_cast<Eigen::Index>(to)) += row[j] * row[j];
        }
    }

    /// The same by traces of Q N_k, where N_k is the part of figure k in the normal matrix: n_k − tr Q N_k,
    /// and tr Q N_k Q N_l, with n_k − 2 tr Q N_k more where l is k.
    void add_by_unknowns(const Adjustment& adjusted, Sums& sums) const {
        const SparseRows& A = adjusted.whitened();
        const Eigen::Index figures = sums.redundancy.size(), unknowns = A.cols();
        std::vector<Eigen::MatrixXd> QN;
        for (Eigen::Index k = 0; k < figures; ++k) {
            Eigen::VectorXd is_own = Eigen::VectorXd::Zero(A.rows());
            for (Eigen::Index i = 0; i < A.rows(); ++i)
                is_own[i] = figure_of(i) == static_cast<std::size_t>(k) ? 1.0 : 0.0;
            const SparseRows own = is_own.asDiagonal() * A;
            const Eigen::SparseMatrix<double> N = own.transpose() * own;
            Eigen::MatrixXd& of_figure = QN.emplace_back(unknowns, unknowns);
            for (Eigen::Index j = 0; j < unknowns; ++j)
                of_figure.col(j) = adjusted.step(Eigen::VectorXd(N.col(j)));
            const double count = is_own.sum(), trace = of_figure.trace();
            sums.redundancy[k] = count - trace;
            sums.squares(k, k) = count - 2.0 * trace;
        }
        for (Eigen::Index k = 0; k < figures; ++k)
            for (Eigen::Index l = 0; l < figures; ++l)
                sums.squares(k, l) += QN[static_cast<std::size_t>(k)]
                                          .cwiseProduct(QN[static_cast<std::size_t>(l)].transpose())
                                          .sum();
    }

    std::size_t figure_of(Eigen::Index reading) const {
        return readings_.figure_of[static_cast<std::size_t>(reading)];
    }
    /// The residuals of each figure, in columns.
    Eigen::MatrixXd by_figures(const Eigen::VectorXd& v, Eigen::Index figures) const {
        Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(v.size(), figures);
        for (Eigen::Index i = 0; i < v.size(); ++i)
            if (const std::size_t k = figure_of(i); k != none) parts(i, static_cast<Eigen::Index>(k)) = v[i];
        return parts;
    }
    SparseRows whitening(const Eigen::VectorXd& square) const {
        Eigen::VectorXd by = Eigen::VectorXd::Ones(readings_.residuals.size());
        for (Eigen::Index i = 0; i < by.size(); ++i)
            if (const std::size_t k = figure_of(i); k != none)
                by[i] = 1.0 / std::sqrt(square[static_cast<Eigen::Index>(k)]);
        return by.asDiagonal() * readings_.whitening;
    }

    const RedundantReadings& readings_;
    const Adjustment stated_;
};

}  // namespace

Sums::Sums(Eigen::Index figures)
    : squares(Eigen::MatrixXd::Zero(figures, figures)),
      observed(Eigen::MatrixXd::Zero(figures, figures)),
      redundancy(Eigen::VectorXd::Zero(figures)),
      residuals(Eigen::VectorXd::Zero(figures)) {}

std::unique_ptr<Weighing> weighing_of(const RedundantReadings& readings) {
    return readings.shares.empty() ? weighing_apart(readings) : weighing_together(readings);
}

std::unique_ptr<Weighing> weighing_apart(const RedundantReadings& readings) {
    return std::make_unique<WeighingApart>(readings);
}

}  // namespace covaria::evidence
