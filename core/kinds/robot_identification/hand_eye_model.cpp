// Measurement model "hand-eye": the model class, its tables and its descriptor.
#include "core/kinds/robot_identification/hand_eye_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/name.h"
#include "core/kinds/robot_identification/hand_eye.h"
#include "core/model/equation_model.h"
#include "core/model/layout.h"
#include "core/text/symbol.h"

namespace covaria {

namespace hand_eye {

namespace {

using Eigen::Index;
const Unit um = Unit::of("um");

Table check_table(const Calibration& c) {
    Table table{"check-poses", "Poses held back from the fit, calculated less measured"};
    table.add("pose");
    for (const char* axis : {"x", "y", "z"}) table.add(axis).in(um).symbol().figure(3);
    table.add("distance").in(um).figure(3);
    table.add("U (k = 2), largest").in(um).figure(2);
    table.add("E_n, largest").figure(2);
    const auto m = static_cast<Index>(c.rows_per_pair());
    for (std::size_t k = c.fitted_pairs; k < c.pairs.size(); ++k) {
        const Index row = static_cast<Index>(k - c.fitted_pairs) * m;
        const Eigen::Vector3d d = c.deviations.segment<3>(row), u = c.u_deviations.segment<3>(row);
        table.row({c.pairs[k].name, d.x(), d.y(), d.z(), d.norm(), 2.0 * u.maxCoeff(),
                   d.cwiseAbs().cwiseQuotient(2.0 * u.cwiseMax(1e-300)).maxCoeff()});
    }
    table.notes = {tell<"E_n = |d|/U: below 1 the pose agrees with the calibration.">()};
    return table;
}

class HandEye : public EquationModel<HandEye> {
public:
    explicit HandEye(Calibration c) : c_(std::move(c)) {
        for (const bool of_X : {true, false}) {
            shown_[of_X ? 0 : 1] = std::ranges::any_of(
                c_.unknowns, [&](const Unknown& u) { return u.of_X == of_X && u.coordinate >= 3; });
            for (std::size_t k = 0; k < coordinates_of(of_X); ++k) add_output(of_X, k);
        }
        for (std::size_t k = c_.fitted_pairs; k < c_.pairs.size(); ++k)
            for (const std::string axis : {"x", "y", "z"})
                outputs_.push_back({.symbol = "d_" + axis,
                                    .name = tell<"calculated less measured %1, held back">(axis),
                                    .unit = um,
                                    .group = own_name<"check %1">(c_.pairs[k].name),
                                    .role = OutputRole::intermediate});
    }

    const InputSet& inputs() const override { return c_.inputs; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return tables(c_); }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return c_.statistics.evidence.readings;
    }
    Layout layout(std::span<const double>) const override {
        return hand_eye::layout(c_, coordinates_of(true));
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        Places<Real> places;
        const std::size_t first_check = coordinates_of(true) + coordinates_of(false);
        const auto has_value = hand_eye::evaluate<Real>(
            c_, x, places, [&](std::size_t i, const Real& value) { y.set(first_check + i, value); });
        std::size_t output = 0;
        for (const bool of_X : {true, false}) {
            for (int k = 0; k < 3; ++k) y.set(output++, (of_X ? places.p_X : places.p_Z)[k]);
            if (coordinates_of(of_X) == 3) continue;
            const Vector3<Real> angles = zyx_from_rotation(of_X ? places.R_X : places.R_Z);
            for (int k = 0; k < 3; ++k) y.set(output++, angles[k]);
        }
        return has_value;
    }

private:
    /// An orientation that nothing tells, as that of a point, is no output.
    std::size_t coordinates_of(bool X) const { return shown_[X ? 0 : 1] ? 6 : 3; }

    void add_output(bool of_X, std::size_t k) {
        static const char* const symbols[] = {"x", "y", "z", "alpha", "beta", "gamma"};
        outputs_.push_back({.symbol = symbols[k],
                            .name = tell<"%1, %2">(c_.words_of(of_X), symbol_to_unicode(symbols[k])),
                            .unit = Unit::of(k < 3 ? "mm" : "deg"),
                            .group = of_X == (c_.mount == Mount::instrument) ? own_name<"instrument">()
                                                                             : own_name<"target">(),
                            .periodic = k >= 3});
    }

    Calibration c_;
    std::array<bool, 2> shown_{};
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_hand_eye(const SetupReader& reader, const AssetLibrary& assets,
                                                  Problems& problems) {
    auto c = read(reader, assets, problems);
    return c ? std::make_unique<HandEye>(std::move(*c)) : nullptr;
}

}  // namespace

Message Calibration::words_of(bool of_X) const {
    if (mount == Mount::instrument)
        return of_X ? tell<"instrument in the frame of the flange">()
                    : tell<"target in the frame of the base">();
    return of_X ? tell<"target in the frame of the flange">() : tell<"instrument in the frame of the base">();
}

std::vector<Message> Calibration::names() const {
    static const char* const axes[] = {"x", "y", "z"};
    std::vector<Message> names;
    for (const Unknown& u : unknowns) {
        const std::size_t k = u.coordinate;
        const Message coordinate = k < 3 ? Message(axes[k]) : tell<"rotation about %1">(axes[k - 3]);
        const bool instrument = u.of_X == (mount == Mount::instrument);
        names.push_back(instrument ? tell<"instrument %1">(coordinate) : tell<"target %1">(coordinate));
    }
    return names;
}

std::vector<Table> tables(const Calibration& c) {
    std::vector<Table> all;
    if (!c.held.empty()) all.push_back(held_table(c.held));
    for (Table& table : observability_tables(c.statistics, c.names(), tell<"coordinates in the fit">()))
        all.push_back(std::move(table));
    std::vector<std::string> poses;
    for (std::size_t k = 0; k < c.fitted_pairs; ++k) poses.push_back(c.pairs[k].name);
    all.push_back(residual_table(c.statistics, poses));
    if (c.fitted_pairs < c.pairs.size()) all.push_back(check_table(c));
    return all;
}

/// Base, flange in the first pose, what it carries in all of them, and the other; in the frame of the base.
Layout layout(const Calibration& c, std::size_t first_output_of_Z) {
    Layout layout;
    const bool instrument = c.mount == Mount::instrument;
    const Name carried_name = instrument ? own_name<"instrument">() : own_name<"target">();
    const Name other_name = instrument ? own_name<"target">() : own_name<"instrument">();
    layout.frames = {{.name = own_name<"base">()}, {.name = other_name, .X_WF = c.Z}};
    for (std::size_t k = 0; k < c.pairs.size(); ++k) {
        const Pair& pair = c.pairs[k];
        Eigen::Isometry3d A = Eigen::Isometry3d::Identity();
        A.linear() = pair.R_BF;
        A.translation() = pair.p_BF;
        const Eigen::Isometry3d carried = A * c.X;
        LayoutPoint point{.name = pair.name,
                          .kind = pair.check ? PointKind::ball : PointKind::target,
                          .p_W = carried.translation()};
        point.source.path = pair.source;
        if (k == 0) {
            layout.frames.push_back({.name = own_name<"flange">(), .X_WF = A});
            layout.frames.push_back({.name = carried_name, .X_WF = carried});
            point.outputs = {{0, 1, 2}};
            point.R_WQ = pair.R_BF;
        }
        layout.points.push_back(std::move(point));
        layout.links.push_back({.name = "",
                                .kind = LinkKind::sight_line,
                                .from_W = carried.translation(),
                                .to_W = c.Z.translation()});
    }
    const std::size_t z = first_output_of_Z;
    layout.points.push_back({.name = other_name,
                             .kind = PointKind::station,
                             .p_W = c.Z.translation(),
                             .outputs = {{z, z + 1, z + 2}}});
    return layout;
}

}  // namespace hand_eye

ModelDescriptor hand_eye_model() {
    ModelDescriptor d;
    d.id = "hand-eye";
    d.title = "Hand-eye calibration";
    d.summary =
        "Where an instrument on a robot's flange is and where its target stands, or the other way round (A X "
        "= Z "
        "B), with covariance, residuals and validation.";
    d.references = {{"Y. C. Shiu, S. Ahmad: Calibration of wrist-mounted robotic sensors by solving "
                     "homogeneous transform "
                     "equations of the form AX = XB (1989)"},
                    {"H. Zhuang, Z. S. Roth, R. Sudhakar: Simultaneous robot/world and tool/flange "
                     "calibration by solving "
                     "homogeneous transformation equations of the form AX = YB (1994)"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = {
        {"A_k X = Z B_k", "A flange in the base, B target in the instrument that stands still"},
        {"A_k X = Z B_k⁻¹", "B target in the instrument on the flange"},
        {"R_A R_X − R_Z R_B = 0", tell<"start: linear in both rotations, then in both positions">()},
        {"min Σ (B_meas − B(X, Z))² / u²", "weighted least squares, positions and rotations"},
        {"v ← v + G (B_meas − B(v)),  G = (Jᵀ W J)⁻¹ Jᵀ W", "in each trial, J at the estimates"},
        {"|r_i|/u(r_i) > Φ⁻¹(1 − 0.05/(2 n))", "outlier test of residual i among n"},
        {"E_n = |p_calc − p_meas|/U", "check poses, held back from the fit"}};
    d.notes = {
        "Least squares is on what was measured, and not on A X = Z B itself: an error of a rotation counts "
        "by its "
        "own u, and not by the lever of X.",
        "Errors of the arm are taken to be independent from pose to pose; an arm that is wrong by its "
        "parameters "
        "shows larger residuals, and an identified robot is the better way.",
        "Where all turns of the flange are about one direction, the position along it is not told and "
        "named."};
    d.help_page = "hand-eye.md";
    d.example = "eye-on-hand.covaria";
    d.schema = hand_eye::fields().schema();
    d.create = hand_eye::create_hand_eye;
    return d;
}

}  // namespace covaria
