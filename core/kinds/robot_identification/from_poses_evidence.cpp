// What the residuals of an identification say about the uncertainties of the measured places and of the
// joints' readings.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/evidence/redundant_readings.h"
#include "core/kinds/robot_identification/from_poses_fit.h"

namespace covaria::pose_calibration {

namespace {

using Eigen::Index;

enum class Figure { places, orientations, encoders, repeatability, other_readings };

Message words_of(Figure figure) {
    switch (figure) {
        case Figure::places:
            return tell<"measured places">();
        case Figure::orientations:
            return tell<"measured orientations">();
        case Figure::encoders:
            return tell<"encoders of the joints">();
        case Figure::repeatability:
            return tell<"repeatability of the joints">();
        case Figure::other_readings:
            break;
    }
    return tell<"readings of the joints">();
}

bool is_called(const UncertaintyComponent& component, const InputQuantity& quantity, const char* id) {
    return component.id == quantity.symbol + "." + id;
}

/// Of each component of the fitted poses the figure that states it; those that several poses share, as a
/// tracker's scale, are none: the unknowns take them up.
std::map<std::size_t, Figure> figures_of_components(const Calibration& c) {
    std::map<std::size_t, Figure> figures;
    std::map<std::size_t, std::size_t> pose_of;
    std::vector<std::size_t> shared;
    for (std::size_t k = 0; k < c.fitted_poses; ++k) {
        const auto take = [&](std::size_t quantity, auto figure_of) {
            const InputQuantity& input = c.inputs.quantities[quantity];
            for (const Share& share : input.shares) {
                const auto [known, added] = pose_of.try_emplace(share.component, k);
                if (!added && known->second != k) shared.push_back(share.component);
                figures[share.component] = figure_of(c.inputs.components[share.component], input);
            }
        };
        const MeasuredPose& pose = c.poses[k];
        for (std::size_t row = 0; row < c.rows_per_pose(); ++row)
            take(pose.first_input + row, [&](const UncertaintyComponent&, const InputQuantity&) {
                return row < 3 ? Figure::places : Figure::orientations;
            });
        for (std::size_t j = 0; j < c.robot().joints().size(); ++j)
            if (pose.reading[j] != no_input)
                take(pose.reading[j], [](const UncertaintyComponent& component, const InputQuantity& input) {
                    if (is_called(component, input, "encoder")) return Figure::encoders;
                    return is_called(component, input, "repeatability") ? Figure::repeatability
                                                                        : Figure::other_readings;
                });
    }
    for (const std::size_t component : shared) figures.erase(component);
    return figures;
}

Eigen::MatrixXd columns_of(const Eigen::MatrixXd& all, const std::vector<Index>& chosen) {
    Eigen::MatrixXd columns(all.rows(), static_cast<Index>(chosen.size()));
    for (std::size_t i = 0; i < chosen.size(); ++i) columns.col(static_cast<Index>(i)) = all.col(chosen[i]);
    return columns;
}

void add_component(evidence::StatedFigure& figure, const UncertaintyComponent& component, Figure kind) {
    const double u = component.distribution.standard_uncertainty();
    if (figure.count++ == 0) {
        const bool is_length = component.unit.interval_from_si(1.0) != 0.0 && kind == Figure::places;
        figure.unit = is_length ? Unit::of("mm") : component.unit;
        figure.least = figure.most = u;
    }
    figure.least = std::min(figure.least, u);
    figure.most = std::max(figure.most, u);
}

void name_rows(const Calibration& c, evidence::RedundantReadings& readings) {
    const auto m = static_cast<Index>(c.rows_per_pose());
    for (Index row = 0; row < c.statistics.residuals.size(); ++row) {
        const MeasuredPose& pose = c.poses[static_cast<std::size_t>(row / m)];
        readings.names.push_back(
            tell<"%1, %2">(pose.name, coordinate_words(static_cast<std::size_t>(row % m))));
        readings.sources.push_back(pose.source);
        const double u = c.statistics.u_residuals[row];
        readings.w.push_back(u > 0.0 ? c.statistics.residuals[row] / u
                                     : std::numeric_limits<double>::quiet_NaN());
        readings.figure_of.push_back(evidence::RedundantReadings::no_figure);
    }
}

}  // namespace

std::shared_ptr<const evidence::RedundantReadings> redundant_readings(const Calibration& c,
                                                                      const Eigen::MatrixXd& design,
                                                                      const Eigen::MatrixXd& shares) {
    auto readings = std::make_shared<evidence::RedundantReadings>();
    readings->design = design.sparseView();
    readings->residuals = c.statistics.residuals;
    const std::map<std::size_t, Figure> figures = figures_of_components(c);
    std::map<Figure, std::vector<Index>> members;
    std::map<Figure, evidence::StatedFigure> stated;
    std::vector<Index> others;
    for (Index column = 0; column < shares.cols(); ++column) {
        if (!(shares.col(column).squaredNorm() > 0.0)) continue;
        const auto known = figures.find(static_cast<std::size_t>(column));
        if (known == figures.end()) {
            others.push_back(column);
            continue;
        }
        members[known->second].push_back(column);
        add_component(stated[known->second], c.inputs.components[static_cast<std::size_t>(column)],
                      known->second);
    }
    if (members.empty()) return nullptr;
    for (const auto& [kind, columns] : members) {
        evidence::StatedFigure figure = stated[kind];
        figure.name = words_of(kind);
        readings->figures.push_back(std::move(figure));
        readings->shares.push_back(columns_of(shares, columns));
    }
    readings->others = columns_of(shares, others);
    name_rows(c, *readings);
    return readings;
}

}  // namespace covaria::pose_calibration
