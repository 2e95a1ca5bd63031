// Conversion of a chain of URDF joints to parameters of Eq 5.
#include "core/kinds/robot/urdf.h"

#include <cmath>

#include "core/kinds/robot/fields.h"
#include "core/kinds/robot/urdf_chain.h"
#include "core/math/axis_frames.h"
#include "core/math/rotation.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

using urdf::Chain;

/// Below this sine two axes are parallel: the foot of their common perpendicular is then hardly determined.
constexpr double parallel_limit = 1e-3;
constexpr double no_length = 1e-9;

Eigen::Vector3d normal_part(const Eigen::Vector3d& v, const Eigen::Vector3d& z) {
    return v - z * z.dot(v);
}

/// Axes of the moving joints and the tip at readings of zero, in the frame of the root link.
struct Axes {
    std::vector<AxisLine<double>> lines;
    std::vector<urdf::Joint> joints;
    Eigen::Isometry3d X_tip = Eigen::Isometry3d::Identity();
};

Axes axes_of(const Chain& chain) {
    Axes axes;
    for (const urdf::Joint& joint : chain.joints) {
        axes.X_tip = axes.X_tip * joint.X_PJ;
        if (!joint.moves()) continue;
        axes.lines.push_back({axes.X_tip.translation(), axes.X_tip.linear() * joint.axis});
        axes.joints.push_back(joint);
    }
    return axes;
}

struct FrameChain {
    std::vector<AxisFrame<double>> frames;  ///< 0 ... n
    std::vector<bool> parallel;             ///< axes j and j + 1, n − 1 of them
};

/// z along the first axis, origin next to that of the root link, x as near as may be to its x.
AxisFrame<double> first_frame(const AxisLine<double>& axis) {
    AxisFrame<double> f;
    f.z = axis.direction;
    f.o = axis.point - f.z * f.z.dot(axis.point);
    const Eigen::Vector3d x = normal_part(Eigen::Vector3d::UnitX(), f.z);
    f.x = (x.norm() > 0.1 ? x : normal_part(Eigen::Vector3d::UnitZ(), f.z)).normalized();
    f.y = f.z.cross(f.x);
    return f;
}

AxisFrame<double> next_frame(const AxisFrame<double>& before, const AxisLine<double>& previous,
                             const AxisLine<double>& axis, bool parallel) {
    using namespace axis_detail;
    if (!parallel) {
        const Eigen::Vector3d a = foot(previous, axis) - foot(axis, previous);
        const Eigen::Vector3d n = previous.direction.cross(axis.direction);
        const double side = a.norm() > no_length ? a.dot(n) : n.dot(before.x) + 1e-6 * n.dot(before.y);
        return skew_frame(previous, axis, side < 0.0 ? -1.0 : 1.0);
    }
    AxisFrame<double> f;
    f.z = axis.direction;
    f.o = meets(axis, before.o, before.z);
    const Eigen::Vector3d h = f.o - before.o;
    // Both are the same line: any x will do, so that of the frame before is kept.
    f.y = (h.norm() > no_length ? f.z.cross(h) : f.z.cross(before.x)).normalized();
    f.x = f.y.cross(f.z);
    return f;
}

/// Along the last axis to the foot of the tip; x that of the tip where it can be.
AxisFrame<double> last_frame(const AxisFrame<double>& before, const Eigen::Isometry3d& X_tip) {
    AxisFrame<double> f = before;
    f.o = before.o + before.z * before.z.dot(X_tip.translation() - before.o);
    if (X_tip.linear().col(2).dot(before.z) > 1.0 - 1e-12) {
        f.x = normal_part(X_tip.linear().col(0), f.z).normalized();
        f.y = f.z.cross(f.x);
    }
    return f;
}

FrameChain frames_of(const Axes& axes) {
    FrameChain chain;
    chain.frames.push_back(first_frame(axes.lines.front()));
    for (std::size_t j = 1; j < axes.lines.size(); ++j) {
        const AxisLine<double>&previous = axes.lines[j - 1], &axis = axes.lines[j];
        const bool parallel = previous.direction.cross(axis.direction).norm() < parallel_limit;
        chain.parallel.push_back(parallel);
        chain.frames.push_back(next_frame(chain.frames.back(), previous, axis, parallel));
    }
    chain.frames.push_back(last_frame(chain.frames.back(), axes.X_tip));
    return chain;
}

Eigen::Isometry3d pose_of(const AxisFrame<double>& f) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() << f.x, f.y, f.z;
    X.translation() = f.o;
    return X;
}

/// Without the digits that conversion made up: what is next to a whole number of 1e-9 mm or degrees is that
/// number. Other digits stay: the tool is that of the file to the last.
double plain(double value) {
    const double whole = std::round(value * 1e9) / 1e9;
    return (std::abs(value - whole) <= 2e-12 * std::max(1.0, 1e-3 * std::abs(value)) ? whole : value) + 0.0;
}

/// Position and angles of a pose; entries left by rounding go first, so that the first angle is 0 in gimbal
/// lock.
PoseValue pose_value(const Eigen::Isometry3d& X) {
    PoseValue pose;
    const Eigen::Matrix3d R =
        X.linear().unaryExpr([](double v) { return std::round(v * 1e15) / 1e15 + 0.0; });
    const Eigen::Vector3d angles = zyx_from_rotation<double>(R);
    for (std::size_t k = 0; k < 3; ++k) {
        pose.position[k] = plain(pose.length_unit.from_si(X.translation()[static_cast<Eigen::Index>(k)]));
        pose.angles[k] = plain(pose.angle_unit.from_si(angles[static_cast<Eigen::Index>(k)]));
    }
    return pose;
}

SetupTable joints_table(const Axes& axes, const FrameChain& chain) {
    static const SetupSchema schema = robot_fields().schema();
    const FieldSpec& field = *schema.find("joints");
    SetupTable table;
    for (const ColumnSpec& column : field.columns) table.units.push_back(column.unit);
    const auto put = [&](std::vector<SetupCell>& row, const std::string& key, double si) {
        const std::size_t column = SetupSchema::column(field, key);
        row[column] = plain(table.units[column].from_si(si));
    };
    for (std::size_t j = 0; j < axes.joints.size(); ++j) {
        const bool parallel = j < chain.parallel.size() && chain.parallel[j];
        const AxisFrame<double>&a = chain.frames[j], &b = chain.frames[j + 1];
        const AxisPair pair = !parallel            ? AxisPair::skew
                              : a.z.dot(b.z) < 0.0 ? AxisPair::opposite
                                                   : AxisPair::parallel;
        const JointValues<double> v = parameters_between(a, b, pair);
        std::vector<SetupCell> row(field.columns.size());
        for (JointParameter p : joint_parameters)
            if (p != JointParameter::beta || parallel)
                put(row, symbol_of(p), parallel && p == JointParameter::d ? 0.0 : v[p]);
        const bool slides = axes.joints[j].kind == urdf::JointKind::sliding;
        if (slides) row[SetupSchema::column(field, "type")] = std::string("sliding");
        if (axes.joints[j].limited) {
            put(row, slides ? "s_min" : "q_min", axes.joints[j].low);
            put(row, slides ? "s_max" : "q_max", axes.joints[j].high);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string notes_of(const Chain& chain, const Axes& axes) {
    std::string names, remarks;
    for (const urdf::Joint& joint : axes.joints) names += (names.empty() ? "" : ", ") + joint.name;
    for (const urdf::Remark& remark : chain.remarks)
        remarks += " Joint " + remark.joint + " " + remark.words.english() + ".";
    return "Imported from URDF, from link " + chain.root + " to link " + chain.tip + ". Joints: " + names +
           "." + remarks + " Nominal geometry: give the parameters their uncertainty.";
}

Message limits_of(const urdf::Joint& joint) {
    if (!joint.limited) return tell<"without limits">();
    const Unit unit = Unit::of(joint.slides() ? "mm" : "deg");
    return tell<"%1 to %2 %3">(Message::number(format_short(unit.from_si(joint.low), 6)),
                               Message::number(format_short(unit.from_si(joint.high), 6)),
                               joint.slides() ? "mm" : "deg");
}

/// The numbers in parentheses.
std::string three_numbers(const std::array<double, 3>& v) {
    return "(" + format_short(v[0], 6) + ", " + format_short(v[1], 6) + ", " + format_short(v[2], 6) + ")";
}

Message words_of(const PoseValue& pose) {
    return tell<"%1 mm, turned by %2 deg">(three_numbers(pose.position), three_numbers(pose.angles));
}

Message joint_words(std::size_t number, const urdf::Joint& joint) {
    return joint.slides() ? tell<"joint %1: %2, slides, %3">(number, joint.name, limits_of(joint))
                          : tell<"joint %1: %2, turns, %3">(number, joint.name, limits_of(joint));
}

std::vector<Message> report_of(const Chain& chain, const Axes& axes, const Setup& setup) {
    std::vector<Message> lines;
    const std::size_t n = axes.joints.size();
    lines.push_back(n == 1 ? tell<"%1 joint from link %2 to link %3">(n, chain.root, chain.tip)
                           : tell<"%1 joints from link %2 to link %3">(n, chain.root, chain.tip));
    for (std::size_t j = 0; j < n; ++j) lines.push_back(joint_words(j + 1, axes.joints[j]));
    lines.push_back(tell<"tool: link %1 at %2 from the frame of the last joint">(
        chain.tip, words_of(std::get<PoseValue>(setup.values.at("tool")))));
    lines.push_back(tell<"with all readings at 0 the tool stands at %1 in link %2">(
        words_of(pose_value(axes.X_tip)), chain.root));
    for (const urdf::Remark& remark : chain.remarks) lines.push_back(remark.joint + ": " + remark.words);
    return lines;
}

}  // namespace

Result<ImportedAsset> import_urdf(const std::string& xml, const UrdfChoice& choice) {
    auto robot = urdf::read(xml);
    if (!robot) return fail(robot.error());
    auto frozen = urdf::freeze(*robot, choice.frozen);
    if (!frozen) return fail(frozen.error());
    auto chain = urdf::chain_to(*robot, choice.tip);
    if (!chain) return fail(chain.error());
    chain->remarks.insert(chain->remarks.begin(), frozen->begin(), frozen->end());
    const Axes axes = axes_of(*chain);
    if (axes.lines.size() > most_joints)
        return refused_at(
            axes.joints[most_joints].line,
            tell<"the chain to %1 has %2 moving joints; an arm has at most %3 here: freeze those before the "
                 "arm, --freeze %4=0">(chain->tip, axes.lines.size(), most_joints, axes.joints.front().name));
    const FrameChain frames = frames_of(axes);
    ImportedAsset asset{.kind = "serial-robot",
                        .name = robot->name.empty() ? "Robot" : robot->name,
                        .notes = notes_of(*chain, axes),
                        .setup = {},
                        .report = {}};
    asset.setup.values["joints"] = joints_table(axes, frames);
    asset.setup.values["base"] = pose_value(pose_of(frames.frames.front()));
    asset.setup.values["tool"] = pose_value(pose_of(frames.frames.back()).inverse() * axes.X_tip);
    asset.report = report_of(*chain, axes, asset.setup);
    return asset;
}

}  // namespace covaria
