// Measurement model "theodolite in rounds": the model class and its descriptor.
#include <algorithm>
#include <cmath>

#include "core/kinds/sheets/evidence.h"
#include "core/kinds/sheets/models.h"
#include "core/kinds/sheets/theodolite_fit.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using sheets::PooledScatter;
using sheets::TheodoliteFit;
using sheets::TheodoliteSetup;

constexpr double sight_length = 20.0;  ///< of the picture: the sheet knows no distances, m

const std::vector<ModelEquation>& theodolite_equations() {
    static const std::vector<ModelEquation> all{
        {"(Hz_I + Hz_II ± 180°)/2 + v = o_set + a_target,  min Σ v²",
         tell<"directions of each series, mean of both faces">()},
        {"(V_I − V_II + 360°)/2 + v = z_target,  min Σ v²", tell<"zenith angles of each series">()},
        {"s = √(Σ v²/ν),  u(s) = s/√(2 ν)",
         tell<"pooled over the series, ν readings less unknowns; JCGM 100 H.3.2, E.4.3">()},
        {"i = (V_I + V_II − 360°)/2,  δ = ī,  u(δ) = s_i/√N",
         tell<"index error, s_i within the series; JCGM 100 4.2.3">()}};
    return all;
}

/// The figures of the fit are the input quantities and the outputs.
class TheodoliteRounds : public EquationModel<TheodoliteRounds> {
public:
    TheodoliteRounds(TheodoliteSetup setup, TheodoliteFit fit)
        : setup_(std::move(setup)),
          fit_(std::move(fit)),
          evidence_(sheets::redundant_readings(setup_, fit_)) {
        add_deviation("s_Hz", tell<"standard deviation of a direction, measured once in both faces">(),
                      fit_.directions_pooled);
        add_deviation("s_V", tell<"standard deviation of a zenith angle, measured once in both faces">(),
                      fit_.zeniths_pooled);
        if (fit_.index.scatter) add_index();
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return sheets::theodolite_tables(setup_, fit_); }
    std::vector<PlotSpecification> figures() const override { return sheets::theodolite_figures(fit_); }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return evidence_;
    }

    Layout layout(std::span<const double>) const override {
        Layout layout;
        layout.bodies.push_back(
            {.name = own_name<"theodolite">(), .kind = BodyKind::instrument, .glyph = "total-station"});
        for (std::size_t i = 0; i < setup_.readings.size(); ++i) {
            const sheets::FaceReadings& r = setup_.readings[i];
            const auto& first = setup_.readings.front();
            if (r.series != first.series || r.set != first.set) continue;
            const double zenith = r.has_zeniths() ? r.zenith() : std::acos(0.0);
            const Eigen::Vector3d place =
                sight_length * Eigen::Vector3d(std::sin(zenith) * std::cos(fit_.directions[i]),
                                               -std::sin(zenith) * std::sin(fit_.directions[i]),
                                               std::cos(zenith));
            layout.points.push_back({.name = r.target, .kind = PointKind::target, .p_W = place});
            layout.links.push_back({r.target, LinkKind::sight_line, Eigen::Vector3d::Zero(), place, {}});
        }
        layout.notes.push_back(tell<"Targets stand in their directions; how far they are is not known.">());
        return layout;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        for (std::size_t i = 0; i < outputs_.size(); ++i) y.set(i, x[i]);
        return Real(0.0) == Real(0.0);
    }

private:
    void add(std::string symbol, Message name, double estimate,
             std::vector<UncertaintyComponent> components) {
        inputs_.add({.symbol = symbol,
                     .name = name,
                     .unit = Unit::of("arcsec"),
                     .offset = estimate,
                     .group = own_name<"instrument">()},
                    std::move(components));
        outputs_.push_back({.symbol = std::move(symbol),
                            .name = std::move(name),
                            .unit = Unit::of("arcsec"),
                            .group = own_name<"instrument">()});
    }

    void add_deviation(std::string symbol, Message name, const PooledScatter& found) {
        if (!found) return;
        std::vector<UncertaintyComponent> own;
        if (found.squares > 0.0)
            own.push_back(sheets::deviation_component(
                symbol + ".residuals", Unit::of("arcsec"), found.s(), found.degrees_of_freedom,
                tell<"least squares of the rounds, residuals of %1 series">(fit_.series.size())));
        add(std::move(symbol), std::move(name), found.s(), std::move(own));
    }

    void add_index() {
        std::vector<UncertaintyComponent> own;
        if (fit_.index.scatter.squares > 0.0)
            own.push_back(sheets::residual_component(
                "delta.readings", Unit::of("arcsec"), fit_.u_index(), fit_.index.scatter.degrees_of_freedom,
                tell<"scatter of the index">(), tell<"mean of %1 readings in both faces">(fit_.index.count)));
        add("delta", tell<"index error of the vertical circle">(), fit_.index.mean, std::move(own));
    }

    TheodoliteSetup setup_;
    TheodoliteFit fit_;
    std::shared_ptr<const evidence::RedundantReadings> evidence_;  ///< null: nothing is stated
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_theodolite(const SetupReader& reader, const AssetLibrary& assets,
                                                    Problems& problems) {
    auto setup = sheets::read_theodolite_setup(reader, assets, problems);
    if (!setup) return nullptr;
    TheodoliteFit fit = sheets::fit_of(*setup);
    const std::string place = sheets::theodolite_fields().place(&TheodoliteSetup::readings);
    const auto reads = [&](bool (sheets::FaceReadings::*has)() const) {
        return std::ranges::any_of(setup->readings, [&](const auto& r) { return (r.*has)(); });
    };
    if (reads(&sheets::FaceReadings::has_directions) && !fit.directions_pooled)
        problems.error(place, tell<"the directions leave nothing that would tell their scatter: read two "
                                   "targets or more in two sets or more">());
    if (reads(&sheets::FaceReadings::has_zeniths) && !fit.zeniths_pooled)
        problems.error(place, tell<"the zenith angles leave nothing that would tell their scatter: read "
                                   "targets in two sets or more">());
    if (problems.has_errors()) return nullptr;
    return std::make_unique<TheodoliteRounds>(std::move(*setup), std::move(fit));
}

}  // namespace

ModelDescriptor theodolite_model() {
    ModelDescriptor d;
    d.id = "theodolite-rounds";
    d.title = "Theodolite in rounds";
    d.summary =
        "Standard deviations of a direction and of a zenith angle measured once in both faces, and the index "
        "error of the vertical circle, from rounds to targets as ISO 17123-3 has them, with their "
        "uncertainties and the statistical tests.";
    d.references = {{"ISO 17123-3"}, {"JCGM 100:2008 (GUM), 4.2.3, E.4.3, H.3"}};
    d.equations = theodolite_equations();
    d.notes = {
        "Any number of series, sets and targets counts, also with readings left out; four series of three "
        "sets of five targets leave 32 degrees of freedom for directions and 40 for zenith angles.",
        "Limits of the tests are quantiles of chi-squared, F and t for the degrees of freedom that the "
        "readings have, not figures of a table.",
        "The index error is positive where a zenith angle in face I reads too large. Its sign and the "
        "estimate of its uncertainty from its own scatter are those of this program; hold them against the "
        "text of the standard before a sheet names it.",
        "That the index error is the same in all series is a test of this program.",
        "A mean of both faces says nothing of collimation and of the tilt of the axes, which it does not "
        "contain."};
    d.help_page = "theodolite-rounds.md";
    d.example = "theodolite.covaria";
    d.decides = true;
    d.schema = sheets::theodolite_fields().schema();
    d.create = create_theodolite;
    return d;
}

}  // namespace covaria
