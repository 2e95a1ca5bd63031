// Measurement model "relation of features": the model class and its descriptor.
#include "core/base/name.h"
#include "core/kinds/geometry/model.h"
#include "core/kinds/geometry/relations.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using geometry::PlacedInput;
using geometry::Relation;
using geometry::RelationSetup;
using geometry::ResolvedRelation;

Layout layout_of_relations(const RelationSetup& setup, std::span<const double> x,
                           const std::vector<double>& y) {
    Layout layout;
    const auto place_of = [&](std::size_t k) {
        const std::size_t i = setup.features[k].first_input;
        return Eigen::Vector3d(x[i], x[i + 1], x[i + 2]);
    };
    double size = 0.0;
    for (std::size_t k = 0; k < setup.features.size(); ++k)
        size = std::max(size, (place_of(k) - place_of(0)).norm());
    for (std::size_t k = 0; k < setup.features.size(); ++k) {
        const PlacedInput& feature = setup.features[k];
        LayoutPoint point{.name = feature.name, .kind = PointKind::target, .p_W = place_of(k)};
        point.inputs = {{feature.first_input, feature.first_input + 1, feature.first_input + 2}};
        layout.points.push_back(std::move(point));
        if (!feature.has_direction || !(size > 0.0)) continue;
        const std::size_t i = feature.first_input + 3;
        const Eigen::Vector3d half = 0.1 * size * Eigen::Vector3d(x[i], x[i + 1], x[i + 2]).normalized();
        layout.links.push_back(
            {feature.name, LinkKind::joint_axis, place_of(k) - half, place_of(k) + half, {}});
    }
    for (const ResolvedRelation& relation : setup.relations) {
        const std::size_t out = relation.first_output;
        if (relation.relation == Relation::distance)
            layout.links.push_back({relation.name, LinkKind::dimension, place_of(relation.features[0]),
                                    place_of(relation.features[1]), relation.name});
        if (setup.outputs[out].symbol != "x") continue;
        const Eigen::Vector3d p(y[out], y[out + 1], y[out + 2]);
        LayoutPoint point{.name = relation.name, .kind = PointKind::tool, .p_W = p};
        point.group = relation.name;
        point.outputs = {{out, out + 1, out + 2}};
        layout.points.push_back(std::move(point));
        if (relation.relation != Relation::frame && relation.relation != Relation::frame_on_plane) continue;
        LayoutFrame frame{.name = relation.name};
        frame.X_WF.linear() = rotation_from_zyx<double>({y[out + 3], y[out + 4], y[out + 5]});
        frame.X_WF.translation() = p;
        frame.group = relation.name;
        layout.frames.push_back(std::move(frame));
    }
    return layout;
}

class FeatureRelations : public EquationModel<FeatureRelations> {
public:
    explicit FeatureRelations(RelationSetup setup) : setup_(std::move(setup)) {}

    const InputSet& inputs() const override { return setup_.inputs; }
    const std::vector<OutputQuantity>& outputs() const override { return setup_.outputs; }
    Layout layout(std::span<const double> x) const override {
        std::vector<double> y(setup_.outputs.size());
        if (!evaluate(x, y)) return {};
        return layout_of_relations(setup_, x, y);
    }
    std::shared_ptr<const Asset> as_asset(const std::string& id) const override {
        return std::make_shared<OutputFeatures>(id, *this);
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        for (const ResolvedRelation& relation : setup_.relations)
            geometry::evaluate_relation<Real>(setup_, relation, x, y);
        return Real(0.0) == Real(0.0);
    }

private:
    RelationSetup setup_;
};

/// Places that are the same have a distance without derivatives, parallel lines no common perpendicular.
Message objection_to(const RelationSetup& setup, const ResolvedRelation& relation) {
    constexpr double least = 1e-9;
    const auto n = [&](std::size_t k) { return setup.features[relation.features[k]].n; };
    const auto p = [&](std::size_t k) { return setup.features[relation.features[k]].p; };
    const auto sine = [&](std::size_t a, std::size_t b) { return n(a).cross(n(b)).norm(); };
    switch (relation.relation) {
        case Relation::distance:
            if (!((p(1) - p(0)).norm() > 0.0)) return tell<"the two places are the same">();
            return {};
        case Relation::from_line:
            if (!(n(1).cross(p(0) - p(1)).norm() > 0.0)) return tell<"the place is on the line">();
            return {};
        case Relation::between_lines:
        case Relation::two_lines:
        case Relation::two_planes:
            if (!(sine(0, 1) > least)) return tell<"the two are parallel">();
            return {};
        case Relation::angle:
            if (!(sine(0, 1) > least))
                return tell<"the directions are parallel: ask for tilts, which have a sign">();
            return {};
        case Relation::line_and_plane:
            if (!(std::abs(n(0).dot(n(1))) > least)) return tell<"the line is parallel to the plane">();
            return {};
        case Relation::three_planes:
            if (!(std::abs(n(0).dot(n(1).cross(n(2)))) > least))
                return tell<"the three planes have no common point">();
            return {};
        case Relation::frame:
        case Relation::frame_on_plane: {
            const PlacedInput& third = setup.features[relation.features[2]];
            const Eigen::Vector3d towards =
                third.has_direction ? third.n : Eigen::Vector3d((third.p - p(0)).normalized());
            if (!(n(1).cross(towards).norm() > least)) return tell<"x and z are parallel">();
            return {};
        }
        default:
            return {};
    }
}

std::unique_ptr<MeasurementModel> create_relations(const SetupReader& reader, const AssetLibrary& assets,
                                                   Problems& problems) {
    std::optional<RelationSetup> setup = geometry::read_relations(reader, assets, problems);
    if (!setup) return nullptr;
    for (std::size_t row = 0; row < setup->relations.size(); ++row) {
        const Message objection = objection_to(*setup, setup->relations[row]);
        if (!objection.empty())
            problems.error(geometry::relation_fields().place(&geometry::StatedRelations::relations, row),
                           tell<"'%1': %2">(setup->relations[row].name, objection));
    }
    if (problems.has_errors()) return nullptr;
    return std::make_unique<FeatureRelations>(std::move(*setup));
}

std::vector<ModelEquation> relation_equations() {
    const Message rule =
        tell<"elementary geometry; p places, n unit directions of the first, second, third">();
    return {{"l = |p₂ − p₁|", rule},
            {"l = n₂ᵀ(p₁ − p₂)", tell<"from a plane; from a line the length across n₂">()},
            {"l = |(n₁ × n₂)ᵀ(p₂ − p₁)| / |n₁ × n₂|", tell<"between lines">()},
            {"φ = atan2(|n₁ × n₂|, n₁ᵀn₂)", tell<"angle of two directions">()},
            {"t_x = atan2(xᵀn₁, zᵀn₁),  t_y = atan2(yᵀn₁, zᵀn₁)", tell<"tilts, z = n₂">()},
            {"R = (x, y, z),  z = n₂,  x = (v − z zᵀv)/|v − z zᵀv|,  y = z × x",
             tell<"frames, v of the third">()}};
}

}  // namespace

ModelDescriptor feature_relations_model() {
    ModelDescriptor d;
    d.id = "feature-relations";
    d.title = "Relation of features";
    d.summary =
        "Distances, angles, intersections and frames of features and points that other analyses measured, or "
        "that are typed.";
    d.references = {{"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = relation_equations();
    d.notes = {
        "Features are evaluated with the relations as one model in every trial: what two features have in "
        "common, as the station of their instrument, cancels where it cancels.",
        "A direction is that of the feature, with its sign: of a plane the normal. The angle of a line and a "
        "plane is 90° less the angle of their directions.",
        "The angle of nearly parallel directions is never negative, so its estimate is too large where its "
        "uncertainty is not small; tilts have signs and no such bias.",
        "A frame's angles are those of Z-Y-X: R = Rz(γ) Ry(β) Rx(α)."};
    d.help_page = "feature-relations.md";
    d.example = "robot-flange.covaria";
    d.capabilities = {PointUncertaintySource::capability, FeatureSource::capability};
    d.schema = geometry::relation_fields().schema();
    d.create = create_relations;
    return d;
}

}  // namespace covaria
