// Stated uncertainties against the scatter that the residuals show: variance components with their own
// uncertainty.
#pragma once

#include <vector>

#include "core/evidence/redundant_readings.h"

namespace covaria::evidence {

/// Below this share of redundancy no change of a figure is suggested: its u is not known to 22 %.
inline constexpr double least_redundancy = 10.0;
/// Readings of which variance components are computed at most; each of them costs a solution.
inline constexpr std::size_t most_readings = 6000;
/// The same of readings that share components, whose matrices are full.
inline constexpr std::size_t most_sharing_readings = 2000;
std::size_t most_readings_of(const RedundantReadings& readings);

enum class Verdict {
    agrees,      ///< the interval holds the stated figure
    smaller,     ///< the data see less scatter than is stated
    larger,      ///< the data contradict the stated figure: it is too small
    too_little,  ///< too little redundancy to say
};

/// The standard uncertainty that the residuals see, over the one that is stated.
struct SeenFigure {
    double factor = 1.0;
    /// The variance component factor². Unbiased where all components have redundancy enough; where another
    /// one would be negative and stands at zero instead, it is too small by a part of its own uncertainty.
    double square = 1.0;
    double u_square = 0.0;  ///< its standard uncertainty, from the inverse of N
    double redundancy = 0.0;
    double degrees_of_freedom = 0.0;  ///< 2 factor⁴ / u²(factor²)
    double low = 0.0, high = 0.0;     ///< interval of the factor, by chi-squared
    Verdict verdict = Verdict::too_little;
    bool clamped = false;                     ///< its estimate was negative: factor 0 in its place
    std::vector<std::size_t> not_apart = {};  ///< figures that only have one factor together with this one
};

/// The data contradict what is stated. A figure that is stated too large is cautious, and not wrong.
inline bool is_contradicted(const SeenFigure& figure) {
    return figure.verdict == Verdict::larger;
}
/// Whether the seen figure may stand in the place of the stated one.
inline bool is_known(const SeenFigure& figure) {
    return figure.verdict != Verdict::too_little && !figure.clamped;
}

struct Seen {
    std::vector<SeenFigure> figures;
    double sum_of_squares = 0.0;  ///< vᵀ C⁻¹ v as stated
    int degrees_of_freedom = 0;
    double s0 = 0.0;
    double s0_low = 0.0, s0_high = 0.0;  ///< the global test passes between them
    /// Root mean square of the u of all measurands, as stated and with the factors of all figures.
    double mean_u_stated = 0.0, mean_u_seen = 0.0;
    bool found = false;  ///< the components came to rest; else the figures have none
};

/// Least-squares estimates of variance components, iterated, which are those of restricted maximum likelihood
/// (P. J. G. Teunissen, A. R. Amiri-Simkooei, J. Geod. 82, 2008): N_kl = 1/2 tr(Q⁻¹R Q_k Q⁻¹R Q_l),
/// l_k = 1/2 vᵀ Q⁻¹ Q_k Q⁻¹ v, covariance N⁻¹. Components are not negative: one that the likelihood draws
/// below zero stands there. `level`: of each verdict and of the global test, two-sided. Figures that N cannot
/// tell apart get one factor. Without redundancy, or with more readings than `most_readings`, nothing is
/// found.
Seen see(const RedundantReadings& readings, double level = 0.05);
/// The result at the level of 5 %, computed when it is first asked for, as report, tables and results.json
/// ask for the same.
const Seen& seen_of(const RedundantReadings& readings);
/// The test of the residuals without a look at figures, for any number of readings.
Seen global_test(const RedundantReadings& readings, double level = 0.05);

}  // namespace covaria::evidence
