// What the joint trajectories say: parameters with their covariance, tables, picture.
#include <cmath>
#include <numbers>

#include "core/assets/circle_points.h"
#include "core/model/robot_layout.h"

namespace covaria::circle_points {

namespace {

template <class Real>
class AllInputs {
public:
    AllInputs(const InputSet& inputs, std::size_t first) : first_(first) {
        for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x_.push_back(estimate_of(inputs, i));
    }
    void move_to(std::size_t first) { first_ = first; }
    std::size_t size() const { return x_.size(); }
    Real operator[](std::size_t i) const {
        if constexpr (std::is_same_v<Real, Dual>)
            return i >= first_ && i < first_ + Dual::size ? Dual::variable(x_[i], i - first_) : Dual(x_[i]);
        else
            return x_[i];
    }

private:
    std::vector<double> x_;
    std::size_t first_;
};

/// Parameters (rows) by components (columns), times the standard uncertainties of the components.
Eigen::MatrixXd scaled_sensitivity(const Identification& id) {
    const auto rows = static_cast<Eigen::Index>(id.parameters.size());
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(id.inputs.components.size()));
    AllInputs<Dual> x(id.inputs, 0);
    std::vector<Dual> y(id.parameters.size() + id.trajectories.size());
    for (std::size_t first = 0; first < x.size(); first += Dual::size) {
        x.move_to(first);
        evaluate<Dual>(id, x, [&](std::size_t j, const Dual& value) { y[j] = value; });
        for (std::size_t i = first; i < std::min(first + Dual::size, x.size()); ++i)
            for (const Share& share : id.inputs.quantities[i].shares)
                for (Eigen::Index j = 0; j < rows; ++j)
                    S(j, static_cast<Eigen::Index>(share.component)) +=
                        y[static_cast<std::size_t>(j)].partials()[i - first] * share.factor;
    }
    for (std::size_t c = 0; c < id.inputs.components.size(); ++c)
        S.col(static_cast<Eigen::Index>(c)) *= id.inputs.components[c].distribution.standard_uncertainty();
    return S;
}

double nominal_of(const Identification& id, const Parameter& p) {
    return id.robot().joints()[p.joint].values[p.parameter];
}

TableCell cell(JointParameter p, double si) {
    const Unit unit = Unit::of(is_length(p) ? "mm" : "deg");
    return Quantity{unit.interval_from_si(si), unit};
}

DataTable circles_table(const Identification& id) {
    const Unit mm = Unit::of("mm");
    DataTable table;
    table.id = "circles";
    table.title = "Circles of the joints";
    table.columns = {{.header = "joint"},
                     {.header = "points"},
                     {.header = "arc", .unit = Unit::of("deg"), .digits = 4},
                     {.header = "radius", .unit = mm, .digits = 6},
                     {.header = "rms along the radius", .unit = mm, .digits = 2},
                     {.header = "rms off the plane", .unit = mm, .digits = 2}};
    for (std::size_t j = 0; j < id.trajectories.size(); ++j) {
        const Trajectory& t = id.trajectories[j];
        double along = 0.0, off = 0.0;
        for (const Eigen::Vector3d& p : t.points) {
            const Eigen::Vector3d q = t.shape.start.axes.transpose() * (p - t.shape.start.centre);
            along += std::pow(q.head<2>().norm() - t.shape.start.radius, 2);
            off += q.z() * q.z();
        }
        const auto n = static_cast<double>(t.points.size());
        table.rows.push_back({static_cast<double>(j + 1), n, t.shape.arc, t.shape.start.radius,
                              std::sqrt(along / n), std::sqrt(off / n)});
    }
    if (id.simulated)
        table.notes.push_back("Simulated points of the nominal robot: they lie on their circles.");
    return table;
}

DataTable parameters_table(const Identification& id) {
    DataTable table;
    table.id = "identified";
    table.title = "Identified parameters beside the nominal ones";
    table.columns = {{.header = "parameter", .is_symbol = true},
                     {.header = "nominal"},
                     {.header = "identified"},
                     {.header = "difference"}};
    const auto values = estimates(id);
    for (std::size_t i = 0; values && i < id.parameters.size(); ++i) {
        const JointParameter p = id.parameters[i].parameter;
        const double nominal = nominal_of(id, id.parameters[i]);
        table.rows.push_back({id.parameters[i].symbol(), cell(p, nominal), cell(p, (*values)[i]),
                              cell(p, (*values)[i] - nominal)});
    }
    return table;
}

DataTable missing_table(const Identification& id) {
    DataTable table;
    table.id = "not-identified";
    table.title = "What these points cannot tell";
    table.columns = {{.header = "parameter", .is_symbol = true}, {.header = "reason"}};
    for (const Missing& m : id.missing) table.rows.push_back({m.parameter, m.reason});
    return table;
}

}  // namespace

std::optional<std::vector<double>> estimates(const Identification& id) {
    const AllInputs<double> x(id.inputs, 0);
    std::vector<double> y(id.parameters.size() + id.trajectories.size());
    if (!evaluate<double>(id, x, [&](std::size_t j, double value) { y[j] = value; })) return {};
    y.resize(id.parameters.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (!std::isfinite(y[i])) return {};
        if (is_length(id.parameters[i].parameter)) continue;
        const double nominal = nominal_of(id, id.parameters[i]);
        y[i] = nominal + std::remainder(y[i] - nominal, 2.0 * std::numbers::pi);
    }
    return y;
}

std::vector<DataTable> tables(const Identification& id) {
    return {circles_table(id), parameters_table(id), missing_table(id)};
}

Layout layout(const Identification& id) {
    Layout layout;
    double size = 0.0;
    for (const Trajectory& t : id.trajectories) size = std::max(size, t.shape.start.radius);
    for (std::size_t j = 0; j < id.trajectories.size(); ++j) {
        const Trajectory& t = id.trajectories[j];
        const CircleStart& s = t.shape.start;
        const std::string name = "joint " + std::to_string(j + 1);
        LayoutBody disc{.name = "circle of " + name};
        constexpr int corners = 72;
        for (int k = 0; k < corners; ++k) {
            const double a = 2.0 * std::numbers::pi * k / corners;
            disc.outline_W.push_back(s.centre +
                                     s.radius * (std::cos(a) * s.axes.col(0) + std::sin(a) * s.axes.col(1)));
        }
        layout.bodies.push_back(std::move(disc));
        layout.links.push_back({.name = "axis of " + name,
                                .kind = LinkKind::joint_axis,
                                .from_W = s.centre - 0.2 * size * s.axes.col(2),
                                .to_W = s.centre + 0.2 * size * s.axes.col(2)});
        for (std::size_t k = 0; k < t.points.size(); ++k) {
            const std::size_t i = t.first_input + 3 * k;
            LayoutPoint point{.name = "", .kind = PointKind::ball, .p_W = t.points[k]};
            if (k == 0) point.name = name;
            if (!t.rows.empty()) point.source.path = "/points/rows/" + std::to_string(t.rows[k]);
            point.inputs = {{i, i + 1, i + 2}};
            layout.points.push_back(std::move(point));
        }
    }
    return layout;
}

std::optional<RobotData> identified(const Identification& id, Problems& problems) {
    const auto values = estimates(id);
    if (!values) {
        problems.error("/points", "the points do not lead to parameters of the arm");
        return {};
    }
    RobotData data;
    const SerialRobotSource& nominal = id.robot();
    data.joints = nominal.joints();
    data.X_WB = nominal.X_WB();
    data.X_FT = nominal.X_FT();
    for (std::size_t j = 0; j + 1 < data.joints.size(); ++j) {
        data.joints[j].parallel = id.structure.parallel[j];
        if (data.joints[j].parallel) data.joints[j].values.d = 0.0;
    }
    const Eigen::MatrixXd S = scaled_sensitivity(id);
    const Eigen::MatrixXd C = S * S.transpose();
    std::vector<Eigen::Index> drawn;
    for (std::size_t i = 0; i < id.parameters.size(); ++i) {
        const Parameter& p = id.parameters[i];
        data.joints[p.joint].values[p.parameter] = (*values)[i];
        const auto row = static_cast<Eigen::Index>(i);
        if (!(C(row, row) > 0.0)) continue;
        drawn.push_back(row);
        data.deviations.push_back({p.joint,
                                   p.parameter,
                                   {.id = p.symbol() + ".identification",
                                    .name = p.symbol() + ", identification",
                                    .unit = Unit::of(is_length(p.parameter) ? "mm" : "deg"),
                                    .distribution = Distribution::normal(std::sqrt(C(row, row))),
                                    .origin = "identification by joint trajectories"}});
    }
    for (std::size_t a = 0; a < drawn.size(); ++a)
        for (std::size_t b = a + 1; b < drawn.size(); ++b)
            if (const double r =
                    C(drawn[a], drawn[b]) / std::sqrt(C(drawn[a], drawn[a]) * C(drawn[b], drawn[b]));
                std::abs(r) > 1e-12)
                data.correlations.push_back({a, b, r});
    return data;
}

}  // namespace covaria::circle_points
