#include "core/project/project.h"

#include <algorithm>

namespace covaria {

namespace {

template <class Entry>
const Entry* find_entry(const std::vector<Entry>& entries, const std::string& id) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.id == id; });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace

const AssetEntry* Project::find_asset(const std::string& id) const {
    return find_entry(assets, id);
}

EvaluationOptions effective_options(const Project& project, const AnalysisEntry& analysis) {
    EvaluationOptions options = analysis.options;
    if (!options.coverage_factor) options.coverage_factor = project.results.coverage_factor;
    return options;
}

const AnalysisEntry* Project::find_analysis(const std::string& id) const {
    return find_entry(analyses, id);
}

}  // namespace covaria
