// An analysis of a made project, ready to be evaluated.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/run_control.h"
#include "core/model/asset.h"
#include "core/model/model_descriptor.h"
#include "core/project/links.h"
#include "core/project/project.h"
#include "core/propagation/options.h"
#include "core/propagation/propagated.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// Everything that influences the numbers of an analysis: itself, the assets and analyses that it uses.
class AnalysisNumbers {
public:
    AnalysisNumbers(std::shared_ptr<const Project> project, std::string analysis);
    /// Made when it is first asked for.
    const std::string& fingerprint() const;
    bool operator==(const AnalysisNumbers& other) const;

private:
    Project part() const;

    std::shared_ptr<const Project> project_;
    std::string analysis_;
    mutable std::once_flag once_;
    mutable std::string fingerprint_;
};

/// Immutable and safe to hand to a worker thread; copies share what is large.
struct PreparedAnalysis {
    std::string id;
    std::string name;
    const ModelDescriptor* descriptor;
    AssetLibrary assets;  ///< assets that it uses; kept alive for the model, which may refer to them
    std::shared_ptr<const PropagatedModel> propagated;
    std::shared_ptr<const MeasurementModel> model;
    const InputSet& inputs;                ///< the model's, with the analysis' edits and correlations applied
    std::vector<LinkedInput> linked = {};  ///< inputs taken from other analyses: they are not in `inputs`
    std::vector<LinkedPoint> linked_points = {};  ///< those of them that are a point of the layout
    EvaluationOptions options;
    ResultStyle style = {};  ///< style that the project states
    std::shared_ptr<const AnalysisNumbers> numbers;
    Message forecast = {};  ///< how many trials an adaptive run needs, in words; empty for other methods

    /// Fingerprint of everything that influences this analysis' numbers (its assets included).
    const std::string& fingerprint() const { return numbers->fingerprint(); }
};

/// Results of the one are results of the other.
bool same_numbers(const PreparedAnalysis& a, const PreparedAnalysis& b);

/// Evaluates and fills in provenance.
Result<UncertaintyResult> run_analysis(const PreparedAnalysis& analysis, const RunControl& control = {});

}  // namespace covaria
