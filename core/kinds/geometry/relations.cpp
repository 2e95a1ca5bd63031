// The set-up of "relation of features": fields, reading, inputs and outputs.
#include "core/kinds/geometry/relations.h"

#include <cmath>
#include <map>

#include "core/base/name.h"

namespace covaria::geometry {

namespace {

Columns<RelatedFeature> related_columns() {
    using Row = RelatedFeature;
    const Unit mm = Unit::of("mm");
    const Range not_negative{.low = 0.0};
    return Columns<Row>()
        .add(&Row::name, "name", "name", "Name of the feature here, unique.")
        .add(&Row::source, "analysis", "analysis",
             "The analysis whose result it is; empty: place and direction are typed.", {.optional = true})
        .add(&Row::there, "feature", "feature",
             "Its name in that analysis: a feature, a target, \"apex of C1\"; empty: the name here.",
             {.optional = true})
        .each(&Row::p, by_axis(along_axes, "Typed coordinate *; empty: 0.", {.unit = mm, .optional = true}))
        .each(&Row::n,
              by_axis({"n_x", "n_y", "n_z"},
                      "Typed direction, component *, of any length; empty: it has none.", {.optional = true}))
        .add(&Row::u_p, "u", "u", "Standard uncertainty of each typed coordinate; empty: none.",
             {.unit = mm, .range = not_negative, .optional = true})
        .add(&Row::u_n, "u_n", "u_n",
             "Standard uncertainty of the typed direction, of two tilts across it; empty: none.",
             {.unit = Unit::of("mrad"), .range = not_negative, .optional = true});
}

Columns<StatedRelation> stated_columns() {
    using Row = StatedRelation;
    using R = Relation;
    return Columns<Row>()
        .add(&Row::name, "name", "name", "Name of the result, unique.")
        .choice(&Row::relation, "relation", "relation", "What is wanted of the features.",
                {{R::distance, "distance", "distance of two places"},
                 {R::from_plane, "from-plane", "distance of a place from a plane"},
                 {R::from_line, "from-line", "distance of a place from a line"},
                 {R::between_lines, "between-lines", "distance of two lines"},
                 {R::angle, "angle", "angle of two directions"},
                 {R::tilts, "tilts", "tilts of a direction against another"},
                 {R::middle, "middle", "middle of two places"},
                 {R::foot_on_plane, "foot-on-plane", "foot of a place on a plane"},
                 {R::foot_on_line, "foot-on-line", "foot of a place on a line"},
                 {R::line_and_plane, "line-and-plane", "intersection of a line and a plane"},
                 {R::two_lines, "two-lines", "intersection of two lines"},
                 {R::three_planes, "three-planes", "intersection of three planes"},
                 {R::two_planes, "two-planes", "line of two planes"},
                 {R::frame, "frame", "frame: origin, z, x"},
                 {R::frame_on_plane, "frame-on-plane", "frame: origin on a plane, its normal z, x"}})
        .add(&Row::first, "first", "first",
             "A feature: the place, line or plane that is asked about; of a frame its origin.")
        .add(&Row::second, "second", "second",
             "Another one: what it is related to; of a frame the direction of z.")
        .add(&Row::third, "third", "third",
             "A third one: the third plane; of a frame and of tilts what x points to, along its direction if "
             "it has one, else towards its place.",
             {.optional = true});
}

std::string feature_row(std::size_t row) {
    return relation_fields().place(&StatedRelations::features, row);
}
std::string relation_row(std::size_t row) {
    return relation_fields().place(&StatedRelations::relations, row);
}

constexpr std::array<const char*, 3> direction_symbols{"n_x", "n_y", "n_z"};

class RelationReading {
public:
    RelationReading(const StatedRelations& stated, Problems& problems)
        : stated_(stated), problems_(problems) {}

    std::optional<RelationSetup> read() {
        for (std::size_t row = 0; row < stated_.features.size(); ++row) take_feature(row);
        if (problems_.has_errors()) return {};
        for (std::size_t row = 0; row < stated_.relations.size(); ++row) take_relation(row);
        if (problems_.has_errors()) return {};
        return std::move(setup_);
    }

private:
    void take_feature(std::size_t row) {
        const RelatedFeature& stated = stated_.features[row];
        if (!numbers_.emplace(stated.name, row).second)
            problems_.error(feature_row(row), tell<"two features are called '%1'">(stated.name));
        PlacedInput feature{.name = stated.name};
        feature.first_input = setup_.inputs.quantities.size();
        if (stated.source)
            take_result(row, feature);
        else if (stated.source.id.empty())
            take_typed(row, feature);
        setup_.features.push_back(std::move(feature));
    }

    void take_result(std::size_t row, PlacedInput& feature) {
        const RelatedFeature& stated = stated_.features[row];
        const std::string& there = stated.there.empty() ? stated.name : stated.there;
        const auto* outputs = offers<PointOutputSource>(stated.source.asset);
        const auto place = stated.source->place(there);
        if (!outputs || !outputs->coordinate(there, 0))
            return problems_.error(feature_row(row),
                                   tell<"%1 has no feature called '%2'">(stated.source.name, there));
        if (!place) return problems_.error(feature_row(row), tell<"%1 has no value">(stated.source.name));
        feature.p = *place;
        const auto direction = stated.source->direction(there);
        feature.has_direction = direction.has_value();
        if (direction) feature.n = direction->normalized();
        add_inputs(row, feature);
        for (std::size_t c = 0; c < 3; ++c) {
            const OutputReference coordinate = *outputs->coordinate(there, c);
            setup_.inputs.quantities[feature.first_input + c].taken_from = coordinate;
            if (!direction) continue;
            OutputReference component = coordinate;
            component.symbol = direction_symbols[c];
            setup_.inputs.quantities[feature.first_input + 3 + c].taken_from = component;
        }
    }

    void take_typed(std::size_t row, PlacedInput& feature) {
        const RelatedFeature& stated = stated_.features[row];
        for (std::size_t c = 0; c < 3; ++c) {
            const auto i = Eigen::Index(c);
            feature.p[i] = stated.p[c].value_or(0.0);
            feature.n[i] = stated.n[c].value_or(0.0);
            feature.has_direction = feature.has_direction || stated.n[c].has_value();
        }
        const double longest = feature.n.cwiseAbs().maxCoeff();
        if (feature.has_direction && !(longest > 0.0))
            return problems_.error(feature_row(row), tell<"the direction of '%1' is zero">(feature.name));
        if (feature.has_direction) feature.n = (feature.n / longest).normalized();
        add_inputs(row, feature);
        const double u_p = stated.u_p.value_or(0.0), u_n = stated.u_n.value_or(0.0);
        for (std::size_t c = 0; c < 3 && u_p > 0.0; ++c) {
            InputQuantity& quantity = setup_.inputs.quantities[feature.first_input + c];
            quantity.shares.push_back(
                {add_component(quantity.symbol + ".typed", tell<"typed coordinate">(), Unit::of("mm"), u_p),
                 1.0});
        }
        if (!feature.has_direction || !(u_n > 0.0)) return;
        const Eigen::Vector3d e1 = feature.n.cross(axis_most_across(feature.n)).normalized();
        const Eigen::Vector3d e2 = feature.n.cross(e1);
        for (const auto& [across, number] : {std::pair(e1, 1), std::pair(e2, 2)}) {
            const std::size_t component =
                add_component(std::to_string(row + 1) + ".tilt_" + std::to_string(number),
                              tell<"tilt of the typed direction">(), Unit::of("mrad"), u_n);
            for (std::size_t c = 0; c < 3; ++c)
                if (const double share = across[Eigen::Index(c)]; share != 0.0)
                    setup_.inputs.quantities[feature.first_input + 3 + c].shares.push_back(
                        {component, share});
        }
    }

    std::size_t add_component(std::string id, Message name, const Unit& unit, double u) {
        return setup_.inputs.add({.id = std::move(id),
                                  .name = std::move(name),
                                  .unit = unit,
                                  .distribution = Distribution::normal(u),
                                  .origin = tell<"typed standard uncertainty">()});
    }

    void add_inputs(std::size_t row, const PlacedInput& feature) {
        const std::string number = "_" + std::to_string(row + 1);
        for (std::size_t c = 0; c < (feature.has_direction ? 6u : 3u); ++c) {
            const bool turn = c >= 3;
            const std::size_t axis = c % 3;
            InputQuantity quantity{
                .symbol = (turn ? "n" : "") + std::string(along_axes[axis]) + number,
                .name = turn ? tell<"%1, direction along %2">(feature.name, along_axes[axis])
                             : tell<"%1, coordinate %2">(feature.name, along_axes[axis]),
                .unit = turn ? Unit{} : Unit::of("mm"),
                .offset = turn ? feature.n[Eigen::Index(axis)] : feature.p[Eigen::Index(axis)],
                .group = feature.name,
                .source = feature_row(row)};
            setup_.inputs.quantities.push_back(std::move(quantity));
        }
    }

    void take_relation(std::size_t row) {
        const StatedRelation& stated = stated_.relations[row];
        if (!names_.emplace(stated.name, row).second)
            problems_.error(relation_row(row), tell<"two relations are called '%1'">(stated.name));
        ResolvedRelation relation{.name = stated.name, .relation = stated.relation, .features = {}};
        const RelationNeeds needs = needs_of(stated.relation);
        const std::array<const std::string*, 3> named{&stated.first, &stated.second, &stated.third};
        for (std::size_t k = 0; k < 3; ++k) {
            if (named[k]->empty() && k >= needs.least) continue;
            if (!named[k]->empty() && k >= needs.most)
                return problems_.error(relation_row(row) + "/third",
                                       tell<"'%1' takes two features; leave the third empty">(stated.name));
            const auto found = numbers_.find(*named[k]);
            if (found == numbers_.end())
                return problems_.error(relation_row(row), named[k]->empty()
                                                              ? tell<"'%1' needs three features">(stated.name)
                                                              : tell<"there is no feature '%1'">(*named[k]));
            if (needs.direction[k] && !setup_.features[found->second].has_direction)
                return problems_.error(relation_row(row), tell<"'%1' has no direction, which '%2' needs">(
                                                              *named[k], stated.name));
            relation.features.push_back(found->second);
        }
        relation.first_output = setup_.outputs.size();
        add_outputs(relation);
        setup_.relations.push_back(std::move(relation));
    }

    void add_outputs(const ResolvedRelation& relation) {
        const Unit mm = Unit::of("mm");
        const auto add = [&](const char* symbol, Message name, const Unit& unit, bool periodic = false) {
            setup_.outputs.push_back({.symbol = symbol,
                                      .name = std::move(name),
                                      .unit = unit,
                                      .group = relation.name,
                                      .periodic = periodic});
        };
        switch (relation.relation) {
            case Relation::distance:
            case Relation::from_plane:
            case Relation::from_line:
            case Relation::between_lines:
                return add("l", tell<"%1, distance">(relation.name), mm);
            case Relation::angle:
                return add("phi", tell<"%1, angle">(relation.name), Unit::of("deg"));
            case Relation::tilts:
                add("t_x", tell<"%1, tilt towards x">(relation.name), Unit::of("mrad"));
                return add("t_y", tell<"%1, tilt towards y">(relation.name), Unit::of("mrad"));
            default:
                break;
        }
        for (const char* axis : along_axes) add(axis, tell<"%1, coordinate %2">(relation.name, axis), mm);
        if (relation.relation == Relation::two_planes)
            for (std::size_t c = 0; c < 3; ++c)
                add(direction_symbols[c], tell<"%1, direction along %2">(relation.name, along_axes[c]), {});
        if (relation.relation != Relation::frame && relation.relation != Relation::frame_on_plane) return;
        static constexpr std::array<const char*, 3> angles{"alpha", "beta", "gamma"};
        for (std::size_t c = 0; c < 3; ++c)
            add(angles[c], tell<"%1, rotation about %2">(relation.name, along_axes[c]), Unit::of("deg"),
                true);
    }

    const StatedRelations& stated_;
    Problems& problems_;
    RelationSetup setup_;
    std::map<std::string, std::size_t> numbers_, names_;
};

}  // namespace

const Fields<StatedRelations>& relation_fields() {
    static const auto fields =
        Fields<StatedRelations>()
            .section("Features")
            .table(&StatedRelations::features, "features", "Features",
                   "Results of analyses (features, targets, frames' origins), or typed ones, such as the "
                   "direction of gravity.",
                   related_columns(), {.min_rows = 1})
            .section("Relations")
            .table(&StatedRelations::relations, "relations", "Relations",
                   "Distances, angles, intersections and frames of the features.", stated_columns(),
                   {.min_rows = 1});
    return fields;
}

std::optional<RelationSetup> read_relations(const SetupReader& reader, const AssetLibrary& assets,
                                            Problems& problems) {
    const StatedRelations stated = relation_fields().read(reader, assets, problems);
    if (problems.has_errors()) return {};
    return RelationReading(stated, problems).read();
}

}  // namespace covaria::geometry
