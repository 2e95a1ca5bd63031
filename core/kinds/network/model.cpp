// Measurement model "points from sensors": the model class and its descriptor.
#include "core/kinds/network/model.h"

#include <future>
#include <mutex>

#include "core/base/name.h"
#include "core/kinds/network/equations.h"
#include "core/kinds/network/sensitivities.h"
#include "core/kinds/network/sensor_evidence.h"
#include "core/kinds/points/output_points.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

class PointsFromSensors : public EquationModel<PointsFromSensors> {
public:
    PointsFromSensors(network::NetworkSetup setup, InputSet inputs)
        : setup_(std::move(setup)), inputs_(std::move(inputs)) {
        const Unit mm = Unit::of("mm");
        for (const network::Target& target : setup_.targets)
            for (const std::string axis : {"x", "y", "z"})
                outputs_.push_back({.symbol = axis,
                                    .name = tell<"%1, coordinate %2">(target.name, axis),
                                    .unit = mm,
                                    .group = target.name});
        for (const network::Distance& distance : setup_.distances) {
            const std::string from = setup_.targets[distance.from].name,
                              to = setup_.targets[distance.to].name;
            outputs_.push_back({.symbol = from + to,
                                .name = tell<"distance from %1 to %2">(from, to),
                                .unit = mm,
                                .group = own_name<"distances">()});
        }
        for (const network::Angle& angle : setup_.angles) {
            const auto name = [&](std::size_t t) { return setup_.targets[t].name; };
            outputs_.push_back(
                {.symbol = name(angle.from) + name(angle.at) + name(angle.to),
                 .name = tell<"angle at %1 from %2 to %3">(name(angle.at), name(angle.from), name(angle.to)),
                 .unit = Unit::of("deg"),
                 .group = own_name<"angles">()});
        }
        for (const network::TargetFrame& frame : setup_.frames) add_frame(frame.name);
        for (const network::ScaleBar& bar : setup_.bars)
            outputs_.push_back({.symbol = "Δ" + setup_.targets[bar.from].name + setup_.targets[bar.to].name,
                                .name = tell<"%1, measured minus calibrated length">(bar.name),
                                .unit = Unit::of("mm"),
                                .group = own_name<"calibrated lengths">()});
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double> x) const override { return network::network_layout(setup_, x); }
    bool sensitivities(std::span<const double> x, SensitivityRows& rows) const override {
        return network::network_sensitivities(setup_, x, rows);
    }
    std::vector<Table> evaluation() const override { return network::network_evaluation(setup_); }

    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        std::call_once(asked_, [this] { evidence_ = network::sensor_evidence(setup_); });
        return evidence_;
    }
    std::shared_ptr<const Asset> as_asset(const std::string& id) const override {
        return std::make_shared<OutputPoints>(id, outputs_);
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        return network::all_targets<Real>(setup_, x, y);
    }

private:
    void add_frame(const std::string& name) {
        for (const std::string axis : {"x", "y", "z"})
            outputs_.push_back({.symbol = axis,
                                .name = tell<"origin of %1, coordinate %2">(name, axis),
                                .unit = Unit::of("mm"),
                                .group = name});
        static constexpr const char* angles[] = {"alpha", "beta", "gamma"};
        static constexpr const char* axes[] = {"x", "y", "z"};
        for (std::size_t i = 0; i < 3; ++i)
            outputs_.push_back({.symbol = angles[i],
                                .name = tell<"rotation of %1 about %2">(name, axes[i]),
                                .unit = Unit::of("deg"),
                                .group = name,
                                .periodic = true});
    }

    network::NetworkSetup setup_;
    InputSet inputs_;
    mutable std::once_flag asked_;
    mutable std::shared_ptr<const evidence::RedundantReadings> evidence_;  ///< null: nothing is redundant
    std::vector<OutputQuantity> outputs_;
};

/// An error where a sensor looks the other way from where its readings find a target.
void check_directions(const network::NetworkSetup& setup, Problems& problems) {
    for (const network::Target& target : setup.targets)
        for (const network::Sight& sight : target.sights) {
            if (!sight.has[1] || !sight.has[2]) continue;
            const Eigen::Vector3d v = setup.station(target, sight).in_axes(target.nominal);
            const network::ReadDirections<double> e(sight.reading[1], sight.reading[2]);
            if (e.r.dot(v) < 0.0)
                problems.error(sight.source[1],
                               tell<"%1 looks away from target %2: its angles point to the opposite side">(
                                   setup.sensors[sight.sensor].name, target.name));
        }
}

constexpr std::size_t most_sights_one_by_one = 1000;

std::unique_ptr<MeasurementModel> measured_network(network::NetworkSetup setup, Problems& problems) {
    network::locate(setup, problems);
    if (!problems.has_errors()) check_directions(setup, problems);
    if (problems.has_errors()) return nullptr;
    network::check_residuals(setup, problems);
    InputSet inputs = network::network_inputs(setup);
    return std::make_unique<PointsFromSensors>(std::move(setup), std::move(inputs));
}

std::unique_ptr<MeasurementModel> create_network_model(const SetupReader& reader, const AssetLibrary& assets,
                                                       Problems& problems) {
    std::optional<network::NetworkSetup> setup = network::read_network_setup(reader, assets, problems);
    if (!setup) return nullptr;
    network::number_inputs(*setup);
    network::divide_set_ups(*setup, problems);
    if (problems.has_errors()) return nullptr;
    if (setup->measured) return measured_network(std::move(*setup), problems);
    // The weights are written where the inputs do not look: of a large network at once.
    const auto make_inputs = [&] { return network::network_inputs(*setup); };
    const bool large = setup->targets.size() * setup->sensors.size() > most_sights_one_by_one;
    std::future<InputSet> inputs =
        std::async(large ? std::launch::async : std::launch::deferred, make_inputs);
    network::find_weights(*setup, problems);
    if (problems.has_errors()) return nullptr;
    InputSet made = inputs.get();
    return std::make_unique<PointsFromSensors>(std::move(*setup), std::move(made));
}

std::vector<ModelEquation> network_equations() {
    const std::string paper = "Galetto et al., ";
    return {{"X = X₀ + R v,  R = Rx(ω) Ry(φ) Rz(κ)", paper + "section 2 (or Z-Y-X angles)"},
            {"d = |v|,  θ = atan2(v_y, v_x),  φ = atan2(v_z, √(v_x² + v_y²))", paper + "section 2"},
            {"(R e_r)ᵀX = (R e_r)ᵀX₀ + d,  (R e_θ)ᵀX = (R e_θ)ᵀX₀,  (R e_φ)ᵀX = (R e_φ)ᵀX₀",
             paper + "Eq 1, M X = B"},
            {"X = (MᵀM)⁻¹ MᵀB", paper + "Eq 3"},
            {"W = (D Σ Dᵀ)⁻¹,  D = ∂F/∂S", paper + "Eq 2, corrected"},
            {"X = (MᵀW M)⁻¹ MᵀW B", paper + "Eq 4"},
            {"U_X = (MᵀW M)⁻¹", paper + "Eq 5: readings alone"},
            {"C_X = A (Σ_readings + F Fᵀ) Aᵀ,  A = (JᵀW J)⁻¹ JᵀW",
             "law of propagation with the stations, F: shared"},
            {tell<"min Σ w (reading − h(X))²">(), "non-linear least squares, Gauss-Newton method"},
            {"Δ = |X_b − X_a| − L", "a calibrated length as check; as constraint L is one more reading"}};
}

std::vector<std::string> network_notes() {
    return {
        "The uncertainty of the stations does not contribute marginally to the position of a target, as the "
        "paper "
        "says: only distances within one set-up are nearly free of it. Eq 5 is the precision of the "
        "readings; it "
        "is shown beside the total, never as the uncertainty of a position.",
        "Weights from the readings alone, as in the paper, are inefficient for positions; those with the "
        "stations "
        "are the default.",
        "Eq 2 is corrected: D holds equations by readings; as printed it is transposed.",
        "The linearised equations have the measured angles in M: their estimate shrinks towards the sensors, "
        "the "
        "non-linear one moves outwards by half as much. It matters beyond a milliradian (3.5 mrad, cameras "
        "alone: "
        "−6.9 mm against +3.3 mm) and not for the paper's network.",
        "Stations are located once for a set-up: all its targets share their deviations. \"New set-up\" at a "
        "target "
        "draws them anew.",
        "A distance without angles has no linear equation; the non-linear estimator uses it, from the "
        "nominal "
        "coordinates as start.",
        "A calibrated length as a check is not used in the estimation: its difference is to be judged by its "
        "uncertainty. As a constraint it carries its own uncertainty; a scale that the instruments share is "
        "corrected by it.",
        "With more than 600 readings in one set-up each target is estimated by itself, weighted with the "
        "stations.",
        "Azimuths may be given with any number of whole turns."};
}

}  // namespace

ModelDescriptor points_from_sensors_model() {
    ModelDescriptor d;
    d.id = "points-from-sensors";
    d.title = "Points from sensors";
    d.summary =
        "Coordinates of targets and distances between them, measured by any mix of trackers, total stations, "
        "cameras "
        "and distance meters placed in space.";
    d.references = {{"M. Galetto, L. Mastrogiacomo, D. A. Maisano, F. Franceschini: Uncertainty evaluation "
                     "of distributed "
                     "Large-Scale-Metrology systems by a Monte Carlo approach"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = network_equations();
    d.notes = network_notes();
    d.help_page = "points-from-sensors.md";
    d.example = "lsm-network.covaria";
    d.capabilities = {"point-uncertainty"};
    d.schema = network::network_fields().schema();
    d.create = create_network_model;
    return d;
}

}  // namespace covaria
