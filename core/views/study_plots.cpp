// The charts of studies: sweeps as lines, maps as coloured cells.
#include "core/views/study_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/text/head_with_unit.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/text/ticks.h"
#include "core/views/plot_words.h"
#include "core/views/plots_parts.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

constexpr std::array<SeriesRole, 6> family = {SeriesRole::family_1, SeriesRole::family_2,
                                              SeriesRole::family_3, SeriesRole::family_4,
                                              SeriesRole::family_5, SeriesRole::family_6};
// Ratio of the highest to the lowest value from which on an axis is logarithmic.
constexpr double wide_range = 30.0;
constexpr int value_digits = 6;

/// The unit as that of an axis.
std::string axis_unit(const Unit& unit) {
    return unit == Unit{} ? std::string() : unit.display();
}

double shown(const StudyResult& study, const StudyQuantity& quantity, std::size_t point) {
    return quantity.unit.interval_from_si(value_at(study, quantity, point));
}

/// The value as text, "500" or "1500.25", without the tail of digits of a logarithmic spacing.
std::string value_text(double value, const NumberLocale& numbers) {
    return grouped_digits(format_trimmed(value, value_digits), numbers);
}

/// Adds a line in runs of points with values, of which only the first has the name.
void add_line(PlotSpecification& plot, const Text& name, SeriesRole role, const std::vector<double>& x,
              const std::vector<double>& y) {
    PlotSeries run;
    run.name = name;
    run.role = role;
    const auto flush = [&] {
        if (run.x.empty()) return;
        if (run.x.size() == 1) run.kind = SeriesKind::points;
        plot.series.push_back(run);
        run = {};
        run.role = role;
    };
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::isfinite(y[i])) {
            run.x.push_back(x[i]);
            run.y.push_back(y[i]);
        } else {
            flush();
        }
    }
    flush();
}

void choose_y_range(PlotSpecification& plot) {
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    for (const PlotSeries& series : plot.series)
        for (const double y : series.y) {
            low = std::min(low, y);
            high = std::max(high, y);
        }
    plot.y.logarithmic = low > 0.0 && high > wide_range * low;
    if (plot.y.logarithmic || !(high > 0.0)) return;
    plot.y.high = 1.06 * high;  // the axis begins at zero, so that lengths can be compared
}

void mark_present(PlotSpecification& plot, const StudyAxisValues& axis, const DocumentLanguage& language) {
    const auto [low, high] = std::minmax(axis.values.front(), axis.values.back());
    if (axis.present < low || axis.present > high) return;
    const bool is_written_out = format_trimmed(axis.present, value_digits).find('e') == std::string::npos;
    const int exponent = is_written_out ? 0 : axis_exponent(std::max(std::abs(low), std::abs(high)));
    const std::string number = value_text(axis.present / std::pow(10.0, exponent), language.numbers()) +
                               (exponent == 0 ? "" : "×" + power_of_ten(exponent));
    plot.x.exponent = exponent;
    plot.marks.push_back(
        {language.say(plot_words::as_set_up, {number}), axis.present, false, SeriesRole::reference});
}

/// The place of the present value between the categories of a map's axis; empty where it is outside.
std::optional<double> present_place(const StudyAxisValues& axis) {
    const std::vector<double>& values = axis.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (axis.present == values[i]) return static_cast<double>(i);
        if (i + 1 == values.size() || (values[i] < axis.present) != (axis.present < values[i + 1])) continue;
        return static_cast<double>(i) + (axis.present - values[i]) / (values[i + 1] - values[i]);
    }
    return std::nullopt;
}

/// Marks the place as it is set up by a cross, as far as that is on the map; the categories of y run
/// downwards.
void mark_present(PlotSpecification& plot, const StudyAxisValues& x, const StudyAxisValues& y,
                  const DocumentLanguage& language) {
    const auto i = present_place(x), j = present_place(y);
    const auto said = [&](const StudyAxisValues& axis) {
        return language.say(plot_words::as_set_up, {value_text(axis.present, language.numbers())});
    };
    if (i) plot.marks.push_back({said(x), *i, false, SeriesRole::reference});
    if (j)
        plot.marks.push_back(
            {said(y), static_cast<double>(y.values.size() - 1) - *j, true, SeriesRole::reference});
}

/// Outputs whose lines can share a chart with the quantity.
std::vector<StudyQuantity> companions(const std::vector<StudyQuantity>& all, const StudyResult& study,
                                      const StudyQuantity& chosen) {
    const auto group = [&](const StudyQuantity& q) {
        return q.position ? study.outputs[study.triples[q.index].outputs[0]].group
                          : study.outputs[q.index].group;
    };
    std::vector<StudyQuantity> found;
    for (const bool same_group : {true, false})
        for (const StudyQuantity& q : all)
            if (q.unit == chosen.unit && (group(q) == group(chosen)) == same_group &&
                found.size() < family.size())
                found.push_back(q);
    return found;
}

PlotSpecification sweep(const StudyResult& study, const StudyQuantity& chosen,
                        const DocumentLanguage& language) {
    PlotSpecification plot;
    const StudyAxisValues& axis = study.axes.front();
    plot.title = study.name;
    plot.x.title = axis.title.in(language);
    plot.x.unit = axis_unit(axis.unit);
    plot.x.logarithmic = axis.logarithmic;
    plot.y.title = language.say(plot_words::uncertainty);
    plot.y.unit = axis_unit(chosen.unit);
    const std::vector<StudyQuantity> lines = companions(study_quantities(study, language), study, chosen);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        std::vector<double> y;
        for (std::size_t i = 0; i < study.points.size(); ++i) y.push_back(shown(study, lines[k], i));
        add_line(plot, lines[k].title, family[k], axis.values, y);
    }
    choose_y_range(plot);
    mark_present(plot, axis, language);
    return plot;
}

/// Two axes of the grid and the indices of the others.
struct Plane {
    std::size_t x = 0, y = 1;
    std::vector<std::size_t> at;
};

std::size_t point_of(const StudyResult& study, const Plane& plane, std::size_t i, std::size_t j) {
    std::vector<std::size_t> at = plane.at;
    at[plane.x] = i;
    at[plane.y] = j;
    std::size_t point = 0;
    for (std::size_t axis = 0; axis < at.size(); ++axis)
        point = point * study.axes[axis].values.size() + at[axis];
    return point;
}

Plane plane_of(const StudyResult& study, const StudyView& view) {
    Plane plane{0, 1, std::vector<std::size_t>(study.axes.size(), 0)};
    if (study.axes.size() < 3) return plane;
    const std::size_t fixed = std::min<std::size_t>(view.fixed_axis, 2);
    plane.x = fixed == 0 ? 1 : 0;
    plane.y = fixed == 2 ? 1 : 2;
    plane.at[fixed] = std::min(view.slice, study.axes[fixed].values.size() - 1);
    return plane;
}

Text title_of(const StudyResult& study, const StudyView& view, const StudyQuantity& quantity,
              const DocumentLanguage& language) {
    Text title = study.name + ": " + head_with_unit(quantity.title, quantity.unit);
    if (study.axes.size() < 3) return title;
    const StudyAxisValues& axis = study.axes[std::min<std::size_t>(view.fixed_axis, 2)];
    const double value = axis.values[std::min(view.slice, axis.values.size() - 1)];
    const std::string at = value_text(value, language.numbers()) + unit_after_number(axis.unit);
    return language.say_text(plot_words::slice_at, {title, axis.title.in(language), at});
}

PlotAxis category_axis(const StudyAxisValues& values, bool downwards, const DocumentLanguage& language) {
    PlotAxis axis;
    axis.title = values.title.in(language);
    axis.unit = axis_unit(values.unit);
    for (const double value : values.values) axis.categories.push_back(value_text(value, language.numbers()));
    if (downwards) std::reverse(axis.categories.begin(), axis.categories.end());
    return axis;
}

/// Sets the range of colours over the whole study, so that slices can be compared.
void set_colour_range(PlotSpecification& plot, const StudyResult& study, const StudyQuantity& quantity) {
    const StudyExtremes extremes = extremes_of(study, quantity);
    if (!extremes.known) return;
    plot.z_low = shown(study, quantity, extremes.best);
    plot.z_high = shown(study, quantity, extremes.worst);
    if (!(plot.z_high > plot.z_low)) plot.z_high = plot.z_low > 0.0 ? 1.001 * plot.z_low : 1.0;
}

PlotSpecification map(const StudyResult& study, const Plane& plane, const StudyQuantity& quantity,
                      const DocumentLanguage& language) {
    PlotSpecification plot;
    plot.x = category_axis(study.axes[plane.x], false, language);
    plot.y = category_axis(study.axes[plane.y], true, language);
    PlotSeries cells;
    cells.kind = SeriesKind::heat_map;
    cells.name = quantity.title;
    cells.unit = axis_unit(quantity.unit);
    for (std::size_t j = plot.y.categories.size(); j-- > 0;)
        for (std::size_t i = 0; i < plot.x.categories.size(); ++i)
            cells.z.push_back(shown(study, quantity, point_of(study, plane, i, j)));
    plot.series = {std::move(cells)};
    set_colour_range(plot, study, quantity);
    mark_present(plot, study.axes[plane.x], study.axes[plane.y], language);
    return plot;
}

PlotSpecification lines_over_first(const StudyResult& study, const Plane& plane,
                                   const StudyQuantity& quantity, const DocumentLanguage& language) {
    PlotSpecification plot;
    const StudyAxisValues &x = study.axes[plane.x], &other = study.axes[plane.y];
    plot.x.title = x.title.in(language);
    plot.x.unit = axis_unit(x.unit);
    plot.x.logarithmic = x.logarithmic;
    plot.y.title = quantity.title;
    plot.y.unit = axis_unit(quantity.unit);
    const std::size_t n = other.values.size(), lines = std::min(n, family.size());
    for (std::size_t k = 0; k < lines; ++k) {
        const std::size_t j = lines > 1 ? k * (n - 1) / (lines - 1) : 0;
        std::vector<double> y;
        for (std::size_t i = 0; i < x.values.size(); ++i)
            y.push_back(shown(study, quantity, point_of(study, plane, i, j)));
        add_line(plot,
                 other.title.in(language) + " = " + value_text(other.values[j], language.numbers()) +
                     unit_after_number(other.unit),
                 family[k], x.values, y);
    }
    choose_y_range(plot);
    mark_present(plot, x, language);
    return plot;
}

}  // namespace

PlotSpecification study_plot(const StudyResult& study, const StudyView& view,
                             const DocumentLanguage& language) {
    const std::string id = "study-" + study.id;
    const std::vector<StudyQuantity> quantities = study_quantities(study, language);
    if (quantities.empty() || study.failed() == study.points.size())
        return plot_parts::nothing_to_show(
            id, study.points.empty() || quantities.empty()
                    ? language.say(plot_words::run_study, {study.name})
                    : language.say(plot_words::no_values, {study.name, language.say(study.reasons.back())}));
    const StudyQuantity& quantity = quantities[std::min(view.quantity, quantities.size() - 1)];
    PlotSpecification plot;
    if (study.axes.size() == 1) {
        plot = sweep(study, quantity, language);
    } else {
        const Plane plane = plane_of(study, view);
        plot = view.lines ? lines_over_first(study, plane, quantity, language)
                          : map(study, plane, quantity, language);
        plot.title = title_of(study, view, quantity, language);
    }
    plot.id = id + "-" + result_words::id_part(quantity.id);
    return plot;
}

std::vector<PlotSpecification> study_plots(const StudyResult& study, const DocumentLanguage& language,
                                           std::size_t most) {
    std::vector<PlotSpecification> plots;
    std::set<Text> shown_series;
    StudyView view;
    if (study.axes.size() == 3) {
        view.fixed_axis = 2;
        view.slice = study.axes[2].values.size() / 2;
    }
    const std::vector<StudyQuantity> quantities = study_quantities(study, language);
    for (view.quantity = 0; view.quantity < quantities.size() && plots.size() < most; ++view.quantity) {
        // A sweep shows several quantities at once.
        if (study.axes.size() == 1 && shown_series.contains(quantities[view.quantity].title)) continue;
        plots.push_back(study_plot(study, view, language));
        for (const PlotSeries& series : plots.back().series) shown_series.insert(series.name);
    }
    return plots;
}

std::string point_words(const StudyResult& study, std::size_t point, const DocumentLanguage& in) {
    const NumberLocale& numbers = in.numbers();
    const std::vector<std::size_t> at = study.indices_of(point);
    std::string words;
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
        const StudyAxisValues& values = study.axes[axis];
        if (axis) words += numbers.decimal == "," ? "; " : ", ";
        words += in.say(values.title.message()) + " = " + value_text(values.values[at[axis]], numbers) +
                 unit_after_number(values.unit);
    }
    return words;
}

}  // namespace covaria
