#include "viz/scene/arms.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace covaria::detail {
namespace {

// Radii as parts of the reach, as arms with six axes have them.
constexpr double base_radius = 0.056, flange_radius = 0.026, tool_radius = 0.010;
constexpr double at_joint = 2e-3;  // part of the reach: places that count as one
constexpr double along = 0.9;      // cosine: an axis along a link turns it, one across bends the arm

/// Numbers of links, one after the other from the base.
struct Arm {
    std::vector<std::size_t> links;
    double reach = 0.0;
};

bool begins_at_end(const SceneLink& link, const SceneLink& before, double reach) {
    return (link.from - before.to).norm() <= at_joint * reach;
}

std::vector<Arm> arms_of(const Scene& scene) {
    std::vector<Arm> arms;
    for (std::size_t i = 0; i < scene.links.size(); ++i) {
        const SceneLink& link = scene.links[i];
        if (link.kind != LinkKind::robot_link) continue;
        const double length = (link.to - link.from).norm();
        if (arms.empty() ||
            !begins_at_end(link, scene.links[arms.back().links.back()], arms.back().reach + length))
            arms.emplace_back();
        arms.back().links.push_back(i);
        arms.back().reach += length;
    }
    return arms;
}

/// A joint of an arm, with the arm's thickness there.
struct Joint {
    Eigen::Vector3d at;
    Eigen::Vector3d before = Eigen::Vector3d::Zero(), after = Eigen::Vector3d::Zero();  ///< ways of links
    double radius;
};

class ArmShape {
public:
    ArmShape(Scene& scene, const Arm& arm) : scene_(scene), arm_(arm) {}

    void make() {
        taper();
        const std::vector<Joint> joints = places();
        std::size_t axes = 0;
        for (SceneLink& link : scene_.links)
            if (link.kind == LinkKind::joint_axis && !(link.radius > 0)) axes += make_drum(link, joints);
        if (axes == 0) return;
        SceneLink& first = scene_.links[arm_.links.front()];
        const Eigen::Vector3d way = first.to - first.from;
        first.stands = way.z() > along * way.norm();
        make_tool();
    }

private:
    void taper() {
        double from = 0.0;
        const auto radius = [this](double at) {
            return arm_.reach * (base_radius + (flange_radius - base_radius) * at / arm_.reach);
        };
        for (const std::size_t i : arm_.links) {
            SceneLink& link = scene_.links[i];
            link.radius = radius(from);
            from += (link.to - link.from).norm();
            link.end_radius = radius(from);
        }
    }

    std::vector<Joint> places() const {
        std::vector<Joint> joints;
        for (const std::size_t i : arm_.links) {
            const SceneLink& link = scene_.links[i];
            const Eigen::Vector3d way = (link.to - link.from).normalized();
            if (joints.empty()) joints.push_back({.at = link.from, .radius = link.radius});
            joints.back().after = way;
            joints.push_back({.at = link.to, .before = way, .radius = link.end_radius});
        }
        return joints;
    }

    /// Makes a drum of an axis, or a collar. False: the axis is not one of this arm's.
    bool make_drum(SceneLink& axis, const std::vector<Joint>& joints) {
        const Eigen::Vector3d middle = (axis.from + axis.to) / 2, z = (axis.to - axis.from).normalized();
        const auto joint = std::ranges::find_if(
            joints, [&](const Joint& each) { return (each.at - middle).norm() <= at_joint * arm_.reach; });
        if (joint == joints.end() || joints.size() < 3) return false;
        const bool turns = std::abs(z.dot(joint->before)) > along || std::abs(z.dot(joint->after)) > along;
        axis.radius = (turns ? 1.1 : 1.24) * joint->radius;
        const double half = (turns ? 0.4 : 1.34) * joint->radius;
        Eigen::Vector3d at = middle;
        // One that turns a link is a collar on it, clear of the drum across that may sit at the same place.
        if (turns) {
            const bool ahead = std::abs(z.dot(joint->after)) > along;
            at += 1.7 * joint->radius * (ahead ? joint->after : Eigen::Vector3d(-joint->before));
        }
        axis.from = at - half * z;
        axis.to = at + half * z;
        axis.is_dashed = false;
        return true;
    }

    /// Makes the last link a tool if no axis passes its beginning, but one passes that of the link before.
    void make_tool() {
        if (arm_.links.size() < 3) return;
        SceneLink& last = scene_.links[arm_.links.back()];
        const Eigen::Vector3d& wrist = scene_.links[arm_.links[arm_.links.size() - 2]].from;
        const bool is_tool = std::ranges::any_of(scene_.links, [&](const SceneLink& axis) {
            return axis.kind == LinkKind::joint_axis && axis.radius > 0 &&
                   ((axis.from + axis.to) / 2 - wrist).norm() <= 0.1 * arm_.reach;
        });
        const bool on_wrist = std::ranges::any_of(scene_.links, [&](const SceneLink& axis) {
            return axis.kind == LinkKind::joint_axis && axis.radius > 0 &&
                   ((axis.from + axis.to) / 2 - last.from).norm() <= at_joint * arm_.reach;
        });
        if (!is_tool || on_wrist) return;
        last.radius = tool_radius * arm_.reach;
        last.end_radius = 0.5 * last.radius;
    }

    Scene& scene_;
    const Arm& arm_;
};

}  // namespace

void shape_arms(Scene& scene) {
    for (const Arm& arm : arms_of(scene)) {
        if (arm.links.size() < 2) continue;  // a tool of its own
        ArmShape(scene, arm).make();
    }
}

}  // namespace covaria::detail
