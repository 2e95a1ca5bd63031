// Law of propagation of uncertainty.
#include "core/propagation/first_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/math/special_quantiles.h"
#include "core/propagation/condensed_law.h"
#include "core/propagation/term_maker.h"

namespace covaria::detail {
namespace {

constexpr double unknown_to_first_order = std::numeric_limits<double>::quiet_NaN();

using OutputFlags = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// " (alpha, gamma of pose 7)": the outputs without the flag; empty if it is known of none.
Message named_outputs(const MeasurementModel& model, const OutputFlags& good) {
    std::vector<std::pair<std::string, std::string>> groups;  // groups with the symbols of their outputs
    for (std::size_t j = 0; j < model.outputs().size(); ++j) {
        if (good[static_cast<Eigen::Index>(j)]) continue;
        const OutputQuantity& output = model.outputs()[j];
        if (!groups.empty() && groups.back().first == output.group)
            groups.back().second += ", " + output.symbol;
        else
            groups.emplace_back(output.group, output.symbol);
    }
    Message words;
    for (const auto& [group, symbols] : groups) {
        if (!words.empty()) words += "; ";
        words += group.empty() ? Message(symbols) : tell<"%1 of %2">(symbols, group);
    }
    return words.empty() ? Message{} : " (" + words + ")";
}

/// Sensitivity coefficients of the outputs that have them, and which these are: none where the model does not
/// say.
OutputFlags differentiable_outputs(const MeasurementModel& model, std::span<const double> x,
                                   SensitivityRows& rows) {
    constexpr std::size_t affordable = 10'000'000;  // numbers in the matrix
    OutputFlags good = OutputFlags::Constant(static_cast<Eigen::Index>(model.outputs().size()), false);
    rows.assign(model.outputs().size(), {});
    if (model.outputs().size() * x.size() > affordable) return good;
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(good.size(), static_cast<Eigen::Index>(x.size()));
    model.jacobian(x, J);
    if (J.rows() != good.size() || J.allFinite()) return good;
    for (Eigen::Index j = 0; j < good.size(); ++j) {
        good[j] = J.row(j).allFinite();
        for (Eigen::Index i = 0; good[j] && i < J.cols(); ++i)
            if (J(j, i) != 0.0)
                rows[static_cast<std::size_t>(j)].push_back({static_cast<std::size_t>(i), J(j, i)});
    }
    return good;
}

std::span<const double> estimates_in(const LawOfPropagation& law) {
    return {law.inputs.data(), static_cast<std::size_t>(law.inputs.size())};
}

Result<void> evaluate_at_estimates(const MeasurementModel& model, LawOfPropagation& law) {
    const std::span<const double> x = estimates_in(law);
    law.estimate.resize(static_cast<Eigen::Index>(model.outputs().size()));
    const std::span<double> y(law.estimate.data(), model.outputs().size());
    law.estimate.setZero();
    if (!model.evaluate(x, y) || !law.estimate.allFinite())
        return fail(ErrorCode::numeric,
                    tell<"the measurement model has no value at the estimates of its input quantities%1: "
                         "check the nominal geometry and the values entered">(
                        named_outputs(model, law.estimate.array().isFinite())));
    law.differentiable.assign(model.outputs().size(), true);
    return {};
}

void take_sensitivities(const MeasurementModel& model, LawOfPropagation& law) {
    const std::span<const double> x = estimates_in(law);
    if (model.sensitivities(x, law.sensitivities)) return;
    const OutputFlags good = differentiable_outputs(model, x, law.sensitivities);
    law.differentiable.assign(good.begin(), good.end());
}

constexpr std::size_t most_dense = 4'000'000;  // outputs x components of a matrix made without a thought
constexpr std::size_t few_outputs = 64;        // outputs that a component concerns, for sums without a matrix

/// Covariance (c u) R (c u)^T. In large models components that concern few outputs are added one by one.
Eigen::MatrixXd whole_covariance(const LawOfPropagation& law) {
    struct Entry {
        Eigen::Index output;
        double contribution, correlated;
    };
    const auto components = static_cast<std::size_t>(law.u.size());
    const auto outputs = static_cast<Eigen::Index>(law.terms.size());
    std::vector<std::vector<Entry>> columns(components);
    for (Eigen::Index j = 0; j < outputs; ++j)
        for (const PropagationTerm& t : law.terms[static_cast<std::size_t>(j)])
            columns[t.component].push_back({j, t.contribution, t.correlated});
    const bool all = law.terms.size() * components <= most_dense;
    std::vector<std::size_t> dense;
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(outputs, outputs);
    for (std::size_t c = 0; c < components; ++c) {
        if (all || columns[c].size() > few_outputs) {
            dense.push_back(c);
            continue;
        }
        for (const Entry& a : columns[c])
            for (const Entry& b : columns[c]) covariance(a.output, b.output) += a.correlated * b.contribution;
    }
    const auto width = static_cast<Eigen::Index>(dense.size());
    Eigen::MatrixXd contribution = Eigen::MatrixXd::Zero(outputs, width), correlated = contribution;
    for (Eigen::Index k = 0; k < width; ++k)
        for (const Entry& entry : columns[dense[static_cast<std::size_t>(k)]]) {
            contribution(entry.output, k) = entry.contribution;
            correlated(entry.output, k) = entry.correlated;
        }
    if (!all && correlated == contribution) {
        covariance.selfadjointView<Eigen::Lower>().rankUpdate(contribution);
        covariance.triangularView<Eigen::StrictlyUpper>() = covariance.transpose();
    } else {
        covariance.noalias() += correlated * contribution.transpose();
        for (Eigen::Index j = 0; j < outputs;
             ++j)  // in place: with thousands of outputs it is the largest matrix
            for (Eigen::Index i = 0; i < j; ++i)
                covariance(i, j) = covariance(j, i) = 0.5 * (covariance(i, j) + covariance(j, i));
    }
    covariance.diagonal() = covariance.diagonal().cwiseMax(0.0);
    return covariance;
}

}  // namespace

Eigen::MatrixXd covariance_among(const LawOfPropagation& law, const std::vector<std::size_t>& outputs) {
    const auto size = static_cast<Eigen::Index>(outputs.size());
    Eigen::MatrixXd covariance(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j <= i; ++j) {
            const std::size_t a = outputs[static_cast<std::size_t>(i)],
                              b = outputs[static_cast<std::size_t>(j)];
            const double sum = covariance_of_pair(law.terms[a], law.terms[b]);
            covariance(i, j) = covariance(j, i) = a == b ? std::max(sum, 0.0) : sum;
        }
    return covariance;
}

namespace {

OutputCovariance covariance_of(const LawOfPropagation& law, const OutputBlocks& blocks) {
    if (blocks.is_one()) return whole_covariance(law);
    OutputCovariance covariance(blocks);
    for (std::size_t k = 0; k < blocks.list().size(); ++k) {
        std::vector<std::size_t> outputs(static_cast<std::size_t>(blocks.list()[k].size));
        std::iota(outputs.begin(), outputs.end(), static_cast<std::size_t>(blocks.list()[k].first));
        covariance.block(k) = covariance_among(law, outputs);
    }
    return covariance;
}

}  // namespace

WelchSatterthwaite degrees_of_freedom_rule(const InputSet& inputs, const Correlations& correlations) {
    const std::vector<std::size_t> estimates = inputs.estimates_of_components();
    std::vector<WelchSatterthwaite::Source> sources;
    for (std::size_t c = 0; c < inputs.components.size(); ++c)
        sources.push_back({degrees_of_freedom_of(inputs.components[c]), estimates[c]});
    return {std::move(sources), correlations};
}

namespace {

void add_degrees_of_freedom(const InputSet& inputs, const Correlations& correlations, LawOfPropagation& law) {
    WelchSatterthwaite rule = degrees_of_freedom_rule(inputs, correlations);
    law.degrees_of_freedom.resize(law.estimate.size());
    std::vector<WelchSatterthwaite::Part> parts;
    for (Eigen::Index j = 0; j < law.estimate.size(); ++j) {
        parts.clear();
        for (const PropagationTerm& term : law.terms[static_cast<std::size_t>(j)])
            parts.push_back({term.component, term.contribution * term.correlated});
        const auto effective = rule.effective(parts, law.covariance(j, j));
        law.degrees_of_freedom(j) = effective.degrees_of_freedom;
        law.degrees_of_freedom_approximate = law.degrees_of_freedom_approximate || effective.approximate;
    }
}

}  // namespace

bool LawOfPropagation::is_differentiable() const {
    return std::find(differentiable.begin(), differentiable.end(), false) == differentiable.end();
}

Error without_sensitivities(const MeasurementModel& model, const LawOfPropagation& law) {
    OutputFlags good(static_cast<Eigen::Index>(law.differentiable.size()));
    for (Eigen::Index j = 0; j < good.size(); ++j) good[j] = law.differentiable[static_cast<std::size_t>(j)];
    return {ErrorCode::numeric,
            tell<"the measurement model has no sensitivity coefficients at the estimates of its input "
                 "quantities%1: it is not differentiable there (singular geometry); Monte Carlo needs none">(
                good.any() ? named_outputs(model, good) : Message()),
            {}};
}

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

namespace {

/// All terms of all outputs, and what follows from them.
void take_terms(const MeasurementModel& model, const InputSet& inputs, const Correlations& correlations,
                LawOfPropagation& law) {
    take_sensitivities(model, law);
    TermMaker maker(inputs, correlations, law.u);
    for (const std::vector<Sensitivity>& row : law.sensitivities) maker.make(row, law.terms.emplace_back());
    law.covariance = covariance_of(law, OutputBlocks::of(model.outputs()));
    for (std::size_t j = 0; j < law.differentiable.size(); ++j)
        if (!law.differentiable[j]) law.covariance.set(static_cast<Eigen::Index>(j), unknown_to_first_order);
    add_degrees_of_freedom(inputs, correlations, law);
}

}  // namespace

Result<LawOfPropagation> law_of_propagation(const MeasurementModel& model, const InputSet& inputs,
                                            const Correlations& correlations, const LawSizes& sizes) {
    LawOfPropagation law;
    const auto quantities = static_cast<Eigen::Index>(inputs.quantities.size());
    law.inputs.resize(quantities);
    for (Eigen::Index i = 0; i < quantities; ++i)
        law.inputs(i) = estimate_of(inputs, static_cast<std::size_t>(i));
    if (auto ok = evaluate_at_estimates(model, law); !ok) return fail(ok.error());

    const auto components = static_cast<Eigen::Index>(inputs.components.size());
    law.u.resize(components);
    for (Eigen::Index c = 0; c < components; ++c) {
        const UncertaintyComponent& component = inputs.components[static_cast<std::size_t>(c)];
        law.u(c) = component.held ? 0.0 : component.distribution.standard_uncertainty();
    }
    const bool are_many = model.outputs().size() * inputs.quantities.size() > sizes.most_sensitivities;
    const auto source = are_many ? model.sensitivity_source(estimates_in(law)) : nullptr;
    if (source)
        condense(*source, model, inputs, correlations, sizes.most_budget_rows, law);
    else
        take_terms(model, inputs, correlations, law);
    return law;
}

namespace {

/// The law with the standard deviations of what is drawn: its terms alone.
LawOfPropagation law_of_draws(const InputSet& inputs, const Correlations& correlations,
                              const LawOfPropagation& law) {
    LawOfPropagation drawn;
    drawn.u = law.u;
    for (Eigen::Index c = 0; c < drawn.u.size(); ++c)
        if (drawn.u(c) > 0.0)
            drawn.u(c) =
                drawn_distribution(inputs.components[static_cast<std::size_t>(c)]).standard_deviation();
    TermMaker maker(inputs, correlations, drawn.u);
    for (const std::vector<Sensitivity>& row : law.sensitivities) maker.make(row, drawn.terms.emplace_back());
    return drawn;
}

}  // namespace

OutputCovariance covariance_of_draws(const InputSet& inputs, const Correlations& correlations,
                                     const LawOfPropagation& law) {
    return covariance_of(law_of_draws(inputs, correlations, law), law.covariance.blocks());
}

Eigen::MatrixXd covariance_of_draws(const InputSet& inputs, const Correlations& correlations,
                                    const LawOfPropagation& law, const std::vector<std::size_t>& outputs) {
    const LawOfPropagation drawn = law_of_draws(inputs, correlations, law);
    const OutputBlocks& blocks = law.covariance.blocks();
    return blocks.is_one() ? covariance_of(drawn, blocks).among(outputs) : covariance_among(drawn, outputs);
}

Eigen::MatrixXd sensitivity_matrix(const LawOfPropagation& law) {
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(law.estimate.size(), law.u.size());
    for (std::size_t j = 0; j < law.terms.size(); ++j)
        for (const PropagationTerm& term : law.terms[j])
            c(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(term.component)) = term.sensitivity;
    return c;
}

double coverage_factor_of(double probability, double degrees_of_freedom) {
    return -t_quantile(0.5 * (1.0 - probability),
                       degrees_of_freedom);  // lower tail: exact near probability 1
}

}  // namespace covaria::detail
