// The set-up of "pose from points", read, checked, and completed with nominal or measured coordinates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/math/frames.h"
#include "core/math/rotation_convention.h"
#include "core/model/asset.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/setup_schema.h"

namespace covaria::pose {

/// Whose points: the base's or the moving frame's. Keys of the set-up begin with it ("base_points").
enum class Side { base, moving };
std::string prefix_of(Side side);
std::string letter_of(Side side);  ///< "b", "p": symbols of the paper

struct NominalPoint {
    std::string name;
    Eigen::Vector3d local;                        ///< in its own frame
    std::array<std::optional<double>, 3> u = {};  ///< typed standard uncertainties of this point
};

/// How a frame is made from its points.
struct FrameRule {
    std::vector<NominalPoint> points;  ///< those the frame depends on
    bool least_squares = false;
    ThirdPoint third_point = ThirdPoint::positive_y;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< s_b, s_p of Eqs 17, 18
    // least squares: local coordinates from their centroid
    std::vector<Eigen::Vector3d> centred;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
};

/// Where the standard uncertainties of a frame's points come from.
struct UncertaintyRule {
    std::shared_ptr<const Asset> asset = {};  ///< null: typed
    std::string asset_id, asset_name;
    std::array<double, 3> u{};
    std::array<bool, 3> common{};
    bool along_base = false;        ///< typed ones of the moving points lie along the axes of the base frame
    std::string distribution = {};  ///< shape of typed deviations
};

struct Pose {
    std::string name;
    Eigen::Isometry3d X_bp = Eigen::Isometry3d::Identity();  ///< nominal
    std::vector<Eigen::Vector3d> points;                     ///< estimates of p_i in frame 0
};

struct PoseSetup {
    FrameRule base, moving;
    UncertaintyRule base_uncertainty, moving_uncertainty;
    std::vector<Pose> poses;
    std::vector<Eigen::Vector3d> base_points;                ///< estimates of b_i in frame 0
    Eigen::Isometry3d X_0b = Eigen::Isometry3d::Identity();  ///< a priori: nominal pose of the base
    bool a_posteriori = false;
    RotationConvention orientation = RotationConvention::zyx;
};

SetupSchema pose_schema();

/// Empty if `problems` got an error.
std::optional<PoseSetup> read_pose_setup(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems);

/// X_0F of a frame made from the points q (in frame 0).
Eigen::Isometry3d frame_of(const FrameRule& rule, const std::vector<Eigen::Vector3d>& q);

/// An error for every point that its instrument cannot measure.
void check_measurable(const PoseSetup& setup, Problems& problems);

/// The input quantities b_ix ... and p_ix_k ... with their components.
InputSet pose_inputs(const PoseSetup& setup);

/// Warnings: large uncertainties, gimbal lock, nominal points whose frame is not the one they are given in.
void warn_about(const PoseSetup& setup, const InputSet& inputs, Problems& problems);

}  // namespace covaria::pose
