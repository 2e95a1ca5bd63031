// Measurement model "accuracy and repeatability of poses": the model class and its descriptor.
#include <cmath>

#include "core/kinds/sheets/robot_poses_figures.h"
#include "core/kinds/sheets/robot_poses_model.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using sheets::PoseSeries;
using sheets::RobotPosesFigures;
using sheets::RobotPosesSetup;
using sheets::SeriesFigures;

constexpr double nothing_square = 1e-36;  ///< m^2: keeps the derivative of a root finite
constexpr std::array<const char*, 3> axis_keys{"x", "y", "z"}, angle_keys{"a", "b", "c"};

const std::vector<ModelEquation>& robot_poses_equations() {
    static const std::vector<ModelEquation> all{
        {"AP = |x̄ − x_c|", tell<"ISO 9283, accuracy of a pose">()},
        {"RP = c (l̄ + 3 s_l),  l_j = |x_j − x̄|",
         tell<"ISO 9283, repeatability; c = RP(∞)/RP(n) by simulated campaigns">()},
        {"RP_R² = RP² − RP_I²", tell<"without the instrument, where both scatter in one shape">()},
        {"vAP = max |x̄_h − x̄_k|", tell<"of several directions of approach">()},
        {"AD = |D̄ − D_c|,  RD = ±3 s_D", tell<"distances between poses">()},
        {"dAP = max |AP(t) − AP(0)|,  dRP = max |RP(t) − RP(0)|", tell<"drift">()}};
    return all;
}

/// Barycentres with the scatter of their cycles, RP with the law of few cycles, the instrument's share.
class RobotPoses : public EquationModel<RobotPoses> {
public:
    RobotPoses(RobotPosesSetup setup, RobotPosesFigures figures)
        : setup_(std::move(setup)), figures_(std::move(figures)) {
        stride_ = setup_.has_angles() ? 10 : 4;
        for (std::size_t k = 0; k < setup_.series.size(); ++k) add_series(k);
        first_place_ = inputs_.quantities.size();
        for (std::size_t p = 0; p < setup_.commanded.size(); ++p) add_place(p);
        first_distance_ = inputs_.quantities.size();
        for (std::size_t d = 0; d < figures_.distances.size(); ++d) add_distance(d);
        instrument_ = inputs_.quantities.size();
        if (figures_.instrument) add_instrument();
        for (std::size_t k = 0; k < setup_.series.size(); ++k) add_outputs(k);
        add_joint_outputs();
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return sheets::robot_poses_tables(setup_, figures_); }
    std::vector<PlotSpecification> figures() const override {
        return sheets::robot_poses_plots(setup_, figures_);
    }

    Layout layout(std::span<const double> x) const override {
        Layout layout;
        layout.frames.push_back({own_name<"base of the robot">()});
        for (std::size_t k = 0; k < setup_.series.size(); ++k) {
            const std::size_t i = k * stride_;
            layout.points.push_back({.name = sheets::label_of(setup_.series[k]),
                                     .kind = PointKind::tool,
                                     .p_W = Eigen::Vector3d(x[i], x[i + 1], x[i + 2]),
                                     .group = group_of(k),
                                     .inputs = std::array<std::size_t, 3>{i, i + 1, i + 2}});
        }
        return layout;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        using namespace real_functions;
        std::size_t output = 0;
        for (std::size_t k = 0; k < setup_.series.size(); ++k) output = one_series(x, y, k, output);
        for (const auto& group : figures_.directions) {
            Real largest(nothing_square);
            for (std::size_t i = 0; i < group.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    largest = max(largest, squared_distance(x, group[i], group[j]));
            y.set(output++, sqrt(largest));
        }
        for (const auto& group : figures_.drifts)
            for (const std::size_t what : {std::size_t(0), std::size_t(1)}) {
                const Real start = y.get(ap_output(group.front()) + what);
                Real largest(0.0);
                for (std::size_t i = 1; i < group.size(); ++i)
                    largest = max(largest, Real(abs(Real(y.get(ap_output(group[i]) + what) - start))));
                y.set(output++, largest);
            }
        for (std::size_t d = 0; d < figures_.distances.size(); ++d) {
            y.set(output++, abs(Real(x[first_distance_ + 2 * d] - Real(figures_.distances[d].commanded))));
            y.set(output++, x[first_distance_ + 2 * d + 1]);
        }
        return Real(0.0) == Real(0.0);
    }

private:
    std::size_t outputs_of_a_series() const {
        return 2 + (figures_.instrument ? 2 : 0) + (setup_.has_angles() ? 6 : 0);
    }
    std::size_t ap_output(std::size_t series) const { return series * outputs_of_a_series(); }

    template <class Real>
    std::size_t one_series(const Inputs<Real>& x, Outputs<Real>& y, std::size_t k, std::size_t output) const {
        using namespace real_functions;
        const std::size_t i = k * stride_, place = first_place_ + 3 * figures_.series[k].pose;
        Real square(0.0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Real d =
                x[i + axis] + x[place + axis] - Real(setup_.series[k].commanded[Eigen::Index(axis)]);
            square = square + d * d;
        }
        y.set(output++, sqrt(max(square, Real(nothing_square))));
        y.set(output++, x[i + 3]);
        if (figures_.instrument) {
            const Real whole = x[i + 3] * x[i + 3], own = x[instrument_] * x[instrument_];
            y.set(output++, sqrt(max(Real(whole - own), Real(nothing_square))));
            y.set(output++, own / max(whole, Real(nothing_square)));
        }
        for (std::size_t a = 0; a < 6 && setup_.has_angles(); ++a) y.set(output++, x[i + 4 + a]);
        return output;
    }

    template <class Real>
    Real squared_distance(const Inputs<Real>& x, std::size_t k, std::size_t l) const {
        Real square(0.0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Real d = x[k * stride_ + axis] - x[l * stride_ + axis];
            square = square + d * d;
        }
        return square;
    }

    Name group_of(std::size_t k) const { return own_name<"pose %1">(sheets::label_of(setup_.series[k])); }
    std::string number_of(std::size_t k) const { return std::to_string(k + 1); }

    UncertaintyComponent scatter(std::string id, Message name, double u, int cycles) const {
        UncertaintyComponent component;
        component.id = std::move(id);
        component.name = std::move(name);
        component.unit = Unit::of("mm");
        component.distribution = Distribution::of(StudentT{0.0, u, double(cycles - 1)});
        component.type = EvaluationType::type_a;
        component.degrees_of_freedom = double(cycles - 1);
        component.origin = tell<"%1 cycles">(cycles);
        return component;
    }

    /// A figure of scatter times what few cycles leave open of it: a distribution of its own.
    void add_scaled(std::string symbol, Message name, const Unit& unit, double figure, Distribution factor,
                    int cycles, Name group) {
        UncertaintyComponent component;
        component.id = symbol + ".cycles";
        component.name = tell<"few cycles">();
        component.distribution = std::move(factor);
        component.type = EvaluationType::type_a;
        component.origin = tell<"%1 cycles, normal scatter of the shape seen">(cycles);
        InputQuantity quantity{
            .symbol = std::move(symbol), .name = std::move(name), .unit = unit, .group = std::move(group)};
        if (figure > 0.0) quantity.shares.push_back({inputs_.add(std::move(component)), figure});
        inputs_.quantities.push_back(std::move(quantity));
    }

    void add_series(std::size_t k) {
        const PoseSeries& series = setup_.series[k];
        const SeriesFigures& f = figures_.series[k];
        const double n = double(series.cycles());
        VarianceEstimate estimate{"barycentre " + number_of(k), {}};
        std::array<std::size_t, 3> components{InputSet::npos, InputSet::npos, InputSet::npos};
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const std::string symbol = std::string(axis_keys[std::size_t(axis)]) + "_" + number_of(k);
            const double u = std::sqrt(f.covariance(axis, axis) / n);
            InputQuantity quantity{
                .symbol = symbol,
                .name = tell<"barycentre of %1, %2">(sheets::label_of(series), axis_keys[std::size_t(axis)]),
                .unit = Unit::of("mm"),
                .offset = f.barycentre[axis],
                .group = group_of(k)};
            if (u > 0.0) {
                components[std::size_t(axis)] = inputs_.add(
                    scatter(symbol + ".cycles", tell<"scatter of the cycles">(), u, series.cycles()));
                quantity.shares.push_back({components[std::size_t(axis)], 1.0});
                estimate.components.push_back(components[std::size_t(axis)]);
            }
            inputs_.quantities.push_back(std::move(quantity));
        }
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index j = 0; j < i; ++j)
                if (components[std::size_t(i)] != InputSet::npos &&
                    components[std::size_t(j)] != InputSet::npos)
                    inputs_.correlations.push_back(
                        {components[std::size_t(j)], components[std::size_t(i)],
                         f.covariance(i, j) / std::sqrt(f.covariance(i, i) * f.covariance(j, j))});
        if (estimate.components.size() > 1) inputs_.variance_estimates.push_back(std::move(estimate));
        add_scaled("R_" + number_of(k), tell<"repeatability of %1">(sheets::label_of(series)), Unit::of("mm"),
                   f.rp, f.law.factor(), series.cycles(), group_of(k));
        if (setup_.has_angles()) add_angles(k);
    }

    void add_angles(std::size_t k) {
        const PoseSeries& series = setup_.series[k];
        const SeriesFigures& f = figures_.series[k];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double u = f.s_angles[Eigen::Index(axis)] / std::sqrt(double(series.cycles()));
            const std::string symbol = std::string(angle_keys[axis]) + "_" + number_of(k);
            UncertaintyComponent component =
                scatter(symbol + ".cycles", tell<"scatter of the cycles">(), u, series.cycles());
            component.unit = Unit::of("deg");
            InputQuantity quantity{
                .symbol = symbol,
                .name = tell<"mean deviation of angle %1 of %2">(angle_keys[axis], sheets::label_of(series)),
                .unit = Unit::of("deg"),
                .offset = f.angles[Eigen::Index(axis)],
                .group = group_of(k)};
            if (u > 0.0) quantity.shares.push_back({inputs_.add(std::move(component)), 1.0});
            inputs_.quantities.push_back(std::move(quantity));
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            add_scaled("R" + std::string(angle_keys[axis]) + "_" + number_of(k),
                       tell<"repeatability of angle %1 of %2">(angle_keys[axis], sheets::label_of(series)),
                       Unit::of("deg"), 3.0 * f.s_angles[Eigen::Index(axis)],
                       sheets::deviation_factor(double(series.cycles() - 1)), series.cycles(), group_of(k));
    }

    UncertaintyComponent of_instrument(std::string id, double u) const {
        UncertaintyComponent component;
        component.id = std::move(id);
        component.name = tell<"instrument and base of the robot">();
        component.unit = Unit::of("mm");
        component.distribution = Distribution::normal(u);
        component.origin = tell<"u of a measured coordinate">();
        return component;
    }

    /// What the instrument and the base add to all cycles of a pose.
    void add_place(std::size_t p) {
        for (const char* axis : axis_keys) {
            const std::string symbol = std::string("e") + axis + "_" + std::to_string(p + 1);
            inputs_.add(
                {.symbol = symbol,
                 .name = tell<"error of the measured place of %1, %2">(setup_.commanded[p].pose, axis),
                 .unit = Unit::of("mm"),
                 .group = own_name<"instrument">()},
                {of_instrument(symbol + ".instrument", setup_.u_place)});
        }
    }

    void add_distance(std::size_t d) {
        const sheets::DistanceFigures& f = figures_.distances[d];
        const std::string symbol = "D_" + std::to_string(d + 1);
        const Name group = own_name<"distance %1">(f.label);
        std::vector<UncertaintyComponent> own{
            of_instrument(symbol + ".instrument", std::sqrt(2.0) * setup_.u_place)};
        if (f.s > 0.0)
            own.push_back(scatter(symbol + ".cycles", tell<"scatter of the cycles">(),
                                  f.s / std::sqrt(double(f.cycles)), f.cycles));
        inputs_.add({.symbol = symbol,
                     .name = tell<"mean distance %1">(f.label),
                     .unit = Unit::of("mm"),
                     .offset = f.mean,
                     .group = group},
                    std::move(own));
        add_scaled("RD_" + std::to_string(d + 1), tell<"repeatability of distance %1">(f.label),
                   Unit::of("mm"), 3.0 * f.s, sheets::deviation_factor(double(f.cycles - 1)), f.cycles,
                   group);
    }

    void add_instrument() {
        const int cycles = setup_.instrument == sheets::InstrumentScatter::stated
                               ? setup_.instrument_cycles
                               : int(setup_.fixed_target.size());
        add_scaled("RP_I", tell<"repeatability of the instrument alone">(), Unit::of("mm"),
                   figures_.instrument->rp, figures_.instrument->law.factor(), cycles,
                   own_name<"instrument">());
    }

    void put(std::string symbol, Message name, const char* unit, Name group) {
        outputs_.push_back({.symbol = std::move(symbol),
                            .name = std::move(name),
                            .unit = Unit::of(unit),
                            .group = std::move(group)});
    }

    void add_outputs(std::size_t k) {
        const Name group = group_of(k);
        put("AP", tell<"accuracy of the pose">(), "mm", group);
        put("RP", tell<"repeatability of the pose">(), "mm", group);
        if (figures_.instrument) {
            put("RP_R", tell<"repeatability of the robot alone">(), "mm", group);
            put("w_I", tell<"share of the instrument in RP²">(), "%", group);
        }
        if (!setup_.has_angles()) return;
        for (const char* a : angle_keys)
            put(std::string("AP_") + a, tell<"accuracy of angle %1">(a), "deg", group);
        for (const char* a : angle_keys)
            put(std::string("RP_") + a, tell<"repeatability of angle %1, ±">(a), "deg", group);
    }

    void add_joint_outputs() {
        for (const auto& series : figures_.directions)
            put("vAP", tell<"variation of the accuracy over the directions of approach">(), "mm",
                own_name<"directions of %1">(sheets::label_of(setup_.series[series.front()])));
        for (const auto& series : figures_.drifts) {
            const Name group = own_name<"drift of %1">(sheets::label_of(setup_.series[series.front()]));
            put("dAP", tell<"drift of the accuracy">(), "mm", group);
            put("dRP", tell<"drift of the repeatability">(), "mm", group);
        }
        for (const sheets::DistanceFigures& f : figures_.distances) {
            const Name group = own_name<"distance %1">(f.label);
            put("AD", tell<"accuracy of the distance">(), "mm", group);
            put("RD", tell<"repeatability of the distance, ±">(), "mm", group);
        }
    }

    RobotPosesSetup setup_;
    RobotPosesFigures figures_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    std::size_t stride_ = 4;  ///< quantities of a series
    std::size_t first_place_ = 0, first_distance_ = 0, instrument_ = 0;
};

std::unique_ptr<MeasurementModel> create_robot_poses(const SetupReader& reader, const AssetLibrary& assets,
                                                     Problems& problems) {
    auto setup = sheets::read_robot_poses_setup(reader, assets, problems);
    if (!setup) return nullptr;
    RobotPosesFigures figures = sheets::figures_of(*setup);
    for (std::size_t k = 0; k < setup->series.size(); ++k) {
        if (figures.instrument && !(figures.series[k].rp > figures.instrument->rp))
            problems.warning(
                sheets::robot_poses_fields().place(&RobotPosesSetup::instrument),
                tell<"the instrument alone scatters as much as what it measured at %1: nothing is left that "
                     "could be called the robot's">(sheets::label_of(setup->series[k])));
    }
    return std::make_unique<RobotPoses>(std::move(*setup), std::move(figures));
}

}  // namespace

ModelDescriptor robot_poses_model() {
    ModelDescriptor d;
    d.id = "robot-pose-performance";
    d.title = "Accuracy and repeatability of poses";
    d.summary =
        "What ISO 9283 asks of a robot, from measured poses: AP and RP, distances, directions of approach, "
        "drift; with the uncertainty that few cycles and the instrument leave, and decisions about a maker's "
        "figures.";
    d.references = {{"ISO 9283:1998"}, {"JCGM 106:2012"}};
    d.equations = robot_poses_equations();
    d.notes = {
        "RP of the standard comes out too small from few cycles: by 2 % from 30 and 7 % from 10, where the "
        "scatter is alike in all directions. The result is multiplied by what that is for the shape of the "
        "scatter seen; the table gives RP as the standard defines it beside it.",
        "Scatter is taken to be normal. The law of RP for the number of cycles and the shape of the scatter "
        "comes from 4,000 simulated campaigns, always the same ones.",
        "Limits and numbers of cycles of the standard are not built in: what is held against a figure is "
        "what is entered. Formulas of directions, distances and drift are those in common use; hold them "
        "against the text of the standard before a sheet names it.",
        "RP² is split between robot and instrument as if both scattered in one shape."};
    d.help_page = "robot-pose-performance.md";
    d.example = "robot-performance.covaria";
    d.schema = sheets::robot_poses_fields().schema();
    d.create = create_robot_poses;
    return d;
}

}  // namespace covaria
