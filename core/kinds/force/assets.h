// Assets of force measurement: sensor, calibration machine.
#pragma once

#include "core/model/asset.h"

namespace covaria {

/// A machine that loads a force/moment sensor (Kim, Eq. 5).
AssetDescriptor force_calibrator_kind();
/// A multi-axis force/moment sensor with its calibration (Kim).
AssetDescriptor force_sensor_kind();

}  // namespace covaria
