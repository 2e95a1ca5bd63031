// The list of asset kinds.
#include "core/kinds/assets.h"

#include "core/kinds/ballbar/assets.h"
#include "core/kinds/force/assets.h"
#include "core/kinds/instruments/assets.h"
#include "core/kinds/network/asset.h"
#include "core/kinds/points/assets.h"
#include "core/kinds/robot/asset.h"
#include "core/kinds/robot_identification/assets.h"

namespace covaria {

const std::vector<AssetDescriptor>& asset_registry() {
    static const std::vector<AssetDescriptor> kinds{
        artefact_points_kind(),     length_standard_kind(),     spherical_instrument_kind(),
        sensor_network_kind(),      point_specification_kind(), ballbar_set_kind(),
        robot_repeatability_kind(), serial_robot_kind(),        identified_robot_kind(),
        calibrated_robot_kind(),    force_calibrator_kind(),    force_sensor_kind()};
    return kinds;
}

const AssetDescriptor* find_asset_kind(const std::string& kind) {
    for (const AssetDescriptor& descriptor : asset_registry())
        if (descriptor.kind == kind) return &descriptor;
    return nullptr;
}

}  // namespace covaria
