// Telescopic ballbars on kinematic supports that measure their lengths to one ball at once (Brosed et al.).
#include <cmath>

#include "core/base/name.h"
#include "core/kinds/ballbar/assets.h"
#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/points/stated_figure.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

const Unit mm = Unit::of("mm");

struct FurtherSupport {
    double L_1 = 0.0, L_2 = 0.0, L_3 = 0.0;  ///< distances to the first three supports, m
    double z = 0.0, u_z = 0.0;               ///< m
};

struct StatedBallbars {
    double length_12 = 0.0, length_13 = 0.0, length_23 = 0.0;  ///< m
    std::vector<FurtherSupport> further;
    double side = 1.0;
    Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
    double reading_constant = 0.0, reading_scale = 0.0;  ///< m, relative
    double support_constant = 0.0, support_scale = 0.0;
    std::string meaning;  ///< meaning of these four
    double u_scale = 0.0, u_zero = 0.0;
    std::string distribution;  ///< distribution of these two
};

Columns<FurtherSupport> further_columns() {
    const auto length = [](const char* key) {
        return ColumnSpec{.key = key,
                          .title = key,
                          .unit = mm,
                          .range = {.low = 0.0, .low_open = true},
                          .help = "Length to this support."};
    };
    return Columns<FurtherSupport>()
        .add(&FurtherSupport::L_1, length("L_1"))
        .add(&FurtherSupport::L_2, length("L_2"))
        .add(&FurtherSupport::L_3, length("L_3"))
        .add(&FurtherSupport::z, "z", "z", "Height above the first three supports.", {.unit = mm})
        .add(&FurtherSupport::u_z, "u_z", "u_z", "Standard uncertainty of the height.",
             {.unit = mm, .range = {.low = 0.0}});
}

void add_supports(Fields<StatedBallbars>& fields) {
    const auto length = [](const char* key, const char* title, const char* help) {
        return FieldSpec{.key = key,
                         .title = title,
                         .help = help,
                         .unit = mm,
                         .range = {.low = 0.0, .low_open = true},
                         .section = "Supports"};
    };
    fields
        .add(&StatedBallbars::length_12,
             length("length_12", "Support 1 to support 2", "Measured length between supports 1 and 2."))
        .add(&StatedBallbars::length_13,
             length("length_13", "Support 1 to support 3", "Measured length between supports 1 and 3."))
        .add(&StatedBallbars::length_23,
             length("length_23", "Support 2 to support 3", "Measured length between supports 2 and 3."))
        .section("Supports")
        .table(&StatedBallbars::further, "further_supports", "Further supports",
               "Supports 4, 5 ...: their lengths to the first three, and their height above the "
               "plane of these. More than three lengths are adjusted by least squares.",
               further_columns(), {.optional = true})
        .choice(&StatedBallbars::side, "side", "The ball is",
                "Three lengths meet in two points, mirror images in the plane of the supports: on "
                "which side of it the ball is (sign of the root of Eq 3).",
                {{1.0, "positive", "on the side of +z"}, {-1.0, "negative", "on the side of −z"}}, 1.0)
        .section("Placement")
        .add(&StatedBallbars::placement, "placement", "Place in the robot's frame",
             "Where the instrument's frame is in the robot's: origin in support 1, x towards support 2, "
             "z normal to the plane of the first three supports, on the left of the way 1-2-3.",
             {.default_value = PoseValue{}});
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

void add_uncertainties(Fields<StatedBallbars>& fields) {
    const char* const specification = "Uncertainty of a length";
    const char* const shared = "Shared by all lengths";
    fields
        .add(&StatedBallbars::reading_constant,
             figure("reading_constant", "To the ball: constant part a", "mm",
                    "Figure for one reading of a bar to the ball, the part that does not depend on the "
                    "length.",
                    specification))
        .add(&StatedBallbars::reading_scale,
             figure("reading_scale", "To the ball: part b per length", "ppm",
                    "Figure for one reading of a bar to the ball, the part in proportion to the length.",
                    specification))
        .add(&StatedBallbars::support_constant,
             figure("support_constant", "Between supports: constant part a", "mm",
                    "Figure for a length between two supports, which one measurement gives for all points: "
                    "the part that does not depend on the length.",
                    specification))
        .add(&StatedBallbars::support_scale,
             figure("support_scale", "Between supports: part b per length", "ppm",
                    "Figure for a length between two supports, the part in proportion to the length.",
                    specification))
        .add(&StatedBallbars::meaning, meaning_field(specification))
        .add(&StatedBallbars::u_scale,
             figure("u_scale", "Scale of all lengths", "ppm",
                    "Standard uncertainty of the scale that all lengths share: wavelength, refractive index.",
                    shared))
        .add(&StatedBallbars::u_zero,
             figure("u_zero", "Constant of each bar", "mm",
                    "Standard uncertainty of the constant of a bar, the same in all its readings to the "
                    "ball.",
                    shared))
        .add(&StatedBallbars::distribution,
             distribution_field("distribution", "scale and constants", shared));
}

const Fields<StatedBallbars>& ballbar_fields() {
    static const Fields<StatedBallbars> fields = [] {
        Fields<StatedBallbars> made;
        add_supports(made);
        add_uncertainties(made);
        return made;
    }();
    return fields;
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
    explicit BallbarSet(const StatedBallbars& stated)
        : reading_{stated.reading_constant, stated.reading_scale, stated.meaning},
          between_{stated.support_constant, stated.support_scale, stated.meaning},
          placement_(stated.placement),
          side_(stated.side) {
        add_length(0, 1, stated.length_12);
        add_length(0, 2, stated.length_13);
        add_length(1, 2, stated.length_23);
        for (const FurtherSupport& support : stated.further) add_support(support);
        add_shared(stated);
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
                .name = tell<"reading of bar %1">(bar + 1),
                .unit = Unit::of("um"),
                .distribution = reading_.at(length),
                .origin = tell<"ballbars: %1">(meaning_words(reading_.meaning))};
    }

    std::vector<Table> evaluation() const override { return {support_table()}; }

    Layout layout() const override {
        Layout layout;
        const std::vector<Eigen::Vector3d> positions = support_positions(*this);
        LayoutBody plate{.name = own_name<"supports">(), .kind = BodyKind::plate};
        for (std::size_t k = 0; k < positions.size(); ++k) {
            const Eigen::Vector3d p = placement_ * positions[k];
            layout.points.push_back(
                {.name = own_name<"support %1">(k + 1), .kind = PointKind::support, .p_W = p});
            if (k < 3) plate.outline_W.push_back(p);
        }
        layout.bodies.push_back(std::move(plate));
        layout.frames.push_back(
            {.name = own_name<"instrument">(),
             .X_WF = placement_,
             .source = {.path = ballbar_fields().place(&StatedBallbars::placement), .draggable = true}});
        return layout;
    }

private:
    void add_length(std::size_t from, std::size_t to, double length) {
        const std::string pair = support_pair(from, to);
        lengths_.push_back({from,
                            to,
                            length,
                            {.id = "L_" + pair,
                             .name = tell<"length between supports %1">(pair),
                             .unit = Unit::of("um"),
                             .distribution = between_.at(length),
                             .origin = tell<"ballbars: %1">(meaning_words(between_.meaning))}});
    }

    void add_support(const FurtherSupport& support) {
        const std::size_t index = supports();
        add_length(0, index, support.L_1);
        add_length(1, index, support.L_2);
        add_length(2, index, support.L_3);
        const std::string number = std::to_string(index + 1);
        heights_.push_back({support.z,
                            {.id = "z_" + number,
                             .name = tell<"height of support %1">(number),
                             .unit = Unit::of("um"),
                             .distribution = Distribution::normal(support.u_z),
                             .origin = tell<"ballbars: standard uncertainty">()}});
    }

    void add_shared(const StatedBallbars& stated) {
        const double u_scale = stated.u_scale, u_zero = stated.u_zero;
        const auto component = [&](std::string id, Message name, const char* unit, double u) {
            return UncertaintyComponent{.id = std::move(id),
                                        .name = std::move(name),
                                        .unit = Unit::of(unit),
                                        .distribution = distribution_of_shape(stated.distribution, u),
                                        .origin = tell<"ballbars: standard uncertainty">()};
        };
        if (u_scale > 0.0)
            shared_.push_back({component("scale", tell<"scale of all lengths">(), "ppm", u_scale), true, 0});
        for (std::size_t bar = 0; u_zero > 0.0 && bar < supports(); ++bar) {
            const std::string number = std::to_string(bar + 1);
            shared_.push_back(
                {component("zero_" + number, tell<"constant of bar %1">(number), "um", u_zero), false, bar});
        }
    }

    Table support_table() const {
        Table table{"supports", "Supports in the instrument's frame and in the robot's"};
        table.add("support");
        for (const char* const header : {"x", "y", "z", "x_R", "y_R", "z_R"})
            table.add(header).in(mm).symbol().figure(7);
        const std::vector<Eigen::Vector3d> positions = support_positions(*this);
        for (std::size_t k = 0; k < positions.size(); ++k) {
            const Eigen::Vector3d &p = positions[k], p_R = placement_ * p;
            table.row({std::to_string(k + 1), p.x(), p.y(), p.z(), p_R.x(), p_R.y(), p_R.z()});
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
    return format_decimals(1e3 * length, 3) + " mm";
}

void check_triangle(const BallbarSource& ballbars, Problems& problems) {
    const auto& L = ballbars.support_lengths();
    const double a = L[0].length, b = L[1].length, c = L[2].length;
    const double longest = std::max({a, b, c}), others = a + b + c - longest;
    if (longest > others * (1.0 + 1e-9))
        return problems.error(ballbar_fields().place(&StatedBallbars::length_12),
                              tell<"the lengths between the supports make no triangle: the longest of %1, %2 "
                                   "and %3 exceeds the sum of the others">(in_mm(a), in_mm(b), in_mm(c)));
    const double height = std::abs(support_positions(ballbars)[2].y());
    if (!(height > 1e-3 * longest))
        problems.error(ballbar_fields().place(&StatedBallbars::length_12),
                       tell<"the three supports lie on a line (%1, %2 and %3): they leave the place of the "
                            "ball undetermined; move one of them aside">(in_mm(a), in_mm(b), in_mm(c)));
}

void check_further(const BallbarSource& ballbars, Problems& problems) {
    const std::vector<Eigen::Vector3d> positions = support_positions(ballbars);
    for (std::size_t k = 3; k < positions.size(); ++k) {
        double worst = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double length = ballbars.support_lengths()[3 * (k - 2) + i].length;
            worst = std::max(worst, std::abs((positions[k] - positions[i]).norm() - length));
        }
        const std::string path = ballbar_fields().place(&StatedBallbars::further, k - 3);
        if (!positions[k].allFinite() || !(worst < 1e-3))
            problems.error(path, tell<"the lengths of support %1 do not meet at its height: they miss by %2">(
                                     k + 1, in_mm(worst)));
    }
}

std::unique_ptr<Asset> create_ballbars(const SetupReader& setup, const AssetLibrary& assets,
                                       Problems& problems) {
    const StatedBallbars stated = ballbar_fields().read(setup, assets, problems);
    if (stated.further.size() + 3 > most_supports) {
        problems.error(ballbar_fields().place(&StatedBallbars::further),
                       tell<"a set has at most %1 supports">(most_supports));
        return nullptr;
    }
    auto set = std::make_unique<BallbarSet>(stated);
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
    d.schema = ballbar_fields().schema();
    d.create = create_ballbars;
    return d;
}

}  // namespace covaria
