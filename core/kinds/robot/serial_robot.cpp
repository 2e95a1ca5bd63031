#include "core/kinds/robot/serial_robot.h"

#include <cmath>
#include <map>

#include "core/text/table.h"

namespace covaria {

const char* symbol_of(JointParameter parameter) {
    static constexpr const char* symbols[] = {"theta", "d", "a", "alpha", "beta"};
    return symbols[static_cast<std::size_t>(parameter)];
}

Message words_of(JointParameter parameter) {
    static constexpr Message (*words[])() = {tell<"joint angle">, tell<"offset">, tell<"link length">,
                                             tell<"twist">, tell<"second twist">};
    return words[static_cast<std::size_t>(parameter)]();
}

std::string reading_symbol(const SerialRobotSource& robot, std::size_t joint) {
    return (robot.joints()[joint].slides ? "s_" : "q_") + std::to_string(joint + 1);
}

std::size_t first_sliding_joint(const SerialRobotSource& robot) {
    for (std::size_t i = 0; i < robot.joints().size(); ++i)
        if (robot.joints()[i].slides) return i + 1;
    return 0;
}

std::size_t first_coupled_joint(const SerialRobotSource& robot) {
    for (std::size_t i = 0; i < robot.joints().size(); ++i)
        if (robot.joints()[i].moved_by != RobotJoint::alone) return i + 1;
    return 0;
}

std::vector<Eigen::Isometry3d> link_frames(const SerialRobotSource& robot, const std::vector<double>& q) {
    std::vector<Eigen::Isometry3d> frames{Eigen::Isometry3d::Identity()};
    for (std::size_t i = 0; i < robot.joints().size(); ++i) {
        const RobotJoint& joint = robot.joints()[i];
        JointValues<double> values = joint.values;
        (joint.slides ? values.d : values.theta) += travel_of(robot.joints(), i, q);
        const JointTransform<double> T = joint_transform(values, true);
        Matrix3<double> R = Matrix3<double>::Identity();
        Vector3<double> p = Vector3<double>::Zero();
        apply_to_axes(robot.convention(), T, R);
        apply(robot.convention(), T, p);
        Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
        X.linear() = R;
        X.translation() = p;
        frames.push_back(frames.back() * X);
    }
    frames.push_back(frames.back() * robot.X_FT());
    return frames;
}

double standard_uncertainty_of(const SerialRobotSource& robot, std::size_t joint, JointParameter parameter) {
    double squares = 0.0;
    for (const ParameterDeviation& d : robot.deviations())
        if (d.joint == joint && d.parameter == parameter)
            squares += std::pow(d.component.distribution.standard_uncertainty(), 2);
    return std::sqrt(squares);
}

namespace {

struct Combined {
    std::map<std::string, double> by_source;
    double squares = 0.0, welch = 0.0;  // sums of u^2, and of u^4 over the degrees of freedom
};

Combined combined(const SerialRobotSource& robot, std::size_t joint, JointParameter parameter) {
    Combined sum;
    for (const ParameterDeviation& d : robot.deviations()) {
        if (d.joint != joint || d.parameter != parameter) continue;
        const double u = d.component.distribution.standard_uncertainty();
        sum.by_source[d.component.origin.english()] += u * u;
        sum.squares += u * u;
        sum.welch += std::pow(u, 4) / degrees_of_freedom_of(d.component);
    }
    return sum;
}

std::vector<std::string> sources_of(const SerialRobotSource& robot) {
    std::vector<std::string> sources;
    for (const ParameterDeviation& d : robot.deviations()) {
        const std::string source = d.component.origin.english();
        if (std::find(sources.begin(), sources.end(), source) == sources.end()) sources.push_back(source);
    }
    return sources;
}

void add_row(const SerialRobotSource& robot, const std::vector<std::string>& sources, std::size_t i,
             JointParameter p, Table& table) {
    const Unit unit = is_length(p) ? Unit::of("mm") : Unit::of("deg");
    const double value = robot.joints()[i].values[p];
    const Combined sum = combined(robot, i, p);
    const double u = std::sqrt(sum.squares);
    const auto cell = [&](double si) { return Cell(Quantity{unit.interval_from_si(si), unit}); };
    std::vector<Cell> row{std::string(symbol_of(p)) + "_" + std::to_string(i + 1), cell(value)};
    for (const std::string& source : sources) {
        const auto found = sum.by_source.find(source);
        row.push_back(found == sum.by_source.end() ? Cell{} : cell(std::sqrt(found->second)));
    }
    row.insert(row.end(), {cell(u), cell(2 * u), cell(value - 2 * u), cell(value + 2 * u)});
    row.push_back(sum.welch > 0 ? Cell(sum.squares * sum.squares / sum.welch) : Cell{});
    table.row(std::move(row));
}

}  // namespace

Table parameter_table(const SerialRobotSource& robot) {
    Table table{"parameters", "Parameters and their uncertainty"};
    table.add("parameter");
    table.add("value");
    const std::vector<std::string> sources = sources_of(robot);
    for (const std::string& source : sources) table.add("u, " + source).figure(2);
    table.add("u").figure(2);
    table.add("U = 2 u").figure(2);
    for (const char* header : {"value − U", "value + U"}) table.add(header).estimate_of("U = 2 u");
    table.add("nu_eff").symbol().figure(3);
    for (std::size_t i = 0; i < robot.joints().size(); ++i)
        for (JointParameter p : joint_parameters)
            if (robot.joints()[i].has(p)) add_row(robot, sources, i, p, table);
    table.notes.push_back(
        tell<
            "Components of a parameter combine in quadrature (Wen et al., Eq. 10). U has the factor 2 of the "
            "paper; with few effective degrees of freedom 95 % need more.">());
    return table;
}

}  // namespace covaria
