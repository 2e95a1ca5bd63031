// Law of propagation of uncertainty.
#include "core/propagation/first_order.h"

#include <cmath>

#include "core/math/special_quantiles.h"
#include "core/propagation/draw_plan.h"

namespace covaria::detail {
namespace {

Result<void> evaluate_at_estimates(const MeasurementModel& model, LawOfPropagation& law,
                                   Eigen::MatrixXd& jacobian) {
    const std::span<const double> x(law.inputs.data(), static_cast<std::size_t>(law.inputs.size()));
    law.estimate.resize(static_cast<Eigen::Index>(model.outputs().size()));
    const std::span<double> y(law.estimate.data(), model.outputs().size());
    if (!model.evaluate(x, y) || !law.estimate.allFinite())
        return fail(ErrorCode::numeric,
                    "the measurement model has no value at the estimates of its input quantities: check the "
                    "nominal geometry and the values entered");
    if (!model.jacobian(x, jacobian) || !jacobian.allFinite())
        return fail(ErrorCode::numeric,
                    "the measurement model has no sensitivity coefficients at the estimates of its input "
                    "quantities: it is not differentiable there (singular geometry)");
    return {};
}

double degrees_of(const UncertaintyComponent& component) {
    return std::min(component.degrees_of_freedom, component.distribution.degrees_of_freedom());
}

/// Terms u_k^4 / nu_k of Welch-Satterthwaite (JCGM 100 G.2b). A correlated set counts as one term with its
/// variance; its degrees of freedom are those its members have in common, else their weighted harmonic mean.
class WelchSatterthwaite {
public:
    WelchSatterthwaite(const InputSet& inputs, const Correlations& correlations) {
        const std::size_t n = inputs.components.size();
        std::vector<bool> in_set(n, false);
        sets_ = correlated_sets(n, correlations);
        for (const auto& set : sets_)
            for (std::size_t c : set) in_set[c] = true;
        for (std::size_t c = 0; c < n; ++c) {
            degrees_.push_back(degrees_of(inputs.components[c]));
            if (!in_set[c]) sets_.push_back({c});
        }
    }

    /// `approximate` is set when a correlated set contributes with finite degrees of freedom.
    double effective(const LawOfPropagation& law, Eigen::Index output, bool& approximate) const {
        const double variance = law.covariance(output, output);
        if (!(variance > 0)) return infinity;
        double sum = 0.0;
        for (const auto& set : sets_) {
            double set_variance = 0.0, weight = 0.0, weighted = 0.0;
            for (std::size_t member : set) {
                const auto c = static_cast<Eigen::Index>(member);
                const double part = law.contribution(output, c) * law.correlated(output, c);
                set_variance += part;
                weight += std::abs(part);
                weighted += std::abs(part) / degrees_[member];
            }
            if (!(weighted > 0)) continue;
            approximate = approximate || set.size() > 1;
            const double relative = set_variance / variance;
            sum += relative * relative * weighted / weight;
        }
        return sum > 0 ? 1.0 / sum : infinity;
    }

private:
    std::vector<std::vector<std::size_t>> sets_;
    std::vector<double> degrees_;
};

}  // namespace

double LawOfPropagation::uncertainty(Eigen::Index j) const {
    return std::sqrt(covariance(j, j));
}

Eigen::MatrixXd factor_matrix(const InputSet& inputs) {
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(inputs.quantities.size()),
                                                    static_cast<Eigen::Index>(inputs.components.size()));
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i)
        for (const Share& share : inputs.quantities[i].shares)
            factors(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(share.component)) += share.factor;
    return factors;
}

Result<LawOfPropagation> law_of_propagation(const MeasurementModel& model, const InputSet& inputs,
                                            const Correlations& correlations) {
    LawOfPropagation law;
    const auto quantities = static_cast<Eigen::Index>(inputs.quantities.size());
    law.inputs.resize(quantities);
    for (Eigen::Index i = 0; i < quantities; ++i)
        law.inputs(i) = estimate_of(inputs, static_cast<std::size_t>(i));
    Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(model.outputs().size()), quantities);
    if (auto ok = evaluate_at_estimates(model, law, jacobian); !ok) return fail(ok.error());

    const auto components = static_cast<Eigen::Index>(inputs.components.size());
    law.u.resize(components);
    for (Eigen::Index c = 0; c < components; ++c) {
        const UncertaintyComponent& component = inputs.components[static_cast<std::size_t>(c)];
        law.u(c) = component.held ? 0.0 : component.distribution.standard_uncertainty();
    }
    law.sensitivity = jacobian * factor_matrix(inputs);
    law.contribution = law.sensitivity * law.u.asDiagonal();
    law.correlated = law.contribution;
    for (const ComponentCorrelation& r : correlations) {
        const auto a = static_cast<Eigen::Index>(r.first), b = static_cast<Eigen::Index>(r.second);
        law.correlated.col(a) += r.coefficient * law.contribution.col(b);
        law.correlated.col(b) += r.coefficient * law.contribution.col(a);
    }
    const Eigen::MatrixXd product = law.correlated * law.contribution.transpose();
    law.covariance = 0.5 * (product + product.transpose());
    law.covariance.diagonal() = law.covariance.diagonal().cwiseMax(0.0);

    const WelchSatterthwaite rule(inputs, correlations);
    law.degrees_of_freedom.resize(law.estimate.size());
    for (Eigen::Index j = 0; j < law.estimate.size(); ++j)
        law.degrees_of_freedom(j) = rule.effective(law, j, law.degrees_of_freedom_approximate);
    return law;
}

double coverage_factor_of(double probability, double degrees_of_freedom) {
    return -t_quantile(0.5 * (1.0 - probability),
                       degrees_of_freedom);  // lower tail: exact near probability 1
}

}  // namespace covaria::detail
