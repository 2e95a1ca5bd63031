// Points of a study's grid, one after the other, by one thread.
#pragma once

#include <functional>

#include "core/base/bytes.h"
#include "core/propagation/evaluate_summary.h"
#include "core/study/changed_project.h"
#include "core/study/study.h"

namespace covaria::detail {

/// The plan of a study, which all its points share.
struct StudyPlan {
    explicit StudyPlan(const PreparedStudy& prepared);

    const PreparedStudy& prepared;
    ChangedNumbers numbers;
    EvaluationOptions options;
    std::vector<std::vector<double>> values;  ///< per axis
    std::vector<StudyOutput> outputs;
    std::vector<std::size_t> indices;  ///< indices of the outputs in the unchanged model
    std::vector<StudyTriple> triples;
    std::size_t points = 1;
};

/// A grid point's numbers, or why there are none.
struct EvaluatedPoint {
    StudyPoint point = {};
    Message reason = {};
    bool cancelled = false;
    void write(ByteWriter& writer) const;
    void read(ByteReader& reader);
};

/// The points of the grid, each evaluated by itself.
class GridWalker {
public:
    explicit GridWalker(const StudyPlan& plan);
    EvaluatedPoint evaluate(std::size_t point, const std::function<bool(std::uint64_t)>& advance);

private:
    EvaluatedPoint of_model(const ChangedModel& changed, const std::function<bool(std::uint64_t)>& advance);
    void add_places(const Layout& layout, const std::vector<std::size_t>& indices,
                    const EvaluationSummary& summary, StudyPoint& point) const;

    const StudyPlan& plan_;
    ChangedProject changed_;
};

}  // namespace covaria::detail
