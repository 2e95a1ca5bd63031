#include "core/kinds/sheets/distance_meter_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>

namespace covaria::sheets {

namespace {

/// Equations of one Gauss-Newton step; a slope distance is not linear in the zero offset. Signs: horizontal
/// distance of (reading + zero offset) + residual = place of the farther pillar - place of the nearer one.
struct DistanceEquations {
    Eigen::MatrixXd design;
    Eigen::VectorXd misclosure;

    DistanceEquations(const DistanceMeterSetup& setup, const Eigen::VectorXd& unknowns) {
        const auto n = Eigen::Index(setup.readings.size()), last = unknowns.size() - 1;
        design = Eigen::MatrixXd::Zero(n, unknowns.size());
        misclosure.resize(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto [nearer, farther] = setup.places[std::size_t(i)];
            BaselineReading reading = setup.readings[std::size_t(i)];
            reading.distance += unknowns[last];
            const double horizontal = reading.horizontal();
            const double length =
                unknowns[Eigen::Index(farther) - 1] - (nearer > 0 ? unknowns[Eigen::Index(nearer) - 1] : 0.0);
            if (nearer > 0) design(i, Eigen::Index(nearer) - 1) = -1.0;
            design(i, Eigen::Index(farther) - 1) = 1.0;
            design(i, last) = -reading.distance / horizontal;
            misclosure[i] = horizontal - length;
        }
    }
};

}  // namespace

std::optional<DistanceMeterFit> fit_of(const DistanceMeterSetup& setup) {
    const auto count = Eigen::Index(setup.unknowns());
    DistanceMeterFit fit;
    fit.unknowns = Eigen::VectorXd::Zero(count);
    for (Eigen::Index k = 0; k + 1 < count; ++k) fit.unknowns[k] = setup.along[std::size_t(k) + 1];
    fit.degrees_of_freedom = setup.degrees_of_freedom();
    for (int step = 0; step < 4; ++step) {
        const DistanceEquations equations(setup, fit.unknowns);
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(equations.design);
        if (factor.rank() < count) return std::nullopt;
        fit.unknowns += factor.solve(equations.misclosure);
    }
    const DistanceEquations equations(setup, fit.unknowns);
    if (!equations.misclosure.allFinite()) return std::nullopt;
    fit.residuals = -equations.misclosure;
    fit.design = equations.design;
    const Eigen::HouseholderQR<Eigen::MatrixXd> factor(equations.design);
    const Eigen::MatrixXd inverse = factor.matrixQR().topRows(count).triangularView<Eigen::Upper>().solve(
        Eigen::MatrixXd::Identity(count, count));
    fit.cofactors = inverse * inverse.transpose();
    fit.redundancy = (1.0 - (equations.design * inverse).rowwise().squaredNorm().array()).matrix();
    fit.s = std::sqrt(fit.residuals.squaredNorm() / fit.degrees_of_freedom);
    return fit;
}

Eigen::Index unknown_of(const DistanceMeterSetup& setup, const ReferenceLength& length) {
    return std::ranges::find(setup.pillars, length.pillar) - setup.pillars.begin() - 1;
}

Eigen::VectorXd scale_gain(const DistanceMeterSetup& setup, const DistanceMeterFit& fit) {
    const auto count = Eigen::Index(setup.reference.size());
    Eigen::MatrixXd covariance(count, count);
    Eigen::VectorXd lengths(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const ReferenceLength& reference = setup.reference[std::size_t(i)];
        lengths[i] = fit.unknowns[unknown_of(setup, reference)];
        for (Eigen::Index j = 0; j < count; ++j)
            covariance(i, j) = fit.s * fit.s *
                               fit.cofactors(unknown_of(setup, reference),
                                             unknown_of(setup, setup.reference[std::size_t(j)]));
        covariance(i, i) += reference.u * reference.u;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    const bool weighs = covariance.diagonal().minCoeff() > 0.0 && factor.info() == Eigen::Success;
    const Eigen::VectorXd weighted = weighs ? Eigen::VectorXd(factor.solve(lengths)) : lengths;
    return weighted / lengths.dot(weighted);
}

}  // namespace covaria::sheets
