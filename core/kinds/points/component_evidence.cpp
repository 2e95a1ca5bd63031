#include "core/kinds/points/component_evidence.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <set>

#include "core/text/numbers.h"

namespace covaria {

namespace {

Eigen::MatrixXd columns_of(const Eigen::MatrixXd& all, const std::vector<std::size_t>& chosen) {
    Eigen::MatrixXd columns(all.rows(), static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t i = 0; i < chosen.size(); ++i)
        columns.col(static_cast<Eigen::Index>(i)) = all.col(static_cast<Eigen::Index>(chosen[i]));
    return columns;
}

evidence::StatedFigure stated_figure(const InputSet& inputs, const FigureOfComponent& of,
                                     const std::vector<std::size_t>& components) {
    evidence::StatedFigure figure{
        .name = of.name, .unit = of.unit, .count = components.size(), .source = of.source};
    for (const std::size_t c : components) {
        const double u = inputs.components[c].distribution.standard_uncertainty();
        figure.least = c == components.front() ? u : std::min(figure.least, u);
        figure.most = std::max(figure.most, u);
    }
    return figure;
}

void leave_estimates(InputSet& inputs, const std::set<std::size_t>& components) {
    for (VarianceEstimate& estimate : inputs.variance_estimates)
        std::erase_if(estimate.components, [&](std::size_t c) { return components.contains(c); });
    std::erase_if(inputs.variance_estimates,
                  [](const VarianceEstimate& estimate) { return estimate.components.empty(); });
}

void take_figure(InputSet& inputs, const std::vector<std::size_t>& components,
                 const evidence::TakenFactor& taken, std::size_t estimate) {
    leave_estimates(inputs, {components.begin(), components.end()});
    for (const std::size_t c : components) {
        UncertaintyComponent& component = inputs.components[c];
        const Distribution& stated = component.distribution;
        component.distribution =
            Distribution::of(Normal{stated.mean(), taken.factor * stated.standard_uncertainty()});
        component.type = EvaluationType::type_a;
        component.degrees_of_freedom = taken.degrees_of_freedom;
        component.origin =
            tell<"as seen: %1 times what was stated">(Message::number(format_significant(taken.factor, 3)));
        inputs.rest_on_estimate("seen." + std::to_string(estimate), c);
    }
}

}  // namespace

ComponentsOfFigures add_figures(const InputSet& inputs,
                                const std::map<std::size_t, FigureOfComponent>& figure_of,
                                const Eigen::MatrixXd& deviations, evidence::RedundantReadings& readings) {
    std::map<std::string, std::vector<std::size_t>> members;
    std::vector<std::size_t> others;
    for (std::size_t c = 0; c < inputs.components.size(); ++c) {
        if (!(deviations.col(static_cast<Eigen::Index>(c)).squaredNorm() > 0.0)) continue;
        const auto known = figure_of.find(c);
        (known == figure_of.end() ? others : members[known->second.key]).push_back(c);
    }
    ComponentsOfFigures figures;
    for (auto& [key, components] : members) {
        if (components.size() == 1) {
            others.push_back(components.front());
            continue;
        }
        readings.figures.push_back(stated_figure(inputs, figure_of.at(components.front()), components));
        readings.shares.push_back(columns_of(deviations, components));
        figures.push_back(std::move(components));
    }
    readings.others = columns_of(deviations, others);
    return figures;
}

void FitsWithSharedComponents::add(const std::vector<Row>& rows) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    Fit fit{Eigen::MatrixXd(n, rows.front().design.size()),
            Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(inputs_.components.size())),
            Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Row& row = rows[static_cast<std::size_t>(i)];
        names_.push_back(row.name);
        for (std::size_t k = 0; k < abscissas_.size(); ++k)
            abscissas_[k].values.push_back(k < row.over.size() ? row.over[k]
                                                               : std::numeric_limits<double>::quiet_NaN());
        fit.design.row(i) = row.design.transpose();
        fit.residuals[i] = row.residual;
        for (const Part& part : row.parts)
            for (const Share& share : inputs_.quantities[part.quantity].shares)
                fit.deviations(i, static_cast<Eigen::Index>(share.component)) +=
                    part.factor * share.factor *
                    inputs_.components[share.component].distribution.standard_uncertainty();
    }
    const Eigen::VectorXd scale = fit.design.colwise().norm();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(fit.design * scale.cwiseInverse().asDiagonal());
    const Eigen::MatrixXd taken = qr.householderQ() * Eigen::MatrixXd::Identity(n, fit.design.cols());
    fit.residuals -= taken * (taken.transpose() * fit.residuals);
    const Eigen::MatrixXd left = fit.deviations - taken * (taken.transpose() * fit.deviations);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double u = left.row(i).norm();
        w_.push_back(u > 0.0 ? fit.residuals[i] / u : std::numeric_limits<double>::quiet_NaN());
    }
    fits_.push_back(std::move(fit));
}

ComponentEvidence FitsWithSharedComponents::evidence(
    const std::map<std::size_t, FigureOfComponent>& figure_of) const {
    const auto rows = static_cast<Eigen::Index>(names_.size());
    if (names_.empty() || names_.size() > evidence::most_sharing_readings) return {};
    Eigen::Index unknowns = 0;
    for (const Fit& fit : fits_) unknowns += fit.design.cols();
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(rows, unknowns);
    Eigen::MatrixXd deviations(rows, static_cast<Eigen::Index>(inputs_.components.size()));
    auto readings = std::make_shared<evidence::RedundantReadings>();
    readings->residuals.resize(rows);
    Eigen::Index row = 0, column = 0;
    for (const Fit& fit : fits_) {
        const Eigen::Index n = fit.design.rows();
        design.block(row, column, n, fit.design.cols()) = fit.design;
        deviations.middleRows(row, n) = fit.deviations;
        readings->residuals.segment(row, n) = fit.residuals;
        row += n;
        column += fit.design.cols();
    }
    readings->design = design.sparseView();
    readings->names = names_;
    readings->abscissas = abscissas_;
    readings->w = w_;
    readings->figure_of.assign(names_.size(), evidence::RedundantReadings::no_figure);
    readings->take_over = take_over_of_uncertainties();
    ComponentsOfFigures figures = add_figures(inputs_, figure_of, deviations, *readings);
    if (figures.empty()) return {};
    return {std::move(readings), std::move(figures)};
}

void take_as_seen(InputSet& inputs, const ComponentEvidence& evidence, evidence::UncertaintiesFrom from,
                  const std::string& place, Problems& problems) {
    const evidence::AsSeen taken = evidence::as_seen(evidence.readings.get(), from, place, problems);
    if (!taken.has_any()) return;
    for (std::size_t k = 0; k < evidence.figures.size(); ++k)
        if (taken.factors[k].is_seen())
            take_figure(inputs, evidence.figures[k], taken.factors[k],
                        from == evidence::UncertaintiesFrom::one_factor ? 0 : k);
}

std::vector<ChoiceOf<evidence::UncertaintiesFrom>> choices_of_uncertainties() {
    using From = evidence::UncertaintiesFrom;
    return {{From::stated, "stated", "as stated"},
            {From::one_factor, "one-factor", "as seen, one factor s_0"},
            {From::seen, "seen", "as seen, a factor for each figure"}};
}

evidence::TakeOver take_over_of_uncertainties() {
    return {uncertainties_key, "stated", "seen"};
}

Remedy remedy_as_seen(std::string place) {
    return {tell<"uncertainties as the residuals see them">(), {{std::move(place), std::string("seen")}}};
}

}  // namespace covaria
