#include "core/kinds/equation/observations.h"

#include <algorithm>
#include <cmath>

#include "core/text/symbol.h"

namespace covaria::equation_model {

Observations::Observations(const std::vector<Observation>& rows) {
    for (const Observation& row : rows) {
        Series& series = of_[plain_symbol(row.quantity)][row.series];
        series.values.push_back(row.value);
        if (row.number) series.numbers.push_back(*row.number);
    }
    for (auto& [quantity, all] : of_)
        for (auto& [name, series] : all)
            if (series.numbers.size() != series.values.size()) series.numbers.clear();
}

std::vector<std::string> Observations::quantities() const {
    std::vector<std::string> names;
    for (const auto& [quantity, series] : of_) names.push_back(quantity);
    return names;
}

ObservedQuantity Observations::listed(const InputQuantity& quantity) const {
    ObservedQuantity made{quantity.symbol, quantity.name.english(), quantity.unit, {}};
    if (const auto found = of_.find(quantity.symbol); found != of_.end())
        for (const auto& [name, series] : found->second) made.series.push_back({name, series.values});
    return made;
}

const Observations::Series* Observations::present_series(const std::string& quantity) const {
    const auto found = of_.find(quantity);
    if (found == of_.end()) return nullptr;
    const SeriesByName& series = found->second;
    if (const auto unnamed = series.find(""); unnamed != series.end()) return &unnamed->second;
    return series.size() == 1 ? &series.begin()->second : nullptr;
}

Result<Observations::Mean> Observations::mean_of(const std::string& quantity) const {
    const Series* series = present_series(quantity);
    if (!series)
        return fail(ErrorCode::bad_input,
                    has(quantity)
                        ? tell<"it has several series: leave out the name of the one that is measured now">()
                        : tell<"the table of observations has no rows for it">());
    return type_a_evaluation(series->values).map([&](const TypeA& a) {
        return Mean{a.mean, a.standard_uncertainty, a.degrees_of_freedom, series->values.size()};
    });
}

Result<Observations::Mean> Observations::pooled(const std::string& quantity, std::optional<double> n) const {
    const auto found = of_.find(quantity);
    if (found == of_.end())
        return fail(ErrorCode::bad_input, tell<"the table of observations has no rows for it">());
    std::vector<std::vector<double>> all;
    for (const auto& [name, series] : found->second)
        if (series.values.size() > 1) all.push_back(series.values);
    const auto pool = pooled_deviation(all);
    if (!pool) return fail(pool.error());
    Mean result;
    result.degrees_of_freedom = pool->degrees_of_freedom;
    if (const Series* present = present_series(quantity)) {
        result.count = present->values.size();
        for (const double v : present->values) result.mean += v / static_cast<double>(result.count);
    }
    const double count = n.value_or(static_cast<double>(result.count));
    if (!(count >= 1.0))
        return fail(ErrorCode::bad_input,
                    tell<"'a' is missing: number of observations of which the value is the mean">());
    result.u = pool->standard_deviation / std::sqrt(count);
    return result;
}

std::optional<double> Observations::correlation(const std::string& first, const std::string& second) const {
    const Series* x = present_series(first);
    const Series* y = present_series(second);
    if (!x || !y || x->numbers.empty()) return std::nullopt;
    std::map<int, double> partner;
    for (std::size_t i = 0; i < y->numbers.size(); ++i) partner[y->numbers[i]] = y->values[i];
    if (partner.size() != x->numbers.size()) return std::nullopt;
    std::vector<double> paired;
    for (const int number : x->numbers) {
        const auto found = partner.find(number);
        if (found == partner.end()) return std::nullopt;
        paired.push_back(found->second);
    }
    const auto covariance = covariance_of_means(x->values, paired);
    const auto u = type_a_evaluation(x->values), v = type_a_evaluation(paired);
    if (!covariance || !u || !v || !(u->standard_uncertainty * v->standard_uncertainty > 0.0))
        return std::nullopt;
    return std::clamp(*covariance / (u->standard_uncertainty * v->standard_uncertainty), -1.0, 1.0);
}

}  // namespace covaria::equation_model
