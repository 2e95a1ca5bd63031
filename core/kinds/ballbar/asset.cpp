// Telescopic ballbars on kinematic supports that measure their lengths to one ball at once (Brosed et al.).
#include <cmath>
#include <cstdio>

#include "core/kinds/ballbar/assets.h"
#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/points/stated_figure.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

const Unit mm = Unit::of("mm");

FieldSpec length_field(const char* key, const char* title, const char* help) {
    return {.key = key,
            .title = title,
            .help = help,
            .unit = mm,
            .range = {.low = 0.0, .low_open = true},
            .section = "Supports"};
}

FieldSpec further_supports_table() {
    FieldSpec table{.key = "further_supports",
                    .title = "Further supports",
                    .kind = FieldKind::table,
                    .help =
                        "Supports 4, 5 ...: their lengths to the first three, and their height above the "
                        "plane of these. More than three lengths are adjusted by least squares.",
                    .optional = true,
                    .section = "Supports"};
    const auto length = [](const char* key, const char* title) {
        return ColumnSpec{.key = key,
                          .title = title,
                          .unit = mm,
                          .range = {.low = 0.0, .low_open = true},
                          .help = "Length to this support."};
    };
    table.columns = {length("L_1", "L_1"),
                     length("L_2", "L_2"),
                     length("L_3", "L_3"),
                     {.key = "z", .title = "z", .unit = mm, .help = "Height above the first three supports."},
                     {.key = "u_z",
                      .title = "u_z",
                      .unit = mm,
                      .range = {.low = 0.0},
                      .help = "Standard uncertainty of the height."}};
    return table;
}

FieldSpec figure(const char* key, const char* title, const char* unit, const char* help,
                 const char* section) {
    const Unit u = Unit::of(unit);
    return {.key = key,
            .title = title,
            .help = help,
            .unit = u,
            .range = {.low = 0.0},
            .default_value = Quantity{0.0, u},
            .section = section};
}

SetupSchema ballbar_schema() {
    const char* const specification = "Uncertainty of a length";
    const char* const shared = "Shared by all lengths";
    return SetupSchema(
        {length_field("length_12", "Support 1 to support 2", "Measured length between supports 1 and 2."),
         length_field("length_13", "Support 1 to support 3", "Measured length between supports 1 and 3."),
         length_field("length_23", "Support 2 to support 3", "Measured length between supports 2 and 3."),
         further_supports_table(),
         {.key = "side",
          .title = "The ball is",
          .kind = FieldKind::choice,
          .help = "Three lengths meet in two points, mirror images in the plane of the supports: on which "
                  "side of it the ball is (sign of the root of Eq 3).",
          .default_value = std::string("positive"),
          .choices = {{"positive", "on the side of +z"}, {"negative", "on the side of −z"}},
          .section = "Supports"},
         {.key = "placement",
          .title = "Place in the robot's frame",
          .kind = FieldKind::pose,
          .help = "Where the instrument's frame is in the robot's: origin in support 1, x towards support 2, "
                  "z normal to the plane of the first three supports, on the left of the way 1-2-3.",
          .default_value = PoseValue{},
          .section = "Placement"},
         figure("reading_constant", "To the ball: constant part a", "mm",
                "Figure for one reading of a bar to the ball, the part that does not depend on the length.",
                specification),
         figure("reading_scale", "To the ball: part b per length", "ppm",
                "Figure for one reading of a bar to the ball, the part in proportion to the length.",
                specification),
         figure("support_constant", "Between supports: constant part a", "mm",
                "Figure for a length between two supports, which one measurement gives for all points: the "
                "part that does not depend on the length.",
                specification),
         figure("support_scale", "Between supports: part b per length", "ppm",
                "Figure for a length between two supports, the part in proportion to the length.",
                specification),
         meaning_field(specification),
         figure("u_scale", "Scale of all lengths", "ppm",
                "Standard uncertainty of the scale that all lengths share: wavelength, refractive index.",
                shared),
         figure("u_zero", "Constant of each bar", "mm",
                "Standard uncertainty of the constant of a bar, the same in all its readings to the ball.",
                shared),
         distribution_field("distribution", "scale and constants", shared)});
}

/// a + b L with its meaning.
struct LengthFigure {
    double constant = 0.0, scale = 0.0;
    std::string meaning;
    Distribution at(double length) const {
        return specified_distribution(meaning, constant + scale * length);
    }
};

std::string support_pair(std::size_t from, std::size_t to) {
    return std::to_string(from + 1) + "-" + std::to_string(to + 1);
}

class BallbarSet : public Asset, public BallbarSource {
public:
    explicit BallbarSet(const SetupReader& setup)
        : reading_{setup.number("reading_constant"), setup.number("reading_scale"), setup.text("meaning")},
          between_{setup.number("support_constant"), setup.number("support_scale"), setup.text("meaning")},
          placement_(setup.pose("placement")),
          side_(setup.text("side") == "negative" ? -1.0 : 1.0) {
        add_length(0, 1, setup.number("length_12"));
        add_length(0, 2, setup.number("length_13"));
        add_length(1, 2, setup.number("length_23"));
        for (std::size_t row = 0; row < setup.rows("further_supports"); ++row) add_support(setup, row);
        add_shared(setup);
        offer(*this);
    }

    std::size_t supports() const override { return 3 + heights_.size(); }
    const std::vector<SupportLength>& support_lengths() const override { return lengths_; }
    const std::vector<SupportHeight>& heights() const override { return heights_; }
    double side() const override { return side_; }
    const Eigen::Isometry3d& placement() const override { return placement_; }
    const std::vector<SharedLengthDeviation>& shared() const override { return shared_; }
    UncertaintyComponent reading(std::size_t bar, double length) const override {
        return {.id = "L_" + std::to_string(bar + 1),
                .name = "reading of bar " + std::to_string(bar + 1),
                .unit = Unit::of("um"),
                .distribution = reading_.at(length),
                .origin = "ballbars: " + meaning_words(reading_.meaning)};
    }

    std::vector<DataTable> evaluation() const override { return {support_table()}; }

    Layout layout() const override {
        Layout layout;
        const std::vector<Eigen::Vector3d> positions = support_positions(*this);
        LayoutBody plate{.name = "supports", .kind = BodyKind::plate};
        for (std::size_t k = 0; k < positions.size(); ++k) {
            const Eigen::Vector3d p = placement_ * positions[k];
            layout.points.push_back(
                {.name = "support " + std::to_string(k + 1), .kind = PointKind::support, .p_W = p});
            if (k < 3) plate.outline_W.push_back(p);
        }
        layout.bodies.push_back(std::move(plate));
        layout.frames.push_back(
            {.name = "instrument", .X_WF = placement_, .source = {.path = "/placement", .draggable = true}});
        return layout;
    }

private:
    void add_length(std::size_t from, std::size_t to, double length) {
        const std::string pair = support_pair(from, to);
        lengths_.push_back({from,
                            to,
                            length,
                            {.id = "L_" + pair,
                             .name = "length between supports " + pair,
                             .unit = Unit::of("um"),
                             .distribution = between_.at(length),
                             .origin = "ballbars: " + meaning_words(between_.meaning)}});
    }

    void add_support(const SetupReader& setup, std::size_t row) {
        static const char* const columns[] = {"L_1", "L_2", "L_3"};
        for (std::size_t i = 0; i < 3; ++i)
            add_length(i, 3 + row, setup.cell_number("further_supports", row, columns[i]));
        const std::string number = std::to_string(4 + row);
        heights_.push_back(
            {setup.cell_number("further_supports", row, "z"),
             {.id = "z_" + number,
              .name = "height of support " + number,
              .unit = Unit::of("um"),
              .distribution = Distribution::normal(setup.cell_number("further_supports", row, "u_z")),
              .origin = "ballbars: standard uncertainty"}});
    }

    void add_shared(const SetupReader& setup) {
        const double u_scale = setup.number("u_scale"), u_zero = setup.number("u_zero");
        const auto component = [&](std::string id, std::string name, const char* unit, double u) {
            return UncertaintyComponent{.id = std::move(id),
                                        .name = std::move(name),
                                        .unit = Unit::of(unit),
                                        .distribution = distribution_of_shape(setup.text("distribution"), u),
                                        .origin = "ballbars: standard uncertainty"};
        };
        if (u_scale > 0.0)
            shared_.push_back({component("scale", "scale of all lengths", "ppm", u_scale), true, 0});
        for (std::size_t bar = 0; u_zero > 0.0 && bar < supports(); ++bar) {
            const std::string number = std::to_string(bar + 1);
            shared_.push_back(
                {component("zero_" + number, "constant of bar " + number, "um", u_zero), false, bar});
        }
    }

    DataTable support_table() const {
        DataTable table;
        table.id = "supports";
        table.title = "Supports in the instrument's frame and in the robot's";
        table.columns = {{.header = "support"}};
        for (const char* const header : {"x", "y", "z", "x_R", "y_R", "z_R"})
            table.columns.push_back({.header = header, .unit = mm, .is_symbol = true, .digits = 7});
        const std::vector<Eigen::Vector3d> positions = support_positions(*this);
        for (std::size_t k = 0; k < positions.size(); ++k) {
            const Eigen::Vector3d &p = positions[k], p_R = placement_ * p;
            table.rows.push_back({std::to_string(k + 1), p.x(), p.y(), p.z(), p_R.x(), p_R.y(), p_R.z()});
        }
        return table;
    }

    LengthFigure reading_, between_;
    Eigen::Isometry3d placement_;
    double side_;
    std::vector<SupportLength> lengths_;
    std::vector<SupportHeight> heights_;
    std::vector<SharedLengthDeviation> shared_;
};

std::string in_mm(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f mm", 1e3 * length);
    return text;
}

void check_triangle(const BallbarSource& ballbars, Problems& problems) {
    const auto& L = ballbars.support_lengths();
    const double a = L[0].length, b = L[1].length, c = L[2].length;
    const double longest = std::max({a, b, c}), others = a + b + c - longest;
    const std::string lengths = in_mm(a) + ", " + in_mm(b) + " and " + in_mm(c);
    if (longest > others * (1.0 + 1e-9))
        return problems.error("/length_12",
                              "the lengths between the supports make no triangle: the longest of " + lengths +
                                  " exceeds the sum of the others");
    const double height = std::abs(support_positions(ballbars)[2].y());
    if (!(height > 1e-3 * longest))
        problems.error("/length_12",
                       "the three supports lie on a line (" + lengths +
                           "): they leave the place of the ball undetermined; move one of them aside");
}

void check_further(const BallbarSource& ballbars, Problems& problems) {
    const std::vector<Eigen::Vector3d> positions = support_positions(ballbars);
    for (std::size_t k = 3; k < positions.size(); ++k) {
        double worst = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double length = ballbars.support_lengths()[3 * (k - 2) + i].length;
            worst = std::max(worst, std::abs((positions[k] - positions[i]).norm() - length));
        }
        const std::string path = "/further_supports/rows/" + std::to_string(k - 3);
        if (!positions[k].allFinite() || !(worst < 1e-3))
            problems.error(path, "the lengths of support " + std::to_string(k + 1) +
                                     " do not meet at its height: they miss by " + in_mm(worst));
    }
}

std::unique_ptr<Asset> create_ballbars(const SetupReader& setup, const AssetLibrary&, Problems& problems) {
    if (setup.rows("further_supports") + 3 > most_supports) {
        problems.error("/further_supports",
                       "a set has at most " + std::to_string(most_supports) + " supports");
        return nullptr;
    }
    auto set = std::make_unique<BallbarSet>(setup);
    check_triangle(*set, problems);
    if (!problems.has_errors()) check_further(*set, problems);
    if (problems.has_errors()) return nullptr;
    return set;
}

}  // namespace

AssetDescriptor ballbar_set_kind() {
    AssetDescriptor d;
    d.kind = "ballbar-set";
    d.title = "Telescopic ballbars (multilateration)";
    d.category = AssetCategory::instrument;
    d.summary =
        "Three or more telescopic ballbars that measure the lengths from their supports to one ball at once, "
        "and with it where the ball is.";
    d.references = {
        {"F. J. Brosed et al.: Evaluation of the measurement uncertainty of a high-precision "
         "telescopic instrument measuring the tool centre point of a robot (euspen 2025), 2.1"}};
    d.notes = {
        "The supports' frame follows from the lengths between them (Eqs 4 to 7), measured once: their "
        "deviations are common to all points.",
        "Eq 2 as printed has Y_VC3; Y_KS3 is meant. Eq 3 has two roots; the side is a choice here.",
        "The paper's supports are called an equilateral triangle of 520 mm; its Table 1 is isosceles, 520 mm "
        "and 519.711 mm.",
        "A fourth support and those after it are located by their lengths to the first three at a height "
        "that is "
        "an input of its own: lengths say nothing about a height above the plane in which all supports lie."};
    d.capabilities = {BallbarSource::capability};
    d.schema = ballbar_schema();
    d.create = create_ballbars;
    return d;
}

}  // namespace covaria
