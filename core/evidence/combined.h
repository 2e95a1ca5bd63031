// A figure that several campaigns have seen, with what it changes from one to the next.
#pragma once

#include <vector>

namespace covaria::evidence {

struct CampaignFigure {
    double u = 0.0;  ///< > 0, of the same readings in each campaign
    double degrees_of_freedom = 0.0;
};

struct CombinedFigure {
    double u = 0.0;
    double degrees_of_freedom = 0.0;  ///< includes that the next campaign differs as these do
    double between = 0.0;             ///< standard deviation of ln u between campaigns
};

/// Takes the variances of campaigns as sigma^2 with ln sigma^2 normal between them: mean and variance tau^2
/// by R. C. Paule and J. Mandel (J. Res. NBS 87 (1982) 377), which with two campaigns is the estimate of R.
/// DerSimonian and N. Laird (1986). ln s^2 of nu degrees of freedom has the mean ln sigma^2 + psi(nu/2) -
/// ln(nu/2) and the variance psi'(nu/2). Of the next campaign's ln sigma^2 mean and variance are those of a
/// scaled inverse chi-squared, whose scale and degrees of freedom are the result (G. K. Smyth, Stat. Appl.
/// Genet. Mol. Biol. 3 (2004) 3, Eq 6 ff.). One campaign is its own result. At least one is expected.
CombinedFigure combined(const std::vector<CampaignFigure>& campaigns);

}  // namespace covaria::evidence
