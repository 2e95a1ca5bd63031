// Repeatability of a robot: laws of the positioning deviation, and of the orientation.
#include <cmath>
#include <numbers>

#include "core/kinds/ballbar/assets.h"
#include "core/kinds/ballbar/repeatability.h"
#include "core/quantity/input_quantity.h"
#include "core/quantity/isotropic_vector.h"

namespace covaria {

namespace {

// Length of three independent normal coordinates of standard deviation 1 (Maxwell distribution): mean and
// standard deviation.
const double maxwell_mean = std::sqrt(8.0 / std::numbers::pi);
const double maxwell_deviation = std::sqrt(3.0 - 8.0 / std::numbers::pi);

constexpr std::array<const char*, 3> axes{"x", "y", "z"};

std::vector<Choice> laws() {
    return {{"uniform-radius", "rectangular in [0, r] in a random direction"},
            {"ball", "anywhere in a ball of radius r"},
            {"sphere", "always r, in a random direction"},
            {"normal", "normal along each axis"}};
}

SetupSchema repeatability_schema() {
    const char* const position = "Positioning";
    return SetupSchema(
        {{.key = "repeatability",
          .title = "Repeatability",
          .help = "The robot's figure for the scatter of a position that it is sent to again and again.",
          .unit = Unit::of("mm"),
          .range = {.low = 0.0},
          .section = position},
         {.key = "figure",
          .title = "The figure is",
          .kind = FieldKind::choice,
          .help = "A largest distance from the mean position, or RP of ISO 9283: the mean distance plus "
                  "three times its standard deviation. A normal law has no largest distance, so its figure "
                  "is always RP.",
          .default_value = std::string("largest"),
          .choices = {{"largest", "the largest distance r"}, {"iso-9283", "RP of ISO 9283: mean + 3 s"}},
          .shown_if = Condition{"law", {"uniform-radius", "ball", "sphere"}},
          .section = position},
         {.key = "law",
          .title = "Deviation of a position",
          .kind = FieldKind::choice,
          .help = "How the distance from the mean position is distributed; all directions are equally "
                  "probable.",
          .default_value = std::string("uniform-radius"),
          .choices = laws(),
          .section = position},
         {.key = "orientation_repeatability",
          .title = "Orientation",
          .help = "Figure for the scatter of the orientation about each axis of the flange; 0: none.",
          .unit = Unit::of("deg"),
          .range = {.low = 0.0},
          .default_value = Quantity{0.0, Unit::of("deg")},
          .section = "Orientation"},
         {.key = "orientation_figure",
          .title = "The angle is",
          .kind = FieldKind::choice,
          .help = "A standard uncertainty, RP of ISO 9283 for an angle (three times its standard "
                  "deviation), or a limit that is not exceeded.",
          .default_value = std::string("iso-9283"),
          .choices = {{"standard", "standard uncertainty (normal)"},
                      {"iso-9283", "RP of ISO 9283: ± 3 s (normal)"},
                      {"limit", "limit, rectangular: divided by √3"}},
          .section = "Orientation"}});
}

/// The distribution of one coordinate of the position's deviation.
Distribution position_distribution(const std::string& law, const std::string& figure, double value) {
    if (value == 0.0) return Distribution::normal(0.0);
    if (law == "normal") return Distribution::normal(value / (maxwell_mean + 3.0 * maxwell_deviation));
    VectorLength length{law == "ball"     ? RadialLaw::ball
                        : law == "sphere" ? RadialLaw::sphere
                                          : RadialLaw::uniform_length,
                        1.0};
    const double rp_of_one = length.mean() + 3.0 * length.standard_deviation();
    length.largest = figure == "iso-9283" ? value / rp_of_one : value;
    return coordinate_distribution(length);
}

Distribution orientation_distribution(const std::string& figure, double value) {
    if (figure == "limit") return Distribution::of(Rectangular{-value, value});
    return Distribution::normal(figure == "iso-9283" ? value / 3.0 : value);
}

class RobotRepeatability : public Asset, public RepeatabilitySource {
public:
    explicit RobotRepeatability(const SetupReader& setup) : law_(setup.text("law")) {
        const double figure = setup.number("repeatability");
        const Distribution along =
            position_distribution(law_, law_ == "normal" ? "iso-9283" : setup.text("figure"), figure);
        for (std::size_t i = 0; i < 3; ++i)
            position_[i] = {.id = axes[i],
                            .name = std::string("repeatability along ") + axes[i],
                            .unit = Unit::of("um"),
                            .distribution = along,
                            .origin = "repeatability: " + law_title()};
        const double angle = setup.number("orientation_repeatability");
        if (angle > 0.0) add_orientation(orientation_distribution(setup.text("orientation_figure"), angle));
        offer(*this);
    }

    std::array<UncertaintyComponent, 3> position() const override { return position_; }
    std::optional<std::array<UncertaintyComponent, 3>> orientation() const override { return orientation_; }

    std::vector<DataTable> evaluation() const override {
        DataTable table;
        table.id = "repeatability";
        table.title = "Scatter of a pose that the robot is sent to again";
        table.columns = {{.header = "deviation"},
                         {.header = "distribution"},
                         {.header = "u", .unit = Unit::of("um"), .is_symbol = true, .digits = 4}};
        const Distribution& along = position_[0].distribution;
        table.rows.push_back({"along any axis", std::string(along.title()), along.standard_uncertainty()});
        const auto length = length_law_of(along);
        if (length) {
            table.rows.push_back({"distance: largest", law_title(), length->largest});
            table.rows.push_back({"distance: RP = mean + 3 s", law_title(),
                                  length->mean() + 3.0 * length->standard_deviation()});
        } else {
            const double u = along.standard_uncertainty();
            table.rows.push_back(
                {"distance: RP = mean + 3 s", law_title(), (maxwell_mean + 3.0 * maxwell_deviation) * u});
        }
        table.notes.push_back(
            "The coordinates are uncorrelated; unless they are normal, they are not "
            "independent: the distance has the law above, its direction is random.");
        return {table};
    }

private:
    std::string law_title() const {
        for (const Choice& choice : laws())
            if (choice.key == law_) return choice.title;
        return law_;
    }

    void add_orientation(const Distribution& about) {
        orientation_.emplace();
        for (std::size_t i = 0; i < 3; ++i)
            (*orientation_)[i] = {.id = std::string("rotation.") + axes[i],
                                  .name = std::string("repeatability about ") + axes[i],
                                  .unit = Unit::of("urad"),
                                  .distribution = about,
                                  .origin = "repeatability of the orientation"};
    }

    std::string law_;
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
    d.schema = repeatability_schema();
    d.create = [](const SetupReader& setup, const AssetLibrary&, Problems&) -> std::unique_ptr<Asset> {
        return std::make_unique<RobotRepeatability>(setup);
    };
    return d;
}

}  // namespace covaria
