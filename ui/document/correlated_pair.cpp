#include "ui/document/correlated_pair.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace covaria::ui {

std::string part_of_pair(const std::string& first, const std::string& second) {
    const auto& [low, high] = std::minmax(first, second);
    return correlations_part + low + "|" + high;
}

std::optional<CorrelatedPair> pair_in(const AnalysisEntry& analysis, const std::string& part) {
    if (!part.starts_with(correlations_part)) return {};
    const std::string rest = part.substr(std::string_view(correlations_part).size());
    if (const std::size_t bar = rest.find('|'); bar != std::string::npos)
        return CorrelatedPair(rest.substr(0, bar), rest.substr(bar + 1));
    std::size_t number = 0;
    const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (read.ec != std::errc() || number >= analysis.correlations.size()) return {};
    return CorrelatedPair(analysis.correlations[number].first, analysis.correlations[number].second);
}

}  // namespace covaria::ui
