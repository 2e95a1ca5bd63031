// Repeatability of a robot: laws of the positioning deviation, and of the orientation.
#include <cmath>
#include <numbers>

#include "core/kinds/ballbar/assets.h"
#include "core/kinds/ballbar/repeatability.h"
#include "core/quantity/input_quantity.h"
#include "core/quantity/isotropic_vector.h"
#include "core/setup/fields.h"

namespace covaria {

namespace {

// Length of three independent normal coordinates of standard deviation 1 (Maxwell distribution): mean and
// standard deviation.
const double maxwell_mean = std::sqrt(8.0 / std::numbers::pi);
const double maxwell_deviation = std::sqrt(3.0 - 8.0 / std::numbers::pi);

constexpr std::array<const char*, 3> axes{"x", "y", "z"};

enum class PositionFigure { largest, iso_9283 };
enum class Law { uniform_radius, ball, sphere, normal };
enum class AngleFigure { standard, iso_9283, limit };

struct StatedRepeatability {
    double position = 0.0;  ///< m
    PositionFigure figure = PositionFigure::largest;
    Law law = Law::uniform_radius;
    double orientation = 0.0;  ///< rad
    AngleFigure angle_figure = AngleFigure::iso_9283;
};

const std::vector<ChoiceOf<Law>>& laws() {
    static const std::vector<ChoiceOf<Law>> choices{
        {Law::uniform_radius, "uniform-radius", "rectangular in [0, r] in a random direction"},
        {Law::ball, "ball", "anywhere in a ball of radius r"},
        {Law::sphere, "sphere", "always r, in a random direction"},
        {Law::normal, "normal", "normal along each axis"}};
    return choices;
}

void add_position(Fields<StatedRepeatability>& fields) {
    const char* const section = "Positioning";
    fields.section(section)
        .add(&StatedRepeatability::position, "repeatability", "Repeatability",
             "The robot's figure for the scatter of a position that it is sent to again and again.",
             {.unit = Unit::of("mm"), .range = {.low = 0.0}})
        .choice(&StatedRepeatability::figure, "figure", "The figure is",
                "A largest distance from the mean position, or RP of ISO 9283: the mean distance plus "
                "three times its standard deviation. A normal law has no largest distance, so its "
                "figure is always RP.",
                {{PositionFigure::largest, "largest", "the largest distance r"},
                 {PositionFigure::iso_9283, "iso-9283", "RP of ISO 9283: mean + 3 s"}},
                PositionFigure::largest)
        .choice(&StatedRepeatability::law, "law", "Deviation of a position",
                "How the distance from the mean position is distributed; all directions are equally "
                "probable.",
                laws(), Law::uniform_radius)
        .shown_where(&StatedRepeatability::law, {Law::uniform_radius, Law::ball, Law::sphere},
                     &StatedRepeatability::figure);
}

const Fields<StatedRepeatability>& repeatability_fields() {
    static const Fields<StatedRepeatability> fields = [] {
        Fields<StatedRepeatability> made;
        add_position(made);
        made.section("Orientation")
            .add(&StatedRepeatability::orientation, "orientation_repeatability", "Orientation",
                 "Figure for the scatter of the orientation about each axis of the flange; 0: none.",
                 {.unit = Unit::of("deg"),
                  .range = {.low = 0.0},
                  .default_value = Quantity{0.0, Unit::of("deg")}});
        made.choice(&StatedRepeatability::angle_figure, "orientation_figure", "The angle is",
                    "A standard uncertainty, RP of ISO 9283 for an angle (three times its standard "
                    "deviation), or a limit that is not exceeded.",
                    {{AngleFigure::standard, "standard", "standard uncertainty (normal)"},
                     {AngleFigure::iso_9283, "iso-9283", "RP of ISO 9283: ± 3 s (normal)"},
                     {AngleFigure::limit, "limit", "limit, rectangular: divided by √3"}},
                    AngleFigure::iso_9283);
        return made;
    }();
    return fields;
}

/// The distribution of one coordinate of the position's deviation.
Distribution position_distribution(const StatedRepeatability& stated) {
    const double value = stated.position;
    if (value == 0.0) return Distribution::normal(0.0);
    if (stated.law == Law::normal)
        return Distribution::normal(value / (maxwell_mean + 3.0 * maxwell_deviation));
    VectorLength length{stated.law == Law::ball     ? RadialLaw::ball
                        : stated.law == Law::sphere ? RadialLaw::sphere
                                                    : RadialLaw::uniform_length,
                        1.0};
    const double rp_of_one = length.mean() + 3.0 * length.standard_deviation();
    length.largest = stated.figure == PositionFigure::iso_9283 ? value / rp_of_one : value;
    return coordinate_distribution(length);
}

Distribution orientation_distribution(AngleFigure figure, double value) {
    if (figure == AngleFigure::limit) return Distribution::of(Rectangular{-value, value});
    return Distribution::normal(figure == AngleFigure::iso_9283 ? value / 3.0 : value);
}

class RobotRepeatability : public Asset, public RepeatabilitySource {
public:
    explicit RobotRepeatability(const StatedRepeatability& stated) : law_(stated.law) {
        const Distribution along = position_distribution(stated);
        for (std::size_t i = 0; i < 3; ++i)
            position_[i] = {.id = axes[i],
                            .name = tell<"repeatability along %1">(axes[i]),
                            .unit = Unit::of("um"),
                            .distribution = along,
                            .origin = tell<"repeatability: %1">(law_title())};
        if (stated.orientation > 0.0)
            add_orientation(orientation_distribution(stated.angle_figure, stated.orientation));
        offer(*this);
    }

    std::array<UncertaintyComponent, 3> position() const override { return position_; }
    std::optional<std::array<UncertaintyComponent, 3>> orientation() const override { return orientation_; }

    std::vector<Table> evaluation() const override {
        Table table{"repeatability", "Scatter of a pose that the robot is sent to again"};
        table.add("deviation");
        table.add("distribution");
        table.add("value").in(Unit::of("um")).figure(4);
        const Distribution& along = position_[0].distribution;
        table.row(
            {tell<"u along any axis">(), Message::declared(along.title()), along.standard_uncertainty()});
        const auto length = length_law_of(along);
        if (length) {
            table.row({tell<"distance: largest">(), law_title(), length->largest});
            table.row({tell<"distance: RP = mean + 3 s">(), law_title(),
                       length->mean() + 3.0 * length->standard_deviation()});
        } else {
            const double u = along.standard_uncertainty();
            table.row({tell<"distance: RP = mean + 3 s">(), law_title(),
                       (maxwell_mean + 3.0 * maxwell_deviation) * u});
        }
        table.notes.push_back(
            tell<"The coordinates are uncorrelated; unless they are normal, they are not "
                 "independent: the distance has the law above, its direction is random.">());
        return {table};
    }

private:
    Message law_title() const {
        for (const ChoiceOf<Law>& choice : laws())
            if (choice.value == law_) return Message::declared(choice.title);
        return {};
    }

    void add_orientation(const Distribution& about) {
        orientation_.emplace();
        for (std::size_t i = 0; i < 3; ++i)
            (*orientation_)[i] = {.id = std::string("rotation.") + axes[i],
                                  .name = tell<"repeatability about %1">(axes[i]),
                                  .unit = Unit::of("urad"),
                                  .distribution = about,
                                  .origin = tell<"repeatability of the orientation">()};
    }

    Law law_;
    std::array<UncertaintyComponent, 3> position_;
    std::optional<std::array<UncertaintyComponent, 3>> orientation_;
};

}  // namespace

AssetDescriptor robot_repeatability_kind() {
    AssetDescriptor d;
    d.kind = "robot-repeatability";
    d.title = "Robot: repeatability of a pose";
    d.category = AssetCategory::robot;
    d.summary =
        "A robot as a source of uncertainty: each time it goes to a pose it misses it by a distance in a "
        "random direction, and perhaps by small rotations.";
    d.references = {{"ISO 9283:1998, 7.2.2"},
                    {"F. J. Brosed et al.: Evaluation of the measurement uncertainty of a high-precision "
                     "telescopic instrument measuring the tool centre point of a robot (euspen 2025), 2.2"}};
    d.notes = {
        "The paper takes the distance as rectangular in [0, r], r being the data sheet's ± 0.02 mm; u along "
        "an "
        "axis is then r/3. RP of ISO 9283 is the mean distance plus three standard deviations, which is "
        "another "
        "figure: for that law RP = 1.366 r, in a ball 1.331 r, on a sphere r, and 3.616 u for normal "
        "coordinates.",
        "The paper leaves the orientation out. A rotation by e moves the tool by about e times its length."};
    d.capabilities = {RepeatabilitySource::capability};
    d.schema = repeatability_fields().schema();
    d.create = [](const SetupReader& setup, const AssetLibrary& assets,
                  Problems& problems) -> std::unique_ptr<Asset> {
        return std::make_unique<RobotRepeatability>(repeatability_fields().read(setup, assets, problems));
    };
    return d;
}

}  // namespace covaria
