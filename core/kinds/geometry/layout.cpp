// Points and features in the scene: planes and circles as plates, other forms as lines on them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/name.h"
#include "core/kinds/geometry/results.h"
#include "core/kinds/geometry/tables.h"

namespace covaria::geometry {

namespace {

using Eigen::Vector3d;

constexpr int corners_of_circle = 48;

/// A feature as the results state it.
struct PlacedFeature {
    Vector3d place = Vector3d::Zero(), n = Vector3d::UnitZ();
    double radius = 0.0, slope = 0.0;  ///< slope: change of a cone's radius along n
    double low = 0.0, high = 0.0;      ///< extent of the points along n
};

class LayoutOfFeatures {
public:
    LayoutOfFeatures(const GeometrySetup& setup, std::span<const double> x, std::span<const double> y)
        : setup_(setup), x_(x), y_(y) {}

    Layout build(const std::vector<std::size_t>& first_outputs) {
        for (std::size_t k = 0; k < setup_.features.size(); ++k) {
            feature_ = &setup_.features[k];
            first_ = first_outputs[k];
            add_points();
            add_place();
            add_form();
        }
        add_instrument();
        return std::move(layout_);
    }

private:
    Vector3d point(std::size_t i) const {
        const FeaturePoint& of = feature_->points[i];
        Vector3d p = of.p;
        for (std::size_t c = 0; c < feature_->coordinates(); ++c) p[Eigen::Index(c)] = x_[of.first_input + c];
        return p;
    }

    void add_points() {
        for (std::size_t i = 0; i < feature_->points.size(); ++i) {
            const FeaturePoint& of = feature_->points[i];
            LayoutPoint added{
                .name = Name(feature_->points.size() > 1 ? feature_->name + " " + of.name : of.name),
                .kind = PointKind::target,
                .p_W = point(i)};
            added.group = feature_->name;
            added.source = {geometry_fields().place(&StatedGeometry::points, of.row), false};
            if (feature_->coordinates() == 3)
                added.inputs = {{of.first_input, of.first_input + 1, of.first_input + 2}};
            layout_.points.push_back(std::move(added));
            const auto& source = setup_.stated.instrument.source;
            if (!source || setup_.stated.uncertainty != PointUncertainty::source) continue;
            for (const Vector3d& station : source->stations_seeing(point(i)))
                layout_.links.push_back(
                    {"sight of " + of.name, LinkKind::sight_line, station, point(i), feature_->name});
        }
    }

    void add_place() {
        const ResultPlaces at = places_of(*feature_);
        const auto vector_at = [&](std::size_t j) {
            Vector3d v = Vector3d::Zero();
            for (std::size_t c = 0; c < feature_->coordinates(); ++c) v[Eigen::Index(c)] = y_[first_ + j + c];
            return v;
        };
        placed_ = {};
        placed_.place = vector_at(0);
        if (feature_->coordinates() == 2) placed_.place.z() = feature_->fitted.origin.z();
        if (facts_of(feature_->form()).has_direction) placed_.n = vector_at(at.direction);
        if (facts_of(feature_->form()).has_diameter) placed_.radius = 0.5 * y_[first_ + at.diameter];
        if (feature_->form() == Form::cone)
            placed_.slope = std::copysign(std::tan(0.5 * y_[first_ + at.angle]), feature_->fitted.sign);
        for (std::size_t i = 0; i < feature_->points.size(); ++i) {
            const double along = placed_.n.dot(point(i) - placed_.place);
            placed_.low = std::min(placed_.low, along);
            placed_.high = std::max(placed_.high, along);
        }
        LayoutPoint added{.name = feature_->name, .kind = PointKind::other, .p_W = placed_.place};
        added.group = feature_->name;
        added.source = {geometry_fields().place(&StatedGeometry::features,
                                                std::size_t(feature_ - setup_.features.data())),
                        false};
        if (feature_->coordinates() == 3) added.outputs = {{first_, first_ + 1, first_ + 2}};
        layout_.points.push_back(std::move(added));
    }

    void add_form() {
        switch (feature_->form()) {
            case Form::point:
                return;
            case Form::plane:
                return add_plane();
            case Form::circle:
            case Form::circle_2d:
                return add_disc();
            case Form::sphere:
                for (int axis = 0; axis < 3; ++axis)
                    add_ring(placed_.place, Vector3d::Unit(axis), placed_.radius);
                return;
            case Form::cylinder:
            case Form::cone:
                add_ring(at(placed_.low), placed_.n, radius_at(placed_.low));
                add_ring(at(placed_.high), placed_.n, radius_at(placed_.high));
                add_generators();
                [[fallthrough]];
            case Form::line:
            case Form::line_2d: {
                const double beyond = 0.1 * (placed_.high - placed_.low);
                add_link(LinkKind::joint_axis, at(placed_.low - beyond), at(placed_.high + beyond));
            }
        }
    }

    Vector3d at(double along) const { return placed_.place + placed_.n * along; }
    double radius_at(double along) const { return std::abs(placed_.radius + placed_.slope * along); }

    void add_link(LinkKind kind, const Vector3d& from, const Vector3d& to) {
        layout_.links.push_back({feature_->name, kind, from, to, feature_->name});
    }

    static std::vector<Vector3d> ring(const Vector3d& centre, const Vector3d& n, double radius) {
        Eigen::Index least;
        n.cwiseAbs().minCoeff(&least);
        const Vector3d e1 = n.cross(Vector3d::Unit(least)).normalized(), e2 = n.cross(e1);
        std::vector<Vector3d> corners;
        for (int k = 0; k < corners_of_circle; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / corners_of_circle;
            corners.push_back(centre + radius * (std::cos(turn) * e1 + std::sin(turn) * e2));
        }
        return corners;
    }

    void add_ring(const Vector3d& centre, const Vector3d& n, double radius) {
        const std::vector<Vector3d> corners = ring(centre, n, radius);
        for (std::size_t k = 0; k < corners.size(); ++k)
            add_link(LinkKind::edge, corners[k], corners[(k + 1) % corners.size()]);
    }

    void add_generators() {
        const auto low = ring(at(placed_.low), placed_.n, radius_at(placed_.low)),
                   high = ring(at(placed_.high), placed_.n, radius_at(placed_.high));
        for (std::size_t k = 0; k < low.size(); k += low.size() / 8)
            add_link(LinkKind::edge, low[k], high[k]);
    }

    void add_disc() {
        LayoutBody disc{.name = feature_->name, .kind = BodyKind::plate};
        disc.outline_W = ring(placed_.place, placed_.n, placed_.radius);
        disc.group = feature_->name;
        layout_.bodies.push_back(std::move(disc));
    }

    /// The points' convex hull in the plane (A. M. Andrew's monotone chain).
    void add_plane() {
        const Eigen::Matrix3d axes = feature_->fitted.axes;
        std::vector<Eigen::Vector2d> q;
        for (std::size_t i = 0; i < feature_->points.size(); ++i)
            q.push_back(axes.leftCols<2>().transpose() * (point(i) - placed_.place));
        std::sort(q.begin(), q.end(), [](const auto& a, const auto& b) {
            return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
        });
        std::vector<Eigen::Vector2d> hull;
        const auto add_chain = [&](auto begin, auto end) {
            const std::size_t first = hull.size();
            for (auto p = begin; p != end; ++p) {
                while (hull.size() >= first + 2 && turns_right(hull[hull.size() - 2], hull.back(), *p))
                    hull.pop_back();
                hull.push_back(*p);
            }
            hull.pop_back();  // begins the other chain
        };
        add_chain(q.begin(), q.end());
        add_chain(q.rbegin(), q.rend());
        LayoutBody plate{.name = feature_->name, .kind = BodyKind::plate};
        for (const Eigen::Vector2d& corner : hull) {
            const Vector3d p = placed_.place + axes.leftCols<2>() * corner;
            plate.outline_W.push_back(p - placed_.n * placed_.n.dot(p - placed_.place));
        }
        plate.group = feature_->name;
        if (plate.outline_W.size() >= 3) layout_.bodies.push_back(std::move(plate));
    }
    static bool turns_right(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) <= 0.0;
    }

    void add_instrument() {
        const auto& instrument = setup_.stated.instrument;
        if (setup_.stated.uncertainty != PointUncertainty::source || !instrument.asset) return;
        const Layout own = as_part(instrument.asset->layout(), instrument.id);
        for (LayoutBody body : own.bodies) {
            if (own.bodies.size() == 1) body.name = instrument.name;
            layout_.bodies.push_back(std::move(body));
        }
        for (LayoutPoint point : own.points) {
            if (own.points.size() == 1) point.name = instrument.name;
            layout_.points.push_back(std::move(point));
        }
        layout_.links.insert(layout_.links.end(), own.links.begin(), own.links.end());
    }

    const GeometrySetup& setup_;
    std::span<const double> x_, y_;
    const Feature* feature_ = nullptr;
    std::size_t first_ = 0;
    PlacedFeature placed_;
    Layout layout_;
};

}  // namespace

Layout geometry_layout(const GeometrySetup& setup, const std::vector<std::size_t>& first_outputs,
                       std::span<const double> x, std::span<const double> y) {
    return LayoutOfFeatures(setup, x, y).build(first_outputs);
}

}  // namespace covaria::geometry
