// Measurement model "force-moment channels": the model class, its equations and its descriptor.
#include "core/kinds/force/channels.h"

#include "core/kinds/force/channels_setup.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

using force_channels::ChannelSetup;

class ForceChannels : public EquationModel<ForceChannels> {
public:
    explicit ForceChannels(ChannelSetup setup)
        : setup_(std::move(setup)), inputs_(force_channels::inputs(setup_)) {
        const Unit ratio = Unit::of("mV/V"), percent = Unit::of("%");
        for (const ForceChannel& channel : setup_.channels()) {
            const std::string key = channel.kind().key;
            outputs_.push_back({.symbol = channel.kind().symbol,
                                .name = tell<"load %1 that channel %1 tells">(key),
                                .unit = channel.load_unit(),
                                .group = key});
            outputs_.push_back({.symbol = "V",
                                .name = tell<"net reading of channel %1">(key),
                                .unit = ratio,
                                .group = key,
                                .role = OutputRole::intermediate});
            outputs_.push_back({.symbol = "r",
                                .name = tell<"load by the rated load of channel %1">(key),
                                .unit = percent,
                                .group = key,
                                .role = OutputRole::intermediate});
        }
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return force_channels::tables(setup_); }
    std::vector<PlotSpecification> figures() const override { return force_channels::figures(setup_); }

    Layout layout(std::span<const double>) const override {
        Layout layout = layout_for_loads(setup_.sensor);
        const Eigen::Isometry3d& X_WS = setup_.sensor->placement();
        for (const ForceChannel& channel : setup_.channels()) {
            LayoutVector vector{
                .name = channel.kind().key, .at_W = X_WS.translation(), .group = channel.kind().key};
            vector.kind = channel.kind().is_moment ? VectorKind::moment : VectorKind::force;
            vector.vector_W =
                X_WS.linear() * (channel.rated_load * Eigen::Vector3d::Unit(Eigen::Index(channel.axis % 3)));
            layout.vectors.push_back(std::move(vector));
        }
        return layout;
    }

    /// Reading with interference, and the load that the rated output makes of it.
    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const std::size_t n = setup_.size();
        for (std::size_t h = 0; h < n; ++h) {
            const ForceChannel& channel = setup_.channels()[h];
            Real reading = x[h];
            for (std::size_t c = 0; c < n; ++c)
                if (setup_.interferes(h, c)) reading += Real(setup_.e(h, c)) * x[n + c];
            const Real relative = reading * Real(1.0 / channel.rated_output);
            y.set(3 * h, relative * Real(channel.rated_load));
            y.set(3 * h + 1, reading);
            y.set(3 * h + 2, relative);
        }
        return mask_of<Real>(true);
    }

private:
    ChannelSetup setup_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_channels(const SetupReader& reader, const AssetLibrary& assets,
                                                  Problems& problems) {
    auto setup = force_channels::read(reader, assets, problems);
    if (!setup) return nullptr;
    return std::make_unique<ForceChannels>(std::move(*setup));
}

std::vector<ModelEquation> channel_equations() {
    const std::string paper = "Kim, ";
    return {
        {tell<"d_hij = d′_hij − d_h0j,  d_hi = mean over j,  s_hi,  u_A = max s_hi/√n">(), paper + "Eqs 1-4"},
        {"u_CM = U_CM d_R/k,  u_r = r/√12,  u_z = |d_f − d_0|/√12", paper + "Eqs 5-7"},
        {"u_B² = u_CM² + u_r² + u_z²,  u_c² = u_A² + u_B²", paper + "Eqs 8, 9"},
        {"U = u_hys + u_int + k u_c", paper + "Eqs 10-12, the evaluation beside this one"},
        {"V_h = d_h + Σ_c e_hc q_c,  q_c in [−1, 1]", "interference as an unknown load on each other axis"},
        {"F_h = L_R V_h/d_R", "the load that a channel tells by its rated output"},
        {"u² = u_A² + u_CM² + (r² + Z² + H²)/12 + Σ e_hc²/3", "JCGM 100 5.1.2"}};
}

std::vector<std::string> channel_notes() {
    return {
        "U of the paper: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % of rated output: reproduces.",
        "By the GUM (k = 2) with unknown loads on the other five axes: 1.446, 1.425, 2.123, 2.637, 2.990, "
        "1.388 %. With all others at rated load interference alone reaches 2.70, 2.12, 3.33, 4.59, 3.70, "
        "2.27 %, more than U of the paper for all six: its linear sum is no bound.",
        "Monte Carlo intervals are a little shorter than k = 2 because a few rectangular loads dominate.",
        "The load on an axis is one quantity in the equations of all channels, which correlates them.",
        "With n = 3 a standard deviation has two degrees of freedom. Used alone a channel has effective "
        "degrees of freedom between 20 and 140, because its repeatability is a small part.",
        "Not covered: misalignment of the loads, creep, temperature, remounting."};
}

}  // namespace

ModelDescriptor force_channels_model() {
    ModelDescriptor d;
    d.id = "force-moment-channels";
    d.title = "Channels of a force/moment sensor";
    d.summary =
        "The uncertainty of each channel of a multi-axis force/moment sensor, used alone or while unknown "
        "loads act on its other axes; by the GUM, with the paper's evaluation beside it.";
    d.references = {{"G.-S. Kim: Uncertainty evaluation of a multi-axis force/moment sensor, International "
                     "Journal of the KSPE 3 (3)"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008"}};
    d.equations = channel_equations();
    d.notes = channel_notes();
    d.help_page = "force-moment-channels.md";
    d.example = "force-moment-sensor.covaria";
    d.schema = force_channels::fields().schema();
    d.create = create_channels;
    return d;
}

}  // namespace covaria
