#include "core/kinds/robot/arm.h"

#include "core/base/name.h"
#include "core/kinds/robot/layout.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

std::optional<OutputReference> RobotSource::taken_from(std::size_t joint, JointParameter parameter) const {
    for (const ParameterOutput& found : data_.outputs)
        if (found.joint == joint && found.parameter == parameter) return found.output;
    return {};
}

std::vector<UncertaintyComponent> RobotSource::reading(std::size_t joint) const {
    std::vector<UncertaintyComponent> components;
    const auto add = [&](const char* id, const Message& source, double u) {
        if (u == 0.0) return;
        components.push_back({.id = id,
                              .name = tell<"%1 of joint %2">(source, joint + 1),
                              .unit = data_.joints[joint].reading_unit(),
                              .distribution = Distribution::normal(u),
                              .origin = source});
    };
    add("encoder", tell<"encoder">(), data_.u_encoder.empty() ? 0.0 : data_.u_encoder[joint]);
    add("repeatability", tell<"repeatability">(),
        data_.u_repeatability.empty() ? 0.0 : data_.u_repeatability[joint]);
    return components;
}

std::vector<UncertaintyComponent> RobotSource::tool() const {
    std::vector<UncertaintyComponent> components;
    static const char* const axes[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 6; ++i)
        components.push_back(
            {.id = "tool." + std::to_string(i + 1),
             .name = i < 3 ? tell<"tool %1">(axes[i]) : tell<"tool, rotation about %1">(axes[i - 3]),
             .unit = Unit::of(i < 3 ? "mm" : "deg"),
             .distribution = Distribution::normal(i < 3 ? data_.u_tool_position : data_.u_tool_angle),
             .origin = tell<"tool: standard uncertainty">()});
    return components;
}

std::vector<Table> RobotAsset::evaluation() const {
    return {parameter_table(source_)};
}

Layout RobotAsset::layout() const {
    Layout layout;
    std::vector<double> q;
    for (const RobotJoint& joint : source_.joints()) q.push_back(joint.zero);
    add_arm(source_, q, "", layout);
    layout.points.push_back({.name = own_name<"tool">(),
                             .kind = PointKind::tool,
                             .p_W = source_.X_WB() * link_frames(source_, q).back().translation()});
    return layout;
}

}  // namespace covaria
