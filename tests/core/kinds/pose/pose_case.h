// Cases of tests/data/cases: projects that once gave wrong results.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/core/made.h"

namespace covaria::pose_case {

inline Project project(const std::string& name) {
    const LoadedProject loaded = load_project(COVARIA_SOURCE_DIR "/tests/data/cases/" + name + ".covaria");
    for (const Problem& p : loaded.problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << " " << p.message.english();
    return loaded.project;
}

inline std::shared_ptr<const PreparedAnalysis> prepared(const Project& project, const std::string& id,
                                                        Problems& problems) {
    return made_analysis(project, id, problems);
}

}  // namespace covaria::pose_case
#include "tests/core/made.h"
