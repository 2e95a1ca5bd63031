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

/// Of the sum of the terms, whose mean is zero. Normal terms, or one term alone, have closed forms; otherwise
/// the characteristic functions are multiplied on a grid and inverted (Gil-Pelaez 1951) by the midpoint rule:
/// to 1e-8 of the distribution function where its density is smooth. What wraps round from the far tails of
/// Student t terms is taken out by their own distribution functions. Where the product does not end within
/// the grid (few rectangular or arcsine terms), it is damped by a narrow normal distribution, `resolution()`
/// wide, whose effect is taken out to second order: within that distance of a jump of the density the
/// quantile may be off by as much.
class LinearDistribution {
public:
    explicit LinearDistribution(std::vector<LinearTerm> terms);

    /// Infinite with a Student t of two degrees of freedom or fewer.
    double standard_deviation() const { return standard_deviation_; }
    /// Which is zero; not with a Student t of one degree of freedom or fewer.
    bool has_mean() const { return has_mean_; }
    double resolution() const { return damping_; }
    double distribution_function(double x) const;
    /// Empty: there are jumps (discrete terms), the density is too peaked for the grid, or the quantile lies
    /// beyond it (far tails of few degrees of freedom).
    std::optional<double> quantile(double p) const;

private:
    struct Value {
        double probability = 0.0, density = 0.0;
    };
    void take_closed_forms(std::vector<LinearTerm>& terms);
    void choose_grid(const std::vector<LinearTerm>& terms);
    bool keeps_steps(const std::vector<LinearTerm>& terms) const;
    void multiply(const std::vector<LinearTerm>& terms);
    Value at(double x) const;
    double wrapped(double x) const;

    double standard_deviation_ = 0.0;
    double scale_ = 0.0;   ///< a width, finite also for heavy tails
    double normal_ = 0.0;  ///< standard deviation of all normal terms
    double spacing_ = 0.0;
    double damping_ = 0.0;
    std::size_t most_points_ = 0;
    bool has_mean_ = true;
    bool has_density_ = true;
    std::vector<LinearTerm> alone_;             ///< the only term
    std::vector<LinearTerm> heavy_;             ///< Student t terms
    std::vector<std::complex<double>> values_;  ///< at (k + 1/2) spacing
};

}  // namespace covaria::detail
