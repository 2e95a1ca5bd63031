// An arm of joints that turn or slide with its parameters, their components of uncertainty, limits and tool.
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/kinds/robot/arm.h"
#include "core/kinds/robot/asset.h"
#include "core/kinds/robot/fields.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

std::string row_path(const char* table, std::size_t row) {
    return std::string("/") + table + "/rows/" + std::to_string(row);
}

Distribution distribution_of(const std::string& kind, double u) {
    const double half = u * std::numbers::sqrt3;
    if (kind == "rectangular") return Distribution::of(Rectangular{-half, half});
    if (kind == "triangular")
        return Distribution::of(Triangular{-half * std::numbers::sqrt2, half * std::numbers::sqrt2});
    return Distribution::normal(u);
}

/// "Joint range" -> "joint-range", as part of a component's id.
std::string id_part(const std::string& text) {
    std::string id;
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        id += std::isalnum(u) ? static_cast<char>(std::tolower(u)) : '-';
    }
    return id;
}

class RobotReading {
public:
    RobotReading(const SetupReader& setup, Problems& problems) : setup_(setup), problems_(problems) {}

    std::optional<RobotData> read() {
        data_.convention =
            setup_.text("convention") == "craig" ? DhConvention::craig : DhConvention::modified;
        data_.X_WB = setup_.pose("base");
        data_.X_FT = setup_.pose("tool");
        data_.u_tool_position = setup_.number("u_tool_position");
        data_.u_tool_angle = setup_.number("u_tool_angle");
        if (setup_.rows("joints") > most_joints)
            problems_.error("/joints", "an arm has at most " + std::to_string(most_joints) + " joints here");
        for (std::size_t row = 0; row < setup_.rows("joints"); ++row) read_joint(row);
        for (std::size_t row = 0; row < setup_.rows("uncertainties"); ++row) read_uncertainties(row);
        for (std::size_t row = 0; row < setup_.rows("correlations"); ++row) read_correlation(row);
        if (problems_.has_errors()) return {};
        return std::move(data_);
    }

private:
    double optional_number(std::size_t row, const char* column, double otherwise) const {
        return setup_.cell_empty("joints", row, column) ? otherwise
                                                        : setup_.cell_number("joints", row, column);
    }

    void read_joint(std::size_t row) {
        RobotJoint joint;
        for (JointParameter p : joint_parameters) joint.values[p] = optional_number(row, symbol_of(p), 0.0);
        joint.parallel = !setup_.cell_empty("joints", row, "beta");
        joint.slides =
            !setup_.cell_empty("joints", row, "type") && setup_.cell_text("joints", row, "type") == "sliding";
        const auto column = [&](const char* turning, const char* sliding) {
            refuse_other(row, joint.slides ? turning : sliding, joint.slides);
            return joint.slides ? sliding : turning;
        };
        joint.zero = optional_number(row, column("q_zero", "s_zero"), 0.0);
        joint.low = optional_number(row, column("q_min", "s_min"), joint.low);
        joint.high = optional_number(row, column("q_max", "s_max"), joint.high);
        if (!setup_.cell_empty("joints", row, "direction") &&
            setup_.cell_text("joints", row, "direction") == "negative")
            joint.direction = -1.0;
        data_.u_encoder.push_back(optional_number(row, column("u_encoder", "u_s_encoder"), 0.0));
        data_.u_repeatability.push_back(
            optional_number(row, column("u_repeatability", "u_s_repeatability"), 0.0));
        check_joint(joint, row);
        data_.joints.push_back(joint);
    }

    void refuse_other(std::size_t row, const std::string& column, bool slides) {
        if (setup_.cell_empty("joints", row, column)) return;
        problems_.error(row_path("joints", row) + "/" + column,
                        "joint " + std::to_string(row + 1) +
                            (slides ? " slides: state its readings as lengths, in the columns of s"
                                    : " turns: state its readings as angles, or give it the type sliding"));
    }

    void check_joint(const RobotJoint& joint, std::size_t row) {
        const std::string name = "joint " + std::to_string(row + 1);
        const std::string path = row_path("joints", row);
        if (joint.parallel && setup_.text("convention") != "modified")
            problems_.error(path + "/beta",
                            "only the convention with Ry(beta) has a beta; leave it empty for " + name +
                                ", or choose that convention");
        if (joint.parallel && joint.values.d != 0.0)
            problems_.error(path + "/d",
                            "d and beta of " + name +
                                " describe the same place of a parallel axis: where beta is given, "
                                "d is 0 by definition");
        if (!(joint.low < joint.high))
            problems_.error(path + "/q_min", "the lowest reading of " + name + " is not below its highest");
    }

    void read_uncertainties(std::size_t row) {
        const std::string path = row_path("uncertainties", row);
        const bool all = setup_.cell_empty("uncertainties", row, "joint");
        std::size_t first = 0, last = data_.joints.size();
        if (!all) {
            first = static_cast<std::size_t>(setup_.cell_number("uncertainties", row, "joint")) - 1;
            last = first + 1;
        }
        if (last > data_.joints.size())
            return problems_.error(path + "/joint", "the robot has no joint " + std::to_string(last));
        for (std::size_t joint = first; joint < last; ++joint)
            for (JointParameter p : joint_parameters) add_component(row, joint, p, all);
    }

    void add_component(std::size_t row, std::size_t joint, JointParameter p, bool all) {
        const std::string key = uncertainty_key(p);
        if (setup_.cell_empty("uncertainties", row, key)) return;
        const double u = setup_.cell_number("uncertainties", row, key);
        if (u == 0.0) return;
        const std::string symbol = std::string(symbol_of(p)) + "_" + std::to_string(joint + 1);
        if (!data_.joints[joint].has(p)) {
            if (!all)
                problems_.error(
                    row_path("uncertainties", row) + "/" + key,
                    symbol + (p == JointParameter::d
                                  ? " is 0 by definition, because the axis is parallel to the next"
                                  : " is no parameter of this robot: give beta in the table of joints"
                                    " where axes are parallel"));
            return;
        }
        data_.deviations.push_back({joint, p, component(row, symbol, u, is_length(p) ? "mm" : "deg")});
    }

    UncertaintyComponent component(std::size_t row, const std::string& symbol, double u, const char* unit) {
        const std::string source = setup_.cell_text("uncertainties", row, "source");
        const std::string kind = setup_.cell_empty("uncertainties", row, "distribution")
                                     ? "normal"
                                     : setup_.cell_text("uncertainties", row, "distribution");
        UncertaintyComponent c{.id = symbol + "." + id_part(source),
                               .name = symbol + ", " + source,
                               .unit = Unit::of(unit),
                               .distribution = distribution_of(kind, u),
                               .origin = source};
        if (const int again = ++ids_[c.id]; again > 1) c.id += "-" + std::to_string(again);
        if (!setup_.cell_empty("uncertainties", row, "dof")) {
            c.degrees_of_freedom = setup_.cell_number("uncertainties", row, "dof");
            c.type = EvaluationType::type_a;
        }
        return c;
    }

    void read_correlation(std::size_t row) {
        const std::optional<std::size_t> first = deviation_called(row, "first");
        const std::optional<std::size_t> second = deviation_called(row, "second");
        if (!first || !second) return;
        if (*first == *second)
            return problems_.error(row_path("correlations", row),
                                   "a parameter is correlated with itself; name two different ones");
        data_.correlations.push_back({*first, *second, setup_.cell_number("correlations", row, "r")});
    }

    /// The one deviation of the parameter named in a cell; empty after an error.
    std::optional<std::size_t> deviation_called(std::size_t row, const char* column) {
        const std::string symbol = setup_.cell_text("correlations", row, column);
        std::optional<std::size_t> found;
        std::size_t count = 0;
        for (std::size_t i = 0; i < data_.deviations.size(); ++i) {
            const ParameterDeviation& d = data_.deviations[i];
            if (symbol != std::string(symbol_of(d.parameter)) + "_" + std::to_string(d.joint + 1)) continue;
            found = i;
            ++count;
        }
        if (count == 1) return found;
        problems_.error(row_path("correlations", row) + "/" + column,
                        count == 0 ? "there is no parameter '" + symbol +
                                         "' with an uncertainty; write its symbol, such as d_3"
                                   : symbol +
                                         " has several components of uncertainty: give it one, the "
                                         "combined, so that it can be correlated");
        return {};
    }

    const SetupReader& setup_;
    Problems& problems_;
    RobotData data_;
    std::map<std::string, int> ids_;
};

std::unique_ptr<Asset> create_robot(const SetupReader& setup, const AssetLibrary&, Problems& problems) {
    std::optional<RobotData> data = RobotReading(setup, problems).read();
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
    d.schema = robot_schema();
    d.create = create_robot;
    return d;
}

}  // namespace covaria
