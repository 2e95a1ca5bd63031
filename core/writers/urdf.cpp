// A serial robot in URDF, the robot description format of ROS.
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "core/readers/entry_texts.h"
#include "core/setup/message_text.h"
#include "core/writers/exported_robot.h"
#include "core/writers/formats.h"

namespace covaria {

namespace {

std::string urdf_three(double a, double b, double c) {
    return shortest_number(a + 0.0) + " " + shortest_number(b + 0.0) + " " + shortest_number(c + 0.0);
}

pugi::xml_node urdf_joint(pugi::xml_node robot, const std::string& name, const char* type,
                          const std::string& parent, const std::string& child, const Eigen::Isometry3d& X) {
    robot.append_child("link").append_attribute("name") = child.c_str();
    pugi::xml_node joint = robot.append_child("joint");
    joint.append_attribute("name") = name.c_str();
    joint.append_attribute("type") = type;
    joint.append_child("parent").append_attribute("link") = parent.c_str();
    joint.append_child("child").append_attribute("link") = child.c_str();
    const Eigen::Vector3d p = X.translation();
    const auto rpy = roll_pitch_yaw(X.linear());
    pugi::xml_node origin = joint.append_child("origin");
    origin.append_attribute("xyz") = urdf_three(p[0], p[1], p[2]).c_str();
    origin.append_attribute("rpy") = urdf_three(rpy[0], rpy[1], rpy[2]).c_str();
    return joint;
}

/// Adds type and limit of a joint. A sliding joint must have a limit in ROS.
void add_movement(pugi::xml_node joint, const ArmFrame& frame, std::size_t number, WrittenFile& file) {
    joint.append_child("axis").append_attribute("xyz") = "0 0 1";
    const bool limited = std::isfinite(frame.low) && std::isfinite(frame.high);
    joint.attribute("type") = frame.slides ? "prismatic" : limited ? "revolute" : "continuous";
    if (limited) {
        pugi::xml_node limit = joint.append_child("limit");
        limit.append_attribute("lower") = shortest_number(frame.low).c_str();
        limit.append_attribute("upper") = shortest_number(frame.high).c_str();
        for (const char* unknown : {"effort", "velocity"}) limit.append_attribute(unknown) = "0";
    } else if (frame.slides || std::isfinite(frame.low) || std::isfinite(frame.high)) {
        file.said.push_back("joint " + std::to_string(number) +
                            " has no limits in the file: the robot does not state both" +
                            (frame.slides ? ", and ROS asks for those of a joint that slides" : ""));
    }
}

Result<WrittenFile> write_urdf(const WriterSource& source) {
    const auto found = exported_robot(source);
    if (!found) return fail(found.error());
    const ExportedRobot& robot = *found;
    WrittenFile file{.bytes = {}, .said = robot.said};
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "utf-8";
    pugi::xml_node root = document.append_child("robot");
    root.append_attribute("name") = plain_name(robot.name.empty() ? robot.id : robot.name).c_str();
    root.append_child(pugi::node_comment)
        .set_value(
            " Lengths in m, angles in rad, about fixed axes; effort and velocity of limits are not "
            "known: 0. In comments: parameters of the robot and their standard uncertainties u. ");
    root.append_child("link").append_attribute("name") = "world";
    urdf_joint(root, "base", "fixed", "world", "base_link", robot.arm.X_WB);
    std::string parent = "base_link";
    for (std::size_t i = 0; i < robot.arm.joints.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        root.append_child(pugi::node_comment)
            .set_value((" joint " + number + ": " + robot.parameters[i] + " ").c_str());
        const auto joint =
            urdf_joint(root, "joint_" + number, "", parent, "link_" + number, robot.arm.joints[i].X_PJ);
        add_movement(joint, robot.arm.joints[i], i + 1, file);
        parent = "link_" + number;
    }
    urdf_joint(root, "tool", "fixed", parent, "tool0", robot.arm.X_JT);
    std::ostringstream text;
    document.save(text, "  ");
    file.bytes = text.str();
    file.said.push_back("links world, base_link, link_1 ... tool0; geometry only, without bodies and masses");
    return file;
}

}  // namespace

Writer urdf_writer() {
    return {.name = "urdf",
            .title = "Robot description (URDF)",
            .ending = ".urdf",
            .writes =
                "the serial robot that the analyses use or find, the identified before the nominal, with "
                "standard uncertainties of its parameters as comments",
            .write = write_urdf};
}

}  // namespace covaria
