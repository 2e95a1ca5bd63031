#include "core/project/entry_graph.h"

#include <algorithm>
#include <map>

#include "core/project/kind_lookup.h"
#include "core/project/references.h"

namespace covaria {

namespace {

std::vector<EntryReference> references_in(const SetupSchema* schema, const Setup& setup) {
    std::vector<EntryReference> references;
    if (!schema) return references;
    for (AssetReference& found : references_of(*schema, setup))
        references.push_back({"/setup" + found.path, std::move(found.title), std::move(found.id),
                              std::move(found.capabilities)});
    return references;
}

}  // namespace

EntryGraph::EntryGraph(const Project& project) : assets_(project.assets.size()) {
    for (const AssetEntry& asset : project.assets) {
        ids_.push_back(asset.id);
        references_.push_back(references_in(schema_of(asset), asset.setup));
    }
    for (const AnalysisEntry& analysis : project.analyses) {
        ids_.push_back(analysis.id);
        references_.push_back(references_in(schema_of(analysis), analysis.setup));
    }
    refer(project);
    sort();
}

void EntryGraph::refer(const Project& project) {
    std::map<std::string, std::size_t> assets, analyses;
    for (std::size_t i = 0; i < project.assets.size(); ++i) assets.try_emplace(project.assets[i].id, i);
    for (std::size_t i = 0; i < project.analyses.size(); ++i)
        analyses.try_emplace(project.analyses[i].id, number_of_analysis(i));
    for (std::size_t entry = 0; entry < size(); ++entry)
        for (EntryReference& reference : references_[entry]) {
            const auto asset = assets.find(reference.id);
            const auto analysis = analyses.find(reference.id);
            reference.to_analysis = asset == assets.end() && analysis != analyses.end();
            if (asset != assets.end()) reference.entry = asset->second;
            if (reference.to_analysis && !is_asset(entry)) reference.entry = analysis->second;
        }
    links_.resize(size());
    for (std::size_t i = 0; i < project.analyses.size(); ++i)
        for (const InputLink& link : project.analyses[i].links)
            if (const auto found = analyses.find(link.output.analysis); found != analyses.end())
                links_[number_of_analysis(i)].push_back(found->second);
}

// The entries are sorted depth first, with a stack of our own: a chain may be as long as the file.
void EntryGraph::sort() {
    enum class State { waiting, in_work, done };
    struct Step {
        std::size_t entry, next;
    };
    std::vector<State> states(size(), State::waiting);
    std::vector<Step> way;
    const auto enter = [&](std::size_t entry) {
        states[entry] = State::in_work;
        way.push_back({entry, 0});
    };
    for (std::size_t begin = 0; begin < size(); ++begin) {
        if (states[begin] == State::waiting) enter(begin);
        while (!way.empty()) {
            Step& step = way.back();
            if (step.next == references_[step.entry].size()) {
                states[step.entry] = State::done;
                order_.push_back(step.entry);
                way.pop_back();
                continue;
            }
            EntryReference& reference = references_[step.entry][step.next++];
            if (reference.entry == EntryReference::none) continue;
            if (states[reference.entry] == State::waiting) {
                enter(reference.entry);
            } else if (states[reference.entry] == State::in_work) {
                auto on_way = std::find_if(way.begin(), way.end(),
                                           [&](const Step& s) { return s.entry == reference.entry; });
                for (; on_way != way.end(); ++on_way) reference.circle.push_back(ids_[on_way->entry]);
            }
        }
    }
}

std::vector<std::size_t> EntryGraph::used_by(std::size_t entry) const {
    std::vector<bool> used(size(), false);
    used[entry] = true;
    std::vector<std::size_t> waiting{entry}, found;
    const auto use = [&](std::size_t other) {
        if (other == EntryReference::none || used[other]) return;
        used[other] = true;
        waiting.push_back(other);
        found.push_back(other);
    };
    while (!waiting.empty()) {
        const std::size_t from = waiting.back();
        waiting.pop_back();
        for (const EntryReference& reference : references_[from]) use(reference.entry);
        for (const std::size_t link : links_[from]) use(link);
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::string> assets_used_by(const Project& project, const AnalysisEntry& analysis) {
    Project part{.title = {}, .assets = project.assets, .analyses = {analysis}};
    for (const AnalysisEntry& other : project.analyses)
        if (other.id != analysis.id) part.analyses.push_back(other);
    const EntryGraph graph(part);
    std::vector<std::string> ids;
    for (const std::size_t used : graph.used_by(graph.number_of_analysis(0)))
        if (graph.is_asset(used)) ids.push_back(part.assets[used].id);
    return ids;
}

std::vector<std::string> analyses_using(const Project& project, const std::string& asset_id) {
    const EntryGraph graph(project);
    std::vector<std::string> users;
    for (std::size_t i = 0; i < project.analyses.size(); ++i)
        for (const std::size_t used : graph.used_by(graph.number_of_analysis(i)))
            if (graph.is_asset(used) && project.assets[used].id == asset_id) {
                users.push_back(project.analyses[i].id);
                break;
            }
    return users;
}

}  // namespace covaria
