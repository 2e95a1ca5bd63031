#include "ui/document/correlated_pair.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace covaria::ui {

std::string part_of_pair(const std::string& first, const std::string& second) {
    const auto& [low, high] = std::minmax(first, second);
    return correlations_part + low + "|" + high;
}

std::optional<CorrelatedPair> pair_of(const std::string& part) {
    const std::size_t bar = part.find('|');
    if (!part.starts_with(correlations_part) || bar == std::string::npos) return {};
    const std::size_t first = std::string_view(correlations_part).size();
    return CorrelatedPair(part.substr(first, bar - first), part.substr(bar + 1));
}

std::optional<CorrelatedPair> pair_in(const AnalysisEntry& analysis, const std::string& part) {
    if (const auto pair = pair_of(part)) return pair;
    if (!part.starts_with(correlations_part)) return {};
    const std::string rest = part.substr(std::string_view(correlations_part).size());
    std::size_t number = 0;
    const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (read.ec != std::errc() || number >= analysis.correlations.size()) return {};
    return CorrelatedPair(analysis.correlations[number].first, analysis.correlations[number].second);
}

}  // namespace covaria::ui
