// What messages call an asset or an analysis: as the tree of the project shows it, never by its id.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/in_quotes.h"
#include "core/project/project.h"
#include "core/setup/message_text.h"

namespace covaria {

/// Of an asset or analysis; what has no name, and what is not in the project, is called as it is referred to.
inline std::string shown_name(const Project& project, const std::string& id, bool of_analysis) {
    if (of_analysis) {
        const AnalysisEntry* analysis = project.find_analysis(id);
        return analysis && !analysis->name.empty() ? analysis->name : id;
    }
    const AssetEntry* asset = project.find_asset(id);
    return asset && !asset->name.empty() ? asset->name : id;
}

/// " (did you mean 'Laser tracker'?)": the entry with the nearest id or name, by its name.
template <class Entry>
Message did_you_mean_entry(const std::string& reference, const std::vector<Entry>& entries) {
    std::vector<std::string> known;
    for (const Entry& entry : entries) known.push_back(entry.id);
    for (const Entry& entry : entries) known.push_back(entry.name);
    const std::string nearest = nearest_name(reference, known);
    if (nearest.empty()) return {};
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
        return entry.id == nearest || entry.name == nearest;
    });
    return tell<" (did you mean %1?)">(in_quotes(found->name.empty() ? found->id : found->name));
}

}  // namespace covaria
