// Estimates, standard uncertainties and effective degrees of freedom of input quantities.
#include "core/quantity/input_quantity.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/quantity/component_pairs.h"

namespace covaria {

namespace {

/// Contributions a_j = factor_j u_j of the components of one quantity and their correlations R.
struct Contributions {
    Eigen::VectorXd a;
    Eigen::MatrixXd correlation;
    std::vector<std::size_t> components;
};

/// A component named twice counts once, with the sum of its factors; held ones contribute nothing.
Contributions merged_contributions(const InputSet& inputs, const InputQuantity& quantity) {
    Contributions c;
    std::vector<double> a;
    for (const Share& share : quantity.shares) {
        const UncertaintyComponent& component = inputs.components.at(share.component);
        if (component.held) continue;
        const double part = share.factor * component.distribution.standard_uncertainty();
        const auto known = std::find(c.components.begin(), c.components.end(), share.component);
        if (known != c.components.end()) {
            a[static_cast<std::size_t>(known - c.components.begin())] += part;
            continue;
        }
        c.components.push_back(share.component);
        a.push_back(part);
    }
    c.a = Eigen::Map<const Eigen::VectorXd>(a.data(), static_cast<Eigen::Index>(a.size()));
    return c;
}

Contributions contributions(const InputSet& inputs, const InputQuantity& quantity) {
    Contributions c = merged_contributions(inputs, quantity);
    const Eigen::Index n = c.a.size();
    c.correlation = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = i + 1; j < n; ++j) {
            const std::size_t first = c.components[static_cast<std::size_t>(i)];
            const std::size_t second = c.components[static_cast<std::size_t>(j)];
            c.correlation(i, j) = c.correlation(j, i) = detail::correlation_between(inputs, first, second);
        }
    return c;
}

double variance(const Contributions& c) {
    return std::max(0.0, c.a.dot(c.correlation * c.a));
}

}  // namespace

std::size_t InputSet::add(UncertaintyComponent component) {
    components.push_back(std::move(component));
    return components.size() - 1;
}

std::size_t InputSet::add(InputQuantity quantity, std::vector<UncertaintyComponent> own_components) {
    for (UncertaintyComponent& component : own_components)
        quantity.shares.push_back({add(std::move(component)), 1.0});
    quantities.push_back(std::move(quantity));
    return quantities.size() - 1;
}

std::size_t InputSet::find(const std::string& symbol) const {
    const auto it = std::find_if(quantities.begin(), quantities.end(),
                                 [&](const InputQuantity& q) { return q.symbol == symbol; });
    return it == quantities.end() ? npos : static_cast<std::size_t>(it - quantities.begin());
}

double estimate_of(const InputSet& inputs, std::size_t quantity) {
    const InputQuantity& q = inputs.quantities.at(quantity);
    double estimate = q.offset;
    for (const Share& share : q.shares)
        estimate += share.factor * inputs.components.at(share.component).distribution.mean();
    return estimate;
}

double standard_uncertainty_of(const InputSet& inputs, std::size_t quantity) {
    return std::sqrt(variance(contributions(inputs, inputs.quantities.at(quantity))));
}

// JCGM 100 G.4.1 with correlations: u^2 = a'Ra has the variance sum (2 (Ra)_j)^2 a_j^2/(2 nu_j), and nu_eff
// is 1/2 (u/du)^2 (G.3). For R = 1 this is Welch-Satterthwaite.
double degrees_of_freedom_of(const InputSet& inputs, std::size_t quantity) {
    const Contributions c = contributions(inputs, inputs.quantities.at(quantity));
    const double u2 = variance(c);
    const Eigen::VectorXd slopes = c.correlation * c.a;
    double sum = 0.0;
    for (Eigen::Index j = 0; j < c.a.size(); ++j) {
        const UncertaintyComponent& component = inputs.components[c.components[static_cast<std::size_t>(j)]];
        const double nu = std::min(component.degrees_of_freedom, component.distribution.degrees_of_freedom());
        sum += slopes[j] * slopes[j] * c.a[j] * c.a[j] / nu;
    }
    return sum > 0.0 ? u2 * u2 / sum : infinity;
}

}  // namespace covaria
