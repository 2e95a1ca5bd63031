// Studies in a report: what was varied, best and worst points, charts, what has no values.
#include <algorithm>

#include "core/report/report_parts.h"
#include "core/report/study_plots.h"
#include "core/result/representation.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {

namespace {

constexpr std::size_t most_points = 30;     // of a sweep that is printed in full
constexpr std::size_t most_quantities = 8;  // of the table of best and worst points

std::string what_was_done(const StudyResult& study) {
    std::string words = "Evaluated at " + count_text(study.points.size()) + " grid points, ";
    words += study.trials > 0 ? "with " + count_text(study.trials) + " trials at each"
                              : std::string("by the law of propagation of uncertainty");
    for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
        const StudyAxisValues& values = study.axes[axis];
        const std::string unit = values.unit == Unit{} ? "" : " " + values.unit.display();
        words += (axis ? "; " : ". Varied: ") + to_unicode(values.title) + " from " +
                 format_trimmed(values.values.front(), 6) + " to " + format_trimmed(values.values.back(), 6) +
                 unit + " (" + std::to_string(values.values.size()) + " values" +
                 (values.logarithmic ? ", logarithmic)" : ")");
    }
    return words + ".";
}

TableBlock sweep_table(const StudyResult& study) {
    TableBuilder table("study-" + study.id, study.name);
    const StudyAxisValues& axis = study.axes.front();
    table.number(to_unicode(axis.title) + (axis.unit == Unit{} ? "" : " / " + axis.unit.display()), 4);
    const std::vector<StudyQuantity> all = study_quantities(study);
    const std::size_t shown = std::min(all.size(), most_quantities);
    for (std::size_t q = 0; q < shown; ++q)
        table.number(to_unicode(all[q].title) + " / " + all[q].unit.display(), 3);
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        std::vector<TableCell> row{axis.values[i]};
        for (std::size_t q = 0; q < shown && study.points[i].has_values(); ++q)
            row.emplace_back(all[q].unit.interval_from_si(value_at(study, all[q], i)));
        row.resize(shown + 1);
        table.row(std::move(row));
    }
    if (all.size() > shown) table.note("The CSV table of the study has all output quantities.");
    return table.take();
}

TableBlock extremes_table(const StudyResult& study) {
    TableBuilder table("study-" + study.id, study.name + ": best and worst grid points");
    table.text("Quantity");
    table.number("least", 3);
    table.text("at");
    table.number("greatest", 3);
    table.text("at");
    const std::vector<StudyQuantity> all = study_quantities(study);
    for (std::size_t q = 0; q < std::min(all.size(), most_quantities); ++q) {
        const StudyExtremes extremes = extremes_of(study, all[q]);
        if (!extremes.known) continue;
        const auto cell = [&](std::size_t point) {
            return interval_in(all[q].unit, value_at(study, all[q], point));
        };
        table.row({to_unicode(all[q].title), cell(extremes.best), point_words(study, extremes.best),
                   cell(extremes.worst), point_words(study, extremes.worst)});
    }
    return table.take();
}

void add_reasons(Blocks& blocks, const StudyResult& study) {
    if (const std::size_t count = not_representing(study).size(); count > 0)
        blocks.push_back(ParagraphBlock{
            "What is given for " + count_text(count) + " of the grid points " + does_not_represent +
            ": more than 1 % of their trials have no value (see the CSV table)."});
    if (study.failed() == 0) return;
    blocks.push_back(ParagraphBlock{count_text(study.failed()) + " grid points have no values:"});
    ListBlock list;
    constexpr std::size_t most = 6;
    for (std::size_t reason = 1; reason < study.reasons.size() && reason <= most; ++reason) {
        const auto count = std::count_if(study.points.begin(), study.points.end(),
                                         [&](const StudyPoint& point) { return point.reason == reason; });
        list.items.push_back(count_text(static_cast<std::uint64_t>(count)) + ": " + study.reasons[reason]);
    }
    if (study.reasons.size() > most + 1) list.items.push_back("others: see the CSV table of the study");
    blocks.push_back(std::move(list));
}

}  // namespace

void add_studies(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    if (evaluated.studies.empty()) return;
    blocks.push_back(HeadingBlock{2, "Studies"});
    for (const auto& study : evaluated.studies) {
        blocks.push_back(HeadingBlock{3, study->name});
        blocks.push_back(ParagraphBlock{what_was_done(*study)});
        if (study->axes.size() == 1 && study->points.size() <= most_points)
            blocks.push_back(sweep_table(*study));
        else
            blocks.push_back(extremes_table(*study));
        for (PlotSpecification& plot : study_plots(*study))
            if (!plot.series.empty()) {
                std::string caption = to_unicode(plot.title) + ".";
                blocks.push_back(figure(std::move(plot), evaluated, std::move(caption)));
            }
        add_reasons(blocks, *study);
    }
}

}  // namespace covaria::report_parts
