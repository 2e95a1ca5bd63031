// Evidence of the residuals of an identification about the uncertainties of the measured places and of the
// joints' readings.
#include <map>

#include "core/kinds/robot_identification/from_poses_fit.h"
#include "core/kinds/robot_identification/reading_figures.h"

namespace covaria::pose_calibration {

namespace {

using Eigen::Index;

FigureOfComponent figure_of_coordinate(const Calibration& c, const UncertaintyComponent& component,
                                       bool turn) {
    if (turn)
        return {"2", tell<"measured orientations">(), component.unit, fields().place(&Calibration::u_angle)};
    if (c.locator.typed)
        return {"1", tell<"measured places">(), component.unit,
                locator_fields().place(&PointLocator::u_point)};
    return {"1 " + component.name.english(), component.name, component.unit, {}};
}

std::map<std::size_t, FigureOfComponent> figures_of_components(const Calibration& c) {
    FiguresOfReadings figures(c.inputs);
    for (std::size_t k = 0; k < c.fitted_poses; ++k) {
        const MeasuredPose& pose = c.poses[k];
        for (std::size_t row = 0; row < c.rows_per_pose(); ++row)
            figures.take(pose.first_input + row, k,
                         [&](const UncertaintyComponent& component, const InputQuantity&) {
                             return figure_of_coordinate(c, component, row >= 3);
                         });
        for (const std::size_t reading : pose.reading)
            if (reading != no_input) figures.take(reading, k, figure_of_joint_reading);
    }
    return figures.of_one_owner();
}

}  // namespace

void find_evidence(Calibration& c, const Eigen::MatrixXd& design, const Eigen::MatrixXd& shares) {
    auto readings = std::make_shared<evidence::RedundantReadings>();
    readings->design = design.sparseView();
    readings->residuals = c.statistics.residuals;
    ComponentsOfFigures figures = add_figures(c.inputs, figures_of_components(c), shares, *readings);
    if (figures.empty()) return;
    readings->take_over = take_over_of_uncertainties();
    const std::size_t m = c.rows_per_pose();
    for (std::size_t row = 0; row < c.rows(); ++row)
        readings->names.push_back(tell<"%1, %2">(c.poses[row / m].name, coordinate_words(row % m)));
    name_standardised(c.statistics, *readings);
    c.statistics.evidence = {std::move(readings), std::move(figures)};
}

}  // namespace covaria::pose_calibration
