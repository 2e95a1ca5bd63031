// The fields of "accuracy and repeatability of poses", and the series of cycles that follow from them.
#include "core/kinds/sheets/robot_poses_setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/text/numbers.h"

namespace covaria::sheets {

namespace {

using StatedPoses = RobotPosesSetup;
const Unit pose_mm = Unit::of("mm"), pose_deg = Unit::of("deg"), pose_hour = Unit::of("h");
constexpr AxisKeys pose_angle_keys{"a", "b", "c"};

Columns<CommandedPose> commanded_columns() {
    return Columns<CommandedPose>()
        .add(&CommandedPose::pose, "pose", "pose", "Name, unique: P1.")
        .each(&CommandedPose::p,
              by_axis(along_axes, "Commanded coordinate * in the base of the robot.", {.unit = pose_mm}))
        .each(&CommandedPose::angles, by_axis(pose_angle_keys,
                                              "Commanded angle of the orientation; empty: orientations are "
                                              "not evaluated.",
                                              {.unit = pose_deg, .optional = true}));
}

Columns<AttainedPose> attained_columns() {
    return Columns<AttainedPose>()
        .add(&AttainedPose::pose, "pose", "pose", "As in the commanded poses.")
        .add(&AttainedPose::direction, "direction", "direction",
             "From where the pose was approached, where there are several ways; empty: one for all.",
             {.optional = true})
        .add(&AttainedPose::time, "time", "time",
             "Of the series of cycles, where it is repeated to see a drift; empty: there is one series.",
             {.unit = pose_hour, .optional = true})
        .each(&AttainedPose::p, by_axis(along_axes, "Attained coordinate * in the base of the robot.",
                                        {.unit = pose_mm, .observed = true}))
        .each(&AttainedPose::angles, by_axis(pose_angle_keys, "Attained angle of the orientation.",
                                             {.unit = pose_deg, .optional = true}));
}

void add_poses(Fields<StatedPoses>& fields) {
    fields.section("Poses")
        .table(&StatedPoses::commanded, "commanded", "Commanded poses", "Where the robot was sent to.",
               commanded_columns(), {.min_rows = 1})
        .table(&StatedPoses::attained, "attained", "Attained poses",
               "A row for every cycle in the order of measurement, typed, pasted or from a CSV file. The "
               "coordinates are those of the robot's base.",
               attained_columns(), {.min_rows = 3, .measured = true})
        .table(&StatedPoses::pairs, "distances", "Distances",
               "Pairs of poses whose distance is held against the commanded one, cycle by cycle.",
               Columns<PosePair>()
                   .add(&PosePair::from, "from", "from", "A commanded pose.")
                   .add(&PosePair::to, "to", "to", "Another one, with as many cycles."),
               {.optional = true});
}

void add_instrument(Fields<StatedPoses>& fields) {
    fields.section("Instrument")
        .add(
            &StatedPoses::u_place, "u_place", "u of a measured coordinate",
            "Standard uncertainty that all cycles of a pose share: of the instrument and of the robot's base "
            "in its frame. It is part of u(AP), not of RP.",
            {.unit = pose_mm, .range = {.low = 0.0}, .default_value = Quantity{0.0, pose_mm}})
        .choice(
            &StatedPoses::instrument, "instrument", "Scatter of the instrument",
            "What the instrument scatters by itself is part of RP. Where it is known, RP² less its RP² is "
            "that of the robot, if both scatter alike in all directions.",
            {{InstrumentScatter::none, "none", "not taken out"},
             {InstrumentScatter::stated, "stated", "its RP from a fixed target"},
             {InstrumentScatter::readings, "readings", "readings of a fixed target"}},
            InstrumentScatter::none)
        .add(&StatedPoses::instrument_rp, "instrument_rp", "RP of the instrument alone",
             "l̄ + 3 s of readings of a fixed target, as measured in the cell.",
             {.unit = pose_mm, .range = {.low = 0.0, .low_open = true}})
        .add(&StatedPoses::instrument_cycles, "instrument_cycles", "Its readings",
             "Number of readings that it is taken from: so well is it known.",
             {.range = {.low = 3.0, .high = 1e4}, .default_value = Quantity{30.0, Unit{}}})
        .table(&StatedPoses::fixed_target, "fixed_target", "Readings of a fixed target",
               "Coordinates of a target that does not move, read as the poses were.",
               Columns<FixedTarget>().each(&FixedTarget::p, by_axis(along_axes, "Read coordinate *.",
                                                                    {.unit = pose_mm, .observed = true})),
               {.min_rows = 3, .measured = true})
        .shown_where(&StatedPoses::instrument, {InstrumentScatter::stated}, &StatedPoses::instrument_rp,
                     &StatedPoses::instrument_cycles)
        .shown_where(&StatedPoses::instrument, {InstrumentScatter::readings}, &StatedPoses::fixed_target);
}

void add_decisions(Fields<StatedPoses>& fields) {
    fields.section("Decisions")
        .add(&StatedPoses::rated_ap, "rated_ap", "Rated AP", "The maker's figure; empty: nothing is decided.",
             {.unit = pose_mm, .range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&StatedPoses::rated_rp, "rated_rp", "Rated RP", "The maker's figure; empty: nothing is decided.",
             {.unit = pose_mm, .range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&StatedPoses::probability, "probability", "Probability of a decision",
             "A robot conforms where this is the probability that its figure is not above the rated one.",
             {.range = {.low = 0.5, .high = 0.9999}, .default_value = Quantity{0.95, Unit{}}})
        .add(&StatedPoses::expanded_u, "expanded_u", "U of the instrument",
             "Expanded uncertainty of the measured position, k = 2; empty: it is not held against AP and RP.",
             {.unit = pose_mm, .range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&StatedPoses::largest_ratio, "largest_ratio", "Largest ratio of U to AP, RP",
             "What the standard or the contract allows, as it says it.",
             {.unit = Unit::of("%"), .range = {.low = 0.0, .high = 1.0, .low_open = true}, .optional = true});
}

/// Cycles in their order, by pose, direction and time.
class SeriesOfCycles {
public:
    SeriesOfCycles(StatedPoses& setup, Problems& problems) : setup_(setup), problems_(problems) {}

    void collect() {
        for (std::size_t row = 0; row < setup_.attained.size(); ++row) take(row);
        if (problems_.has_errors()) return;
        std::set<std::string> labels;
        for (std::size_t k = 0; k < setup_.series.size(); ++k) {
            fill(k);
            if (!labels.insert(label_of(setup_.series[k])).second)
                problems_.error(robot_poses_fields().place(&StatedPoses::attained, rows_[k].front()),
                                tell<"two series are called '%1'">(label_of(setup_.series[k])));
        }
    }

private:
    const CommandedPose* commanded(const std::string& pose) const {
        const auto found = std::ranges::find(setup_.commanded, pose, &CommandedPose::pose);
        return found == setup_.commanded.end() ? nullptr : &*found;
    }

    void take(std::size_t row) {
        const AttainedPose& a = setup_.attained[row];
        if (!commanded(a.pose))
            return problems_.error(
                robot_poses_fields().place(&StatedPoses::attained, row, &AttainedPose::pose),
                tell<"there is no commanded pose '%1'">(a.pose));
        const auto same = [&](const PoseSeries& s) {
            return s.pose == a.pose && s.direction == a.direction && s.time == a.time;
        };
        auto found = std::ranges::find_if(setup_.series, same);
        if (found == setup_.series.end()) {
            setup_.series.push_back({a.pose, a.direction, a.time, {}, {}, commanded(a.pose)->p});
            rows_.emplace_back();
            found = setup_.series.end() - 1;
        }
        rows_[std::size_t(found - setup_.series.begin())].push_back(row);
    }

    void fill(std::size_t k) {
        PoseSeries& series = setup_.series[k];
        const std::vector<std::size_t>& rows = rows_[k];
        const std::string place = robot_poses_fields().place(&StatedPoses::attained, rows.front());
        if (rows.size() < 3)
            return problems_.error(place, tell<"%1 has fewer than three cycles">(label_of(series)));
        const OptionalAngles& nominal = commanded(series.pose)->angles;
        const bool turns = std::ranges::all_of(nominal, [](const auto& a) { return a.has_value(); });
        series.points.resize(Eigen::Index(rows.size()), 3);
        series.angles.resize(turns ? Eigen::Index(rows.size()) : 0, 3);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const AttainedPose& a = setup_.attained[rows[i]];
            series.points.row(Eigen::Index(i)) = a.p.transpose();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (!turns && a.angles[axis])
                    return problems_.error(
                        robot_poses_fields().place(&StatedPoses::attained, rows[i]),
                        tell<"row %1 has angles, though its pose is commanded without them">(rows[i] + 1));
                if (!turns) continue;
                if (!a.angles[axis])
                    return problems_.error(
                        robot_poses_fields().place(&StatedPoses::attained, rows[i]),
                        tell<"row %1 has no angles, though its pose is commanded with them">(rows[i] + 1));
                series.angles(Eigen::Index(i), Eigen::Index(axis)) =
                    std::remainder(*a.angles[axis] - *nominal[axis], 2.0 * std::numbers::pi);
            }
        }
        check_size(series, place);
    }

    /// Squares of the deviations must be numbers.
    void check_size(const PoseSeries& series, const std::string& place) const {
        const Eigen::RowVector3d mean = series.points.colwise().mean();
        if (!std::isfinite((series.points.rowwise() - mean).squaredNorm() + series.commanded.squaredNorm()))
            problems_.error(place, tell<"the coordinates at %1 are too large">(label_of(series)));
    }

    StatedPoses& setup_;
    Problems& problems_;
    std::vector<std::vector<std::size_t>> rows_;  ///< rows of each series
};

void check_commanded(const StatedPoses& setup, Problems& problems) {
    std::size_t turned = 0;
    for (std::size_t row = 0; row < setup.commanded.size(); ++row) {
        const CommandedPose& c = setup.commanded[row];
        if (std::ranges::count(setup.commanded, c.pose, &CommandedPose::pose) > 1)
            problems.error(robot_poses_fields().place(&StatedPoses::commanded, row, &CommandedPose::pose),
                           tell<"pose '%1' is commanded twice">(c.pose));
        const auto given = std::ranges::count_if(c.angles, [](const auto& a) { return a.has_value(); });
        turned += given == 3 ? 1u : 0u;
        if (given == 1 || given == 2)
            problems.error(robot_poses_fields().place(&StatedPoses::commanded, row),
                           tell<"pose '%1' is commanded with some angles and without others">(c.pose));
    }
    if (turned != 0 && turned != setup.commanded.size())
        problems.error(robot_poses_fields().place(&StatedPoses::commanded),
                       tell<"some poses are commanded with all angles and others are not">());
}

const PoseSeries* series_of(const StatedPoses& setup, const std::string& pose) {
    const auto found = std::ranges::find(setup.series, pose, &PoseSeries::pose);
    return found == setup.series.end() ? nullptr : &*found;
}

void check_pairs(const StatedPoses& setup, Problems& problems) {
    for (std::size_t row = 0; row < setup.pairs.size(); ++row) {
        const PosePair& pair = setup.pairs[row];
        const PoseSeries *from = series_of(setup, pair.from), *to = series_of(setup, pair.to);
        const std::string place = robot_poses_fields().place(&StatedPoses::pairs, row);
        if (!from || !to)
            problems.error(place, tell<"no cycles were measured at pose '%1'">(from ? pair.to : pair.from));
        else if (from == to)
            problems.error(place, tell<"a distance from pose '%1' to itself">(pair.from));
        else if (std::ranges::count_if(setup.pairs, [&](const PosePair& other) {
                     return other.from == pair.from && other.to == pair.to;
                 }) > 1)
            problems.error(place, tell<"the distance from '%1' to '%2' is there twice">(pair.from, pair.to));
        else if (from->cycles() != to->cycles())
            problems.error(place,
                           tell<"poses '%1' and '%2' have different numbers of cycles">(pair.from, pair.to));
    }
}

void check_target(const StatedPoses& setup, Problems& problems) {
    for (std::size_t row = 0; row < setup.fixed_target.size(); ++row)
        if (!std::isfinite(double(setup.fixed_target.size()) * setup.fixed_target[row].p.squaredNorm()))
            problems.error(robot_poses_fields().place(&StatedPoses::fixed_target, row),
                           tell<"the coordinates of the fixed target in row %1 are too large">(row + 1));
}

void check_rule(const StatedPoses& setup, Problems& problems) {
    if (setup.expanded_u.has_value() == setup.largest_ratio.has_value()) return;
    problems.error(setup.expanded_u ? robot_poses_fields().place(&StatedPoses::largest_ratio)
                                    : robot_poses_fields().place(&StatedPoses::expanded_u),
                   tell<"U of the instrument and the largest ratio go together: enter both, or neither">());
}

}  // namespace

std::string label_of(const PoseSeries& series) {
    std::string label = series.pose;
    if (!series.direction.empty()) label += ", " + series.direction;
    if (series.time) label += ", " + format_short(pose_hour.from_si(*series.time), 6) + " h";
    return label;
}

const Fields<RobotPosesSetup>& robot_poses_fields() {
    static const Fields<RobotPosesSetup> fields = [] {
        Fields<RobotPosesSetup> made;
        add_poses(made);
        add_instrument(made);
        add_decisions(made);
        return made;
    }();
    return fields;
}

std::optional<RobotPosesSetup> read_robot_poses_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                      Problems& problems) {
    RobotPosesSetup setup = robot_poses_fields().read(reader, assets, problems);
    check_commanded(setup, problems);
    if (!problems.has_errors()) SeriesOfCycles(setup, problems).collect();
    check_pairs(setup, problems);
    check_rule(setup, problems);
    check_target(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

}  // namespace covaria::sheets
