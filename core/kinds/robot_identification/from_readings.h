// Identification of an arm by least squares from what can be measured without poses: distances from points
// and planes, distances between two places of a ball, positions of reflectors.
#pragma once

#include <Eigen/Core>
#include <array>
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

namespace covaria::reading_identification {

inline constexpr std::size_t most_targets = 12, most_places = 48, most_zeros = 48;
/// Base, places, zeros, targets, parameters and compliances of the joints.
inline constexpr std::size_t most_unknowns =
    6 + 3 * (most_places + most_targets) + most_zeros + 6 * most_joints;
inline constexpr std::size_t nothing = InputSet::npos;

/// A ball or reflector on the last link, in its frame.
struct StatedTarget {
    std::string name;
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    bool found = true;
    double u = 0.0;  ///< of each coordinate, where it is known
};

/// A point or plane in the measuring frame.
struct StatedPlace {
    std::string name;
    bool plane = false;
    std::array<std::optional<double>, 3> p = {}, normal = {};
    bool found = false;
    double u = 0.0;  ///< of each coordinate of a known point, of a known plane along its normal
};

struct StatedPose {
    std::string name;
    StatedReadings q = {}, s = {};
    StatedReadings torque = {};  ///< N m
};

enum class From { point, plane, pose };

struct StatedDistance {
    std::string pose, target;  ///< empty target: the first
    From from = From::point;
    std::string to;  ///< name of a place, or of a pose
    std::optional<double> value, u;
    std::string zero;  ///< unknown that all distances of this name contain; empty: none
    bool check = false;
};

struct StatedPosition {
    std::string pose, target;
    std::array<std::optional<double>, 3> p = {};
    bool check = false;
};

/// The set-up as typed, SI.
struct StatedIdentification {
    Offered<SerialRobotSource> nominal;
    bool simulated = false, base_found = true, compliant = false;
    std::vector<StatedTarget> targets;
    std::vector<StatedPlace> places;
    std::vector<StatedPose> stated_poses;
    std::vector<StatedDistance> distances;
    std::vector<StatedPosition> positions;
    double u_distance = 0.0, u_scale = 0.0;
    PointLocator locator;
    struct Held {
        std::string parameter;
    };
    std::vector<Held> held_by_user;
    evidence::UncertaintiesFrom uncertainties = evidence::UncertaintiesFrom::stated;

    const SerialRobotSource& robot() const { return *nominal; }
};
const Fields<StatedIdentification>& fields();

struct Pose {
    std::string name;
    std::vector<double> q;
    std::vector<Turn<double>> turns = {};  ///< of each joint from its zero reading; one that slides: none
    std::array<double, most_joints> torque = {};
    std::array<std::size_t, most_joints> reading = {};  ///< index of an uncertain reading, or nothing
};

struct Target {
    std::string name;
    Eigen::Vector3d p_F = Eigen::Vector3d::Zero();
    bool found = true;
    std::size_t first_input = nothing;  ///< x, y, z of a known one that is uncertain
};

struct Place {
    std::string name;
    bool plane = false, found = false;
    Eigen::Vector3d p = Eigen::Vector3d::Zero();         ///< the point; a point of the plane
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of a plane: two along it, its normal
    std::size_t first_input = nothing;  ///< x, y, z of an uncertain point; offset of an uncertain plane
};

enum class RowKind { x, y, z, from_point, from_plane, between_poses, nominal_length };

/// A number that was measured.
struct Row {
    RowKind kind = RowKind::x;
    std::size_t pose = 0, target = 0;
    std::size_t to = nothing;    ///< a place, the other pose, the joint of a nominal length
    std::size_t zero = nothing;  ///< an unknown zero that it contains
    std::size_t input = 0;
    bool check = false;             ///< held back from the fit
    JointParameter parameter = {};  ///< of a nominal length
    double value = 0.0;
    Message name;
    std::string source;
};

enum class UnknownKind { base, place, zero, target, parameter, compliance };

/// A number that the fit finds.
struct Unknown {
    UnknownKind kind = UnknownKind::parameter;
    std::size_t of = 0;  ///< place, zero, target or joint
    std::size_t coordinate =
        0;  ///< of base, point and target: x, y, z, rotations; of a plane: two tilts, offset
    JointParameter parameter = {};
};

struct Identification : StatedIdentification {
    explicit Identification(StatedIdentification stated) : StatedIdentification(std::move(stated)) {}
    std::vector<Pose> poses;
    std::vector<Target> arm_targets;
    std::vector<Place> fixed_places;
    std::vector<std::string> zeros;  ///< their names
    std::vector<Row> rows;           ///< those of the fit, then the others
    std::size_t fitted_rows = 0;
    Eigen::Isometry3d X_MB = Eigen::Isometry3d::Identity();  ///< base in the measuring frame
    std::vector<Unknown> unknowns;
    std::vector<double> solution;  ///< rotations of the base and tilts of planes from X_MB and axes
    std::vector<HeldParameter> held;
    Message scale_note;             ///< where the readings hardly tell the scale: what gives it
    Eigen::MatrixXd gain;           ///< unknowns by rows of the fit
    std::vector<double> inverse_u;  ///< of the unknowns
    identification::FitStatistics statistics;
    Eigen::VectorXd deviations, u_deviations, before;  ///< at the rows held back: calculated less measured
    InputSet inputs;

    /// "P3", or "P3 B" where the arm has several targets.
    std::string label(std::size_t pose, std::size_t target) const;
    Message name_of(const Unknown& unknown) const;
    std::vector<Message> names() const;
    std::vector<IdentifiedParameter> parameters() const;
    std::vector<double> values_of_parameters() const;
    bool has_kind(UnknownKind kind) const;
};

/// Empty if `problems` got an error.
std::optional<Identification> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems);
/// Values of the rows become those of the nominal arm, with places as stated and zeros of 0.
void simulate(Identification& id);
/// `Row::input`, first a row of the tables, becomes the index of an input quantity.
void add_inputs(Identification& id, Problems& problems);
/// The nominal value of a length, as uncertain as the robot states, becomes a row of the fit. False where it
/// states no uncertainty.
bool add_nominal(Identification& id, const Unknown& length);
/// The unknowns as base, places, targets and the nominal arm have them.
std::vector<double> values_of(const Identification& id);
/// Puts base, places and targets where the readings have them with the nominal arm.
void find_start(Identification& id);
/// Takes out what the rows cannot tell and fits the others. False after an error.
bool fit(Identification& id, Problems& problems);
/// The rows of the fit as evidence about what is stated of them.
void find_evidence(Identification& id, const Eigen::MatrixXd& design, const Eigen::MatrixXd& shares);
std::vector<Table> tables(const Identification& id);
Layout layout(const Identification& id);
/// The arm with the identified parameters, standing where the base was found.
RobotData identified(const Identification& id);

/// The arm and its surroundings in one trial.
template <class Real>
struct Scene {
    std::array<JointTransform<Real>, most_joints> T;
    std::array<Real, most_joints> compliance;
    Matrix3<Real> R_MB;
    Vector3<Real> p_MB;
    std::array<Vector3<Real>, most_targets> targets;
    std::array<Vector3<Real>, most_places> points, normals;
    std::array<Real, most_zeros> zeros;
};

template <class Real, class In>
Vector3<Real> known_or_uncertain(const Eigen::Vector3d& p, std::size_t first_input, const In& x) {
    if (first_input == nothing) return {Real(p[0]), Real(p[1]), Real(p[2])};
    return {Real(x[first_input]), Real(x[first_input + 1]), Real(x[first_input + 2])};
}

/// A point of the plane and its normal, from tilts about its axes and its offset.
template <class Real>
void put_plane(const Place& place, const Vector3<Real>& tilts_and_offset, Vector3<Real>& point,
               Vector3<Real>& normal) {
    using namespace real_functions;
    Real length(1.0);
    for (int k = 0; k < 2; ++k) length += tilts_and_offset[k] * tilts_and_offset[k];
    length = sqrt(length);
    for (int i = 0; i < 3; ++i) {
        normal[i] = (Real(place.axes(i, 2)) + tilts_and_offset[0] * Real(place.axes(i, 0)) +
                     tilts_and_offset[1] * Real(place.axes(i, 1))) /
                    length;
        point[i] = Real(place.p[i]) + tilts_and_offset[2] * Real(place.axes(i, 2));
    }
}

/// `v[i]`: value of unknown i; `x[i]`: input quantity i.
template <class Real, class Values, class In>
void scene_of(const Identification& id, const Values& v, const In& x, Scene<Real>& scene) {
    const Vector3<Real> zero(Real(0.0), Real(0.0), Real(0.0));
    const auto& joints = id.robot().joints();
    std::array<JointValues<Real>, most_joints> joint;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        scene.compliance[j] = Real(0.0);
        for (const JointParameter p : joint_parameters) joint[j][p] = Real(joints[j].values[p]);
    }
    Vector3<Real> turned = zero;
    for (int k = 0; k < 3; ++k) scene.p_MB[k] = Real(id.X_MB.translation()[k]);
    for (std::size_t t = 0; t < id.arm_targets.size(); ++t)
        scene.targets[t] = known_or_uncertain<Real>(id.arm_targets[t].p_F, id.arm_targets[t].first_input, x);
    for (std::size_t k = 0; k < id.fixed_places.size(); ++k) {
        const Place& place = id.fixed_places[k];
        // Tilts and offset until the plane is put.
        scene.points[k] = zero;
        if (!place.plane) scene.points[k] = known_or_uncertain<Real>(place.p, place.first_input, x);
        if (place.plane && place.first_input != nothing) scene.points[k][2] = Real(x[place.first_input]);
    }
    for (std::size_t k = 0; k < id.zeros.size(); ++k) scene.zeros[k] = Real(0.0);
    for (std::size_t i = 0; i < id.unknowns.size(); ++i) {
        const Unknown& u = id.unknowns[i];
        const auto k = static_cast<Eigen::Index>(u.coordinate);
        switch (u.kind) {
            case UnknownKind::base:
                (k < 3 ? scene.p_MB[k] : turned[k - 3]) = v[i];
                break;
            case UnknownKind::place:
                scene.points[u.of][k] = v[i];
                break;
            case UnknownKind::zero:
                scene.zeros[u.of] = v[i];
                break;
            case UnknownKind::target:
                scene.targets[u.of][k] = v[i];
                break;
            case UnknownKind::parameter:
                joint[u.of][u.parameter] = v[i];
                break;
            case UnknownKind::compliance:
                scene.compliance[u.of] = v[i];
                break;
        }
    }
    for (std::size_t k = 0; k < id.fixed_places.size(); ++k)
        if (const Place& place = id.fixed_places[k]; place.plane) {
            const Vector3<Real> stated = scene.points[k];
            put_plane<Real>(place, stated, scene.points[k], scene.normals[k]);
        }
    for (std::size_t j = 0; j < joints.size(); ++j)
        scene.T[j] = joint_transform(joint[j], joints[j].parallel);
    scene.R_MB = id.X_MB.linear().cast<Real>();
    if (id.base_found) scene.R_MB = (scene.R_MB * rotation_from_zyx<Real>(turned)).eval();
}

/// Where a target is in the measuring frame while the arm stands in a pose.
template <class Real, class In>
Vector3<Real> place_of(const Identification& id, const Scene<Real>& scene, const Pose& pose,
                       std::size_t target, const In& x) {
    const SerialRobotSource& robot = id.robot();
    Vector3<Real> p = scene.targets[target];
    for (std::size_t j = robot.joints().size(); j-- > 0;) {
        JointTransform<Real> joint = scene.T[j];
        const auto travel = [&] {
            return travel_of<Real>(robot.joints(), j, [&](std::size_t k) {
                return pose.reading[k] == nothing ? Real(pose.q[k]) : Real(x[pose.reading[k]]);
            });
        };
        if (robot.joints()[j].slides) {
            joint.d += travel();
        } else {
            Turn<Real> turn(Real(pose.turns[j].c), Real(pose.turns[j].s));
            if (is_uncertain(robot.joints(), pose.reading, j)) turn = Turn<Real>(travel());
            joint.theta = joint.theta * turn;
            if (id.compliant && pose.torque[j] != 0.0)
                joint.theta = joint.theta * Turn<Real>(Real(scene.compliance[j] * Real(pose.torque[j])));
        }
        apply(robot.convention(), joint, p);
    }
    return (scene.R_MB * p + scene.p_MB).eval();
}

/// Measured less calculated: `set(i, value)` for the rows first ... last − 1, i from 0.
template <class Real, class In, class Set>
void residuals(const Identification& id, std::size_t first, std::size_t last, const Scene<Real>& scene,
               const In& x, Set set) {
    using namespace real_functions;
    std::size_t pose = nothing, target = nothing;
    Vector3<Real> p;
    for (std::size_t i = first; i < last; ++i) {
        const Row& row = id.rows[i];
        if (row.pose != pose || row.target != target) {
            pose = row.pose;
            target = row.target;
            p = place_of<Real>(id, scene, id.poses[pose], target, x);
        }
        Real calculated(0.0);
        if (row.kind == RowKind::from_plane) {
            const Vector3<Real>&o = scene.points[row.to], &n = scene.normals[row.to];
            for (int k = 0; k < 3; ++k) calculated += n[k] * (p[k] - o[k]);
        } else if (row.kind == RowKind::from_point || row.kind == RowKind::between_poses) {
            const Vector3<Real> o = row.kind == RowKind::from_point
                                        ? scene.points[row.to]
                                        : place_of<Real>(id, scene, id.poses[row.to], target, x);
            for (int k = 0; k < 3; ++k) calculated += (p[k] - o[k]) * (p[k] - o[k]);
            calculated = sqrt(calculated);
        } else if (row.kind == RowKind::nominal_length) {
            calculated = row.parameter == JointParameter::d ? scene.T[row.to].d : scene.T[row.to].a;
        } else {
            calculated = p[static_cast<int>(row.kind) - static_cast<int>(RowKind::x)];
        }
        if (row.zero != nothing) calculated += scene.zeros[row.zero];
        set(i - first, Real(Real(x[row.input]) - calculated));
    }
}

/// Values of a trial that are reported beside the unknowns themselves.
template <class Real>
struct Found {
    std::array<Real, most_unknowns> v;
    Scene<Real> scene;
};

/// Unknowns in `found`, then `deviation(i, value)` of the rows held back, calculated less measured.
template <class Real, class In, class Set>
mask_of<Real> evaluate(const Identification& id, const In& x, Found<Real>& found, Set deviation) {
    auto& v = found.v;
    for (std::size_t i = 0; i < id.unknowns.size(); ++i) v[i] = Real(id.solution[i]);
    const auto settled =
        identification::follow_gain<Real>(id.gain, id.inverse_u, v, [&](const auto& at, const auto& add) {
            scene_of<Real>(id, at, x, found.scene);
            residuals<Real>(id, 0, id.fitted_rows, found.scene, x, add);
        });
    scene_of<Real>(id, v, x, found.scene);
    residuals<Real>(id, id.fitted_rows, id.rows.size(), found.scene, x,
                    [&](std::size_t row, const Real& r) { deviation(row, Real(-r)); });
    return settled;
}

}  // namespace covaria::reading_identification
