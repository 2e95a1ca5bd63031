// Least squares by Levenberg-Marquardt, and which unknowns the rows of a fit can tell. Shared by the ways of
// identification that fit an arm to readings.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/points/component_evidence.h"
#include "core/kinds/robot_identification/identified_parameters.h"
#include "core/text/table.h"

namespace covaria::identification {

/// A fit as a function of its unknowns.
struct FitFunctions {
    /// Rows: measured less calculated.
    std::function<Eigen::VectorXd(const std::vector<double>&)> residuals;
    /// d(calculated)/d(unknown), rows by unknowns.
    std::function<Eigen::MatrixXd(const std::vector<double>&)> jacobian;
};

/// Weighted least squares from `v` on; `w`: the factor of each row. A step that does not lower the sum of
/// squares is damped more and tried again from where it began. False: no convergence.
bool minimise(const FitFunctions& fit, const Eigen::VectorXd& w, std::vector<double>& v);

struct Told {
    std::vector<std::size_t> unknowns;  ///< by index, in their order
    std::vector<HeldParameter> held;    ///< the others
};

/// Goes through the unknowns in their order and keeps those that move the rows in a way that those kept
/// before do not (Gram-Schmidt on columns of length one). `A`: the weighted Jacobian; `unmoved`: the words
/// for one that changes no row.
Told told_apart(const Eigen::MatrixXd& A, const std::vector<Message>& names, const Message& unmoved);

struct Gain {
    Eigen::MatrixXd gain;             ///< unknowns by rows: (Aᵀ W A)⁻¹ Aᵀ W
    Eigen::VectorXd singular_values;  ///< those of the weighted Jacobian with columns of length one
    Eigen::VectorXd weakest;          ///< direction of the unknowns that belongs to the last
};

/// `A`: the weighted Jacobian. Empty: its unknowns cannot be told apart.
std::optional<Gain> gain_of(const Eigen::MatrixXd& A, const Eigen::VectorXd& w);

/// Statistics of what a fit leaves over.
struct FitStatistics {
    Eigen::VectorXd residuals;    ///< of all rows of the fit
    Eigen::VectorXd u_residuals;  ///< expected scatter; 0 where no other row controls it
    Eigen::VectorXd w;            ///< |residual| as the test standardises it; 0 where nothing controls it
    Eigen::MatrixXd covariance;   ///< covariance of the unknowns
    Eigen::VectorXd singular_values, weakest;
    double scatter = 0.0;  ///< root mean square of residuals over what their uncertainties explain
    double limit = 0.0;    ///< limit of w, family-wise 5 %
    /// Rows whose errors the test cannot tell from one of the row with the largest w.
    std::vector<std::size_t> alike;
    ComponentEvidence evidence;  ///< evidence of the readings about the stated uncertainties

    /// Row with the largest w.
    Eigen::Index worst_row() const;
    double worst_size() const;
    bool has_outlier() const;
    /// More scatter than 1 % of fits have whose uncertainties are right.
    bool scatters_too_much() const;
};

/// Takes gain and covariance over. `from_inputs`: rows by components, each times its standard uncertainty;
/// `design`: rows by unknowns.
void take_statistics(FitStatistics& statistics, const Gain& gain, const Eigen::VectorXd& residuals,
                     const Eigen::MatrixXd& design, const Eigen::MatrixXd& from_inputs,
                     const Eigen::VectorXd& w);

/// 1/u of the unknowns; of one without uncertainty that of a micrometre or microradian.
std::vector<double> inverse_uncertainties(const Eigen::MatrixXd& covariance);

/// "d_3, a_2": unknowns that the rows tell worst; empty where all are told well.
Message least_told(const FitStatistics& statistics, const std::vector<Message>& names);
double condition_of(const FitStatistics& statistics);
/// Above it, unknowns are hardly told apart.
inline constexpr double most_condition = 1e4;

/// Rank, freedom, condition, what is told worst; and the strongest correlation of each unknown.
std::vector<Table> observability_tables(const FitStatistics& statistics, const std::vector<Message>& names,
                                        const Message& what_the_rows_are);

}  // namespace covaria::identification
