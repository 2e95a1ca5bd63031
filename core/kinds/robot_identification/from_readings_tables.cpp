// Results of an identification from readings: parameters, what was found beside them, observability,
// residuals, readings held back, layout.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/kinds/robot/layout.h"
#include "core/kinds/robot_identification/from_readings.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria::reading_identification {

namespace {

using Eigen::Index;
const Unit um = Unit::of("um");

Message coordinate_name(const Unknown& unknown, bool plane) {
    static const char* const axes[] = {"x", "y", "z"};
    const std::size_t k = unknown.coordinate;
    if (plane) return k < 2 ? tell<"tilt %1">(k + 1) : tell<"offset">();
    return k < 3 ? Message(axes[k]) : tell<"rotation about %1">(axes[k - 3]);
}

Eigen::MatrixXd parameter_covariance(const Identification& id) {
    std::vector<Index> of;
    for (std::size_t i = 0; i < id.unknowns.size(); ++i)
        if (id.unknowns[i].kind == UnknownKind::parameter) of.push_back(static_cast<Index>(i));
    return id.statistics.covariance(of, of);
}

/// Rows of what was found beside the parameters; `slopes`: derivatives by the unknowns.
class SurroundingsTable {
public:
    explicit SurroundingsTable(const Identification& id) : id_(id) {
        table_.add("unknown");
        table_.add("value").estimate_of("u");
        table_.add("u").symbol().figure(2);
    }

    Table make() {
        add_base_angles();
        for (std::size_t i = 0; i < id_.unknowns.size(); ++i) {
            const Unknown& unknown = id_.unknowns[i];
            const bool turns = unknown.kind == UnknownKind::base && unknown.coordinate >= 3;
            const bool plane = unknown.kind == UnknownKind::place && id_.fixed_places[unknown.of].plane;
            if (unknown.kind == UnknownKind::parameter || turns || plane) continue;
            const Unit unit = Unit::of(unknown.kind == UnknownKind::compliance ? "urad/(N*m)" : "mm");
            add(id_.name_of(unknown), id_.solution[i], slope(i), unit);
        }
        for (std::size_t k = 0; k < id_.fixed_places.size(); ++k)
            if (id_.fixed_places[k].plane && id_.fixed_places[k].found) add_plane(k);
        return std::move(table_);
    }

private:
    Eigen::VectorXd none() const { return Eigen::VectorXd::Zero(static_cast<Index>(id_.unknowns.size())); }
    Eigen::VectorXd slope(std::size_t unknown) const {
        Eigen::VectorXd slopes = none();
        slopes[static_cast<Index>(unknown)] = 1.0;
        return slopes;
    }

    void add(Message name, double value, const Eigen::VectorXd& slopes, const Unit& unit) {
        const double u = std::sqrt(std::max(0.0, slopes.dot(id_.statistics.covariance * slopes)));
        table_.row({std::move(name), Quantity{unit.interval_from_si(value), unit},
                    Quantity{unit.interval_from_si(u), unit}});
    }

    /// Angles of the base by the small rotations about its axes, which the fit finds.
    void add_base_angles() {
        static const char* const symbols[] = {"alpha", "beta", "gamma"};
        constexpr double turn = 1e-5;
        if (!id_.has_kind(UnknownKind::base)) return;
        const Eigen::Vector3d angles = zyx_from_rotation<double>(id_.X_MB.linear());
        std::array<Eigen::VectorXd, 3> slopes{none(), none(), none()};
        for (std::size_t i = 0; i < id_.unknowns.size(); ++i) {
            const Unknown& unknown = id_.unknowns[i];
            if (unknown.kind != UnknownKind::base || unknown.coordinate < 3) continue;
            Eigen::Vector3d small = Eigen::Vector3d::Zero();
            small[static_cast<Index>(unknown.coordinate) - 3] = turn;
            const Eigen::Vector3d there =
                zyx_from_rotation<double>(id_.X_MB.linear() * rotation_from_zyx<double>(small));
            for (int k = 0; k < 3; ++k)
                slopes[static_cast<std::size_t>(k)][static_cast<Index>(i)] =
                    std::remainder(there[k] - angles[k], 2.0 * std::numbers::pi) / turn;
        }
        for (std::size_t k = 0; k < 3; ++k)
            add(tell<"base %1">(symbol_to_unicode(symbols[k])), angles[static_cast<Index>(k)], slopes[k],
                Unit::of("deg"));
    }

    void add_plane(std::size_t place) {
        static const char* const axes[] = {"n_x", "n_y", "n_z"};
        const Place& plane = id_.fixed_places[place];
        const Eigen::Vector3d normal = plane.axes.col(2);
        std::array<Eigen::VectorXd, 3> slopes{none(), none(), none()};
        Eigen::VectorXd distance = none();
        for (std::size_t i = 0; i < id_.unknowns.size(); ++i) {
            const Unknown& unknown = id_.unknowns[i];
            if (unknown.kind != UnknownKind::place || unknown.of != place) continue;
            const auto k = static_cast<Index>(unknown.coordinate), column = static_cast<Index>(i);
            distance[column] = k < 2 ? plane.p.dot(plane.axes.col(k)) : 1.0;
            for (Index axis = 0; axis < 3 && k < 2; ++axis)
                slopes[static_cast<std::size_t>(axis)][column] = plane.axes(axis, k);
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            add(tell<"%1 %2">(plane.name, axes[axis]), normal[static_cast<Index>(axis)], slopes[axis],
                Unit());
        add(tell<"distance of plane %1 from the origin">(plane.name), normal.dot(plane.p), distance,
            Unit::of("mm"));
    }

    const Identification& id_;
    Table table_{"surroundings", "What was found beside the parameters"};
};

Table residual_table(const Identification& id) {
    Table table{"residuals", "Residuals of the fit, measured less calculated"};
    table.add("reading");
    table.add("residual").in(um).figure(3);
    table.add("over its u").figure(2);
    table.add("outlier test");
    const auto& s = id.statistics;
    for (std::size_t i = 0; i < id.fitted_rows; ++i) {
        const auto row = static_cast<Index>(i);
        const double size = s.w[row];
        table.row({id.rows[i].name, s.residuals[row], size, size > s.limit ? tell<"outlier">() : Message()});
    }
    table.notes = {
        tell<"A residual beyond %1 times its own standard uncertainty is an outlier: 5 % for all residuals "
             "together (Bonferroni).">(Message::number(format_decimals(s.limit, 2)))};
    return table;
}

Table check_table(const Identification& id) {
    Table table{"check-readings", "Readings held back from the fit, calculated less measured"};
    table.add("reading");
    table.add("nominal").in(um).figure(3);
    table.add("identified").in(um).figure(3);
    table.add("U (k = 2)").in(um).figure(2);
    table.add("E_n").symbol().figure(2);
    for (std::size_t i = id.fitted_rows; i < id.rows.size(); ++i) {
        const auto k = static_cast<Index>(i - id.fitted_rows);
        const double U = 2.0 * id.u_deviations[k];
        table.row({id.rows[i].name, id.before[k], id.deviations[k], U,
                   U > 0.0 ? Cell(std::abs(id.deviations[k]) / U) : Cell(Message())});
    }
    table.notes = {
        tell<"Nominal: the same surroundings fitted with the nominal parameters. E_n = |d|/U: below 1 the "
             "reading agrees with the calibration.">()};
    return table;
}

class LayoutOfReadings {
public:
    explicit LayoutOfReadings(const Identification& id) : id_(id) {
        RobotData data = identified(id);
        data.X_FT = Eigen::Translation3d(id.arm_targets.front().p_F);
        const RobotSource arm(std::move(data));
        add_arm(arm, id.poses.front().q, "", layout_);
        for (const Pose& pose : id.poses)
            flanges_.push_back(id.X_MB * link_frames(arm, pose.q)[pose.q.size()]);
    }

    Layout build() {
        add_targets();
        add_distances();
        for (std::size_t k = 0; k < id_.fixed_places.size(); ++k)
            id_.fixed_places[k].plane ? add_plane(k) : add_point(k);
        return std::move(layout_);
    }

private:
    Eigen::Vector3d place(std::size_t pose, std::size_t target) const {
        return flanges_[pose] * id_.arm_targets[target].p_F;
    }

    void add_targets() {
        std::set<std::pair<std::size_t, std::size_t>> shown;
        for (const Row& row : id_.rows) {
            if (!shown.insert({row.pose, row.target}).second) continue;
            LayoutPoint point{.name = "",
                              .kind = row.check ? PointKind::ball : PointKind::target,
                              .p_W = place(row.pose, row.target)};
            point.source.path = row.source;
            if (row.kind == RowKind::x) point.inputs = {{row.input, row.input + 1, row.input + 2}};
            layout_.points.push_back(std::move(point));
        }
    }

    /// One line of sight from each point: all of them would hide the arm.
    void add_distances() {
        std::set<std::size_t> seen_from;
        for (const Row& row : id_.rows) {
            if (row.kind == RowKind::from_point && seen_from.insert(row.to).second)
                layout_.links.push_back({.name = "",
                                         .kind = LinkKind::sight_line,
                                         .from_W = id_.fixed_places[row.to].p,
                                         .to_W = place(row.pose, row.target)});
            if (row.kind == RowKind::between_poses)
                layout_.links.push_back({.name = "",
                                         .kind = LinkKind::dimension,
                                         .from_W = place(row.to, row.target),
                                         .to_W = place(row.pose, row.target)});
        }
    }

    void add_point(std::size_t k) {
        LayoutPoint point{
            .name = id_.fixed_places[k].name, .kind = PointKind::station, .p_W = id_.fixed_places[k].p};
        point.source.path = fields().place(&Identification::places, k);
        layout_.points.push_back(std::move(point));
    }

    /// As large as what was measured from it.
    void add_plane(std::size_t k) {
        const Place& plane = id_.fixed_places[k];
        Eigen::Array2d low = Eigen::Array2d::Constant(infinity), high = -low;
        for (const Row& row : id_.rows) {
            if (row.kind != RowKind::from_plane || row.to != k) continue;
            const Eigen::Vector3d p = place(row.pose, row.target) - plane.p;
            const Eigen::Array2d along(p.dot(plane.axes.col(0)), p.dot(plane.axes.col(1)));
            low = low.min(along);
            high = high.max(along);
        }
        if (!(low < high).all()) return;
        // Edges alone: a plate of this size would hide the arm.
        const std::array<Eigen::Array2d, 5> corners{low, {high[0], low[1]}, high, {low[0], high[1]}, low};
        const auto at = [&](const Eigen::Array2d& c) -> Eigen::Vector3d {
            return plane.p + plane.axes.leftCols<2>() * c.matrix();
        };
        for (std::size_t i = 0; i < 4; ++i)
            layout_.links.push_back(
                {.name = "", .kind = LinkKind::edge, .from_W = at(corners[i]), .to_W = at(corners[i + 1])});
        LayoutPoint point{.name = plane.name, .kind = PointKind::other, .p_W = at(low)};
        point.source.path = fields().place(&Identification::places, k);
        layout_.points.push_back(std::move(point));
    }

    const Identification& id_;
    std::vector<Eigen::Isometry3d> flanges_;
    Layout layout_;
};

}  // namespace

std::string Identification::label(std::size_t pose, std::size_t target) const {
    const std::string& name = poses[pose].name;
    return arm_targets.size() == 1 ? name : name + " " + arm_targets[target].name;
}

Message Identification::name_of(const Unknown& u) const {
    switch (u.kind) {
        case UnknownKind::base:
            return tell<"base %1">(coordinate_name(u, false));
        case UnknownKind::place:
            return tell<"%1 %2">(fixed_places[u.of].name, coordinate_name(u, fixed_places[u.of].plane));
        case UnknownKind::zero:
            return tell<"zero %1">(zeros[u.of]);
        case UnknownKind::target:
            return tell<"%1 %2">(arm_targets[u.of].name, coordinate_name(u, false));
        case UnknownKind::parameter:
            return IdentifiedParameter{u.of, u.parameter}.symbol();
        case UnknownKind::compliance:
            return "c_" + std::to_string(u.of + 1);
    }
    return {};
}

std::vector<Message> Identification::names() const {
    std::vector<Message> names;
    for (const Unknown& u : unknowns) names.push_back(name_of(u));
    return names;
}

std::vector<IdentifiedParameter> Identification::parameters() const {
    std::vector<IdentifiedParameter> found;
    for (const Unknown& u : unknowns)
        if (u.kind == UnknownKind::parameter) found.push_back({u.of, u.parameter});
    return found;
}

std::vector<double> Identification::values_of_parameters() const {
    std::vector<double> values;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (unknowns[i].kind == UnknownKind::parameter) values.push_back(solution[i]);
    return values;
}

bool Identification::has_kind(UnknownKind kind) const {
    return std::ranges::any_of(unknowns, [&](const Unknown& u) { return u.kind == kind; });
}

std::vector<Table> tables(const Identification& id) {
    std::vector<Table> all{
        identified_table(id.robot(), id.parameters(), id.values_of_parameters(), parameter_covariance(id)),
        SurroundingsTable(id).make(), held_table(id.held)};
    if (!id.scale_note.empty()) all.front().notes.push_back(id.scale_note);
    for (Table& table : observability_tables(id.statistics, id.names(), tell<"readings in the fit">()))
        all.push_back(std::move(table));
    if (!id.simulated) all.push_back(residual_table(id));
    if (id.fitted_rows < id.rows.size()) all.push_back(check_table(id));
    return all;
}

RobotData identified(const Identification& id) {
    RobotData data = identified_robot(id.robot(), id.parameters(), id.values_of_parameters());
    data.X_WB = id.X_MB;
    take_reading_uncertainties(id.robot(), data);
    return data;
}

/// The arm as identified in its first pose, where its targets were in all of them, and what was measured
/// from.
Layout layout(const Identification& id) {
    return LayoutOfReadings(id).build();
}

}  // namespace covaria::reading_identification
