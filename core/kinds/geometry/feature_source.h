// Capability "features": results of an analysis as places and directions, with their estimates.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/kinds/points/output_points.h"
#include "core/model/measurement_model.h"

namespace covaria {

class FeatureSource : public Capability {
public:
    static constexpr const char* capability = "features";
    static constexpr const char* lacking = "has no features as results";
    /// Place of the feature of this name at the estimates of the analysis, as its set-up states it; empty:
    /// there is none, or it has no value.
    virtual std::optional<Eigen::Vector3d> place(const std::string& feature) const = 0;
    /// Direction of the feature; empty: it has none.
    virtual std::optional<Eigen::Vector3d> direction(const std::string& feature) const = 0;
};

/// The features of a model: every group of outputs with lengths x, y and z is one of that name, and with
/// n_x, n_y and n_z one with a direction. It is a point too, whose deviations are those of the outputs.
class OutputFeatures : public OutputPoints, public FeatureSource {
public:
    OutputFeatures(std::string analysis, const MeasurementModel& model);

    std::optional<Eigen::Vector3d> place(const std::string& feature) const override;
    std::optional<Eigen::Vector3d> direction(const std::string& feature) const override;

private:
    struct Placed {
        std::optional<Eigen::Vector3d> place, direction;
    };
    std::map<std::string, Placed> features_;
};

}  // namespace covaria
