// Sensitivity coefficients that are kept by rows, as a dense matrix.
#pragma once

#include <Eigen/Core>

#include "core/model/measurement_model.h"

namespace covaria {

/// Puts the rows into `jacobian`, outputs x inputs; what no row names is zero.
inline void set_dense(const SensitivityRows& rows, std::size_t inputs, Eigen::MatrixXd& jacobian) {
    jacobian.setZero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(inputs));
    for (std::size_t j = 0; j < rows.size(); ++j)
        for (const Sensitivity& s : rows[j])
            jacobian(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(s.input)) = s.coefficient;
}

}  // namespace covaria
