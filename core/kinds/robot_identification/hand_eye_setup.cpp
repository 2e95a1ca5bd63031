// Fields and reading of poses of the flange with what an instrument measured in each.
#include <algorithm>
#include <set>

#include "core/kinds/robot_identification/hand_eye.h"
#include "core/kinds/robot_identification/reading_figures.h"

namespace covaria::hand_eye {

namespace {

using Stated = StatedHandEye;
const Unit mm = Unit::of("mm");
const Unit deg = Unit::of("deg");

template <class Figure>
Columns<StatedPair>& add_axes(Columns<StatedPair>& columns, Figure StatedPair::*member,
                              const std::array<const char*, 3>& keys, const std::string& help,
                              const Unit& unit, bool optional) {
    std::array<ColumnSpec, 3> specs = by_axis(keys, help, {.unit = unit, .optional = optional});
    return columns.each(member, specs);
}

Columns<StatedPair> pair_columns() {
    Columns<StatedPair> columns;
    columns.add(&StatedPair::name, "name", "name", "Name, unique.")
        .choice(&StatedPair::check, "use", "use",
                "fit: taken into the fit. check: held back, to see how well the result tells it. Empty: fit.",
                {{false, "fit", "fit"}, {true, "check", "check"}}, {.optional = true});
    add_axes(columns, &StatedPair::p_BF, {"x", "y", "z"},
             "Coordinate * of the flange in the frame of the robot's base, as the controller says.", mm,
             false);
    add_axes(
        columns, &StatedPair::angles_BF, {"alpha", "beta", "gamma"},
        "Angle of the flange's orientation, R = Rz(gamma) Ry(beta) Rx(alpha): W, P, R of some controllers, "
        "C, B, A of others.",
        deg, false);
    add_axes(columns, &StatedPair::p_measured, {"x_m", "y_m", "z_m"},
             "Coordinate of the target in the frame of the instrument, as measured.", mm, false);
    add_axes(
        columns, &StatedPair::measured_angles, {"alpha_m", "beta_m", "gamma_m"},
        "Angle of the target's orientation in the frame of the instrument, composed likewise; empty in all "
        "rows where points alone are measured.",
        deg, true);
    return columns;
}

class PairReading {
public:
    PairReading(Calibration& c, Problems& problems) : c_(c), problems_(problems) {}

    void read() {
        c_.with_orientation = std::ranges::any_of(
            c_.stated, [](const StatedPair& pair) { return pair.measured_angles[0].has_value(); });
        for (std::size_t row = 0; row < c_.stated.size(); ++row) read_pair(row);
        std::ranges::stable_partition(c_.pairs, [](const Pair& pair) { return !pair.check; });
        c_.fitted_pairs = static_cast<std::size_t>(
            std::ranges::count_if(c_.pairs, [](const Pair& pair) { return !pair.check; }));
        const std::size_t fewest = c_.with_orientation ? 3 : 5;
        if (c_.fitted_pairs < fewest)
            problems_.error(fields().place(&Stated::stated),
                            tell<"the fit has %1 poses; it needs %2 or more">(c_.fitted_pairs, fewest));
        for (std::size_t k = 0; k < c_.pairs.size(); ++k) add_inputs(k);
    }

private:
    void read_pair(std::size_t row) {
        const StatedPair& stated = c_.stated[row];
        Pair pair{.name = stated.name,
                  .source = fields().place(&Stated::stated, row),
                  .check = stated.check,
                  .p_BF = stated.p_BF,
                  .p_measured = stated.p_measured,
                  .R_BF = rotation_from_zyx<double>(stated.angles_BF)};
        if (!names_.insert(pair.name).second)
            problems_.error(pair.source, tell<"two poses are called %1">(pair.name));
        const auto& angles = stated.measured_angles;
        if (c_.with_orientation && angles[0] && angles[1] && angles[2])
            pair.R_measured = rotation_from_zyx<double>({*angles[0], *angles[1], *angles[2]});
        else if (c_.with_orientation || angles[1] || angles[2])
            problems_.error(pair.source,
                            tell<"pose %1: its measured orientation is missing; give alpha_m, beta_m "
                                 "and gamma_m of every pose, or of none">(pair.name));
        c_.pairs.push_back(std::move(pair));
    }

    void add_inputs(std::size_t k) {
        Pair& pair = c_.pairs[k];
        const std::string number = std::to_string(k + 1);
        pair.measured_input =
            add(pair, pair.p_measured, "_m," + number, own_name<"measured poses">(), c_.with_orientation,
                c_.u_position, c_.u_angle, {"measured", tell<"measured pose">()});
        if (c_.u_robot_position > 0.0 || c_.u_robot_angle > 0.0)
            pair.robot_input =
                add(pair, pair.p_BF, "_F," + number, own_name<"poses of the flange">(), true,
                    c_.u_robot_position, c_.u_robot_angle, {"flange", tell<"pose of the flange">()});
    }

    struct Words {
        std::string id;
        Message name;
    };

    std::size_t add(const Pair& pair, const Eigen::Vector3d& p, const std::string& suffix, const Name& kind,
                    bool turns, double u_position, double u_angle, const Words& words) {
        static const char* const symbols[] = {"x", "y", "z", "alpha", "beta", "gamma"};
        static const char* const axes[] = {"x", "y", "z"};
        const std::size_t first = c_.inputs.quantities.size();
        for (std::size_t i = 0; i < (turns ? 6u : 3u); ++i) {
            const bool turn = i >= 3;
            const std::string symbol = symbols[i] + suffix;
            InputQuantity quantity{
                .symbol = symbol,
                .name = turn ? tell<"pose %1, %2, rotation about %3">(pair.name, words.name, axes[i - 3])
                             : tell<"pose %1, %2, %3">(pair.name, words.name, axes[i]),
                .unit = turn ? deg : mm,
                .offset = turn ? 0.0 : p[static_cast<Eigen::Index>(i)],
                .group = "pose " + pair.name,
                .source = pair.source};
            quantity.tags = {{"kind", kind}};
            c_.inputs.add(std::move(quantity),
                          {{.id = symbol + "." + words.id + (turn ? ".angle" : ""),
                            .name = words.name,
                            .unit = turn ? deg : mm,
                            .distribution = Distribution::normal(turn ? u_angle : u_position),
                            .origin = tell<"typed standard uncertainty">()}});
        }
        return first;
    }

    Calibration& c_;
    Problems& problems_;
    std::set<std::string> names_;
};

}  // namespace

const Fields<StatedHandEye>& fields() {
    static const auto fields = [] {
        const auto u = [](const Unit& unit, double value) {
            return Further{.unit = unit, .range = {.low = 0.0}, .default_value = Quantity{value, unit}};
        };
        Fields<Stated> made;
        made.section("Poses")
            .choice(
                &Stated::mount, "mount", "The flange carries",
                "The instrument (a camera on the hand), which measures a target that stands still. Or the "
                "target, which an instrument that stands still measures.",
                {{Mount::instrument, "instrument", "the instrument"},
                 {Mount::target, "target", "the target"}},
                Mount::instrument)
            .table(&Stated::stated, "poses", "Poses",
                   "Poses of the flange, and where the instrument saw the target in each.", pair_columns(),
                   {.min_rows = 1, .measured = true})
            .section("Uncertainty")
            .add(&Stated::u_position, "u_position", "Measured positions",
                 "Standard uncertainty of each measured coordinate, independent.", u(mm, 0.1))
            .add(&Stated::u_angle, "u_angle", "Measured orientations",
                 "Standard uncertainty of the measured rotation about each axis of the target, independent.",
                 u(deg, 0.05))
            .add(&Stated::u_robot_position, "u_robot_position", "Positions of the flange",
                 "Standard uncertainty of each coordinate of the flange, independent in each pose: "
                 "repeatability, "
                 "errors of the arm.",
                 u(mm, 0.0))
            .add(&Stated::u_robot_angle, "u_robot_angle", "Orientations of the flange",
                 "Standard uncertainty of the rotation about each axis of the flange, independent in each "
                 "pose.",
                 u(deg, 0.0))
            .choice(
                &Stated::uncertainties, uncertainties_key, "Uncertainties of the readings",
                "As stated; or as the residuals of this fit see them: stated ones times one common factor, "
                "or times the factor of each figure (variance components). Either has the degrees of "
                "freedom of its estimate. What all readings share stays as stated.",
                choices_of_uncertainties(), evidence::UncertaintiesFrom::stated);
        return made;
    }();
    return fields;
}

std::optional<Calibration> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    StatedHandEye stated = fields().read(setup, assets, problems);
    if (problems.has_errors()) return {};
    Calibration c(std::move(stated));
    PairReading(c, problems).read();
    if (problems.has_errors()) return {};
    const bool seen = c.uncertainties != evidence::UncertaintiesFrom::stated;
    const ComponentEvidence evidence = seen ? evidence_as_stated(c) : ComponentEvidence();
    if (seen)
        take_as_seen(c.inputs, evidence, c.uncertainties, fields().place(&Stated::uncertainties), problems);
    if (!fit(c, problems)) return {};
    if (seen) c.statistics.evidence = evidence;
    return c;
}

}  // namespace covaria::hand_eye
