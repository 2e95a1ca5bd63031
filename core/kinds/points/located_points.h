// Input quantities of points that one instrument, or a typed figure, locates.
#pragma once

#include <string>
#include <vector>

#include "core/kinds/points/point_uncertainty.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria {

/// Locator of points: a typed standard uncertainty of every coordinate, or an instrument of the project.
struct PointLocator {
    bool typed = true;
    double u_point = 0.0;      ///< m
    std::string distribution;  ///< shape of a deviation with u_point
    Offered<PointUncertaintySource> instrument;
};
/// Fields of the locator, in the section "Points".
const Fields<PointLocator>& locator_fields();

struct LocatedPoint {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    std::string label;        ///< "3,17": part of the symbols
    std::size_t x_input = 0;  ///< index of x; y and z follow
    std::string name = {};    ///< its name in the analysis that measured it; empty: as its label
};

/// Gives the coordinates of points, measured from one set-up, their components.
void add_point_components(const PointLocator& locator, const std::vector<LocatedPoint>& points,
                          InputSet& inputs, Problems& problems);

}  // namespace covaria
