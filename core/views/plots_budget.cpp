// The sources of the uncertainty of an output, and the dependence of outputs on each other, as charts.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/name.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/views/component_labels.h"
#include "core/views/plot_words.h"
#include "core/views/plots.h"
#include "core/views/plots_parts.h"
#include "core/views/result_columns.h"
#include "core/views/result_statement.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

using plot_parts::nothing_to_show;
using plot_parts::PlottedOutput;

struct Bars {
    std::vector<Text> labels;
    std::vector<double> share;  ///< shares in %
    std::vector<double> alone;  ///< shares in %, one at a time; empty if not evaluated
};

/// The number of bars: shares below a twentieth of a per cent at the end are one bar, where they are several.
std::size_t bars_to_show(const std::vector<BudgetRow>& rows, std::size_t most) {
    const auto last = std::find_if(rows.rbegin(), rows.rend(), [](const BudgetRow& row) {
        return std::abs(row.share) >= 5e-4 || row.one_at_a_time;
    });
    const auto seen = std::max<std::size_t>(1, static_cast<std::size_t>(rows.rend() - last));
    const std::size_t shown = seen + 1 >= rows.size() ? rows.size() : seen;
    return shown <= most && (shown == rows.size() || shown < most) ? shown : most - 1;
}

Bars bars_of(const UncertaintyResult& result, std::size_t output, std::size_t most,
             const DocumentLanguage& language) {
    const std::vector<BudgetRow> all = rows_at(result, places_that_count(result, output));
    const std::size_t shown = bars_to_show(all, most);
    const std::vector<BudgetRow> rows(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(shown));
    const double u = result.outputs[output].standard_uncertainty;
    Bars bars;
    bars.labels = component_labels(result.budget, rows, language);
    for (const BudgetRow& row : rows) bars.share.push_back(100.0 * row.share);
    const bool alone =
        std::all_of(rows.begin(), rows.end(), [](const BudgetRow& r) { return r.one_at_a_time; });
    for (std::size_t i = 0; alone && u > 0.0 && i < rows.size(); ++i)
        bars.alone.push_back(100.0 * std::pow(*rows[i].one_at_a_time / u, 2));
    if (shown < all.size()) {
        double rest = 0.0;
        for (std::size_t i = shown; i < all.size(); ++i) rest += 100.0 * all[i].share;
        bars.labels.push_back(language.say(plot_words::others, {std::to_string(all.size() - shown)}));
        bars.share.push_back(rest);
    }
    return bars;
}

bool has_contributions(const std::vector<BudgetRow>& rows) {
    return std::any_of(rows.begin(), rows.end(),
                       [](const BudgetRow& row) { return row.share > 0.0 || row.one_at_a_time; });
}

bool is_of_second_order(const OutputResult& output) {
    return output.first_order.standard_uncertainty < 1e-9 * output.standard_uncertainty;
}

/// The title "Contributions to u(x), pose 1"; it says how much of u they are contributions to, where that is
/// not all.
Text title_of_contributions(const PlottedOutput& y, const DocumentLanguage& language) {
    const Name& group = y.output().quantity.group;
    const Text title = language.say_text(plot_words::contributions, {y.symbol()}) +
                       (group.empty() ? "" : ", " + language.say(said_name(group)));
    const auto part = part_of_first_order(y.output());
    return part ? language.say_text(plot_words::first_order_differs,
                                    {title, percent_text(*part, language.numbers())})
                : title;
}

std::vector<double> counted(std::size_t n) {
    std::vector<double> positions;
    for (std::size_t i = 0; i < n; ++i) positions.push_back(static_cast<double>(i));
    return positions;
}

}  // namespace

PlotSpecification contribution_plot(const UncertaintyResult& result, std::size_t output,
                                    const DocumentLanguage& language, std::size_t rows) {
    const PlottedOutput y(result, output);
    const std::string id = y.id("contributions");
    if (output >= result.budget.rows.size() || !has_contributions(result.budget.rows[output])) {
        const bool known = !std::isnan(y.output().first_order.standard_uncertainty);
        return nothing_to_show(
            id, language.say_text(!known                           ? plot_words::without_first_order
                                  : is_of_second_order(y.output()) ? plot_words::of_second_order
                                                                   : plot_words::nothing_influences,
                                  {y.label()}));
    }
    Bars bars = bars_of(result, output, std::max<std::size_t>(rows, 2), language);
    PlotSpecification plot;
    plot.id = id;
    plot.title = title_of_contributions(y, language);
    plot.horizontal_bars = true;
    plot.x.title = language.say(plot_words::share);
    plot.x.unit = "%";
    plot.y.categories = bars.labels;
    const std::string name = bars.alone.empty() ? "" : language.say(plot_words::first_order);
    plot.series.push_back(
        {name, SeriesKind::bars, SeriesRole::data, bars.share, counted(bars.share.size()), {}, 0.72});
    if (!bars.alone.empty())
        plot.series.push_back({language.say(plot_words::one_at_a_time),
                               SeriesKind::points,
                               SeriesRole::emphasis,
                               bars.alone,
                               counted(bars.alone.size()),
                               {},
                               0.0});
    return plot;
}

std::vector<std::size_t> outputs_to_correlate(const UncertaintyResult& result, const std::string& group) {
    std::vector<std::size_t> outputs;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (group.empty() || result.outputs[i].quantity.group == group) outputs.push_back(i);
    return outputs;
}

PlotSpecification correlation_plot(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                                   const DocumentLanguage& language) {
    const auto group_of = [&](std::size_t i) { return result.outputs[i].quantity.group; };
    const bool one_group = std::all_of(outputs.begin(), outputs.end(), [&](std::size_t i) {
        return group_of(i) == group_of(outputs.front());
    });
    const Name group = outputs.empty() || !one_group ? Name() : group_of(outputs.front());
    const std::string id = "correlation" + (group.empty() ? "" : "-" + result_words::id_part(group));
    if (outputs.size() < 2) return nothing_to_show(id, language.say(plot_words::single_output));
    const Eigen::MatrixXd correlation = correlation_of(result.covariance.among(outputs));
    PlotSpecification plot;
    plot.id = id;
    plot.title =
        language.say(plot_words::correlation) + (group.empty() ? "" : ", " + language.say(said_name(group)));
    for (const std::size_t i : outputs) {
        const OutputQuantity& quantity = result.outputs[i].quantity;
        plot.y.categories.push_back(one_group ? symbol_text(quantity.symbol)
                                              : result_words::output_text(quantity, language));
    }
    plot.x.categories = plot.y.categories;
    PlotSeries map{
        language.say(plot_words::coefficient), SeriesKind::heat_map, SeriesRole::data, {}, {}, {}, 0.0};
    map.z.assign(correlation.data(), correlation.data() + correlation.size());
    plot.series.push_back(std::move(map));
    plot.z_low = -1.0;
    plot.z_high = 1.0;
    return plot;
}

}  // namespace covaria
