// A serial robot from plain data: an asset, or what an identification found.
#pragma once

#include "core/kinds/robot/serial_robot.h"
#include "core/model/asset.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// A parameter that is an output of an analysis.
struct ParameterOutput {
    std::size_t joint = 0;
    JointParameter parameter = JointParameter::theta;
    OutputReference output;
};

struct RobotData {
    DhConvention convention = DhConvention::modified;
    std::vector<RobotJoint> joints;
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity(), X_FT = Eigen::Isometry3d::Identity();
    std::vector<ParameterDeviation> deviations;
    std::vector<DeviationCorrelation> correlations;
    std::vector<double> u_encoder, u_repeatability;  ///< one for each joint, rad or m
    double u_tool_position = 0.0, u_tool_angle = 0.0;
    std::vector<ParameterOutput> outputs = {};
};

class RobotSource : public SerialRobotSource {
public:
    explicit RobotSource(RobotData data) : data_(std::move(data)) {}
    DhConvention convention() const override { return data_.convention; }
    const std::vector<RobotJoint>& joints() const override { return data_.joints; }
    const Eigen::Isometry3d& X_WB() const override { return data_.X_WB; }
    const Eigen::Isometry3d& X_FT() const override { return data_.X_FT; }
    const std::vector<ParameterDeviation>& deviations() const override { return data_.deviations; }
    const std::vector<DeviationCorrelation>& correlations() const override { return data_.correlations; }
    std::optional<OutputReference> taken_from(std::size_t joint, JointParameter parameter) const override;
    std::vector<UncertaintyComponent> reading(std::size_t joint) const override;
    std::vector<UncertaintyComponent> tool() const override;

private:
    RobotData data_;
};

class RobotAsset : public Asset {
public:
    explicit RobotAsset(RobotData data) : source_(std::move(data)) { offer(source_); }
    /// The table of its parameters.
    std::vector<Table> evaluation() const override;
    /// The arm at the zero readings.
    Layout layout() const override;

private:
    RobotSource source_;
};

}  // namespace covaria
