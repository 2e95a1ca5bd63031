// Evidence of the residuals of least-squares frames about the uncertainties that were stated of their points.
#include "core/kinds/pose/evidence.h"

#include "core/kinds/pose/equations.h"

namespace covaria::pose {

namespace {

using Row = FitsWithSharedComponents::Row;

/// A frame of the set-up: its points in frame 0, and the first of their input quantities.
struct FittedFrame {
    const FrameRule& rule;
    const std::vector<Eigen::Vector3d>& points;
    std::size_t first_input;
};

FittedFrame frame_number(const PoseSetup& setup, std::size_t number) {
    const std::size_t of_base = setup.base.least_squares ? 1 : 0;
    if (number < of_base) return {setup.base, setup.base_points, 0};
    const std::size_t k = number - of_base;
    return {setup.moving, setup.poses[k].points,
            3 * (setup.base.points.size() + k * setup.moving.points.size())};
}

/// Coordinates of its points along its axes; the six unknowns are those of its place.
std::vector<Row> rows_of(const FittedFrame& frame, const FrameFit& fit) {
    const Eigen::Matrix3d R = frame_of(frame.rule, frame.points).linear();
    std::vector<Row> rows;
    for (std::size_t i = 0; i < frame.points.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const Message point = tell<"%1, %2">(fit.set, fit.names[i]);
            Row row{tell<"%1, %2">(point, along_axes[static_cast<std::size_t>(c)]),
                    Eigen::VectorXd::Zero(6),
                    fit.residual[i][c],
                    {}};
            row.design[c] = 1.0;
            for (int k = 0; k < 3; ++k) {
                row.design[3 + k] = Eigen::Vector3d::Unit(k).cross(frame.rule.centred[i])[c];
                row.parts.push_back({frame.first_input + 3 * i + static_cast<std::size_t>(k), R(k, c)});
            }
            rows.push_back(std::move(row));
        }
    return rows;
}

/// Typed coordinates of a frame's points, or a reading of the instrument; what points share is none of them.
void add_figures_of(const PoseSetup& setup, const InputSet& inputs, Side side, std::size_t first,
                    std::size_t count, std::map<std::size_t, FigureOfComponent>& figures) {
    const bool typed = (side == Side::base ? setup.base_uncertainty : setup.moving_uncertainty).typed;
    for (std::size_t i = first; i < first + count; ++i)
        for (const Share& share : inputs.quantities[i].shares) {
            const UncertaintyComponent& component = inputs.components[share.component];
            if (!component.local) continue;
            FigureOfComponent figure{letter_of(side) + component.name.english(), {}, component.unit};
            if (!typed) {
                figure.key = component.contributor + "." + component.name.english();
                figure.name = tell<"%1, %2">(said_name(component.contributor_name), component.name);
            } else if (side == Side::base) {
                figure.name = tell<"base points, %1">(component.name);
            } else {
                figure.name = tell<"points of the moving frame, %1">(component.name);
            }
            if (typed) figure.source = frame_fields(side).place(&FrameRule::points);
            figures.insert_or_assign(share.component, std::move(figure));
        }
}

}  // namespace

ComponentEvidence evidence_of(const PoseSetup& setup, const InputSet& inputs,
                              const std::vector<FrameFit>& fits) {
    FitsWithSharedComponents stacked(inputs);
    std::map<std::size_t, FigureOfComponent> figures;
    for (std::size_t number = 0; number < fits.size(); ++number) {
        const FittedFrame frame = frame_number(setup, number);
        const std::size_t coordinates = 3 * frame.points.size();
        // A direction without stated uncertainty leaves a covariance that cannot be weighed: no evidence.
        if (fits[number].degrees_of_freedom != static_cast<int>(coordinates) - 6) continue;
        if (coordinates <= 6) continue;
        stacked.add(rows_of(frame, fits[number]));
        add_figures_of(setup, inputs, &frame.rule == &setup.base ? Side::base : Side::moving,
                       frame.first_input, coordinates, figures);
    }
    return stacked.evidence(figures);
}

}  // namespace covaria::pose
