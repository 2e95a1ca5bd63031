// Identification of an arm by joint trajectories: points measured while one joint after the other turns
// (circle point analysis; Wen et al., 2.1.2 to 2.1.4). Shared by the asset and the measurement model.
#pragma once

#include <optional>

#include "core/kinds/points/component_evidence.h"
#include "core/kinds/points/located_points.h"
#include "core/kinds/robot/fields.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/identified_parameters.h"
#include "core/math/axis_frames.h"
#include "core/math/circle_fit.h"
#include "core/model/output_quantity.h"
#include "core/quantity/input_quantity.h"

namespace covaria::circle_points {

/// Points measured while one joint turns.
struct Trajectory {
    std::vector<Eigen::Vector3d> points;  ///< world frame, m
    std::vector<std::size_t> rows;        ///< their rows in the table; empty when simulated
    std::size_t first_input = 0;          ///< index of x of the first point; three for each
    CircleShape shape;
};

/// A row of the measured points, SI.
struct StatedPoint {
    std::size_t joint = 0;    ///< number of the joint from 1
    std::optional<double> q;  ///< reading of the joint
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// The set-up as typed, SI.
struct StatedIdentification {
    Offered<SerialRobotSource> nominal;
    bool simulated = true;
    std::vector<StatedPoint> points;
    double half_range = 0.0;  ///< simulated: range, points for each joint, place of the ball
    std::size_t point_count = 0;
    Eigen::Isometry3d ball = Eigen::Isometry3d::Identity();
    PointLocator locator;
    PlaneFit plane = PlaneFit::total_least_squares;
    double parallel_limit = 0.0;
    evidence::UncertaintiesFrom uncertainties = evidence::UncertaintiesFrom::stated;

    const SerialRobotSource& robot() const { return *nominal; }
};
const Fields<StatedIdentification>& fields();

struct Identification : StatedIdentification {
    explicit Identification(StatedIdentification stated) : StatedIdentification(std::move(stated)) {}
    std::vector<Trajectory> trajectories;  ///< one for each joint
    AxisStructure structure;
    std::vector<IdentifiedParameter> parameters;
    std::vector<HeldParameter> missing;
    InputSet inputs;
    ComponentEvidence evidence;  ///< evidence about the stated uncertainties
};

/// Distances of the measured points from their circles, along the normal and along the radius.
ComponentEvidence evidence_of(const Identification& id);

/// Empty if `problems` got an error.
std::optional<Identification> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems);

/// Circles of all joints, then the parameters in the order of `parameters`, and the radii.
template <class Real, class In, class Set>
mask_of<Real> evaluate(const Identification& id, const In& x, Set set) {
    const std::size_t n = id.trajectories.size();
    std::array<AxisLine<Real>, most_joints> axes;
    std::array<AxisFrame<Real>, most_joints> frames;
    mask_of<Real> valid(true);
    for (std::size_t j = 0; j < n; ++j) {
        const Trajectory& t = id.trajectories[j];
        const auto point = [&](std::size_t k) {
            const std::size_t i = t.first_input + 3 * k;
            return Vector3<Real>(Real(x[i]), Real(x[i + 1]), Real(x[i + 2]));
        };
        const SpaceCircle<Real> circle = fit_circle<Real>(t.shape.start, point, t.points.size(), id.plane);
        axes[j] = {circle.centre, circle.normal};
        valid = valid && circle.converged;
        set(id.parameters.size() + j, circle.radius);
    }
    frames_from_axes(axes.data(), n, id.structure, frames.data());
    std::size_t out = 0;
    for (std::size_t j = 0; j + 1 < n; ++j) {
        const JointValues<Real> v = parameters_between(frames[j], frames[j + 1], id.structure.pair(j));
        for (; out < id.parameters.size() && id.parameters[out].joint == j; ++out)
            set(out, v[id.parameters[out].parameter]);
    }
    return valid;
}

/// Parameters at the estimates of the inputs, in SI, angles next to the nominal ones. Empty: no value.
std::optional<std::vector<double>> estimates(const Identification& id);
/// Circles, parameters beside the nominal ones, what is not identified and why.
std::vector<Table> tables(const Identification& id);
Layout layout(const Identification& id);
/// The arm with the identified parameters. Empty: the points do not lead to them.
std::optional<RobotData> identified(const Identification& id);

}  // namespace covaria::circle_points
