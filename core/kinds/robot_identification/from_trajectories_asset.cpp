// A robot whose parameters are identified from joint trajectories: nominal arm, points, full covariance.
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/assets.h"
#include "core/kinds/robot_identification/from_trajectories.h"

namespace covaria {

namespace {

std::unique_ptr<Asset> create_identified(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    const auto identification = circle_points::read(setup, assets, problems);
    if (!identification) return nullptr;
    auto data = circle_points::identified(*identification, problems);
    if (!data) return nullptr;
    return std::make_unique<RobotAsset>(std::move(*data), circle_points::tables(*identification));
}

}  // namespace

AssetDescriptor identified_robot_kind() {
    AssetDescriptor d;
    d.kind = "identified-robot";
    d.title = "Robot identified by joint trajectories";
    d.category = AssetCategory::robot;
    d.summary =
        "A serial robot whose parameters follow from points measured while one joint after the other turns, "
        "with the full covariance of the identification.";
    d.references = {
        {"X. Wen, S. He, G. Qiao, D. Wang, A. Song, C. Kang, Z. Lv: Uncertainty estimation of robot "
         "geometric parameters and end-effector position based on new generation GPS, section 2.1"}};
    d.notes = {
        "The covariance is that of the law of propagation; the analysis \"Robot by joint trajectories\" with "
        "the same settings gives it by Monte Carlo too.",
        "An analysis that uses this robot follows when a point changes."};
    d.capabilities = {SerialRobotSource::capability};
    d.schema = circle_points::fields().schema();
    d.create = create_identified;
    return d;
}

}  // namespace covaria
