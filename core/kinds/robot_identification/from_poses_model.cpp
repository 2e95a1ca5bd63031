// Measurement model "robot from measured poses": the model class and its descriptor.
#include "core/kinds/robot_identification/from_poses_model.h"

#include "core/base/name.h"
#include "core/kinds/robot_identification/from_poses.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"
#include "core/text/symbol.h"

namespace covaria {

namespace {

using namespace pose_calibration;

class RobotCalibration : public EquationModel<RobotCalibration> {
public:
    explicit RobotCalibration(Calibration c) : c_(std::move(c)) {
        for (const Unknown& u : c_.unknowns) add_unknown(u);
        for (std::size_t k = c_.fitted_poses; k < c_.poses.size(); ++k)
            for (const std::string axis : {"x", "y", "z"})
                outputs_.push_back({.symbol = "d_" + axis,
                                    .name = tell<"calculated less measured %1, held back">(axis),
                                    .unit = Unit::of("um"),
                                    .group = own_name<"check %1">(c_.poses[k].name),
                                    .role = OutputRole::intermediate});
    }

    const InputSet& inputs() const override { return c_.inputs; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return tables(c_); }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return c_.statistics.evidence.readings;
    }
    Layout layout(std::span<const double>) const override { return pose_calibration::layout(c_); }

    std::shared_ptr<const Asset> as_asset(const std::string& id) const override {
        return robot_of_analysis(identified(c_), c_.parameters(), id);
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        return pose_calibration::evaluate<Real>(c_, x,
                                                [&](std::size_t j, const Real& value) { y.set(j, value); });
    }

private:
    void add_unknown(const Unknown& u) {
        static const char* const coordinates[] = {"x", "y", "z", "alpha", "beta", "gamma"};
        if (u.kind == UnknownKind::parameter) {
            const IdentifiedParameter& p = u.parameter;
            const Name joint = own_name<"joint %1">(p.joint + 1);
            outputs_.push_back(
                {.symbol = p.symbol(),
                 .name = tell<"%1 of %2">(words_of(p.parameter), tell<"joint %1">(p.joint + 1)),
                 .unit = Unit::of(is_length(p.parameter) ? "mm" : "deg"),
                 .group = joint,
                 .periodic = !is_length(p.parameter)});
            return;
        }
        const bool base = u.kind == UnknownKind::base;
        const char* const coordinate = coordinates[u.coordinate];
        const bool turn = u.coordinate >= 3;
        outputs_.push_back(
            {.symbol = coordinate,
             .name = base   ? (turn ? tell<"orientation of the base, %1">(symbol_to_unicode(coordinate))
                                    : tell<"position of the base, %1">(coordinate))
                     : turn ? tell<"orientation of the tool, %1">(symbol_to_unicode(coordinate))
                            : tell<"position of the tool, %1">(coordinate),
             .unit = Unit::of(turn ? "deg" : "mm"),
             .group = base ? own_name<"base">() : own_name<"tool">(),
             .role = OutputRole::intermediate,
             .periodic = turn});
    }

    Calibration c_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_calibration(const SetupReader& reader, const AssetLibrary& assets,
                                                     Problems& problems) {
    auto calibration = read(reader, assets, problems);
    if (!calibration) return nullptr;
    return std::make_unique<RobotCalibration>(std::move(*calibration));
}

std::vector<ModelEquation> calibration_equations() {
    return {{"p_k = X_MB T_1(q_k1) … T_n(q_kn) p_FT", "Wen et al., Eqs 5-7, with base and ball"},
            {"min Σ_k (p_k,meas − p_k)ᵀ W_k (p_k,meas − p_k)",
             "weighted least squares, W from the uncertainties"},
            {"v ← v + G (p_meas − p(v)),  G = (Aᵀ W A)⁻¹ Aᵀ W", "in each trial, A = ∂p/∂v at the estimates"},
            {"U_v = G U_p Gᵀ", tell<"JCGM 102 6.2, with all that points and readings share">()},
            {"|r_i|/u(r_i) > Φ⁻¹(1 − 0.05/(2 n))", "outlier test of residual i among n"},
            {"E_n = |p_calc − p_meas|/U", "check poses, held back from the fit"}};
}

std::vector<std::string> calibration_notes() {
    return {
        "The paper identifies parameters by joint trajectories; least squares on measured positions or poses "
        "is "
        "the other usual way, with the same model of the arm (Eq 5).",
        "Parameters that the poses cannot tell are found by their columns of the Jacobian: each that is a "
        "combination of those before it (base, then ball or tool, then joint by joint) stays nominal and is "
        "named with its partners.",
        "Weights are the inverse variances of the measured coordinates. Shared deviations of an instrument "
        "and "
        "the readings of the joints do not change the weights, but are propagated in full.",
        "In each trial the gain of the estimates is used. It differs from a complete fit by residual times "
        "curvature, below 1e-9 m here.",
        "Position alone does not tell the last joint's parameters from the place of the ball; a known base "
        "and "
        "a known ball leave more to find."};
}

}  // namespace

ModelDescriptor robot_calibration_model() {
    ModelDescriptor d;
    d.id = "robot-calibration";
    d.title = "Robot from measured poses";
    d.summary =
        "Geometric parameters of a serial robot by least squares from measured positions or poses of its "
        "tool, "
        "with observability, residuals and validation.";
    d.references = {{"X. Wen, S. He, G. Qiao, D. Wang, A. Song, C. Kang, Z. Lv: Uncertainty estimation of "
                     "robot geometric "
                     "parameters and end-effector position based on new generation GPS"},
                    {"Z. S. Roth, B. W. Mooring, B. Ravani: An overview of robot calibration (1987)"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = calibration_equations();
    d.notes = calibration_notes();
    d.help_page = "robot-calibration.md";
    d.example = "er10l-c10.covaria";
    d.capabilities = {"serial-robot"};
    d.was_asset = "calibrated-robot";
    d.schema = pose_calibration::fields().schema();
    d.create = create_calibration;
    return d;
}

}  // namespace covaria
