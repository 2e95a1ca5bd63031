#include "core/report/comparison_report.h"

#include <algorithm>
#include <cmath>

#include "core/report/certificate_words.h"
#include "core/report/report_parts.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/views/comparison_columns.h"

namespace covaria {
namespace {

using namespace report_parts;

constexpr std::size_t most_compared_budgets = 6;
constexpr std::size_t most_changes = 15;  ///< rows of a budget; further components are summed

std::string method_words(const UncertaintyResult& result, const DocumentLanguage& in) {
    const Message method = result.trials == 0
                               ? tell<"law of propagation">()
                               : tell<"Monte Carlo, %1 trials">(count_text(result.trials, in.numbers()));
    return in.say(method) + ", p = " + percent_text(result.coverage_probability, in.numbers());
}

/// The chapter of one analysis.
class ComparedChapter {
public:
    ComparedChapter(const ComparedAnalysis& analysis, Blocks& blocks, const DocumentLanguage& in)
        : analysis_(analysis), comparison_(analysis.comparison), blocks_(blocks), in_(in) {}

    void add(const std::string& before, const std::string& after) {
        blocks_.push_back(
            FactsBlock{{{in_.say(tell<"Before">()), before + method_words(*comparison_.before, in_)},
                        {in_.say(tell<"After">()), after + method_words(*comparison_.after, in_)}}});
        if (expanded_by(*comparison_.before) != expanded_by(*comparison_.after))
            blocks_.push_back(
                ParagraphBlock{in_.say(tell<"U is stated by different rules: before, %1 After, %2">(
                                   expanded_words(*comparison_.before), expanded_words(*comparison_.after))),
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

    /// Chooses the measurands, and by falling change of u those of them that have another budget.
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
        std::string words =
            in_.say(tell<"%1 of %2 measurands are in both results; the budgets of %3 of them differ.">(
                in_both_, shown_.size(), changed_));
        if (changed_ > budgets_.size())
            words +=
                " " + in_.say(tell<"Shown are the %1 whose standard uncertainty changes most, relative to "
                                   "what it was.">(budgets_.size()));
        blocks_.push_back(ParagraphBlock{words});
    }

    void add_results() {
        const std::vector<std::string> keys = {"symbol",         "in",       "unit",    "estimate before",
                                               "estimate after", "U before", "U after", "change of U",
                                               "k before",       "k after"};
        const Table all = compared_results_table(comparison_, shown_);
        TableBuilder table("compared-results-" + analysis_.id, tell<"Results before and after">(), in_);
        table.columns(all, keys);
        Message group;
        for (std::size_t row = 0; row < shown_.size(); ++row) {
            const Message of = std::get<Message>(all.cell(row, "group"));
            if (!(of == group)) table.subhead(of);
            group = of;
            table.row_of(all, row);
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
                           tell<"Changes of the budget of %1">(output_label(after.quantity)), in_);
        const Table all = compared_budget_table(comparison_, places);
        table.columns(all, keys);
        const std::size_t shown = places.size() <= most_changes ? places.size() : most_changes - 1;
        for (std::size_t row = 0; row < shown; ++row) table.row_of(all, row);
        const double variance = std::pow(before.first_order.standard_uncertainty, 2);
        const auto part = [variance](double change) {
            return variance > 0.0 ? Cell(change / variance) : Cell();
        };
        if (shown < places.size()) {
            double rest = 0.0;
            for (std::size_t i = shown; i < places.size(); ++i) rest += places[i].component.change();
            table.row_with({{"component", tell<"%1 further components">(places.size() - shown)},
                            {"change of variance", part(rest)}});
        }
        const Unit& unit = after.quantity.unit;
        table.row_with(
            {{"quantity", Symbols{"u_c"}},
             {"component", tell<"combined (law of propagation)">()},
             {"contribution before", interval_in(unit, before.first_order.standard_uncertainty)},
             {"contribution after", interval_in(unit, after.first_order.standard_uncertainty)},
             {"change of variance", part(std::pow(after.first_order.standard_uncertainty, 2) - variance)}});
        blocks_.push_back(table.take());
    }

    const ComparedAnalysis& analysis_;
    const ResultComparison& comparison_;
    Blocks& blocks_;
    const DocumentLanguage& in_;
    std::vector<std::size_t> shown_, budgets_;
    std::size_t in_both_ = 0, changed_ = 0;
};

/// Adds both distributions of those outputs whose budgets are shown, where trials gave them.
void add_figures(Blocks& blocks, const EvaluatedAnalysis& evaluated, const std::vector<std::size_t>& outputs,
                 const DocumentLanguage& in) {
    const ResultComparison& comparison = evaluated.before->comparison;
    for (const std::size_t i : outputs) {
        const OutputResult& after = *comparison.output_after(comparison.outputs[i]);
        PlotSpecification plot = compared_distributions_plot(comparison, i, {}, in);
        if (plot.series.empty()) continue;
        blocks.push_back(
            figure(std::move(plot), evaluated,
                   in.say(tell<"Distribution of %1 before and after.">(output_label(after.quantity)))));
    }
}

std::string in_one_list(const std::vector<std::string>& analyses) {
    std::string names;
    for (const std::string& name : analyses) names += (names.empty() ? "" : ", ") + name;
    return names;
}

}  // namespace

ReportDocument build_comparison(const ComparedSides& sides, const std::vector<ComparedAnalysis>& analyses,
                                const DocumentLanguage& in) {
    ReportDocument document;
    document.title = in.say(tell<"Results before and after">());
    document.over = in.say(tell<"Comparison of uncertainty evaluations">());
    document.language = in.code();
    document.page_words = in.say(certificate_words::page);
    document.numbers = in.numbers();
    Blocks& blocks = document.blocks;
    blocks.push_back(
        FactsBlock{{{in.say(tell<"Before">()), sides.before}, {in.say(tell<"After">()), sides.after}}, true});
    if (!sides.only_before.empty())
        blocks.push_back(ParagraphBlock{in.say(tell<"Only before: %1.">(in_one_list(sides.only_before)))});
    if (!sides.only_after.empty())
        blocks.push_back(ParagraphBlock{in.say(tell<"Only after: %1.">(in_one_list(sides.only_after)))});
    for (const ComparedAnalysis& analysis : analyses) {
        blocks.push_back(HeadingBlock{1, analysis.title});
        ComparedChapter(analysis, blocks, in).add({}, {});
    }
    return document;
}

void report_parts::add_before(Blocks& blocks, const EvaluatedAnalysis& evaluated,
                              const DocumentLanguage& in) {
    if (!evaluated.before) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Results before and after">())});
    const ComparedAnalysis analysis{id_part(evaluated.analysis->id), evaluated.analysis->name,
                                    evaluated.before->comparison};
    ComparedChapter chapter(analysis, blocks, in);
    chapter.add(in.say(evaluated.before->words) + "; ", in.say(tell<"this report">()) + "; ");
    add_figures(blocks, evaluated, chapter.with_budgets(), in);
}

std::vector<Table> comparison_tables(const ComparedAnalysis& analysis) {
    const ResultComparison& comparison = analysis.comparison;
    Table results = compared_results_table(comparison);
    std::vector<ComparedPlace> places;
    for (std::size_t i = 0; i < comparison.outputs.size(); ++i)
        for (ComparedPlace& place : compared_places(comparison, i)) places.push_back(std::move(place));
    Table changes = compared_budget_table(comparison, std::move(places));
    for (Column& column : changes.columns) column.unit.reset();  // the rows state their units
    results.id = analysis.id + "-" + results.id;
    changes.id = analysis.id + "-" + changes.id;
    return {file_table(results), file_table(changes)};
}

}  // namespace covaria
