// The output quantities of a result.
#include "core/report/result_columns.h"

#include <memory>
#include <numeric>

#include "core/report/report_parts.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"

namespace covaria {
namespace {

using Number = std::function<std::optional<double>(const OutputResult&)>;
using Scale = Measured::Scale;

const char* const first_order_help = "By the law of propagation of uncertainty";

/// A number of Monte Carlo, where it ran.
Number trials(std::function<double(const MonteCarloOutput&)> of) {
    return [of = std::move(of)](const OutputResult& output) {
        return output.monte_carlo ? std::optional(of(*output.monte_carlo)) : std::nullopt;
    };
}

Number first(double FirstOrderOutput::*member) {
    return [member](const OutputResult& output) { return std::optional(output.first_order.*member); };
}

Number second(std::optional<double> FirstOrderOutput::*member) {
    return [member](const OutputResult& output) { return output.first_order.*member; };
}

Number validation(double FirstOrderOutput::Validation::*member) {
    return [member](const OutputResult& output) {
        const auto& v = output.first_order.validation;
        return v ? std::optional((*v).*member) : std::nullopt;
    };
}

NumberRule digits(int significant) {
    return {.digits = significant};
}

NumberRule match(const char* key) {
    return {.match = key};
}

class ResultColumns {
public:
    ResultColumns(const UncertaintyResult& result, std::vector<std::size_t> outputs)
        : result_(result), outputs_(std::make_shared<const std::vector<std::size_t>>(std::move(outputs))) {}

    Table make() {
        table_.rows = outputs_->size();
        add_quantity();
        add_result_line();
        add_trials();
        add_first_order();
        add_contributors();
        return std::move(table_);
    }

private:
    template <class Get>
    std::function<Cell(std::size_t)> of_quantity(Get get) const {
        return [&all = result_.outputs, shown = outputs_, get](std::size_t row) -> Cell {
            return get(all[(*shown)[row]].quantity);
        };
    }

    std::function<Cell(std::size_t)> measured(Number number, Scale scale, bool pure) const {
        return [&all = result_.outputs, shown = outputs_, number = std::move(number), scale,
                pure](std::size_t row) -> Cell {
            const OutputResult& output = all[(*shown)[row]];
            const std::optional<double> si = number(output);
            if (!si) return {};
            return Measured{*si, scale, pure ? Unit{} : output.quantity.unit, {}};
        };
    }
    std::function<Cell(std::size_t)> value(Number n) const {
        return measured(std::move(n), Scale::value, false);
    }
    std::function<Cell(std::size_t)> interval(Number n) const {
        return measured(std::move(n), Scale::interval, false);
    }
    std::function<Cell(std::size_t)> pure(Number n) const {
        return measured(std::move(n), Scale::interval, true);
    }

    void add(Column column) { table_.columns.push_back(std::move(column)); }

    void add_quantity() {
        using Q = const OutputQuantity&;
        add({.key = "group",
             .head = "Group",
             .title = "Group",
             .help = "The pose, point or target the quantity belongs to",
             .cell = of_quantity([](Q q) -> Cell { return q.group; })});
        add({.key = "symbol",
             .head = "Quantity",
             .symbols = true,
             .title = "Symbol",
             .cell = of_quantity([](Q q) -> Cell { return Symbols{q.symbol}; })});
        add({.key = "name", .head = "Name", .title = "Output quantity", .cell = of_quantity([](Q q) -> Cell {
                                                                            return q.name;
                                                                        })});
        add({.key = "role", .cell = of_quantity([](Q q) -> Cell {
                                return std::string(q.role == OutputRole::measurand ? "measurand"
                                                                                   : "intermediate");
                            })});
        add({.key = "unit", .head = "Unit", .title = "Unit", .cell = of_quantity([](Q q) -> Cell {
                                                                 return q.unit;
                                                             })});
    }

    void add_result_line() {
        const std::string expanded = expanded_words(result_);
        using R = const OutputResult&;
        add({.key = "estimate",
             .head = "y",
             .is_symbol = true,
             .title = "Estimate",
             .help = "Best value of the output quantity",
             .rule = match("U"),
             .cell = value([](R o) { return std::optional(o.estimate); })});
        add({.key = "u",
             .head = "u(y)",
             .is_symbol = true,
             .title = "u",
             .help = "Standard uncertainty",
             .rule = digits(2),
             .cell = interval([](R o) { return std::optional(o.standard_uncertainty); })});
        add({.key = "k",
             .head = "k",
             .is_symbol = true,
             .title = "k",
             .help = "Coverage factor. " + expanded,
             .rule = {.decimals = 2},
             .cell = pure([](R o) { return std::optional(o.coverage_factor); })});
        add({.key = "U",
             .head = "U",
             .is_symbol = true,
             .title = "U",
             .help = "Expanded uncertainty. " + expanded,
             .rule = digits(2),
             .cell = interval([](R o) { return std::optional(o.expanded_uncertainty); })});
        add({.key = "coverage probability",
             .cell = pure([&r = result_](R) { return std::optional(r.coverage_probability); })});
        add({.key = "U by", .cell = [by = expanded_key(result_)](std::size_t) -> Cell { return by; }});
        add({.key = "remark",
             .cell = [remark = std::string(represents_measurand(result_) ? "" : does_not_represent)](
                         std::size_t) -> Cell { return remark; }});
    }

    void add_limit(const char* key, const char* title, const char* help, double CoverageInterval::*side,
                   CoverageInterval MonteCarloOutput::*which) {
        add({.key = key,
             .head = key,
             .title = title,
             .help = help,
             .rule = match("U"),
             .cell = value(trials([=](const MonteCarloOutput& t) { return (t.*which).*side; }))});
    }

    void add_trials() {
        using T = const MonteCarloOutput&;
        add({.key = "mean", .cell = value(trials([](T t) { return t.mean; }))});
        add({.key = "u Monte Carlo", .cell = interval(trials([](T t) { return t.standard_uncertainty; }))});
        add({.key = "standard error of mean",
             .cell = interval(trials([](T t) { return t.standard_error_of_mean; }))});
        add({.key = "standard error of u",
             .cell = interval(trials([](T t) { return t.standard_error_of_uncertainty; }))});
        const char* symmetric = "Limit of the probabilistically symmetric coverage interval";
        const char* shortest = "Limit of the shortest coverage interval";
        using C = CoverageInterval;
        using M = MonteCarloOutput;
        add_limit("interval low", "Low", symmetric, &C::low, &M::symmetric);
        add_limit("interval high", "High", symmetric, &C::high, &M::symmetric);
        add_limit("shortest low", "Low", shortest, &C::low, &M::shortest);
        add_limit("shortest high", "High", shortest, &C::high, &M::shortest);
        add({.key = "skewness", .cell = pure(trials([](T t) { return t.skewness; }))});
        add({.key = "excess kurtosis", .cell = pure(trials([](T t) { return t.kurtosis; }))});
        add({.key = "kurtosis", .cell = pure(trials([](T t) { return 3.0 + t.kurtosis; }))});
        add({.key = "coverage ratio", .cell = pure(trials([](T t) { return t.normality.coverage_ratio; }))});
        add({.key = "distribution",
             .cell = [&all = result_.outputs, shown = outputs_](std::size_t row) -> Cell {
                 const auto& t = all[(*shown)[row]].monte_carlo;
                 return t ? Cell(t->normality.words) : Cell();
             }});
        // Of the result line: of Monte Carlo, else of the law of propagation.
        const auto stated = [&r = result_](double C::*side) {
            return
                [&r, side](const OutputResult& o) { return std::optional(coverage_interval_of(o, r).*side); };
        };
        add({.key = "stated interval",
             .cell = [&all = result_.outputs, shown = outputs_](std::size_t row) -> Cell {
                 return std::string(all[(*shown)[row]].monte_carlo ? "symmetric" : "first-order");
             }});
        add({.key = "stated low", .cell = value(stated(&C::low))});
        add({.key = "stated high", .cell = value(stated(&C::high))});
    }

    void add_first_order() {
        using F = FirstOrderOutput;
        using V = FirstOrderOutput::Validation;
        add({.key = "estimate first order",
             .title = "Estimate (first order)",
             .help = first_order_help,
             .rule = match("U first order"),
             .cell = value(first(&F::estimate))});
        add({.key = "u first order",
             .title = "u (first order)",
             .help = first_order_help,
             .rule = digits(2),
             .cell = interval(first(&F::standard_uncertainty))});
        add({.key = "nu_eff",
             .head = "nu_eff",
             .is_symbol = true,
             .title = symbol_text("nu_eff"),
             .help = "Effective degrees of freedom (JCGM 100 G.4)",
             .rule = {.degrees_of_freedom = true},
             .cell = pure(first(&F::effective_degrees_of_freedom))});
        add({.key = "k first order", .cell = pure(first(&F::coverage_factor))});
        add({.key = "U first order",
             .title = "U (first order)",
             .help = first_order_help,
             .rule = digits(2),
             .cell = interval(first(&F::expanded_uncertainty))});
        add({.key = "delta", .cell = interval(validation(&V::tolerance))});
        add({.key = "d_low", .cell = interval(validation(&V::d_low))});
        add({.key = "d_high", .cell = interval(validation(&V::d_high))});
        add({.key = "clause 8",
             .title = "First order validated",
             .help = "JCGM 101 clause 8: agrees with Monte Carlo within the tolerance",
             .cell = [&all = result_.outputs, shown = outputs_](std::size_t row) -> Cell {
                 const auto& v = all[(*shown)[row]].first_order.validation;
                 return v ? Cell(Answer{v->validated, "validated", "not validated"}) : Cell();
             }});
        add({.key = "u second order",
             .title = "u (second order)",
             .help = "With the second-order terms of JCGM 100 5.1.2; for information",
             .rule = digits(2),
             .cell = interval(second(&F::second_order_standard_uncertainty))});
        add({.key = "shift second order",
             .title = "shift (second order)",
             .help = "What the curvature of the equation adds to the estimate; for information, not added",
             .rule = digits(2),
             .cell = interval(second(&F::second_order_estimate_shift))});
    }

    void add_contributors() {
        const std::vector<std::string> keys = contributor_keys(result_);
        const std::string method =
            result_.contributor_trials > 0 ? "by Monte Carlo" : "by the law of propagation";
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const std::string name = report_parts::contributor_title(result_.contributors[i]);
            add({.key = keys[i],
                 .title = keys[i],
                 .help = "Expanded uncertainty that remains when everything " + name +
                         " brings in is held (an ideal one), " + method,
                 .rule = digits(2),
                 .cell = [&r = result_, shown = outputs_, i](std::size_t row) -> Cell {
                     const OutputResult& output = r.outputs[(*shown)[row]];
                     const auto& without = r.contributors[i].without;
                     return Measured{expanded_with(output, without, (*shown)[row]),
                                     Scale::interval,
                                     output.quantity.unit,
                                     {}};
                 }});
        }
    }

    const UncertaintyResult& result_;
    std::shared_ptr<const std::vector<std::size_t>> outputs_;
    Table table_{"results", "Results"};
};

}  // namespace

std::vector<std::string> contributor_keys(const UncertaintyResult& result) {
    std::vector<std::string> keys;
    for (const ContributorResult& c : result.contributors)
        keys.push_back("U, " + report_parts::contributor_title(c) + " held");
    return keys;
}

Table results_table(const UncertaintyResult& result, std::vector<std::size_t> outputs) {
    return ResultColumns(result, std::move(outputs)).make();
}

Table results_table(const UncertaintyResult& result) {
    std::vector<std::size_t> all(result.outputs.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return results_table(result, std::move(all));
}

}  // namespace covaria
