// Input quantities of an identification from readings: what was measured, what is known, how joints are read.
#include <set>

#include "core/kinds/robot_identification/from_readings.h"

namespace covaria::reading_identification {

namespace {

using Stated = StatedIdentification;

class InputsOfRows {
public:
    InputsOfRows(Identification& id, Problems& problems) : id_(id), problems_(problems) {}

    /// `Row::input` becomes the index of an input quantity.
    void add() {
        const std::size_t scale = id_.u_scale > 0.0 ? add_scale() : nothing;
        std::vector<LocatedPoint> points;
        std::set<std::size_t> moving;
        for (Row& row : id_.rows) {
            moving.insert(row.pose);
            if (row.kind == RowKind::between_poses) moving.insert(row.to);
            if (row.kind == RowKind::x)
                points.push_back(add_position(row));
            else if (row.kind == RowKind::y || row.kind == RowKind::z)
                row.input = points.back().x_input + (row.kind == RowKind::y ? 1 : 2);
            else
                add_distance(row, scale);
        }
        if (!points.empty()) add_point_components(id_.locator, points, id_.inputs, problems_);
        for (std::size_t k = 0; k < id_.arm_targets.size(); ++k) add_target(k);
        for (std::size_t k = 0; k < id_.fixed_places.size(); ++k) add_place(k);
        for (const std::size_t pose : moving) add_joint_readings(pose);
    }

private:
    std::size_t add_scale() {
        return id_.inputs.add({.id = "scale",
                               .name = tell<"scale of the distances">(),
                               .unit = Unit::of("ppm"),
                               .distribution = Distribution::normal(id_.u_scale),
                               .origin = tell<"typed standard uncertainty">()});
    }

    LocatedPoint add_position(Row& row) {
        static const char* const axes[] = {"x", "y", "z"};
        const std::size_t number = row.input - id_.distances.size();
        LocatedPoint point{.label = std::to_string(number + 1), .x_input = id_.inputs.quantities.size()};
        row.input = point.x_input;
        point.name = id_.label(row.pose, row.target);
        for (std::size_t k = 0; k < 3; ++k) {
            const double value = (&row)[k].value;
            point.p[static_cast<Eigen::Index>(k)] = value;
            InputQuantity quantity{.symbol = std::string(axes[k]) + "_" + point.label,
                                   .name = (&row)[k].name,
                                   .unit = Unit::of("mm"),
                                   .offset = value,
                                   .group = "pose " + id_.poses[row.pose].name,
                                   .source = row.source};
            quantity.tags = {{"kind", own_name<"measured positions">()}};
            id_.inputs.quantities.push_back(std::move(quantity));
        }
        return point;
    }

    void add_distance(Row& row, std::size_t scale) {
        const std::size_t number = row.input;
        const std::string symbol = "L_" + std::to_string(number + 1);
        InputQuantity quantity{.symbol = symbol,
                               .name = tell<"distance %1">(row.name),
                               .unit = Unit::of("mm"),
                               .offset = row.value,
                               .group = "pose " + id_.poses[row.pose].name,
                               .source = row.source};
        quantity.tags = {{"kind", row.kind == RowKind::from_plane ? own_name<"distances from planes">()
                                                                  : own_name<"measured distances">()}};
        const double u = id_.distances[number].u.value_or(id_.u_distance);
        row.input = id_.inputs.add(std::move(quantity), {{.id = symbol + ".distance",
                                                          .name = tell<"measured distance">(),
                                                          .unit = Unit::of("mm"),
                                                          .distribution = Distribution::normal(u),
                                                          .origin = tell<"typed standard uncertainty">(),
                                                          .source = row.source}});
        if (scale != nothing && row.kind != RowKind::from_plane)
            id_.inputs.quantities[row.input].shares.push_back({scale, row.value});
    }

    std::size_t add_known(const std::string& symbol, Message name, double value, double u,
                          const std::string& source) {
        InputQuantity quantity{.symbol = symbol,
                               .name = std::move(name),
                               .unit = Unit::of("mm"),
                               .offset = value,
                               .source = source};
        quantity.tags = {{"kind", own_name<"known places">()}};
        return id_.inputs.add(std::move(quantity), {{.id = symbol + ".place",
                                                     .name = tell<"known place">(),
                                                     .unit = Unit::of("mm"),
                                                     .distribution = Distribution::normal(u),
                                                     .origin = tell<"typed standard uncertainty">()}});
    }

    std::size_t add_known_point(const std::string& label, const std::string& name, const Eigen::Vector3d& p,
                                double u, const std::string& source) {
        static const char* const axes[] = {"x", "y", "z"};
        const std::size_t first = id_.inputs.quantities.size();
        for (int k = 0; k < 3; ++k)
            add_known(std::string(axes[k]) + "_" + label, tell<"%1, %2">(name, axes[k]), p[k], u, source);
        return first;
    }

    void add_target(std::size_t k) {
        const StatedTarget& stated = id_.targets[k];
        if (stated.found || !(stated.u > 0.0)) return;
        id_.arm_targets[k].first_input = add_known_point("T" + std::to_string(k + 1), stated.name, stated.p,
                                                         stated.u, fields().place(&Stated::targets, k));
    }

    void add_place(std::size_t k) {
        const StatedPlace& stated = id_.places[k];
        if (stated.found || !(stated.u > 0.0)) return;
        Place& place = id_.fixed_places[k];
        const std::string source = fields().place(&Stated::places, k);
        const std::string number = std::to_string(k + 1);
        place.first_input = stated.plane
                                ? add_known("h_" + number, tell<"plane %1, along its normal">(stated.name),
                                            0.0, stated.u, source)
                                : add_known_point("O" + number, stated.name, place.p, stated.u, source);
    }

    void add_joint_readings(std::size_t k) {
        Pose& pose = id_.poses[k];
        for (std::size_t j = 0; j < pose.q.size(); ++j) {
            std::vector<UncertaintyComponent> components = id_.robot().reading(j);
            if (components.empty()) continue;
            const std::string symbol = reading_symbol(id_.robot(), j) + "," + std::to_string(k + 1);
            InputQuantity quantity{.symbol = symbol,
                                   .name = tell<"pose %1, reading of joint %2">(pose.name, j + 1),
                                   .unit = id_.robot().joints()[j].reading_unit(),
                                   .offset = pose.q[j],
                                   .group = "pose " + pose.name,
                                   .source = fields().place(&Stated::stated_poses, k)};
            quantity.tags = {{"kind", own_name<"readings of the joints">()}};
            for (UncertaintyComponent& component : components) component.id = symbol + "." + component.id;
            pose.reading[j] = id_.inputs.add(std::move(quantity), std::move(components));
        }
    }

    Identification& id_;
    Problems& problems_;
};

}  // namespace

void simulate(Identification& id) {
    const std::vector<double> x(3 * id.rows.size(), 0.0);
    std::vector<Row> rows = id.rows;
    for (Row& row : id.rows) row.input = 0;
    Scene<double> scene;
    scene_of<double>(id, x, x, scene);
    residuals<double>(id, 0, rows.size(), scene, x, [&](std::size_t i, double r) { rows[i].value = -r; });
    id.rows = std::move(rows);
}

bool add_nominal(Identification& id, const Unknown& length) {
    const IdentifiedParameter parameter{length.of, length.parameter};
    const std::string symbol = parameter.symbol() + ",nominal";
    std::vector<UncertaintyComponent> components;
    for (const ParameterDeviation& deviation : id.robot().deviations()) {
        if (deviation.joint != length.of || deviation.parameter != length.parameter) continue;
        UncertaintyComponent component = deviation.component;
        if (!(component.distribution.standard_uncertainty() > 0.0)) continue;
        component.id = symbol + "." + component.id;
        components.push_back(std::move(component));
    }
    if (components.empty()) return false;
    const double value = id.robot().joints()[length.of].values[length.parameter];
    Row row{.kind = RowKind::nominal_length,
            .to = length.of,
            .parameter = length.parameter,
            .value = value,
            .name = tell<"nominal %1">(parameter.symbol()),
            .source = fields().place(&Stated::nominal)};
    InputQuantity quantity{
        .symbol = symbol, .name = row.name, .unit = Unit::of("mm"), .offset = value, .source = row.source};
    quantity.tags = {{"kind", own_name<"nominal robot">()}};
    row.input = id.inputs.add(std::move(quantity), std::move(components));
    id.rows.insert(id.rows.begin() + static_cast<std::ptrdiff_t>(id.fitted_rows++), std::move(row));
    return true;
}

void add_inputs(Identification& id, Problems& problems) {
    InputsOfRows(id, problems).add();
}

}  // namespace covaria::reading_identification
