// Law of propagation of uncertainty in terms of components (JCGM 100 5.2, G.4; JCGM 102 6.2).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/model/measurement_model.h"
#include "core/propagation/options.h"
#include "core/quantity/effective_degrees.h"
#include "core/result/output_covariance.h"

namespace covaria::detail {

using Correlations = std::vector<ComponentCorrelation>;

/// Effect of one component of uncertainty on one output.
struct PropagationTerm {
    std::size_t component = 0;
    double sensitivity = 0.0;   ///< c = dy/d epsilon
    double contribution = 0.0;  ///< c u, with sign
    /// sum_k r_jk c_k u_k: the share of component j is contribution * correlated / u^2(y).
    double correlated = 0.0;
};

struct CondensedTerms;  // core/propagation/condensed_law.h

struct LawOfPropagation {
    Eigen::VectorXd inputs;    ///< estimates x
    Eigen::VectorXd estimate;  ///< y = f(x)
    Eigen::VectorXd u;         ///< standard uncertainties of the components, 0 when held
    /// [output]: by rising component; those without any effect are left out.
    std::vector<std::vector<PropagationTerm>> terms;
    SensitivityRows sensitivities;  ///< sensitivities to the input quantities
    OutputCovariance covariance;    ///< U_y = (c u) R (c u)^T
    Eigen::VectorXd degrees_of_freedom;
    bool degrees_of_freedom_approximate = false;  ///< see WelchSatterthwaite
    /// Whether each output has sensitivity coefficients. Without them nothing is known of it to first order:
    /// it has no terms, and its covariances are no numbers.
    std::vector<bool> differentiable;
    /// In place of `terms` and `sensitivities`, which are empty then: they would not fit into memory.
    std::shared_ptr<const CondensedTerms> condensed = {};

    bool is_differentiable() const;
    double uncertainty(Eigen::Index j) const;
};

/// Covariance of the linear parts of the outputs over Monte Carlo's draws: `law.covariance` with the standard
/// deviations of the drawn distributions (Student t: scale * sqrt(nu/(nu - 2)), infinite for nu <= 2).
OutputCovariance covariance_of_draws(const InputSet& inputs, const Correlations& correlations,
                                     const LawOfPropagation& law);
/// Among some outputs, every pair.
Eigen::MatrixXd covariance_of_draws(const InputSet& inputs, const Correlations& correlations,
                                    const LawOfPropagation& law, const std::vector<std::size_t>& outputs);
/// The same by the law itself.
Eigen::MatrixXd covariance_among(const LawOfPropagation& law, const std::vector<std::size_t>& outputs);

/// A (quantities x components): x = constant + A epsilon.
Eigen::MatrixXd factor_matrix(const InputSet& inputs);

/// c as a matrix (outputs x components).
Eigen::MatrixXd sensitivity_matrix(const LawOfPropagation& law);

/// Why the law of propagation says nothing of some outputs: for whoever has no trials that would.
Error without_sensitivities(const MeasurementModel& model, const LawOfPropagation& law);

/// How much of the law is kept in memory.
struct LawSizes {
    /// Sensitivity coefficients from which on a model that gives them row by row has them condensed.
    std::size_t most_sensitivities = 4'000'000;
    std::size_t most_budget_rows = 200'000;  ///< of a condensed law, over all outputs
};

/// Error{numeric}: the model has no value at the estimates.
Result<LawOfPropagation> law_of_propagation(const MeasurementModel& model, const InputSet& inputs,
                                            const Correlations& correlations, const LawSizes& sizes = {});

/// Effective degrees of freedom of combinations of these components.
WelchSatterthwaite degrees_of_freedom_rule(const InputSet& inputs, const Correlations& correlations);

/// k of a coverage probability: t quantile, or normal for infinite degrees of freedom (JCGM 100 G.3.4).
double coverage_factor_of(double probability, double degrees_of_freedom);

}  // namespace covaria::detail
