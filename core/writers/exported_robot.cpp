#include "core/writers/exported_robot.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/unit.h"
#include "core/math/rotation.h"
#include "core/result/representation.h"
#include "core/setup/message_text.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

struct RobotCandidate {
    std::size_t entry = 0;  ///< number in the graph
    std::string id, name;
    ArmFrames arm;
};

class RobotSearch {
public:
    explicit RobotSearch(const WriterSource& source)
        : made_(source.made), project_(source.made.project()), graph_(source.made.graph()) {
        for (const EvaluatedAnalysis& evaluated : source.analyses) {
            for (std::size_t k = 0; k < project_.analyses.size(); ++k)
                if (project_.analyses[k].id == evaluated.analysis->id) add(graph_.number_of_analysis(k));
        }
        if (source.analyses.empty())
            for (std::size_t k = 0; k < project_.assets.size(); ++k) consider(k);
    }

    Result<RobotCandidate> only() {
        std::erase_if(found_, [&](const RobotCandidate& robot) { return is_origin(robot); });
        if (found_.empty())
            return fail(ErrorCode::bad_input,
                        tell<"there is no robot to write: no analysis uses or finds one">());
        if (found_.size() == 1) return found_.front();
        std::vector<std::string> ids;
        for (const RobotCandidate& robot : found_) ids.push_back(robot.id);
        return fail(ErrorCode::bad_input,
                    tell<"the file is of one robot, and there are %1: choose an analysis that uses or finds "
                         "the one to write (--analysis)">(listed(ids)));
    }

private:
    void add(std::size_t analysis) {
        consider(analysis);
        for (const std::size_t entry : graph_.used_by(analysis)) consider(entry);
    }

    void consider(std::size_t entry) {
        if (!seen_.insert(entry).second) return;
        if (graph_.is_asset(entry)) {
            const AssetEntry& asset = project_.assets[entry];
            const auto* made = made_.assets().find(asset.id);
            if (auto arm = arm_frames(made ? made->asset.get() : nullptr))
                found_.push_back({entry, asset.id, asset.name, std::move(*arm)});
            return;
        }
        const AnalysisEntry& analysis = project_.analyses[entry - graph_.number_of_analysis(0)];
        const auto prepared = made_.analysis(analysis.id);
        const auto asset = prepared ? prepared->model->as_asset(analysis.id) : nullptr;
        if (auto arm = arm_frames(asset.get()))
            found_.push_back({entry, analysis.id, analysis.name, std::move(*arm)});
    }

    /// Whether another robot was made from this one: nominal geometry of one that was identified.
    bool is_origin(const RobotCandidate& robot) const {
        return std::any_of(found_.begin(), found_.end(), [&](const RobotCandidate& other) {
            const auto used = graph_.used_by(other.entry);
            return std::binary_search(used.begin(), used.end(), robot.entry);
        });
    }

    const MadeProject& made_;
    const Project& project_;
    const EntryGraph& graph_;
    std::set<std::size_t> seen_;
    std::vector<RobotCandidate> found_;
};

const OutputResult* result_of(const WriterSource& source, const OutputReference& output) {
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        if (evaluated.analysis->id != output.analysis || !represents_measurand(*evaluated.result)) continue;
        for (const OutputResult& result : evaluated.result->outputs)
            if (result.quantity.group == output.group && result.quantity.symbol == output.symbol)
                return &result;
    }
    return nullptr;
}

std::string parameter_words(const ArmParameter& parameter, double u) {
    const Unit unit = Unit::of(parameter.length ? "mm" : "deg");
    std::string words = parameter.symbol + " = " +
                        format_trimmed(unit.interval_from_si(parameter.value), 12) + " " +
                        (parameter.length ? "mm" : "deg");
    if (u > 0)
        words +=
            " (u = " + format_trimmed(unit.interval_from_si(u), 3) + (parameter.length ? " mm)" : " deg)");
    return words;
}

}  // namespace

Result<ExportedRobot> exported_robot(const WriterSource& source) {
    auto found = RobotSearch(source).only();
    if (!found) return fail(found.error());
    if (const std::size_t coupled = found->arm.first_coupled)
        return fail(
            ErrorCode::bad_input,
            tell<"joint %1 is moved along by another, which files of this kind cannot state">(coupled));
    ExportedRobot robot{found->id, found->name, std::move(found->arm), {}, {}};
    robot.parameters.resize(robot.arm.joints.size());
    std::set<std::string> without;
    std::size_t stated = 0;
    for (ArmParameter& parameter : robot.arm.parameters) {
        if (parameter.output) {
            const OutputResult* result = result_of(source, *parameter.output);
            if (!result) without.insert(parameter.output->analysis);
            parameter.u = result ? result->standard_uncertainty : 0.0;
        }
        stated += parameter.u > 0;
        std::string& line = robot.parameters[parameter.joint];
        line += (line.empty() ? "" : ", ") + parameter_words(parameter, parameter.u);
    }
    robot.said.push_back("robot " + robot.id + ", " + std::to_string(robot.arm.joints.size()) + " joints; " +
                         std::to_string(stated) +
                         " parameters with their standard uncertainty, as comments: the format has no place "
                         "for uncertainties, nor for their correlation");
    for (const std::string& analysis : without)
        robot.said.push_back("without the uncertainties that analysis " + analysis +
                             " gives: choose it as well");
    return robot;
}

std::array<double, 3> roll_pitch_yaw(const Eigen::Matrix3d& R) {
    const Eigen::Vector3d angles = zyx_from_rotation<double>(R);
    return {angles[0], angles[1], angles[2]};
}

std::string pose_words(const Eigen::Isometry3d& X) {
    static const Unit mm = Unit::of("mm"), deg = Unit::of("deg");
    const auto three = [](const Unit& unit, const auto& v) {
        return "(" + format_trimmed(unit.interval_from_si(v[0]), 6) + ", " +
               format_trimmed(unit.interval_from_si(v[1]), 6) + ", " +
               format_trimmed(unit.interval_from_si(v[2]), 6) + ") ";
    };
    return three(mm, X.translation()) + "mm, turned by " + three(deg, roll_pitch_yaw(X.linear())) + "deg";
}

}  // namespace covaria
