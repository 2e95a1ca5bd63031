// Analyses that feed analyses: input quantities whose values are outputs of other analyses.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/model/measurement_model.h"
#include "core/project/project.h"

namespace covaria {

/// An input quantity of an analysis as its chain gives it, by the law of propagation.
struct LinkedInput {
    std::string symbol;
    Message name;
    Unit unit = {};
    std::string analysis, analysis_name;
    OutputQuantity output;
    bool linearised = false;
    double estimate = 0.0;
    double standard_uncertainty = 0.0;
    double degrees_of_freedom = 0.0;
};

/// Three linked inputs that are the coordinates of a point in the layout of the analysis.
struct LinkedPoint {
    std::array<std::size_t, 3> links = {};  ///< places as in LayoutPoint::links
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The message for a chain of more analyses than are made into one.
Message chain_too_long();

/// The quantities that an analysis takes from others.
struct LinkedQuantities {
    std::vector<LinkedInput> inputs = {};  ///< inputs in the order of the links
    std::vector<LinkedPoint> points = {};
};

/// A model with its inputs, edits applied; no model after an error (paths relative to the analysis).
struct ModelOfAnalysis {
    std::shared_ptr<const MeasurementModel> model;
    InputSet inputs;
};

/// The model of an entry by itself, edits applied; no model after an error (paths relative to the analysis).
using MakeOwnModel = std::function<ModelOfAnalysis(const AnalysisEntry& entry, Problems& problems)>;

/// The model of an analysis, with the analyses that it takes outputs from, directly or through others, in
/// front of `own`: one model, whose inputs go down to those that nothing is taken for. Without links it is
/// `own` itself. No model after an error: unknown analysis, output or input, another dimension, an input that
/// is edited as well, a circle (with its path).
ModelOfAnalysis compose_analysis(const Project& project, const AnalysisEntry& entry, ModelOfAnalysis own,
                                 const MakeOwnModel& make_own, Problems& problems);

/// Whether `compose_analysis` puts anything in front of the model with these inputs.
bool has_links(const AnalysisEntry& entry, const InputSet& inputs);

/// Ids of the analyses that this one takes outputs from, directly or through others; in project order.
std::vector<std::string> analyses_used_by(const Project& project, const AnalysisEntry& analysis);
/// Ids of the analyses that take something from this one, directly or through others; in project order.
std::vector<std::string> analyses_taking_from(const Project& project, const std::string& analysis_id);
/// Adds to `part`, behind its analyses, those that `analysis` takes outputs from, with all that influences
/// numbers.
void add_used_analyses(const Project& project, const AnalysisEntry& analysis, Project& part);

/// The quantities that the last analysis of a chain takes from others, by the law of propagation. Empty for a
/// model that is no chain, or has no value at its estimates.
LinkedQuantities quantities_of_links(const MeasurementModel& model);

}  // namespace covaria
