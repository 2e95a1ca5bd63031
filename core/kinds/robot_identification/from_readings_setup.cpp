// Reads what was measured of an arm, its uncertainty, and what is to be found.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/kinds/robot_identification/from_readings.h"
#include "core/kinds/robot_identification/reading_figures.h"

namespace covaria::reading_identification {

namespace {

using Stated = StatedIdentification;

/// Two directions along a plane, then its normal.
Eigen::Matrix3d axes_along(const Eigen::Vector3d& normal) {
    Eigen::Matrix3d axes;
    const Eigen::Vector3d n = normal.normalized(), across = n.unitOrthogonal();
    axes << across, n.cross(across), n;
    return axes;
}

/// Of a place that the fit finds, too, a plan must say where it is.
Message where_is_it(const StatedPlace& stated, const char* figures) {
    if (stated.found) return tell<"a plan must say where %1 is: give %2">(stated.name, figures);
    return tell<"%1 is known, but where it is is not said: give %2, or let the fit find it">(stated.name,
                                                                                             figures);
}

void check_place(const Identification& id, std::size_t row, Problems& problems) {
    for (std::size_t k = 0; k < 3; ++k)
        if (!id.places[row].p[k])
            problems.error(fields().place(&Stated::places, row, &StatedPlace::p, k),
                           where_is_it(id.places[row], "x, y, z"));
}

void read_normal(const Identification& id, std::size_t row, Place& place, Problems& problems) {
    const StatedPlace& stated = id.places[row];
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) normal[static_cast<Eigen::Index>(k)] = stated.normal[k].value_or(0.0);
    if (normal.norm() > 0.0 && normal.allFinite())
        place.axes = axes_along(normal / normal.cwiseAbs().maxCoeff());
    else if (!stated.found || id.simulated)
        problems.error(fields().place(&Stated::places, row, &StatedPlace::normal, 0),
                       where_is_it(stated, "n_x, n_y, n_z"));
}

/// A joint that other poses state has a reading in this one, too.
void refuse_missing(const Identification& id, std::size_t row, Problems& problems) {
    const auto& joints = id.robot().joints();
    for (std::size_t j = 0; j < std::min(joints.size(), most_joints); ++j) {
        const auto readings = joints[j].slides ? &StatedPose::s : &StatedPose::q;
        if ((id.stated_poses[row].*readings)[j]) continue;
        if (std::ranges::any_of(id.stated_poses,
                                [&](const StatedPose& other) { return (other.*readings)[j].has_value(); }))
            problems.error(fields().place(&Stated::stated_poses, row, readings, j),
                           tell<"pose %1 lacks its reading %2, which other poses have">(
                               id.stated_poses[row].name, reading_symbol(id.robot(), j)));
    }
}

void refuse_unused(const Identification& id, std::size_t row, StatedReadings StatedPose::*readings,
                   std::size_t j, Problems& problems) {
    const auto& joints = id.robot().joints();
    const std::string place = fields().place(&Stated::stated_poses, row, readings, j);
    if (j >= joints.size())
        return problems.error(place,
                              tell<"the robot has only %1 joints; leave %2 empty">(
                                  joints.size(), fields().columns(&Stated::stated_poses).key(readings, j)));
    if (joints[j].slides && readings == &StatedPose::torque)
        return problems.error(place,
                              tell<"joint %1 slides: a compliance is found of joints that turn">(j + 1));
    if (joints[j].slides == (readings == &StatedPose::s) || readings == &StatedPose::torque) return;
    const std::string symbol = reading_symbol(id.robot(), j);
    problems.error(place, joints[j].slides ? tell<"joint %1 slides: its reading is %2">(j + 1, symbol)
                                           : tell<"joint %1 turns: its reading is %2">(j + 1, symbol));
}

/// Targets, places, poses and rows by what the tables say; names become indices.
class RowReading {
public:
    RowReading(Identification& id, Problems& problems) : id_(id), problems_(problems) {}

    void read() {
        read_targets();
        read_places();
        read_poses();
        if (problems_.has_errors()) return;
        for (std::size_t row = 0; row < id_.distances.size(); ++row) read_distance(row);
        for (std::size_t row = 0; row < id_.positions.size(); ++row) read_position(row);
        sort_rows();
        if (id_.fitted_rows == 0)
            problems_.error(fields().place(&Stated::distances),
                            tell<"nothing is measured: give distances or positions">());
    }

private:
    using Names = std::map<std::string, std::size_t>;

    bool is_new(Names& names, const std::string& name, const std::string& place) {
        if (names.try_emplace(name, names.size()).second) return true;
        problems_.error(place, tell<"two of them are called %1">(name));
        return false;
    }

    bool are_few(std::size_t count, std::size_t most, const std::string& place, const Message& what) {
        if (count <= most) return true;
        problems_.error(place, tell<"at most %1 %2 are taken">(most, what));
        return false;
    }

    void read_targets() {
        if (!are_few(id_.targets.size(), most_targets, fields().place(&Stated::targets),
                     tell<"balls and reflectors">()))
            return;
        for (std::size_t row = 0; row < id_.targets.size(); ++row) {
            const StatedTarget& stated = id_.targets[row];
            is_new(targets_, stated.name, fields().place(&Stated::targets, row));
            id_.arm_targets.push_back({stated.name, stated.p, stated.found});
        }
    }

    void read_places() {
        if (!are_few(id_.places.size(), most_places, fields().place(&Stated::places),
                     tell<"points and planes">()))
            return;
        for (std::size_t row = 0; row < id_.places.size(); ++row) {
            const StatedPlace& stated = id_.places[row];
            is_new(places_, stated.name, fields().place(&Stated::places, row));
            if (targets_.contains(stated.name))
                problems_.error(fields().place(&Stated::places, row),
                                tell<"a ball on the arm is called %1, too">(stated.name));
            Place place{.name = stated.name, .plane = stated.plane, .found = stated.found};
            for (int k = 0; k < 3; ++k) place.p[k] = stated.p[static_cast<std::size_t>(k)].value_or(0.0);
            if (!stated.found || id_.simulated) check_place(id_, row, problems_);
            if (stated.plane) read_normal(id_, row, place, problems_);
            id_.fixed_places.push_back(std::move(place));
        }
    }

    void read_poses() {
        const auto& joints = id_.robot().joints();
        for (std::size_t row = 0; row < id_.stated_poses.size(); ++row) {
            const StatedPose& stated = id_.stated_poses[row];
            is_new(poses_, stated.name, fields().place(&Stated::stated_poses, row));
            Pose pose{.name = stated.name, .q = {}};
            pose.reading.fill(nothing);
            refuse_missing(id_, row, problems_);
            for (std::size_t j = 0; j < std::min(joints.size(), most_joints); ++j) {
                pose.q.push_back((joints[j].slides ? stated.s : stated.q)[j].value_or(joints[j].zero));
                pose.torque[j] = stated.torque[j].value_or(0.0);
            }
            for (std::size_t j = 0; j < pose.q.size(); ++j)
                pose.turns.push_back(joints[j].slides ? Turn<double>()
                                                      : Turn<double>(travel_of(joints, j, pose.q)));
            for (std::size_t j = 0; j < most_joints; ++j)
                for (const auto readings : {&StatedPose::q, &StatedPose::s, &StatedPose::torque})
                    if ((stated.*readings)[j]) refuse_unused(id_, row, readings, j, problems_);
            id_.poses.push_back(std::move(pose));
        }
    }

    std::optional<std::size_t> find(const Names& names, const std::string& name, const std::string& place,
                                    const Message& unknown) {
        const auto found = names.find(name);
        if (found != names.end()) return found->second;
        problems_.error(place, unknown);
        return {};
    }

    std::optional<std::size_t> find_pose(const std::string& name, const std::string& place) {
        return find(poses_, name, place, tell<"there is no pose '%1'">(name));
    }

    std::optional<std::size_t> find_target(const std::string& name, const std::string& place) {
        if (name.empty()) return 0;
        return find(targets_, name, place, tell<"there is no ball or reflector '%1'">(name));
    }

    void read_distance(std::size_t i) {
        const StatedDistance& stated = id_.distances[i];
        const auto place = [&](auto column) { return fields().place(&Stated::distances, i, column); };
        const auto pose = find_pose(stated.pose, place(&StatedDistance::pose));
        const auto target = find_target(stated.target, place(&StatedDistance::target));
        const auto to = find_other(stated, place(&StatedDistance::to));
        if (!pose || !target || !to) return;
        Row row{.kind = stated.from == From::pose    ? RowKind::between_poses
                        : stated.from == From::plane ? RowKind::from_plane
                                                     : RowKind::from_point,
                .pose = *pose,
                .target = *target,
                .to = *to,
                .input = i,
                .check = stated.check,
                .value = stated.value.value_or(0.0),
                .name = tell<"%1 from %2">(id_.label(*pose, *target), stated.to),
                .source = fields().place(&Stated::distances, i)};
        if (stated.from == From::pose && *to == *pose)
            return problems_.error(row.source, tell<"a distance from a pose to itself is 0">());
        if (!stated.zero.empty()) row.zero = zero_called(stated.zero);
        if (!id_.simulated && !stated.value)
            return problems_.error(place(&StatedDistance::value), tell<"this distance was not measured: give "
                                                                       "its value or take its row out">());
        if (!id_.simulated && stated.from != From::plane && stated.zero.empty() && !(row.value > 0.0))
            return problems_.error(place(&StatedDistance::value),
                                   tell<"a distance from a point or pose is above zero">());
        id_.rows.push_back(std::move(row));
    }

    std::optional<std::size_t> find_other(const StatedDistance& stated, const std::string& place) {
        if (stated.from == From::pose) return find_pose(stated.to, place);
        const bool plane = stated.from == From::plane;
        const auto found = find(
            places_, stated.to, place,
            plane ? tell<"there is no plane '%1'">(stated.to) : tell<"there is no point '%1'">(stated.to));
        if (!found || id_.fixed_places[*found].plane == plane) return found;
        problems_.error(place, plane ? tell<"'%1' is a point and no plane">(stated.to)
                                     : tell<"'%1' is a plane and no point">(stated.to));
        return {};
    }

    std::size_t zero_called(const std::string& name) {
        const auto found = std::ranges::find(id_.zeros, name);
        if (found != id_.zeros.end()) return static_cast<std::size_t>(found - id_.zeros.begin());
        if (id_.zeros.size() == most_zeros) {
            if (!std::exchange(too_many_zeros_, true))
                are_few(most_zeros + 1, most_zeros, fields().place(&Stated::distances), tell<"zeros">());
            return nothing;
        }
        id_.zeros.push_back(name);
        return id_.zeros.size() - 1;
    }

    void read_position(std::size_t i) {
        const StatedPosition& stated = id_.positions[i];
        const auto pose =
            find_pose(stated.pose, fields().place(&Stated::positions, i, &StatedPosition::pose));
        const auto target =
            find_target(stated.target, fields().place(&Stated::positions, i, &StatedPosition::target));
        if (!pose || !target) return;
        static const char* const axes[] = {"x", "y", "z"};
        for (std::size_t k = 0; k < 3; ++k) {
            if (!id_.simulated && !stated.p[k])
                return problems_.error(fields().place(&Stated::positions, i, &StatedPosition::p, k),
                                       tell<"this position was not measured: give x, y and z or take its row "
                                            "out">());
            id_.rows.push_back({.kind = static_cast<RowKind>(k),
                                .pose = *pose,
                                .target = *target,
                                .input = id_.distances.size() + i,
                                .check = stated.check,
                                .value = stated.p[k].value_or(0.0),
                                .name = tell<"%1, %2">(id_.label(*pose, *target), axes[k]),
                                .source = fields().place(&Stated::positions, i)});
        }
    }

    void sort_rows() {
        std::ranges::stable_partition(id_.rows, [](const Row& row) { return !row.check; });
        id_.fitted_rows =
            static_cast<std::size_t>(std::ranges::count_if(id_.rows, [](const Row& r) { return !r.check; }));
    }

    Identification& id_;
    Problems& problems_;
    Names targets_, places_, poses_;
    bool too_many_zeros_ = false;
};

void list_parameters(Identification& id, Problems& problems) {
    std::set<std::string> held;
    for (const Stated::Held& row : id.held_by_user) held.insert(row.parameter);
    const auto& joints = id.robot().joints();
    for (std::size_t j = 0; j < joints.size(); ++j)
        for (const JointParameter p : joint_parameters) {
            const std::string symbol = IdentifiedParameter{j, p}.symbol();
            if (p == JointParameter::d && joints[j].parallel)
                id.held.push_back({symbol, parallel_to_the_next()});
            if (!joints[j].has(p)) continue;
            if (held.erase(symbol) > 0)
                id.held.push_back({symbol, "held at its nominal value by the set-up"});
            else
                id.unknowns.push_back({UnknownKind::parameter, j, 0, p});
        }
    for (const std::string& symbol : held)
        problems.error(
            fields().place(&Stated::held_by_user),
            tell<"the robot has no parameter '%1' to hold; write its symbol, such as d_3">(symbol));
}

/// Lists all that could be found; the fit takes out what the readings cannot tell.
void list_unknowns(Identification& id, Problems& problems) {
    auto& unknowns = id.unknowns;
    for (std::size_t k = 0; id.base_found && k < 6; ++k) unknowns.push_back({UnknownKind::base, 0, k});
    for (std::size_t i = 0; i < id.fixed_places.size(); ++i)
        for (std::size_t k = 0; id.fixed_places[i].found && k < 3; ++k)
            unknowns.push_back({UnknownKind::place, i, k});
    for (std::size_t i = 0; i < id.zeros.size(); ++i) unknowns.push_back({UnknownKind::zero, i});
    for (std::size_t i = 0; i < id.arm_targets.size(); ++i)
        for (std::size_t k = 0; id.arm_targets[i].found && k < 3; ++k)
            unknowns.push_back({UnknownKind::target, i, k});
    list_parameters(id, problems);
    const auto& joints = id.robot().joints();
    for (std::size_t j = 0; id.compliant && j < joints.size(); ++j)
        if (!joints[j].slides) unknowns.push_back({UnknownKind::compliance, j});
}

}  // namespace

std::optional<Identification> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    StatedIdentification stated = fields().read(setup, assets, problems);
    if (problems.has_errors()) return {};
    Identification id(std::move(stated));
    id.X_MB = id.robot().X_WB();
    RowReading(id, problems).read();
    if (problems.has_errors()) return {};
    if (id.simulated) simulate(id);
    add_inputs(id, problems);
    list_unknowns(id, problems);
    if (problems.has_errors()) return {};
    const bool seen = !id.simulated && id.uncertainties != evidence::UncertaintiesFrom::stated;
    const ComponentEvidence evidence = seen ? evidence_as_stated(id) : ComponentEvidence();
    if (seen)
        take_as_seen(id.inputs, evidence, id.uncertainties, fields().place(&Stated::uncertainties), problems);
    if (!fit(id, problems)) return {};
    if (seen) id.statistics.evidence = evidence;
    return id;
}

}  // namespace covaria::reading_identification
