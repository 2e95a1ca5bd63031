#include "core/kinds/equation/sampled.h"

#include <algorithm>
#include <numeric>

#include "core/text/symbol.h"

namespace covaria::equation_model {

namespace {

tl::unexpected<Error> no_sample(Message message) {
    return fail(ErrorCode::bad_input, std::move(message));
}

/// Divides by the sum; false: there is nothing to divide.
bool made_probabilities(std::vector<double>& weights) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    if (!(sum > 0.0) || !std::isfinite(sum)) return false;
    for (double& weight : weights) weight /= sum;
    return true;
}

}  // namespace

Result<Distribution> sampled_distribution(const std::vector<Observation>& rows, const std::string& quantity,
                                          const Unit& unit, bool histogram) {
    std::vector<double> values, weights;
    bool all_weighted = true, any_weighted = false;
    for (const Observation& row : rows) {
        if (plain_symbol(row.quantity) != quantity) continue;
        const bool behind_last_edge = histogram && !row.weight;
        values.push_back(unit.to_si(row.value));
        any_weighted = any_weighted || row.weight;
        if (histogram && row.weight && weights.size() + 1 != values.size())
            return no_sample(tell<"the weight of a cell of its histogram is missing">());
        if (!behind_last_edge) weights.push_back(row.weight.value_or(1.0));
        all_weighted = all_weighted && row.weight.has_value();
    }
    if (values.empty()) return no_sample(tell<"the table of observations has no rows for it">());
    if (histogram && weights.size() + 1 != values.size())
        return no_sample(
            tell<"a histogram has the weight of each cell beside the edge where it begins, and none beside "
                 "the last edge">());
    if (!histogram && any_weighted && !all_weighted)
        return no_sample(tell<"some values of its sample have a weight and some have none">());
    if (!made_probabilities(weights)) return no_sample(tell<"its weights must have a sum above zero">());
    if (histogram) return Distribution::make(StatedHistogram{std::move(values), std::move(weights)});
    return Distribution::make(Discrete{std::move(values), std::move(weights)});
}

}  // namespace covaria::equation_model
