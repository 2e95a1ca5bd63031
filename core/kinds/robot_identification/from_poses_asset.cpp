// A robot whose parameters are identified from measured poses of its tool: nominal arm, poses, full
// covariance.
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/assets.h"
#include "core/kinds/robot_identification/from_poses.h"

namespace covaria {

namespace {

std::unique_ptr<Asset> create_calibrated(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    const auto calibration = pose_calibration::read(setup, assets, problems);
    if (!calibration) return nullptr;
    return std::make_unique<RobotAsset>(pose_calibration::identified(*calibration),
                                        pose_calibration::tables(*calibration));
}

}  // namespace

AssetDescriptor calibrated_robot_kind() {
    AssetDescriptor d;
    d.kind = "calibrated-robot";
    d.title = "Robot identified from measured poses";
    d.category = AssetCategory::robot;
    d.summary =
        "A serial robot whose parameters follow by least squares from measured positions or poses of its "
        "tool, "
        "with the full covariance of the identification.";
    d.references = {
        {"X. Wen, S. He, G. Qiao, D. Wang, A. Song, C. Kang, Z. Lv: Uncertainty estimation of robot "
         "geometric parameters and end-effector position based on new generation GPS, Eqs 5-7"},
        {"Z. S. Roth, B. W. Mooring, B. Ravani: An overview of robot calibration (1987)"}};
    d.notes = {
        "The covariance is that of the law of propagation; the analysis \"Robot from measured poses\" with "
        "the "
        "same settings gives it by Monte Carlo too.",
        "The robot stands where the fit found its base; its tool is that of the nominal robot.",
        "An analysis that uses this robot follows when a pose changes."};
    d.capabilities = {SerialRobotSource::capability};
    d.schema = pose_calibration::fields().schema();
    d.create = create_calibrated;
    return d;
}

}  // namespace covaria
