// Reading and checking the set-up of "pose from points".
#include "core/kinds/pose/setup.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/kinds/points/point_uncertainty.h"
#include "core/math/rotation.h"

namespace covaria::pose {

namespace {

constexpr double smallest_sine = 1e-6;  // below it rounding decides on the plane of three points

class PoseReader {
public:
    PoseReader(const SetupReader& setup, const AssetLibrary& assets, Problems& problems)
        : setup_(setup), assets_(assets), problems_(problems) {}

    std::optional<PoseSetup> read() {
        PoseSetup s;
        s.base = frame_rule(Side::base);
        s.moving = frame_rule(Side::moving);
        s.base_uncertainty = uncertainty_rule(Side::base);
        s.moving_uncertainty = uncertainty_rule(Side::moving);
        s.orientation = rotation_convention_from(setup_.text("orientation"));
        s.a_posteriori = setup_.text("evaluation") == "a-posteriori";
        if (!s.a_posteriori) s.X_0b = setup_.pose("base_pose");
        read_poses(s);
        if (problems_.has_errors()) return {};
        s.a_posteriori ? take_measured(s) : take_nominal(s);
        if (problems_.has_errors()) return {};
        return s;
    }

private:
    static std::string row_path(const std::string& table, std::size_t row) {
        return "/" + table + "/rows/" + std::to_string(row);
    }

    void refuse_duplicates(const std::string& table, const std::string& what) {
        std::set<std::string> names;
        for (std::size_t row = 0; row < setup_.rows(table); ++row) {
            const std::string name = setup_.cell_text(table, row, "name");
            if (!names.insert(name).second)
                problems_.error(row_path(table, row) + "/name",
                                "there are two " + what + " called '" + name + "'; rename one");
        }
    }

    FrameRule frame_rule(Side side) {
        const std::string prefix = prefix_of(side), table = prefix + "_points";
        refuse_duplicates(table, "points");
        FrameRule rule;
        rule.least_squares = setup_.text(prefix + "_fit") == "least-squares";
        for (std::size_t row = 0; row < setup_.rows(table); ++row)
            rule.points.push_back(nominal_point(table, row));
        if (rule.points.size() < 3) {
            problems_.error("/" + table, "the " + prefix + " frame needs at least three points");
            return rule;
        }
        if (rule.least_squares) {
            complete_least_squares(rule, table);
            return rule;
        }
        rule.third_point = setup_.text(prefix + "_third_point") == "negative-y" ? ThirdPoint::negative_y
                                                                                : ThirdPoint::positive_y;
        for (int i = 0; i < 3; ++i) rule.shift[i] = setup_.number(prefix + "_shift_" + "xyz"[i]);
        if (rule.points.size() > 3)
            problems_.warning(row_path(table, 3),
                              "the 3-2-1 method uses the first three points; point " + rule.points[3].name +
                                  " and those after it are not used: choose least squares");
        rule.points.resize(3);
        std::vector<Eigen::Vector3d> positions;
        for (const NominalPoint& p : rule.points) positions.push_back(p.local);
        check_three(rule, positions, side, row_path(table, 2));
        return rule;
    }

    NominalPoint nominal_point(const std::string& table, std::size_t row) {
        NominalPoint p{setup_.cell_text(table, row, "name"), setup_.cell_vector(table, row, "x")};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string column = std::string("u_") + "xyz"[i];
            if (!setup_.cell_empty(table, row, column)) p.u[i] = setup_.cell_number(table, row, column);
        }
        return p;
    }

    void check_three(const FrameRule& rule, const std::vector<Eigen::Vector3d>& q, Side side,
                     const std::string& path) {
        const std::string frame = "the " + prefix_of(side) + " frame is undefined";
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = i + 1; j < 3; ++j)
                if ((q[i] - q[j]).norm() <= smallest_sine * (q[0].norm() + q[1].norm() + q[2].norm())) {
                    problems_.error(path, "points " + rule.points[i].name + " and " + rule.points[j].name +
                                              " coincide: " + frame);
                    return;
                }
        if (sine_of_corner(q[0], q[1], q[2]) < smallest_sine)
            problems_.error(path, "point " + rule.points[2].name + " lies on the line through " +
                                      rule.points[0].name + " and " + rule.points[1].name + ": " + frame);
    }

    void complete_least_squares(FrameRule& rule, const std::string& table) {
        std::vector<Eigen::Vector3d> positions;
        for (const NominalPoint& p : rule.points) {
            positions.push_back(p.local);
            rule.centroid += p.local / static_cast<double>(rule.points.size());
        }
        if (spread_off_a_line(positions) < smallest_sine) {
            problems_.error("/" + table, "all points lie on one line or coincide: their frame is undefined");
            return;
        }
        for (const Eigen::Vector3d& p : positions) rule.centred.push_back(p - rule.centroid);
    }

    UncertaintyRule uncertainty_rule(Side side) {
        const std::string prefix = prefix_of(side);
        UncertaintyRule rule;
        if (setup_.text(prefix + "_uncertainty") == "typed") {
            for (std::size_t i = 0; i < 3; ++i) {
                rule.u[i] = setup_.number(prefix + "_u_" + "xyz"[i]);
                rule.common[i] = setup_.flag(prefix + "_common_" + "xyz"[i]);
            }
            rule.along_base = side == Side::moving && setup_.text("moving_uncertainty_axes") == "base";
            rule.distribution = setup_.text(prefix + "_distribution");
            return rule;
        }
        rule.asset_id = setup_.text(prefix + "_asset");
        const AssetLibrary::Entry* entry = assets_.find(rule.asset_id);
        if (!offers<PointUncertaintySource>(entry)) {
            problems_.error("/" + prefix + "_asset",
                            "'" + rule.asset_id +
                                "' cannot give the uncertainty of points: correct its "
                                "own problems first, or choose another");
            return rule;
        }
        rule.asset = entry->asset;
        rule.asset_name = entry->name;
        warn_of_unused_figures(prefix + "_points");
        return rule;
    }

    void warn_of_unused_figures(const std::string& table) {
        for (std::size_t row = 0; row < setup_.rows(table); ++row)
            for (const std::string column : {"u_x", "u_y", "u_z"})
                if (!setup_.cell_empty(table, row, column)) {
                    problems_.warning(row_path(table, row) + "/" + column,
                                      "not used: the uncertainties come from an artefact or instrument");
                    return;
                }
    }

    void read_poses(PoseSetup& s) {
        refuse_duplicates("poses", "poses");
        for (std::size_t row = 0; row < setup_.rows("poses"); ++row) {
            Pose pose;
            pose.name = setup_.cell_text("poses", row, "name");
            pose.X_bp.translation() = setup_.cell_vector("poses", row, "x");
            pose.X_bp.linear() = rotation_from_zyx<double>(setup_.cell_vector("poses", row, "alpha"));
            if (s.a_posteriori && pose.name == "base")
                problems_.error(
                    row_path("poses", row) + "/name",
                    "no pose may be called 'base': that names the base among the measured points");
            s.poses.push_back(std::move(pose));
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

    void take_measured(PoseSetup& s) {
        const Means means = measured_means(s);
        s.base_points = means_of(means, "base", s.base);
        for (Pose& pose : s.poses) pose.points = means_of(means, pose.name, s.moving);
        if (problems_.has_errors()) return;
        if (!s.base.least_squares) check_three(s.base, s.base_points, Side::base, "/measured_points");
        for (const Pose& pose : s.poses)
            if (!s.moving.least_squares) check_three(s.moving, pose.points, Side::moving, "/measured_points");
    }

    Means measured_means(const PoseSetup& s) {
        Means means;
        for (std::size_t row = 0; row < setup_.rows("measured_points"); ++row) {
            const std::string set = setup_.cell_text("measured_points", row, "set");
            const std::string point = setup_.cell_text("measured_points", row, "point");
            const bool known_pose = std::any_of(s.poses.begin(), s.poses.end(),
                                                [&](const Pose& pose) { return pose.name == set; });
            if (set != "base" && !known_pose)
                problems_.error(row_path("measured_points", row) + "/set",
                                "'" + set + "' is neither 'base' nor the name of a pose");
            const std::string table = set == "base" ? "base_points" : "moving_points";
            if (!has_point(table, point))
                problems_.error(row_path("measured_points", row) + "/point",
                                "there is no point called '" + point + "' in that frame");
            Sum& sum = means[{set, point}];
            sum.sum += setup_.cell_vector("measured_points", row, "x");
            ++sum.count;
        }
        return means;
    }

    bool has_point(const std::string& table, const std::string& name) const {
        for (std::size_t row = 0; row < setup_.rows(table); ++row)
            if (setup_.cell_text(table, row, "name") == name) return true;
        return false;
    }

    std::vector<Eigen::Vector3d> means_of(const Means& means, const std::string& set, const FrameRule& rule) {
        std::vector<Eigen::Vector3d> points;
        for (const NominalPoint& p : rule.points) {
            const auto found = means.find({set, p.name});
            if (found != means.end())
                points.push_back(found->second.sum / found->second.count);
            else
                problems_.error("/measured_points", "point " + p.name + " of '" + set + "' was not measured");
        }
        return points;
    }

    const SetupReader& setup_;
    const AssetLibrary& assets_;
    Problems& problems_;
};

}  // namespace

std::optional<PoseSetup> read_pose_setup(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    return PoseReader(setup, assets, problems).read();
}

}  // namespace covaria::pose
