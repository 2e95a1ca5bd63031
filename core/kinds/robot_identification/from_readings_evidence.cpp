// Evidence of the residuals of an identification about the uncertainties of what was measured.
#include <limits>
#include <map>

#include "core/kinds/robot_identification/from_readings.h"
#include "core/kinds/robot_identification/reading_figures.h"

namespace covaria::reading_identification {

namespace {

FigureOfComponent figure_of_row(const Identification& id, const Row& row,
                                const UncertaintyComponent& component) {
    const std::string place = fields().place(&Identification::u_distance);
    switch (row.kind) {
        case RowKind::from_point:
            return {"1", tell<"distances from points">(), component.unit, place};
        case RowKind::between_poses:
            return {"2", tell<"distances between poses">(), component.unit, place};
        case RowKind::from_plane:
            return {"3", tell<"distances from planes">(), component.unit, place};
        case RowKind::x:
        case RowKind::y:
        case RowKind::z:
        case RowKind::nominal_length:
            break;
    }
    if (id.locator.typed)
        return {"4", tell<"measured places">(), component.unit,
                locator_fields().place(&PointLocator::u_point)};
    return {"4 " + component.name.english(), component.name, component.unit, {}};
}

/// Figures of the components that belong to one reading or one pose; what several share, as a scale, has
/// none: the unknowns take it up.
std::map<std::size_t, FigureOfComponent> figures_of_components(const Identification& id) {
    FiguresOfReadings figures(id.inputs);
    for (std::size_t i = 0; i < id.fitted_rows; ++i) {
        const Row& row = id.rows[i];
        if (row.kind == RowKind::nominal_length) continue;  // one figure by itself has no scatter
        const bool position = row.kind == RowKind::x || row.kind == RowKind::y || row.kind == RowKind::z;
        const std::size_t owner = position ? i - static_cast<std::size_t>(row.kind) : i;
        figures.take(row.input, owner, [&](const UncertaintyComponent& component, const InputQuantity&) {
            return figure_of_row(id, row, component);
        });
    }
    for (std::size_t k = 0; k < id.poses.size(); ++k)
        for (const std::size_t reading : id.poses[k].reading)
            if (reading != nothing) figures.take(reading, id.rows.size() + k, figure_of_joint_reading);
    return figures.of_one_owner();
}

}  // namespace

void find_evidence(Identification& id, const Eigen::MatrixXd& design, const Eigen::MatrixXd& shares) {
    auto readings = std::make_shared<evidence::RedundantReadings>();
    readings->design = design.sparseView();
    readings->residuals = id.statistics.residuals;
    ComponentsOfFigures figures = add_figures(id.inputs, figures_of_components(id), shares, *readings);
    if (figures.empty()) return;
    readings->take_over = take_over_of_uncertainties();
    for (std::size_t i = 0; i < id.fitted_rows; ++i) readings->names.push_back(id.rows[i].name);
    name_standardised(id.statistics, *readings);
    id.statistics.evidence = {std::move(readings), std::move(figures)};
}

}  // namespace covaria::reading_identification
