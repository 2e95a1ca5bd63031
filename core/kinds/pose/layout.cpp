// Layout of the frames, points and plates of "pose from points".
#include "core/kinds/pose/layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/name.h"

namespace covaria::pose {

namespace {

class LayoutBuilder {
public:
    LayoutBuilder(const PoseSetup& setup, std::span<const double> x) : setup_(setup), x_(x) {}

    Layout build() {
        X_0b_ = add_frame(setup_.base, 0, Side::base, "");
        layout_.frames.back().source.path = setup_.a_posteriori ? "" : pose_fields().place(&PoseSetup::X_0b);
        for (std::size_t k = 0; k < setup_.poses.size(); ++k) add_pose(k);
        add_instrument(setup_.base_uncertainty);
        if (setup_.moving_uncertainty.source.id != setup_.base_uncertainty.source.id)
            add_instrument(setup_.moving_uncertainty);
        return std::move(layout_);
    }

private:
    /// Nests, plate and triad of one frame; returns X_0F.
    Eigen::Isometry3d add_frame(const FrameRule& rule, std::size_t first, Side side,
                                const std::string& group) {
        std::vector<Eigen::Vector3d> q;
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            q.emplace_back(x_[first + 3 * i], x_[first + 3 * i + 1], x_[first + 3 * i + 2]);
        const Eigen::Isometry3d X = frame_of(rule, q);
        for (std::size_t i = 0; i < q.size(); ++i) {
            LayoutPoint point{.name = rule.points[i].name, .kind = PointKind::nest, .p_W = q[i]};
            point.group = group;
            point.inputs = {{first + 3 * i, first + 3 * i + 1, first + 3 * i + 2}};
            point.source = nest_source(side, i, X);
            layout_.points.push_back(std::move(point));
            add_sight_lines(side == Side::base ? setup_.base_uncertainty : setup_.moving_uncertainty, q[i],
                            "sight of " + rule.points[i].name, group);
        }
        LayoutBody plate{.name = side == Side::base ? own_name<"base">() : own_name<"moving platform">()};
        plate.outline_W = outline(q, X);
        plate.group = group;
        layout_.bodies.push_back(std::move(plate));
        layout_.frames.push_back(
            {side == Side::base ? own_name<"base b">() : own_name<"platform p">(), X, group, {}});
        return X;
    }

    LayoutSource nest_source(Side side, std::size_t i, const Eigen::Isometry3d& X_0F) const {
        if (setup_.a_posteriori) return {pose_fields().place(&PoseSetup::measured), false};
        return {frame_fields(side).place(&FrameRule::points, i), true, X_0F};
    }

    void add_pose(std::size_t k) {
        const std::string& group = setup_.poses[k].name;
        const std::size_t first = 3 * setup_.base.points.size() + 3 * setup_.moving.points.size() * k;
        const Eigen::Isometry3d X = add_frame(setup_.moving, first, Side::moving, group);
        const LayoutSource source{pose_fields().place(&PoseSetup::poses, k), !setup_.a_posteriori, X_0b_};
        layout_.frames.back().source = source;
        LayoutPoint origin{.name = "o_p", .kind = PointKind::tool, .p_W = X.translation()};
        origin.group = group;
        origin.source = source;
        const std::size_t out = k * (3 + rotation_convention(setup_.orientation).coordinates.size());
        origin.outputs = {{out, out + 1, out + 2}};
        origin.R_WQ = X_0b_.linear();
        layout_.points.push_back(std::move(origin));
    }

    // The points in order around their middle, as seen along z of the frame.
    static std::vector<Eigen::Vector3d> outline(std::vector<Eigen::Vector3d> q, const Eigen::Isometry3d& X) {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& p : q) middle += p / static_cast<double>(q.size());
        const auto bearing = [&](const Eigen::Vector3d& p) {
            const Eigen::Vector3d d = X.linear().transpose() * (p - middle);
            return std::atan2(d.y(), d.x());
        };
        std::sort(q.begin(), q.end(), [&](const auto& a, const auto& b) { return bearing(a) < bearing(b); });
        return q;
    }

    void add_instrument(const UncertaintyRule& rule) {
        if (!rule.source || !rule.is_world()) return;
        const Layout own = as_part(rule.source.asset->layout(), rule.source.id);
        for (LayoutBody body : own.bodies) {
            if (own.bodies.size() == 1) body.name = rule.source.name;
            layout_.bodies.push_back(std::move(body));
        }
        for (LayoutPoint point : own.points) {
            if (own.points.size() == 1) point.name = rule.source.name;
            layout_.points.push_back(std::move(point));
        }
        layout_.links.insert(layout_.links.end(), own.links.begin(), own.links.end());
    }

    void add_sight_lines(const UncertaintyRule& rule, const Eigen::Vector3d& p, const std::string& name,
                         const std::string& group) {
        if (!rule.source) return;
        for (const Eigen::Vector3d& station : rule.source->stations_seeing(p))
            layout_.links.push_back({name, LinkKind::sight_line, station, p, group});
    }

    const PoseSetup& setup_;
    std::span<const double> x_;
    Eigen::Isometry3d X_0b_ = Eigen::Isometry3d::Identity();
    Layout layout_;
};

}  // namespace

Layout pose_layout(const PoseSetup& setup, std::span<const double> x) {
    return LayoutBuilder(setup, x).build();
}

}  // namespace covaria::pose
