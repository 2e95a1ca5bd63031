// Effective degrees of freedom of a combined standard uncertainty (JCGM 100 G.4).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/quantity/input_quantity.h"

namespace covaria::detail {

/// u^2 = sum P_j, with P_j the share of component j, is a function of estimated variances: its own variance
/// is sum over j, k of 2 rho_jk P_j P_k / sqrt(nu_j nu_k), with rho_jk the correlation of the two estimates:
/// 1 for the same estimate of variance; r_jk^2 for two sample variances of observations with the correlation
/// r_jk; 0 for independent ones. nu_eff = 2 u^4 / that. Independent components: Welch-Satterthwaite
/// (G.2b); those of one estimate count as one term with their joint variance. Parts of opposite sign are not
/// counted on, and a set of correlated components is never worse than one term with the least of their
/// degrees of freedom.
class WelchSatterthwaite {
public:
    /// Basis of the uncertainty of one component.
    struct Source {
        double degrees_of_freedom = infinity;
        std::size_t estimate = InputSet::npos;  ///< estimate of variance, shared with others
    };
    struct Part {
        std::size_t component = 0;
        double variance = 0.0;  ///< P_j; negative where correlation turns it over
    };
    struct Effective {
        double degrees_of_freedom = infinity;
        /// Correlated components that do not share an estimate contribute with finite degrees of freedom.
        bool approximate = false;
    };

    WelchSatterthwaite(std::vector<Source> sources, const std::vector<ComponentCorrelation>& correlations);
    /// `variance` is the sum of all parts; each component occurs once. Not for two threads at a time.
    Effective effective(std::span<const Part> parts, double variance);

private:
    struct Partner {
        std::size_t component = 0;
        double weight = 0.0;  ///< rho_jk / sqrt(nu_j nu_k)
    };
    /// Sums over components that are correlated or share an estimate; between calls they are zero.
    struct Set {
        double variance = 0.0, terms = 0.0, least = infinity;
    };
    void add(const Part& part, Effective& result);
    double take(const Part& part);

    std::vector<Source> sources_;
    std::vector<std::vector<Partner>> partners_;  ///< those with finite nu, another estimate; each pair once
    std::vector<std::size_t> set_of_;
    std::vector<Set> sets_;
    std::vector<double> terms_;        ///< P_j/u^2
    std::vector<double> of_estimate_;  ///< sums of these over its members
};

}  // namespace covaria::detail
