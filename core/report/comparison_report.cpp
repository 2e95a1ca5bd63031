#include "core/report/comparison_report.h"

#include <algorithm>
#include <cmath>

#include "core/report/comparison_columns.h"
#include "core/report/report_parts.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"

namespace covaria {
namespace {

using namespace report_parts;

constexpr std::size_t most_compared_budgets = 6;
constexpr std::size_t most_changes = 15;  ///< of a budget; further components are summed

std::string method_words(const UncertaintyResult& result) {
    const std::string method =
        result.trials == 0 ? "law of propagation" : "Monte Carlo, " + count_text(result.trials) + " trials";
    return method + ", p = " + percent_text(result.coverage_probability);
}

/// The chapter of one analysis.
class ComparedChapter {
public:
    ComparedChapter(const ComparedAnalysis& analysis, Blocks& blocks)
        : analysis_(analysis), comparison_(analysis.comparison), blocks_(blocks) {}

    void add(const std::string& before, const std::string& after) {
        blocks_.push_back(FactsBlock{{{"Before", before + method_words(*comparison_.before)},
                                      {"After", after + method_words(*comparison_.after)}}});
        if (expanded_by(*comparison_.before) != expanded_by(*comparison_.after))
            blocks_.push_back(ParagraphBlock{"U is stated by different rules: before, " +
                                                 expanded_words(*comparison_.before) + " After, " +
                                                 expanded_words(*comparison_.after),
                                             true});
        choose();
        add_summary();
        add_results();
        for (const std::size_t output : budgets_) add_budget(output);
    }

    /// Outputs whose changed budgets are shown.
    const std::vector<std::size_t>& with_budgets() const { return budgets_; }

private:
    double size_of_change(std::size_t output) const {
        const ComparedOutput& at = comparison_.outputs[output];
        const double before = comparison_.output_before(at)->first_order.standard_uncertainty;
        const double after = comparison_.output_after(at)->first_order.standard_uncertainty;
        const auto change = relative_change(before, after);
        return change ? std::abs(*change) : after > 0.0 ? infinity : 0.0;
    }

    bool is_measurand_of_any(const ComparedOutput& at) const {
        const OutputResult* after = comparison_.output_after(at);
        return is_measurand(after ? *after : *comparison_.output_before(at));
    }

    /// The measurands, and those of them with another budget by falling change of u.
    void choose() {
        for (std::size_t i = 0; i < comparison_.outputs.size(); ++i) {
            const ComparedOutput& at = comparison_.outputs[i];
            if (!is_measurand_of_any(at)) continue;
            shown_.push_back(i);
            if (!at.in_both()) continue;
            ++in_both_;
            const auto places = compared_places(comparison_, i);
            if (std::any_of(places.begin(), places.end(),
                            [&](const ComparedPlace& place) { return has_changed(comparison_, place); }))
                budgets_.push_back(i);
        }
        std::stable_sort(budgets_.begin(), budgets_.end(), [this](std::size_t a, std::size_t b) {
            return size_of_change(a) > size_of_change(b);
        });
        changed_ = budgets_.size();
        if (changed_ > most_compared_budgets) budgets_.resize(most_compared_budgets);
    }

    void add_summary() {
        std::string words = std::to_string(in_both_) + " of " + std::to_string(shown_.size()) +
                            " measurands are in both results; the budgets of " + std::to_string(changed_) +
                            " of them differ.";
        if (changed_ > budgets_.size())
            words += " Shown are the " + std::to_string(budgets_.size()) +
                     " whose standard uncertainty changes most, relative to what it was.";
        blocks_.push_back(ParagraphBlock{words});
    }

    void add_results() {
        const std::vector<std::string> keys = {"symbol",         "in",       "unit",    "estimate before",
                                               "estimate after", "U before", "U after", "change of U",
                                               "k before",       "k after"};
        const Table all = compared_results_table(comparison_, shown_);
        TableBuilder table("compared-results-" + analysis_.id, "Results before and after");
        table.columns(all, keys);
        std::string group;
        for (std::size_t row = 0; row < shown_.size(); ++row) {
            const std::string of = std::get<std::string>(all.cell(row, "group"));
            if (of != group) table.subhead(of);
            group = of;
            table.row(print_row(all, keys, row));
        }
        blocks_.push_back(table.take());
    }

    void add_budget(std::size_t output) {
        std::vector<ComparedPlace> places = compared_places(comparison_, output);
        std::erase_if(places, [&](const ComparedPlace& place) { return !has_changed(comparison_, place); });
        const ComparedOutput& at = comparison_.outputs[output];
        const OutputResult& before = *comparison_.output_before(at);
        const OutputResult& after = *comparison_.output_after(at);
        const std::vector<std::string> keys = {"quantity",
                                               "component",
                                               "what",
                                               "unit",
                                               "u before",
                                               "u after",
                                               "contribution before",
                                               "contribution after",
                                               "change of variance"};
        TableBuilder table("compared-budget-" + analysis_.id + "-" +
                               id_part(after.quantity.symbol + " " + after.quantity.group),
                           "Changes of the budget of " + output_label(after.quantity));
        const Table all = compared_budget_table(comparison_, places);
        table.columns(all, keys);
        const std::size_t shown = places.size() <= most_changes ? places.size() : most_changes - 1;
        for (std::size_t row = 0; row < shown; ++row) table.row(print_row(all, keys, row));
        const double variance = std::pow(before.first_order.standard_uncertainty, 2);
        const auto percent = [variance](double change) {
            return variance > 0.0 ? TableCell(100.0 * change / variance) : TableCell();
        };
        if (shown < places.size()) {
            double rest = 0.0;
            for (std::size_t i = shown; i < places.size(); ++i) rest += places[i].component.change();
            table.row({{},
                       std::to_string(places.size() - shown) + " further components",
                       {},
                       {},
                       {},
                       {},
                       {},
                       {},
                       percent(rest)});
        }
        const Unit& unit = after.quantity.unit;
        table.row({std::string("u_c"),
                   std::string("combined (law of propagation)"),
                   {},
                   {},
                   {},
                   {},
                   interval_in(unit, before.first_order.standard_uncertainty),
                   interval_in(unit, after.first_order.standard_uncertainty),
                   percent(std::pow(after.first_order.standard_uncertainty, 2) - variance)});
        blocks_.push_back(table.take());
    }

    const ComparedAnalysis& analysis_;
    const ResultComparison& comparison_;
    Blocks& blocks_;
    std::vector<std::size_t> shown_, budgets_;
    std::size_t in_both_ = 0, changed_ = 0;
};

/// Both distributions of those outputs whose budgets are shown, where trials gave them.
void add_figures(Blocks& blocks, const EvaluatedAnalysis& evaluated,
                 const std::vector<std::size_t>& outputs) {
    const ResultComparison& comparison = evaluated.before->comparison;
    for (const std::size_t i : outputs) {
        const OutputResult& after = *comparison.output_after(comparison.outputs[i]);
        PlotSpecification plot = compared_distributions_plot(comparison, i);
        if (plot.series.empty()) continue;
        blocks.push_back(figure(std::move(plot), evaluated,
                                "Distribution of " + output_label(after.quantity) + " before and after."));
    }
}

void add_missing(Blocks& blocks, const char* where, const std::vector<std::string>& analyses) {
    if (analyses.empty()) return;
    std::string names;
    for (const std::string& name : analyses) names += (names.empty() ? "" : ", ") + name;
    blocks.push_back(ParagraphBlock{std::string("Only ") + where + ": " + names + "."});
}

}  // namespace

ReportDocument build_comparison(const ComparedSides& sides, const std::vector<ComparedAnalysis>& analyses) {
    ReportDocument document;
    document.title = "Results before and after";
    document.over = "Comparison of uncertainty evaluations";
    Blocks& blocks = document.blocks;
    blocks.push_back(FactsBlock{{{"Before", sides.before}, {"After", sides.after}}, true});
    add_missing(blocks, "before", sides.only_before);
    add_missing(blocks, "after", sides.only_after);
    for (const ComparedAnalysis& analysis : analyses) {
        blocks.push_back(HeadingBlock{1, analysis.title});
        ComparedChapter(analysis, blocks).add({}, {});
    }
    return document;
}

void report_parts::add_before(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    if (!evaluated.before) return;
    blocks.push_back(HeadingBlock{2, "Results before and after"});
    const ComparedAnalysis analysis{id_part(evaluated.analysis->id), evaluated.analysis->name,
                                    evaluated.before->comparison};
    ComparedChapter chapter(analysis, blocks);
    chapter.add(evaluated.before->words + "; ", "this report; ");
    add_figures(blocks, evaluated, chapter.with_budgets());
}

std::vector<DataTable> comparison_tables(const ComparedAnalysis& analysis) {
    const ResultComparison& comparison = analysis.comparison;
    DataTable results = data_table(compared_results_table(comparison));
    std::vector<ComparedPlace> places;
    for (std::size_t i = 0; i < comparison.outputs.size(); ++i)
        for (ComparedPlace& place : compared_places(comparison, i)) places.push_back(std::move(place));
    Table budget = compared_budget_table(comparison, std::move(places));
    for (Column& column : budget.columns) column.unit.reset();  // the rows say it
    DataTable changes = data_table(budget);
    results.id = analysis.id + "-" + results.id;
    changes.id = analysis.id + "-" + changes.id;
    return {std::move(results), std::move(changes)};
}

}  // namespace covaria
