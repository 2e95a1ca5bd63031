// Assets and analyses of a project as one graph: which entry refers to which.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "core/project/project.h"

namespace covaria {

/// A reference of an entry to another.
struct EntryReference {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::string path;   ///< place of the reference, relative to the entry: "/setup/base_uncertainty"
    std::string title;  ///< title of the field that refers
    std::string id;     ///< id of the entry that it refers to
    std::vector<std::string> capabilities;
    std::size_t entry = none;  ///< number of that entry; none: there is no such entry, or it cannot be taken
    /// Whether it refers to an analysis, which stands for an asset; only analyses can take it.
    bool to_analysis = false;
    /// Ids from that entry back to this one, where it refers back: the reference is then refused, and is no
    /// edge.
    std::vector<std::string> circle = {};

    bool is_edge() const { return entry != none && circle.empty(); }
};

/// The graph of the entries, which are numbered: the assets of the project, then its analyses. Of several
/// entries with one id the first counts.
class EntryGraph {
public:
    explicit EntryGraph(const Project& project);

    std::size_t size() const { return references_.size(); }
    bool is_asset(std::size_t entry) const { return entry < assets_; }
    std::size_t number_of_analysis(std::size_t analysis) const { return assets_ + analysis; }
    /// The references of an entry, in the order of its schema.
    const std::vector<EntryReference>& references(std::size_t entry) const { return references_[entry]; }
    /// All entries, each after those that its set-up refers to. (Links are no part of this order: they
    /// compose models that are made already.)
    const std::vector<std::size_t>& order() const { return order_; }
    /// The entries that this one refers to or has links to, directly or through others, without itself;
    /// rising.
    std::vector<std::size_t> used_by(std::size_t entry) const;

private:
    void refer(const Project& project);
    void sort();

    std::size_t assets_;
    std::vector<std::string> ids_;
    std::vector<std::vector<EntryReference>> references_;
    /// Links of each entry to the analyses whose outputs are inputs of it.
    std::vector<std::vector<std::size_t>> links_;
    std::vector<std::size_t> order_;
};

/// Ids of the assets that the analysis uses, directly or through others, in the order of the project.
std::vector<std::string> assets_used_by(const Project& project, const AnalysisEntry& analysis);
/// Ids of the analyses that use the asset.
std::vector<std::string> analyses_using(const Project& project, const std::string& asset_id);

}  // namespace covaria
