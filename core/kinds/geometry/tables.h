// Tables of what the points say about the features, and the layout of both.
#pragma once

#include <span>
#include <vector>

#include "core/kinds/geometry/setup.h"
#include "core/model/layout.h"
#include "core/text/table.h"

namespace covaria::geometry {

std::vector<Table> geometry_tables(const GeometrySetup& setup);

/// Warns of features that their points determine badly.
void warn_of_condition(const GeometrySetup& setup, Problems& problems);

/// `first_outputs`: of each feature.
Layout geometry_layout(const GeometrySetup& setup, const std::vector<std::size_t>& first_outputs,
                       std::span<const double> x, std::span<const double> y);

}  // namespace covaria::geometry
