// Measurement model "force-proving instrument": the model class and its descriptor.
#include <algorithm>
#include <cmath>

#include "core/kinds/sheets/models.h"
#include "core/kinds/sheets/proving_figures.h"
#include "core/kinds/sheets/scatter.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using sheets::ForcePart;
using sheets::ProvingFigures;
using sheets::ProvingSetup;
using sheets::StepFigures;

const std::vector<ModelEquation>& proving_equations() {
    static const std::vector<ModelEquation> all{
        {"X = i − i_0,  X̄ = (X_1 + X_3 + X_5)/3", tell<"deflection, mean of the rotations">()},
        {"b = (X_max − X_min)/X̄,  b′ = |X_2 − X_1|/X̄_12,  v = (|X_4′ − X_3|/X_3 + |X_6′ − X_5|/X_5)/2",
         tell<"reproducibility, repeatability and reversibility errors, ISO 376">()},
        {"f_c = (X̄ − X_a)/X_a,  f_0 = (i_f − i_0)/X_N,  c = |i_300 − i_30|/X_N",
         tell<"interpolation, zero and creep errors, ISO 376">()},
        {"X_a(F) = Σ A_k F^k,  min Σ (X̄ − X_a)²", tell<"interpolation, degree 1 to 3">()},
        {"w² = w_1² + Σ (X_i − X̄)²/(6 X̄²) + b′²/3 + (r/X)²/6 + c²/3 + f_0² + (K ΔT)²/3 + w_8²",
         tell<"machine, reproducibility, repeatability, resolution, creep, zero, temperature, interpolation, "
              "EURAMET cg-4; (v/divisor)² for decreasing forces">()},
        {"w_8 = √(Σ (X̄ − X_a)²/ν)/X_N,  W = k w", tell<"ν forces less coefficients">()}};
    return all;
}

/// Each mean deflection is a quantity with its parts as components; what acts at all forces alike is one.
class ForceProving : public EquationModel<ForceProving> {
public:
    ForceProving(ProvingSetup setup, ProvingFigures figures)
        : setup_(std::move(setup)), figures_(std::move(figures)) {
        add_common();
        for (std::size_t i = 0; i < setup_.steps.size(); ++i) add_deflection(i);
        for (std::size_t i = 0; i < setup_.steps.size(); ++i) add_residual(i);
        add_outputs();
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return sheets::proving_tables(setup_, figures_); }
    std::vector<PlotSpecification> figures() const override {
        return sheets::proving_plots(setup_, figures_);
    }
    Layout layout(std::span<const double>) const override { return {}; }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const std::size_t steps = setup_.steps.size();
        for (std::size_t i = 0; i < steps; ++i) y.set(i, x[i] + x[steps + i]);
        for (Eigen::Index k = 0; k < gain_.rows(); ++k) {
            Real sum(0.0);
            for (std::size_t i = 0; i < steps; ++i) sum = sum + Real(gain_(k, Eigen::Index(i))) * x[i];
            y.set(steps + std::size_t(k), sum);
        }
        return Real(0.0) == Real(0.0);
    }

private:
    /// A component of relative uncertainty that all steps share; npos: there is none of it.
    struct Shared {
        std::size_t component = InputSet::npos;
        double u = 0.0;
    };

    static UncertaintyComponent relative(std::string id, Message name, Distribution distribution,
                                         Message origin) {
        UncertaintyComponent component;
        component.id = std::move(id);
        component.name = std::move(name);
        component.unit = Unit::of("%");
        component.distribution = std::move(distribution);
        component.origin = std::move(origin);
        return component;
    }
    static Distribution rectangular(double half_width) {
        return Distribution::of(Rectangular{-half_width, half_width});
    }

    Shared share(UncertaintyComponent component, double u) {
        return u > 0.0 ? Shared{inputs_.add(std::move(component)), u} : Shared{};
    }

    void add_common() {
        double largest = 0.0;
        for (const StepFigures& s : figures_.steps) largest = std::max(largest, s.part(ForcePart::machine));
        UncertaintyComponent machine =
            relative("machine", tell<"force of the calibration machine">(), Distribution::normal(largest),
                     setup_.machine ? tell<"calibration machine '%1'">(setup_.machine.name)
                                    : tell<"uncertainties of the forces">());
        if (setup_.machine) {
            machine.contributor = setup_.machine.id;
            machine.contributor_name = setup_.machine.name;
        }
        machine_ = share(std::move(machine), largest);
        const double c = figures_.c.value_or(0.0), f_0 = std::abs(figures_.f_0.value_or(0.0));
        creep_ = share(
            relative("creep", tell<"creep">(), rectangular(c), tell<"indications after 30 s and 300 s">()),
            c);
        zero_ = share(relative("zero", tell<"zero error">(), Distribution::normal(f_0),
                               tell<"largest change of the indication without load">()),
                      f_0);
        const double t = setup_.temperature_coefficient * setup_.temperature_half_width;
        temperature_ = share(relative("temperature", tell<"temperature of the instrument">(), rectangular(t),
                                      tell<"temperature coefficient and half width">()),
                             t);
        add_rotations();
    }

    /// Contrasts of the three rotations: two components, whose factors at the steps keep the covariance of
    /// the means of the series that was seen, with two degrees of freedom.
    void add_rotations() {
        for (const StepFigures& s : figures_.steps)
            turned_u_ = std::max(turned_u_, std::hypot(s.turned[0], s.turned[1]));
        if (!(turned_u_ > 0.0)) return;
        for (std::size_t k = 0; k < 2; ++k)
            turned_[k] = inputs_.add(type_a("rotations." + std::to_string(k + 1), turned_u_, 2.0,
                                            tell<"reproducibility with rotation">(),
                                            tell<"three positions of the instrument">()));
        inputs_.variance_estimates.push_back({"rotations", {turned_[0], turned_[1]}});
    }

    UncertaintyComponent type_a(std::string id, double u, double degrees_of_freedom, Message name,
                                Message origin) const {
        UncertaintyComponent component = sheets::residual_component(
            std::move(id), Unit::of("mV/V"), u, degrees_of_freedom, std::move(name), std::move(origin));
        component.normal_draws = !setup_.student_t;
        if (component.normal_draws) component.distribution = Distribution::normal(u);
        return component;
    }

    std::string number(std::size_t i) const { return std::to_string(i + 1); }

    void add_deflection(std::size_t i) {
        const StepFigures& step = figures_.steps[i];
        const std::string label = setup_.label(setup_.steps[i]), symbol = "X_" + number(i);
        InputQuantity quantity{.symbol = symbol,
                               .name = tell<"mean deflection at %1">(label),
                               .unit = Unit::of("mV/V"),
                               .offset = step.mean,
                               .group = own_name<"force %1">(label)};
        const auto add = [&](std::size_t component, double factor) {
            if (component != InputSet::npos && factor != 0.0) quantity.shares.push_back({component, factor});
        };
        if (machine_.u > 0.0) add(machine_.component, step.mean * step.part(ForcePart::machine) / machine_.u);
        for (const Shared& shared : {creep_, zero_, temperature_}) add(shared.component, step.mean);
        if (turned_u_ > 0.0)
            for (std::size_t k = 0; k < 2; ++k) add(turned_[k], step.turned[k] / turned_u_);
        const auto own = [&](const char* what, Message name, Distribution distribution, double u,
                             Message origin) {
            if (u > 0.0)
                add(inputs_.add(
                        relative(symbol + what, std::move(name), std::move(distribution), std::move(origin))),
                    step.mean);
        };
        const double r = setup_.resolution / std::abs(step.mean), v = step.part(ForcePart::reversibility);
        own(".repeatability", tell<"repeatability without rotation">(), rectangular(step.b_same), step.b_same,
            tell<"two series in one position">());
        own(".resolution", tell<"resolution of the indicator">(), Distribution::of(Triangular{-r, r}), r,
            tell<"difference of two indications">());
        own(".reversibility", tell<"reversibility">(), Distribution::normal(v), v,
            tell<"decreasing against increasing force">());
        inputs_.quantities.push_back(std::move(quantity));
    }

    void add_residual(std::size_t i) {
        const StepFigures& step = figures_.steps[i];
        const std::string label = setup_.label(setup_.steps[i]), symbol = "r_" + number(i);
        InputQuantity quantity{.symbol = symbol,
                               .name = tell<"interpolated less mean deflection at %1">(label),
                               .unit = Unit::of("mV/V"),
                               .offset = step.fitted - step.mean,
                               .group = own_name<"force %1">(label)};
        const double u = step.part(ForcePart::interpolation) * std::abs(step.mean);
        if (u > 0.0) {
            quantity.shares.push_back(
                {inputs_.add(type_a(symbol + ".residuals", u, setup_.degrees_of_freedom(),
                                    tell<"interpolation">(),
                                    tell<"residuals of %1 forces">(setup_.steps.size()))),
                 1.0});
            inputs_.rest_on_estimate("interpolation", quantity.shares.back().component);
        }
        inputs_.quantities.push_back(std::move(quantity));
    }

    void add_outputs() {
        for (const sheets::ForceStep& step : setup_.steps)
            outputs_.push_back({.symbol = "X_a",
                                .name = tell<"interpolated deflection at %1">(setup_.label(step)),
                                .unit = Unit::of("mV/V"),
                                .group = own_name<"force %1">(setup_.label(step))});
        gain_ = figures_.gain;
        for (Eigen::Index k = 0; k < gain_.rows(); ++k) {
            const std::size_t power = setup_.first_power() + std::size_t(k);
            gain_.row(k) /= std::pow(setup_.largest_force(), double(power));
            outputs_.push_back({.symbol = "A_" + std::to_string(power),
                                .name = tell<"coefficient of F to the power %1">(power),
                                .unit = sheets::per_force("mV/V", setup_.force_unit, power),
                                .group = own_name<"interpolation">()});
        }
    }

    ProvingSetup setup_;
    ProvingFigures figures_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    Eigen::MatrixXd gain_;  ///< [power][step], SI
    Shared machine_, creep_, zero_, temperature_;
    std::array<std::size_t, 2> turned_{InputSet::npos, InputSet::npos};
    double turned_u_ = 0.0;  ///< u of each component of the rotations
};

std::unique_ptr<MeasurementModel> create_proving(const SetupReader& reader, const AssetLibrary& assets,
                                                 Problems& problems) {
    auto setup = sheets::read_proving_setup(reader, assets, problems);
    if (!setup) return nullptr;
    ProvingFigures figures = sheets::figures_of(*setup);
    return std::make_unique<ForceProving>(std::move(*setup), std::move(figures));
}

}  // namespace

ModelDescriptor force_proving_model() {
    ModelDescriptor d;
    d.id = "force-proving-instrument";
    d.title = "Force-proving instrument";
    d.summary =
        "Errors of a force transducer as ISO 376 has them, from indications under calibration forces in "
        "three positions, its interpolation with covariance, W over the force with all its parts as EURAMET "
        "cg-4 combines them, and its class by limits that are entered.";
    d.references = {{"ISO 376"}, {"EURAMET cg-4"}, {"JCGM 100:2008 (GUM)"}};
    d.equations = proving_equations();
    d.notes = {
        "Formulas are those in common use; hold them against the texts of ISO 376 and EURAMET cg-4 before a "
        "certificate names them. Limits of classes are not built in.",
        "W of the table has the coverage factor that is entered. Results have the one of their degrees of "
        "freedom: three rotations leave two, which k = 2 does not know.",
        "The uncertainty of the machine's force, creep, zero and temperature act at all forces alike and are "
        "common to them; the rotations keep the covariance between the forces that was seen. What is read at "
        "one force is its own.",
        "The coefficients have the covariance of the mean deflections; the residuals of the interpolation "
        "count at the forces, not in the coefficients.",
        "Drift since the calibration, another indicator and other conditions of use are not part of W."};
    d.help_page = "force-proving-instrument.md";
    d.example = "force-transducer.covaria";
    d.schema = sheets::proving_fields().schema();
    d.create = create_proving;
    return d;
}

}  // namespace covaria
