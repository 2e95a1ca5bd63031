// A project made: all its assets and analyses, once for each state, and everything that is wrong with it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/made/made_entry.h"
#include "core/project/entry_graph.h"
#include "core/project/project.h"

namespace covaria {

/// Count of what there was to do.
struct MakingCounts {
    std::size_t assets = 0, models = 0, inputs = 0;  ///< made anew
    std::size_t taken = 0;                           ///< entries taken over as they were: assets and models
};

/// Immutable and safe to share between threads. Titles, names of analyses and notes influence nothing that is
/// made; the name of an asset is said by what uses it, which is made anew with it and keeps its numbers.
class MadeProject {
public:
    using Pointer = std::shared_ptr<const MadeProject>;

    /// Takes over from `before`, an earlier state, every entry whose own value and whose references stay.
    static Pointer make(std::shared_ptr<const Project> project, const Pointer& before = {});
    static Pointer make(Project project, const Pointer& before = {});

    const Project& project() const { return *project_; }
    const std::shared_ptr<const Project>& snapshot() const { return project_; }
    const EntryGraph& graph() const { return graph_; }
    /// The assets without errors.
    const AssetLibrary& assets() const { return assets_; }
    /// Null: it has errors, or there is none.
    std::shared_ptr<const PreparedAnalysis> analysis(const std::string& id) const;
    /// Null: there is none.
    const MadeAnalysis* find_analysis(const std::string& id) const;
    /// Ids of the assets that the analysis uses, directly or through others, in the order of the project.
    std::vector<std::string> assets_used_by(const std::string& analysis) const;

    /// All problems, with paths from the root of the project.
    Problems problems() const;
    /// Problems of one analysis without its studies and designs; an error that names it where there is none.
    Problems problems_of_analysis(const std::string& id) const;
    /// Warnings to be shown beside the results of an analysis: those of the assets that it uses ("asset
    /// ID: ..."), then its own.
    std::vector<Message> warnings_of(const std::string& analysis) const;
    const MakingCounts& counts() const { return counts_; }

private:
    friend class ProjectMaking;
    explicit MadeProject(std::shared_ptr<const Project> project)
        : project_(std::move(project)), graph_(*project_) {}
    const MadeAnalysis& made_analysis(std::size_t index) const {
        return static_cast<const MadeAnalysis&>(*entries_[graph_.number_of_analysis(index)]);
    }

    std::shared_ptr<const Project> project_;
    EntryGraph graph_;
    std::vector<std::shared_ptr<const MadeEntry>> entries_;  ///< entries by the numbers of the graph
    AssetLibrary assets_;
    MakingCounts counts_;
};

/// The message of the first error; `otherwise` where there is none.
Message first_error(const Problems& problems, const Message& otherwise);

}  // namespace covaria
