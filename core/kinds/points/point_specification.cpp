// A manufacturer's figure for the uncertainty of a measured point (Porath et al., section 4).
#include <array>
#include <numbers>

#include "core/kinds/points/assets.h"
#include "core/kinds/points/own_frame_source.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/kinds/points/stated_figure.h"
#include "core/setup/fields.h"

namespace covaria {

namespace {

constexpr std::array<const char*, 3> point_coordinates{"x", "y", "z"};

struct StatedSpecification {
    double figure = 0.0;
    std::string meaning;
    bool of_length = false;
};

const Fields<StatedSpecification>& specification_fields() {
    using S = StatedSpecification;
    static const auto fields =
        Fields<S>()
            .section("Specification")
            .add(&S::figure, "figure", "Figure of the data sheet",
                 "The uncertainty or limit that the manufacturer states, the same for x, y and z.",
                 {.unit = Unit::of("mm"), .range = {.low = 0.0}})
            .add(&S::meaning, meaning_field("Specification"))
            .choice(&S::of_length, "applies_to", "The figure applies to",
                    "A coordinate of a point, or a length between two points; a length is the difference of "
                    "two points, so a coordinate has 1/√2 of it.",
                    {{false, "coordinate", "a coordinate"}, {true, "length", "a length between two points"}},
                    false);
    return fields;
}

class PointSpecification : public Asset {
public:
    PointSpecification(const Distribution& distribution, Message meaning)
        : distribution_(distribution), meaning_(std::move(meaning)) {
        std::vector<PointDeviation> deviations;
        for (std::size_t i = 0; i < 3; ++i) {
            const Message name = tell<"coordinate %1">(point_coordinates[i]);
            PointDeviation d{
                point_coordinates[i], name, Eigen::Vector3d::Unit(static_cast<int>(i)), {}, false};
            d.component = {.id = point_coordinates[i],
                           .name = name,
                           .unit = Unit::of("mm"),
                           .distribution = distribution_,
                           .origin = tell<"specification: %1">(meaning_)};
            deviations.push_back(std::move(d));
        }
        source_ = OwnFrameSource(std::move(deviations));
        offer(source_);
    }

    std::vector<Table> evaluation() const override {
        Table table{"specification", known_text<"Uncertainty of a measured point">()};
        table.add("coordinate");
        table.add("distribution");
        table.add("u").in(Unit::of("mm")).symbol().figure(3);
        for (const char* coordinate : point_coordinates)
            table.row({std::string(coordinate), Message::declared(distribution_.title()),
                       distribution_.standard_uncertainty()});
        table.notes.push_back(tell<"The figure is taken as: %1.">(meaning_));
        return {table};
    }

private:
    Distribution distribution_;
    Message meaning_;
    OwnFrameSource source_;
};

std::unique_ptr<Asset> create_specification(const SetupReader& setup, const AssetLibrary& assets,
                                            Problems& problems) {
    const StatedSpecification stated = specification_fields().read(setup, assets, problems);
    const Distribution distribution = specified_distribution(stated.meaning, stated.figure)
                                          .scaled(stated.of_length ? 1.0 / std::numbers::sqrt2 : 1.0);
    Message words = meaning_words(stated.meaning);
    if (stated.of_length) words = tell<"%1, of a length: divided by √2">(words);
    return std::make_unique<PointSpecification>(distribution, words);
}

}  // namespace

AssetDescriptor point_specification_kind() {
    AssetDescriptor d;
    d.kind = "point-specification";
    d.title = "Specification of a measured point";
    d.category = AssetCategory::instrument;
    d.summary =
        "One figure of a data sheet for all coordinates: a standard uncertainty or a maximum permissible "
        "error.";
    d.references = {
        {"Porath, Gross, Eger: Experimental-numerical approach to the estimation of uncertainty in "
         "robot pose measurement, section 4"},
        {"JCGM 100:2008, 4.3"}};
    d.notes = {
        "A specification taken alike in all directions overestimates, by a factor of 2 to 5 in the paper's "
        "example; an instrument that stands somewhere (spherical instrument) is closer to the truth."};
    d.capabilities = {PointUncertaintySource::capability};
    d.schema = specification_fields().schema();
    d.create = create_specification;
    return d;
}

}  // namespace covaria
