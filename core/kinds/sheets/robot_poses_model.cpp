// Measurement model "accuracy and repeatability of poses": the model class and its descriptor.
#include <cmath>

#include "core/kinds/sheets/robot_poses_inputs.h"
#include "core/kinds/sheets/robot_poses_model.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using sheets::RobotPosesFigures;
using sheets::RobotPosesSetup;

constexpr double nothing_square = 1e-36;  ///< m^2: keeps the derivative of a root finite

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

OutputQuantity performance_output(std::string symbol, Message name, const char* unit, Name group) {
    return {.symbol = std::move(symbol),
            .name = std::move(name),
            .unit = Unit::of(unit),
            .group = std::move(group)};
}

void add_outputs_of(const RobotPosesSetup& setup, const RobotPosesFigures& figures, std::size_t k,
                    std::vector<OutputQuantity>& outputs) {
    const Name group = sheets::group_of(setup.series[k]);
    const auto put = [&](std::string symbol, Message name, const char* unit) {
        outputs.push_back(performance_output(std::move(symbol), std::move(name), unit, group));
    };
    put("AP", tell<"accuracy of the pose">(), "mm");
    put("RP", tell<"repeatability of the pose">(), "mm");
    if (figures.is_split[k]) {
        put("RP_R", tell<"repeatability of the robot alone">(), "mm");
        put("w_I", tell<"share of the instrument in RP²">(), "%");
    }
    if (!setup.has_angles()) return;
    for (const char* a : sheets::pose_angles)
        put(std::string("AP_") + a, tell<"accuracy of angle %1">(a), "deg");
    for (const char* a : sheets::pose_angles)
        put(std::string("RP_") + a, tell<"repeatability of angle %1, ±">(a), "deg");
}

std::vector<OutputQuantity> performance_outputs(const RobotPosesSetup& setup,
                                                const RobotPosesFigures& figures) {
    std::vector<OutputQuantity> outputs;
    for (std::size_t k = 0; k < setup.series.size(); ++k) add_outputs_of(setup, figures, k, outputs);
    const auto put = [&](const char* symbol, Message name, const Name& group) {
        outputs.push_back(performance_output(symbol, std::move(name), "mm", group));
    };
    for (const auto& series : figures.directions)
        put("vAP", tell<"variation of the accuracy over the directions of approach">(),
            own_name<"directions of %1">(sheets::label_of(setup.series[series.front()])));
    for (const auto& series : figures.drifts) {
        const Name group = own_name<"drift of %1">(sheets::label_of(setup.series[series.front()]));
        put("dAP", tell<"drift of the accuracy">(), group);
        put("dRP", tell<"drift of the repeatability">(), group);
    }
    for (const sheets::DistanceFigures& f : figures.distances) {
        const Name group = own_name<"distance %1">(f.label);
        put("AD", tell<"accuracy of the distance">(), group);
        put("RD", tell<"repeatability of the distance, ±">(), group);
    }
    return outputs;
}

/// Barycentres with the scatter of their cycles, RP with the law of few cycles, the instrument's share.
class RobotPoses : public EquationModel<RobotPoses> {
public:
    RobotPoses(RobotPosesSetup setup, RobotPosesFigures figures)
        : setup_(std::move(setup)),
          figures_(std::move(figures)),
          at_(sheets::performance_inputs(setup_, figures_)),
          outputs_(performance_outputs(setup_, figures_)) {}

    const InputSet& inputs() const override { return at_.set; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return sheets::robot_poses_tables(setup_, figures_); }
    std::vector<PlotSpecification> figures() const override {
        return sheets::robot_poses_plots(setup_, figures_);
    }

    Layout layout(std::span<const double> x) const override {
        Layout layout;
        layout.frames.push_back({own_name<"base of the robot">()});
        for (std::size_t k = 0; k < setup_.series.size(); ++k) {
            const std::size_t i = k * at_.stride;
            layout.points.push_back(
                {.name = sheets::label_of(setup_.series[k]),
                 .kind = PointKind::tool,
                 .p_W = setup_.series[k].commanded + Eigen::Vector3d(x[i], x[i + 1], x[i + 2]),
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
            y.set(output++, abs(Real(x[at_.first_distance + 2 * d])));
            y.set(output++, x[at_.first_distance + 2 * d + 1]);
        }
        return Real(0.0) == Real(0.0);
    }

private:
    std::size_t ap_output(std::size_t series) const {
        std::size_t output = series * (2 + (setup_.has_angles() ? 6 : 0));
        for (std::size_t k = 0; k < series; ++k) output += figures_.is_split[k] ? 2 : 0;
        return output;
    }

    template <class Real>
    std::size_t one_series(const Inputs<Real>& x, Outputs<Real>& y, std::size_t k, std::size_t output) const {
        using namespace real_functions;
        const std::size_t i = k * at_.stride, place = at_.first_place + 3 * figures_.series[k].pose;
        Real square(0.0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Real d = x[i + axis] + x[place + axis];
            square = square + d * d;
        }
        y.set(output++, sqrt(max(square, Real(nothing_square))));
        y.set(output++, x[i + 3]);
        if (figures_.is_split[k]) {
            const Real whole = x[i + 3] * x[i + 3], own = x[at_.instrument] * x[at_.instrument];
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
            const Real d = x[k * at_.stride + axis] - x[l * at_.stride + axis];
            square = square + d * d;
        }
        return square;
    }

    RobotPosesSetup setup_;
    RobotPosesFigures figures_;
    sheets::PerformanceInputs at_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_robot_poses(const SetupReader& reader, const AssetLibrary& assets,
                                                     Problems& problems) {
    auto setup = sheets::read_robot_poses_setup(reader, assets, problems);
    if (!setup) return nullptr;
    RobotPosesFigures figures = sheets::figures_of(*setup);
    for (std::size_t k = 0; k < setup->series.size(); ++k) {
        if (figures.instrument && !figures.is_split[k])
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
        "comes from up to 4,000 simulated campaigns, always the same ones.",
        "Limits and numbers of cycles of the standard are not built in: what is held against a figure is "
        "what is entered. Formulas of directions, distances and drift are those in common use; hold them "
        "against the text of the standard before a sheet names it.",
        "RP² is split between robot and instrument as if both scattered in one shape."};
    d.help_page = "robot-pose-performance.md";
    d.example = "robot-performance.covaria";
    d.decides = true;
    d.schema = sheets::robot_poses_fields().schema();
    d.create = create_robot_poses;
    return d;
}

}  // namespace covaria
