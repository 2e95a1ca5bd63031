// Probability distributions of input quantities (JCGM 101 table 1 and the usual extras): moments, density,
// quantiles.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/error.h"

namespace covaria {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Parameters, SI. JCGM 101 clause in brackets.
struct Normal {
    double mean, standard_deviation;
    bool operator==(const Normal&) const = default;
};  // 6.4.7
struct StudentT {
    double mean, scale, degrees_of_freedom;
    bool operator==(const StudentT&) const = default;
};  // 6.4.9
struct Rectangular {
    double low, high;
    bool operator==(const Rectangular&) const = default;
};  // 6.4.2
struct CurvilinearTrapezoid {
    double low, high, inexactness;
    bool operator==(const CurvilinearTrapezoid&) const = default;
};  // 6.4.3
struct Trapezoidal {
    double low, high, beta;
    bool operator==(const Trapezoidal&) const = default;
};  // 6.4.4
struct Triangular {
    double low, high;
    bool operator==(const Triangular&) const = default;
};  // 6.4.5
struct Arcsine {
    double low, high;
    bool operator==(const Arcsine&) const = default;
};  // 6.4.6
struct Exponential {
    double mean;
    bool operator==(const Exponential&) const = default;
};  // 6.4.10
struct Gamma {
    double shape, scale;
    bool operator==(const Gamma&) const = default;
};  // 6.4.11 (q counts: shape q+1)
struct TruncatedNormal {
    double mean, standard_deviation, low, high;
    bool operator==(const TruncatedNormal&) const = default;
};
struct Lognormal {
    double log_mean, log_standard_deviation;
    bool operator==(const Lognormal&) const = default;
};
struct Beta {
    double low, high, alpha, beta;
    bool operator==(const Beta&) const = default;
};
struct Discrete {
    std::vector<double> values, probabilities;
    bool operator==(const Discrete&) const = default;
};  // empirical too
struct Laplace {
    double mean, scale;
    bool operator==(const Laplace&) const = default;
};
/// location + scale (-ln(1 - p))^(1/shape): a negative scale mirrors it.
struct Weibull {
    double location, scale, shape;
    bool operator==(const Weibull&) const = default;
};
/// zero + step N with a number N of events; the step may be negative.
struct Poisson {
    double number, step, zero;
    bool operator==(const Poisson&) const = default;
};
/// Binomial distribution: N of `trials` with the same probability each; the value is as for Poisson.
struct Binomial {
    double trials, probability, step, zero;
    bool operator==(const Binomial&) const = default;
};
/// Rectangular in each cell between two edges, one edge more than probabilities.
struct StatedHistogram {
    std::vector<double> edges, probabilities;
    bool operator==(const StatedHistogram&) const = default;
};

namespace detail {
class QuantileFunction;
}

using DistributionParameters =
    std::variant<Normal, StudentT, Rectangular, CurvilinearTrapezoid, Trapezoidal, Triangular, Arcsine,
                 Exponential, Gamma, TruncatedNormal, Lognormal, Beta, Discrete, Laplace, Weibull, Poisson,
                 Binomial, StatedHistogram>;

/// A distribution whose parameters have been checked. Immutable and cheap to copy: tables needed for fast
/// quantiles are made once and shared. A width of zero is legal everywhere it makes sense (normal with
/// standard deviation 0, rectangular with low == high): the quantity is then a constant.
class Distribution {
public:
    Distribution();  ///< the constant 0
    // Copies of the alternatives are compiled once, in distribution.cpp.
    Distribution(const Distribution&);
    Distribution(Distribution&&) noexcept;
    Distribution& operator=(const Distribution&);
    Distribution& operator=(Distribution&&) noexcept;
    ~Distribution();
    /// Errors: not finite, negative width or scale, shape outside [0.001, 1e6], fewer than 0.2 degrees of
    /// freedom, probabilities that do not sum to 1
    /// ...; the message names the parameter.
    static Result<Distribution> make(DistributionParameters parameters);
    /// Makes a distribution from checked values; throws ImpossibleValue (guarded.h) for others.
    static Distribution of(DistributionParameters parameters);
    static Distribution normal(double standard_uncertainty);

    const DistributionParameters& parameters() const { return parameters_; }
    /// X = location + factor * (variable with `parameters()`). 0 and 1, unless an exponential, gamma or
    /// lognormal distribution has been shifted or mirrored: these kinds have no parameters for it.
    double location() const { return location_; }
    double factor() const { return factor_; }

    double mean() const;  ///< for a Student t its centre, also where nu <= 1 leaves the expectation undefined
    /// Standard deviation of the drawn values: for Student t scale*sqrt(nu/(nu-2)), infinite for nu <= 2.
    double standard_deviation() const;
    /// Standard uncertainty of the law of propagation: as `standard_deviation`, but the scale for Student t
    /// (JCGM 100 G.3).
    double standard_uncertainty() const;
    double degrees_of_freedom() const;  ///< those of a Student t; infinite otherwise
    double density(double x) const;     ///< 0 where `has_jumps`
    bool has_jumps() const;             ///< discrete, Poisson, binomial: takes single values only
    double quantile(double p) const;    ///< inverse distribution function, 0 < p < 1

    /// Vectorised inverse distribution function: x[i] = quantile(p[i]). No allocation. `p` and `x` may be the
    /// same memory. Element i depends on p[i] only, whatever the length of the span (bit-identical for any
    /// blocking).
    void quantiles(std::span<const double> p, std::span<double> x) const;
    /// Same from standard normal draws z (correlated components): x = quantile(Phi(z)); exact shortcut for
    /// Normal.
    void from_standard_normal(std::span<const double> z, std::span<double> x) const;

    /// The distribution of c*X (c may be negative or 0) and of X + d; c and d must be finite.
    Distribution scaled(double c) const;
    Distribution shifted(double d) const;

    std::string_view kind() const;   ///< key used in files: "normal", "student-t", "rectangular" ...
    std::string_view title() const;  ///< name for people: "normal", "Student t", "rectangular" ...

    bool operator==(const Distribution& other) const;

private:
    explicit Distribution(DistributionParameters parameters, double location = 0.0, double factor = 1.0);
    DistributionParameters parameters_;
    double location_ = 0.0;
    double factor_ = 1.0;
    std::shared_ptr<const detail::QuantileFunction> quantile_function_;
};

/// The kinds in the order of DistributionParameters with the names of their parameters, for files and forms.
struct DistributionParameterInfo {
    std::string_view key;    ///< "mean"
    std::string_view title;  ///< "mean value"
    bool has_unit;           ///< carries the quantity's unit (false: pure number such as degrees of freedom)
    bool is_interval;        ///< a width or scale, never a place on the axis
};
struct DistributionKindInfo {
    std::string_view key;
    std::string_view title;
    std::vector<DistributionParameterInfo> parameters;  ///< empty where they are two lists
    std::string_view list =
        {};  ///< key of the first list, values that have a unit; the second: probabilities
};
const std::vector<DistributionKindInfo>& distribution_kinds();
/// Null: there is none with this key.
const DistributionKindInfo* find_distribution_kind(std::string_view key);
/// Builds from a kind's key and its parameters in the order of `distribution_kinds()` (SI); for lists
/// the first, then all probabilities (a histogram has one edge more). Errors: unknown kind, wrong number of
/// parameters, those of `Distribution::make`.
Result<Distribution> distribution_from(std::string_view kind, std::span<const double> parameters);
/// The parameters in that order (SI).
std::vector<double> distribution_parameters(const Distribution& distribution);
/// Length of the first list, of this number of parameters that are two lists.
std::size_t first_list_size(std::size_t parameters);
/// The values that a distribution with jumps takes, with their probabilities (of far tails as much as can be
/// drawn); nothing of one without.
Discrete values_with_probabilities(const Distribution& distribution);

}  // namespace covaria
