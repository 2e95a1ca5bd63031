#include "core/kinds/registries.h"

#include <algorithm>

#include "core/kinds/ballbar/assets.h"
#include "core/kinds/ballbar/model.h"
#include "core/kinds/context/assets.h"
#include "core/kinds/curve/model.h"
#include "core/kinds/equation/model.h"
#include "core/kinds/force/assets.h"
#include "core/kinds/force/channels.h"
#include "core/kinds/force/loads.h"
#include "core/kinds/geometry/model.h"
#include "core/kinds/groups/model.h"
#include "core/kinds/instruments/assets.h"
#include "core/kinds/laboratory/assets.h"
#include "core/kinds/network/adjusted_model.h"
#include "core/kinds/network/asset.h"
#include "core/kinds/network/model.h"
#include "core/kinds/points/assets.h"
#include "core/kinds/pose/model.h"
#include "core/kinds/robot/asset.h"
#include "core/kinds/robot/model.h"
#include "core/kinds/robot_identification/from_poses_model.h"
#include "core/kinds/robot_identification/from_readings_model.h"
#include "core/kinds/robot_identification/from_trajectories_model.h"
#include "core/kinds/robot_identification/hand_eye_model.h"
#include "core/kinds/sheets/history_model.h"
#include "core/kinds/sheets/models.h"
#include "core/kinds/sheets/robot_poses_model.h"
#include "core/kinds/sheets/tracker_tests_model.h"

namespace covaria {
namespace {

template <class Descriptor>
const Descriptor* find(const std::vector<Descriptor>& descriptors, std::string Descriptor::*key,
                       const std::string& wanted) {
    const auto found = std::ranges::find(descriptors, wanted, key);
    return found == descriptors.end() ? nullptr : &*found;
}

}  // namespace

const std::vector<ModelDescriptor>& model_registry() {
    static const std::vector<ModelDescriptor> models{pose_from_points_model(),
                                                     points_from_sensors_model(),
                                                     network_adjustment_model(),
                                                     geometry_from_points_model(),
                                                     feature_relations_model(),
                                                     tcp_from_ballbars_model(),
                                                     robot_pose_model(),
                                                     robot_circle_points_model(),
                                                     robot_calibration_model(),
                                                     robot_from_readings_model(),
                                                     hand_eye_model(),
                                                     force_channels_model(),
                                                     force_loads_model(),
                                                     measurement_equation_model(),
                                                     calibration_curve_model(),
                                                     group_observations_model(),
                                                     distance_meter_model(),
                                                     theodolite_model(),
                                                     robot_poses_model(),
                                                     tracker_tests_model(),
                                                     history_model(),
                                                     force_proving_model()};
    return models;
}

const ModelDescriptor* find_model(const std::string& id) {
    return find(model_registry(), &ModelDescriptor::id, id);
}

const std::vector<AssetDescriptor>& asset_registry() {
    static const std::vector<AssetDescriptor> kinds{
        artefact_points_kind(),     length_standard_kind(),     spherical_instrument_kind(),
        sensor_network_kind(),      point_specification_kind(), ballbar_set_kind(),
        robot_repeatability_kind(), serial_robot_kind(),        force_calibrator_kind(),
        force_sensor_kind(),        context_mesh_kind(),        best_capability_kind()};
    return kinds;
}

const AssetDescriptor* find_asset_kind(const std::string& kind) {
    return find(asset_registry(), &AssetDescriptor::kind, kind);
}

}  // namespace covaria
