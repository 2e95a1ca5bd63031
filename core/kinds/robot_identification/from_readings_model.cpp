// Measurement model "robot from readings": the model class and its descriptor.
#include "core/kinds/robot_identification/from_readings_model.h"

#include "core/base/name.h"
#include "core/kinds/robot_identification/from_readings.h"
#include "core/model/equation_model.h"
#include "core/text/symbol.h"

namespace covaria {

namespace reading_identification {

namespace {

class RobotFromReadings : public EquationModel<RobotFromReadings> {
public:
    explicit RobotFromReadings(Identification id) : id_(std::move(id)) {
        for (std::size_t i = 0; i < id_.unknowns.size(); ++i)
            if (is_of_the_arm(id_.unknowns[i])) add_of_the_arm(id_.unknowns[i]);
        if (id_.has_kind(UnknownKind::base)) add_base();
        for (const Unknown& u : id_.unknowns)
            if (!is_of_the_arm(u) && u.kind != UnknownKind::base) add_surroundings(u);
        for (std::size_t i = id_.fitted_rows; i < id_.rows.size(); ++i)
            outputs_.push_back({.symbol = "d_" + std::to_string(i - id_.fitted_rows + 1),
                                .name = tell<"%1: calculated less measured, held back">(id_.rows[i].name),
                                .unit = Unit::of("um"),
                                .group = own_name<"check">(),
                                .role = OutputRole::intermediate});
    }

    const InputSet& inputs() const override { return id_.inputs; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return tables(id_); }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return id_.statistics.evidence.readings;
    }
    Layout layout(std::span<const double>) const override { return reading_identification::layout(id_); }

    std::shared_ptr<const Asset> as_asset(const std::string& id) const override {
        return robot_of_analysis(identified(id_), id_.parameters(), id);
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        Found<Real> found;
        const std::size_t first_check = outputs_.size() - (id_.rows.size() - id_.fitted_rows);
        const auto has_value = reading_identification::evaluate<Real>(
            id_, x, found, [&](std::size_t i, const Real& value) { y.set(first_check + i, value); });
        std::size_t output = 0;
        for (std::size_t i = 0; i < id_.unknowns.size(); ++i)
            if (is_of_the_arm(id_.unknowns[i])) y.set(output++, found.v[i]);
        if (id_.has_kind(UnknownKind::base)) {
            const Vector3<Real> angles = zyx_from_rotation(found.scene.R_MB);
            for (int k = 0; k < 3; ++k) y.set(output++, found.scene.p_MB[k]);
            for (int k = 0; k < 3; ++k) y.set(output++, angles[k]);
        }
        for (std::size_t i = 0; i < id_.unknowns.size(); ++i) {
            const Unknown& u = id_.unknowns[i];
            if (is_of_the_arm(u) || u.kind == UnknownKind::base) continue;
            if (is_of_plane(u) && u.coordinate < 2) continue;
            y.set(output++, is_of_plane(u) ? distance_from_origin(found.scene, u.of) : found.v[i]);
        }
        return has_value;
    }

private:
    static bool is_of_the_arm(const Unknown& u) {
        return u.kind == UnknownKind::parameter || u.kind == UnknownKind::compliance;
    }
    bool is_of_plane(const Unknown& u) const {
        return u.kind == UnknownKind::place && id_.fixed_places[u.of].plane;
    }

    template <class Real>
    static Real distance_from_origin(const Scene<Real>& scene, std::size_t plane) {
        Real h(0.0);
        for (int k = 0; k < 3; ++k) h += scene.normals[plane][k] * scene.points[plane][k];
        return h;
    }

    void add_of_the_arm(const Unknown& u) {
        const Name joint = own_name<"joint %1">(u.of + 1);
        if (u.kind == UnknownKind::compliance) {
            outputs_.push_back({.symbol = "c_" + std::to_string(u.of + 1),
                                .name = tell<"compliance of %1">(tell<"joint %1">(u.of + 1)),
                                .unit = Unit::of("urad/(N*m)"),
                                .group = joint});
            return;
        }
        outputs_.push_back({.symbol = IdentifiedParameter{u.of, u.parameter}.symbol(),
                            .name = tell<"%1 of %2">(words_of(u.parameter), tell<"joint %1">(u.of + 1)),
                            .unit = Unit::of(is_length(u.parameter) ? "mm" : "deg"),
                            .group = joint,
                            .periodic = !is_length(u.parameter)});
    }

    void add_base() {
        for (const char* const axis : {"x", "y", "z"})
            outputs_.push_back({.symbol = axis,
                                .name = tell<"position of the base, %1">(axis),
                                .unit = Unit::of("mm"),
                                .group = own_name<"base">(),
                                .role = OutputRole::intermediate});
        for (const char* const angle : {"alpha", "beta", "gamma"})
            outputs_.push_back({.symbol = angle,
                                .name = tell<"orientation of the base, %1">(symbol_to_unicode(angle)),
                                .unit = Unit::of("deg"),
                                .group = own_name<"base">(),
                                .role = OutputRole::intermediate,
                                .periodic = true});
    }

    void add_surroundings(const Unknown& u) {
        static const char* const axes[] = {"x", "y", "z"};
        if (is_of_plane(u) && u.coordinate < 2) return;
        const bool zero = u.kind == UnknownKind::zero, plane = is_of_plane(u);
        const std::string& name = zero                            ? id_.zeros[u.of]
                                  : u.kind == UnknownKind::target ? id_.arm_targets[u.of].name
                                                                  : id_.fixed_places[u.of].name;
        const Message of = zero    ? tell<"zero %1">(name)
                           : plane ? tell<"distance of plane %1 from the origin">(name)
                                   : tell<"%1, %2">(name, axes[u.coordinate]);
        outputs_.push_back({.symbol = zero    ? "z"
                                      : plane ? "h"
                                              : axes[u.coordinate],
                            .name = of,
                            .unit = Unit::of("mm"),
                            .group = zero    ? own_name<"zero %1">(name)
                                     : plane ? own_name<"plane %1">(name)
                                             : Name(name),
                            .role = OutputRole::intermediate});
    }

    Identification id_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_from_readings(const SetupReader& reader, const AssetLibrary& assets,
                                                       Problems& problems) {
    auto id = read(reader, assets, problems);
    if (!id) return nullptr;
    return std::make_unique<RobotFromReadings>(std::move(*id));
}

std::vector<ModelEquation> reading_equations() {
    return {
        {"p_kt = X_MB T_1(q_k1) … T_n(q_kn) p_t", "Wen et al., Eqs 5-7, with base and target t"},
        {"L = |p_kt − o| + z,  L = |p_kt − p_mt| + z", tell<"distance from a point, from another pose">()},
        {"L = n·(p_kt − o) + z", tell<"distance from a plane, 0 where it is touched">()},
        {"theta_j = theta_j + q_j + c_j tau_j", tell<"where compliances are found">()},
        {"min Σ (L_meas − L)² / u²", "weighted least squares"},
        {"v ← v + G (L_meas − L(v)),  G = (Aᵀ W A)⁻¹ Aᵀ W", "in each trial, A = ∂L/∂v at the estimates"},
        {"U_v = G U_L Gᵀ", tell<"JCGM 102 6.2, with all that readings share">()},
        {"|r_i|/u(r_i) > Φ⁻¹(1 − 0.05/(2 n))", "outlier test of residual i among n"}};
}

std::vector<std::string> reading_notes() {
    return {
        "Unknowns that the readings cannot tell are found by their columns of the Jacobian: each that is a "
        "combination of those before it (base, places, zeros, targets, then joint by joint, then "
        "compliances) "
        "stays as stated and is named with its partners.",
        "Touched planes that are themselves found tell no lengths: an arm and its surroundings that are "
        "larger "
        "by one factor touch planes that are further away by it. One known distance gives the scale.",
        "Weights are the inverse variances of the readings. What readings share (the scale of the distances, "
        "an instrument's station, readings of the joints, known places) does not change the weights, but is "
        "propagated in full.",
        "The identified robot stands where its base was found; compliances are reported and not part of it.",
        "In each trial the gain of the estimates is used. It differs from a complete fit by residual times "
        "curvature."};
}

}  // namespace

}  // namespace reading_identification

ModelDescriptor robot_from_readings_model() {
    using namespace reading_identification;
    ModelDescriptor d;
    d.id = "robot-from-readings";
    d.title = "Robot from distances, planes and balls";
    d.summary =
        "Geometric parameters of a robot by least squares from distances, touched planes, distances between "
        "poses and positions of reflectors, without measured poses.";
    d.references = {{"X. Wen, S. He, G. Qiao, D. Wang, A. Song, C. Kang, Z. Lv: Uncertainty estimation of "
                     "robot geometric "
                     "parameters and end-effector position based on new generation GPS"},
                    {"Z. S. Roth, B. W. Mooring, B. Ravani: An overview of robot calibration (1987)"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = reading_equations();
    d.notes = reading_notes();
    d.help_page = "robot-from-readings.md";
    d.example = "robot-readings.covaria";
    d.capabilities = {"serial-robot"};
    d.schema = reading_identification::fields().schema();
    d.create = create_from_readings;
    return d;
}

}  // namespace covaria
