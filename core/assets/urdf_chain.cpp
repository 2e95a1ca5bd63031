#include "core/assets/urdf_chain.h"

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "core/math/rotation.h"

namespace covaria::urdf {

namespace {

Result<Eigen::Vector3d> vector_in(const pugi::xml_attribute& attribute, const Eigen::Vector3d& otherwise) {
    if (!attribute) return otherwise;
    std::istringstream text(attribute.value());
    Eigen::Vector3d v;
    if (text >> v[0] >> v[1] >> v[2]) return v;
    return fail(ErrorCode::bad_input, std::string("'") + attribute.value() + "' is not three numbers");
}

Result<Joint> joint_in(const pugi::xml_node& node) {
    Joint joint{.name = node.attribute("name").value(),
                .type = node.attribute("type").value(),
                .parent = node.child("parent").attribute("link").value(),
                .child = node.child("child").attribute("link").value()};
    if (joint.parent.empty() || joint.child.empty())
        return fail(ErrorCode::bad_input, "joint " + joint.name + " does not say which links it joins");
    const auto xyz = vector_in(node.child("origin").attribute("xyz"), Eigen::Vector3d::Zero());
    const auto rpy = vector_in(node.child("origin").attribute("rpy"), Eigen::Vector3d::Zero());
    const auto axis = vector_in(node.child("axis").attribute("xyz"), Eigen::Vector3d::UnitX());
    for (const auto* v : {&xyz, &rpy, &axis})
        if (!*v) return fail(ErrorCode::bad_input, "joint " + joint.name + ": " + v->error().message);
    joint.X_PJ.translation() = *xyz;
    joint.X_PJ.linear() = rotation_from_zyx<double>(*rpy);
    const bool turns = joint.type == "revolute" || joint.type == "continuous";
    if (turns && !(axis->norm() > 1e-9))
        return fail(ErrorCode::bad_input, "joint " + joint.name + ": its axis has no direction");
    if (turns) joint.axis = axis->normalized();
    const bool follows = static_cast<bool>(node.child("mimic"));
    joint.kind = joint.type == "fixed" ? JointKind::fixed
                 : (turns && !follows) ? JointKind::rotating
                                       : JointKind::other;
    joint.low = node.child("limit").attribute("lower").as_double();
    joint.high = node.child("limit").attribute("upper").as_double();
    joint.limited = joint.type == "revolute" && joint.low < joint.high;
    return joint;
}

std::size_t rotating(const Chain& chain) {
    return static_cast<std::size_t>(
        std::count_if(chain.joints.begin(), chain.joints.end(),
                      [](const Joint& j) { return j.kind == JointKind::rotating; }));
}

const Joint* obstacle(const Chain& chain) {
    for (const Joint& joint : chain.joints)
        if (joint.kind == JointKind::other) return &joint;
    return nullptr;
}

std::string last_rotating(const Chain& chain) {
    std::string name;
    for (const Joint& joint : chain.joints)
        if (joint.kind == JointKind::rotating) name = joint.name;
    return name;
}

class ChainFinder {
public:
    explicit ChainFinder(const Robot& robot) : robot_(robot) {
        for (const Joint& joint : robot.joints) above_[joint.child] = &joint;
    }

    /// From the root of the tree; empty joints if the link is the root itself.
    Result<Chain> to(const std::string& tip) const {
        Chain chain{.root = tip, .tip = tip};
        for (auto joint = above_.find(tip); joint != above_.end(); joint = above_.find(chain.root)) {
            chain.joints.insert(chain.joints.begin(), *joint->second);
            chain.root = joint->second->parent;
            if (chain.joints.size() > robot_.joints.size())
                return fail(ErrorCode::bad_input, "the links form a ring; URDF describes trees");
        }
        return chain;
    }

    /// The tip of the longest arm.
    Result<Chain> longest() const {
        std::vector<Chain> best;
        std::string first_obstacle;
        for (const Joint& joint : robot_.joints) {
            auto chain = to(joint.child);
            if (!chain) return chain;
            if (const Joint* other = obstacle(*chain)) {
                if (first_obstacle.empty()) first_obstacle = other->name + " (" + other->type + ")";
                continue;
            }
            if (!best.empty() && rotating(*chain) > rotating(best.front())) best.clear();
            if (best.empty() || rotating(*chain) == rotating(best.front())) best.push_back(std::move(*chain));
        }
        if (best.empty() || rotating(best.front()) == 0)
            return fail(ErrorCode::bad_input,
                        first_obstacle.empty() ? "the file has no rotating joint"
                                               : "no arm of rotating joints: joint " + first_obstacle +
                                                     " is of a kind that a serial robot does not have here");
        return preferred(best);
    }

private:
    static Result<Chain> preferred(const std::vector<Chain>& chains) {
        for (const Chain& chain : chains)
            if (last_rotating(chain) != last_rotating(chains.front()))
                return fail(ErrorCode::bad_input, "the file has several arms of equal length, ending at " +
                                                      chains.front().tip + " and " + chain.tip +
                                                      ": name the tip link of the one to import");
        for (const char* wanted : {"tool0", "tcp", "flange"})
            for (const Chain& chain : chains)
                if (chain.tip.find(wanted) != std::string::npos) return chain;
        return *std::max_element(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
            return a.joints.size() < b.joints.size();
        });
    }

    const Robot& robot_;
    std::map<std::string, const Joint*> above_;
};

}  // namespace

Result<Robot> read(const std::string& xml) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
    if (!parsed)
        return fail(ErrorCode::bad_input, std::string("not readable as XML: ") + parsed.description() +
                                              ", at character " + std::to_string(parsed.offset));
    const pugi::xml_node root = document.child("robot");
    if (!root) return fail(ErrorCode::bad_input, "no URDF: its root element <robot> is missing");
    if (xml.find("<xacro:") != std::string::npos)
        return fail(ErrorCode::bad_input,
                    "the file has xacro macros: expand them first (xacro FILE > arm.urdf)");
    Robot robot{.name = root.attribute("name").value()};
    std::set<std::string> children;
    for (const pugi::xml_node& node : root.children("joint")) {
        auto joint = joint_in(node);
        if (!joint) return fail(joint.error());
        if (!children.insert(joint->child).second)
            return fail(ErrorCode::bad_input,
                        "link " + joint->child + " hangs on two joints; URDF describes trees");
        robot.joints.push_back(std::move(*joint));
    }
    return robot;
}

Result<Chain> chain_to(const Robot& robot, const std::string& tip) {
    const ChainFinder finder(robot);
    if (tip.empty()) return finder.longest();
    auto chain = finder.to(tip);
    if (!chain) return chain;
    if (chain->joints.empty()) return fail(ErrorCode::not_found, "no joint leads to a link called " + tip);
    if (const Joint* other = obstacle(*chain))
        return fail(ErrorCode::bad_input,
                    "joint " + other->name + " on the way to " + tip + " is of the type " + other->type +
                        " or follows another one: a serial robot has rotating joints here");
    if (rotating(*chain) == 0) return fail(ErrorCode::bad_input, "no rotating joint leads to " + tip);
    return chain;
}

}  // namespace covaria::urdf
