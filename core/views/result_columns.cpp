// The columns of the output quantities of a result.
#include "core/views/result_columns.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <set>

#include "core/base/name.h"
#include "core/propagation/requirements.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/views/result_statement.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

const char* const met_word = "met";
const char* const not_met_word = "not met";

const Phrase low_at{"%1 interval, low"}, high_at{"%1 interval, high"}, low{"Interval, low"},
    high{"Interval, high"}, without{"U without %1"},
    remains_by_law{
        "Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by "
        "the "
        "law of propagation"},
    remains_by_monte_carlo{
        "Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by "
        "Monte "
        "Carlo"};

using Number = std::function<std::optional<double>(const OutputResult&)>;
using Scale = Measured::Scale;

/// A figure of the shape of a distribution; it is not a number where that has no variance, or is a constant.
double moment(const MonteCarloOutput& trials, double value) {
    const double u = trials.standard_uncertainty;
    return std::isfinite(u) && u > 0.0 ? value : std::numeric_limits<double>::quiet_NaN();
}

/// A number of Monte Carlo, empty where it did not run.
Number trials(std::function<double(const MonteCarloOutput&)> of) {
    return [of = std::move(of)](const OutputResult& output) {
        return output.monte_carlo ? std::optional(of(*output.monte_carlo)) : std::nullopt;
    };
}

Number line(double OutputResult::*member) {
    return [member](const OutputResult& output) { return std::optional(output.*member); };
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

using Rows = std::shared_ptr<const std::vector<std::size_t>>;

/// Adds U of the outputs in the rows without each contributor.
void add_contributors(Table& table, const UncertaintyResult& result, const Rows& outputs,
                      const DocumentLanguage& language) {
    const std::vector<std::string> keys = contributor_keys(result);
    const Phrase& help = result.contributor_trials > 0 ? remains_by_monte_carlo : remains_by_law;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::string name = language.say(result_words::contributor_title(result.contributors[i]));
        table
            .add(keys[i],
                 [&r = result, shown = outputs, i](std::size_t row) -> Cell {
                     const OutputResult& output = r.outputs[(*shown)[row]];
                     const double U = expanded_with(output, r.contributors[i].without, (*shown)[row]);
                     return Measured{U, Scale::interval, output.quantity.unit, {}};
                 })
            .window(language.say(without, {name}), language.say(help, {name}))
            .uncertainty()
            .not_in_files();
    }
}

/// Gives an estimate, its uncertainties and limits one power of ten, because the result line is read across.
void share_powers(Table& table) {
    static const std::set<std::string, std::less<>> line{"estimate",
                                                         "u",
                                                         "U",
                                                         "interval low",
                                                         "interval high",
                                                         "shortest low",
                                                         "shortest high",
                                                         "stated low",
                                                         "stated high",
                                                         "estimate first order",
                                                         "u first order",
                                                         "U first order"};
    for (Column& column : table.columns)
        if (line.contains(column.key)) column.of_row({"estimate", "u", "U", "interval low", "interval high"});
}

class ResultColumns {
public:
    ResultColumns(const UncertaintyResult& result, std::vector<std::size_t> outputs,
                  const DocumentLanguage& language)
        : result_(result),
          outputs_(std::make_shared<const std::vector<std::size_t>>(std::move(outputs))),
          language_(language) {}

    /// Makes the table with its columns in the order in which files have them.
    Table make() {
        table_.rows = outputs_->size();
        add_quantity();
        add_result_line();
        add_trials();
        add_first_order();
        table_.add("U by", words(expanded_key(result_)));
        table_.add("remark", words(represents_measurand(result_) ? "" : std::string(does_not_represent)));
        add_contributors(table_, result_, outputs_, language_);
        share_powers(table_);
        return std::move(table_);
    }

private:
    using Cells = std::function<Cell(std::size_t)>;

    Cells of_output(std::function<Cell(const OutputResult&)> get) const {
        return [&all = result_.outputs, shown = outputs_, get = std::move(get)](std::size_t row) {
            return get(all[(*shown)[row]]);
        };
    }
    static Cells words(std::string same) {
        return [same = std::move(same)](std::size_t) -> Cell { return same; };
    }
    Cells measured(Number number, Scale scale) const {
        return of_output([number = std::move(number), scale](const OutputResult& output) -> Cell {
            const std::optional<double> si = number(output);
            return si ? Cell(Measured{*si, scale, output.quantity.unit, {}}) : Cell();
        });
    }
    Cells value(Number number) const { return measured(std::move(number), Scale::value); }
    Cells interval(Number number) const { return measured(std::move(number), Scale::interval); }
    Cells pure(Number number) const {
        return of_output([number = std::move(number)](const OutputResult& output) -> Cell {
            const std::optional<double> x = number(output);
            return x ? Cell(Measured{*x}) : Cell();
        });
    }

    void add_quantity() {
        using R = const OutputResult&;
        table_.add("group", of_output([](R o) -> Cell { return said_name(o.quantity.group); }))
            .window("Group", "The pose, point or target the quantity belongs to");
        table_.add("symbol", of_output([](R o) -> Cell { return Symbols{o.quantity.symbol}; }))
            .print("Quantity")
            .window("Symbol")
            .of_symbols();
        table_.add("name", of_output([](R o) -> Cell { return o.quantity.name; })).window("Output quantity");
        table_.add(
            "role", of_output([](R o) -> Cell {
                return std::string(o.quantity.role == OutputRole::measurand ? "measurand" : "intermediate");
            }));
        table_.add("unit", of_output([](R o) -> Cell { return o.quantity.unit; }))
            .print("Unit")
            .window("Unit");
    }

    void add_result_line() {
        const std::string by = expanded_words(result_).english();
        table_
            .add("rounding", interval([&r = result_](const OutputResult& o) {
                     return std::optional(stated_spread(o, r));
                 }))
            .uncertainty()
            .not_in_files();
        table_.add("estimate", value(line(&OutputResult::estimate)))
            .print_symbol("y")
            .window("Estimate", "Best value of the output quantity")
            .estimate_of("rounding");
        table_.add("u", interval(line(&OutputResult::standard_uncertainty)))
            .print_symbol("u(y)")
            .window("u", "Standard uncertainty")
            .uncertainty();
        table_.add("k", pure(line(&OutputResult::coverage_factor)))
            .print_symbol("k")
            .window("k", "Coverage factor. " + by)
            .fixed(2);
        table_.add("U", interval(line(&OutputResult::expanded_uncertainty)))
            .print_symbol("U")
            .window("U", "Expanded uncertainty. " + by)
            .uncertainty();
        table_.add("coverage probability",
                   [p = result_.coverage_probability](std::size_t) -> Cell { return Measured{p}; });
    }

    Column& add_limit(const char* key, double CoverageInterval::*side,
                      CoverageInterval MonteCarloOutput::*which) {
        const auto limit = trials([=](const MonteCarloOutput& t) { return (t.*which).*side; });
        return table_.add(key, value(limit)).print(key).estimate_of("rounding");
    }

    void add_trials() {
        using T = const MonteCarloOutput&;
        using C = CoverageInterval;
        using M = MonteCarloOutput;
        const IntervalHeads heads = interval_heads(result_.coverage_probability, language_);
        const char* shortest = "Limit of the shortest coverage interval";
        table_.add("mean", value(trials([](T t) { return t.mean; })))
            .print("mean Monte Carlo")
            .estimate_of("u Monte Carlo");
        table_.add("u Monte Carlo", interval(trials([](T t) { return t.standard_uncertainty; })))
            .print("u Monte Carlo")
            .uncertainty(3);
        table_.add("standard error of mean", interval(trials([](T t) { return t.standard_error_of_mean; })));
        table_.add("standard error of u",
                   interval(trials([](T t) { return t.standard_error_of_uncertainty; })));
        add_limit("interval low", &C::low, &M::symmetric);
        add_limit("interval high", &C::high, &M::symmetric);
        add_limit("shortest low", &C::low, &M::shortest).window(heads.low, shortest);
        add_limit("shortest high", &C::high, &M::shortest).window(heads.high, shortest);
        table_.add("skewness", pure(trials([](T t) { return moment(t, t.skewness); })))
            .print("skewness")
            .fixed(3);
        table_.add("excess kurtosis", pure(trials([](T t) { return moment(t, t.kurtosis); })))
            .print("excess kurtosis")
            .fixed(3);
        table_.add("kurtosis", pure(trials([](T t) { return moment(t, 3.0 + t.kurtosis); }))).not_in_files();
        table_.add("coverage ratio", pure(trials([](T t) { return t.normality.coverage_ratio; })));
        table_.add("distribution", of_output([](const OutputResult& o) -> Cell {
                       if (!o.monte_carlo) return {};
                       const NormalityVerdict& verdict = o.monte_carlo->normality;
                       return verdict.words.english() +
                              (verdict.acceptable ? "" : ": state the coverage interval");
                   }));
        // The words leave out the advice, which stands below the table.
        table_
            .add("distribution in short", of_output([](const OutputResult& o) -> Cell {
                     return o.monte_carlo ? Cell(o.monte_carlo->normality.words.english()) : Cell();
                 }))
            .print("Distribution")
            .of_own_words()
            .not_in_files();
        table_
            .add(
                "ratio", of_output([](const OutputResult& o) -> Cell {
                    if (!o.monte_carlo || !(o.monte_carlo->standard_uncertainty > 0.0) ||
                        !std::isfinite(o.monte_carlo->standard_uncertainty))
                        return {};
                    return Measured{o.first_order.standard_uncertainty / o.monte_carlo->standard_uncertainty};
                }))
            .print("ratio")
            .fixed(3)
            .not_in_files();
        // The interval is that of the result line: of Monte Carlo, else of the law of propagation.
        const auto stated = [&r = result_](double C::*side) -> Number {
            return [&r, side](const OutputResult& o) { return coverage_interval_of(o, r).*side; };
        };
        table_
            .add("stated interval", of_output([](const OutputResult& o) -> Cell {
                     return std::string(o.monte_carlo ? "symmetric" : "first-order");
                 }))
            .not_in_files();
        const char* interval =
            "Limit of the coverage interval: of Monte Carlo, else of the law of propagation";
        for (const auto& [key, title, side] :
             {std::tuple("stated low", heads.low, &C::low), std::tuple("stated high", heads.high, &C::high)})
            table_.add(key, value(stated(side)))
                .window(title, interval)
                .estimate_of("rounding")
                .not_in_files();
    }

    void add_first_order() {
        using F = FirstOrderOutput;
        using V = FirstOrderOutput::Validation;
        const char* help = "By the law of propagation of uncertainty";
        table_.add("estimate first order", value(first(&F::estimate)))
            .print("y at the estimates")
            .window("Estimate (first order)", help)
            .estimate_of("u first order");
        table_.add("u first order", interval(first(&F::standard_uncertainty)))
            .print("u law of prop.")
            .window("u (first order)", help)
            .uncertainty(3);
        table_.add("nu_eff", pure(first(&F::effective_degrees_of_freedom)))
            .print_symbol("nu_eff")
            .window(result_.trials > 0 ? Text("\u03bd (first order)") : symbol_text("nu_eff"),
                    "Effective degrees of freedom (JCGM 100 G.4)")
            .degrees_of_freedom();
        table_.add("k first order", pure(first(&F::coverage_factor)));
        table_.add("U first order", interval(first(&F::expanded_uncertainty)))
            .window("U (first order)", help)
            .uncertainty();
        table_.add("delta", interval(validation(&V::tolerance))).print_symbol("delta").figure(1);
        table_.add("d_low", interval(validation(&V::d_low))).print_symbol("d_low").estimate_of("delta");
        table_.add("d_high", interval(validation(&V::d_high))).print_symbol("d_high").estimate_of("delta");
        table_
            .add(
                "clause 8", of_output([](const OutputResult& o) -> Cell {
                    const auto& v = o.first_order.validation;
                    return v ? Cell(Answer{v->validated, "validated", "not validated", v->is_close}) : Cell();
                }))
            .print("First order validated")
            .window("First order validated",
                    "JCGM 101 clause 8: agrees with Monte Carlo within the tolerance");
        table_.add("u second order", interval(second(&F::second_order_standard_uncertainty)))
            .print("u with second-order terms")
            .window("u (second order)", "With the second-order terms of JCGM 100 5.1.2; for information")
            .uncertainty(3);
        table_.add("shift second order", interval(second(&F::second_order_estimate_shift)))
            .print("shift of the estimate")
            .window("shift (second order)",
                    "What the curvature of the equation adds to the estimate; for information, not added")
            .figure_no_fewer(2);
    }

    const UncertaintyResult& result_;
    Rows outputs_;
    DocumentLanguage language_;  ///< language of heads with names in them
    Table table_{"results", "Results"};
};

}  // namespace

IntervalHeads interval_heads(std::optional<double> probability, const DocumentLanguage& language) {
    if (!probability) return {language.say(low), language.say(high)};
    const std::string p = percent_text(*probability, language.numbers());
    return {language.say(low_at, {p}), language.say(high_at, {p})};
}

std::vector<std::string> contributor_keys(const UncertaintyResult& result) {
    std::vector<std::string> keys;
    for (const ContributorResult& c : result.contributors)
        keys.push_back(DocumentLanguage().say(without, {result_words::contributor_title(c).english()}));
    return keys;
}

Table results_table(const UncertaintyResult& result, std::vector<std::size_t> outputs) {
    return ResultColumns(result, std::move(outputs), {}).make();
}

Table results_table(const UncertaintyResult& result, std::vector<std::size_t> outputs,
                    const std::vector<RequirementResult>& verdicts, const DocumentLanguage& language) {
    struct OfRow {
        Cell target, part, lower, upper, met;
    };
    auto rows = std::make_shared<std::vector<OfRow>>();
    for (const std::size_t output : outputs) {
        const OutputResult& of = result.outputs[output];
        OfRow& row = rows->emplace_back();
        for (const RequirementResult& verdict : verdicts) {
            if (verdict.output != output) continue;
            if (verdict.lower_limit)
                row.lower = Measured{*verdict.lower_limit, Scale::value, of.quantity.unit, {}};
            if (verdict.upper_limit)
                row.upper = Measured{*verdict.upper_limit, Scale::value, of.quantity.unit, {}};
            if (!verdict.target_uncertainty) continue;
            const double target = *verdict.target_uncertainty;
            row.target = Measured{target, Scale::interval, of.quantity.unit, {}};
            if (target > 0.0) row.part = Measured{of.expanded_uncertainty / target};
        }
        if (const auto met = are_met(verdicts, output)) row.met = std::string(*met ? met_word : not_met_word);
    }
    Table table = ResultColumns(result, std::move(outputs), language).make();
    table.add("target", [rows](std::size_t row) { return (*rows)[row].target; })
        .window("Target", "Target uncertainty that is required")
        .uncertainty()
        .not_in_files();
    table.add("U/target", [rows](std::size_t row) { return (*rows)[row].part; })
        .window("U / target", "Expanded uncertainty as a part of its target: above 1 the target is not met")
        .part_of_limit(2)
        .not_in_files();
    table.add("lower limit", [rows](std::size_t row) { return (*rows)[row].lower; })
        .window("Lower limit", "Of the tolerance; empty: none.")
        .estimate_of("rounding")
        .not_in_files();
    table.add("upper limit", [rows](std::size_t row) { return (*rows)[row].upper; })
        .window("Upper limit", "Of the tolerance; empty: none.")
        .estimate_of("rounding")
        .not_in_files();
    table.add("met", [rows](std::size_t row) { return (*rows)[row].met; })
        .window("Requirement", "Whether the target uncertainty is met and the value is accepted")
        .of_own_words({met_word, not_met_word})
        .not_in_files();
    return table;
}

Table results_table(const UncertaintyResult& result) {
    std::vector<std::size_t> all(result.outputs.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return results_table(result, std::move(all));
}

}  // namespace covaria
