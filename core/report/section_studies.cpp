// Studies in a report: the numbers that were varied, best and worst points, charts, and points without
// values.
#include <algorithm>

#include "core/report/report_parts.h"
#include "core/result/representation.h"
#include "core/text/numbers.h"
#include "core/views/study_plots.h"
#include "core/views/study_view.h"

namespace covaria::report_parts {

namespace {

constexpr std::size_t most_points = 30;     // points of a sweep that is printed in full
constexpr std::size_t most_quantities = 8;  // quantities that a table of points shows

Message range_of(const StudyAxisValues& axis, const DocumentLanguage& in) {
    const auto number = [&in](double value) {
        return grouped_digits(format_trimmed(value, 6), in.numbers());
    };
    const std::string title = in.say(axis.title.message()), from = number(axis.values.front()),
                      to = number(axis.values.back()) + unit_after_number(axis.unit);
    return axis.logarithmic
               ? tell<"%1 from %2 to %3 (%4 values, logarithmic)">(title, from, to, axis.values.size())
               : tell<"%1 from %2 to %3 (%4 values)">(title, from, to, axis.values.size());
}

std::string what_was_done(const StudyResult& study, const DocumentLanguage& in) {
    const std::string points = count_text(study.points.size(), in.numbers());
    std::string words =
        in.say(study.trials > 0
                   ? tell<"Evaluated at %1 grid points, with %2 trials at each.">(
                         points, count_text(study.trials, in.numbers()))
                   : tell<"Evaluated at %1 grid points, by the law of propagation of uncertainty.">(points));
    std::string ranges;
    for (const StudyAxisValues& axis : study.axes)
        ranges += (ranges.empty() ? "" : "; ") + in.say(range_of(axis, in));
    return ranges.empty() ? words : words + " " + in.say(tell<"Varied: %1.">(ranges));
}

TableBlock sweep_table(const StudyResult& study, const DocumentLanguage& in) {
    TableBuilder table("study-" + study.id, study.name, in);
    const Table all = study_view(study, in);
    const std::size_t quantities = study_quantities(study, in).size(),
                      shown = std::min(quantities, most_quantities);
    std::vector<std::string> keys;
    for (std::size_t c = 0; c <= shown; ++c) keys.push_back(all.columns[c].key);
    table.all_of(all, keys);
    if (quantities > shown) table.note(tell<"The CSV table of the study has all output quantities.">());
    return table.take();
}

TableBlock extremes_table(const StudyResult& study, const DocumentLanguage& in) {
    TableBuilder table("study-" + study.id, tell<"%1: best and worst grid points">(study.name), in);
    table.text(tell<"Quantity">());
    table.text(tell<"Unit">());
    table.number(tell<"least">()).figure(3);
    table.text(tell<"at">());
    table.number(tell<"greatest">()).figure(3);
    table.text(tell<"at">());
    const std::vector<StudyQuantity> all = study_quantities(study, in);
    for (std::size_t q = 0; q < std::min(all.size(), most_quantities); ++q) {
        const StudyExtremes extremes = extremes_of(study, all[q]);
        if (!extremes.known) continue;
        const auto cell = [&](std::size_t point) {
            return interval_in(all[q].unit, value_at(study, all[q], point));
        };
        table.row({to_unicode(all[q].title), all[q].unit, cell(extremes.best),
                   point_words(study, extremes.best, in), cell(extremes.worst),
                   point_words(study, extremes.worst, in)});
    }
    if (all.size() > most_quantities)
        table.note(tell<"The CSV table of the study has all output quantities.">());
    return table.take();
}

void add_reasons(Blocks& blocks, const StudyResult& study, const DocumentLanguage& in) {
    const auto number = [&in](std::uint64_t count) { return count_text(count, in.numbers()); };
    if (const std::size_t count = not_representing(study).size(); count > 0)
        blocks.push_back(ParagraphBlock{
            in.say(tell<"What is given for %1 of the grid points does not represent the measurand: more than "
                        "1 % of their trials have no value (see the CSV table).">(number(count)))});
    if (study.failed() == 0) return;
    blocks.push_back(ParagraphBlock{in.say(tell<"%1 grid points have no values:">(number(study.failed())))});
    ListBlock list;
    constexpr std::size_t most = 6;
    for (std::size_t reason = 1; reason < study.reasons.size() && reason <= most; ++reason) {
        const auto count = std::count_if(study.points.begin(), study.points.end(),
                                         [&](const StudyPoint& point) { return point.reason == reason; });
        list.items.push_back(number(static_cast<std::uint64_t>(count)) + ": " +
                             in.say(study.reasons[reason]));
    }
    if (study.reasons.size() > most + 1)
        list.items.push_back(in.say(tell<"others: see the CSV table of the study">()));
    blocks.push_back(std::move(list));
}

}  // namespace

void add_studies(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    if (evaluated.studies.empty()) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Studies">())});
    for (const auto& study : evaluated.studies) {
        blocks.push_back(HeadingBlock{3, study->name});
        blocks.push_back(ParagraphBlock{what_was_done(*study, in)});
        if (study->axes.size() == 1 && study->points.size() <= most_points)
            blocks.push_back(sweep_table(*study, in));
        else
            blocks.push_back(extremes_table(*study, in));
        for (PlotSpecification& plot : study_plots(*study, in))
            if (!plot.series.empty()) blocks.push_back(titled_figure(std::move(plot), evaluated));
        add_reasons(blocks, *study, in);
    }
}

}  // namespace covaria::report_parts
