// Results of a calibration: parameters with their covariance, observability, residuals, check poses, layout.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/kinds/robot/layout.h"
#include "core/kinds/robot_identification/from_poses.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria::pose_calibration {

namespace {

using Eigen::Index;

std::vector<double> parameter_values(const Calibration& c) {
    return {c.solution.begin() + static_cast<std::ptrdiff_t>(c.first_parameter()), c.solution.end()};
}

Eigen::MatrixXd parameter_covariance(const Calibration& c) {
    const auto n = static_cast<Index>(c.unknowns.size() - c.first_parameter());
    return c.statistics.covariance.bottomRightCorner(n, n);
}

Table check_table(const Calibration& c) {
    const Unit um = Unit::of("um");
    Table table{"check-poses", "Poses held back from the fit, calculated less measured"};
    table.add("pose");
    table.add("nominal, distance").in(um).figure(3);
    for (const char* axis : {"x", "y", "z"}) table.add(axis).in(um).symbol().figure(3);
    table.add("distance").in(um).figure(3);
    table.add("U (k = 2), largest").in(um).figure(2);
    table.add("E_n, largest").figure(2);
    const PoseStatistics& s = c.statistics;
    for (std::size_t k = c.fitted_poses; k < c.poses.size(); ++k) {
        const Index row = 3 * static_cast<Index>(k - c.fitted_poses);
        const Eigen::Vector3d d = s.deviations.segment<3>(row), u = s.u_deviations.segment<3>(row);
        const double ratio = d.cwiseAbs().cwiseQuotient(2.0 * u.cwiseMax(1e-300)).maxCoeff();
        table.row({c.poses[k].name, s.before.segment<3>(row).norm(), d.x(), d.y(), d.z(), d.norm(),
                   2.0 * u.maxCoeff(), ratio});
    }
    table.notes = {
        tell<"Nominal: the same base and ball fitted with the nominal parameters. E_n = |d|/U: below 1 the "
             "pose agrees with the calibration.">()};
    return table;
}

}  // namespace

Message coordinate_words(std::size_t coordinate) {
    static const char* const axes[] = {"x", "y", "z"};
    return coordinate < 3 ? Message(axes[coordinate]) : tell<"rotation about %1">(axes[coordinate - 3]);
}

Message Unknown::name() const {
    if (kind == UnknownKind::parameter) return parameter.symbol();
    const Message words = coordinate_words(coordinate);
    return kind == UnknownKind::base ? tell<"base %1">(words) : tell<"tool %1">(words);
}

std::size_t Calibration::first_parameter() const {
    std::size_t first = 0;
    while (first < unknowns.size() && unknowns[first].kind != UnknownKind::parameter) ++first;
    return first;
}

std::vector<IdentifiedParameter> Calibration::parameters() const {
    std::vector<IdentifiedParameter> found;
    for (const Unknown& u : unknowns)
        if (u.kind == UnknownKind::parameter) found.push_back(u.parameter);
    return found;
}

std::vector<Message> Calibration::names() const {
    std::vector<Message> names;
    for (const Unknown& u : unknowns) names.push_back(u.name());
    return names;
}

std::vector<Table> tables(const Calibration& c) {
    std::vector<Table> all{
        identified_table(c.robot(), c.parameters(), parameter_values(c), parameter_covariance(c)),
        held_table(c.held)};
    for (Table& table : observability_tables(c.statistics, c.names(), tell<"coordinates in the fit">()))
        all.push_back(std::move(table));
    std::vector<std::string> fitted;
    for (std::size_t k = 0; k < c.fitted_poses; ++k) fitted.push_back(c.poses[k].name);
    if (!c.simulated) all.push_back(residual_table(c.statistics, fitted));
    if (c.fitted_poses < c.poses.size()) all.push_back(check_table(c));
    return all;
}

/// The arm as identified in its first pose, and all measured points; some of them with their uncertainty.
Layout layout(const Calibration& c) {
    Layout layout;
    RobotData data = identified(c);
    data.X_FT = c.X_FT;
    add_arm(RobotSource(std::move(data)), c.poses.front().q, "", layout);
    const std::size_t every = std::max<std::size_t>(1, c.poses.size() / 6);
    for (std::size_t k = 0; k < c.poses.size(); ++k) {
        const MeasuredPose& pose = c.poses[k];
        const bool shown = k % every == every / 2;
        LayoutPoint point{.name = pose.check || shown ? pose.name : "",
                          .kind = pose.check ? PointKind::ball : PointKind::target,
                          .p_W = pose.p};
        point.source.path = pose.source;
        if (shown) point.inputs = {{pose.first_input, pose.first_input + 1, pose.first_input + 2}};
        layout.points.push_back(std::move(point));
    }
    layout.uncertain_points = c.poses.size();
    return layout;
}

RobotData identified(const Calibration& c) {
    RobotData data = identified_robot(c.robot(), c.parameters(), parameter_values(c));
    data.X_WB = c.X_MB;
    take_reading_uncertainties(c.robot(), data);
    return data;
}

}  // namespace covaria::pose_calibration
