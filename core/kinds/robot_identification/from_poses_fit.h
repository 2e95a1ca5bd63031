// The least-squares fit of a calibration, at the estimates.
#pragma once

#include "core/kinds/robot_identification/from_poses.h"

namespace covaria::pose_calibration {

/// Takes the unknowns out that the poses cannot tell, fits the others (Levenberg-Marquardt), and fills in
/// solution, gain and statistics. Expects poses, inputs and all candidates in `unknowns`. False after an
/// error; warns of outliers, of residuals larger than their uncertainties and of weakly determined unknowns.
bool fit(Calibration& c, Problems& problems);

/// The rows of the fit with what makes them uncertain, as evidence in the statistics. `design`: rows by
/// unknowns; `shares`: rows by components, each times its standard uncertainty. None where nothing that is
/// stated belongs to single poses.
void find_evidence(Calibration& c, const Eigen::MatrixXd& design, const Eigen::MatrixXd& shares);

}  // namespace covaria::pose_calibration
