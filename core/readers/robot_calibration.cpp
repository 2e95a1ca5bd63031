// Kinematic calibration of a UR arm as its ROS driver writes it: the frames of the joints, read as the URDF
// robot that they make.
#include <array>

#include "core/base/in_quotes.h"
#include "core/kinds/robot/urdf.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/yaml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

struct ArmJoint {
    const char* link;  ///< key of the file
    const char* joint;
};
constexpr std::array<ArmJoint, 6> arm_joints{{{"shoulder", "shoulder_pan_joint"},
                                              {"upper_arm", "shoulder_lift_joint"},
                                              {"forearm", "elbow_joint"},
                                              {"wrist_1", "wrist_1_joint"},
                                              {"wrist_2", "wrist_2_joint"},
                                              {"wrist_3", "wrist_3_joint"}}};

/// The element <origin> of one joint, of "x y z" and "roll pitch yaw".
Result<std::string> origin_of(const YamlNode& joint, const std::string& name) {
    std::array<std::string, 6> figures;
    constexpr std::array<const char*, 6> keys{"x", "y", "z", "roll", "pitch", "yaw"};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const YamlNode* node = joint.find(keys[i]);
        const auto value = node ? node->number() : std::nullopt;
        if (!value)
            return (node ? *node : joint)
                .refused(name + ": " + keys[i] +
                         (node ? " " + in_quotes(plain_name(node->text)) + " is no number" : " is missing"));
        const double largest = i < 3 ? 100.0 : 10.0;
        if (!(std::abs(*value) <= largest))
            return node->refused(tell<"%1: %2 must lie within %3">(
                name, keys[i], shortest_number(largest) + (i < 3 ? " m" : " rad")));
        figures[i] = shortest_number(*value);
    }
    return "<origin xyz=\"" + figures[0] + " " + figures[1] + " " + figures[2] + "\" rpy=\"" + figures[3] +
           " " + figures[4] + " " + figures[5] + "\"/>";
}

void leave_out_others(const YamlNode& map, const std::string& where, Proposals& proposals,
                      const std::function<bool(const std::string&)>& known) {
    for (std::size_t i = 0; i < map.keys.size(); ++i)
        if (!known(map.keys[i]))
            proposals.leave_out(map.children[i].line, where + in_quotes(plain_name(map.keys[i])));
}

Result<std::string> urdf_of(const YamlNode& kinematics, Proposals& proposals) {
    std::string urdf = "<robot name=\"calibrated\"><link name=\"base\"/>", parent = "base";
    for (const auto& [link, name] : arm_joints) {
        const YamlNode* joint = kinematics.find(link);
        if (!joint) return kinematics.refused(tell<"the frame of %1 is missing">(link));
        const auto origin = origin_of(*joint, link);
        if (!origin) return fail(origin.error());
        leave_out_others(*joint, std::string(link) + ": ", proposals, [](const std::string& key) {
            return key == "x" || key == "y" || key == "z" || key == "roll" || key == "pitch" || key == "yaw";
        });
        urdf += std::string("<link name=\"") + link + "\"/><joint name=\"" + name +
                "\" type=\"continuous\"><parent link=\"" + parent + "\"/><child link=\"" + link + "\"/>" +
                *origin + "<axis xyz=\"0 0 1\"/></joint>";
        parent = link;
    }
    leave_out_others(kinematics, "kinematics: ", proposals, [](const std::string& key) {
        for (const ArmJoint& joint : arm_joints)
            if (key == joint.link) return true;
        return key == "hash";
    });
    return urdf + "</robot>";
}

Recognition recognise_calibration(std::string_view beginning, const std::string&) {
    const bool arm = beginning.find("kinematics:") != std::string_view::npos &&
                     beginning.find("shoulder:") != std::string_view::npos;
    return arm ? Recognition::certain : Recognition::no;
}

Result<Proposals> read_calibration(const std::string& text, const ReadChoice& choice) {
    const auto yaml = parse_yaml(text);
    if (!yaml) return fail(yaml.error());
    const YamlNode* kinematics = yaml->find("kinematics");
    if (!kinematics) return yaml->refused(tell<"no calibration of a robot: 'kinematics' is missing">());
    Proposals proposals{.title = without_ending(choice.file_name)};
    leave_out_others(*yaml, "", proposals, [](const std::string& key) { return key == "kinematics"; });
    const auto urdf = urdf_of(*kinematics, proposals);
    if (!urdf) return fail(urdf.error());
    auto robot = import_urdf(*urdf, {.tip = "wrist_3", .frozen = {}});
    if (!robot) return kinematics->refused(robot.error().message);
    const std::string hash = plain_name(kinematics->text_of("hash"));
    const std::string name = proposals.title.empty() ? "Calibrated robot" : proposals.title;
    AssetEntry asset{.id = id_of(name, "robot"), .kind = robot->kind, .name = name};
    asset.notes =
        "Kinematic calibration" + (hash.empty() ? std::string() : " " + hash) +
        ": six joints from the base to wrist_3, whose frame is that of the flange (tool0). The file "
        "states no uncertainty: give the parameters theirs.";
    asset.setup = std::move(robot->setup);
    if (!hash.empty()) proposals.found.push_back(tell<"calibration %1">(hash));
    for (const Message& line : robot->report) proposals.found.push_back(line);
    proposals.found.push_back(tell<"lengths in m, angles in rad, about fixed axes as in URDF">());
    proposals.assets.push_back(std::move(asset));
    return proposals;
}

}  // namespace

Reader robot_calibration_reader() {
    return {.name = "robot-calibration",
            .title = "Kinematic calibration of a UR robot (ROS)",
            .pattern = "*.yaml *.yml",
            .takes = "frames of the six joints -> serial robot",
            .recognise = recognise_calibration,
            .read = read_calibration};
}

}  // namespace covaria
