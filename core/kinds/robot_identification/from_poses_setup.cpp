// Reads the poses of a calibration, their uncertainty and what is to be fitted.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/from_poses_fit.h"
#include "core/kinds/robot_identification/reading_figures.h"
#include "core/quantity/input_quantity.h"

namespace covaria::pose_calibration {

namespace {

void refuse_unused(const Calibration& c, std::size_t row, StatedReadings StatedPose::*readings, std::size_t j,
                   Problems& problems) {
    const auto& joints = c.robot().joints();
    const std::string place = fields().place(&Calibration::measured, row, readings, j);
    if (j >= joints.size())
        return problems.error(place,
                              tell<"the robot has only %1 joints; leave %2 empty">(
                                  joints.size(), fields().columns(&Calibration::measured).key(readings, j)));
    if (joints[j].slides == (readings == &StatedPose::s)) return;
    const std::string symbol = reading_symbol(c.robot(), j);
    problems.error(place, joints[j].slides ? tell<"joint %1 slides: its reading is %2">(j + 1, symbol)
                                           : tell<"joint %1 turns: its reading is %2">(j + 1, symbol));
}

/// Poses spread over the range of every joint need one.
void refuse_without_range(const Calibration& c, Problems& problems) {
    const auto& joints = c.robot().joints();
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints[j].slides && !(std::isfinite(joints[j].low) && std::isfinite(joints[j].high)))
            problems.error(
                fields().place(&Calibration::nominal),
                tell<"joint %1 slides: without its limits there is no range over which poses could "
                     "be simulated">(j + 1));
}

class Reading {
public:
    Reading(StatedCalibration stated, Problems& problems) : problems_(problems), c_(std::move(stated)) {}

    std::optional<Calibration> read() {
        c_.X_MB = c_.robot().X_WB();
        c_.X_FT = c_.ball;
        if (c_.simulated)
            simulate();
        else
            for (std::size_t row = 0; row < c_.measured.size(); ++row) read_pose(row);
        if (problems_.has_errors()) return {};
        std::stable_partition(c_.poses.begin(), c_.poses.end(),
                              [](const MeasuredPose& pose) { return !pose.check; });
        c_.fitted_poses = static_cast<std::size_t>(
            std::count_if(c_.poses.begin(), c_.poses.end(), [](const MeasuredPose& p) { return !p.check; }));
        if (c_.fitted_poses < 3) {
            problems_.error(
                fields().place(&Calibration::measured),
                tell<"the fit has %1 poses; it needs three or more, and about twenty to tell all parameters">(
                    c_.fitted_poses));
            return {};
        }
        add_inputs();
        list_unknowns();
        if (problems_.has_errors()) return {};
        const bool seen = !c_.simulated && c_.uncertainties != evidence::UncertaintiesFrom::stated;
        const ComponentEvidence evidence = seen ? evidence_as_stated(c_) : ComponentEvidence();
        if (seen)
            take_as_seen(c_.inputs, evidence, c_.uncertainties, fields().place(&Calibration::uncertainties),
                         problems_);
        if (!fit(c_, problems_)) return {};
        if (seen) c_.statistics.evidence = evidence;
        return std::move(c_);
    }

private:
    void add_pose(MeasuredPose pose) {
        const auto& joints = c_.robot().joints();
        for (std::size_t j = 0; j < joints.size(); ++j)
            pose.turns.push_back(joints[j].slides ? Turn<double>()
                                                  : Turn<double>(travel_of(joints, j, pose.q)));
        pose.reading.fill(no_input);
        c_.poses.push_back(std::move(pose));
    }

    /// An additive recurrence over the range of every joint (Roberts' sequence): evenly spread, and the first
    /// of more poses are those of fewer.
    void simulate() {
        const auto& joints = c_.robot().joints();
        refuse_without_range(c_, problems_);
        if (problems_.has_errors()) return;
        double g = 2.0;  // root of g^(n+1) = g + 1
        for (int k = 0; k < 40; ++k) g = std::pow(1.0 + g, 1.0 / static_cast<double>(joints.size() + 1));
        for (int k = 0; k < c_.pose_count; ++k) {
            MeasuredPose pose{.name = "P" + std::to_string(k + 1)};
            for (std::size_t j = 0; j < joints.size(); ++j) {
                const double range = joints[j].slides ? infinity : c_.half_range;
                const double low = std::max(joints[j].low, joints[j].zero - range);
                const double high = std::min(joints[j].high, joints[j].zero + range);
                const double share = std::fmod(0.5 + (k + 1) * std::pow(g, -static_cast<double>(j + 1)), 1.0);
                pose.q.push_back(low + share * (high - low));
            }
            const Eigen::Isometry3d X = c_.X_MB * link_frames(c_.robot(), pose.q)[joints.size()] * c_.X_FT;
            pose.p = X.translation();
            pose.R = X.linear();
            add_pose(std::move(pose));
        }
    }

    void read_pose(std::size_t row) {
        const StatedPose& stated = c_.measured[row];
        const auto& joints = c_.robot().joints();
        MeasuredPose pose{.name = stated.name,
                          .source = fields().place(&Calibration::measured, row),
                          .check = stated.check};
        if (!names_.insert(pose.name).second)
            problems_.error(pose.source, tell<"two poses are called %1">(pose.name));
        for (std::size_t j = 0; j < std::min(joints.size(), most_joints); ++j)
            pose.q.push_back((joints[j].slides ? stated.s : stated.q)[j].value_or(joints[j].zero));
        for (std::size_t j = 0; j < most_joints; ++j)
            for (const auto readings : {&StatedPose::q, &StatedPose::s})
                if ((stated.*readings)[j]) refuse_unused(c_, row, readings, j, problems_);
        pose.p = stated.p;
        if (c_.with_orientation) read_orientation(stated.angles, pose);
        add_pose(std::move(pose));
    }

    void read_orientation(const std::array<std::optional<double>, 3>& angles, MeasuredPose& pose) {
        if (!angles[0] || !angles[1] || !angles[2])
            return problems_.error(pose.source,
                                   tell<"pose %1: its orientation is missing; give alpha, beta and gamma of "
                                        "every pose, or fit positions alone">(pose.name));
        pose.R = rotation_from_zyx<double>({*angles[0], *angles[1], *angles[2]});
    }

    void add_inputs() {
        std::vector<LocatedPoint> points;
        for (std::size_t k = 0; k < c_.poses.size(); ++k) points.push_back(add_coordinates(k));
        add_point_components(c_.locator, points, c_.inputs, problems_);
        for (std::size_t k = 0; k < c_.poses.size(); ++k) add_readings(k);
    }

    LocatedPoint add_coordinates(std::size_t k) {
        static const char* const axes[] = {"x", "y", "z"};
        static const char* const angles[] = {"alpha", "beta", "gamma"};
        MeasuredPose& pose = c_.poses[k];
        pose.first_input = c_.inputs.quantities.size();
        const LocatedPoint point{pose.p, std::to_string(k + 1), pose.first_input, pose.name};
        for (std::size_t i = 0; i < c_.rows_per_pose(); ++i) {
            const bool turn = i >= 3;
            const std::string symbol = std::string(turn ? angles[i - 3] : axes[i]) + "_" + point.label;
            InputQuantity quantity{.symbol = symbol,
                                   .name = turn ? tell<"pose %1, rotation about %2">(pose.name, axes[i % 3])
                                                : tell<"pose %1, %2">(pose.name, axes[i % 3]),
                                   .unit = Unit::of(turn ? "deg" : "mm"),
                                   .offset = turn ? 0.0 : pose.p[static_cast<Eigen::Index>(i)],
                                   .group = "pose " + pose.name,
                                   .source = pose.source};
            quantity.tags = {
                {"kind", turn ? own_name<"measured orientations">() : own_name<"measured positions">()}};
            if (turn)
                c_.inputs.add(std::move(quantity), {{.id = symbol + ".orientation",
                                                     .name = tell<"measured orientation">(),
                                                     .unit = Unit::of("deg"),
                                                     .distribution = Distribution::normal(c_.u_angle),
                                                     .origin = tell<"typed standard uncertainty">()}});
            else
                c_.inputs.quantities.push_back(std::move(quantity));
        }
        return point;
    }

    void add_readings(std::size_t k) {
        MeasuredPose& pose = c_.poses[k];
        for (std::size_t j = 0; j < pose.q.size(); ++j) {
            std::vector<UncertaintyComponent> components = c_.robot().reading(j);
            if (components.empty()) continue;
            const std::string symbol = reading_symbol(c_.robot(), j) + "," + std::to_string(k + 1);
            InputQuantity quantity{.symbol = symbol,
                                   .name = tell<"pose %1, reading of joint %2">(pose.name, j + 1),
                                   .unit = c_.robot().joints()[j].reading_unit(),
                                   .offset = pose.q[j],
                                   .group = "pose " + pose.name,
                                   .source = pose.source};
            quantity.tags = {{"kind", own_name<"readings of the joints">()}};
            for (UncertaintyComponent& component : components) component.id = symbol + "." + component.id;
            pose.reading[j] = c_.inputs.add(std::move(quantity), std::move(components));
        }
    }

    /// Lists all that could be fitted; the fit takes out what the poses cannot tell.
    void list_unknowns() {
        for (std::size_t k = 0; c_.base_fitted && k < 6; ++k)
            c_.unknowns.push_back({.kind = UnknownKind::base, .coordinate = k});
        for (std::size_t k = 0; c_.tool_fitted && k < c_.rows_per_pose(); ++k)
            c_.unknowns.push_back({.kind = UnknownKind::tool, .coordinate = k});
        std::set<std::string> held;
        for (const HeldByUser& row : c_.held_by_user) held.insert(row.parameter);
        const auto& joints = c_.robot().joints();
        for (std::size_t j = 0; j < joints.size(); ++j)
            for (JointParameter p : joint_parameters) {
                const IdentifiedParameter parameter{j, p};
                if (p == JointParameter::d && joints[j].parallel)
                    c_.held.push_back({parameter.symbol(), parallel_to_the_next()});
                if (!joints[j].has(p)) continue;
                if (held.erase(parameter.symbol()) > 0)
                    c_.held.push_back({parameter.symbol(), "held at its nominal value by the set-up"});
                else
                    c_.unknowns.push_back({.kind = UnknownKind::parameter, .parameter = parameter});
            }
        for (const std::string& symbol : held)
            problems_.error(
                fields().place(&Calibration::held_by_user),
                tell<"the robot has no parameter '%1' to hold; write its symbol, such as d_3">(symbol));
    }

    Problems& problems_;
    Calibration c_;
    std::set<std::string> names_;
};

}  // namespace

std::optional<Calibration> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    StatedCalibration stated = fields().read(setup, assets, problems);
    if (problems.has_errors()) return {};
    return Reading(std::move(stated), problems).read();
}

}  // namespace covaria::pose_calibration
