// The asset kinds of this folder, one function each; registry.cpp lists them.
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// An artefact with calibrated points, measured repeatedly (Porath et al., 2.1, Eqs 1-3).
AssetDescriptor artefact_points_kind();
/// A calibrated length measured in several positions (Porath et al., 2.2, Eqs 4-6).
AssetDescriptor length_standard_kind();
/// An instrument that measures distance and two angles, standing somewhere.
AssetDescriptor spherical_instrument_kind();
/// Instruments that measure the same points together (Galetto et al.).
AssetDescriptor sensor_network_kind();
/// A manufacturer's figure for the uncertainty of a measured point.
AssetDescriptor point_specification_kind();
/// Telescopic ballbars that measure to one ball at once (Brosed et al., 2.1).
AssetDescriptor ballbar_set_kind();
/// How far a robot misses a pose it was sent to before (ISO 9283).
AssetDescriptor robot_repeatability_kind();
/// An arm of rotating joints (Wen et al., Eq. 5).
AssetDescriptor serial_robot_kind();
/// A robot with the parameters of an identification by joint trajectories (Wen et al., 2.1).
AssetDescriptor identified_robot_kind();
/// A robot with the parameters of an identification by least squares from measured poses.
AssetDescriptor calibrated_robot_kind();
/// A machine that loads a force/moment sensor (Kim, Eq. 5).
AssetDescriptor force_calibrator_kind();
/// A multi-axis force/moment sensor with its calibration (Kim).
AssetDescriptor force_sensor_kind();

}  // namespace covaria
