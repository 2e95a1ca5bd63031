// One point of a study's grid after the other, by one thread.
#pragma once

#include <functional>

#include "core/propagation/evaluate_summary.h"
#include "core/study/study.h"

namespace covaria::detail {

/// What all points of a study share.
struct StudyPlan {
    explicit StudyPlan(const PreparedStudy& prepared);

    const PreparedStudy& prepared;
    EvaluationOptions options;
    std::vector<std::vector<double>> values;  ///< per axis
    std::vector<StudyOutput> outputs;
    std::vector<std::size_t> indices;  ///< of the outputs in the unchanged model
    std::vector<StudyTriple> triples;
    std::size_t points = 1;
    bool setup_varied = false;  ///< else the model stays and only its inputs change
};

/// A grid point's numbers, or why there are none.
struct EvaluatedPoint {
    StudyPoint point = {};
    std::string reason = {};
    bool cancelled = false;
};

/// Makes of each grid point what its changes reach, and takes the rest over from the unchanged project.
class GridWalker {
public:
    explicit GridWalker(const StudyPlan& plan);
    EvaluatedPoint evaluate(std::size_t point, const std::function<bool(std::uint64_t)>& advance);

private:
    void change(const std::vector<std::size_t>& indices);
    EvaluatedPoint of_grid_point(const std::vector<std::size_t>& indices,
                                 const std::function<bool(std::uint64_t)>& advance);
    EvaluatedPoint of_model(const MeasurementModel& model, InputSet inputs,
                            const std::function<bool(std::uint64_t)>& advance);
    void add_places(const Layout& layout, const std::vector<std::size_t>& indices,
                    const EvaluationSummary& summary, StudyPoint& point) const;

    const StudyPlan& plan_;
    Project project_;             ///< with the changes of the point
    std::vector<double> values_;  ///< of the axes at the point
};

}  // namespace covaria::detail
