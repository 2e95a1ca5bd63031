// Parts of a project, made for a test.
#pragma once

#include <gtest/gtest.h>

#include "core/made/load_project.h"

namespace covaria {

inline void expect_counts(const MakingCounts& counts, const MakingCounts& expected) {
    EXPECT_EQ(counts.assets, expected.assets);
    EXPECT_EQ(counts.models, expected.models);
    EXPECT_EQ(counts.inputs, expected.inputs);
    EXPECT_EQ(counts.taken, expected.taken);
}

inline void take_asset_problems(const MadeProject& made, Problems& problems) {
    const Problems found = made.problems();
    for (const Problem& problem : found.items())
        if (problem.path.starts_with("/assets/")) problems.add(problem);
}

/// Adds the problems of assets.
inline AssetLibrary made_assets(const Project& project, Problems& problems) {
    const auto made = MadeProject::make(project);
    take_asset_problems(*made, problems);
    return made->assets();
}

/// Null after an error; adds the problems of assets and of the analysis.
inline std::shared_ptr<const PreparedAnalysis> made_analysis(const Project& project, const std::string& id,
                                                             Problems& problems) {
    const auto made = MadeProject::make(project);
    take_asset_problems(*made, problems);
    problems.take(made->problems_of_analysis(id), "");
    return made->analysis(id);
}

/// An analysis of no project with these inputs, to be looked at.
inline std::shared_ptr<const PreparedAnalysis> analysis_with(const std::string& id, InputSet inputs) {
    const auto propagated =
        std::make_shared<const PropagatedModel>(nullptr, std::make_shared<const InputSet>(std::move(inputs)));
    return std::make_shared<const PreparedAnalysis>(PreparedAnalysis{.id = id,
                                                                     .name = {},
                                                                     .descriptor = nullptr,
                                                                     .assets = {},
                                                                     .propagated = propagated,
                                                                     .model = nullptr,
                                                                     .inputs = propagated->inputs(),
                                                                     .options = {},
                                                                     .numbers = nullptr});
}

}  // namespace covaria
