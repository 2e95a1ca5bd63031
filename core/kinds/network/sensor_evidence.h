// Readings of "points from sensors" as evidence for or against the figures of the sensors.
#pragma once

#include <memory>

#include "core/evidence/redundant_readings.h"
#include "core/kinds/network/setup.h"

namespace covaria::network {

/// Evidence of given readings, with targets and stations where these find them. A figure is what a sensor
/// states of one kind of reading, and of all calibrated lengths; stations and deviations that readings share
/// are not asked about. Null: the readings are not given, nothing is redundant, or they are more than
/// `most_joint_rows`: their matrices are full.
std::shared_ptr<const evidence::RedundantReadings> sensor_evidence(const NetworkSetup& setup);

}  // namespace covaria::network
