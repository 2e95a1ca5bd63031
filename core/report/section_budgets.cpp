// Uncertainty budgets: for each measurand of the groups shown in full, one row per component.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "core/report/plots.h"
#include "core/report/report_parts.h"
#include "core/report/table_text.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t most_budget_rows = 24;  // further components are summed; the CSV budget has them

std::string component_text(const BudgetComponent& component) {
    return component.held ? component.name + " (held)" : component.name;
}

/// c in the output's unit per unit of the component.
double shown_sensitivity(const BudgetRow& row, const Unit& component, const Unit& output) {
    return output.interval_from_si(row.sensitivity * component.interval_to_si(1.0));
}

/// Without components whose contribution is only rounding of a sensitivity coefficient of zero.
std::vector<BudgetRow> rows_that_count(std::vector<BudgetRow> rows, double combined) {
    std::erase_if(rows, [combined](const BudgetRow& row) {
        return row.contribution < 1e-9 * combined &&
               !(row.one_at_a_time && *row.one_at_a_time > 1e-9 * combined);
    });
    return rows;
}

class BudgetTable {
public:
    BudgetTable(const EvaluatedAnalysis& evaluated, std::size_t output)
        : result_(*evaluated.result),
          output_(result_.outputs[output]),
          rows_(rows_that_count(result_.budget.rows[output], output_.first_order.standard_uncertainty)),
          table_("budget-" + evaluated.analysis->id + "-" +
                     file_name_part(output_.quantity.symbol + " " + output_.quantity.group),
                 "Budget of " + output_label(output_.quantity) + ", " + output_.quantity.name) {
        one_at_a_time_ = !rows_.empty() && rows_.front().one_at_a_time.has_value();
    }

    TableBlock make() {
        const std::string unit = unit_text(output_.quantity.unit);
        table_.text("Symbol", true);
        table_.text("Component");
        table_.text("Unit");
        table_.estimate("x_i", true, 4);
        table_.symbol("u(x_i)", 3);
        table_.text("Distribution");
        table_.text("Type");
        table_.symbol("nu_i");
        table_.symbol("c_i", 3);
        table_.number("|cᵢ|·u(xᵢ) in " + unit, 2);
        if (one_at_a_time_) table_.number("alone, Monte Carlo, in " + unit, 2);
        table_.fixed("Share of variance in %", 1);
        const std::size_t shown = std::min(rows_.size(), most_budget_rows);
        for (std::size_t i = 0; i < shown; ++i) add(rows_[i]);
        if (shown < rows_.size()) add_rest(shown);
        add_total();
        table_.note(result_line());
        return table_.take();
    }

private:
    void push(std::vector<TableCell> cells, const TableCell& alone, double share) {
        if (one_at_a_time_) cells.push_back(alone);
        cells.emplace_back(100.0 * share);
        table_.row(std::move(cells));
    }

    /// In the component's unit, or with that of its quantity: -49.28° where u is in seconds of arc.
    static TableCell estimate_cell(const BudgetComponent& c) {
        const Unit& unit = c.quantity_unit;
        if (unit == c.unit || !(unit.dimension() == c.unit.dimension())) return value_in(c.unit, c.estimate);
        const std::string number = typeset_number(
            format_to_match(unit.from_si(c.estimate), unit.interval_from_si(c.standard_uncertainty)));
        return number + (unit == Unit::of("deg") ? "" : "\u00a0") + unit.display();
    }

    void add(const BudgetRow& row) {
        const BudgetComponent& c = result_.budget.components[row.component];
        const Unit& unit = output_.quantity.unit;
        TableCell alone;
        if (row.one_at_a_time) alone = interval_in(unit, *row.one_at_a_time);
        // The estimate of a component that several quantities share would be that of one of them.
        const bool shared = c.quantities.size() > 1;
        push({short_list(c.quantities), component_text(c), unit_text(c.unit),
              shared ? TableCell{} : estimate_cell(c), interval_in(c.unit, c.standard_uncertainty),
              c.distribution, std::string(c.type == EvaluationType::type_a ? "A" : "B"),
              shown_degrees_of_freedom(c.degrees_of_freedom), shown_sensitivity(row, c.unit, unit),
              interval_in(unit, row.contribution)},
             alone, row.share);
    }

    void add_rest(std::size_t first) {
        double square = 0.0, share = 0.0;
        for (std::size_t i = first; i < rows_.size(); ++i) {
            square += rows_[i].contribution * rows_[i].contribution;
            share += rows_[i].share;
        }
        push({TableCell{}, std::to_string(rows_.size() - first) + " further components", TableCell{},
              TableCell{}, TableCell{}, TableCell{}, TableCell{}, TableCell{}, TableCell{},
              interval_in(output_.quantity.unit, std::sqrt(square))},
             TableCell{}, share);
    }

    void add_total() {
        const FirstOrderOutput& first = output_.first_order;
        const Unit& unit = output_.quantity.unit;
        double share = 0.0;
        for (const BudgetRow& row : rows_) share += row.share;
        push({std::string("u_c"), "combined (law of propagation)", unit_text(unit), TableCell{}, TableCell{},
              TableCell{}, TableCell{}, shown_degrees_of_freedom(first.effective_degrees_of_freedom),
              TableCell{}, interval_in(unit, first.standard_uncertainty)},
             TableCell{}, share);
    }

    /// y, u_c, nu_eff, k, U, p as EA-4/02 wants them stated, by the law of propagation.
    std::string result_line() const {
        const FirstOrderOutput& first = output_.first_order;
        const Unit& unit = output_.quantity.unit;
        const double U = unit.interval_from_si(first.expanded_uncertainty);
        const std::string symbol = unit == Unit{} ? "" : "\u00a0" + unit.display();
        std::string line =
            output_label(output_.quantity) + " = (" + format_to_match(unit.from_si(first.estimate), U) +
            " ± " + format_significant(U, 2) + ")" + symbol +
            ", u_c = " + format_significant(unit.interval_from_si(first.standard_uncertainty), 2) + symbol;
        line +=
            ", effective degrees of freedom " + format_degrees_of_freedom(first.effective_degrees_of_freedom);
        return line + ", k = " + format_decimals(first.coverage_factor, 2) +
               ", p = " + percent_text(result_.coverage_probability) + " (law of propagation).";
    }

    const UncertaintyResult& result_;
    const OutputResult& output_;
    std::vector<BudgetRow> rows_;
    TableBuilder table_;
    bool one_at_a_time_ = false;
};

/// Shares of the variance by the groups of one grouping, a column for each measurand of a group of outputs,
/// and of the sum of the variances where they have the same dimension.
class GroupTable {
public:
    GroupTable(const EvaluatedAnalysis& evaluated, std::string grouping, std::vector<std::size_t> outputs)
        : result_(*evaluated.result),
          grouping_(std::move(grouping)),
          outputs_(std::move(outputs)),
          table_("groups-" + evaluated.analysis->id + "-" +
                     file_name_part(grouping_ + " " + result_.outputs[outputs_.front()].quantity.group),
                 "Shares of the variance in % by " + grouping_ + ", " +
                     result_.outputs[outputs_.front()].quantity.group) {}

    TableBlock make() {
        collect();
        table_.text(grouping_, grouping_ == "parameter");
        for (const std::size_t j : outputs_) table_.fixed(output_label(result_.outputs[j].quantity), 1);
        if (alike_) table_.fixed("together", 1);
        std::stable_sort(names_.begin(), names_.end(), [&](const std::string& a, const std::string& b) {
            return together_[a] > together_[b];
        });
        for (std::size_t i = 0; i < std::min(names_.size(), most_budget_rows); ++i) add(names_[i]);
        return table_.take();
    }

private:
    void collect() {
        double sum = 0.0;
        for (const std::size_t j : outputs_) {
            const OutputResult& output = result_.outputs[j];
            alike_ = alike_ && output.quantity.unit.dimension() ==
                                   result_.outputs[outputs_.front()].quantity.unit.dimension();
            const double variance =
                output.first_order.standard_uncertainty * output.first_order.standard_uncertainty;
            sum += variance;
            for (const GroupContribution& g : contributions_by_group(result_.budget, j, grouping_)) {
                if (!together_.contains(g.group)) names_.push_back(g.group);
                shares_[{g.group, j}] = g.share;
                together_[g.group] += g.share * variance;
            }
        }
        alike_ = alike_ && outputs_.size() > 1 && sum > 0.0;
        for (auto& [name, share] : together_)
            if (sum > 0.0) share /= sum;
    }

    void add(const std::string& name) {
        std::vector<TableCell> cells{name};
        for (const std::size_t j : outputs_) cells.emplace_back(100.0 * shares_[{name, j}]);
        if (alike_) cells.emplace_back(100.0 * together_[name]);
        table_.row(std::move(cells));
    }

    const UncertaintyResult& result_;
    std::string grouping_;
    std::vector<std::size_t> outputs_;
    TableBuilder table_;
    std::vector<std::string> names_;
    std::map<std::string, double> together_;
    std::map<std::pair<std::string, std::size_t>, double> shares_;
    bool alike_ = true;
};

}  // namespace

void add_budgets(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    blocks.push_back(HeadingBlock{2, "Uncertainty budgets"});
    const std::vector<std::string> groups = measurand_groups(result);
    const std::vector<std::string> shown = groups_in_full(result);
    std::string words =
        "Components by falling share of the variance; cᵢ in the unit of the measurand per unit of the "
        "component.";
    if (shown.size() < groups.size())
        words += " Shown in full for " + shown.front() +
                 ", which has the largest expanded uncertainties of the " + std::to_string(groups.size()) +
                 " groups; the CSV table of budgets has every group.";
    blocks.push_back(ParagraphBlock{words});
    for (const std::string& group : shown) {
        for (const std::string& grouping : groupings_of(result.budget))
            blocks.push_back(GroupTable(evaluated, grouping, measurands_of(result, group)).make());
        for (const std::size_t output : measurands_of(result, group))
            blocks.push_back(BudgetTable(evaluated, output).make());
        for (const std::size_t output : measurands_of(result, group))
            blocks.push_back(figure(
                contribution_plot(result, output), evaluated,
                "Contributions to the variance of " + output_label(result.outputs[output].quantity) + "."));
    }
}

}  // namespace covaria::report_parts
