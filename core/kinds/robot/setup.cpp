// Reads the set-up of "robot pose".
#include "core/kinds/robot/setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/kinds/robot/inverse_kinematics.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/math/rotation.h"
#include "core/text/numbers.h"

namespace covaria::robot {

namespace {

std::string reading_text(const RobotJoint& joint, double reading) {
    return format_short(joint.reading_unit().from_si(reading), 4) + (joint.slides ? " mm" : "°");
}

class PoseReading {
public:
    PoseReading(PoseSetup stated, Problems& problems) : problems_(problems), read_(std::move(stated)) {}

    std::optional<PoseSetup> read() {
        for (const RobotJoint& joint : read_.robot().joints()) previous_.push_back(joint.zero);
        for (std::size_t row = 0; row < read_.stated.size(); ++row) read_pose(row);
        for (std::size_t row = 0; row < read_.places.size() && !problems_.has_errors(); ++row)
            read_place(row);
        if (read_.poses.empty())
            problems_.error(pose_fields().place(&PoseSetup::stated),
                            tell<"there is no pose: give joint readings or a place of the tool">());
        if (problems_.has_errors()) return {};
        return std::move(read_);
    }

private:
    void add(Pose pose) {
        if (!names_.insert(pose.name).second)
            problems_.error(pose.source, tell<"two poses are called %1">(pose.name));
        for (std::size_t i = 0; i < pose.q.size(); ++i) warn_of_limits(pose, i);
        warn_of_singular_angles(pose);
        previous_ = pose.q;
        read_.poses.push_back(std::move(pose));
    }

    void warn_of_limits(const Pose& pose, std::size_t i) {
        const RobotJoint& joint = read_.robot().joints()[i];
        if (pose.q[i] >= joint.low - 1e-9 && pose.q[i] <= joint.high + 1e-9) return;
        problems_.warning(pose.source, tell<"pose %1: reading %2 of joint %3 is beyond its limits, %4 to %5">(
                                           pose.name, reading_text(joint, pose.q[i]), i + 1,
                                           reading_text(joint, joint.low), reading_text(joint, joint.high)));
    }

    void warn_of_singular_angles(const Pose& pose) {
        if (!read_.orientation) return;
        const Eigen::Matrix3d R = link_frames(read_.robot(), pose.q).back().linear();
        if (regularity(*read_.orientation, R) > std::sin(2.0 * std::numbers::pi / 180.0)) return;
        problems_.warning(pose.source,
                          tell<"pose %1: the orientation is within 2° of one that %2 cannot state (gimbal "
                               "lock, half turn); state it otherwise">(
                              pose.name, Message::declared(rotation_convention(*read_.orientation).title)));
    }

    void read_pose(std::size_t row) {
        const StatedPose& stated = read_.stated[row];
        Pose pose{.name = stated.name, .source = pose_fields().place(&PoseSetup::stated, row)};
        const auto& joints = read_.robot().joints();
        for (std::size_t i = 0; i < std::min(joints.size(), most_joints); ++i)
            pose.q.push_back((joints[i].slides ? stated.s : stated.q)[i].value_or(joints[i].zero));
        for (std::size_t i = 0; i < most_joints; ++i)
            for (const auto readings : {&StatedPose::q, &StatedPose::s})
                if ((stated.*readings)[i]) refuse_unused(row, readings, i);
        add(std::move(pose));
    }

    void refuse_unused(std::size_t row, StatedReadings StatedPose::*readings, std::size_t i) {
        const auto& joints = read_.robot().joints();
        const std::size_t n = joints.size();
        if (i < n && joints[i].slides == (readings == &StatedPose::s)) return;
        const auto& fields = pose_fields();
        const std::string place = fields.place(&PoseSetup::stated, row, readings, i);
        if (i >= n)
            return problems_.error(
                place, tell<"%1 has only %2 joints; leave %3 empty">(
                           read_.arm.name, n, fields.columns(&PoseSetup::stated).key(readings, i)));
        const std::string symbol = reading_symbol(read_.robot(), i);
        problems_.error(place,
                        joints[i].slides
                            ? tell<"joint %1 of %2 slides: its reading is %3">(i + 1, read_.arm.name, symbol)
                            : tell<"joint %1 of %2 turns: its reading is %3">(i + 1, read_.arm.name, symbol));
    }

    void read_place(std::size_t row) {
        const auto& [name, position, angles] = read_.places[row];
        const std::string path = pose_fields().place(&PoseSetup::places, row);
        Target target;
        target.position = position;
        if (angles[0] && angles[1] && angles[2])
            target.orientation = rotation_from_zyx<double>({*angles[0], *angles[1], *angles[2]});
        else if (angles[0] || angles[1] || angles[2])
            return problems_.error(path, tell<"pose %1: give all three angles or none">(name));
        InverseSolution found = solve_inverse(read_.robot(), target, previous_);
        if (found.q.empty()) return refuse(name, path, found.distance);
        add({.name = name, .source = path, .q = std::move(found.q)});
    }

    void refuse(const std::string& name, const std::string& path, double distance) {
        const std::string text = format_short(1e3 * distance) + " mm";
        problems_.error(
            path, distance < 1e-6
                      ? tell<"pose %1: no readings within the limits of the joints bring the tool there; the "
                             "nearest attempt misses the place by %2 but not the orientation">(name, text)
                      : tell<"pose %1: no readings within the limits of the joints bring the tool there; the "
                             "nearest attempt misses the place by %2">(name, text));
    }

    Problems& problems_;
    PoseSetup read_;
    std::vector<double> previous_;
    std::set<std::string> names_;
};

bool has_parameters_of_analysis(const SerialRobotSource& robot) {
    for (std::size_t i = 0; i < robot.joints().size(); ++i)
        for (JointParameter p : joint_parameters)
            if (robot.taken_from(i, p)) return true;
    return false;
}

}  // namespace

std::optional<PoseSetup> read_pose_setup(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    PoseSetup stated = pose_fields().read(setup, assets, problems);
    if (!stated.arm) return {};
    if (!stated.correlated && has_parameters_of_analysis(*stated.arm))
        problems.warning(
            pose_fields().place(&PoseSetup::correlated),
            tell<"the parameters come from an analysis, which is evaluated in every trial: their "
                 "correlation cannot be ignored">());
    return PoseReading(std::move(stated), problems).read();
}

std::vector<Table> pose_evaluation(const PoseSetup& setup) {
    Table table{"poses", "Readings and places of the poses, without uncertainty"};
    table.add("pose");
    const std::size_t n = setup.robot().joints().size();
    for (std::size_t i = 0; i < n; ++i)
        table.add(reading_symbol(setup.robot(), i)).in(setup.robot().joints()[i].reading_unit()).symbol();
    for (const char* axis : {"x", "y", "z"}) table.add(axis).in(Unit::of("mm")).symbol();
    for (const Pose& pose : setup.poses) {
        std::vector<Cell> row{pose.name};
        for (double q : pose.q) row.emplace_back(q);
        const Eigen::Vector3d p = link_frames(setup.robot(), pose.q).back().translation();
        for (int k = 0; k < 3; ++k) row.emplace_back(p[k]);
        table.row(std::move(row));
    }
    table.notes.push_back(tell<"Places of the tool in the base frame of the robot.">());
    return {table};
}

}  // namespace covaria::robot
