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
        for (Eigen::Index i = 0; i < v.size(); ++i) {
            const std::size_t of = figure_of(i);
            if (of == none) continue;
            const auto k = static_cast<Eigen::Index>(of);
            Eigen::VectorXd row = -(A * adjusted.step(Eigen::VectorXd(A.row(i).transpose())));
            row[i] += 1.0;
            sums.redundancy[k] += row[i];
            sums.residuals[k] += v[i] * v[i];
            for (Eigen::Index j = 0; j < row.size(); ++j)
                if (const std::size_t to = figure_of(j); to != none)
                    sums.squares(k, static_cast<Eigen::Index>(to)) += row[j] * row[j];
        }
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
