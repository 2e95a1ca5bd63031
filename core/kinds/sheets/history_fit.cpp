#include "core/kinds/sheets/history_fit.h"

#include <algorithm>
#include <cmath>

namespace covaria::sheets {

namespace {

double year_of(const HistorySetup& setup, Days day) {
    return years_between(setup.values.front().day, day);
}

/// Whether the rule is kept so many years after the last calibration.
bool is_kept(const HistorySetup& setup, const HistoryFit& fit, double years) {
    const PredictedValue then = predicted(setup, fit, years);
    const double limit = setup.unit.interval_to_si(setup.limit);
    if (setup.rule == DueRule::drift) return std::abs(then.drift) + setup.factor * then.u_drift <= limit;
    return std::abs(then.value - setup.unit.to_si(setup.nominal)) + setup.factor * then.u <= limit;
}

}  // namespace

HistoryFit fit_of(const HistorySetup& setup) {
    HistoryFit fit;
    const auto weight = [&](const HistoryValue& value) {
        return setup.from_residuals ? 1.0 : 1.0 / (value.u * value.u);
    };
    double weights = 0.0;
    for (const HistoryValue& value : setup.values) {
        weights += weight(value);
        fit.middle += weight(value) * year_of(setup, value.day);
        fit.level += weight(value) * value.value;
    }
    fit.middle /= weights;
    fit.level /= weights;
    double spread = 0.0;
    for (const HistoryValue& value : setup.values) {
        const double t = year_of(setup, value.day) - fit.middle;
        spread += weight(value) * t * t;
        fit.rate += weight(value) * t * (value.value - fit.level);
    }
    fit.rate /= spread;
    double squares = 0.0;
    for (const HistoryValue& value : setup.values) {
        fit.residuals.push_back(value.value - fit.at(year_of(setup, value.day)));
        squares += weight(value) * fit.residuals.back() * fit.residuals.back();
    }
    const double nu = setup.degrees_of_freedom();
    const double scale = nu > 0.0 ? std::sqrt(squares / nu) : 0.0;
    const double factor = setup.from_residuals ? scale : 1.0;
    fit.u_level = factor / std::sqrt(weights);
    fit.u_rate = factor / std::sqrt(spread);
    if (setup.from_residuals) {
        fit.s = scale;
        fit.degrees_of_freedom = nu;
    } else {
        fit.scatter_ratio = scale;
    }
    return fit;
}

PredictedValue predicted(const HistorySetup& setup, const HistoryFit& fit, double years_after_last) {
    const double year = year_of(setup, setup.values.back().day) + years_after_last;
    const double arm = year - fit.middle;
    PredictedValue then;
    then.drift = fit.rate * years_after_last;
    then.u_drift = fit.u_rate * years_after_last;
    then.value = setup.reference + setup.adjusted + fit.at(year);
    then.u = std::sqrt(fit.u_level * fit.u_level + arm * arm * fit.u_rate * fit.u_rate + fit.s * fit.s +
                       setup.common_u * setup.common_u);
    then.half_width = std::abs(then.drift) + setup.factor * then.u_drift;
    then.u_rectangular = then.half_width / std::sqrt(3.0);
    return then;
}

std::optional<DueDay> due_day(const HistorySetup& setup, const HistoryFit& fit) {
    if (setup.rule == DueRule::none) return std::nullopt;
    const Days last = setup.values.back().day;
    if (!is_kept(setup, fit, 0.0)) return DueDay{last, true, false};
    const double day = years_between(Days{}, Days{} + std::chrono::days(1));
    const auto longest = static_cast<long>(std::floor(setup.longest_years / day));
    for (long days = 1; days <= longest; ++days)
        if (!is_kept(setup, fit, years_between(last, last + std::chrono::days(days))))
            return DueDay{last + std::chrono::days(days - 1), false, false};
    return DueDay{last + std::chrono::days(longest), false, true};
}

}  // namespace covaria::sheets
