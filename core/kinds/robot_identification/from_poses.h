// Identification of an arm by least squares from measured positions or poses of its tool. Shared by the asset
// and the measurement model.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/points/located_points.h"
#include "core/kinds/robot/fields.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot_identification/identified_parameters.h"
#include "core/kinds/robot_identification/least_squares.h"
#include "core/math/rotation.h"
#include "core/quantity/input_quantity.h"

namespace covaria::pose_calibration {

/// Parameters of the joints, place of the base, place of the ball or tool on the last link.
inline constexpr std::size_t most_unknowns = 5 * most_joints + 12;
inline constexpr std::size_t no_input = InputSet::npos;

enum class UnknownKind { base, tool, parameter };

/// "y", "rotation about z": of x, y, z and the rotations about them.
Message coordinate_words(std::size_t coordinate);

/// A number that the fit finds.
struct Unknown {
    UnknownKind kind = UnknownKind::parameter;
    IdentifiedParameter parameter = {};  ///< the parameter of a joint
    std::size_t coordinate = 0;          ///< coordinate of base or tool: x, y, z, rotations about x, y, z
    Message name() const;
};

struct MeasuredPose {
    std::string name;
    std::string source = {};
    bool check = false;  ///< held back from the fit
    std::vector<double> q = {};
    std::vector<Turn<double>> turns =
        {};  ///< turn of each joint from its zero reading; none of one that slides
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    std::size_t first_input = 0;                        ///< x, y, z, then rotations about the tool's axes
    std::array<std::size_t, most_joints> reading = {};  ///< index of an uncertain reading, or no_input
};

/// Statistics of a fit also say how well it tells the poses that were held back.
struct PoseStatistics : identification::FitStatistics {
    Eigen::VectorXd deviations, u_deviations;  ///< at check poses: calculated less measured, x y z each
    Eigen::VectorXd before;                    ///< the same with the nominal parameters
};

/// A row of the measured poses, SI.
struct StatedPose {
    std::string name;
    bool check = false;
    StatedReadings q, s;
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    std::array<std::optional<double>, 3> angles;  ///< alpha, beta, gamma
};

struct HeldByUser {
    std::string parameter;  ///< its symbol
};

/// The set-up as typed, SI.
struct StatedCalibration {
    Offered<SerialRobotSource> nominal;
    bool simulated = true, with_orientation = false, base_fitted = true, tool_fitted = true;
    std::vector<StatedPose> measured;
    int pose_count = 0;       ///< simulated
    double half_range = 0.0;  ///< half the range of their joints
    PointLocator locator;
    double u_angle = 0.0;  ///< u of a measured orientation, about each axis
    Eigen::Isometry3d ball = Eigen::Isometry3d::Identity();
    std::vector<HeldByUser> held_by_user;
    evidence::UncertaintiesFrom uncertainties = evidence::UncertaintiesFrom::stated;

    const SerialRobotSource& robot() const { return *nominal; }
};
const Fields<StatedCalibration>& fields();

struct Calibration : StatedCalibration {
    explicit Calibration(StatedCalibration stated) : StatedCalibration(std::move(stated)) {}
    std::vector<MeasuredPose> poses;  ///< poses of the fit, then the others
    std::size_t fitted_poses = 0;
    Eigen::Isometry3d X_MB = Eigen::Isometry3d::Identity();  ///< base in the measuring frame, fitted
    Eigen::Isometry3d X_FT = Eigen::Isometry3d::Identity();  ///< ball or tool, fitted
    std::vector<Unknown> unknowns;
    std::vector<double> solution;  ///< estimates of the unknowns; rotations of base and tool from X_MB, X_FT
    std::vector<HeldParameter> held;
    Eigen::MatrixXd gain;           ///< unknowns by rows of the fit
    std::vector<double> inverse_u;  ///< of the unknowns
    std::vector<double> weights;    ///< weights of the rows of the fit
    PoseStatistics statistics;
    InputSet inputs;

    std::size_t rows_per_pose() const { return with_orientation ? 6 : 3; }
    std::size_t rows() const { return fitted_poses * rows_per_pose(); }
    /// Joint parameters among the unknowns; base and tool come first.
    std::vector<IdentifiedParameter> parameters() const;
    std::size_t first_parameter() const;
    std::vector<Message> names() const;  ///< of the unknowns
};

/// Empty if `problems` got an error.
std::optional<Calibration> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems);
/// Parameters, what is held and why, observability, residuals, check poses.
std::vector<Table> tables(const Calibration& c);
Layout layout(const Calibration& c);
/// The arm with the identified parameters, standing where the base was found.
RobotData identified(const Calibration& c);

/// The arm of one trial: joints at their zero readings, base and tool.
template <class Real>
struct CalibratedArm {
    std::array<JointTransform<Real>, most_joints> T;
    Matrix3<Real> R_MB, R_FT;
    Vector3<Real> p_MB, p_FT;
};

/// `v[i]`: value of unknown i.
template <class Real, class Values>
CalibratedArm<Real> arm_of(const Calibration& c, const Values& v) {
    CalibratedArm<Real> arm;
    Vector3<Real> base(Real(0.0), Real(0.0), Real(0.0)), tool = base;
    for (int k = 0; k < 3; ++k) {
        arm.p_MB[k] = Real(c.X_MB.translation()[k]);
        arm.p_FT[k] = Real(c.X_FT.translation()[k]);
    }
    const auto& joints = c.robot().joints();
    std::array<JointValues<Real>, most_joints> joint;
    for (std::size_t j = 0; j < joints.size(); ++j)
        for (JointParameter p : joint_parameters) joint[j][p] = Real(joints[j].values[p]);
    for (std::size_t i = 0; i < c.unknowns.size(); ++i) {
        const Unknown& u = c.unknowns[i];
        const auto k = static_cast<Eigen::Index>(u.coordinate);
        if (u.kind == UnknownKind::parameter)
            joint[u.parameter.joint][u.parameter.parameter] = v[i];
        else if (u.kind == UnknownKind::base)
            (k < 3 ? arm.p_MB[k] : base[k - 3]) = v[i];
        else
            (k < 3 ? arm.p_FT[k] : tool[k - 3]) = v[i];
    }
    for (std::size_t j = 0; j < joints.size(); ++j) arm.T[j] = joint_transform(joint[j], joints[j].parallel);
    arm.R_MB = c.X_MB.linear().cast<Real>();
    if (c.base_fitted) arm.R_MB = (arm.R_MB * rotation_from_zyx<Real>(base)).eval();
    arm.R_FT = c.X_FT.linear().cast<Real>();
    if (c.tool_fitted && c.with_orientation) arm.R_FT = (arm.R_FT * rotation_from_zyx<Real>(tool)).eval();
    return arm;
}

/// Measured less calculated of one pose in `r`: x, y, z, then the rotation vector in the axes of the tool (to
/// first order, which is what a residual needs). `x[i]`: input quantity i.
template <class Real, class In>
void residuals(const Calibration& c, const MeasuredPose& pose, const CalibratedArm<Real>& arm, const In& x,
               Real* r) {
    const SerialRobotSource& robot = c.robot();
    Vector3<Real> p = arm.p_FT;
    Matrix3<Real> R = arm.R_FT;
    for (std::size_t j = robot.joints().size(); j-- > 0;) {
        JointTransform<Real> joint = arm.T[j];
        const auto travel = [&] {
            return travel_of<Real>(robot.joints(), j, [&](std::size_t k) {
                return pose.reading[k] == no_input ? Real(pose.q[k]) : Real(x[pose.reading[k]]);
            });
        };
        if (robot.joints()[j].slides)
            joint.d = joint.d + travel();
        else if (is_uncertain(robot.joints(), pose.reading, j))
            joint.theta = joint.theta * Turn<Real>(travel());
        else
            joint.theta = joint.theta * Turn<Real>(Real(pose.turns[j].c), Real(pose.turns[j].s));
        apply(robot.convention(), joint, p);
        if (c.with_orientation) apply_to_axes(robot.convention(), joint, R);
    }
    p = (arm.R_MB * p + arm.p_MB).eval();
    for (std::size_t k = 0; k < 3; ++k)
        r[k] = Real(x[pose.first_input + k]) - p[static_cast<Eigen::Index>(k)];
    if (!c.with_orientation) return;
    const std::size_t i = pose.first_input + 3;
    const Matrix3<Real> stated = pose.R.cast<Real>();
    const Matrix3<Real> measured =
        stated * rotation_from_zyx<Real>({Real(x[i]), Real(x[i + 1]), Real(x[i + 2])});
    const Matrix3<Real> turned = (arm.R_MB * R).transpose() * measured;
    r[3] = Real(0.5) * (turned(2, 1) - turned(1, 2));
    r[4] = Real(0.5) * (turned(0, 2) - turned(2, 0));
    r[5] = Real(0.5) * (turned(1, 0) - turned(0, 1));
}

/// Unknowns in their order (rotations of base and tool as angles of their pose), then the deviations of the
/// check poses, calculated less measured.
template <class Real, class In, class Set>
mask_of<Real> evaluate(const Calibration& c, const In& x, Set set) {
    const std::size_t n = c.unknowns.size(), m = c.rows_per_pose();
    std::array<Real, most_unknowns> v;
    std::array<Real, 6> r;
    for (std::size_t i = 0; i < n; ++i) v[i] = Real(c.solution[i]);
    const auto settled =
        identification::follow_gain<Real>(c.gain, c.inverse_u, v, [&](const auto& at, const auto& add) {
            const CalibratedArm<Real> arm = arm_of<Real>(c, at);
            for (std::size_t pose = 0; pose < c.fitted_poses; ++pose) {
                residuals<Real>(c, c.poses[pose], arm, x, r.data());
                for (std::size_t row = 0; row < m; ++row) add(pose * m + row, r[row]);
            }
        });
    const CalibratedArm<Real> arm = arm_of<Real>(c, v);
    const Vector3<Real> base = zyx_from_rotation(arm.R_MB), tool = zyx_from_rotation(arm.R_FT);
    for (std::size_t i = 0; i < n; ++i) {
        const Unknown& u = c.unknowns[i];
        const bool turns = u.kind != UnknownKind::parameter && u.coordinate >= 3;
        const auto k = static_cast<Eigen::Index>(u.coordinate) - 3;
        set(i, turns ? (u.kind == UnknownKind::base ? base[k] : tool[k]) : v[i]);
    }
    for (std::size_t pose = c.fitted_poses; pose < c.poses.size(); ++pose) {
        residuals<Real>(c, c.poses[pose], arm, x, r.data());
        for (std::size_t k = 0; k < 3; ++k) set(n + 3 * (pose - c.fitted_poses) + k, Real(-r[k]));
    }
    return settled;
}

}  // namespace covaria::pose_calibration
