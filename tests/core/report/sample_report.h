// A result made by hand for tests of reports: some poses of six outputs with inputs, budget, regions and
// histograms.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/report/report.h"
#include "core/text/symbol.h"

namespace covaria::test {

inline const Unit& mm() {
    static const Unit unit = Unit::of("mm");
    return unit;
}
inline const Unit& deg() {
    static const Unit unit = Unit::of("deg");
    return unit;
}

struct SampleOptions {
    int poses = 13;
    int base_points = 3, platform_points = 3;
    bool monte_carlo = true;
    std::string group_name = "pose";
};

inline const ModelDescriptor& sample_model() {
    static const ModelDescriptor descriptor = [] {
        ModelDescriptor d;
        d.id = "sample-pose";
        d.title = "Pose from points <sample>";
        d.summary =
            "The pose of a moving frame in a base frame, both defined by three measured points & an offset.";
        d.references = {{"A. Author: Poses from points, J. of Frames 1 (2020), Eqs 1-6"}};
        d.equations = {{"o = R_bᵀ (o_p − o_b)", "Author, Eq. 4"},
                       {"R = R_bᵀ R_p", "Author, Eq. 5, corrected"}};
        d.notes = {"Equation 5 is used as R_bᵀ R_p; the source prints R_p R_bᵀ."};
        FieldSpec mode{"mode", "Mode | a priori or not", FieldKind::choice, "How.", {},
                       {},     std::string("a-priori")};
        mode.choices = {{"a-priori", "a priori (nominal)"}};
        FieldSpec side{"side", "Side of the triangle", FieldKind::number, "Length.", mm(),
                       {},     Quantity{688.0, mm()}};
        FieldSpec points{"points", "Base points", FieldKind::table, "Coordinates.", {}, {}, {}};
        points.columns = {{"point", "point", FieldKind::text},
                          {"x", "x", FieldKind::number, mm()},
                          {"u_x", "u_x", FieldKind::number, mm()},
                          {"note", "note", FieldKind::text}};
        d.schema = SetupSchema({mode, side, points});
        return d;
    }();
    return descriptor;
}

inline Setup sample_setup() {
    Setup setup;
    SetupTable table;
    table.units = {Unit{}, mm(), mm(), Unit{}};
    table.rows = {{std::string("b1"), -344.0, 0.066, {}}, {std::string("b2"), 344.0, 0.066, {}}};
    setup.values["points"] = table;
    return setup;
}

inline Project sample_project() {
    Project project;
    project.title = "Stewart platform <test & trial>";
    AnalysisEntry entry;
    entry.id = "typed";
    entry.model = "sample-pose";
    entry.name = "Pose of the platform";
    entry.setup = sample_setup();
    entry.requirements = {{"pose 1", "x", Quantity{0.5, mm()}},
                          {"pose 1", "z", Quantity{500.0, Unit::of("um")}}};
    project.analyses = {entry};
    return project;
}

inline void add_point_inputs(InputSet& inputs, const std::string& point, const std::string& group,
                             double u_mm) {
    for (const char axis : {'x', 'y', 'z'}) {
        UncertaintyComponent component;
        component.id = point + axis + ".typed";
        component.name = tell<"coordinate of a point">();
        component.unit = mm();
        component.distribution = Distribution::normal(1e-3 * u_mm);
        component.origin = tell<"typed, Table 1">();
        InputQuantity quantity;
        quantity.symbol = point + axis;
        quantity.name = tell<"point %1, %2">(point, std::string(1, axis));
        quantity.unit = mm();
        quantity.offset = 0.344;
        quantity.group = group;
        inputs.add(quantity, {component});
    }
}

inline InputSet sample_inputs(const SampleOptions& options) {
    InputSet inputs;
    for (int i = 1; i <= options.base_points; ++i)
        add_point_inputs(inputs, "b_" + std::to_string(i), "base", 0.066);
    for (int pose = 1; pose <= options.poses; ++pose)
        for (int i = 1; i <= options.platform_points; ++i)
            add_point_inputs(inputs, "p_" + std::to_string(pose) + "_" + std::to_string(i),
                             options.group_name + " " + std::to_string(pose), 0.236);
    return inputs;
}

inline MonteCarloOutput sample_monte_carlo(double estimate, double u) {
    MonteCarloOutput trials;
    trials.mean = estimate + 1e-4 * u;
    trials.standard_uncertainty = u;
    trials.standard_error_of_mean = 1e-3 * u;
    trials.standard_error_of_uncertainty = 7e-4 * u;
    trials.symmetric = {estimate - 1.96 * u, estimate + 1.96 * u};
    trials.shortest = {estimate - 1.959 * u, estimate + 1.958 * u};
    trials.skewness = -0.0031;
    trials.kurtosis = 0.0042;
    trials.normality.words = "normal within 1 %";
    trials.histogram = {estimate - 4.0 * u, estimate + 4.0 * u, {}, 0, 3};
    for (int i = 0; i < 40; ++i) {
        const double z = -4.0 + 0.2 * (i + 0.5);
        trials.histogram.counts.push_back(static_cast<std::uint64_t>(79788.0 * std::exp(-0.5 * z * z)));
    }
    for (int i = 1; i <= 199; ++i) trials.quantiles.push_back(estimate + u * (i - 100) / 50.0);
    return trials;
}

inline OutputResult sample_output(const std::string& symbol, const std::string& group, double estimate,
                                  double u) {
    OutputResult output;
    const bool angle = symbol.size() > 1;
    output.quantity = {symbol,
                       tell<"%1 of the platform">(symbol_to_unicode(symbol)),
                       angle ? deg() : mm(),
                       group,
                       OutputRole::measurand,
                       angle};
    output.first_order = {estimate, 1.001 * u, infinity, 2.0, 2.002 * u, {}, {}, {}};
    output.estimate = estimate;
    output.standard_uncertainty = u;
    output.coverage_factor = 2.0;
    output.expanded_uncertainty = 2.0 * u;
    return output;
}

inline void add_pose(UncertaintyResult& result, const std::string& group, int pose) {
    const double to_rad = std::acos(-1.0) / 180.0;
    const double grow = 1.0 + 0.01 * (pose % 5);
    const std::pair<const char*, std::array<double, 2>> outputs[] = {
        {"x", {-0.12 + 0.001 * pose, 0.000367 * grow}},
        {"y", {0.12, 0.000313 * grow}},
        {"z", {1.174909, 0.00015 * grow}},
        {"alpha", {5.0 * to_rad, 0.0505 * to_rad}},
        {"beta", {-5.0 * to_rad, 0.0505 * to_rad}},
        {"gamma", {0.0, 0.0505 * to_rad}}};
    for (const auto& [symbol, numbers] : outputs)
        result.outputs.push_back(sample_output(symbol, group, numbers[0], numbers[1]));
}

inline void add_budget(UncertaintyResult& result) {
    for (const UncertaintyComponent& c : result.inputs->components)
        result.budget.components.push_back({.id = c.id,
                                            .name = c.name,
                                            .origin = c.origin,
                                            .unit = c.unit,
                                            .distribution = "normal",
                                            .type = c.type,
                                            .standard_uncertainty = c.distribution.standard_uncertainty(),
                                            .quantities = {c.id.substr(0, c.id.find('.'))},
                                            .group = "base",
                                            .estimate = 0.344});
    const std::size_t rows = std::min<std::size_t>(18, result.budget.components.size());
    for (const OutputResult& output : result.outputs) {
        std::vector<BudgetRow> list;
        const double share = 1.0 / static_cast<double>(rows);
        for (std::size_t i = 0; i < rows; ++i) {
            const double contribution = output.standard_uncertainty * std::sqrt(share);
            list.push_back({i,
                            contribution / result.budget.components[i].standard_uncertainty,
                            contribution,
                            share,
                            {}});
        }
        result.budget.rows.push_back(std::move(list));
    }
}

inline void add_covariance(UncertaintyResult& result) {
    const auto n = static_cast<Eigen::Index>(result.outputs.size());
    Eigen::MatrixXd covariance(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const double r = i == j ? 1.0 : 0.25 / (1.0 + static_cast<double>(std::abs(i - j)));
            covariance(i, j) = r * result.outputs[static_cast<std::size_t>(i)].standard_uncertainty *
                               result.outputs[static_cast<std::size_t>(j)].standard_uncertainty;
        }
    result.covariance = std::move(covariance);
}

inline void add_trials(UncertaintyResult& result) {
    result.trials = 1'000'000;
    for (OutputResult& output : result.outputs) {
        output.monte_carlo = sample_monte_carlo(output.estimate, output.standard_uncertainty);
        const double delta = 0.005 * output.standard_uncertainty;
        output.first_order.validation = FirstOrderOutput::Validation{delta, 0.5 * delta, 0.6 * delta, true};
    }
    for (const std::uint64_t trials : {10'000ULL, 100'000ULL, 1'000'000ULL}) {
        ConvergencePoint point;
        point.trials = trials;
        for (const OutputResult& output : result.outputs) {
            point.mean.push_back(output.estimate);
            point.standard_uncertainty.push_back(output.standard_uncertainty);
        }
        result.convergence.push_back(std::move(point));
    }
}

inline UncertaintyResult sample_result(const SampleOptions& options = {}) {
    UncertaintyResult result;
    result.inputs = sample_inputs(options);
    for (int pose = 1; pose <= options.poses; ++pose) {
        const std::string group = options.group_name + " " + std::to_string(pose);
        add_pose(result, group, pose);
        const std::size_t first = result.outputs.size() - 6;
        CoverageRegion region;
        region.group = group;
        for (std::size_t i = 0; i < 6; ++i) region.outputs.push_back(first + i);
        region.ellipsoid_first_order = 3.5485;
        region.rectangle_first_order = 2.6383;
        if (options.monte_carlo) {
            region.ellipsoid_monte_carlo = 3.5491;
            region.rectangle_monte_carlo = 2.6312;
            region.trials = 1'000'000;
        }
        result.regions.push_back(std::move(region));
    }
    add_budget(result);
    add_covariance(result);
    if (options.monte_carlo) add_trials(result);
    result.provenance = {"0123456789abcdef", "0.2.0", 18446744073709551615ULL};
    return result;
}

inline EvaluatedAnalysis sample_analysis(UncertaintyResult result) {
    const auto propagated =
        std::make_shared<const PropagatedModel>(nullptr, std::make_shared<const InputSet>(result.inputs));
    const auto prepared = std::make_shared<PreparedAnalysis>(
        PreparedAnalysis{.id = "typed",
                         .name = "Pose of the platform",
                         .descriptor = &sample_model(),
                         .assets = {},
                         .propagated = propagated,
                         .model = nullptr,
                         .inputs = propagated->inputs(),
                         .options = {},
                         .numbers = std::make_shared<const AnalysisNumbers>(
                             std::make_shared<const Project>(sample_project()), "typed")});
    return {prepared, std::make_shared<UncertaintyResult>(std::move(result)), {}};
}

inline ReportDocument sample_report(const SampleOptions& options = {}) {
    return build_report(*MadeProject::make(sample_project()), {sample_analysis(sample_result(options))});
}

}  // namespace covaria::test
