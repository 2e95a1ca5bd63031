// The tables of one analysis for CSV: every output, input, component, budget row, covariance and cell of a
// histogram.
#include "core/project/stated_requirements.h"
#include "core/report/report.h"
#include "core/report/report_parts.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"

namespace covaria {
namespace {

using namespace report_parts;

std::string role_text(OutputRole role) {
    return role == OutputRole::measurand ? "measurand" : "intermediate";
}

std::string type_text(EvaluationType type) {
    return type == EvaluationType::type_a ? "A" : "B";
}

DataTable table_with(const std::string& id, const std::string& title, const std::vector<std::string>& heads) {
    DataTable table;
    table.id = id;
    table.title = title;
    for (const std::string& head : heads) table.columns.push_back({head, {}, false, 0});
    return table;
}

std::vector<TableCell> monte_carlo_cells(const OutputResult& output) {
    if (!output.monte_carlo) return std::vector<TableCell>(12);
    const Unit& unit = output.quantity.unit;
    const MonteCarloOutput& trials = *output.monte_carlo;
    return {value_in(unit, trials.mean),
            interval_in(unit, trials.standard_uncertainty),
            interval_in(unit, trials.standard_error_of_mean),
            interval_in(unit, trials.standard_error_of_uncertainty),
            value_in(unit, trials.symmetric.low),
            value_in(unit, trials.symmetric.high),
            value_in(unit, trials.shortest.low),
            value_in(unit, trials.shortest.high),
            trials.skewness,
            trials.kurtosis,
            trials.normality.coverage_ratio,
            trials.normality.words};
}

std::vector<TableCell> first_order_cells(const OutputResult& output) {
    const Unit& unit = output.quantity.unit;
    const FirstOrderOutput& first = output.first_order;
    std::vector<TableCell> cells = {value_in(unit, first.estimate),
                                    interval_in(unit, first.standard_uncertainty),
                                    first.effective_degrees_of_freedom, first.coverage_factor,
                                    interval_in(unit, first.expanded_uncertainty)};
    if (!first.validation) {
        cells.resize(cells.size() + 4);
    } else {
        for (const double d :
             {first.validation->tolerance, first.validation->d_low, first.validation->d_high})
            cells.emplace_back(interval_in(unit, d));
        cells.emplace_back(std::string(first.validation->validated ? "validated" : "not validated"));
    }
    for (const auto& of_second_order :
         {first.second_order_standard_uncertainty, first.second_order_estimate_shift})
        cells.push_back(of_second_order ? TableCell(interval_in(unit, *of_second_order)) : TableCell{});
    return cells;
}

DataTable results_table(const UncertaintyResult& result) {
    DataTable table = table_with("results", "Results",
                                 {"group",
                                  "symbol",
                                  "name",
                                  "role",
                                  "unit",
                                  "estimate",
                                  "u",
                                  "k",
                                  "U",
                                  "coverage probability",
                                  "mean",
                                  "u Monte Carlo",
                                  "standard error of mean",
                                  "standard error of u",
                                  "interval low",
                                  "interval high",
                                  "shortest low",
                                  "shortest high",
                                  "skewness",
                                  "excess kurtosis",
                                  "coverage ratio",
                                  "distribution",
                                  "estimate first order",
                                  "u first order",
                                  "nu_eff",
                                  "k first order",
                                  "U first order",
                                  "delta",
                                  "d_low",
                                  "d_high",
                                  "clause 8",
                                  "u second order",
                                  "shift second order",
                                  "U by",
                                  "remark"});
    for (const OutputResult& output : result.outputs) {
        const OutputQuantity& q = output.quantity;
        std::vector<TableCell> row = {q.group,
                                      q.symbol,
                                      q.name,
                                      role_text(q.role),
                                      q.unit.text(),
                                      value_in(q.unit, output.estimate),
                                      interval_in(q.unit, output.standard_uncertainty),
                                      output.coverage_factor,
                                      interval_in(q.unit, output.expanded_uncertainty),
                                      result.coverage_probability};
        for (auto& cell : monte_carlo_cells(output)) row.push_back(std::move(cell));
        for (auto& cell : first_order_cells(output)) row.push_back(std::move(cell));
        row.emplace_back(expanded_key(result));
        row.emplace_back(std::string(represents_measurand(result) ? "" : does_not_represent));
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string comma_list(const std::vector<std::string>& symbols) {
    std::string text;
    for (const std::string& symbol : symbols) text += (text.empty() ? "" : ", ") + symbol;
    return text;
}

DataTable budget_table(const UncertaintyResult& result) {
    DataTable table = table_with("budget", "Uncertainty budgets",
                                 {"group", "output", "output unit", "quantity", "component", "id", "unit",
                                  "u", "distribution", "type", "degrees of freedom", "sensitivity",
                                  "contribution", "share of variance", "one at a time", "held", "origin"});
    for (std::size_t i = 0; i < result.budget.rows.size() && i < result.outputs.size(); ++i) {
        const OutputQuantity& q = result.outputs[i].quantity;
        for (const BudgetRow& row : result.budget.rows[i]) {
            const BudgetComponent& c = result.budget.components[row.component];
            TableCell alone;
            if (row.one_at_a_time) alone = interval_in(q.unit, *row.one_at_a_time);
            table.rows.push_back({q.group, q.symbol, q.unit.text(), comma_list(c.quantities), c.name, c.id,
                                  c.unit.text(), interval_in(c.unit, c.standard_uncertainty), c.distribution,
                                  type_text(c.type), c.degrees_of_freedom,
                                  q.unit.interval_from_si(row.sensitivity * c.unit.interval_to_si(1.0)),
                                  interval_in(q.unit, row.contribution), row.share, alone,
                                  std::string(c.held ? "yes" : "no"), c.origin});
        }
    }
    return table;
}

DataTable inputs_table(const InputSet& inputs) {
    DataTable table = table_with(
        "inputs", "Input quantities and their components",
        {"group", "symbol", "name", "unit", "estimate", "u", "component", "id", "factor", "component unit",
         "component u", "distribution", "type", "degrees of freedom", "held", "origin"});
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
        const InputQuantity& q = inputs.quantities[i];
        const std::vector<TableCell> head = {q.group,
                                             q.symbol,
                                             q.name,
                                             q.unit.text(),
                                             value_in(q.unit, estimate_of(inputs, i)),
                                             interval_in(q.unit, standard_uncertainty_of(inputs, i))};
        if (q.shares.empty()) table.rows.push_back(head);
        for (const Share& share : q.shares) {
            const UncertaintyComponent& c = inputs.components[share.component];
            std::vector<TableCell> row = head;
            row.insert(row.end(), {TableCell(c.name), c.id,
                                   q.unit.interval_from_si(share.factor * c.unit.interval_to_si(1.0)),
                                   c.unit.text(), interval_in(c.unit, c.distribution.standard_uncertainty()),
                                   std::string(drawn_distribution(c).title()), type_text(c.type),
                                   c.degrees_of_freedom, std::string(c.held ? "yes" : "no"), c.origin});
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

std::string plain_label(const OutputQuantity& q) {
    return q.group.empty() ? q.symbol : q.symbol + " (" + q.group + ")";
}

/// `in_units`: entries in the product of the units of their row and column; else pure numbers.
DataTable matrix_table(const UncertaintyResult& result, const Eigen::MatrixXd& matrix, const std::string& id,
                       bool in_units) {
    DataTable table = table_with(id, id, {"output", "unit"});
    for (const OutputResult& output : result.outputs) {
        const std::string unit = in_units ? " × " + output.quantity.unit.text() : "";
        table.columns.push_back({plain_label(output.quantity) + unit, {}, false, 0});
    }
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        const OutputQuantity& q = result.outputs[static_cast<std::size_t>(i)].quantity;
        std::vector<TableCell> row = {plain_label(q), in_units ? q.unit.text() : "1"};
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
            const Unit& other = result.outputs[static_cast<std::size_t>(j)].quantity.unit;
            row.emplace_back(in_units ? other.interval_from_si(q.unit.interval_from_si(matrix(i, j)))
                                      : matrix(i, j));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

DataTable regions_table(const UncertaintyResult& result) {
    DataTable table = table_with(
        "regions", "Joint coverage regions",
        {"group", "outputs", "coverage probability", "ellipsoid first order", "rectangle first order",
         "ellipsoid Monte Carlo", "rectangle Monte Carlo", "trials", "singular"});
    const auto cell = [](const std::optional<double>& value) {
        return value ? TableCell(*value) : TableCell{};
    };
    for (const CoverageRegion& region : result.regions) {
        std::string outputs;
        for (const std::size_t i : region.outputs)
            outputs += (outputs.empty() ? "" : " ") + result.outputs[i].quantity.symbol;
        table.rows.push_back({region.group, outputs, result.coverage_probability,
                              region.ellipsoid_first_order, region.rectangle_first_order,
                              cell(region.ellipsoid_monte_carlo), cell(region.rectangle_monte_carlo),
                              static_cast<double>(region.trials),
                              std::string(region.singular ? "yes" : "no")});
    }
    return table;
}

DataTable convergence_table(const UncertaintyResult& result) {
    DataTable table = table_with("convergence", "Running mean and standard uncertainty",
                                 {"trials", "group", "symbol", "unit", "mean", "u"});
    for (const ConvergencePoint& point : result.convergence)
        for (std::size_t i = 0; i < result.outputs.size(); ++i) {
            const OutputQuantity& q = result.outputs[i].quantity;
            table.rows.push_back({static_cast<double>(point.trials), q.group, q.symbol, q.unit.text(),
                                  value_in(q.unit, point.mean[i]),
                                  interval_in(q.unit, point.standard_uncertainty[i])});
        }
    return table;
}

DataTable histograms_table(const UncertaintyResult& result) {
    DataTable table = table_with("histograms", "Histograms",
                                 {"group", "symbol", "unit", "cell low", "cell high", "trials"});
    for (const OutputResult& output : result.outputs) {
        if (!output.monte_carlo) continue;
        const OutputQuantity& q = output.quantity;
        const Histogram& h = output.monte_carlo->histogram;
        const double width = (h.high - h.low) / static_cast<double>(h.counts.size());
        const auto add = [&](const TableCell& low, const TableCell& high, std::uint64_t trials) {
            table.rows.push_back({q.group, q.symbol, q.unit.text(), low, high, static_cast<double>(trials)});
        };
        if (h.below > 0) add(TableCell{}, value_in(q.unit, h.low), h.below);
        for (std::size_t i = 0; i < h.counts.size(); ++i)
            add(value_in(q.unit, h.low + width * static_cast<double>(i)),
                value_in(q.unit, h.low + width * static_cast<double>(i + 1)), h.counts[i]);
        if (h.above > 0) add(value_in(q.unit, h.high), TableCell{}, h.above);
    }
    return table;
}

/// One row for an output and a contributor.
DataTable contributors_table(const UncertaintyResult& result) {
    DataTable table = table_with("contributors", "Standard uncertainties with contributors held, and alone",
                                 {"group", "symbol", "unit", "contributor", "u_held_first_order",
                                  "u_alone_first_order", "u_held_monte_carlo", "u_alone_monte_carlo"});
    for (const ContributorResult& c : result.contributors)
        for (std::size_t j = 0; j < result.outputs.size(); ++j) {
            const OutputQuantity& q = result.outputs[j].quantity;
            const auto cell = [&](const std::vector<double>& u) {
                return u.empty() ? TableCell{} : TableCell(interval_in(q.unit, u[j]));
            };
            table.rows.push_back({q.group, q.symbol, q.unit.text(), contributor_title(c),
                                  cell(c.without.first_order), cell(c.alone.first_order),
                                  cell(c.without.monte_carlo), cell(c.alone.monte_carlo)});
        }
    return table;
}

DataTable sobol_table(const UncertaintyResult& result) {
    DataTable table = table_with(
        "sobol", "Sobol indices",
        {"group", "symbol", "component", "first", "first_standard_error", "total", "total_standard_error"});
    for (std::size_t j = 0; j < result.sobol.size(); ++j)
        for (const SobolIndex& s : result.sobol[j])
            table.rows.push_back({result.outputs[j].quantity.group, result.outputs[j].quantity.symbol, s.name,
                                  s.first, s.first_standard_error, s.total, s.total_standard_error});
    return table;
}

DataTable requirements_table(const UncertaintyResult& result,
                             const std::vector<RequirementResult>& verdicts) {
    DataTable table = table_with(
        "requirements", "Requirements",
        {"group", "symbol", "unit", "U", "target", "target_met", "lower_limit", "upper_limit", "guard_band",
         "decision", "p_conforming", "p_conforming_by", "global_consumer_risk", "global_producer_risk"});
    for (const RequirementResult& r : verdicts) {
        const OutputResult& output = result.outputs[r.output];
        const OutputQuantity& q = output.quantity;
        const bool limited = r.lower_limit || r.upper_limit;
        const auto value = [&](const std::optional<double>& si) {
            return si ? TableCell(value_in(q.unit, *si)) : TableCell{};
        };
        const auto number = [](bool known, double x) { return known ? TableCell(x) : TableCell{}; };
        table.rows.push_back(
            {q.group, q.symbol, q.unit.text(), interval_in(q.unit, output.expanded_uncertainty),
             r.target_uncertainty ? TableCell(interval_in(q.unit, *r.target_uncertainty)) : TableCell{},
             r.target_uncertainty ? TableCell(std::string(r.meets_target ? "yes" : "no")) : TableCell{},
             value(r.lower_limit), value(r.upper_limit),
             limited ? TableCell(interval_in(q.unit, r.guard_band)) : TableCell{},
             limited ? TableCell(std::string(r.decision == RequirementResult::Decision::accept ? "accept"
                                                                                               : "reject"))
                     : TableCell{},
             number(limited, r.conformance),
             limited ? TableCell(distribution_key(r.conformance_by)) : TableCell{},
             number(r.global_risks.has_value(), r.global_risks ? r.global_risks->consumer : 0.0),
             number(r.global_risks.has_value(), r.global_risks ? r.global_risks->producer : 0.0)});
    }
    return table;
}

}  // namespace

std::vector<DataTable> result_tables(const Project& project, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    std::vector<DataTable> tables = {
        results_table(result),
        budget_table(result),
        matrix_table(result, result.covariance, "covariance", true),
        matrix_table(result, correlation_of(result.covariance), "correlation", false),
        inputs_table(result.inputs),
        regions_table(result)};
    if (result.trials > 0) {
        tables.push_back(histograms_table(result));
        tables.push_back(convergence_table(result));
    }
    if (!result.sobol.empty()) tables.push_back(sobol_table(result));
    const AnalysisEntry* entry = evaluated.analysis ? project.find_analysis(evaluated.analysis->id) : nullptr;
    if (entry && !entry->requirements.empty())
        tables.push_back(requirements_table(result, judge(result, *entry)));
    if (!result.contributors.empty()) tables.push_back(contributors_table(result));
    if (evaluated.analysis && evaluated.analysis->model)
        for (DataTable& table : evaluated.analysis->model->evaluation()) tables.push_back(std::move(table));
    for (const auto& study : evaluated.studies) tables.push_back(study_table(*study));
    return tables;
}

std::vector<DataTable> asset_tables(const AssetLibrary& assets) {
    std::vector<DataTable> tables;
    for (const auto& [id, entry] : assets.entries()) {
        if (!entry.asset) continue;
        for (DataTable& table : entry.asset->evaluation()) {
            table.id = id + "-" + table.id;
            tables.push_back(std::move(table));
        }
    }
    return tables;
}

}  // namespace covaria
