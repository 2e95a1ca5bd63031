// Makes a state of a project out of the one before; internal to core/made.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/made/analysis_making.h"
#include "core/made/made_project.h"
#include "core/made/making.h"

namespace covaria {

class ProjectMaking {
public:
    ProjectMaking(std::shared_ptr<const Project> project, const MadeProject* before);
    MadeProject::Pointer make();

private:
    making::Uses uses_of(std::size_t entry) const;
    bool references_keep_numbers(std::size_t entry) const;
    void make_asset(std::size_t index);
    void make_analysis(std::size_t index);

    std::shared_ptr<MadeProject> made_;
    const MadeProject* before_;                                           ///< may be null
    std::map<std::string, std::size_t> assets_before_, analyses_before_;  ///< indices by id
    bool all_assets_stay_ = false;
    /// Whether each asset, with what it refers to, is as before but for names. False for analyses.
    std::vector<bool> keeps_numbers_;
    std::vector<AnalysisMaking> analyses_;  ///< made by themselves, their chains not yet
};

}  // namespace covaria
