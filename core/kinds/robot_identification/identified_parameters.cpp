#include "core/kinds/robot_identification/identified_parameters.h"
#include "core/kinds/robot/serial_robot.h"

#include <cmath>
#include <numbers>

#include "core/base/name.h"

namespace covaria {

namespace {

Cell cell(JointParameter p, double si) {
    const Unit unit = Unit::of(is_length(p) ? "mm" : "deg");
    return Quantity{unit.interval_from_si(si), unit};
}

}  // namespace

Message parallel_to_the_next() {
    return tell<"the axis is parallel to the next: 0 by definition, or beta and d would describe the same">();
}

double next_to(double nominal, JointParameter parameter, double value) {
    if (is_length(parameter)) return value;
    return nominal + std::remainder(value - nominal, 2.0 * std::numbers::pi);
}

Table identified_table(const SerialRobotSource& nominal, const std::vector<IdentifiedParameter>& found,
                       const std::vector<double>& values, const Eigen::MatrixXd& covariance) {
    Table table{"identified", "Identified parameters beside the nominal ones"};
    table.add("parameter");
    table.add("nominal");
    const bool has_u = covariance.size() > 0;
    const auto add_estimate = [&](const char* head, int digits) {
        Column& column = table.add(head);
        has_u ? column.estimate_of("u") : column.figure(digits);
    };
    add_estimate("identified", 8);
    add_estimate("difference", 4);
    if (has_u) table.add("u").symbol().figure(2);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const JointParameter p = found[i].parameter;
        const double before = nominal.joints()[found[i].joint].values[p];
        std::vector<Cell> row{found[i].symbol(), cell(p, before), cell(p, values[i]),
                              cell(p, values[i] - before)};
        const auto k = static_cast<Eigen::Index>(i);
        if (has_u) row.push_back(cell(p, std::sqrt(covariance(k, k))));
        table.row(std::move(row));
    }
    return table;
}

Table held_table(const std::vector<HeldParameter>& held) {
    Table table{"not-identified", "What these points cannot tell"};
    table.add("parameter");
    table.add("reason");
    for (const HeldParameter& h : held) table.row({h.parameter, h.reason});
    return table;
}

RobotData identified_robot(const SerialRobotSource& nominal, const std::vector<IdentifiedParameter>& found,
                           const std::vector<double>& values) {
    RobotData data;
    data.convention = nominal.convention();
    data.joints = nominal.joints();
    data.X_WB = nominal.X_WB();
    data.X_FT = nominal.X_FT();
    for (std::size_t i = 0; i < found.size(); ++i)
        data.joints[found[i].joint].values[found[i].parameter] = values[i];
    return data;
}

void take_reading_uncertainties(const SerialRobotSource& robot, RobotData& data) {
    const auto figures_of = [&](const UncertaintyComponent& component) -> std::vector<double>& {
        return component.id == "encoder" ? data.u_encoder : data.u_repeatability;
    };
    for (std::size_t j = 0; j < data.joints.size(); ++j)
        for (const UncertaintyComponent& component : robot.reading(j)) {
            figures_of(component).resize(data.joints.size());
            figures_of(component)[j] = component.distribution.standard_uncertainty();
        }
}

std::shared_ptr<const Asset> robot_of_analysis(RobotData data, const std::vector<IdentifiedParameter>& found,
                                               const std::string& analysis) {
    for (const IdentifiedParameter& p : found)
        data.outputs.push_back(
            {p.joint, p.parameter, {analysis, own_name<"joint %1">(p.joint + 1), p.symbol()}});
    return std::make_shared<RobotAsset>(std::move(data));
}

}  // namespace covaria
