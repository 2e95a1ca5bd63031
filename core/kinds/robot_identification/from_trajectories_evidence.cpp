// Evidence of the distances of measured points from the circles of the joints about their uncertainties.
#include <map>

#include "core/kinds/robot_identification/from_trajectories.h"

namespace covaria::circle_points {

namespace {

using Rows = std::vector<FitsWithSharedComponents::Row>;

/// Along the normal and along the radius of each point, in which plane and circle have three unknowns each.
Rows rows_of(const Identification& id, std::size_t joint) {
    const Trajectory& t = id.trajectories[joint];
    const CircleStart& circle = t.shape.start;
    Rows rows;
    for (std::size_t k = 0; k < t.points.size(); ++k) {
        const Eigen::Vector3d q = circle.axes.transpose() * (t.points[k] - circle.centre);
        const Eigen::Vector2d radial = q.head<2>().normalized();
        const auto add = [&](const Message& name, const Eigen::Vector3d& along, double residual) {
            FitsWithSharedComponents::Row row{name, Eigen::VectorXd::Zero(6), residual, {}};
            for (int c = 0; c < 3; ++c)
                row.parts.push_back({t.first_input + 3 * k + static_cast<std::size_t>(c), along[c]});
            rows.push_back(std::move(row));
        };
        const Message point = tell<"joint %1, point %2">(joint + 1, k + 1);
        add(tell<"%1, off the plane">(point), circle.axes.col(2), q.z());
        rows.back().design.head<3>() = Eigen::Vector3d(1.0, q.x(), q.y());
        add(tell<"%1, along the radius">(point), circle.axes.leftCols<2>() * radial,
            q.head<2>().norm() - circle.radius);
        rows.back().design.tail<3>() = Eigen::Vector3d(radial.x(), radial.y(), 1.0);
    }
    return rows;
}

std::map<std::size_t, FigureOfComponent> figures_of_components(const Identification& id) {
    std::map<std::size_t, FigureOfComponent> figures;
    for (std::size_t c = 0; c < id.inputs.components.size(); ++c) {
        const UncertaintyComponent& component = id.inputs.components[c];
        if (id.locator.typed)
            figures[c] = {"", tell<"measured places">(), component.unit,
                          locator_fields().place(&PointLocator::u_point)};
        else if (component.local)
            figures[c] = {component.name.english(), component.name, component.unit, {}};
    }
    return figures;
}

}  // namespace

ComponentEvidence evidence_of(const Identification& id) {
    if (id.simulated) return {};
    FitsWithSharedComponents fits(id.inputs);
    for (std::size_t j = 0; j < id.trajectories.size(); ++j) fits.add(rows_of(id, j));
    return fits.evidence(figures_of_components(id));
}

}  // namespace covaria::circle_points
