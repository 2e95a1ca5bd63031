#include "core/evidence/as_seen.h"

#include <algorithm>

namespace covaria::evidence {

namespace {

/// The same readings, with all figures as one.
RedundantReadings as_one_figure(const RedundantReadings& readings) {
    RedundantReadings one = readings;
    one.figures.resize(1);
    for (std::size_t& figure : one.figure_of)
        if (figure != RedundantReadings::no_figure) figure = 0;
    if (one.shares.empty()) return one;
    Eigen::Index columns = 0, at = 0;
    for (const Eigen::MatrixXd& shares : readings.shares) columns += shares.cols();
    Eigen::MatrixXd all(readings.residuals.size(), columns);
    for (const Eigen::MatrixXd& shares : readings.shares) {
        all.middleCols(at, shares.cols()) = shares;
        at += shares.cols();
    }
    one.shares = {std::move(all)};
    return one;
}

bool all_rest_on_figures(const RedundantReadings& readings) {
    return readings.shares.empty() &&
           std::ranges::find(readings.figure_of, RedundantReadings::no_figure) == readings.figure_of.end();
}

/// Empty where the residuals tell none.
TakenFactor one_factor(const RedundantReadings& readings) {
    if (all_rest_on_figures(readings)) {
        // Then it is s_0, for any number of readings.
        const Seen seen = global_test(readings);
        if (!(seen.s0 > 0.0)) return {};
        return {seen.s0, static_cast<double>(seen.degrees_of_freedom)};
    }
    const Seen seen = see(as_one_figure(readings));
    if (!seen.found || !(seen.figures.front().degrees_of_freedom > 0.0)) return {};
    return {seen.figures.front().factor, seen.figures.front().degrees_of_freedom};
}

AsSeen by_figures(const RedundantReadings& readings) {
    AsSeen taken{std::vector<TakenFactor>(readings.figures.size()), {}};
    const Seen& seen = seen_of(readings);
    if (!seen.found) {
        taken.kept =
            readings.names.size() > most_readings_of(readings)
                ? tell<
                      "The residuals of more than %1 readings are not divided between their figures: "
                      "uncertainties "
                      "stay as stated; one factor for all of them can be had">(most_readings_of(readings))
                : tell<"The residuals give no factors: uncertainties of the readings stay as stated">();
        return taken;
    }
    Message kept;
    for (std::size_t k = 0; k < taken.factors.size(); ++k) {
        const SeenFigure& figure = seen.figures[k];
        if (is_known(figure))
            taken.factors[k] = {figure.factor, figure.degrees_of_freedom};
        else
            kept += Message(kept.empty() ? "" : ", ") + readings.figures[k].name;
    }
    if (!kept.empty()) taken.kept = tell<"Too little redundancy to say, so they stay as stated: %1">(kept);
    return taken;
}

}  // namespace

bool AsSeen::has_any() const {
    return std::ranges::any_of(factors, &TakenFactor::is_seen);
}

AsSeen as_seen(const RedundantReadings& readings, UncertaintiesFrom from) {
    if (from == UncertaintiesFrom::seen) return by_figures(readings);
    AsSeen taken{std::vector<TakenFactor>(readings.figures.size()), {}};
    if (from == UncertaintiesFrom::stated) return taken;
    std::ranges::fill(taken.factors, one_factor(readings));
    if (!taken.has_any())
        taken.kept = tell<
            "The readings have no residuals that could tell their uncertainty: it stays as "
            "stated">();
    return taken;
}

AsSeen as_seen(const RedundantReadings* readings, UncertaintiesFrom from, const std::string& place,
               Problems& problems) {
    if (from == UncertaintiesFrom::stated) return {};
    if (!readings) {
        problems.warning(place, tell<"Nothing is redundant: uncertainties of the readings stay as stated">());
        return {};
    }
    AsSeen taken = as_seen(*readings, from);
    if (!taken.kept.empty()) problems.warning(place, taken.kept);
    return taken;
}

}  // namespace covaria::evidence
