// Results beside each other, and the difference of their budgets.
#include "core/views/comparison_columns.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>

#include "core/base/name.h"
#include "core/views/component_labels.h"

namespace covaria {
namespace {

using Scale = Measured::Scale;

/// One output in both results; either may be missing.
struct OutputPair {
    const OutputResult* before;
    const OutputResult* after;
    const OutputQuantity& quantity() const { return after ? after->quantity : before->quantity; }
};

OutputPair pair_of(const ResultComparison& comparison, std::size_t output) {
    const ComparedOutput& at = comparison.outputs[output];
    return {comparison.output_before(at), comparison.output_after(at)};
}

const char* presence(bool before, bool after) {
    return before && after ? "both" : after ? "only after" : "only before";
}

/// Columns of the results: each number before, after and its change.
class ComparedResults {
public:
    ComparedResults(const ResultComparison& comparison, std::vector<std::size_t> outputs)
        : comparison_(comparison),
          outputs_(std::make_shared<const std::vector<std::size_t>>(std::move(outputs))) {}

    Table make() {
        table_.rows = outputs_->size();
        using P = const OutputPair&;
        add("group", [](P p) -> Cell { return said_name(p.quantity().group); }).window("Group");
        add("symbol", [](P p) -> Cell { return Symbols{p.quantity().symbol}; })
            .print("Quantity")
            .window("Symbol")
            .of_symbols();
        add("name", [](P p) -> Cell { return p.quantity().name; }).window("Output quantity");
        add("in", [](P p) -> Cell { return std::string(presence(p.before, p.after)); })
            .print("In")
            .window("In", "Whether both results have the quantity")
            .of_own_words({"both", "only before", "only after"});
        add("unit", [](P p) -> Cell { return p.quantity().unit; }).print("Unit").window("Unit");
        both("U", "U", &OutputResult::expanded_uncertainty, Scale::interval, "Expanded uncertainty");
        change("change of U", "Change of U in %", &OutputResult::expanded_uncertainty,
               "Change of the expanded uncertainty, in per cent of that before");
        both("estimate", "y", &OutputResult::estimate, Scale::value, "Best value of the output quantity");
        table_.columns[table_.columns.size() - 2].estimate_of("U before");
        table_.columns.back().estimate_of("U after");
        add("change of estimate",
            [](P p) -> Cell {
                if (!p.before || !p.after) return {};
                return Measured{
                    p.after->estimate - p.before->estimate, Scale::interval, p.quantity().unit, {}};
            })
            .print("Change of y")
            .window("Change of estimate", "Estimate after less estimate before")
            .estimate_of("U after");
        both("u", "u", &OutputResult::standard_uncertainty, Scale::interval, "Standard uncertainty");
        both("k", "k", &OutputResult::coverage_factor, Scale::interval, "Coverage factor", true);
        return std::move(table_);
    }

private:
    using Number = double OutputResult::*;

    template <class Get>
    Column& add(const std::string& key, Get get) {
        return table_.add(key, [&c = comparison_, shown = outputs_, get](std::size_t row) -> Cell {
            return get(pair_of(c, (*shown)[row]));
        });
    }

    /// Adds a number of both results: "U before", "U after".
    void both(const std::string& key, const std::string& symbol, Number number, Scale scale,
              const std::string& help, bool pure = false) {
        const auto cell = [=](const OutputResult* of, const Unit& unit) -> Cell {
            if (!of) return {};
            return pure ? Measured{of->*number} : Measured{of->*number, scale, unit, {}};
        };
        const NumberRule rule = pure ? NumberRule{.role = NumberRole::fixed, .decimals = 2}
                                     : NumberRule{.role = NumberRole::uncertainty};
        const bool estimate = scale == Scale::value;
        add(key + " before", [=](const OutputPair& p) { return cell(p.before, p.quantity().unit); })
            .print(symbol + " before")
            .window(Text((estimate ? "Estimate" : symbol) + " before"), help)
            .round(rule);
        add(key + " after", [=](const OutputPair& p) { return cell(p.after, p.quantity().unit); })
            .print(symbol + " after")
            .window(Text((estimate ? "Estimate" : symbol) + " after"), help)
            .round(rule);
    }

    void change(const std::string& key, const std::string& head, Number number, const std::string& help) {
        add(key,
            [number](const OutputPair& p) -> Cell {
                if (!p.before || !p.after) return {};
                const auto part = relative_change(p.before->*number, p.after->*number);
                return part ? Cell(Measured{*part}) : Cell();
            })
            .print(head)
            .window(Text(head), help)
            .percent(1);
    }

    const ResultComparison& comparison_;
    std::shared_ptr<const std::vector<std::size_t>> outputs_;
    Table table_{"compared-results", "Results before and after"};
};

/// A component in both budgets; either may be missing.
struct ComponentPair {
    const OutputQuantity& output;
    const BudgetRow* row_before;
    const BudgetRow* row_after;
    const BudgetComponent* before;
    const BudgetComponent* after;
    double change;           ///< change of the variance
    double variance_before;  ///< u_c^2 of the output
    bool changed;
    const BudgetComponent& either() const { return after ? *after : *before; }
};

ComponentPair pair_of(const ResultComparison& c, const ComparedPlace& place) {
    const ComparedOutput& at = c.outputs[place.output];
    const auto row = [](const UncertaintyResult& result, std::optional<std::size_t> output,
                        std::optional<std::size_t> index) {
        return output && index ? &result.budget.rows[*output][*index] : nullptr;
    };
    const BudgetRow* before = row(*c.before, at.before, place.component.before);
    const BudgetRow* after = row(*c.after, at.after, place.component.after);
    const double u = at.before ? c.before->outputs[*at.before].first_order.standard_uncertainty : 0.0;
    return {at.after ? c.after->outputs[*at.after].quantity : c.before->outputs[*at.before].quantity,
            before,
            after,
            before ? &c.before->budget.components[before->component] : nullptr,
            after ? &c.after->budget.components[after->component] : nullptr,
            place.component.change(),
            u * u,
            has_changed(c, place)};
}

std::string change_word(const ComponentPair& p) {
    if (!p.before) return "new";
    if (!p.after) return "gone";
    return p.changed ? "changed" : "same";
}

Cell interval_cell(const double* si, const Unit& unit) {
    return si ? Cell(Measured{*si, Scale::interval, unit, {}}) : Cell();
}

std::optional<Unit> unit_of_all(const ResultComparison& comparison,
                                const std::vector<ComparedPlace>& places) {
    for (const ComparedPlace& place : places)
        if (place.output != places.front().output) return std::nullopt;
    if (places.empty()) return std::nullopt;
    return pair_of(comparison, places.front()).output.unit;
}

}  // namespace

Table compared_results_table(const ResultComparison& comparison, std::vector<std::size_t> outputs) {
    return ComparedResults(comparison, std::move(outputs)).make();
}

Table compared_results_table(const ResultComparison& comparison) {
    std::vector<std::size_t> all(comparison.outputs.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return compared_results_table(comparison, std::move(all));
}

std::vector<ComparedPlace> compared_places(const ResultComparison& comparison, std::size_t output) {
    std::vector<ComparedPlace> places;
    for (const ComparedComponent& component : compare_budgets(comparison, comparison.outputs[output]))
        places.push_back({output, component});
    return places;
}

bool has_changed(const ResultComparison& comparison, const ComparedPlace& place) {
    const ComparedOutput& at = comparison.outputs[place.output];
    double scale = 0.0;
    for (const OutputResult* of : {comparison.output_before(at), comparison.output_after(at)})
        if (of) scale = std::max(scale, std::pow(of->first_order.standard_uncertainty, 2));
    return std::abs(place.component.change()) > 1e-12 * scale;
}

std::vector<Text> compared_labels(const ResultComparison& comparison,
                                  const std::vector<ComparedPlace>& places,
                                  const DocumentLanguage& language) {
    std::vector<const BudgetComponent*> components;
    for (const ComparedPlace& place : places) components.push_back(&pair_of(comparison, place).either());
    return component_labels(components, language);
}

Table compared_budget_table(const ResultComparison& comparison, std::vector<ComparedPlace> at,
                            const DocumentLanguage& language) {
    const std::optional<Unit> unit = unit_of_all(comparison, at);
    const auto places = std::make_shared<const std::vector<ComparedPlace>>(std::move(at));
    Table table{"compared-budget", "Budgets before and after", places->size()};
    using P = const ComponentPair&;
    const auto add = [&](const char* key, auto get) -> Column& {
        return table.add(key, [&comparison, places, get](std::size_t row) -> Cell {
            return get(pair_of(comparison, (*places)[row]));
        });
    };
    add("group", [](P p) -> Cell { return p.output.group; });
    add("output", [](P p) -> Cell { return Symbols{p.output.symbol}; });
    add("output unit", [](P p) -> Cell { return p.output.unit; });
    add("quantity", [](P p) -> Cell { return p.either().quantities; })
        .print("Symbol")
        .window("Input quantity")
        .of_symbols();
    add_label_column(table, std::bind_front(compared_labels, std::cref(comparison), *places, language));
    add("component", [](P p) -> Cell { return p.either().name; })
        .print("Component")
        .window("Component of uncertainty");
    add("id", [](P p) -> Cell { return p.either().id; });
    add("what", [](P p) -> Cell { return change_word(p); })
        .print("What")
        .window("Kind of change", "Changed, the same, new, or gone")
        .of_own_words({"new", "gone", "changed", "same"});
    add("unit", [](P p) -> Cell { return p.either().unit; })
        .print("Unit")
        .window("Unit", "Of the component's u");
    const char* u_help = "Standard uncertainty of the component";
    add("u before",
        [](P p) {
            return interval_cell(p.before ? &p.before->standard_uncertainty : nullptr, p.either().unit);
        })
        .print("u before")
        .window("u before", u_help)
        .uncertainty(3);
    add("u after",
        [](P p) {
            return interval_cell(p.after ? &p.after->standard_uncertainty : nullptr, p.either().unit);
        })
        .print("u after")
        .window("u after", u_help)
        .uncertainty(3);
    const char* c_help = "Contribution to the standard uncertainty";
    add("contribution before",
        [](P p) {
            return interval_cell(p.row_before ? &p.row_before->contribution : nullptr, p.output.unit);
        })
        .print(unit ? "|c|\u00b7u before in %1" : "|c|\u00b7u before")
        .window("|c|\u00b7u before", c_help)
        .uncertainty()
        .in(unit);
    add("contribution after",
        [](P p) { return interval_cell(p.row_after ? &p.row_after->contribution : nullptr, p.output.unit); })
        .print(unit ? "|c|\u00b7u after in %1" : "|c|\u00b7u after")
        .window("|c|\u00b7u after", c_help)
        .uncertainty()
        .in(unit);
    add("share before", [](P p) { return interval_cell(p.row_before ? &p.row_before->share : nullptr, {}); })
        .print("Share before in %")
        .window("Share before / %", "Of the variance before")
        .percent(1);
    add("share after", [](P p) { return interval_cell(p.row_after ? &p.row_after->share : nullptr, {}); })
        .print("Share after in %")
        .window("Share after / %", "Of the variance after")
        .percent(1);
    add("change of variance",
        [](P p) -> Cell {
            return p.variance_before > 0.0 ? Cell(Measured{p.change / p.variance_before}) : Cell();
        })
        .print("Change of variance in %")
        .window("Change of variance / %",
                "By how much this component changes the variance of the output, in per cent of the whole "
                "variance before; the rows add up to the change of the whole")
        .percent(1);
    add("origin", [](P p) -> Cell {
        return p.either().origin;
    }).window("Origin", "Where the figure comes from");
    return table;
}

}  // namespace covaria
