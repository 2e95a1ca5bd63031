// Least squares by Levenberg-Marquardt, and which unknowns the rows of a fit can tell. Shared by the ways of
// identification that fit an arm to readings.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/points/component_evidence.h"
#include "core/kinds/robot_identification/identified_parameters.h"
#include "core/math/dual.h"
#include "core/math/real.h"
#include "core/text/table.h"

namespace covaria::identification {

/// A fit as a function of its unknowns.
struct FitFunctions {
    /// Rows: measured less calculated.
    std::function<Eigen::VectorXd(const std::vector<double>&)> residuals;
    /// d(calculated)/d(unknown), rows by unknowns.
    std::function<Eigen::MatrixXd(const std::vector<double>&)> jacobian;
};

/// The estimates of all input quantities.
std::vector<double> estimates_of(const InputSet& inputs);

/// d(calculated)/d(unknown) at `v`, rows by unknowns. `residuals(v, set)` calls `set(row, measured less
/// calculated)`, in duals.
template <class Residuals>
Eigen::MatrixXd jacobian_of(const std::vector<double>& v, std::size_t rows, const Residuals& residuals) {
    using Eigen::Index;
    Eigen::MatrixXd A(static_cast<Index>(rows), static_cast<Index>(v.size()));
    std::vector<Dual> variables(v.begin(), v.end());
    for (std::size_t first = 0; first < v.size(); first += Dual::size) {
        const std::size_t last = std::min(first + Dual::size, v.size());
        for (std::size_t i = first; i < last; ++i) variables[i] = Dual::variable(v[i], i - first);
        residuals(variables, [&](std::size_t row, const Dual& value) {
            for (std::size_t i = first; i < last; ++i)
                A(static_cast<Index>(row), static_cast<Index>(i)) = -value.partials()[i - first];
        });
        for (std::size_t i = first; i < last; ++i) variables[i] = Dual(v[i]);
    }
    return A;
}

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

/// By what a residual is tested: by its own scatter, or by the covariance of all rows, so that what rows
/// share, a known point or a scale, hides no error of one of them.
enum class TestBy { scatter, covariance };

/// Takes gain and covariance over. `from_inputs`: rows by components, each times its standard uncertainty;
/// `design`: rows by unknowns.
void take_statistics(FitStatistics& statistics, const Gain& gain, const Eigen::VectorXd& residuals,
                     const Eigen::MatrixXd& design, const Eigen::MatrixXd& from_inputs,
                     const Eigen::VectorXd& w, TestBy test);

/// 1/u of the unknowns; of one without uncertainty that of a micrometre or microradian.
std::vector<double> inverse_uncertainties(const Eigen::MatrixXd& covariance);

/// Steps with the gain at the estimates; each reduces what is missing by the factor by which the gain changes
/// within a trial. Derivatives are there after the first.
inline constexpr int fewest_gain_steps = 4, most_gain_steps = 60;
/// A trial is settled where its last step is below this part of the standard uncertainty of each unknown.
inline constexpr double settled_step = 1e-6;

/// The unknowns `v` of a trial, from the estimates on: `residuals(v, add)` calls `add(row, measured less
/// calculated)`. Which trials are settled.
template <class Real, std::size_t most, class Residuals>
mask_of<Real> follow_gain(const Eigen::MatrixXd& gain, const std::vector<double>& inverse_u,
                          std::array<Real, most>& v, const Residuals& residuals) {
    using namespace real_functions;
    const std::size_t n = inverse_u.size();
    std::array<Real, most> step;
    mask_of<Real> settled(false);
    for (int k = 0; k < most_gain_steps && (k < fewest_gain_steps || !all(settled)); ++k) {
        for (std::size_t i = 0; i < n; ++i) step[i] = Real(0.0);
        residuals(v, [&](std::size_t row, const Real& r) {
            const double* column = &gain(0, static_cast<Eigen::Index>(row));
            for (std::size_t i = 0; i < n; ++i) step[i] += Real(column[i]) * r;
        });
        Real largest(0.0);
        for (std::size_t i = 0; i < n; ++i) {
            v[i] += step[i];
            largest = max(largest, Real(abs(step[i]) * Real(inverse_u[i])));
        }
        settled = largest < Real(settled_step);
    }
    return settled;
}

/// "d_3, a_2": unknowns that the rows tell worst; empty where all are told well.
Message least_told(const FitStatistics& statistics, const std::vector<Message>& names);
double condition_of(const FitStatistics& statistics);
/// Above it, unknowns are hardly told apart.
inline constexpr double most_condition = 1e4;

/// Rank, freedom, condition, what is told worst; and the strongest correlation of each unknown.
std::vector<Table> observability_tables(const FitStatistics& statistics, const std::vector<Message>& names,
                                        const Message& what_the_rows_are);

/// The residuals of poses, x, y, z first in each, and the largest of all its rows as the test standardises
/// it.
Table residual_table(const FitStatistics& statistics, const std::vector<std::string>& poses);

}  // namespace covaria::identification
