// A form through points without any hint where it is: closed solutions, then damped steps from the best of
// many directions.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/kinds/geometry/fit.h"

namespace covaria::geometry {

/// Points with at least `least_points` rows. The direction has its largest component positive; that of a cone
/// leads from the apex into it. Error: the points determine no such form.
Result<FittedForm> fitted_form(Form form, const std::vector<Eigen::Vector3d>& points);

/// Cofactors: covariance of the parameters for an uncorrelated standard uncertainty of 1 in every coordinate.
Eigen::MatrixXd cofactors(const FittedForm& fitted, const std::vector<Eigen::Vector3d>& points);

}  // namespace covaria::geometry
