#include "core/kinds/robot/layout.h"
#include "core/kinds/robot/serial_robot.h"

#include <algorithm>

#include "core/base/name.h"

namespace covaria {

namespace {

class ArmBuilder {
public:
    ArmBuilder(const SerialRobotSource& robot, const std::vector<double>& q, const std::string& group,
               Layout& layout)
        : robot_(robot), q_(q), group_(group), layout_(layout), frames_(link_frames(robot, q)) {
        for (Eigen::Isometry3d& frame : frames_) frame = robot.X_WB() * frame;
        for (std::size_t i = 1; i < frames_.size(); ++i)
            reach_ += (frames_[i].translation() - frames_[i - 1].translation()).norm();
    }

    void build() {
        const std::size_t n = robot_.joints().size();
        for (std::size_t i = 0; i < n; ++i) {
            add_link(i);
            add_axis(i);
        }
        add_segment(own_name<"tool">(), frames_[n].translation(), frames_[n + 1].translation());
        for (std::size_t i = 0; i <= n; ++i) add_frame(std::to_string(i), frames_[i]);
        add_frame(own_name<"tool">(), frames_[n + 1]);
    }

private:
    /// Along the offset d first, then along the length a; Craig's convention has them the other way round.
    void add_link(std::size_t i) {
        const Eigen::Vector3d from = frames_[i].translation(), to = frames_[i + 1].translation();
        const bool craig = robot_.convention() == DhConvention::craig;
        const RobotJoint& joint = robot_.joints()[i];
        const double a = joint.values.a,
                     d = joint.values.d + (joint.slides ? travel_of(robot_.joints(), i, q_) : 0.0);
        const Eigen::Vector3d corner = craig ? Eigen::Vector3d(from + a * frames_[i].linear().col(0))
                                             : Eigen::Vector3d(from + d * frames_[i].linear().col(2));
        add_segment("link " + std::to_string(i + 1), from, corner);
        add_segment("link " + std::to_string(i + 1), corner, to);
    }

    void add_segment(const Name& name, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        if ((to - from).norm() < 1e-3 * reach_) return;
        layout_.links.push_back(
            {.name = name, .kind = LinkKind::robot_link, .from_W = from, .to_W = to, .group = group_});
    }

    void add_axis(std::size_t i) {
        const Eigen::Isometry3d& X = frames_[robot_.convention() == DhConvention::craig ? i + 1 : i];
        const Eigen::Vector3d half = 0.07 * reach_ * X.linear().col(2);
        layout_.links.push_back({.name = own_name<"axis %1">(i + 1),
                                 .kind = LinkKind::joint_axis,
                                 .from_W = X.translation() - half,
                                 .to_W = X.translation() + half,
                                 .group = group_});
    }

    /// A frame at the place of an earlier one is not drawn again: triads would cover each other.
    void add_frame(const Name& name, const Eigen::Isometry3d& X) {
        const bool covered = std::any_of(drawn_.begin(), drawn_.end(), [&](const Eigen::Isometry3d& other) {
            return (other.translation() - X.translation()).norm() < 1e-3 * reach_;
        });
        if (covered) return;
        drawn_.push_back(X);
        layout_.frames.push_back({name, X, group_, {}});
    }

    const SerialRobotSource& robot_;
    const std::vector<double>& q_;
    const std::string& group_;
    Layout& layout_;
    std::vector<Eigen::Isometry3d> frames_, drawn_;
    double reach_ = 0.0;
};

}  // namespace

void add_arm(const SerialRobotSource& robot, const std::vector<double>& q, const std::string& group,
             Layout& layout) {
    ArmBuilder(robot, q, group, layout).build();
}

}  // namespace covaria
