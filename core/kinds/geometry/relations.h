// The set-up of "relation of features", and its equations for every number type.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinds/geometry/feature_source.h"
#include "core/math/rotation.h"
#include "core/math/rotation_convention.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria::geometry {

enum class Relation {
    distance,        ///< between the places of two features
    from_plane,      ///< distance of a place from a plane, along its normal
    from_line,       ///< distance of a place from a line
    between_lines,   ///< distance along their common perpendicular
    angle,           ///< between two directions
    tilts,           ///< angles of a direction against another
    middle,          ///< point between two places
    foot_on_plane,   ///< point of a plane next to a place
    foot_on_line,    ///< point of a line next to a place
    line_and_plane,  ///< their common point
    two_lines,       ///< middle of their common perpendicular
    three_planes,    ///< their common point
    two_planes,      ///< their common line
    frame,           ///< place, z along a direction, x towards a third feature
    frame_on_plane,  ///< as `frame`, the origin moved into a plane along its normal, which is z
};

struct RelatedFeature {
    std::string name, there;
    Offered<FeatureSource> source;
    std::array<std::optional<double>, 3> p = {}, n = {};
    std::optional<double> u_p = {}, u_n = {};
};

struct StatedRelation {
    std::string name;
    Relation relation = Relation::distance;
    std::string first, second, third;
};

struct StatedRelations {
    std::vector<RelatedFeature> features;
    std::vector<StatedRelation> relations;
};
const Fields<StatedRelations>& relation_fields();

/// A feature with its estimates; inputs: the place, and behind it the direction where it has one.
struct PlacedInput {
    std::string name;
    Eigen::Vector3d p = Eigen::Vector3d::Zero(), n = Eigen::Vector3d::Zero();
    bool has_direction = false;
    std::size_t first_input = 0;
};

struct ResolvedRelation {
    std::string name;
    Relation relation = Relation::distance;
    std::vector<std::size_t> features;  ///< numbers of them
    std::size_t first_output = 0;
};

struct RelationSetup {
    std::vector<PlacedInput> features;
    std::vector<ResolvedRelation> relations;
    InputSet inputs;
    std::vector<OutputQuantity> outputs;
};
std::optional<RelationSetup> read_relations(const SetupReader& reader, const AssetLibrary& assets,
                                            Problems& problems);

/// Number of features that a relation takes, and which of them need a direction.
struct RelationNeeds {
    std::size_t least, most;
    std::array<bool, 3> direction;
};
constexpr RelationNeeds needs_of(Relation relation) {
    switch (relation) {
        case Relation::distance:
        case Relation::middle:
            return {2, 2, {false, false, false}};
        case Relation::from_plane:
        case Relation::from_line:
        case Relation::foot_on_plane:
        case Relation::foot_on_line:
            return {2, 2, {false, true, false}};
        case Relation::between_lines:
        case Relation::angle:
        case Relation::line_and_plane:
        case Relation::two_lines:
        case Relation::two_planes:
            return {2, 2, {true, true, false}};
        case Relation::tilts:
            return {2, 3, {true, true, false}};
        case Relation::three_planes:
            return {3, 3, {true, true, true}};
        case Relation::frame:
        case Relation::frame_on_plane:
            break;
    }
    return {3, 3, {false, true, false}};
}

template <class Real>
struct FeatureValues {
    Vector3<Real> p, n;  ///< n is a unit vector, or zero
    bool has_direction;
};

/// Values of a feature from its x on, relative to `origin`: places may be far away.
template <class Real, class In>
FeatureValues<Real> values_of(const PlacedInput& feature, const In& x, const Eigen::Vector3d& origin) {
    using namespace real_functions;
    FeatureValues<Real> values;
    values.has_direction = feature.has_direction;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto i = Eigen::Index(c);
        values.p[i] = Real(x[feature.first_input + c]) - Real(origin[i]);
        values.n[i] = feature.has_direction ? Real(x[feature.first_input + 3 + c]) : Real(0.0);
    }
    if (feature.has_direction)
        values.n = (values.n * Real(Real(1.0) / sqrt(Real(values.n.dot(values.n))))).eval();
    return values;
}

template <class Real>
class RelationEquations {
public:
    using Vector = Vector3<Real>;
    RelationEquations(const FeatureValues<Real>& a, const FeatureValues<Real>& b,
                      const FeatureValues<Real>& c)
        : a_(a), b_(b), c_(c) {}

    static Real length(const Vector& v) {
        using namespace real_functions;
        return sqrt(Real(v.dot(v)));
    }
    Real distance() const { return length(b_.p - a_.p); }
    Real from_plane() const { return b_.n.dot(a_.p - b_.p); }
    Vector foot_on_plane() const { return a_.p - b_.n * from_plane(); }
    Vector foot_on_line() const { return b_.p + b_.n * Real(b_.n.dot(a_.p - b_.p)); }
    Real from_line() const { return length(a_.p - foot_on_line()); }
    Real between_lines() const {
        using namespace real_functions;
        const Vector across = a_.n.cross(b_.n);
        return abs(Real(across.dot(b_.p - a_.p) / length(across)));
    }
    Real angle() const {
        using namespace real_functions;
        return atan2(length(a_.n.cross(b_.n)), Real(a_.n.dot(b_.n)));
    }
    Vector middle() const { return (a_.p + b_.p) * Real(0.5); }
    Vector line_and_plane() const { return a_.p + a_.n * Real(b_.n.dot(b_.p - a_.p) / b_.n.dot(a_.n)); }
    Vector two_lines() const {
        const Vector across = a_.n.cross(b_.n), d = b_.p - a_.p;
        const Real over = Real(1.0) / across.dot(across);
        const Real s = d.cross(b_.n).dot(across) * over, t = d.cross(a_.n).dot(across) * over;
        return (a_.p + a_.n * s + b_.p + b_.n * t) * Real(0.5);
    }
    Vector three_planes() const {
        const Vector bc = b_.n.cross(c_.n), ca = c_.n.cross(a_.n), ab = a_.n.cross(b_.n);
        return (bc * Real(a_.n.dot(a_.p)) + ca * Real(b_.n.dot(b_.p)) + ab * Real(c_.n.dot(c_.p))) *
               Real(Real(1.0) / a_.n.dot(bc));
    }
    /// The line's direction, and its point next to the place of the first plane.
    Vector common_direction() const {
        const Vector across = a_.n.cross(b_.n);
        return across * Real(Real(1.0) / length(across));
    }
    Vector two_planes() const {
        // in the first plane, from its place across the line
        const Vector towards = a_.n.cross(common_direction());
        return a_.p + towards * Real(b_.n.dot(b_.p - a_.p) / b_.n.dot(towards));
    }
    Vector origin(bool on_plane) const { return on_plane ? foot_on_plane() : a_.p; }
    /// Axes by columns: z along the second feature, x towards the third or along its direction.
    Matrix3<Real> axes(const Vector& origin) const {
        const Vector towards = c_.has_direction ? c_.n : Vector(c_.p - origin);
        return axes_about(b_.n, towards);
    }
    /// The first direction along x and y of axes whose z is the second; x is towards the third.
    std::array<Real, 2> tilts(const Eigen::Vector3d& x_without_third, bool has_third, double sign) const {
        Vector towards = Vector(Real(x_without_third[0]), Real(x_without_third[1]), Real(x_without_third[2]));
        if (has_third) towards = c_.has_direction ? c_.n : Vector(c_.p - b_.p);
        const Matrix3<Real> R = axes_about(b_.n, towards);
        using namespace real_functions;
        const Vector along = a_.n * Real(sign);
        const Vector x = R.col(0), y = R.col(1);
        const Real z = b_.n.dot(along);
        return {Real(atan2(Real(x.dot(along)), z)), Real(atan2(Real(y.dot(along)), z))};
    }

private:
    static Matrix3<Real> axes_about(const Vector& z, const Vector& towards) {
        Vector x = towards - z * Real(z.dot(towards));
        x = (x * Real(Real(1.0) / length(x))).eval();
        const Vector y = z.cross(x);
        Matrix3<Real> R;
        for (int i = 0; i < 3; ++i) {
            R(i, 0) = x[i];
            R(i, 1) = y[i];
            R(i, 2) = z[i];
        }
        return R;
    }
    const FeatureValues<Real>&a_, &b_, &c_;
};

/// The world's axis that lies most across the second direction: x of tilts without a third feature.
inline Eigen::Vector3d axis_most_across(const Eigen::Vector3d& n) {
    Eigen::Index least;
    n.cwiseAbs().minCoeff(&least);
    return Eigen::Vector3d::Unit(least);
}

template <class Real, class In, class Out>
void evaluate_relation(const RelationSetup& setup, const ResolvedRelation& relation, const In& x, Out& y) {
    const Eigen::Vector3d origin = setup.features[relation.features[0]].p;
    const auto values = [&](std::size_t k) {
        const std::size_t number = relation.features[std::min(k, relation.features.size() - 1)];
        return values_of<Real>(setup.features[number], x, origin);
    };
    const FeatureValues<Real> a = values(0), b = values(1), c = values(2);
    const RelationEquations<Real> e(a, b, c);
    const std::size_t out = relation.first_output;
    const auto set_place = [&](const Vector3<Real>& p) {
        for (std::size_t i = 0; i < 3; ++i)
            y.set(out + i, Real(p[Eigen::Index(i)] + Real(origin[Eigen::Index(i)])));
    };
    switch (relation.relation) {
        case Relation::distance:
            return y.set(out, e.distance());
        case Relation::from_plane:
            return y.set(out, e.from_plane());
        case Relation::from_line:
            return y.set(out, e.from_line());
        case Relation::between_lines:
            return y.set(out, e.between_lines());
        case Relation::angle:
            return y.set(out, e.angle());
        case Relation::tilts: {
            const Eigen::Vector3d na = setup.features[relation.features[0]].n,
                                  nb = setup.features[relation.features[1]].n;
            const auto t =
                e.tilts(axis_most_across(nb), relation.features.size() > 2, na.dot(nb) < 0.0 ? -1.0 : 1.0);
            y.set(out, t[0]);
            return y.set(out + 1, t[1]);
        }
        case Relation::middle:
            return set_place(e.middle());
        case Relation::foot_on_plane:
            return set_place(e.foot_on_plane());
        case Relation::foot_on_line:
            return set_place(e.foot_on_line());
        case Relation::line_and_plane:
            return set_place(e.line_and_plane());
        case Relation::two_lines:
            return set_place(e.two_lines());
        case Relation::three_planes:
            return set_place(e.three_planes());
        case Relation::two_planes: {
            set_place(e.two_planes());
            const Vector3<Real> n = e.common_direction();
            for (std::size_t i = 0; i < 3; ++i) y.set(out + 3 + i, n[Eigen::Index(i)]);
            return;
        }
        case Relation::frame:
        case Relation::frame_on_plane: {
            const Vector3<Real> o = e.origin(relation.relation == Relation::frame_on_plane);
            set_place(o);
            const auto angles = rotation_coordinates(RotationConvention::zyx, Matrix3<Real>(e.axes(o)));
            for (std::size_t i = 0; i < 3; ++i) y.set(out + 3 + i, angles[i]);
        }
    }
}

}  // namespace covaria::geometry
