#include "core/evidence/plain_readings.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/adjustment/adjustment.h"

namespace covaria::evidence {

namespace {

constexpr double least_controlled = 1e-9;  ///< redundancy of a reading that others control

/// Orthonormal columns that span what the unknowns take up of the readings.
Eigen::MatrixXd span_of(const Eigen::MatrixXd& design) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(design);
    return qr.householderQ() * Eigen::MatrixXd::Identity(design.rows(), design.cols());
}

Eigen::MatrixXd independent_columns(const Eigen::MatrixXd& design) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(design);
    Eigen::MatrixXd columns(design.rows(), qr.rank());
    for (Eigen::Index k = 0; k < qr.rank(); ++k)
        columns.col(k) = design.col(qr.colsPermutation().indices()[k]);
    return columns;
}

void state(StatedFigure& figure, double u) {
    figure.least = figure.count == 0 ? u : std::min(figure.least, u);
    figure.most = std::max(figure.most, u);
    ++figure.count;
}

}  // namespace

RedundantReadings readings_apart(RedundantReadings described, const Eigen::MatrixXd& design,
                                 const Eigen::VectorXd& u) {
    RedundantReadings readings = std::move(described);
    const Eigen::MatrixXd columns = independent_columns(design);
    const Eigen::MatrixXd taken = span_of(u.cwiseInverse().asDiagonal() * columns);
    const Eigen::VectorXd scaled = readings.residuals.cwiseQuotient(u);
    const Eigen::VectorXd left = scaled - taken * (taken.transpose() * scaled);
    for (Eigen::Index i = 0; i < u.size(); ++i) {
        const double redundancy = 1.0 - taken.row(i).squaredNorm();
        readings.w.push_back(redundancy > least_controlled ? left[i] / std::sqrt(redundancy)
                                                           : std::numeric_limits<double>::quiet_NaN());
        state(readings.figures[readings.figure_of[static_cast<std::size_t>(i)]], u[i]);
    }
    readings.residuals = left.cwiseProduct(u);
    readings.design = columns.sparseView();
    readings.whitening = adjustment::whitening(u, {});
    return readings;
}

RedundantReadings readings_together(RedundantReadings described, const Eigen::MatrixXd& design) {
    RedundantReadings readings = std::move(described);
    const Eigen::MatrixXd columns = independent_columns(design);
    const Eigen::MatrixXd taken = span_of(columns);
    readings.residuals -= taken * (taken.transpose() * readings.residuals);
    Eigen::VectorXd stated = Eigen::VectorXd::Zero(columns.rows()), seen = stated;
    const auto add = [&](const Eigen::MatrixXd& share) {
        if (share.cols() == 0) return;
        stated += share.rowwise().squaredNorm();
        seen += (share - taken * (taken.transpose() * share)).rowwise().squaredNorm();
    };
    for (const Eigen::MatrixXd& share : readings.shares) add(share);
    add(readings.others);
    for (Eigen::Index i = 0; i < stated.size(); ++i)
        readings.w.push_back(seen[i] > least_controlled * stated[i]
                                 ? readings.residuals[i] / std::sqrt(seen[i])
                                 : std::numeric_limits<double>::quiet_NaN());
    readings.design = columns.sparseView();
    readings.figure_of.resize(readings.names.size(), RedundantReadings::no_figure);
    return readings;
}

}  // namespace covaria::evidence
