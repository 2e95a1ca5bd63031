// Reads the poses of a calibration, their uncertainty and what is to be fitted.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/from_poses_fit.h"
#include "core/quantity/input_quantity.h"

namespace covaria::pose_calibration {

namespace {

class Reading {
public:
    Reading(const SetupReader& setup, const AssetLibrary& assets, Problems& problems)
        : setup_(setup), assets_(assets), problems_(problems) {}

    std::optional<Calibration> read() {
        if (!read_assets()) return {};
        c_.simulated = setup_.text("data") == "simulated";
        c_.with_orientation = setup_.text("quantity") == "poses";
        c_.base_fitted = setup_.text("base_place") == "fitted";
        c_.tool_fitted = setup_.text("tool_place") == "fitted";
        if (c_.with_orientation) c_.u_angle = setup_.number("u_angle");
        c_.X_MB = c_.robot().X_WB();
        c_.X_FT = setup_.pose("ball");
        if (c_.simulated)
            simulate();
        else
            for (std::size_t row = 0; row < setup_.rows("poses"); ++row) read_pose(row);
        if (problems_.has_errors()) return {};
        std::stable_partition(c_.poses.begin(), c_.poses.end(),
                              [](const MeasuredPose& pose) { return !pose.check; });
        c_.fitted_poses = static_cast<std::size_t>(
            std::count_if(c_.poses.begin(), c_.poses.end(), [](const MeasuredPose& p) { return !p.check; }));
        if (c_.fitted_poses < 3) {
            problems_.error("/poses", "the fit has " + std::to_string(c_.fitted_poses) +
                                          " poses; it needs three or more, and about twenty to tell all "
                                          "parameters");
            return {};
        }
        add_inputs();
        list_unknowns();
        if (problems_.has_errors() || !fit(c_, problems_)) return {};
        return std::move(c_);
    }

private:
    bool read_assets() {
        const AssetLibrary::Entry* robot = assets_.find(setup_.text("nominal"));
        if (!offers<SerialRobotSource>(robot)) {
            problems_.error("/nominal", "'" + setup_.text("nominal") + "' is no serial robot");
            return false;
        }
        c_.nominal = robot->asset;
        if (const std::size_t sliding = first_sliding_joint(c_.robot()); sliding > 0) {
            problems_.error("/nominal",
                            "joint " + std::to_string(sliding) +
                                " slides: only arms whose joints turn are identified; take an arm "
                                "without it, as it stands during the measurement");
            return false;
        }
        c_.locator = locator_fields().read(setup_, assets_, problems_);
        return c_.locator.typed || c_.locator.instrument;
    }

    void add_pose(MeasuredPose pose) {
        const auto& joints = c_.robot().joints();
        for (std::size_t j = 0; j < joints.size(); ++j)
            pose.turns.push_back(Turn<double>(joints[j].travel(pose.q[j])));
        pose.reading.fill(no_input);
        c_.poses.push_back(std::move(pose));
    }

    /// An additive recurrence over the range of every joint (Roberts' sequence): evenly spread, and the first
    /// of more poses are those of fewer.
    void simulate() {
        const auto& joints = c_.robot().joints();
        const double range = setup_.number("half_range");
        double g = 2.0;  // root of g^(n+1) = g + 1
        for (int k = 0; k < 40; ++k) g = std::pow(1.0 + g, 1.0 / static_cast<double>(joints.size() + 1));
        for (int k = 0; k < setup_.integer("pose_count"); ++k) {
            MeasuredPose pose{.name = "P" + std::to_string(k + 1)};
            for (std::size_t j = 0; j < joints.size(); ++j) {
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
        const auto& joints = c_.robot().joints();
        MeasuredPose pose{.name = setup_.cell_text("poses", row, "name"),
                          .source = "/poses/rows/" + std::to_string(row)};
        if (!names_.insert(pose.name).second)
            problems_.error(pose.source, "two poses are called " + pose.name);
        pose.check =
            !setup_.cell_empty("poses", row, "use") && setup_.cell_text("poses", row, "use") == "check";
        for (std::size_t j = 0; j < most_joints; ++j) {
            const std::string column = "q_" + std::to_string(j + 1);
            const bool empty = setup_.cell_empty("poses", row, column);
            if (j < joints.size())
                pose.q.push_back(empty ? joints[j].zero : setup_.cell_number("poses", row, column));
            else if (!empty)
                problems_.error(pose.source + "/" + column, "the robot has only " +
                                                                std::to_string(joints.size()) +
                                                                " joints; leave " + column + " empty");
        }
        pose.p = setup_.cell_vector("poses", row, "x");
        if (c_.with_orientation) read_orientation(row, pose);
        add_pose(std::move(pose));
    }

    void read_orientation(std::size_t row, MeasuredPose& pose) {
        static const char* const columns[] = {"alpha", "beta", "gamma"};
        Eigen::Vector3d angles = Eigen::Vector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            if (setup_.cell_empty("poses", row, columns[k]))
                return problems_.error(pose.source, "pose " + pose.name +
                                                        ": its orientation is missing; give alpha, beta and "
                                                        "gamma of every pose, or fit positions alone");
            angles[k] = setup_.cell_number("poses", row, columns[k]);
        }
        pose.R = rotation_from_zyx<double>(angles);
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
            InputQuantity quantity{
                .symbol = symbol,
                .name = "pose " + pose.name + (turn ? ", rotation about " : ", ") + axes[i % 3],
                .unit = Unit::of(turn ? "deg" : "mm"),
                .offset = turn ? 0.0 : pose.p[static_cast<Eigen::Index>(i)],
                .group = "pose " + pose.name,
                .source = pose.source};
            quantity.tags = {{"kind", turn ? "measured orientations" : "measured positions"}};
            if (turn)
                c_.inputs.add(std::move(quantity), {{.id = symbol + ".orientation",
                                                     .name = "measured orientation",
                                                     .unit = Unit::of("deg"),
                                                     .distribution = Distribution::normal(c_.u_angle),
                                                     .origin = "typed standard uncertainty"}});
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
            const std::string symbol = "q_" + std::to_string(j + 1) + "," + std::to_string(k + 1);
            InputQuantity quantity{
                .symbol = symbol,
                .name = "pose " + pose.name + ", reading of joint " + std::to_string(j + 1),
                .unit = Unit::of("deg"),
                .offset = pose.q[j],
                .group = "pose " + pose.name,
                .source = pose.source};
            quantity.tags = {{"kind", "readings of the joints"}};
            for (UncertaintyComponent& component : components) component.id = symbol + "." + component.id;
            pose.reading[j] = c_.inputs.add(std::move(quantity), std::move(components));
        }
    }

    /// Everything that could be fitted; what the poses cannot tell is taken out by the fit.
    void list_unknowns() {
        for (std::size_t k = 0; c_.base_fitted && k < 6; ++k)
            c_.unknowns.push_back({.kind = UnknownKind::base, .coordinate = k});
        for (std::size_t k = 0; c_.tool_fitted && k < c_.rows_per_pose(); ++k)
            c_.unknowns.push_back({.kind = UnknownKind::tool, .coordinate = k});
        std::set<std::string> held = held_by_user();
        const auto& joints = c_.robot().joints();
        for (std::size_t j = 0; j < joints.size(); ++j)
            for (JointParameter p : joint_parameters) {
                const IdentifiedParameter parameter{j, p};
                if (p == JointParameter::d && joints[j].parallel)
                    c_.held.push_back({parameter.symbol(),
                                       "the axis is parallel to the next: 0 by definition, "
                                       "or beta and d would describe the same"});
                if (!joints[j].has(p)) continue;
                if (held.erase(parameter.symbol()) > 0)
                    c_.held.push_back({parameter.symbol(), "held at its nominal value by the set-up"});
                else
                    c_.unknowns.push_back({.kind = UnknownKind::parameter, .parameter = parameter});
            }
        for (const std::string& symbol : held)
            problems_.error("/held", "the robot has no parameter '" + symbol +
                                         "' to hold; write its symbol, such as d_3");
    }

    std::set<std::string> held_by_user() const {
        std::set<std::string> symbols;
        for (std::size_t row = 0; row < setup_.rows("held"); ++row)
            symbols.insert(setup_.cell_text("held", row, "parameter"));
        return symbols;
    }

    const SetupReader& setup_;
    const AssetLibrary& assets_;
    Problems& problems_;
    Calibration c_;
    std::set<std::string> names_;
};

}  // namespace

std::optional<Calibration> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    return Reading(setup, assets, problems).read();
}

}  // namespace covaria::pose_calibration
