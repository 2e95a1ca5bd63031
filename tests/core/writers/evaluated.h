// Projects evaluated by the law of propagation, for writers.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/made/load_project.h"
#include "core/writers/writers.h"

namespace covaria::writers_test {

struct Evaluated {
    MadeProject::Pointer made;
    std::vector<EvaluatedAnalysis> analyses;
    WriterSource source() const { return {*made, analyses}; }
};

inline Evaluated evaluate(Project project, std::uint64_t trials = 0) {
    for (AnalysisEntry& entry : project.analyses) {
        entry.options.method = trials > 0 ? Method::monte_carlo : Method::first_order;
        entry.options.trials = trials;
    }
    Evaluated evaluated{MadeProject::make(std::move(project)), {}};
    for (const AnalysisEntry& entry : evaluated.made->project().analyses) {
        const auto prepared = evaluated.made->analysis(entry.id);
        if (!prepared) {
            ADD_FAILURE() << entry.id << ": "
                          << first_error(evaluated.made->problems_of_analysis(entry.id), "");
            continue;
        }
        auto result = run_analysis(*prepared);
        EXPECT_TRUE(result) << entry.id;
        if (result)
            evaluated.analyses.push_back(
                {prepared, std::make_shared<const UncertaintyResult>(std::move(*result)), {}, {}});
    }
    return evaluated;
}

inline Project loaded(const std::filesystem::path& file) {
    const LoadedProject project = load_project(file);
    EXPECT_FALSE(project.problems.has_errors()) << file;
    return project.project;
}

inline Result<WrittenFile> write_as(const std::string& writer, const WriterSource& source) {
    const Writer* found = find_writer(writer);
    if (!found) return fail(ErrorCode::not_found, "no writer " + writer);
    return found->write(source);
}

}  // namespace covaria::writers_test
