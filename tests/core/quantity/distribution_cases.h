// One or more distributions of every kind, easy and awkward, for tests that hold for all of them.
#pragma once

#include <string>
#include <vector>

#include "core/quantity/distribution.h"

namespace covaria {

inline std::vector<Distribution> distribution_cases() {
    std::vector<Distribution> cases;
    for (const DistributionParameters& parameters :
         std::vector<DistributionParameters>{Normal{10.0, 2.0},
                                             StudentT{5.0, 2.0, 9.0},
                                             StudentT{0.0, 1.0, 1.0},
                                             StudentT{-3.0, 0.1, 2.6},
                                             StudentT{0.0, 1.0, 250.0},
                                             StudentT{1.0, 1.0, infinity},
                                             Rectangular{-1.0, 3.0},
                                             CurvilinearTrapezoid{-1.0, 1.0, 0.4},
                                             CurvilinearTrapezoid{-1.0, 1.0, 1.0},
                                             CurvilinearTrapezoid{2.0, 4.0, 1e-6},
                                             Trapezoidal{0.0, 4.0, 0.3},
                                             Trapezoidal{0.0, 4.0, 1.0},
                                             Triangular{-2.0, 2.0},
                                             Arcsine{-1.0, 1.0},
                                             Exponential{3.0},
                                             Gamma{5.0, 1.0},
                                             Gamma{0.5, 2.0},
                                             TruncatedNormal{0.0, 1.0, -0.5, 2.0},
                                             TruncatedNormal{0.0, 1.0, 0.5, infinity},
                                             TruncatedNormal{1.0, 2.0, -infinity, -7.0},
                                             Lognormal{0.2, 0.5},
                                             Beta{-1.0, 3.0, 2.0, 5.0},
                                             Beta{0.0, 1.0, 0.5, 0.5},
                                             Laplace{2.0, 0.7},
                                             Weibull{1.0, 2.0, 1.5},
                                             Weibull{-1.0, -2.0, 3.6},
                                             Weibull{0.0, 1.0, 0.7}})
        cases.push_back(Distribution::of(parameters));
    cases.push_back(Distribution::of(Exponential{2.0}).scaled(-1.5).shifted(4.0));
    cases.push_back(Distribution::of(Gamma{3.0, 0.5}).shifted(-1.0));
    cases.push_back(Distribution::of(Lognormal{0.0, 0.3}).scaled(-2.0));
    return cases;
}

inline Distribution discrete_case() {
    return Distribution::of(Discrete{{8.0, 1.0, 4.0, 2.0}, {0.1, 0.4, 0.2, 0.3}});
}

/// Distributions that a jump or a kink of the quantile function keeps out of integrals over it.
inline std::vector<Distribution> stepped_cases() {
    std::vector<Distribution> cases{discrete_case()};
    for (const DistributionParameters& parameters : std::vector<DistributionParameters>{
             Poisson{3.5, 1.0, 0.0}, Poisson{400.0, -0.5, 7.0}, Binomial{12.0, 0.3, 1.0, 0.0},
             Binomial{5000.0, 0.97, 0.01, -2.0}, StatedHistogram{{-1.0, 0.0, 0.5, 4.0}, {0.2, 0.5, 0.3}},
             StatedHistogram{{0.0, 1.0, 2.0, 3.0}, {0.5, 0.0, 0.5}}})
        cases.push_back(Distribution::of(parameters));
    return cases;
}

inline std::string described(const Distribution& distribution) {
    std::string text(distribution.kind());
    for (const double parameter : distribution_parameters(distribution))
        text += " " + std::to_string(parameter);
    return text;
}

}  // namespace covaria
