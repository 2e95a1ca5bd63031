#include "core/project/kept_state.h"

#include <algorithm>
#include <utility>

#include "core/project/asides.h"
#include "core/project/entry_graph.h"
#include "core/project/linked_files.h"
#include "core/project/project.h"

namespace covaria {
namespace {

template <class Entry>
void link_as(std::vector<Entry>& entries, const std::vector<Entry>& linked) {
    for (Entry& entry : entries) {
        const auto same = std::ranges::find(linked, entry.id, &Entry::id);
        if (same == linked.end()) continue;
        for (auto& [key, value] : entry.setup.values) {
            auto* table = std::get_if<SetupTable>(&value);
            const auto found = same->setup.values.find(key);
            const auto* now =
                found == same->setup.values.end() ? nullptr : std::get_if<SetupTable>(&found->second);
            if (!table || !now || table->rows != now->rows || table->units != now->units) continue;
            table->csv_file = now->csv_file;
            table->csv_columns = now->csv_columns;
        }
    }
}

/// Numbers of the entries that the analysis uses, and its own behind them.
std::vector<std::size_t> entries_of(const EntryGraph& graph, std::size_t analysis) {
    std::vector<std::size_t> entries = graph.used_by(graph.number_of_analysis(analysis));
    entries.push_back(graph.number_of_analysis(analysis));
    return entries;
}

/// Puts the entry in the place of the one with its id, or behind the others where there is none.
template <class Entry>
void put(std::vector<Entry>& entries, const Entry& entry) {
    const auto same = std::ranges::find(entries, entry.id, &Entry::id);
    if (same == entries.end())
        entries.push_back(entry);
    else
        *same = entry;
}

}  // namespace

bool KeptState::operator==(const KeptState& with) const {
    return analysis == with.analysis && at == with.at && other == with.other &&
           other_name == with.other_name && (project == with.project || *project == *with.project);
}

KeptState state_to_keep(const Project& project, const std::string& analysis, const std::string& at) {
    auto kept = std::make_shared<Project>();
    kept->results = project.results;
    kept->assets = project.assets;
    kept->analyses = project.analyses;
    kept->directory = project.directory;
    unlink_tables(*kept);
    return {analysis, at, std::move(kept)};
}

KeptState state_to_keep(Project of_results, const Project& now, const std::string& analysis,
                        const std::string& at) {
    for (AssetEntry& entry : of_results.assets)
        if (const AssetEntry* present = now.find_asset(entry.id)) take_asides(entry, *present);
    for (AnalysisEntry& entry : of_results.analyses) {
        const AnalysisEntry* present = now.find_analysis(entry.id);
        if (!present) continue;
        take_asides(entry, *present);
        entry.studies = present->studies;
    }
    return state_to_keep(of_results, analysis, at);
}

KeptState state_of_other(const Project& project, const std::string& other, const std::string& other_name,
                         const std::string& analysis, const std::string& at) {
    KeptState state = state_to_keep(project, analysis, at);
    const auto compared = std::ranges::find(project.analyses, other, &AnalysisEntry::id);
    if (compared == project.analyses.end()) return state;
    // The part of another one's project is no more than the numbers need.
    auto part = std::make_shared<Project>(*state.project);
    part->assets.clear();
    part->analyses.clear();
    const auto number = static_cast<std::size_t>(compared - project.analyses.begin());
    for (const std::size_t entry : entries_of(EntryGraph(project), number)) {
        if (entry < project.assets.size())
            part->assets.push_back(state.project->assets[entry]);
        else
            part->analyses.push_back(state.project->analyses[entry - project.assets.size()]);
    }
    for (AnalysisEntry& entry : part->analyses) {
        entry.studies.clear();
        entry.designs.clear();
        entry.views.clear();
        entry.quantity_notes.clear();
        entry.notes.clear();
    }
    return {analysis, at, std::move(part), other, other_name};
}

const KeptState* find_kept(const std::vector<KeptState>& kept, const std::string& analysis) {
    const auto found = std::ranges::find(kept, analysis, &KeptState::analysis);
    return found == kept.end() ? nullptr : &*found;
}

void put_kept(std::vector<KeptState>& kept, KeptState state) {
    const auto found = std::ranges::find(kept, state.analysis, &KeptState::analysis);
    if (found == kept.end())
        kept.push_back(std::move(state));
    else
        *found = std::move(state);
}

void discard_kept(std::vector<KeptState>& kept, const std::string& analysis) {
    std::erase_if(kept, [&](const KeptState& state) { return state.analysis == analysis; });
}

void go_back(Project& project, const KeptState& state) {
    const std::shared_ptr<const Project> before = state.project;  // `state` may be one of the project's
    const auto analysis = std::ranges::find(before->analyses, state.analysis, &AnalysisEntry::id);
    if (analysis == before->analyses.end()) return;
    auto assets = before->assets;
    auto analyses = before->analyses;
    link_as(assets, project.assets);
    link_as(analyses, project.analyses);
    const auto number = static_cast<std::size_t>(analysis - before->analyses.begin());
    for (const std::size_t entry : entries_of(EntryGraph(*before), number)) {
        if (entry < assets.size())
            put(project.assets, assets[entry]);
        else
            put(project.analyses, analyses[entry - assets.size()]);
    }
    project.results.coverage_factor = before->results.coverage_factor;
}

}  // namespace covaria
