// Reads the joints of a URDF file.
#include <algorithm>
#include <cstdio>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "core/base/in_quotes.h"
#include "core/base/unit.h"
#include "core/kinds/robot/urdf_chain.h"
#include "core/math/rotation.h"
#include "core/setup/message_text.h"
#include "core/text/numbers.h"

namespace covaria::urdf {

namespace {

Result<Eigen::Vector3d> vector_in(const pugi::xml_attribute& attribute, const Eigen::Vector3d& otherwise) {
    if (!attribute) return otherwise;
    std::istringstream text(attribute.value());
    Eigen::Vector3d v;
    if (text >> v[0] >> v[1] >> v[2]) return v;
    return fail(ErrorCode::bad_input, tell<"'%1' is not three numbers">(attribute.value()));
}

/// 0 where there is none that can be read. In every locale: pugixml reads it with that of the process.
double limit_of(const pugi::xml_node& joint, const char* name) {
    std::istringstream text(joint.child("limit").attribute(name).value());
    double value = 0.0;
    return text >> value ? value : 0.0;
}

JointKind kind_of(const Joint& joint) {
    if (joint.type == "fixed") return JointKind::fixed;
    if (!joint.follows.empty()) return JointKind::other;
    return joint.turns() ? JointKind::rotating : joint.slides() ? JointKind::sliding : JointKind::other;
}

Result<Joint> joint_in(const pugi::xml_node& node, int line) {
    Joint joint{.name = node.attribute("name").value(),
                .type = node.attribute("type").value(),
                .parent = node.child("parent").attribute("link").value(),
                .child = node.child("child").attribute("link").value(),
                .line = line};
    if (joint.parent.empty() || joint.child.empty())
        return refused_at(line, tell<"joint %1 does not say which links it joins">(joint.name));
    const auto xyz = vector_in(node.child("origin").attribute("xyz"), Eigen::Vector3d::Zero());
    const auto rpy = vector_in(node.child("origin").attribute("rpy"), Eigen::Vector3d::Zero());
    const auto axis = vector_in(node.child("axis").attribute("xyz"), Eigen::Vector3d::UnitX());
    for (const auto* v : {&xyz, &rpy, &axis})
        if (!*v) return refused_at(line, tell<"joint %1: %2">(joint.name, v->error().message));
    joint.X_PJ.translation() = *xyz;
    joint.X_PJ.linear() = rotation_from_zyx<double>(*rpy);
    const bool directed = joint.turns() || joint.slides();
    if (directed && !(axis->norm() > 1e-9))
        return refused_at(line, tell<"joint %1: its axis has no direction">(joint.name));
    if (directed) joint.axis = axis->normalized();
    if (const pugi::xml_node mimic = node.child("mimic")) joint.follows = mimic.attribute("joint").value();
    if (node.child("mimic") && joint.follows.empty()) joint.follows = "another one";
    joint.kind = kind_of(joint);
    joint.low = limit_of(node, "lower");
    joint.high = limit_of(node, "upper");
    joint.limited = directed && joint.type != "continuous" && joint.low < joint.high;
    return joint;
}

}  // namespace

void Joint::freeze(double value) {
    if (slides()) X_PJ = X_PJ * Eigen::Translation3d(value * axis);
    if (turns()) X_PJ = X_PJ * Eigen::AngleAxisd(value, axis);
    kind = JointKind::fixed;
}

Result<Robot> read(const std::string& xml) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
    const TextPlaces places(xml);
    if (!parsed)
        return refused_at(places.line(parsed.offset), tell<"not readable as XML: %1">(parsed.description()));
    const pugi::xml_node root = document.child("robot");
    if (!root)
        return refused_at(places.line(document.first_child().offset_debug()),
                          tell<"no URDF: its root element <robot> is missing">());
    if (const std::size_t xacro = xml.find("<xacro:"); xacro != std::string::npos)
        return refused_at(places.line(static_cast<std::ptrdiff_t>(xacro)),
                          tell<"the file has xacro macros: expand them first (xacro FILE > arm.urdf)">());
    Robot robot{.name = root.attribute("name").value(), .line = places.line(root.offset_debug())};
    std::set<std::string> children;
    for (const pugi::xml_node& node : root.children("joint")) {
        auto joint = joint_in(node, places.line(node.offset_debug()));
        if (!joint) return fail(joint.error());
        if (!children.insert(joint->child).second)
            return refused_at(joint->line,
                              tell<"link %1 hangs on two joints; URDF describes trees">(joint->child));
        robot.joints.push_back(std::move(*joint));
    }
    return robot;
}

Result<std::vector<Remark>> freeze(Robot& robot, const std::vector<FrozenJoint>& frozen) {
    std::map<std::string, Joint*> by_name;
    std::vector<std::string> names;
    for (Joint& joint : robot.joints) {
        by_name[joint.name] = &joint;
        if (joint.kind != JointKind::fixed) names.push_back(joint.name);
    }
    std::vector<Remark> remarks;
    for (const FrozenJoint& wanted : frozen) {
        const auto found = by_name.find(wanted.name);
        if (found == by_name.end())
            return fail(ErrorCode::not_found, tell<"there is no joint %1 to freeze%2">(
                                                  in_quotes(wanted.name), did_you_mean(wanted.name, names)));
        Joint& joint = *found->second;
        if (joint.kind == JointKind::fixed)
            return refused_at(joint.line, tell<"joint %1 does not move, or is frozen twice">(wanted.name));
        if (!joint.slides() && !joint.turns() && wanted.value != 0.0)
            return refused_at(joint.line, tell<"joint %1 is of the type %2: it can be frozen at 0 only">(
                                              wanted.name, joint.type));
        const double value = Unit::of(joint.slides() ? "mm" : "deg").to_si(wanted.value);
        const std::string text = format_short(wanted.value, 10) + (joint.slides() ? " mm" : "°");
        const bool beyond = joint.limited && (value < joint.low || value > joint.high);
        remarks.push_back({joint.name, beyond ? tell<"frozen at %1, beyond its limits">(text)
                                              : tell<"frozen at %1">(text)});
        joint.freeze(value);
    }
    return remarks;
}

}  // namespace covaria::urdf
