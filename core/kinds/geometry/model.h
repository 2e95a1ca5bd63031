// Measurement models of geometric features.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

/// Lines, planes, circles, spheres, cylinders and cones through measured points.
ModelDescriptor geometry_from_points_model();

/// Distances, angles, intersections and frames of features.
ModelDescriptor feature_relations_model();

}  // namespace covaria
