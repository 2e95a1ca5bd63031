#include "core/kinds/robot_identification/reading_figures.h"

#include <cmath>
#include <limits>

namespace covaria {

FigureOfComponent figure_of_joint_reading(const UncertaintyComponent& component, const InputQuantity& input) {
    const auto is_called = [&](const char* id) { return component.id == input.symbol + "." + id; };
    if (is_called("encoder")) return {"5", tell<"encoders of the joints">(), component.unit};
    if (is_called("repeatability")) return {"6", tell<"repeatability of the joints">(), component.unit};
    return {"7", tell<"readings of the joints">(), component.unit};
}

std::map<std::size_t, FigureOfComponent> FiguresOfReadings::of_one_owner() const {
    auto figures = figures_;
    for (const std::size_t component : shared_) figures.erase(component);
    return figures;
}

void name_standardised(const identification::FitStatistics& statistics,
                       evidence::RedundantReadings& readings) {
    for (Eigen::Index row = 0; row < statistics.residuals.size(); ++row) {
        const double w = std::copysign(statistics.w[row], statistics.residuals[row]);
        readings.w.push_back(w != 0.0 ? w : std::numeric_limits<double>::quiet_NaN());
        readings.figure_of.push_back(evidence::RedundantReadings::no_figure);
    }
}

}  // namespace covaria
