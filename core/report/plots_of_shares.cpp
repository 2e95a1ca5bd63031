// The charts of shares: contributions to an output, correlation between outputs.
#include <algorithm>
#include <cmath>

#include "core/base/symbol.h"
#include "core/report/plot_parts.h"
#include "core/report/plots.h"

namespace covaria {
namespace {

std::string row_label(const BudgetComponent& component) {
    return component.quantity.empty() ? component.name : symbol_to_unicode(component.quantity);
}

/// Two components of one quantity have the same symbol: then the component's name tells them apart.
std::vector<std::string> distinct_labels(const UncertaintyBudget& budget,
                                         const std::vector<BudgetRow>& rows) {
    std::vector<std::string> labels;
    for (const BudgetRow& row : rows) labels.push_back(row_label(budget.components[row.component]));
    std::vector<std::string> distinct = labels;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (std::count(labels.begin(), labels.end(), labels[i]) > 1)
            distinct[i] += ", " + budget.components[rows[i].component].name;
    return distinct;
}

}  // namespace

PlotSpecification contribution_plot(const UncertaintyResult& result, std::size_t output, std::size_t rows) {
    const OutputResult& out = result.outputs[output];
    PlotSpecification plot =
        plot_frame("contributions", out, "Contributions to u(" + plot_name(out.quantity) + ")");
    std::vector<BudgetRow> shown = result.budget.rows[output];
    std::erase_if(shown, [](const BudgetRow& row) { return row.share == 0.0; });
    if (shown.empty()) return without_spread(std::move(plot));
    double rest = 0.0;
    const std::size_t others = shown.size() > rows ? shown.size() - rows : 0;
    for (std::size_t i = rows; i < shown.size(); ++i) rest += shown[i].share;
    shown.resize(std::min(shown.size(), rows));
    PlotSeries bars{"", SeriesKind::bars, SeriesRole::data, {}, {}, {}, 0.7};
    plot.y.categories = distinct_labels(result.budget, shown);
    for (const BudgetRow& row : shown) bars.y.push_back(100.0 * row.share);
    if (others > 0) {
        plot.y.categories.push_back(std::to_string(others) + " others");
        bars.y.push_back(100.0 * rest);
    }
    for (std::size_t i = 0; i < bars.y.size(); ++i) bars.x.push_back(double(i));
    plot.x = {"share of the variance (%)", 0.0, 0.0, false, {}};
    plot.horizontal_bars = true;
    plot.series.push_back(std::move(bars));
    return plot;
}

PlotSpecification correlation_plot(const UncertaintyResult& result, const std::string& group) {
    PlotSpecification plot;
    plot.id = "correlation" + (group.empty() ? "" : "-" + file_word(group));
    plot.title = "Correlation between the outputs" + (group.empty() ? "" : " of " + group);
    const Eigen::MatrixXd correlation = correlation_of(result.covariance);
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (group.empty() || result.outputs[i].quantity.group == group) shown.push_back(i);
    PlotSeries map{"", SeriesKind::heat_map, SeriesRole::data, {}, {}, {}, 0.0};
    for (std::size_t row : shown) {
        const OutputQuantity& quantity = result.outputs[row].quantity;
        plot.x.categories.push_back(group.empty() ? plot_name(quantity) : symbol_to_unicode(quantity.symbol));
        for (std::size_t column : shown)
            map.z.push_back(correlation(Eigen::Index(row), Eigen::Index(column)));
    }
    plot.y.categories = plot.x.categories;
    plot.z_low = -1.0;
    plot.z_high = 1.0;
    plot.series.push_back(std::move(map));
    return plot;
}

}  // namespace covaria
