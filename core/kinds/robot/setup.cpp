// Reads the set-up of "robot pose".
#include "core/kinds/robot/setup.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "core/kinds/robot/inverse_kinematics.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/math/rotation.h"

namespace covaria::robot {

namespace {

std::string reading_text(const RobotJoint& joint, double reading) {
    char text[32];
    std::snprintf(text, sizeof text, joint.slides ? "%.4g mm" : "%.4g°",
                  joint.reading_unit().from_si(reading));
    return text;
}

class PoseReading {
public:
    PoseReading(const SetupReader& setup, const AssetLibrary& assets, Problems& problems)
        : setup_(setup), assets_(assets), problems_(problems) {}

    std::optional<PoseSetup> read() {
        if (!read_robot()) return {};
        const std::string orientation = setup_.text("orientation");
        if (orientation != "none") read_.orientation = rotation_convention_from(orientation);
        read_.in_world = setup_.text("frame") == "world";
        read_.combine = setup_.text("components") == "combined";
        read_.correlated = setup_.text("correlation") == "used";
        for (std::size_t row = 0; row < setup_.rows("poses"); ++row) read_pose(row);
        for (std::size_t row = 0; row < setup_.rows("targets") && !problems_.has_errors(); ++row)
            read_target(row);
        if (read_.poses.empty())
            problems_.error("/poses", "there is no pose: give joint readings or a place of the tool");
        if (problems_.has_errors()) return {};
        return std::move(read_);
    }

private:
    bool read_robot() {
        const std::string id = setup_.text("robot");
        const AssetLibrary::Entry* entry = assets_.find(id);
        if (!offers<SerialRobotSource>(entry)) {
            problems_.error("/robot", "'" + id + "' is no serial robot");
            return false;
        }
        read_.asset = entry->asset;
        read_.asset_id = id;
        read_.asset_name = entry->name.empty() ? id : entry->name;
        for (const RobotJoint& joint : read_.robot().joints()) previous_.push_back(joint.zero);
        return true;
    }

    void add(Pose pose) {
        if (!names_.insert(pose.name).second)
            problems_.error(pose.source, "two poses are called " + pose.name);
        for (std::size_t i = 0; i < pose.q.size(); ++i) warn_of_limits(pose, i);
        warn_of_singular_angles(pose);
        previous_ = pose.q;
        read_.poses.push_back(std::move(pose));
    }

    void warn_of_limits(const Pose& pose, std::size_t i) {
        const RobotJoint& joint = read_.robot().joints()[i];
        if (pose.q[i] >= joint.low - 1e-9 && pose.q[i] <= joint.high + 1e-9) return;
        problems_.warning(pose.source, "pose " + pose.name + ": reading " + reading_text(joint, pose.q[i]) +
                                           " of joint " + std::to_string(i + 1) + " is beyond its limits, " +
                                           reading_text(joint, joint.low) + " to " +
                                           reading_text(joint, joint.high));
    }

    void warn_of_singular_angles(const Pose& pose) {
        if (!read_.orientation) return;
        const Eigen::Matrix3d R = link_frames(read_.robot(), pose.q).back().linear();
        if (regularity(*read_.orientation, R) > std::sin(2.0 * std::numbers::pi / 180.0)) return;
        problems_.warning(pose.source, "pose " + pose.name + ": the orientation is within 2° of one that " +
                                           std::string(rotation_convention(*read_.orientation).title) +
                                           " cannot state (gimbal lock, half turn); state it otherwise");
    }

    void read_pose(std::size_t row) {
        Pose pose{.name = setup_.cell_text("poses", row, "name"),
                  .source = "/poses/rows/" + std::to_string(row)};
        const auto& joints = read_.robot().joints();
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const std::string column = reading_symbol(read_.robot(), i);
            const bool empty = setup_.cell_empty("poses", row, column);
            pose.q.push_back(empty ? joints[i].zero : setup_.cell_number("poses", row, column));
        }
        for (std::size_t i = 0; i < most_joints; ++i)
            for (const char* letter : {"q_", "s_"}) refuse_unused(row, letter + std::to_string(i + 1), i);
        add(std::move(pose));
    }

    void refuse_unused(std::size_t row, const std::string& column, std::size_t i) {
        const std::size_t n = read_.robot().joints().size();
        if (setup_.cell_empty("poses", row, column)) return;
        if (i < n && column == reading_symbol(read_.robot(), i)) return;
        problems_.error("/poses/rows/" + std::to_string(row) + "/" + column,
                        i >= n ? read_.asset_name + " has only " + std::to_string(n) + " joints; leave " +
                                     column + " empty"
                               : "joint " + std::to_string(i + 1) + " of " + read_.asset_name +
                                     (read_.robot().joints()[i].slides ? " slides" : " turns") +
                                     ": its reading is " + reading_symbol(read_.robot(), i));
    }

    void read_target(std::size_t row) {
        const std::string path = "/targets/rows/" + std::to_string(row);
        Target target;
        target.position = setup_.cell_vector("targets", row, "x");
        Eigen::Vector3d angles = Eigen::Vector3d::Zero();
        int given = 0;
        static const char* const columns[] = {"alpha", "beta", "gamma"};
        for (int k = 0; k < 3; ++k) {
            if (setup_.cell_empty("targets", row, columns[k])) continue;
            angles[k] = setup_.cell_number("targets", row, columns[k]);
            ++given;
        }
        const std::string name = setup_.cell_text("targets", row, "name");
        if (given != 0 && given != 3)
            return problems_.error(path, "pose " + name + ": give all three angles or none");
        if (given == 3) target.orientation = rotation_from_zyx<double>(angles);
        InverseSolution found = solve_inverse(read_.robot(), target, previous_);
        if (found.q.empty()) return refuse(name, path, found.distance);
        add({.name = name, .source = path, .q = std::move(found.q)});
    }

    void refuse(const std::string& name, const std::string& path, double distance) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3g mm", 1e3 * distance);
        problems_.error(path, "pose " + name +
                                  ": no readings within the limits of the joints bring the tool there; the "
                                  "nearest attempt misses the place by " +
                                  text + (distance < 1e-6 ? " but not the orientation" : ""));
    }

    const SetupReader& setup_;
    const AssetLibrary& assets_;
    Problems& problems_;
    PoseSetup read_;
    std::vector<double> previous_;
    std::set<std::string> names_;
};

}  // namespace

std::optional<PoseSetup> read_pose_setup(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    return PoseReading(setup, assets, problems).read();
}

std::vector<DataTable> pose_evaluation(const PoseSetup& setup) {
    DataTable table;
    table.id = "poses";
    table.title = "Readings and places of the poses, without uncertainty";
    table.columns = {{.header = "pose"}};
    const std::size_t n = setup.robot().joints().size();
    for (std::size_t i = 0; i < n; ++i)
        table.columns.push_back({.header = reading_symbol(setup.robot(), i),
                                 .unit = setup.robot().joints()[i].reading_unit(),
                                 .is_symbol = true});
    for (const char* axis : {"x", "y", "z"})
        table.columns.push_back({.header = axis, .unit = Unit::of("mm"), .is_symbol = true});
    for (const Pose& pose : setup.poses) {
        std::vector<TableCell> row{pose.name};
        for (double q : pose.q) row.emplace_back(q);
        const Eigen::Vector3d p = link_frames(setup.robot(), pose.q).back().translation();
        for (int k = 0; k < 3; ++k) row.emplace_back(p[k]);
        table.rows.push_back(std::move(row));
    }
    table.notes.push_back("Places of the tool in the base frame of the robot.");
    return {table};
}

}  // namespace covaria::robot
