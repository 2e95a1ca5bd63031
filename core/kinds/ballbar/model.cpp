// Measurement model "TCP from ballbars": the model class and its descriptor.
#include "core/kinds/ballbar/model.h"

#include "core/base/name.h"
#include "core/kinds/ballbar/equations.h"
#include "core/kinds/ballbar/evidence.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

using tcp::axis_letters;

class TcpFromBallbars : public EquationModel<TcpFromBallbars> {
public:
    TcpFromBallbars(tcp::TcpSetup setup, tcp::TcpInputs inputs,
                    std::shared_ptr<const evidence::RedundantReadings> evidence)
        : setup_(std::move(setup)), inputs_(std::move(inputs)), evidence_(std::move(evidence)) {
        if (setup_.finds_tool()) add_tool();
        const OutputRole role = setup_.finds_tool() ? OutputRole::intermediate : OutputRole::measurand;
        for (const tcp::Point& point : setup_.points)
            add_position(point.name, tell<"point %1">(point.name), role);
    }

    const InputSet& inputs() const override { return inputs_.set; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return tcp::tcp_layout(setup_); }
    std::vector<Table> evaluation() const override {
        std::vector<Table> tables = tcp::tcp_evaluation(setup_);
        if (setup_.has_lengths()) tables.push_back(tcp::residuals_of_lengths(setup_));
        return tables;
    }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return evidence_;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        return tcp::procedure<Real>(setup_, inputs_.of_points, x, y);
    }

private:
    void add_position(const Name& group, const Message& what, OutputRole role) {
        for (const std::string axis : {"x", "y", "z"})
            outputs_.push_back({.symbol = axis,
                                .name = tell<"%1, coordinate %2">(what, axis),
                                .unit = Unit::of("mm"),
                                .group = group,
                                .role = role});
    }

    void add_tool() {
        add_position("TCP", tell<"tool centre point">(), OutputRole::measurand);
        for (const tcp::Sequence& s : setup_.sequences)
            for (int other = 0; other < 3; ++other) {
                if (other == s.axis) continue;
                const std::string own(1, axis_letters[s.axis]), to(1, axis_letters[other]);
                outputs_.push_back({.symbol = "alpha_" + own + to,
                                    .name = tell<"axis %1 of the flange, angle towards %2">(own, to),
                                    .unit = Unit::of("urad"),
                                    .group = own_name<"axes of the flange">(),
                                    .role = OutputRole::intermediate});
            }
        add_position(own_name<"centre of the flange">(), tell<"centre of the flange">(),
                     OutputRole::intermediate);
    }

    tcp::TcpSetup setup_;
    tcp::TcpInputs inputs_;
    std::shared_ptr<const evidence::RedundantReadings> evidence_;  ///< null: nothing is redundant
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_tcp_model(const SetupReader& reader, const AssetLibrary& assets,
                                                   Problems& problems) {
    std::optional<tcp::TcpSetup> setup = tcp::read_tcp_setup(reader, assets, problems);
    if (!setup) return nullptr;
    tcp::check_tcp_setup(*setup, problems);
    if (problems.has_errors()) return nullptr;
    tcp::TcpInputs inputs = tcp::tcp_inputs(*setup);
    const ComponentEvidence evidence = tcp::evidence_of(*setup, inputs);
    if (setup->uncertainties == evidence::UncertaintiesFrom::stated)
        tcp::warn_of_lengths(evidence, problems);
    else
        take_as_seen(inputs.set, evidence, setup->uncertainties,
                     tcp::tcp_fields().place(&tcp::StatedTcp::uncertainties), problems);
    return std::make_unique<TcpFromBallbars>(std::move(*setup), std::move(inputs), evidence.readings);
}

std::vector<ModelEquation> tcp_model_equations() {
    const std::string paper = "Brosed et al., ";
    return {{"x₂ = L₁₂,  x₃ = L₁₃ cos β,  y₃ = L₁₃ sin β,  cos β = (L₁₂² + L₁₃² − L₂₃²)/(2 L₁₂ L₁₃)",
             paper + "Eqs 4-7"},
            {"X = (L₁² − L₂² + x₂²)/(2 x₂)", paper + "Eq 1"},
            {"Y = (L₁² − L₃² + x₃² + y₃²)/(2 y₃) − (x₃/y₃) X", paper + "Eq 2, Y_VC3 read as Y_KS3"},
            {tell<"Z = ± √(L₁² − X² − Y²);  no value where the root is negative">(), paper + "Eq 3"},
            {tell<"min Σ w (L_j − |M − KS_j|)², Gauss-Newton from Eqs 1-3">(), "more than three supports"},
            {tell<"L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + reading's deviation">(),
             paper + "section 3; ω added"},
            {tell<"n_x, n_y: planes of the arcs by total least squares;  C: sphere through all points">(),
             paper + "section 2.2"},
            {"y = n_y,  z = unit(n_x × y),  x = y × z", "frame, not stated in the paper; \"y first\""},
            {tell<"TCP = mean of Rot_iᵀ Fᵀ (M_i − C)">(), paper + "Eq 8, averaged over the points"}};
}

std::vector<std::string> tcp_notes() {
    return {
        "The paper states neither the tool, nor the flange's orientation, start angles, how the frame is "
        "made, "
        "nor how the points are averaged. With a tool of (0, 0, 100) mm, the flange pointing down, arcs from "
        "-60° "
        "to 140° and from -90° to 90° and u(L) = 1.55 µm, the published values reproduce within 1.5 % (root "
        "mean square).",
        "U(TCP): published 8.2, 11.1, 5.1 µm; here 8.16, 10.92, 5.00 µm: reproduces.",
        "U(TCP) with an ideal robot: published 2.8, 3.7, 1.6 µm; here 2.77, 3.61, 1.57 µm: reproduces.",
        "U of the axes' angles XY, XZ, YX, YZ: published 79, 87, 59, 123 µrad; here 78.3, 87.2, 58.5, 120.6 "
        "µrad: "
        "reproduces.",
        "Largest U of a point measured by the ballbars alone: published 5.7, 5.7, 2.4 µm; here 5.83, 5.72, "
        "2.38 µm: "
        "reproduces.",
        "With the stated U(L) = 4 µm the same geometry gives U(TCP) 8.46, 11.31, 5.16 µm and points up to "
        "7.53, "
        "7.37, 3.07 µm: differs, because the stated 4 µm and the published points cannot both hold. U(z) of "
        "a point "
        "at most 577 mm above the supports is 2.4 µm only for U(L) near 3.1 µm; all six figures of the "
        "instrument "
        "alone are 0.78 of what 4 µm gives.",
        "The centre of the sphere is the centre of the flange, not the tool centre point as section 4 says: "
        "its U "
        "is 5.96, 7.42, 6.94 µm.",
        "Eq 8 needs perpendicular axes, which two measured normals are not: U(x) of the tool is 8.16, 8.37 "
        "or 8.66 "
        "µm with y first, symmetric or x first.",
        "A trial whose lengths do not meet (negative root of Eq 3) has no value: it is counted and "
        "reported."};
}

}  // namespace

ModelDescriptor tcp_from_ballbars_model() {
    ModelDescriptor d;
    d.id = "tcp-from-ballbars";
    d.title = "TCP from ballbars";
    d.summary =
        "The tool centre point of a robot: the flange turns about its own axes, telescopic ballbars measure "
        "where the ball at the tool goes, and planes and a sphere give the flange's axes and centre.";
    d.references = {
        {"F. J. Brosed, J. J. Aguilar, S. Aguado, M. Pueo, A. C. Majarena, J. Velázquez: Evaluation "
         "of the measurement uncertainty of a high-precision telescopic instrument measuring the "
         "tool centre point of a robot (euspen 2025)"},
        {"JCGM 101:2008, JCGM 102:2011"}};
    d.equations = tcp_model_equations();
    d.notes = tcp_notes();
    d.help_page = "tcp-from-ballbars.md";
    d.example = "ballbar-tcp.covaria";
    d.schema = tcp::tcp_fields().schema();
    d.create = create_tcp_model;
    return d;
}

}  // namespace covaria
