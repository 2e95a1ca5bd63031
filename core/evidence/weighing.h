// Redundant readings with the variance of each figure times a factor, and what the equations of variance
// components need of them.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "core/evidence/redundant_readings.h"

namespace covaria::evidence {

/// Sums over M = Q⁻¹R with the components as they are now, by figures.
struct Sums {
    explicit Sums(Eigen::Index figures);

    Eigen::MatrixXd squares;     ///< tr(M Q_k M Q_l)
    Eigen::MatrixXd observed;    ///< vᵀ Q⁻¹ Q_k M Q_l Q⁻¹ v; its expectation is `squares`
    Eigen::VectorXd redundancy;  ///< tr(M Q_k)
    Eigen::VectorXd residuals;   ///< vᵀ Q⁻¹ Q_k Q⁻¹ v; its expectation is `redundancy`
};

/// The readings with the variance of each figure times a factor.
class Weighing {
public:
    virtual ~Weighing() = default;
    virtual std::optional<Sums> sums(const Eigen::VectorXd& square) const = 0;
    /// Root mean square of the u of the measurands.
    virtual std::optional<double> mean_u(const Eigen::VectorXd& square) const = 0;
    virtual double sum_of_squares() const = 0;
    virtual int degrees_of_freedom() const = 0;
};

/// The weighing of readings, which outlive it.
std::unique_ptr<Weighing> weighing_of(const RedundantReadings& readings);
std::unique_ptr<Weighing> weighing_apart(const RedundantReadings& readings);
std::unique_ptr<Weighing> weighing_together(const RedundantReadings& readings);

}  // namespace covaria::evidence
