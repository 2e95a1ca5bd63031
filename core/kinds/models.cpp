// The list of measurement models.
#include "core/kinds/models.h"

#include "core/kinds/ballbar/model.h"
#include "core/kinds/curve/model.h"
#include "core/kinds/equation/model.h"
#include "core/kinds/force/channels.h"
#include "core/kinds/force/loads.h"
#include "core/kinds/groups/model.h"
#include "core/kinds/network/model.h"
#include "core/kinds/pose/model.h"
#include "core/kinds/robot/model.h"
#include "core/kinds/robot_identification/from_poses_model.h"
#include "core/kinds/robot_identification/from_trajectories_model.h"

namespace covaria {

const std::vector<ModelDescriptor>& model_registry() {
    static const std::vector<ModelDescriptor> models{
        pose_from_points_model(),  points_from_sensors_model(), tcp_from_ballbars_model(),
        robot_pose_model(),        robot_circle_points_model(), robot_calibration_model(),
        force_channels_model(),    force_loads_model(),         measurement_equation_model(),
        calibration_curve_model(), group_observations_model()};
    return models;
}

const ModelDescriptor* find_model(const std::string& id) {
    for (const ModelDescriptor& descriptor : model_registry())
        if (descriptor.id == id) return &descriptor;
    return nullptr;
}

}  // namespace covaria
