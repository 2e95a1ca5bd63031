// Measurement model "force-moment loads": the model class and its descriptor.
#include "core/kinds/force/loads.h"

#include <cstdio>

#include "core/kinds/force/loads_equations.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

using force_loads::Case;
using force_loads::Factors;
using force_loads::LoadsSetup;

class ForceLoads : public EquationModel<ForceLoads> {
public:
    ForceLoads(LoadsSetup setup, InputSet inputs) : setup_(std::move(setup)), inputs_(std::move(inputs)) {
        const std::size_t n = setup_.size();
        for (std::size_t i = 0; i < n * n; ++i) {
            per_a_.push_back(1.0 / setup_.scale(i / n, i % n));
            per_b_.push_back(1.0 / setup_.scale(i / n, i % n, 2));
        }
        for (const Case& one : setup_.cases) add_outputs(one.name);
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return force_loads::tables(setup_); }
    std::vector<PlotSpecification> figures() const override { return force_loads::figures(setup_); }

    Layout layout(std::span<const double> x) const override {
        Layout layout = layout_for_loads(setup_.sensor);
        std::vector<double> y(outputs_.size());
        if (!evaluate(x, y)) return layout;
        for (std::size_t k = 0; k < setup_.cases.size(); ++k)
            for (const VectorKind kind : {VectorKind::force, VectorKind::moment})
                add_vector(k, kind, y, layout);
        return layout;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const std::size_t n = setup_.size(), S = setup_.first_element, Q = S + n * n;
        const auto a = [&](std::size_t h, std::size_t c) {
            return Real(x[S + h * n + c]) * Real(per_a_[h * n + c]);
        };
        const auto b = [&](std::size_t h, std::size_t c) {
            return Real(x[Q + h * n + c]) * Real(per_b_[h * n + c]);
        };
        const Factors<Real> factors(setup_.rows, a);
        mask_of<Real> valid(true);
        for (std::size_t k = 0; k < setup_.cases.size(); ++k) {
            force_loads::Vector<Real> v;
            for (std::size_t h = 0; h < n; ++h)
                v[h] =
                    Real(x[setup_.first_reading + k * n + h]) * Real(1.0 / setup_.channels()[h].rated_output);
            force_loads::Vector<Real> l = factors.solve(v);
            if (setup_.quadratic) valid = valid && force_loads::refine<Real>(setup_, a, b, v, l);
            for (std::size_t c = 0; c < n; ++c) {
                const Real rated(setup_.channels()[c].rated_load);
                y.set(2 * n * k + c, l[c] * rated);
                y.set(2 * n * k + n + c, v[c] / a(c, c) * rated);
            }
        }
        return valid;
    }

private:
    void add_outputs(const std::string& group) {
        for (const ForceChannel& channel : setup_.channels())
            outputs_.push_back({.symbol = channel.kind().symbol,
                                .name = tell<"load %1, compensated">(channel.kind().key),
                                .unit = channel.load_unit(),
                                .group = group});
        for (const ForceChannel& channel : setup_.channels())
            outputs_.push_back({.symbol = std::string(channel.kind().symbol) + ",0",
                                .name = tell<"load %1 by its own channel alone">(channel.kind().key),
                                .unit = channel.load_unit(),
                                .group = group,
                                .role = OutputRole::intermediate});
    }

    /// Adds the vector, with the uncertainty of its tip where all three coordinates are measured.
    void add_vector(std::size_t k, VectorKind kind, const std::vector<double>& y, Layout& layout) const {
        const std::size_t n = setup_.size();
        const bool moment = kind == VectorKind::moment;
        LayoutVector vector{.name = moment ? "M" : "F", .group = setup_.cases[k].name, .kind = kind};
        vector.is_measured = true;
        std::array<std::size_t, 3> outputs{};
        std::size_t found = 0;
        Eigen::Vector3d value = Eigen::Vector3d::Zero();
        for (std::size_t c = 0; c < n; ++c) {
            const ForceChannel& channel = setup_.channels()[c];
            if (channel.kind().is_moment != moment) continue;
            ++found;
            outputs[channel.axis % 3] = 2 * n * k + c;
            value[Eigen::Index(channel.axis % 3)] = y[2 * n * k + c];
        }
        if (found == 0) return;
        const Eigen::Isometry3d& X_WS = setup_.sensor->placement();
        vector.at_W = X_WS.translation();
        vector.vector_W = X_WS.linear() * value;
        vector.R_WQ = X_WS.linear();
        if (found == 3) vector.outputs = outputs;
        layout.vectors.push_back(std::move(vector));
    }

    LoadsSetup setup_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    std::vector<double> per_a_, per_b_;
};

std::unique_ptr<MeasurementModel> create_loads(const SetupReader& reader, const AssetLibrary& assets,
                                               Problems& problems) {
    auto setup = force_loads::read(reader, assets, problems);
    if (!setup) return nullptr;
    InputSet inputs = force_loads::inputs(*setup);
    return std::make_unique<ForceLoads>(std::move(*setup), std::move(inputs));
}

std::vector<ModelEquation> load_equations() {
    return {{tell<"S_hc = Σ L d_h/Σ L²  over the increasing readings under load c">(),
             "least squares through zero"},
            {tell<"V = S L,  L = C V  with  C = S⁻¹">(), "calibration matrix; not in Kim"},
            {tell<"V_h = Σ_c (S_hc L_c + Q_hc L_c²),  by Newton's method from L = C V">(),
             "with quadratic terms"},
            {tell<"V_h = d_h + repeatability + resolution + non-zero + hysteresis">(),
             "Kim, Eqs 3, 6, 7, 10, of one reading"},
            {tell<"S_hc = fitted + regression + S_hc δ_c">(),
             "δ_c: relative deviation of the machine's load on c, Kim, Eq 5"},
            {"L_h,0 = V_h/S_hh", "without compensation"}};
}

std::vector<std::string> load_notes() {
    return {
        "Kim prints no signs of the interference: nothing can be compensated from the paper. The readings of "
        "the example have signs of their own.",
        "U (k = 2) in % of rated load with all six axes at rated load: 0.184, 0.192, 0.152, 0.226, 0.219, "
        "0.261; without load 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. Compensation lowers the uncertainty "
        "under combined loads by a factor of 5 to 13 against U of the paper.",
        "Without compensation the same loads are told wrong by -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %.",
        "The machine's deviation is common to all readings under one load: a column of the matrix, and so a "
        "scale of the load on that axis.",
        "Repeatability is that of one reading, the largest of the steps; hysteresis is rectangular over the "
        "loop, in proportion to the load.",
        "Not covered: products of loads in the interference, misalignment of loads, creep, temperature, "
        "remounting."};
}

}  // namespace

ModelDescriptor force_loads_model() {
    ModelDescriptor d;
    d.id = "force-moment-loads";
    d.title = "Forces and moments by the calibration matrix";
    d.summary =
        "Forces and moments that act together, from the readings of all channels of a multi-axis sensor: the "
        "calibration matrix takes the interference between them away.";
    d.references = {{"G.-S. Kim: Uncertainty evaluation of a multi-axis force/moment sensor, International "
                     "Journal of the KSPE 3 (3)"},
                    {"JCGM 102:2011"}};
    d.equations = load_equations();
    d.notes = load_notes();
    d.help_page = "force-moment-loads.md";
    d.example = "force-moment-sensor.covaria";
    d.schema = force_loads::fields().schema();
    d.create = create_loads;
    return d;
}

}  // namespace covaria
