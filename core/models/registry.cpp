// The list of measurement models.
#include "core/models/registry.h"

#include "core/models/calibration_curve.h"
#include "core/models/equation.h"
#include "core/models/force_channels.h"
#include "core/models/force_loads.h"
#include "core/models/group_observations.h"
#include "core/models/points_from_sensors.h"
#include "core/models/pose_from_points.h"
#include "core/models/robot_calibration.h"
#include "core/models/robot_circle_points.h"
#include "core/models/robot_pose.h"
#include "core/models/tcp_from_ballbars.h"

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
