// Least squares of distances between pillars on a line: their lengths, the zero offset, the scatter.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "core/kinds/sheets/distance_meter_setup.h"
#include "core/kinds/sheets/scatter.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria::sheets {

/// Unknowns: places of all pillars but the first, then the zero offset, which is added to a reading.
struct DistanceMeterFit {
    Eigen::VectorXd unknowns;
    Eigen::MatrixXd design;      ///< readings x unknowns
    Eigen::MatrixXd cofactors;   ///< cofactors of the unknowns
    Eigen::VectorXd residuals;   ///< adjusted less read, horizontal
    Eigen::VectorXd redundancy;  ///< redundancy of each reading: diagonal of I - A Q A^T
    double s = 0.0;              ///< standard deviation of one distance
    double degrees_of_freedom = 0.0;
    double zero_offset() const { return unknowns[unknowns.size() - 1]; }
    double u(Eigen::Index unknown) const { return s * std::sqrt(cofactors(unknown, unknown)); }
    double u_zero_offset() const { return u(unknowns.size() - 1); }
    double u_s() const { return u_of_deviation(s, degrees_of_freedom); }
};

/// Empty: the readings do not tell the zero offset from the lengths.
std::optional<DistanceMeterFit> fit_of(const DistanceMeterSetup& setup);

/// The scale correction m = sum g_j (L_j - X_j) by the reference lengths, with the weights of least squares:
/// the covariance of the adjusted lengths and the u of each reference length.
Eigen::VectorXd scale_gain(const DistanceMeterSetup& setup, const DistanceMeterFit& fit);
/// Index of the unknown that a reference length belongs to.
Eigen::Index unknown_of(const DistanceMeterSetup& setup, const ReferenceLength& length);

std::vector<Table> distance_meter_tables(const DistanceMeterSetup& setup, const DistanceMeterFit& fit);
std::vector<PlotSpecification> distance_meter_figures(const DistanceMeterSetup& setup,
                                                      const DistanceMeterFit& fit);

}  // namespace covaria::sheets
