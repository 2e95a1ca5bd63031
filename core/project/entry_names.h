// The names of assets and analyses in messages: as the tree of the project shows them, never by their ids.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/in_quotes.h"
#include "core/project/project.h"
#include "core/setup/message_text.h"

namespace covaria {

/// The name of an entry among its like; entries that share a name are counted in the order of the tree:
/// "Tracker (1)", "Tracker (2)".
template <class Entry>
std::string name_among(const std::vector<Entry>& entries, const Entry& entry) {
    if (entry.name.empty()) return entry.id;
    std::size_t alike = 0, place = 0;
    for (const Entry& other : entries) {
        if (other.name != entry.name) continue;
        ++alike;
        if (other.id == entry.id) place = alike;
    }
    return alike < 2 ? entry.name : entry.name + " (" + std::to_string(place) + ")";
}

/// The name of an asset or analysis; one without a name, or that is not in the project, is called as it is
/// referred to.
inline std::string shown_name(const Project& project, const std::string& id, bool of_analysis) {
    if (of_analysis) {
        const AnalysisEntry* analysis = project.find_analysis(id);
        return analysis ? name_among(project.analyses, *analysis) : id;
    }
    const AssetEntry* asset = project.find_asset(id);
    return asset ? name_among(project.assets, *asset) : id;
}

/// A hint at the entry with the nearest id or name, by its name: " (did you mean 'Laser tracker'?)".
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
    return tell<" (did you mean %1?)">(in_quotes(name_among(entries, *found)));
}

}  // namespace covaria
