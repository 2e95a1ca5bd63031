// Results of an evaluation: plain data, never a pointer to a model. Everything SI; `unit` is for display.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/model/output_quantity.h"
#include "core/quantity/shared_inputs.h"
#include "core/result/guard_rule.h"
#include "core/result/output_covariance.h"
#include "core/result/trial_distribution.h"
#include "core/result/variance_reduction.h"

namespace covaria {

struct CoverageInterval {
    double low = 0.0;
    double high = 0.0;
};

/// Law of propagation of uncertainty for one output (JCGM 100 5, G.4).
struct FirstOrderOutput {
    double estimate = 0.0;              ///< f at the estimates
    double standard_uncertainty = 0.0;  ///< u_c
    double effective_degrees_of_freedom = infinity;
    double coverage_factor = 0.0;
    double expanded_uncertainty = 0.0;
    std::optional<double> second_order_standard_uncertainty = {};  ///< NOTE to JCGM 100 5.1.2, if asked for
    std::optional<double> second_order_estimate_shift = {};
    /// JCGM 101 clause 8 (empty without Monte Carlo): |y -+ U - y_low/high| <= delta
    struct Validation {
        double tolerance = 0.0;  ///< delta
        double d_low = 0.0;
        double d_high = 0.0;
        bool validated = false;
        bool is_close = false;  ///< other trials could give the other verdict
    };
    std::optional<Validation> validation = {};
};

/// Equal cells over [low, high]; values outside are counted in below/above.
struct Histogram {
    double low = 0.0;
    double high = 0.0;
    std::vector<std::uint64_t> counts;
    std::uint64_t below = 0;
    std::uint64_t above = 0;
};

/// Is a normal distribution an acceptable description? (porath.md: never a single Shapiro-Wilk test)
struct NormalityVerdict {
    double skewness_z = 0.0;  ///< skewness / its standard error under normality
    double kurtosis_z = 0.0;
    double coverage_ratio = 1.0;  ///< (q_high - q_low) / (2 k_normal u): 1 for a normal distribution
    bool acceptable = true;       ///< U = k u may be stated; else the coverage interval
    Message words;                ///< "normal within 1 %", "too heavy-tailed for k u"
};

/// Propagation of distributions for one output (JCGM 101 7).
struct MonteCarloOutput {
    double mean = 0.0;
    double standard_uncertainty = 0.0;
    double standard_error_of_mean = 0.0;
    double standard_error_of_uncertainty = 0.0;
    CoverageInterval symmetric;  ///< probabilistically symmetric
    CoverageInterval shortest;
    double skewness = 0.0;
    double kurtosis = 0.0;  ///< excess kurtosis (normal: 0)
    double minimum = 0.0;
    double maximum = 0.0;
    NormalityVerdict normality;
    Histogram histogram;
    std::vector<double> quantiles;  ///< quantiles at (i - 0.5)/n, i = 1..n (n = 199): for the Q-Q chart
    TrialDistribution distribution;
    std::optional<ReducedVariance> reduced = {};  ///< mean, u, the symmetric interval; the rest is plain
};

struct OutputResult {
    OutputQuantity quantity;
    FirstOrderOutput first_order;
    std::optional<MonteCarloOutput> monte_carlo = {};
    /// The result line: Monte Carlo where it ran, else first order.
    double estimate = 0.0;
    double standard_uncertainty = 0.0;  ///< infinite where a component that contributes has no finite one
    double coverage_factor = 0.0;       ///< U / u; NaN where u is infinite
    double expanded_uncertainty = 0.0;  ///< see result_line.h: which U it is depends on the method
};

/// A row of the budget: one component (or all components of one quantity) and its effect on one output.
struct BudgetRow {
    std::size_t component = 0;  ///< index into UncertaintyBudget::components
    double sensitivity = 0.0;   ///< c = dy/d epsilon, through every quantity that shares the component
    double contribution = 0.0;  ///< |c| u
    double share = 0.0;  ///< share of the variance, with its part of covariances (may be negative); sums to 1
    std::optional<double> one_at_a_time = {};  ///< u(y) by Monte Carlo with everything else held
};

struct BudgetComponent {
    std::string id;
    Message name, origin;
    std::string owner = {};  ///< name of the asset or analysis that brings it in; empty: the set-up
    Unit unit;
    std::string distribution;  ///< title
    EvaluationType type;
    double standard_uncertainty = 0.0;
    double degrees_of_freedom = infinity;
    bool held = false;
    std::vector<std::string> quantities;  ///< symbols of all quantities that have a share in it
    Name group;                           ///< group of the first of them
    std::vector<GroupTag> tags = {};      ///< its own and those of that quantity
    double estimate = 0.0;                ///< estimate of that first quantity
    Unit quantity_unit = {};              ///< its unit, for display
    /// Whether it stands for all components of one group that have no row of their own in the budget of an
    /// output, because all rows of all outputs would not fit into memory. It is no component of the inputs.
    bool is_rest = false;
};

/// Per output, the rows sorted by falling |share|.
struct UncertaintyBudget {
    /// Those of the inputs, in their order; then the rests.
    std::vector<BudgetComponent> components;
    std::vector<std::vector<BudgetRow>>
        rows;  ///< [output][...]; without zero sensitivities, unless few components have no other
};

/// Result with everything held that one contributor brings in ("ideal robot"), and from it alone: standard
/// uncertainty of each output.
struct ContributorResult {
    struct Uncertainties {
        std::vector<double> first_order;
        std::vector<double> monte_carlo;  ///< empty unless asked for
        std::uint64_t failed_trials = 0;
    };
    Name contributor;            ///< its name; with its id where two have one name; "" = the set-up
    std::size_t components = 0;  ///< number that it brings in
    Uncertainties without, alone;
};

/// Contribution of the components of one group to one output.
struct GroupContribution {
    Name group;                 ///< "joint 4"
    double contribution = 0.0;  ///< root of the sum of squares of |c| u, of independent components
    double share = 0.0;         ///< share of the variance, with covariances
};

/// Shares of the variance by one component, or by several that are not independent of each other (Sobol 1993;
/// Saltelli et al. 2010; Jansen 1999).
struct SobolIndex {
    std::string name;                     ///< ids of the first components, for people
    std::vector<std::size_t> components;  ///< indices into InputSet::components
    double first = 0.0;                   ///< share by itself
    double total = 0.0;                   ///< share with all its interactions
    double first_standard_error = 0.0;
    double total_standard_error = 0.0;
};

/// A requirement on one output; SI.
struct OutputRequirement {
    std::size_t output = 0;
    std::optional<double> target_uncertainty = {};
    std::optional<double> lower_limit = {}, upper_limit = {};
    double guard_factor = 1.0;  ///< r of the decision rule w = r U
    std::optional<double> prior_mean = {}, prior_standard_deviation = {};
    GuardRule guard_rule = GuardRule::factor;
    double target_risk = 0.02;  ///< target of the rules that have one
};

/// A requirement and how the result stands to it: made of both whenever it is looked at.
struct RequirementResult : OutputRequirement {
    /// Why there is no verdict; empty if there is one. Without it the target is not met and nothing is
    /// decided.
    Message not_judged = {};
    bool meets_target = true;

    double guard_band = 0.0;  ///< w
    /// Decision about the value that the result line states.
    enum class Decision { none, accept, reject } decision = Decision::none;
    /// Probability of conformance p_c (JCGM 106 7), by the distribution that the result line states: the
    /// trials, or Student's t with nu_eff about y with scale u, which is normal for infinite nu_eff.
    double conformance = 0.0;
    enum class Distribution { trials, student_t, normal } conformance_by = Distribution::normal;
    std::optional<double> capability_index = {};   ///< C_m = T/(4u), T/(2U) for U = 2u (JCGM 106 7.6)
    std::optional<double> uncertainty_ratio = {};  ///< TUR: half of the tolerance over the U that is stated
    struct GlobalRisks {
        double consumer = 0.0;  ///< accepted and not conforming
        double producer = 0.0;  ///< rejected and conforming
        /// Conditional ones: of what is accepted the part that does not conform, of what is rejected the part
        /// that does. 0 where nothing is accepted, or rejected.
        double consumer_if_accepted = 0.0, producer_if_rejected = 0.0;
    };
    std::optional<GlobalRisks> global_risks = {};
};

/// Joint coverage region of outputs of one group (JCGM 102 6.5, 7.7).
struct CoverageRegion {
    Name group;
    std::vector<std::size_t> outputs;
    double ellipsoid_first_order = 0.0;  ///< k_p from chi-squared or F; says nothing where it is singular
    double rectangle_first_order = 0.0;  ///< k_q, Bonferroni
    std::optional<double> ellipsoid_monte_carlo = {};
    std::optional<double> rectangle_monte_carlo = {};
    std::uint64_t trials = 0;  ///< used for the Monte Carlo factors
    bool singular = false;     ///< covariance of rank too low for an ellipsoid
};

/// Running mean and u of every output at some numbers of trials.
struct ConvergencePoint {
    std::uint64_t trials = 0;
    std::vector<double> mean;
    std::vector<double> standard_uncertainty;
};

struct Provenance {
    std::string project_fingerprint;  ///< filled by the caller that knows the project
    std::string covaria_version;
    std::uint64_t seed = 0;
};

struct UncertaintyResult {
    std::vector<OutputResult> outputs;
    SharedInputs inputs;          ///< as evaluated (edits applied)
    OutputCovariance covariance;  ///< Monte Carlo where it ran, else first order
    /// Covariance of first order, where Monte Carlo ran.
    std::optional<OutputCovariance> covariance_before_trials = {};
    UncertaintyBudget budget;
    std::vector<ContributorResult> contributors;  ///< empty with fewer than two
    std::uint64_t contributor_trials = 0;         ///< trials of their Monte Carlo part
    std::vector<CoverageRegion> regions;
    std::vector<std::vector<SobolIndex>>
        sobol;  ///< [output][...], by falling total index; empty unless asked for
    std::uint64_t sobol_trials = 0;
    double coverage_probability = 0.95;
    std::optional<double> fixed_coverage_factor = {};  ///< k that the user fixed

    std::uint64_t trials = 0;         ///< 0 = first order only
    std::uint64_t failed_trials = 0;  ///< without a value; not part of the statistics
    bool adaptive = false;
    bool stabilised = true;  ///< false: adaptive run stopped at its cap
    std::uint64_t batches = 0;
    VarianceReduction variance_reduction = VarianceReduction::none;
    bool intervals_exact = true;  ///< false: from cells (more trials than memory for exact order statistics)
    std::vector<ConvergencePoint> convergence;
    std::vector<Message> warnings;
    Provenance provenance;
};

/// Covariance as it is stated: where u of an output does not exist (infinite, by Monte Carlo), neither do
/// its covariances, which the matrix has from the trials that happened to be made: NaN.
OutputCovariance existing_covariance(const UncertaintyResult& result);
/// Covariance by the law of propagation of uncertainty.
const OutputCovariance& first_order_covariance(const UncertaintyResult& result);

/// Least gain of variance reduction at the interval ends of the measurands; empty without variance reduction,
/// or with too few batches to say.
std::optional<double> least_gain(const UncertaintyResult& result);

/// The groupings of a budget, in order of appearance: "parameter", "joint", "kind".
std::vector<std::string> groupings_of(const UncertaintyBudget& budget);
inline constexpr const char* group_without_tag = "other";
/// Contributions to an output by the groups of a grouping, by falling share; components without a tag are
/// `group_without_tag`.
std::vector<GroupContribution> contributions_by_group(const UncertaintyBudget& budget, std::size_t output,
                                                      const std::string& grouping);

/// Indices of the outputs of a group, in order; all groups in order of appearance.
std::vector<std::size_t> outputs_of_group(const std::vector<OutputQuantity>& outputs,
                                          const std::string& group);
std::vector<Name> groups_of(const std::vector<OutputQuantity>& outputs);
/// Correlation matrix of a covariance matrix; 0 off the diagonal and 1 on it where a variance is 0.
Eigen::MatrixXd correlation_of(const Eigen::MatrixXd& covariance);

}  // namespace covaria
