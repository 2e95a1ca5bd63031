// An arm of joints that turn or slide with its parameters, their components of uncertainty, limits and tool.
#include <cctype>
#include <map>
#include <optional>

#include "core/kinds/points/stated_figure.h"
#include "core/kinds/robot/arm.h"
#include "core/kinds/robot/asset.h"
#include "core/kinds/robot/fields.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

/// "Joint range" -> "joint-range", as part of a component's id.
std::string id_part(const std::string& text) {
    std::string id;
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        id += std::isalnum(u) ? static_cast<char>(std::tolower(u)) : '-';
    }
    return id;
}

template <class... M>
std::string place(M... members) {
    return robot_fields().place(members...);
}

class RobotReading {
public:
    RobotReading(const StatedRobot& stated, Problems& problems) : stated_(stated), problems_(problems) {}

    std::optional<RobotData> read() {
        const bool craig = stated_.convention == StatedRobot::Convention::craig;
        data_.convention = craig ? DhConvention::craig : DhConvention::modified;
        data_.X_WB = stated_.base;
        data_.X_FT = stated_.tool;
        data_.u_tool_position = stated_.u_tool_position;
        data_.u_tool_angle = stated_.u_tool_angle;
        if (stated_.joints.size() > most_joints)
            problems_.error(place(&StatedRobot::joints),
                            tell<"an arm has at most %1 joints here">(most_joints));
        for (std::size_t row = 0; row < stated_.joints.size(); ++row) read_joint(row);
        for (std::size_t row = 0; row < stated_.uncertainties.size(); ++row) read_uncertainties(row);
        for (std::size_t row = 0; row < stated_.correlations.size(); ++row) read_correlation(row);
        if (problems_.has_errors()) return {};
        return std::move(data_);
    }

private:
    void read_joint(std::size_t row) {
        const StatedJoint& stated = stated_.joints[row];
        RobotJoint joint;
        for (JointParameter p : joint_parameters) joint.values[p] = stated.values[index_of(p)].value_or(0.0);
        joint.parallel = stated.values[index_of(JointParameter::beta)].has_value();
        joint.slides = stated.slides;
        refuse_other(row);
        const StatedJoint::Figures& figures = stated.*stated.own();
        joint.zero = figures[StatedJoint::zero].value_or(0.0);
        joint.low = figures[StatedJoint::low].value_or(joint.low);
        joint.high = figures[StatedJoint::high].value_or(joint.high);
        if (stated.against) joint.direction = -1.0;
        read_coupling(joint, row);
        data_.u_encoder.push_back(figures[StatedJoint::u_encoder].value_or(0.0));
        data_.u_repeatability.push_back(figures[StatedJoint::u_repeatability].value_or(0.0));
        check_joint(joint, row);
        data_.joints.push_back(joint);
    }

    void read_coupling(RobotJoint& joint, std::size_t row) {
        const StatedJoint& stated = stated_.joints[row];
        const auto refuse = [&](auto member, Message why) {
            problems_.error(place(&StatedRobot::joints, row, member), std::move(why));
        };
        if (!stated.moved_by) {
            if (stated.share)
                refuse(&StatedJoint::share, tell<"say which joint moves joint %1 along">(row + 1));
            return;
        }
        const std::size_t other = *stated.moved_by - 1;
        if (other >= stated_.joints.size())
            return refuse(&StatedJoint::moved_by, tell<"the robot has no joint %1">(other + 1));
        if (other == row)
            return refuse(&StatedJoint::moved_by, tell<"joint %1 does not move itself along">(row + 1));
        if (stated.slides || stated_.joints[other].slides)
            return refuse(
                &StatedJoint::moved_by,
                tell<"joints %1 and %2: only joints that turn move each other along">(other + 1, row + 1));
        joint.moved_by = other;
        joint.share = stated.share.value_or(1.0);
    }

    void refuse_other(std::size_t row) {
        const StatedJoint& joint = stated_.joints[row];
        const auto other = joint.slides ? &StatedJoint::turning : &StatedJoint::sliding;
        for (std::size_t i = 0; i < (joint.*other).size(); ++i)
            if ((joint.*other)[i])
                problems_.error(
                    place(&StatedRobot::joints, row, other, i),
                    joint.slides
                        ? tell<"joint %1 slides: state its readings as lengths, in the columns of s">(row + 1)
                        : tell<"joint %1 turns: state its readings as angles, or give it the type sliding">(
                              row + 1));
    }

    void check_joint(const RobotJoint& joint, std::size_t row) {
        const Message name = tell<"joint %1">(row + 1);
        const auto cell = [&](JointParameter p) {
            return place(&StatedRobot::joints, row, &StatedJoint::values, index_of(p));
        };
        if (joint.parallel && stated_.convention != StatedRobot::Convention::modified)
            problems_.error(cell(JointParameter::beta),
                            tell<"only the convention with Ry(beta) has a beta; leave it empty for %1, or "
                                 "choose that convention">(name));
        if (joint.parallel && joint.values.d != 0.0)
            problems_.error(cell(JointParameter::d),
                            tell<"d and beta of %1 describe the same place of a parallel axis: where beta is "
                                 "given, d is 0 by definition">(name));
        if (!(joint.low < joint.high))
            problems_.error(
                place(&StatedRobot::joints, row, stated_.joints[row].own(), std::size_t{StatedJoint::low}),
                tell<"the lowest reading of %1 is not below its highest">(name));
    }

    void read_uncertainties(std::size_t row) {
        const StatedUncertainty& stated = stated_.uncertainties[row];
        const std::size_t first = stated.joint ? *stated.joint - 1 : 0;
        const std::size_t last = stated.joint ? *stated.joint : data_.joints.size();
        if (last > data_.joints.size())
            return problems_.error(place(&StatedRobot::uncertainties, row, &StatedUncertainty::joint),
                                   tell<"the robot has no joint %1">(last));
        for (std::size_t joint = first; joint < last; ++joint)
            for (JointParameter p : joint_parameters)
                if (stated.u[index_of(p)].value_or(0.0) != 0.0) add_component(row, joint, p);
    }

    void add_component(std::size_t row, std::size_t joint, JointParameter p) {
        const StatedUncertainty& stated = stated_.uncertainties[row];
        const std::string symbol = std::string(symbol_of(p)) + "_" + std::to_string(joint + 1);
        if (data_.joints[joint].has(p))
            data_.deviations.push_back({joint, p, component(stated, symbol, p)});
        else if (stated.joint)
            problems_.error(
                place(&StatedRobot::uncertainties, row, &StatedUncertainty::u, index_of(p)),
                p == JointParameter::d
                    ? tell<"%1 is 0 by definition, because the axis is parallel to the next">(symbol)
                    : tell<"%1 is no parameter of this robot: give beta in the table of joints where "
                           "axes are parallel">(symbol));
    }

    UncertaintyComponent component(const StatedUncertainty& stated, const std::string& symbol,
                                   JointParameter p) {
        UncertaintyComponent c{
            .id = symbol + "." + id_part(stated.source),
            .name = tell<"%1, %2">(symbol, stated.source),
            .unit = Unit::of(is_length(p) ? "mm" : "deg"),
            .distribution = distribution_of_shape(stated.distribution, *stated.u[index_of(p)]),
            .origin = stated.source};
        if (const int again = ++ids_[c.id]; again > 1) c.id += "-" + std::to_string(again);
        if (stated.degrees_of_freedom) {
            c.degrees_of_freedom = *stated.degrees_of_freedom;
            c.type = EvaluationType::type_a;
        }
        return c;
    }

    void read_correlation(std::size_t row) {
        const std::optional<std::size_t> first = deviation_called(row, &StatedCorrelation::first);
        const std::optional<std::size_t> second = deviation_called(row, &StatedCorrelation::second);
        if (!first || !second) return;
        if (*first == *second)
            return problems_.error(place(&StatedRobot::correlations, row),
                                   tell<"a parameter is correlated with itself; name two different ones">());
        data_.correlations.push_back({*first, *second, stated_.correlations[row].coefficient});
    }

    /// The one deviation of the parameter named in a cell; empty after an error.
    std::optional<std::size_t> deviation_called(std::size_t row, std::string StatedCorrelation::*which) {
        const std::string& symbol = stated_.correlations[row].*which;
        std::optional<std::size_t> found;
        std::size_t count = 0;
        for (std::size_t i = 0; i < data_.deviations.size(); ++i) {
            const ParameterDeviation& d = data_.deviations[i];
            if (symbol != std::string(symbol_of(d.parameter)) + "_" + std::to_string(d.joint + 1)) continue;
            found = i;
            ++count;
        }
        if (count == 1) return found;
        problems_.error(
            place(&StatedRobot::correlations, row, which),
            count == 0
                ? tell<"there is no parameter '%1' with an uncertainty; write its symbol, such as d_3">(
                      symbol)
                : tell<"%1 has several components of uncertainty: give it one, the combined, so that it can "
                       "be correlated">(symbol));
        return {};
    }

    const StatedRobot& stated_;
    Problems& problems_;
    RobotData data_;
    std::map<std::string, int> ids_;
};

std::unique_ptr<Asset> create_robot(const SetupReader& setup, const AssetLibrary& assets,
                                    Problems& problems) {
    const StatedRobot stated = robot_fields().read(setup, assets, problems);
    std::optional<RobotData> data = RobotReading(stated, problems).read();
    if (!data) return nullptr;
    return std::make_unique<RobotAsset>(std::move(*data));
}

}  // namespace

AssetDescriptor serial_robot_kind() {
    AssetDescriptor d;
    d.kind = "serial-robot";
    d.title = "Serial robot";
    d.category = AssetCategory::robot;
    d.summary =
        "An arm of joints that turn or slide: parameters in a Denavit-Hartenberg convention with one or more "
        "components "
        "of uncertainty each, their correlation, limits, encoders, base and tool.";
    d.references = {
        {"X. Wen, S. He, G. Qiao, D. Wang, A. Song, C. Kang, Z. Lv: Uncertainty estimation of robot "
         "geometric parameters and end-effector position based on new generation GPS, Eq. 5"},
        {"J. Denavit, R. S. Hartenberg (1955); J. J. Craig: Introduction to Robotics; S. A. "
         "Hayati (1983): the angle beta of parallel joints"}};
    d.notes = {
        "Eq. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Where an axis is parallel to the next, beta is "
        "a "
        "parameter and d is 0 by definition; elsewhere beta is 0.",
        "alpha and beta of a row turn the axis of the joint into that of the next (the paper's text shifts "
        "them by one joint).",
        "The joint angle is theta plus the reading less the zero reading; a sliding joint adds its reading "
        "to d "
        "in the same way."};
    d.capabilities = {SerialRobotSource::capability};
    d.schema = robot_fields().schema();
    d.create = create_robot;
    return d;
}

}  // namespace covaria
