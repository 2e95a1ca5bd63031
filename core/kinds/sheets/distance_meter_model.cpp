// Measurement model "distance meter on a baseline": the model class and its descriptor.
#include <cmath>

#include "core/kinds/sheets/distance_meter_fit.h"
#include "core/kinds/sheets/evidence.h"
#include "core/kinds/sheets/models.h"
#include "core/kinds/sheets/scatter.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using sheets::DistanceMeterFit;
using sheets::DistanceMeterSetup;

const std::vector<ModelEquation>& distance_meter_equations() {
    static const std::vector<ModelEquation> all{
        {"d_i + δ + v_i = |X_b − X_a|,  min Σ v_i²", tell<"all pairs of pillars, ISO 17123-4">()},
        {"s = √(Σ v_i²/ν),  ν = N − n,  u(δ) = s √q_δδ",
         tell<"N distances between n pillars; JCGM 100 H.3.2">()},
        {"u(s) = s/√(2 ν)", tell<"JCGM 100 E.4.3">()},
        {"m = Σ g_j (L_j − (1 + a) X_j)", tell<"scale, by the reference lengths L_j">()}};
    return all;
}

/// The estimates of the fit are its input quantities, correlated by their cofactors: one s for all.
class DistanceMeter : public EquationModel<DistanceMeter> {
public:
    DistanceMeter(DistanceMeterSetup setup, DistanceMeterFit fit)
        : setup_(std::move(setup)),
          fit_(std::move(fit)),
          evidence_(sheets::redundant_readings(setup_, fit_)) {
        add_fit();
        add_scatter();
        if (setup_.with_scale) add_scale();
        add_outputs();
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return sheets::distance_meter_tables(setup_, fit_); }
    std::vector<PlotSpecification> figures() const override {
        return sheets::distance_meter_figures(setup_, fit_);
    }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return evidence_;
    }
    std::vector<ModelEquation> formulas() const override {
        std::vector<ModelEquation> all = distance_meter_equations();
        if (!setup_.with_scale) all.pop_back();
        return all;
    }

    Layout layout(std::span<const double> x) const override {
        Layout layout;
        Eigen::Vector3d before = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < setup_.pillars.size(); ++k) {
            const Eigen::Vector3d here(k == 0 ? 0.0 : x[k - 1], 0.0, 0.0);
            layout.points.push_back({.name = setup_.pillars[k], .kind = PointKind::target, .p_W = here});
            if (k > 0)
                layout.links.push_back(
                    {own_name<"line of the baseline">(), LinkKind::edge, before, here, {}});
            before = here;
        }
        return layout;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const std::size_t lengths = setup_.unknowns() - 1;
        std::size_t output = 0;
        y.set(output++, x[lengths]);
        y.set(output++, x[lengths + 1]);
        if (setup_.with_scale) {
            Real m(0.0);
            for (std::size_t j = 0; j < setup_.reference.size(); ++j) {
                m = m +
                    Real(gain_[Eigen::Index(j)]) *
                        (x[first_reference_ + j] - (Real(1.0) + x[first_reference_ - 1]) * x[length_of_[j]]);
            }
            y.set(output++, m);
        }
        for (std::size_t k = 0; k < lengths; ++k) y.set(output++, x[k]);
        return Real(0.0) == Real(0.0);
    }

private:
    Message origin() const {
        return tell<"least squares, residuals of %1 distances">(setup_.readings.size());
    }

    void add_fit() {
        const auto count = fit_.unknowns.size();
        VarianceEstimate estimate{"distances", {}};
        for (Eigen::Index k = 0; k < count; ++k) {
            const bool is_zero = k + 1 == count;
            const std::string symbol = is_zero ? "delta" : "X_" + std::to_string(k + 2);
            InputQuantity quantity{
                .symbol = symbol,
                .name = is_zero ? tell<"zero offset">()
                                : tell<"place of pillar %1">(setup_.pillars[std::size_t(k) + 1]),
                .unit = Unit::of(is_zero ? "mm" : "m"),
                .offset = fit_.unknowns[k],
                .group = is_zero ? own_name<"instrument">() : own_name<"baseline">()};
            if (fit_.s > 0.0) {
                const std::size_t component = inputs_.add(sheets::residual_component(
                    symbol + ".residuals", Unit::of("mm"), fit_.u(k), fit_.degrees_of_freedom,
                    tell<"scatter of the distances">(), origin()));
                quantity.shares.push_back({component, 1.0});
                estimate.components.push_back(component);
            }
            inputs_.quantities.push_back(std::move(quantity));
        }
        if (estimate.components.empty()) return;
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index j = 0; j < i; ++j)
                inputs_.correlations.push_back(
                    {estimate.components[std::size_t(j)], estimate.components[std::size_t(i)],
                     fit_.cofactors(i, j) / std::sqrt(fit_.cofactors(i, i) * fit_.cofactors(j, j))});
        inputs_.variance_estimates.push_back(std::move(estimate));
    }

    void add_scatter() {
        InputQuantity quantity{.symbol = "s",
                               .name = tell<"standard deviation of one distance">(),
                               .unit = Unit::of("mm"),
                               .offset = fit_.s,
                               .group = own_name<"instrument">()};
        std::vector<UncertaintyComponent> own;
        if (fit_.s > 0.0)
            own.push_back(sheets::deviation_component("s.residuals", Unit::of("mm"), fit_.s,
                                                      fit_.degrees_of_freedom, origin()));
        inputs_.add(std::move(quantity), std::move(own));
    }

    static UncertaintyComponent stated(std::string id, Message name, const char* unit, double u) {
        UncertaintyComponent component;
        component.id = std::move(id);
        component.name = std::move(name);
        component.unit = Unit::of(unit);
        component.distribution = Distribution::normal(u);
        component.origin = tell<"reference lengths and their conditions">();
        return component;
    }

    void add_scale() {
        gain_ = sheets::scale_gain(setup_, fit_);
        const auto& fields = sheets::distance_meter_fields();
        inputs_.add(
            {.symbol = "a",
             .name = tell<"scale of the readings by the atmosphere">(),
             .unit = Unit::of("ppm"),
             .group = own_name<"scale">()},
            {stated("a.stated", tell<"correction for the atmosphere">(), "ppm", setup_.u_atmosphere)});
        const std::size_t common = inputs_.add(
            stated("reference.scale", tell<"scale of the baseline">(), "ppm", setup_.u_reference_scale));
        first_reference_ = inputs_.quantities.size();
        for (std::size_t j = 0; j < setup_.reference.size(); ++j) {
            const sheets::ReferenceLength& reference = setup_.reference[j];
            length_of_.push_back(std::size_t(sheets::unknown_of(setup_, reference)));
            const std::string symbol = "L_" + std::to_string(j + 1);
            InputQuantity quantity{.symbol = symbol,
                                   .name = tell<"reference length of pillar %1">(reference.pillar),
                                   .unit = Unit::of("m"),
                                   .offset = reference.distance,
                                   .group = own_name<"scale">(),
                                   .source = fields.place(&DistanceMeterSetup::reference, j,
                                                          &sheets::ReferenceLength::distance)};
            quantity.shares.push_back({common, reference.distance});
            quantity.shares.push_back(
                {inputs_.add(stated(symbol + ".stated", tell<"reference length">(), "mm", reference.u)),
                 1.0});
            inputs_.quantities.push_back(std::move(quantity));
        }
    }

    void add_outputs() {
        const auto add = [&](std::string symbol, Message name, const char* unit, Name group,
                             OutputRole role) {
            outputs_.push_back({.symbol = std::move(symbol),
                                .name = std::move(name),
                                .unit = Unit::of(unit),
                                .group = std::move(group),
                                .role = role});
        };
        const Name instrument = own_name<"instrument">();
        add("delta", tell<"zero offset, added to a reading">(), "mm", instrument, OutputRole::measurand);
        add("s", tell<"standard deviation of one distance">(), "mm", own_name<"scatter">(),
            OutputRole::measurand);
        if (setup_.with_scale)
            add("m", tell<"scale correction, times a reading">(), "ppm", own_name<"scale">(),
                OutputRole::measurand);
        for (std::size_t k = 1; k < setup_.pillars.size(); ++k)
            add("X_" + std::to_string(k + 1), tell<"place of pillar %1">(setup_.pillars[k]), "m",
                own_name<"baseline">(), OutputRole::intermediate);
    }

    DistanceMeterSetup setup_;
    DistanceMeterFit fit_;
    std::shared_ptr<const evidence::RedundantReadings> evidence_;  ///< null: nothing is stated
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    Eigen::VectorXd gain_;
    std::size_t first_reference_ = 0;
    std::vector<std::size_t> length_of_;  ///< the unknown that each reference length is of
};

std::unique_ptr<MeasurementModel> create_distance_meter(const SetupReader& reader, const AssetLibrary& assets,
                                                        Problems& problems) {
    auto setup = sheets::read_distance_meter_setup(reader, assets, problems);
    if (!setup) return nullptr;
    auto fit = sheets::fit_of(*setup);
    if (!fit) {
        problems.error(sheets::distance_meter_fields().place(&DistanceMeterSetup::readings),
                       tell<"the readings do not tell the zero offset from the lengths: some line of three "
                            "pillars must be read whole and in parts">());
        return nullptr;
    }
    return std::make_unique<DistanceMeter>(std::move(*setup), std::move(*fit));
}

}  // namespace

ModelDescriptor distance_meter_model() {
    ModelDescriptor d;
    d.id = "distance-meter-baseline";
    d.title = "Distance meter on a baseline";
    d.summary =
        "Zero offset and standard deviation of a distance meter from distances between all pairs of pillars "
        "on a line, with their uncertainties, and the statistical tests of ISO 17123-4; its scale, where "
        "lengths of the baseline are known.";
    d.references = {{"ISO 17123-4:2012"}, {"JCGM 100:2008 (GUM), E.4.3, H.3"}};
    d.equations = distance_meter_equations();
    d.notes = {
        "All pairs of n pillars, read once each: the cofactor of the zero offset is 6/((n − 1)(n − 2)) "
        "whatever the lengths, and there are n (n − 1)/2 − n degrees of freedom.",
        "Limits of the tests are quantiles of chi-squared, F and t for the degrees of freedom that the "
        "readings have, not figures of a table.",
        "Any set of readings that tells the unknowns is adjusted, also one with pairs left out or repeated; "
        "readings that repeat without the instrument set up anew agree better than the instrument does.",
        "Distances count with equal weights."};
    d.help_page = "distance-meter-baseline.md";
    d.example = "distance-meter.covaria";
    d.decides = true;
    d.schema = sheets::distance_meter_fields().schema();
    d.create = create_distance_meter;
    return d;
}

}  // namespace covaria
