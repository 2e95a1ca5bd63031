// Reading and checking the set-up of "pose from points".
#include "core/kinds/pose/setup.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/math/rotation.h"

namespace covaria::pose {

namespace {

constexpr double smallest_sine = 1e-6;  // below it rounding decides on the plane of three points

class PoseReader {
public:
    explicit PoseReader(Problems& problems) : problems_(problems) {}

    std::optional<PoseSetup> read(const SetupReader& setup, const AssetLibrary& assets) {
        PoseSetup s = pose_fields().read(setup, assets, problems_);
        complete_frame(s.base, Side::base);
        complete_frame(s.moving, Side::moving);
        warn_of_unused_figures(s.base, s.base_uncertainty, Side::base);
        warn_of_unused_figures(s.moving, s.moving_uncertainty, Side::moving);
        complete_poses(s);
        if (problems_.has_errors()) return {};
        const Means means = measured_means(s);
        for (FrameRule* rule : {&s.base, &s.moving})
            if (!rule->least_squares) rule->points.resize(3);
        s.a_posteriori ? take_measured(s, means) : take_nominal(s);
        if (problems_.has_errors()) return {};
        return s;
    }

private:
    /// Names are in the first column.
    template <class Row>
    void refuse_duplicates(const std::vector<Row>& rows, const std::string& table,
                           Message (*two_called)(const std::string& name)) {
        std::set<std::string> names;
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (!names.insert(rows[row].name).second)
                problems_.error(table + "/rows/" + std::to_string(row) + "/name", two_called(rows[row].name));
    }

    void complete_frame(FrameRule& rule, Side side) {
        const auto& fields = frame_fields(side);
        refuse_duplicates(rule.points, fields.place(&FrameRule::points), [](const std::string& name) {
            return tell<"there are two points called '%1'; rename one">(name);
        });
        if (rule.least_squares) return complete_least_squares(rule, fields.place(&FrameRule::points));
        if (rule.points.size() > 3)
            problems_.warning(fields.place(&FrameRule::points, 3),
                              tell<"the 3-2-1 method uses the first three points; point %1 and those after "
                                   "it are not used: choose least squares">(rule.points[3].name));
        std::vector<Eigen::Vector3d> positions;
        for (const NominalPoint& p : rule.points) positions.push_back(p.local);
        check_three(rule, positions, side, fields.place(&FrameRule::points, 2));
    }

    void check_three(const FrameRule& rule, const std::vector<Eigen::Vector3d>& q, Side side,
                     const std::string& path) {
        const Message frame = side == Side::base ? tell<"the base frame is undefined">()
                                                 : tell<"the moving frame is undefined">();
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = i + 1; j < 3; ++j)
                if ((q[i] - q[j]).norm() <= smallest_sine * (q[0].norm() + q[1].norm() + q[2].norm())) {
                    problems_.error(path, tell<"points %1 and %2 coincide: %3">(rule.points[i].name,
                                                                                rule.points[j].name, frame));
                    return;
                }
        if (sine_of_corner(q[0], q[1], q[2]) < smallest_sine)
            problems_.error(path, tell<"point %1 lies on the line through %2 and %3: %4">(
                                      rule.points[2].name, rule.points[0].name, rule.points[1].name, frame));
    }

    void complete_least_squares(FrameRule& rule, const std::string& table) {
        std::vector<Eigen::Vector3d> positions;
        for (const NominalPoint& p : rule.points) {
            positions.push_back(p.local);
            rule.centroid += p.local / static_cast<double>(rule.points.size());
        }
        if (spread_off_a_line(positions) < smallest_sine)
            problems_.error(table,
                            tell<"all points lie on one line or coincide: their frame is undefined">());
        for (const Eigen::Vector3d& p : positions) rule.centred.push_back(p - rule.centroid);
    }

    void warn_of_unused_figures(const FrameRule& rule, const UncertaintyRule& uncertainty, Side side) {
        if (!uncertainty.source) return;
        for (std::size_t row = 0; row < rule.points.size(); ++row)
            for (std::size_t i = 0; i < 3; ++i)
                if (rule.points[row].u[i])
                    return problems_.warning(
                        frame_fields(side).place(&FrameRule::points, row, &NominalPoint::u, i),
                        tell<"not used: the uncertainties come from an artefact or instrument">());
    }

    void complete_poses(PoseSetup& s) {
        refuse_duplicates(s.poses, pose_fields().place(&PoseSetup::poses), [](const std::string& name) {
            return tell<"there are two poses called '%1'; rename one">(name);
        });
        for (std::size_t row = 0; row < s.poses.size(); ++row) {
            Pose& pose = s.poses[row];
            pose.X_bp.translation() = pose.position;
            pose.X_bp.linear() = rotation_from_zyx<double>(pose.angles);
            if (s.a_posteriori && pose.name == "base")
                problems_.error(
                    pose_fields().place(&PoseSetup::poses, row, &Pose::name),
                    tell<"no pose may be called 'base': that names the base among the measured points">());
        }
    }

    static void take_nominal(PoseSetup& s) {
        for (const NominalPoint& b : s.base.points) s.base_points.push_back(s.X_0b * b.local);
        for (Pose& pose : s.poses)
            for (const NominalPoint& p : s.moving.points) pose.points.push_back(s.X_0b * pose.X_bp * p.local);
    }

    struct Sum {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        int count = 0;
    };
    using Means = std::map<std::pair<std::string, std::string>, Sum>;

    void take_measured(PoseSetup& s, const Means& means) {
        s.base_points = means_of(means, "base", s.base);
        for (Pose& pose : s.poses) pose.points = means_of(means, pose.name, s.moving);
        if (problems_.has_errors()) return;
        const std::string place = pose_fields().place(&PoseSetup::measured);
        if (!s.base.least_squares) check_three(s.base, s.base_points, Side::base, place);
        for (const Pose& pose : s.poses)
            if (!s.moving.least_squares) check_three(s.moving, pose.points, Side::moving, place);
    }

    Means measured_means(const PoseSetup& s) {
        Means means;
        const auto is_called = [](const std::string& name) {
            return [&name](const auto& one) { return one.name == name; };
        };
        for (std::size_t row = 0; row < s.measured.size(); ++row) {
            const auto& [set, point, number, p_0] = s.measured[row];
            if (set != "base" && std::none_of(s.poses.begin(), s.poses.end(), is_called(set)))
                problems_.error(pose_fields().place(&PoseSetup::measured, row, &Repeat::set),
                                tell<"'%1' is neither 'base' nor the name of a pose">(set));
            const auto& points = set == "base" ? s.base.points : s.moving.points;
            if (std::none_of(points.begin(), points.end(), is_called(point)))
                problems_.error(pose_fields().place(&PoseSetup::measured, row, &Repeat::point),
                                tell<"there is no point called '%1' in that frame">(point));
            Sum& sum = means[{set, point}];
            sum.sum += p_0;
            ++sum.count;
        }
        return means;
    }

    std::vector<Eigen::Vector3d> means_of(const Means& means, const std::string& set, const FrameRule& rule) {
        std::vector<Eigen::Vector3d> points;
        for (const NominalPoint& p : rule.points) {
            const auto found = means.find({set, p.name});
            if (found != means.end())
                points.push_back(found->second.sum / found->second.count);
            else
                problems_.error(pose_fields().place(&PoseSetup::measured),
                                tell<"point %1 of '%2' was not measured">(p.name, set));
        }
        return points;
    }

    Problems& problems_;
};

}  // namespace

std::optional<PoseSetup> read_pose_setup(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    return PoseReader(problems).read(setup, assets);
}

}  // namespace covaria::pose
