// The set-up of "pose from points", read, checked, and completed with nominal or measured coordinates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/evidence/as_seen.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/math/frames.h"
#include "core/math/rotation_convention.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria::pose {

/// The frame of a point: the base or the moving one. Keys of the set-up begin with it ("base_points").
enum class Side { base, moving };
std::string prefix_of(Side side);
std::string letter_of(Side side);  ///< "b", "p": symbols of the paper

struct NominalPoint {
    std::string name;
    Eigen::Vector3d local = Eigen::Vector3d::Zero();  ///< coordinates in its own frame
    std::array<std::optional<double>, 3> u = {};      ///< typed standard uncertainties of this point
};

/// Rule by which a frame is made from its points.
struct FrameRule {
    std::vector<NominalPoint> points;  ///< the points that the frame depends on
    bool least_squares = false;
    ThirdPoint third_point = ThirdPoint::positive_y;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< s_b, s_p of Eqs 17, 18
    // least squares: local coordinates from their centroid
    std::vector<Eigen::Vector3d> centred;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
};
const Fields<FrameRule>& frame_fields(Side side);

/// Source of the standard uncertainties of a frame's points.
struct UncertaintyRule {
    bool typed = true;
    std::array<double, 3> u{};
    std::array<bool, 3> common{};
    bool along_base = false;        ///< typed ones of the moving points lie along the axes of the base frame
    std::string distribution = {};  ///< shape of typed deviations
    Offered<PointUncertaintySource> source = {};  ///< measures the points without typed figures
    bool is_world() const { return source->axes() == PointUncertaintySource::Axes::world; }
};
const Fields<UncertaintyRule>& uncertainty_fields(Side side);

struct Pose {
    std::string name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< nominal
    Eigen::Vector3d angles = Eigen::Vector3d::Zero();        ///< alpha, beta, gamma; nominal
    Eigen::Isometry3d X_bp = Eigen::Isometry3d::Identity();  ///< pose from position and angles
    std::vector<Eigen::Vector3d> points = {};                ///< estimates of p_i in frame 0
};

/// A row of measured points: one of the repeats.
struct Repeat {
    std::string set, point;
    int number = 0;
    Eigen::Vector3d p_0 = Eigen::Vector3d::Zero();
};

struct PoseSetup {
    FrameRule base, moving;
    UncertaintyRule base_uncertainty, moving_uncertainty;
    std::vector<Pose> poses;
    std::vector<Repeat> measured;
    std::vector<Eigen::Vector3d> base_points;                ///< estimates of b_i in frame 0
    Eigen::Isometry3d X_0b = Eigen::Isometry3d::Identity();  ///< a priori: nominal pose of the base
    bool a_posteriori = false;
    evidence::UncertaintiesFrom uncertainties = evidence::UncertaintiesFrom::stated;
    RotationConvention orientation = RotationConvention::zyx;
};
const Fields<PoseSetup>& pose_fields();

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
