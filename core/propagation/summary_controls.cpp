#include "core/propagation/summary_controls.h"

#include <cmath>

#include "core/propagation/linear_parts.h"

namespace covaria::detail {

SummaryControls::SummaryControls(const InputSet& inputs, const Correlations& correlations,
                                 const LawOfPropagation& law, const std::vector<std::size_t>& outputs) {
    LinearTermMaker maker(inputs, correlations);
    std::vector<LinearRow> rows;
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < outputs.size() && !law.condensed; ++k) {
        auto terms = maker.make(law.terms[outputs[k]]);
        if (!terms) continue;
        LinearDistribution distribution(*std::move(terms));
        // Without a variance there is no regression.
        if (!std::isfinite(distribution.standard_deviation())) continue;
        LinearRow row{outputs[k], {}};
        for (const Sensitivity& s : law.sensitivities[outputs[k]])
            row.terms.push_back({s.input, s.coefficient, law.inputs(static_cast<Eigen::Index>(s.input))});
        rows.push_back(std::move(row));
        place_of_.push_back(k);
        chosen.push_back(outputs[k]);
        distributions_.push_back(std::move(distribution));
    }
    rows_ = LinearRows(std::move(rows));
    if (!chosen.empty()) covariance_ = covariance_of_draws(inputs, correlations, law, chosen);
}

void SummaryControls::improve(TrialFigures& figures, double probability, std::uint64_t trials_made) const {
    constexpr double least_explained = 1.0 / 3.0, small = 0.1;
    const auto own = figures.covariance.rows() - static_cast<Eigen::Index>(place_of_.size());
    const Eigen::MatrixXd trials = figures.covariance;
    const double lower = 0.5 * (1.0 - probability);
    const double scatter = std::sqrt(lower * (1.0 - lower) / static_cast<double>(trials_made));
    const auto exact_end = [&](const LinearDistribution& distribution, double p) {
        auto end = distribution.quantile(p);
        return end && distribution.error(*end) < small * scatter ? end : std::nullopt;
    };
    std::vector<double> slope(place_of_.size(), 0.0);
    for (std::size_t r = 0; r < place_of_.size(); ++r) {
        const auto y = static_cast<Eigen::Index>(place_of_[r]), l = own + static_cast<Eigen::Index>(r);
        if (!(trials(l, l) > 0.0)) continue;
        const double b = trials(y, l) / trials(l, l);
        if (!(b * trials(y, l) >= least_explained * trials(y, y))) continue;
        slope[r] = b;
        figures.mean(y) -= b * figures.mean(l);
        CoverageInterval& interval = figures.intervals[place_of_[r]];
        const CoverageInterval& of_linear = figures.intervals[static_cast<std::size_t>(l)];
        if (const auto exact = exact_end(distributions_[r], lower))
            interval.low += b * (*exact - of_linear.low);
        if (const auto exact = exact_end(distributions_[r], 1.0 - lower))
            interval.high += b * (*exact - of_linear.high);
    }
    for (std::size_t r = 0; r < place_of_.size(); ++r)
        for (std::size_t s = 0; s < place_of_.size(); ++s) {
            const auto a = static_cast<Eigen::Index>(r), b = static_cast<Eigen::Index>(s);
            figures.covariance(static_cast<Eigen::Index>(place_of_[r]),
                               static_cast<Eigen::Index>(place_of_[s])) +=
                slope[r] * slope[s] * (covariance_(a, b) - trials(own + a, own + b));
        }
}

}  // namespace covaria::detail
