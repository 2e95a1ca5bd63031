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

/// Keeps copies of what it changes, so that a point costs no more than its changes.
class GridWalker {
public:
    explicit GridWalker(const StudyPlan& plan);
    EvaluatedPoint evaluate(std::size_t point, const std::function<bool(std::uint64_t)>& advance);

private:
    void change(const std::vector<std::size_t>& indices);
    bool make_assets(Problems& problems);
    EvaluatedPoint of_grid_point(const std::vector<std::size_t>& indices,
                                 const std::function<bool(std::uint64_t)>& advance);
    EvaluatedPoint of_model(const ModelOfAnalysis& made, const std::function<bool(std::uint64_t)>& advance);
    void add_places(const ModelOfAnalysis& made, const std::vector<std::size_t>& indices,
                    const EvaluationSummary& summary, StudyPoint& point) const;

    const StudyPlan& plan_;
    AnalysisEntry entry_;
    std::vector<AssetEntry> changed_assets_;  ///< copies of those with an axis and those that refer to them
    std::vector<std::size_t> asset_of_axis_;  ///< into changed_assets_
    AssetLibrary library_;
    std::vector<double> values_;  ///< of the axes at the point
};

}  // namespace covaria::detail
