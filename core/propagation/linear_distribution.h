// The exact distribution of a linear combination of independent variables.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <vector>

#include "core/quantity/characteristic_function.h"

namespace covaria::detail {

/// factor * (X - mean of X).
struct LinearTerm {
    double factor = 1.0;
    Distribution distribution = {};
    std::shared_ptr<const CharacteristicFunction> characteristic = {};
};

/// A quantile, and how far it may be off.
struct KnownQuantile {
    double value = 0.0, error = 0.0;
};

/// The sum of the terms, whose mean is zero. Normal terms, or one term alone, have closed forms; otherwise
/// the characteristic functions are multiplied on a grid and inverted (Gil-Pelaez 1951) by the midpoint rule:
/// to 1e-8 of the distribution function where its density is smooth. What wraps round from the far tails of
/// Student t terms is taken out by their own distribution functions. Where the product does not end within
/// the grid (few rectangular or arcsine terms), it is damped by a narrow normal distribution, `resolution()`
/// wide, whose effect is taken out to second order. `error` bounds what is left of all this.
class LinearDistribution {
public:
    explicit LinearDistribution(std::vector<LinearTerm> terms);

    /// Infinite with a Student t of two degrees of freedom or fewer.
    double standard_deviation() const { return standard_deviation_; }
    /// Whether the mean exists, which is zero: not with a Student t of one degree of freedom or fewer.
    bool has_mean() const { return has_mean_; }
    double resolution() const { return damping_; }
    double distribution_function(double x) const;
    /// Bound of the error of the distribution function: errors of the characteristic functions, what wraps
    /// round from far tails, and the effect of the damping within some of its widths about x.
    double error(double x) const;
    /// Empty: there are jumps (discrete terms), the density is too peaked for the grid, or the quantile lies
    /// beyond it (far tails of few degrees of freedom).
    std::optional<double> quantile(double p) const;
    /// The same with its error: where p moves by the error of the distribution function. Infinite: nothing is
    /// known there.
    std::optional<KnownQuantile> known_quantile(double p) const;

private:
    struct Value {
        double probability = 0.0, density = 0.0;
    };
    void take_closed_forms(std::vector<LinearTerm>& terms);
    void choose_grid(const std::vector<LinearTerm>& terms);
    bool keeps_steps(const std::vector<LinearTerm>& terms) const;
    void multiply(const std::vector<LinearTerm>& terms);
    Value at(double x) const { return damped_at(x, 0.0); }
    /// Damped by further normal terms of this variance.
    Value damped_at(double x, double further) const;
    double wrapped(double x) const;
    double beyond_grid(const std::vector<LinearTerm>& terms) const;
    bool is_closed() const { return values_.empty() || !alone_.empty(); }

    double standard_deviation_ = 0.0;
    double scale_ = 0.0;   ///< a width, finite also for heavy tails
    double normal_ = 0.0;  ///< standard deviation of all normal terms
    double spacing_ = 0.0;
    double damping_ = 0.0;
    double lasting_error_ = 0.0;  ///< error of the distribution function that is the same everywhere
    std::size_t most_points_ = 0;
    bool has_mean_ = true;
    bool has_density_ = true;
    std::vector<LinearTerm> alone_;             ///< the only term
    std::vector<LinearTerm> heavy_;             ///< Student t terms
    std::vector<std::complex<double>> values_;  ///< values at (k + 1/2) spacing
};

}  // namespace covaria::detail
