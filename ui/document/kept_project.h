// A project in the history of edits: what it has in common with its neighbour is there once.
#pragma once

#include <memory>
#include <vector>

#include "core/project/project.h"

namespace covaria::ui {

class KeptProject {
public:
    using Pointer = std::shared_ptr<const KeptProject>;
    /// Shares the assets and analyses that `neighbour` (may be null) has as well.
    static Pointer keep(Project project, const KeptProject* neighbour);

    Project project() const;
    bool operator==(const KeptProject& other) const;
    /// Assets and analyses that both hold together.
    std::size_t shared_with(const KeptProject& other) const;

private:
    template <class Entry>
    using Entries = std::vector<std::shared_ptr<const Entry>>;

    Project rest_;  ///< without assets and analyses
    Entries<AssetEntry> assets_;
    Entries<AnalysisEntry> analyses_;
};

}  // namespace covaria::ui
