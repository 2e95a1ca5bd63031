// Input quantities of "robot pose": parameters joint by joint, the tool, then readings that are uncertain.
#include <cmath>

#include "core/base/name.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot/setup.h"
#include "core/quantity/input_quantity.h"

namespace covaria::robot {

namespace {

class InputBuilder {
public:
    explicit InputBuilder(PoseSetup& setup) : setup_(setup), robot_(setup.robot()) {}

    InputSet build() {
        for (auto& joint : setup_.parameter) joint.fill(no_input);
        component_of_.assign(robot_.deviations().size(), no_input);
        for (std::size_t i = 0; i < robot_.joints().size(); ++i)
            for (JointParameter p : joint_parameters)
                if (robot_.joints()[i].has(p)) add_parameter(i, p);
        for (const DeviationCorrelation& c : robot_.correlations())
            if (setup_.correlated)
                inputs_.correlations.push_back(
                    {component_of_[c.first], component_of_[c.second], c.coefficient});
        add_tool();
        for (std::size_t k = 0; k < setup_.poses.size(); ++k) add_readings(k);
        return std::move(inputs_);
    }

private:
    static Name joint_name(std::size_t i) { return own_name<"joint %1">(i + 1); }

    void add_parameter(std::size_t i, JointParameter p) {
        const std::string symbol = std::string(symbol_of(p)) + "_" + std::to_string(i + 1);
        InputQuantity quantity{.symbol = symbol,
                               .name = tell<"%1 of joint %2">(words_of(p), i + 1),
                               .unit = Unit::of(is_length(p) ? "mm" : "deg"),
                               .offset = robot_.joints()[i].values[p],
                               .group = joint_name(i)};
        quantity.tags = {{"parameter", symbol},
                         {"joint", joint_name(i)},
                         {"kind", is_length(p) ? own_name<"lengths">() : own_name<"angles">()}};
        for (std::size_t d = 0; d < robot_.deviations().size(); ++d) {
            const ParameterDeviation& deviation = robot_.deviations()[d];
            if (deviation.joint != i || deviation.parameter != p) continue;
            component_of_[d] = add_component(deviation.component, quantity);
        }
        quantity.taken_from = robot_.taken_from(i, p);
        setup_.parameter[i][static_cast<std::size_t>(p)] = inputs_.quantities.size();
        inputs_.quantities.push_back(std::move(quantity));
    }

    std::size_t add_component(const UncertaintyComponent& own, InputQuantity& quantity) {
        if (setup_.combine && !quantity.shares.empty()) {
            combine(own, quantity.symbol, inputs_.components[quantity.shares.front().component]);
            return quantity.shares.front().component;
        }
        UncertaintyComponent component = own;
        if (!setup_.combine) component.tags.push_back({"source", Name::of(own.origin)});
        component.identity = setup_.arm.id + "." + own.id;
        component.origin = tell<"%1: %2">(setup_.arm.name, own.origin);
        quantity.shares.push_back({inputs_.add(std::move(component)), 1.0});
        return quantity.shares.front().component;
    }

    /// Root sum of squares, with effective degrees of freedom (Welch-Satterthwaite).
    void combine(const UncertaintyComponent& more, const std::string& symbol,
                 UncertaintyComponent& sum) const {
        const double a = sum.distribution.standard_uncertainty(),
                     b = more.distribution.standard_uncertainty();
        const double u = std::hypot(a, b);
        const double welch =
            std::pow(a, 4) / sum.degrees_of_freedom + std::pow(b, 4) / more.degrees_of_freedom;
        sum.degrees_of_freedom = welch > 0.0 ? std::pow(u, 4) / welch : infinity;
        sum.distribution = Distribution::normal(u);
        sum.id = symbol + ".combined";
        sum.identity = setup_.arm.id + "." + sum.id;
        sum.name = tell<"%1, combined">(symbol);
        sum.origin = tell<"%1, %2">(sum.origin, more.origin);
    }

    void add_tool() {
        static const char* const symbols[] = {"x_T", "y_T", "z_T", "alpha_T", "beta_T", "gamma_T"};
        std::vector<UncertaintyComponent> components = robot_.tool();
        double any = 0.0;
        for (const UncertaintyComponent& c : components) any += c.distribution.standard_uncertainty();
        if (any == 0.0) return;
        setup_.tool = inputs_.quantities.size();
        for (std::size_t i = 0; i < 6; ++i) {
            InputQuantity quantity{.symbol = symbols[i],
                                   .name = tell<"%1, deviation">(components[i].name),
                                   .unit = Unit::of(i < 3 ? "mm" : "deg"),
                                   .group = own_name<"tool">()};
            quantity.tags = {{"parameter", symbols[i]},
                             {"joint", own_name<"tool">()},
                             {"kind", i < 3 ? own_name<"lengths">() : own_name<"angles">()}};
            components[i].identity = setup_.arm.id + "." + components[i].id;
            components[i].origin = tell<"%1: %2">(setup_.arm.name, components[i].origin);
            inputs_.add(std::move(quantity), {components[i]});
        }
    }

    void add_readings(std::size_t k) {
        Pose& pose = setup_.poses[k];
        pose.input.fill(no_input);
        for (std::size_t i = 0; i < pose.q.size(); ++i) {
            std::vector<UncertaintyComponent> components = robot_.reading(i);
            if (components.empty()) continue;
            const std::string symbol = reading_symbol(robot_, i) + "," + std::to_string(k + 1);
            InputQuantity quantity{.symbol = symbol,
                                   .name = tell<"reading of joint %1, %2">(i + 1, pose.name),
                                   .unit = robot_.joints()[i].reading_unit(),
                                   .offset = pose.q[i],
                                   .group = pose.name,
                                   .source = pose.source};
            quantity.tags = {
                {"parameter", symbol}, {"joint", joint_name(i)}, {"kind", own_name<"readings">()}};
            for (UncertaintyComponent& c : components) {
                c.id = symbol + "." + c.id;
                c.tags.push_back({"source", Name::of(c.origin)});
                c.origin = tell<"%1: %2">(setup_.arm.name, c.origin);
            }
            pose.input[i] = inputs_.add(std::move(quantity), std::move(components));
        }
    }

    PoseSetup& setup_;
    const SerialRobotSource& robot_;
    InputSet inputs_;
    std::vector<std::size_t> component_of_;  ///< component of each deviation
};

}  // namespace

InputSet pose_inputs(PoseSetup& setup) {
    return InputBuilder(setup).build();
}

}  // namespace covaria::robot
