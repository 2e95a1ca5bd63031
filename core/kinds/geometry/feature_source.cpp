#include "core/kinds/geometry/feature_source.h"

#include <algorithm>
#include <array>

namespace covaria {

namespace {

constexpr std::array<const char*, 3> place_symbols{"x", "y", "z"};
constexpr std::array<const char*, 3> component_symbols{"n_x", "n_y", "n_z"};

/// Empty: the model has no value at the estimates of its inputs.
std::vector<double> estimated_outputs(const MeasurementModel& model) {
    std::vector<double> x, y(model.outputs().size());
    for (std::size_t i = 0; i < model.inputs().quantities.size(); ++i)
        x.push_back(estimate_of(model.inputs(), i));
    return model.evaluate(x, y) ? y : std::vector<double>();
}

}  // namespace

OutputFeatures::OutputFeatures(std::string analysis, const MeasurementModel& model)
    : OutputPoints(std::move(analysis), model.outputs()) {
    const std::vector<double> y = estimated_outputs(model);
    const auto& outputs = model.outputs();
    std::map<std::string, std::map<std::string, std::size_t>> groups;
    for (std::size_t j = 0; j < outputs.size(); ++j) groups[outputs[j].group][outputs[j].symbol] = j;
    for (const auto& [name, symbols] : groups) {
        const auto has = [&](const char* symbol) { return symbols.contains(symbol); };
        const auto vector_of = [&](const std::array<const char*, 3>& of) -> std::optional<Eigen::Vector3d> {
            if (y.empty()) return {};
            return Eigen::Vector3d(y[symbols.at(of[0])], y[symbols.at(of[1])], y[symbols.at(of[2])]);
        };
        if (!coordinate(name, 0)) continue;
        Placed& placed = features_[name];
        placed.place = vector_of(place_symbols);
        if (std::all_of(component_symbols.begin(), component_symbols.end(), has))
            placed.direction = vector_of(component_symbols);
    }
}

std::optional<Eigen::Vector3d> OutputFeatures::place(const std::string& feature) const {
    const auto found = features_.find(feature);
    return found == features_.end() ? std::nullopt : found->second.place;
}

std::optional<Eigen::Vector3d> OutputFeatures::direction(const std::string& feature) const {
    const auto found = features_.find(feature);
    return found == features_.end() ? std::nullopt : found->second.direction;
}

}  // namespace covaria
