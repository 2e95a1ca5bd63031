// Uncertainty budgets: for each measurand of the groups shown in full, one row per component.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/name.h"
#include "core/report/report_parts.h"
#include "core/result/representation.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/views/plots.h"
#include "core/views/result_columns.h"
#include "core/views/result_statement.h"

namespace covaria::report_parts {
namespace {

class BudgetBlock {
public:
    BudgetBlock(const EvaluatedAnalysis& evaluated, std::size_t output, std::size_t most_rows,
                const DocumentLanguage& in)
        : in_(in),
          result_(*evaluated.result),
          most_rows_(most_rows),
          digits_(evaluated.analysis->style.digits.value_or(2)),
          output_(result_.outputs[output]),
          places_(places_that_count(result_, output)),
          table_("budget-" + evaluated.analysis->id + "-" +
                     id_part(output_.quantity.symbol + " " + output_.quantity.group),
                 title(), in) {
        if (!places_.empty() && row(0).one_at_a_time) keys_.insert(keys_.end() - 1, "one at a time");
    }

    TableBlock make() {
        const Table budget = budget_table(result_, places_, in_);
        table_.columns(budget, keys_);
        const std::size_t shown = std::min(places_.size(), most_rows_);
        for (std::size_t i = 0; i < shown; ++i) table_.row_of(budget, i);
        if (shown < places_.size()) add_rest(shown);
        add_total();
        add_note_on_zeros();
        table_.note(result_line());
        if (result_.trials > 0 && represents_measurand(result_)) table_.note(stated_line());
        return table_.take();
    }

private:
    const BudgetRow& row(std::size_t i) const {
        return result_.budget.rows[places_[i].output][places_[i].row];
    }

    Message title() const {
        const Message label = output_label(output_.quantity);
        const Message& name = output_.quantity.name;
        if (name.empty() || name == Message(output_.quantity.symbol)) return tell<"Budget of %1">(label);
        return tell<"Budget of %1, %2">(label, name);
    }

    /// The source of a component: its owner or, where one owner brings in all of them, the origin of its
    /// figure.
    std::string source_of(std::size_t i, bool by_owner) const {
        const BudgetComponent& component = result_.budget.components[row(i).component];
        return by_owner ? component.owner : in_.say(component.origin);
    }

    /// The components that are not shown as rows of their own, by their sources, the largest share first.
    struct Rest {
        std::string source;
        std::size_t components = 0, sources = 1;
        double square = 0.0, share = 0.0;
        void take(const Rest& other) {
            components += other.components;
            square += other.square;
            share += other.share;
        }
    };
    std::vector<Rest> rest_from(std::size_t first, bool by_owner) const {
        std::vector<Rest> all;
        std::map<std::string, std::size_t> known;
        for (std::size_t i = first; i < places_.size(); ++i) {
            const std::string source = source_of(i, by_owner);
            const auto [entry, fresh] = known.try_emplace(source, all.size());
            if (fresh) all.push_back({source});
            all[entry->second].take({source, 1, 1, row(i).contribution * row(i).contribution, row(i).share});
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const Rest& a, const Rest& b) { return a.share > b.share; });
        return all;
    }

    void add_rest(std::size_t first) {
        std::vector<Rest> rest = rest_from(first, true);
        const bool by_owner = rest.size() > 1;
        if (!by_owner) rest = rest_from(first, false);
        while (rest.size() > most_sources) {
            Rest& last = rest[rest.size() - 2];
            last.take(rest.back());
            last.sources += rest.back().sources;
            rest.pop_back();
        }
        for (const Rest& part : rest)
            table_.row_with({{"component in words", rest_words(part, rest.size() > 1, by_owner)},
                             {"contribution", interval_in(output_.quantity.unit, std::sqrt(part.square))},
                             {"share of variance", part.share}});
    }

    static Message rest_words(const Rest& rest, bool several, bool by_owner) {
        const std::size_t n = rest.components;
        if (rest.sources > 1) return tell<"%1 further components of %2 other sources">(n, rest.sources);
        const Message source = !rest.source.empty() ? Message(rest.source)
                               : by_owner           ? tell<"the set-up">()
                                                    : tell<"other sources">();
        if (!several && rest.source.empty())
            return n == 1 ? tell<"1 further component">() : tell<"%1 further components">(n);
        return n == 1 ? tell<"1 further component: %1">(source)
                      : tell<"%1 further components: %2">(n, source);
    }

    /// Adds a note on components without a row: their names, or their number.
    void add_note_on_zeros() {
        // What has no row of its own is in a rest, and nobody knows what contributes nothing.
        if (!result_.budget.components.empty() && result_.budget.components.back().is_rest) return;
        std::vector<bool> has_row(result_.budget.components.size(), false);
        for (std::size_t i = 0; i < places_.size(); ++i) has_row[row(i).component] = true;
        const auto zeros = static_cast<std::size_t>(std::count(has_row.begin(), has_row.end(), false));
        if (zeros == 0) return;
        if (zeros > most_named) {
            table_.note(
                tell<"Left out: %1 components that contribute nothing (less than 10⁻⁹ of u_c).">(zeros));
            return;
        }
        std::string list;
        for (std::size_t i = 0; i < has_row.size(); ++i)
            if (!has_row[i]) list += (list.empty() ? "" : "; ") + name_of(result_.budget.components[i]);
        table_.note(tell<"Left out, because they contribute nothing (less than 10⁻⁹ of u_c): %1.">(list));
    }

    /// The name of a component: "l_S, calibration".
    std::string name_of(const BudgetComponent& component) const {
        const std::string name = in_.say(component.name);
        return component.quantities.size() == 1
                   ? symbol_to_unicode(component.quantities.front()) + ", " + name
                   : name;
    }

    void add_total() {
        const FirstOrderOutput& first = output_.first_order;
        const Unit& unit = output_.quantity.unit;
        double share = 0.0;
        for (std::size_t i = 0; i < places_.size(); ++i) share += row(i).share;
        table_.row_with({{"quantity", Symbols{"u_c"}},
                         {"component in words", tell<"combined (law of propagation)">()},
                         {"unit", unit},
                         {"degrees of freedom", first.effective_degrees_of_freedom},
                         {"contribution", interval_in(unit, first.standard_uncertainty)},
                         {"share of variance", share}});
    }

    /// The result line y, u_c, nu_eff, k, U, p as EA-4/02 wants it stated, by the law of propagation.
    Message result_line() const {
        const FirstOrderOutput& first = output_.first_order;
        const Unit& unit = output_.quantity.unit;
        const auto number = [this](const std::string& plain) { return grouped_digits(plain, in_.numbers()); };
        const double u = unit.interval_from_si(first.standard_uncertainty);
        const double largest = std::max(u, std::abs(unit.from_si(first.estimate)));
        const std::string u_text = u > 0.0 && std::isfinite(u)
                                       ? format_in_row(u, decimals_for(u, digits_), largest)
                                       : format_significant(u, digits_);
        const std::string value =
            value_statement(first.estimate, first.expanded_uncertainty, unit, digits_, true, in_);
        return tell<
            "%1 = %2, u_c = %3, effective degrees of freedom %4, k = %5, p = %6 (law of propagation).">(
            output_label(output_.quantity), value, number(u_text) + unit_after_number(unit),
            number(format_degrees_of_freedom(first.effective_degrees_of_freedom)),
            number(format_decimals(first.coverage_factor, 2)),
            probability_text(stated_probability(first, result_), in_));
    }

    /// The line of the result that is stated, where it is not that of the line above.
    Message stated_line() const {
        return tell<"Stated in the results: %1 = %2 (propagation of distributions).">(
            output_label(output_.quantity), result_statement(output_, result_, in_, {}, digits_));
    }

    const DocumentLanguage& in_;
    const UncertaintyResult& result_;
    static constexpr std::size_t most_sources = 5;  // sources of further components
    static constexpr std::size_t most_named = 6;    // components of zero

    const std::size_t most_rows_;
    const int digits_;  ///< digits of uncertainties
    const OutputResult& output_;
    std::vector<BudgetPlace> places_;
    std::vector<std::string> keys_ = {"quantity",
                                      "component in words",
                                      "unit",
                                      "estimate",
                                      "u",
                                      "distribution",
                                      "type",
                                      "degrees of freedom",
                                      "sensitivity",
                                      "contribution",
                                      "share of variance"};
    TableBuilder table_;
};

/// Shares of the variance by the groups of one grouping, with a column for each measurand of a group of
/// outputs, and one of the sum of the variances where they have the same dimension.
class GroupTable {
public:
    GroupTable(const EvaluatedAnalysis& evaluated, std::string grouping, std::vector<std::size_t> outputs,
               std::size_t most_rows, const DocumentLanguage& in)
        : in_(in),
          result_(*evaluated.result),
          most_rows_(most_rows),
          grouping_(std::move(grouping)),
          outputs_(std::move(outputs)),
          table_(
              "groups-" + evaluated.analysis->id + "-" +
                  id_part(grouping_ + " " + result_.outputs[outputs_.front()].quantity.group),
              tell<"Shares of the variance in % by %1, %2">(
                  Message::declared(grouping_), said_name(result_.outputs[outputs_.front()].quantity.group)),
              in) {}

    TableBlock make() {
        collect();
        table_.text(Message::declared(grouping_), grouping_ == "parameter");
        for (const std::size_t j : outputs_) table_.fixed(output_label(result_.outputs[j].quantity), 1);
        if (alike_) table_.fixed(tell<"together">(), 1);
        std::stable_sort(names_.begin(), names_.end(), [&](const std::string& a, const std::string& b) {
            return together_[a] > together_[b];
        });
        for (std::size_t i = 0; i < std::min(names_.size(), most_rows_); ++i) add(names_[i]);
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

    void add(const Name& name) {
        std::vector<Cell> cells{name == group_without_tag  ? in_.say(tell<"other">())
                                : grouping_ == "parameter" ? std::string(name)
                                                           : in_.say(said_name(name))};
        for (const std::size_t j : outputs_) cells.emplace_back(100.0 * shares_[{name, j}]);
        if (alike_) cells.emplace_back(100.0 * together_[name]);
        table_.row(std::move(cells));
    }

    const DocumentLanguage& in_;
    const UncertaintyResult& result_;
    const std::size_t most_rows_;
    std::string grouping_;
    std::vector<std::size_t> outputs_;
    TableBuilder table_;
    std::vector<Name> names_;
    std::map<std::string, double> together_;
    std::map<std::pair<std::string, std::size_t>, double> shares_;
    bool alike_ = true;
};

/// The sentence about which of the groups is shown, and why that one.
Message choice_of_groups(const UncertaintyResult& result) {
    const std::string shown = groups_in_full(result).front();
    const std::size_t all = measurand_groups(result).size(), alike = groups_like_the_first(result).size();
    if (alike == 1)
        return tell<"Shown for %1, the first of the %2 groups; the CSV table of budgets has every group.">(
            shown, all);
    if (alike == all)
        return tell<
            "Shown for %1: of the %2 groups it has the largest expanded uncertainties on average; the CSV "
            "table of budgets has every group.">(shown, all);
    return tell<
        "Shown for %1: of the %2 groups with the same quantities it has the largest expanded uncertainties "
        "on "
        "average; the CSV table of budgets has all %3 groups.">(shown, alike, all);
}

/// Whether an output has a budget: without sensitivity coefficients Monte Carlo answers alone.
bool has_budget(const OutputResult& output) {
    return !std::isnan(output.first_order.standard_uncertainty);
}

}  // namespace

void add_budgets(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in,
                 std::size_t most_rows) {
    const UncertaintyResult& result = *evaluated.result;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Uncertainty budgets">())});
    const std::vector<Name> groups = measurand_groups(result);
    const std::vector<Name> shown = groups_in_full(result);
    std::string words = in.say(
        tell<"Components by falling share of the variance; cᵢ in the unit of the measurand per unit of "
             "the component.">());
    if (!result.inputs->correlations.empty())
        words += " " + in.say(tell<"Two correlated components have half of their covariance each, in the "
                                   "effective degrees of freedom "
                                   "too.">());
    if (shown.size() < groups.size()) words += " " + in.say(choice_of_groups(result));
    blocks.push_back(ParagraphBlock{words});
    for (const std::string& group : shown) {
        for (const std::string& grouping : groupings_of(result.budget))
            blocks.push_back(
                GroupTable(evaluated, grouping, measurands_of(result, group), most_rows, in).make());
        for (const std::size_t output : measurands_of(result, group))
            if (has_budget(result.outputs[output]))
                blocks.push_back(BudgetBlock(evaluated, output, most_rows, in).make());
            else
                blocks.push_back(ParagraphBlock{
                    in.say(tell<"There is no budget of %1: the law of propagation of uncertainty says "
                                "nothing of it at the estimates of its input quantities.">(
                        output_label(result.outputs[output].quantity)))});
        for (const std::size_t output : measurands_of(result, group))
            if (has_budget(result.outputs[output]))
                blocks.push_back(figure(contribution_plot(result, output, in), evaluated,
                                        in.say(tell<"Contributions to the variance of %1.">(
                                            output_label(result.outputs[output].quantity)))));
    }
}

}  // namespace covaria::report_parts
