// The tables of one analysis for CSV: every output, input, component, budget row, covariance and cell of a
// histogram.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include "core/project/stated_requirements.h"
#include "core/result/result_line.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "core/views/result_columns.h"
#include "core/views/result_words.h"
#include "core/views/seen_table.h"

namespace covaria {
namespace {

using namespace result_words;

Table table_with(const std::string& id, const std::string& title, const std::vector<std::string>& heads) {
    Table table{id, title};
    for (const std::string& head : heads) table.add(head);
    return table;
}

Quantity stated_value(const Unit& unit, double si) {
    return value_in(unit, si).in({});
}

Quantity stated_interval(const Unit& unit, double si) {
    return interval_in(unit, si).in({});
}

std::size_t outputs_with_budget(const UncertaintyResult& result) {
    return std::min(result.budget.rows.size(), result.outputs.size());
}

Table budget_at(const UncertaintyResult& result, std::vector<BudgetPlace> places) {
    Table table = budget_table(result, std::move(places));
    for (Column& column : table.columns) column.unit.reset();  // the rows say it
    return table;
}

/// The most lines that a file of budgets has, but for the least number of an output's: one with every reading
/// of a network in the budget of each coordinate would take a hundred megabytes, hardly a line of which
/// matters.
constexpr std::size_t most_lines = 50'000, least_of_output = 10;

/// The number of components that the file has of each output.
std::size_t components_in_file(const UncertaintyResult& result) {
    std::size_t lines = 0;
    for (const std::vector<BudgetRow>& rows : result.budget.rows) lines += rows.size();
    return lines <= most_lines ? lines : std::max(least_of_output, most_lines / result.budget.rows.size());
}

/// The sum of the components of an output that are not among the places, as a row of `table`.
void add_rest(const UncertaintyResult& result, std::size_t output, const std::vector<BudgetPlace>& places,
              Table& table) {
    const std::vector<BudgetRow>& rows = result.budget.rows[output];
    std::vector<char> written(rows.size(), 0);
    for (const BudgetPlace& place : places) written[place.row] = 1;
    double share = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!written[i]) share += rows[i].share;
    const OutputResult& of = result.outputs[output];
    const double contribution = of.first_order.standard_uncertainty * std::sqrt(std::max(0.0, share));
    std::vector<Cell> cells;
    for (const Column& column : table.columns)
        cells.push_back(column.key == "group"         ? Cell(of.quantity.group)
                        : column.key == "output"      ? Cell(Symbols{of.quantity.symbol})
                        : column.key == "output unit" ? Cell(of.quantity.unit)
                        : column.key == "component"   ? Cell(std::to_string(rows.size() - places.size()) +
                                                             " smaller components together")
                        : column.key == "contribution"
                            ? Cell(Measured{contribution, Measured::Scale::interval, of.quantity.unit, {}})
                        : column.key == "share of variance" ? Cell(Measured{share})
                                                            : Cell());
    table.row(std::move(cells));
}

/// The budget of an output as the file has it: the components with the largest shares, in their order, and
/// the others in one row.
Table budget_of(const UncertaintyResult& result, std::size_t output, std::size_t most) {
    std::vector<BudgetPlace> places = budget_places(result, output);
    if (places.size() <= most + 1) return budget_at(result, std::move(places));
    const auto size = [&](const BudgetPlace& place) {
        return std::abs(result.budget.rows[place.output][place.row].share);
    };
    std::ranges::stable_sort(places, std::greater(), size);
    places.resize(most);
    std::ranges::sort(places, {}, &BudgetPlace::row);
    Table table = file_table(budget_at(result, places));
    add_rest(result, output, places, table);
    return table;
}

Table budget_file(const UncertaintyResult& result) {
    const std::size_t most = components_in_file(result);
    Table all = file_table(budget_at(result, {}));
    for (std::size_t i = 0; i < outputs_with_budget(result); ++i) {
        const Table one = file_table(budget_of(result, i, most));
        for (std::size_t row = 0; row < one.rows; ++row) {
            std::vector<Cell> cells;
            for (const Column& column : one.columns) cells.push_back(column.cell(row));
            all.row(std::move(cells));
        }
    }
    return all;
}

/// The same as a file, output by output: of hundreds of points all cells together take some gigabytes.
std::string budget_csv(const UncertaintyResult& result) {
    const std::string line_end = "\r\n";
    const std::size_t most = components_in_file(result);
    std::string csv = to_csv(budget_at(result, {}));
    for (std::size_t i = 0; i < outputs_with_budget(result); ++i) {
        const std::string one = to_csv(budget_of(result, i, most));
        csv += one.substr(one.find(line_end) + line_end.size());
    }
    return csv;
}

Table links_table(const std::vector<LinkedInput>& linked) {
    Table table = table_with("links", "Input quantities taken from other analyses",
                             {"symbol", "name", "unit", "estimate", "u", "degrees of freedom", "analysis",
                              "output group", "output", "linearised"});
    for (const LinkedInput& input : linked)
        table.row({input.symbol, input.name.english(), input.unit.text(),
                   stated_value(input.unit, input.estimate),
                   stated_interval(input.unit, input.standard_uncertainty), input.degrees_of_freedom,
                   input.analysis, input.output.group, input.output.symbol,
                   std::string(input.linearised ? "yes" : "no")});
    return table;
}

/// Shares of the variance by the analyses of a chain.
Table analyses_table(const UncertaintyResult& result) {
    Table table =
        table_with("by-analysis", "Shares of the variance by analysis",
                   {"group", "output", "output unit", "analysis", "contribution", "share of variance"});
    for (std::size_t j = 0; j < result.outputs.size(); ++j) {
        const OutputQuantity& q = result.outputs[j].quantity;
        for (const GroupContribution& g : contributions_by_group(result.budget, j, "analysis"))
            table.row({q.group, q.symbol, q.unit.text(), g.group, stated_interval(q.unit, g.contribution),
                       g.share});
    }
    return table;
}

std::string plain_label(const OutputQuantity& q) {
    return q.group.empty() ? q.symbol : q.symbol + " (" + q.group + ")";
}

/// `in_units`: entries in the product of the units of their row and column; else pure numbers.
Table matrix_table(const UncertaintyResult& result, Eigen::MatrixXd matrix, const std::string& id,
                   bool in_units) {
    const auto held = std::make_shared<const Eigen::MatrixXd>(std::move(matrix));
    Table table{id, id, result.outputs.size()};
    const auto quantity = [&result](std::size_t i) -> const OutputQuantity& {
        return result.outputs[i].quantity;
    };
    table.add("output", [=](std::size_t i) -> Cell { return plain_label(quantity(i)); });
    table.add("unit",
              [=](std::size_t i) -> Cell { return in_units ? quantity(i).unit.text() : std::string("1"); });
    for (std::size_t j = 0; j < table.rows; ++j)
        table.add(plain_label(quantity(j)) + (in_units ? " × " + quantity(j).unit.text() : ""),
                  [=](std::size_t i) -> Cell {
                      const double entry =
                          (*held)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
                      if (!in_units) return entry;
                      return quantity(j).unit.interval_from_si(quantity(i).unit.interval_from_si(entry));
                  });
    return table;
}

/// Pairs of thousands of outputs: those of a group, and of a point its three coordinates.
Table pairs_table(const UncertaintyResult& result) {
    Table table = table_with("covariance", "covariance",
                             {"group", "output", "other output", "unit", "other unit",
                              "covariance in the "
                              "product of the units",
                              "correlation"});
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t j = 0; j < result.outputs.size(); ++j)
        groups[result.outputs[j].quantity.group].push_back(j);
    const auto u = [&](std::size_t j) { return result.outputs[j].standard_uncertainty; };
    for (const auto& [group, members] : groups)
        for (std::size_t k = 1; k < members.size(); ++k)
            for (std::size_t i = 0; i < k; ++i) {
                const OutputQuantity &a = result.outputs[members[i]].quantity,
                                     &b = result.outputs[members[k]].quantity;
                const double covariance = result.covariance(static_cast<Eigen::Index>(members[i]),
                                                            static_cast<Eigen::Index>(members[k]));
                const double product = u(members[i]) * u(members[k]);
                if (!std::isfinite(product)) continue;
                table.row({group, a.symbol, b.symbol, a.unit.text(), b.unit.text(),
                           a.unit.interval_from_si(b.unit.interval_from_si(covariance)),
                           product > 0.0 ? covariance / product : 0.0});
            }
    return table;
}

Table convergence_table(const UncertaintyResult& result) {
    Table table = table_with("convergence", "Running mean and standard uncertainty",
                             {"trials", "group", "symbol", "unit", "mean", "u"});
    for (const ConvergencePoint& point : result.convergence)
        for (std::size_t i = 0; i < result.outputs.size(); ++i) {
            const OutputQuantity& q = result.outputs[i].quantity;
            const double of_all = result.outputs[i].standard_uncertainty;  // infinite however it runs
            table.row({static_cast<double>(point.trials), q.group, q.symbol, q.unit.text(),
                       stated_value(q.unit, point.mean[i]),
                       stated_interval(q.unit, std::isinf(of_all) ? of_all : point.standard_uncertainty[i])});
        }
    return table;
}

Table histograms_table(const UncertaintyResult& result) {
    Table table = table_with("histograms", "Histograms",
                             {"group", "symbol", "unit", "cell low", "cell high", "trials"});
    for (const OutputResult& output : result.outputs) {
        if (!output.monte_carlo) continue;
        const OutputQuantity& q = output.quantity;
        const Histogram& h = output.monte_carlo->histogram;
        const double width = (h.high - h.low) / static_cast<double>(h.counts.size());
        const auto add = [&](const Cell& from, const Cell& to, std::uint64_t trials) {
            table.row({q.group, q.symbol, q.unit.text(), from, to, static_cast<double>(trials)});
        };
        if (h.below > 0) add(Cell{}, stated_value(q.unit, h.low), h.below);
        for (std::size_t i = 0; i < h.counts.size(); ++i)
            add(stated_value(q.unit, h.low + width * static_cast<double>(i)),
                stated_value(q.unit, h.low + width * static_cast<double>(i + 1)), h.counts[i]);
        if (h.above > 0) add(stated_value(q.unit, h.high), Cell{}, h.above);
    }
    return table;
}

/// Rows for each output and contributor.
Table contributors_table(const UncertaintyResult& result) {
    Table table =
        table_with("contributors", "Standard uncertainties without each contributor, and of it alone",
                   {"group", "symbol", "unit", "contributor", "u_held_first_order", "u_alone_first_order",
                    "u_held_monte_carlo", "u_alone_monte_carlo"});
    for (const ContributorResult& c : result.contributors)
        for (std::size_t j = 0; j < result.outputs.size(); ++j) {
            const OutputQuantity& q = result.outputs[j].quantity;
            const auto cell = [&](const std::vector<double>& u) {
                return u.empty() ? Cell{} : Cell(stated_interval(q.unit, u[j]));
            };
            table.row({q.group, q.symbol, q.unit.text(), contributor_title(c).english(),
                       cell(c.without.first_order), cell(c.alone.first_order), cell(c.without.monte_carlo),
                       cell(c.alone.monte_carlo)});
        }
    return table;
}

Table sobol_table(const UncertaintyResult& result) {
    Table table = table_with(
        "sobol", "Sobol indices",
        {"group", "symbol", "component", "first", "first_standard_error", "total", "total_standard_error"});
    for (std::size_t j = 0; j < result.sobol.size(); ++j)
        for (const SobolIndex& s : result.sobol[j])
            table.row({result.outputs[j].quantity.group, result.outputs[j].quantity.symbol, s.name, s.first,
                       s.first_standard_error, s.total, s.total_standard_error});
    return table;
}

std::string decision_key(const RequirementResult& r) {
    if (!r.not_judged.empty()) return "not judged";
    return r.decision == RequirementResult::Decision::accept ? "accept" : "reject";
}

Table requirements_table(const UncertaintyResult& result, const std::vector<RequirementResult>& verdicts) {
    Table table =
        table_with("requirements", "Requirements",
                   {"group", "symbol", "unit", "U", "target", "target_met", "lower_limit", "upper_limit",
                    "guard_band", "decision", "p_conforming", "p_conforming_by", "global_consumer_risk",
                    "global_producer_risk", "consumer_risk_if_accepted", "producer_risk_if_rejected"});
    for (const RequirementResult& r : verdicts) {
        const OutputResult& output = result.outputs[r.output];
        const OutputQuantity& q = output.quantity;
        const bool judged = r.not_judged.empty(), with_limits = r.lower_limit || r.upper_limit;
        const bool limited = with_limits && judged;
        const auto value = [&](const std::optional<double>& si) {
            return si ? Cell(stated_value(q.unit, *si)) : Cell{};
        };
        const auto number = [](bool known, double x) { return known ? Cell(x) : Cell{}; };
        const auto of_prior = [&](double RequirementResult::GlobalRisks::*risk) {
            return r.global_risks ? Cell((*r.global_risks).*risk) : Cell{};
        };
        table.row({q.group, q.symbol, q.unit.text(), stated_interval(q.unit, output.expanded_uncertainty),
                   r.target_uncertainty ? Cell(stated_interval(q.unit, *r.target_uncertainty)) : Cell{},
                   r.target_uncertainty ? Cell(std::string(!judged          ? "not judged"
                                                           : r.meets_target ? "yes"
                                                                            : "no"))
                                        : Cell{},
                   value(r.lower_limit), value(r.upper_limit),
                   limited ? Cell(stated_interval(q.unit, r.guard_band)) : Cell{},
                   with_limits ? Cell(decision_key(r)) : Cell{}, number(limited, r.conformance),
                   limited ? Cell(distribution_key(r.conformance_by)) : Cell{},
                   of_prior(&RequirementResult::GlobalRisks::consumer),
                   of_prior(&RequirementResult::GlobalRisks::producer),
                   of_prior(&RequirementResult::GlobalRisks::consumer_if_accepted),
                   of_prior(&RequirementResult::GlobalRisks::producer_if_rejected)});
    }
    return table;
}

}  // namespace

namespace {

/// Calls `take` for all tables but results and budget.
void each_further_table(const Project& project, const EvaluatedAnalysis& evaluated,
                        const std::function<void(const Table&)>& take) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.covariance.is_whole()) {
        take(matrix_table(result, existing_covariance(result).whole(), "covariance", true));
        take(matrix_table(result, correlation_of(result.covariance.whole()), "correlation", false));
    } else {
        take(pairs_table(result));
    }
    take(inputs_table(result.inputs, all_shares(result.inputs)));
    take(regions_table(result));
    if (auto pairs = all_correlations(result.inputs); !pairs.empty())
        take(input_correlations_table(result.inputs, std::move(pairs)));
    if (result.trials > 0) {
        take(histograms_table(result));
        take(convergence_table(result));
    }
    if (!result.sobol.empty()) take(sobol_table(result));
    const AnalysisEntry* entry = evaluated.analysis ? project.find_analysis(evaluated.analysis->id) : nullptr;
    if (entry && !entry->requirements.empty()) take(requirements_table(result, judge(result, *entry)));
    if (!result.contributors.empty()) take(contributors_table(result));
    if (evaluated.analysis && !evaluated.analysis->linked.empty()) {
        take(links_table(evaluated.analysis->linked));
        take(analyses_table(result));
    }
    if (evaluated.analysis && evaluated.analysis->model) {
        for (const Table& table : evaluated.analysis->model->evaluation()) take(table);
        if (const auto redundant = evaluated.analysis->model->redundant_readings())
            take(seen_table(*redundant, evidence::seen_of(*redundant)));
    }
    for (const auto& study : evaluated.studies) take(study_table(*study));
}

}  // namespace

std::vector<Table> result_tables(const Project& project, const EvaluatedAnalysis& evaluated) {
    std::vector<Table> tables{file_table(results_table(*evaluated.result)),
                              file_table(budget_file(*evaluated.result))};
    each_further_table(project, evaluated, [&](const Table& table) { tables.push_back(file_table(table)); });
    return tables;
}

void each_result_file(const Project& project, const EvaluatedAnalysis& evaluated,
                      const std::function<void(const std::string&, const std::string&)>& take) {
    const auto take_table = [&](const Table& table) { take(table.id, to_csv(table)); };
    take_table(results_table(*evaluated.result));
    take("budget", budget_csv(*evaluated.result));
    each_further_table(project, evaluated, take_table);
}

std::vector<Table> asset_tables(const AssetLibrary& assets) {
    std::vector<Table> tables;
    for (const auto& [id, entry] : assets.entries()) {
        if (!entry.asset) continue;
        for (Table& table : entry.asset->evaluation()) {
            table.id = id + "-" + table.id;
            tables.push_back(std::move(table));
        }
    }
    return tables;
}

}  // namespace covaria
