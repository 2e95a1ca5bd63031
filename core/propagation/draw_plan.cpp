// Addresses, factors of correlated groups and the combination of components into quantities.
#include "core/propagation/draw_plan.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/guarded.h"
#include "core/math/decompositions.h"
#include "core/math/normal_quantile.h"
#include "core/quantity/copula.h"
#include "core/random/uniforms.h"

namespace covaria::detail {
namespace {

/// `members` is sorted.
Eigen::MatrixXd correlation_matrix(const std::vector<std::size_t>& members,
                                   const std::vector<ComponentCorrelation>& correlations) {
    const auto n = static_cast<Eigen::Index>(members.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
    const auto position = [&members](std::size_t component) -> Eigen::Index {
        const auto place = std::lower_bound(members.begin(), members.end(), component);
        return place != members.end() && *place == component ? place - members.begin() : -1;
    };
    for (const ComponentCorrelation& c : correlations) {
        const Eigen::Index a = position(c.first), b = position(c.second);
        if (a >= 0 && b >= 0) matrix(a, b) = matrix(b, a) = c.coefficient;
    }
    return matrix;
}

}  // namespace

Eigen::MatrixXd correlation_factor(const Eigen::MatrixXd& correlation) {
    // Pivoted LDL^T copes with rank deficiency (arithmetic combination: all coefficients +-1).
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(correlation);
    Eigen::MatrixXd factor(correlation.rows(), 0);
    const Eigen::MatrixXd lower = ldlt.matrixL();
    for (Eigen::Index k = 0; k < lower.cols(); ++k) {
        if (!(ldlt.vectorD()(k) > 1e-12)) break;
        factor.conservativeResize(Eigen::NoChange, k + 1);
        factor.col(k) = lower.col(k) * std::sqrt(ldlt.vectorD()(k));
    }
    Eigen::MatrixXd result = ldlt.transpositionsP().transpose() * factor;
    result.rowwise().normalize();
    // Asked by its product: info() takes a rank that rounding makes unclear for a failure.
    if (!((result * result.transpose() - correlation).cwiseAbs().maxCoeff() < 1e-6))
        throw ImpossibleValue("matrix of correlations that cannot be factored");
    return result;
}

DrawPlan::DrawPlan(const InputSet& inputs, const std::vector<ComponentCorrelation>& correlations,
                   std::optional<std::size_t> only) {
    const std::size_t n = inputs.components.size();
    std::vector<ComponentDraw> draws = terms_of(inputs, only);
    add_estimates(inputs, draws);
    std::vector<bool> grouped(n, false);
    // Coefficients that cannot be are refused where inputs are checked.
    const auto copula = copula_coefficients(inputs, correlations).value_or(correlations);
    for (const auto& set : correlated_sets(n, copula)) {
        for (std::size_t c : set) grouped[c] = true;
        add_group(set, draws, copula);
    }
    for (const DrawnVector& vector : vectors_of_random_direction(inputs)) {
        for (std::size_t c : vector.components) grouped[c] = true;
        add_vector(vector, draws);
    }
    for (std::size_t c = 0; c < n; ++c)
        if (!grouped[c] && !draws[c].terms.empty()) independent_.push_back(std::move(draws[c]));
    mark_first_terms();
}

std::vector<ComponentDraw> DrawPlan::terms_of(const InputSet& inputs, std::optional<std::size_t> only) {
    std::vector<ComponentDraw> draws(inputs.components.size());
    std::vector<bool> random(draws.size());
    for (std::size_t c = 0; c < draws.size(); ++c) {
        const UncertaintyComponent& component = inputs.components[c];
        draws[c] = {static_cast<std::uint32_t>(c), drawn_distribution(component), {}};
        random[c] =
            !component.held && draws[c].distribution.standard_deviation() > 0 && (!only || *only == c);
    }
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
        double constant = inputs.quantities[i].offset;
        for (const Share& share : inputs.quantities[i].shares) {
            if (random[share.component])
                draws[share.component].terms.push_back({i, share.factor, false});
            else
                constant += share.factor * inputs.components[share.component].distribution.mean();
        }
        constant_.push_back(constant);
    }
    return draws;
}

void DrawPlan::add_estimates(const InputSet& inputs, std::vector<ComponentDraw>& draws) {
    constexpr double as_good_as_known = 1e6;  // degrees of freedom: chi^2/nu is 1 within .2 %
    for (std::size_t e = 0; e < inputs.variance_estimates.size(); ++e) {
        double nu = infinity;
        for (const std::size_t member : inputs.variance_estimates[e].components) {
            const double of_member = draws[member].distribution.degrees_of_freedom();
            if (draws[member].terms.empty() || !(of_member < as_good_as_known)) continue;
            draws[member].estimate = estimates_.size();
            nu = of_member;
        }
        if (std::isfinite(nu))
            estimates_.push_back(
                {static_cast<std::uint32_t>(e), Distribution::of(Gamma{0.5 * nu, 2.0 / nu})});
    }
}

void DrawPlan::add_group(const std::vector<std::size_t>& set, const std::vector<ComponentDraw>& draws,
                         const std::vector<ComponentCorrelation>& correlations) {
    CorrelatedDraws group;
    bool needed = false;
    for (std::size_t c : set) {
        needed = needed || !draws[c].terms.empty();
        group.members.push_back(draws[c]);
    }
    if (!needed) return;
    const Eigen::MatrixXd wanted = correlation_matrix(set, correlations);
    const bool normal = std::all_of(set.begin(), set.end(), [&](std::size_t c) {
        return draws[c].distribution.kind() == "normal";  // then it has been checked as it is
    });
    const Eigen::MatrixXd possible = normal ? wanted : nearest_correlation(wanted);
    largest_compromise_ = std::max(largest_compromise_, (possible - wanted).cwiseAbs().maxCoeff());
    group.factor = correlation_factor(possible);
    for (Eigen::Index k = 0; k < group.factor.cols(); ++k)
        group.addresses.push_back(static_cast<std::uint32_t>(set[static_cast<std::size_t>(k)]));
    latent_rows_ = std::max(latent_rows_, group.addresses.size());
    correlated_.push_back(std::move(group));
}

void DrawPlan::add_vector(const DrawnVector& vector, const std::vector<ComponentDraw>& draws) {
    VectorDraws added{vector.length, {}};
    bool needed = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        added.members[axis] = draws[vector.components[axis]];
        needed = needed || !added.members[axis].terms.empty();
    }
    if (!needed) return;
    latent_rows_ = std::max(latent_rows_, added.members.size());
    vectors_.push_back(std::move(added));
}

void DrawPlan::mark_first_terms() {
    drawn_.assign(constant_.size(), false);
    const auto mark = [this](ComponentDraw& draw) {
        for (DrawTerm& term : draw.terms) {
            term.first = !drawn_[term.quantity];
            drawn_[term.quantity] = true;
        }
    };
    for (ComponentDraw& draw : independent_) mark(draw);
    for (CorrelatedDraws& group : correlated_)
        for (ComponentDraw& draw : group.members) mark(draw);
    for (VectorDraws& vector : vectors_)
        for (ComponentDraw& draw : vector.members) mark(draw);
}

void DrawPlan::fill(DrawPurpose purpose, std::uint64_t seed, std::uint32_t address, std::uint64_t first,
                    std::span<double> u) const {
    if (points_)
        points_->fill(purpose, address, first, u);
    else
        uniforms(seed, purpose, address, first, u);
}

void DrawPlan::draw_estimates(std::uint64_t seed, std::uint64_t first, std::size_t count,
                              DrawWorkspace& workspace) const {
    for (std::size_t e = 0; e < estimates_.size(); ++e) {
        const std::span<double> divisor(workspace.latent.row(e), count);
        fill(DrawPurpose::variance_estimates, seed, estimates_[e].address, first, divisor);
        estimates_[e].ratio.quantiles(divisor, divisor);
        for (double& d : divisor) d = std::sqrt(d);
    }
}

void DrawPlan::realise(const ComponentDraw& component, std::span<double> p,
                       const DrawWorkspace& workspace) const {
    if (component.estimate == ComponentDraw::no_estimate) return component.distribution.quantiles(p, p);
    normal_quantiles(p, p);
    realise_scores(component, p, workspace);
}

void DrawPlan::realise_scores(const ComponentDraw& component, std::span<double> z,
                              const DrawWorkspace& workspace) const {
    if (component.estimate == ComponentDraw::no_estimate)
        return component.distribution.from_standard_normal(z, z);
    const double mean = component.distribution.mean(), scale = component.distribution.standard_uncertainty();
    const double* divisor = workspace.latent.row(component.estimate);
    for (std::size_t t = 0; t < z.size(); ++t) z[t] = mean + scale * z[t] / divisor[t];
}

void DrawPlan::add_terms(const ComponentDraw& component, const double* epsilon, std::size_t count,
                         TrialRows& inputs) const {
    for (const DrawTerm& term : component.terms) {
        double* x = inputs.row(term.quantity);
        if (term.first) {
            const double constant = constant_[term.quantity];
            for (std::size_t t = 0; t < count; ++t) x[t] = constant + term.factor * epsilon[t];
        } else {
            for (std::size_t t = 0; t < count; ++t) x[t] += term.factor * epsilon[t];
        }
    }
}

void DrawPlan::draw_group(const CorrelatedDraws& group, std::uint64_t seed, std::uint64_t first,
                          std::size_t count, TrialRows& inputs, DrawWorkspace& workspace) const {
    for (std::size_t k = 0; k < group.addresses.size(); ++k) {
        const std::span<double> normal(workspace.latent.row(estimates_.size() + k), count);
        fill(DrawPurpose::trials, seed, group.addresses[k], first, normal);
        normal_quantiles(normal, normal);
    }
    double* z = workspace.draw.row(0);
    for (std::size_t member = 0; member < group.members.size(); ++member) {
        if (group.members[member].terms.empty()) continue;
        std::fill_n(z, count, 0.0);
        for (std::size_t k = 0; k < group.addresses.size(); ++k) {
            const double f = group.factor(static_cast<Eigen::Index>(member), static_cast<Eigen::Index>(k));
            if (f == 0.0) continue;
            const double* normal = workspace.latent.row(estimates_.size() + k);
            for (std::size_t t = 0; t < count; ++t) z[t] += f * normal[t];
        }
        realise_scores(group.members[member], {z, count}, workspace);
        add_terms(group.members[member], z, count, inputs);
    }
}

void DrawPlan::draw_vector(const VectorDraws& vector, std::uint64_t seed, std::uint64_t first,
                           std::size_t count, TrialRows& inputs, DrawWorkspace& workspace) const {
    std::array<std::span<double>, 3> rows;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double* row = workspace.latent.row(estimates_.size() + axis);
        rows[axis] = {row, padded_to_lanes(count)};
        fill(DrawPurpose::trials, seed, vector.members[axis].address, first, {row, count});
        std::fill(row + count, row + padded_to_lanes(count), 0.5);
    }
    draw_directions(vector.length, rows);
    for (std::size_t axis = 0; axis < 3; ++axis)
        add_terms(vector.members[axis], workspace.latent.row(estimates_.size() + axis), count, inputs);
}

void DrawPlan::draw(std::uint64_t seed, std::uint64_t first, std::size_t count, TrialRows& inputs,
                    DrawWorkspace& workspace) const {
    for (std::size_t i = 0; i < constant_.size(); ++i)
        if (!drawn_[i]) std::fill_n(inputs.row(i), count, constant_[i]);
    draw_estimates(seed, first, count, workspace);
    double* epsilon = workspace.draw.row(0);
    for (const ComponentDraw& component : independent_) {
        fill(DrawPurpose::trials, seed, component.address, first, {epsilon, count});
        realise(component, {epsilon, count}, workspace);
        add_terms(component, epsilon, count, inputs);
    }
    for (const CorrelatedDraws& group : correlated_) draw_group(group, seed, first, count, inputs, workspace);
    for (const VectorDraws& vector : vectors_) draw_vector(vector, seed, first, count, inputs, workspace);
    for (std::size_t i = 0; i < constant_.size(); ++i) {
        double* x = inputs.row(i);
        std::fill(x + count, x + padded_to_lanes(count), x[count - 1]);
    }
}

}  // namespace covaria::detail
