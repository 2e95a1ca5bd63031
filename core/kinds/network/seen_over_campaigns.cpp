// Charts of figures of readings over the campaigns that saw them.
#include <algorithm>
#include <cmath>

#include "core/kinds/network/seen_figures.h"
#include "core/math/special_quantiles.h"

namespace covaria::network {

namespace {

using Campaign = FigureOverCampaigns::Campaign;

constexpr double level = 0.05;             ///< of what is outside of the intervals
constexpr double days_of_a_year = 365.25;  ///< as in the history of an instrument
constexpr double margin = 0.05;            ///< of the lines of the combined figure beyond the campaigns

/// Where the campaigns stand: in years since the first where each states its day, else in their order.
struct Places {
    explicit Places(const std::vector<Campaign>& campaigns)
        : are_years(std::ranges::all_of(campaigns, [](const Campaign& one) { return one.day.has_value(); })) {
        if (!are_years) {
            for (std::size_t k = 0; k < campaigns.size(); ++k) x.push_back(static_cast<double>(k + 1));
            return;
        }
        Days first = *campaigns.front().day;
        for (const Campaign& one : campaigns) first = std::min(first, *one.day);
        for (const Campaign& one : campaigns)
            x.push_back(static_cast<double>((*one.day - first).count()) / days_of_a_year);
    }
    bool are_years;
    std::vector<double> x;
};

/// Ends of the interval of a standard deviation of these degrees of freedom, by chi-squared.
std::pair<double, double> interval_of(const Campaign& seen) {
    const double nu = seen.degrees_of_freedom;
    if (!std::isfinite(nu)) return {seen.value, seen.value};
    return {seen.value * std::sqrt(nu / chi_squared_quantile(1.0 - level / 2, nu)),
            seen.value * std::sqrt(nu / chi_squared_quantile(level / 2, nu))};
}

PlotSpecification chart_of(const FigureOverCampaigns& figure) {
    const auto shown = [&](double si) { return figure.unit ? figure.unit->from_si(si) : si; };
    const Places places(figure.campaigns);
    PlotSpecification plot;
    plot.id = "campaigns-" + figure.kind + (figure.instrument.empty() ? "" : "-" + figure.instrument);
    std::ranges::replace(plot.id, ' ', '-');
    plot.title = figure.unit ? known_text<"Standard uncertainty as seen, over campaigns">()
                             : known_text<"Seen over stated, over campaigns">();
    plot.x.title = places.are_years ? known_text<"years since the first campaign">()
                                    : known_text<"campaign, in the order of the set-up">();
    plot.y.title = figure.kind;
    if (figure.unit) plot.y.unit = figure.unit->display();

    PlotSeries seen{known_text<"as seen">(), SeriesKind::points, SeriesRole::data, {}, {}, {}, 0.0};
    if (!figure.instrument.empty()) {
        seen.name = figure.instrument;
        seen.is_named = true;
    }
    std::vector<PlotSeries> intervals;
    for (std::size_t k = 0; k < figure.campaigns.size(); ++k) {
        seen.x.push_back(places.x[k]);
        seen.y.push_back(shown(figure.campaigns[k].value));
        const auto [low, high] = interval_of(figure.campaigns[k]);
        intervals.push_back({k == 0 ? known_text<"its 95 % interval">() : std::string(),
                             SeriesKind::line,
                             SeriesRole::data,
                             {places.x[k], places.x[k]},
                             {shown(low), shown(high)},
                             {},
                             0.0});
    }
    plot.series.push_back(std::move(seen));
    std::ranges::move(intervals, std::back_inserter(plot.series));

    const auto [first, last] = std::ranges::minmax(places.x);
    const double beyond = margin * std::max(last - first, 1e-3);
    const auto across = [&](std::string name, SeriesRole role, double y) {
        plot.series.push_back({std::move(name),
                               SeriesKind::line,
                               role,
                               {first - beyond, last + beyond},
                               {shown(y), shown(y)},
                               {},
                               0.0});
    };
    const auto [low, high] = interval_of(figure.combined);
    across(known_text<"combined">(), SeriesRole::fit, figure.combined.value);
    across(known_text<"95 % interval of the next campaign">(), SeriesRole::reference, low);
    across({}, SeriesRole::reference, high);
    return plot;
}

}  // namespace

std::vector<PlotSpecification> figures_over_campaigns(const AdjustedNetwork& network) {
    std::vector<PlotSpecification> charts;
    for (const FigureOverCampaigns& figure : network.over_campaigns) charts.push_back(chart_of(figure));
    return charts;
}

}  // namespace covaria::network
