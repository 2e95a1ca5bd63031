// Redundant readings from plain matrices: residuals, standardised residuals and what figures state of them.
#pragma once

#include <Eigen/Core>

#include "core/evidence/redundant_readings.h"

namespace covaria::evidence {

/// Completes readings that share nothing. `described`: residuals, up to what the unknowns take up, SI;
/// `figure_of`, names, and figures without their u. `design`: readings x unknowns; columns that others
/// determine are left out. `u` > 0: stated standard uncertainty of each reading, SI.
RedundantReadings readings_apart(RedundantReadings described, const Eigen::MatrixXd& design,
                                 const Eigen::VectorXd& u);

/// Completes readings whose uncertainty is made of `shares` and `others`, which `described` has, with the
/// figures whole. `figure_of` may say which figure a reading mostly rests on, for charts. Standardised
/// residuals are those of unweighted least squares.
RedundantReadings readings_together(RedundantReadings described, const Eigen::MatrixXd& design);

}  // namespace covaria::evidence
