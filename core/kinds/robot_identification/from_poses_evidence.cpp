// Evidence of the residuals of an identification about the uncertainties of the measured places and of the
// joints' readings.
#include <map>

#include "core/kinds/robot_identification/from_poses_fit.h"

namespace covaria::pose_calibration {

namespace {

using Eigen::Index;

bool is_called(const UncertaintyComponent& component, const InputQuantity& quantity, const char* id) {
    return component.id == quantity.symbol + "." + id;
}

FigureOfComponent figure_of_coordinate(const Calibration& c, const UncertaintyComponent& component,
                                       bool turn) {
    if (turn)
        return {"2", tell<"measured orientations">(), component.unit, fields().place(&Calibration::u_angle)};
    if (c.locator.typed)
        return {"1", tell<"measured places">(), component.unit,
                locator_fields().place(&PointLocator::u_point)};
    return {"1 " + component.name.english(), component.name, component.unit, {}};
}

FigureOfComponent figure_of_reading(const UncertaintyComponent& component, const InputQuantity& input) {
    if (is_called(component, input, "encoder"))
        return {"3", tell<"encoders of the joints">(), component.unit};
    if (is_called(component, input, "repeatability"))
        return {"4", tell<"repeatability of the joints">(), component.unit};
    return {"5", tell<"readings of the joints">(), component.unit};
}

/// Figures of the components of the fitted poses; components that several poses share, as a tracker's scale,
/// have none: the unknowns take them up.
std::map<std::size_t, FigureOfComponent> figures_of_components(const Calibration& c) {
    std::map<std::size_t, FigureOfComponent> figures;
    std::map<std::size_t, std::size_t> pose_of;
    std::vector<std::size_t> shared;
    for (std::size_t k = 0; k < c.fitted_poses; ++k) {
        const auto take = [&](std::size_t quantity, auto figure_of) {
            const InputQuantity& input = c.inputs.quantities[quantity];
            for (const Share& share : input.shares) {
                const auto [known, added] = pose_of.try_emplace(share.component, k);
                if (!added && known->second != k) shared.push_back(share.component);
                figures.insert_or_assign(share.component,
                                         figure_of(c.inputs.components[share.component], input));
            }
        };
        const MeasuredPose& pose = c.poses[k];
        for (std::size_t row = 0; row < c.rows_per_pose(); ++row)
            take(pose.first_input + row, [&](const UncertaintyComponent& component, const InputQuantity&) {
                return figure_of_coordinate(c, component, row >= 3);
            });
        for (std::size_t j = 0; j < c.robot().joints().size(); ++j)
            if (pose.reading[j] != no_input) take(pose.reading[j], figure_of_reading);
    }
    for (const std::size_t component : shared) figures.erase(component);
    return figures;
}

void name_rows(const Calibration& c, evidence::RedundantReadings& readings) {
    const auto m = static_cast<Index>(c.rows_per_pose());
    for (Index row = 0; row < c.statistics.residuals.size(); ++row) {
        const MeasuredPose& pose = c.poses[static_cast<std::size_t>(row / m)];
        readings.names.push_back(
            tell<"%1, %2">(pose.name, coordinate_words(static_cast<std::size_t>(row % m))));
        const double u = c.statistics.u_residuals[row];
        readings.w.push_back(u > 0.0 ? c.statistics.residuals[row] / u
                                     : std::numeric_limits<double>::quiet_NaN());
        readings.figure_of.push_back(evidence::RedundantReadings::no_figure);
    }
}

}  // namespace

void find_evidence(Calibration& c, const Eigen::MatrixXd& design, const Eigen::MatrixXd& shares) {
    auto readings = std::make_shared<evidence::RedundantReadings>();
    readings->design = design.sparseView();
    readings->residuals = c.statistics.residuals;
    ComponentsOfFigures figures = add_figures(c.inputs, figures_of_components(c), shares, *readings);
    if (figures.empty()) return;
    readings->take_over = take_over_of_uncertainties();
    name_rows(c, *readings);
    c.statistics.evidence = {std::move(readings), std::move(figures)};
}

}  // namespace covaria::pose_calibration
