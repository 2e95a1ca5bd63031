// Columns and choices of tables about the axes of a force/moment sensor.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/force/force_sensor.h"
#include "core/setup/fields.h"

namespace covaria {

/// Figures of the axes, one for each; empty where none is given.
using AxisFigures = std::array<std::optional<double>, most_channels>;

/// Choices of a column that names an axis, by its index in force_axes.
const std::vector<ChoiceOf<std::size_t>>& axis_choices();
/// Columns of AxisFigures.
std::array<ColumnSpec, most_channels> axis_columns(const Unit& unit, const std::string& help);

}  // namespace covaria
