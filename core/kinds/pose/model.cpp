// Measurement model "pose from points": the model class and its descriptor.
#include "core/kinds/pose/model.h"

#include "core/kinds/pose/equations.h"
#include "core/kinds/pose/evidence.h"
#include "core/kinds/pose/layout.h"
#include "core/kinds/pose/tables.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

class PoseFromPoints : public EquationModel<PoseFromPoints> {
public:
    PoseFromPoints(pose::PoseSetup setup, InputSet inputs, std::vector<pose::FrameFit> fits,
                   std::shared_ptr<const evidence::RedundantReadings> evidence)
        : setup_(std::move(setup)),
          inputs_(std::move(inputs)),
          fits_(std::move(fits)),
          evidence_(std::move(evidence)) {
        const auto& info = rotation_convention(setup_.orientation);
        for (const pose::Pose& pose : setup_.poses) {
            for (const std::string axis : {"x", "y", "z"})
                outputs_.push_back({.symbol = axis,
                                    .name = tell<"position of the platform, %1">(axis),
                                    .unit = Unit::of("mm"),
                                    .group = pose.name});
            for (const RotationCoordinate& c : info.coordinates)
                outputs_.push_back({.symbol = std::string(c.symbol),
                                    .name = Message::declared(c.name),
                                    .unit = Unit::of(c.unit),
                                    .group = pose.name,
                                    .periodic = c.periodic});
        }
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double> x) const override { return pose::pose_layout(setup_, x); }
    std::vector<Table> evaluation() const override { return pose::fit_tables(fits_); }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return evidence_;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        return pose::all_poses<Real>(setup_, x, y);
    }

private:
    pose::PoseSetup setup_;
    InputSet inputs_;
    std::vector<pose::FrameFit> fits_;
    std::shared_ptr<const evidence::RedundantReadings> evidence_;  ///< evidence about what was stated
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_pose_model(const SetupReader& setup, const AssetLibrary& assets,
                                                    Problems& problems) {
    std::optional<pose::PoseSetup> read = pose::read_pose_setup(setup, assets, problems);
    if (!read) return nullptr;
    pose::check_measurable(*read, problems);
    if (problems.has_errors()) return nullptr;
    InputSet inputs = pose::pose_inputs(*read);
    pose::warn_about(*read, inputs, problems);
    std::vector<pose::FrameFit> fits = pose::frame_fits(*read, inputs);
    const ComponentEvidence evidence = pose::evidence_of(*read, inputs, fits);
    if (read->a_posteriori && read->uncertainties != evidence::UncertaintiesFrom::stated) {
        take_as_seen(inputs, evidence, read->uncertainties,
                     pose::pose_fields().place(&pose::PoseSetup::uncertainties), problems);
        // A misfit that exchanged names explain is no scatter, and stays a warning.
        std::erase_if(fits, [](const pose::FrameFit& fit) { return !fit.explanation; });
        pose::warn_of_misfits(fits, problems, false);
        fits = pose::frame_fits(*read, inputs);
    } else {
        pose::warn_of_misfits(fits, problems, evidence.readings != nullptr);
    }
    return std::make_unique<PoseFromPoints>(std::move(*read), std::move(inputs), std::move(fits),
                                            evidence.readings);
}

std::vector<ModelEquation> pose_equations() {
    const std::string paper = "Porath et al., ";
    return {{"x = (q₂ − q₁)/|q₂ − q₁|", paper + "Eqs 9, 13"},
            {"z_b = (b₃ − b₁) × x_b/|…|,  z_p = x_p × (p₃ − p₁)/|…|", paper + "Eqs 10, 14"},
            {"y = z × x,  R = [x y z]", paper + "Eqs 11, 12, 15, 16"},
            {"o_b = b₁ + R_b s_b,  o_p = p₁ + R_p s_p", paper + "Eqs 17, 18"},
            {"o = R_bᵀ (o_p − o_b)", paper + "Eq 19, corrected"},
            {"R = R_bᵀ R_p", paper + "Eq 20, corrected"},
            {"α = atan2(r₃₂, r₃₃),  β = atan2(−r₃₁, √(r₁₁² + r₂₁²)),  γ = atan2(r₂₁, r₁₁)",
             paper + "Eqs 21-23, corrected"},
            {tell<"least squares: R maximises tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄">(),
             "orthogonal Procrustes problem, closed form: B. K. P. Horn (1987)"}};
}

std::vector<std::string> pose_notes() {
    return {
        "Eq 19 is corrected: o_p − o_b must be expressed in the base frame. As printed, the pose does not "
        "depend on the orientation of the base, and U(x) of all poses is the same.",
        "Eq 20 is corrected: R = R_bᵀ R_p. The printed R_p R_bᵀ is the same rotation expressed in frame 0.",
        "Eqs 21-23 are corrected: as printed they are Z-Y-Z angles, undefined without tilt; the text and "
        "Table 3 use Z-Y-X angles, R = Rz(γ) Ry(β) Rx(α).",
        "b₃ lies at negative y of its frame (Eq 10) and p₃ at positive y of its own (Eq 14); other "
        "arrangements can be chosen.",
        "Typed uncertainties lie along the axes of the frame that the points define (those of the moving "
        "frame "
        "along the base's on request) and are turned into frame 0; those of an instrument lie along and "
        "across "
        "its line of sight.",
        "Measured points of a least-squares frame are tested against their nominal coordinates: residuals, "
        "redundancy, chi-square with the full covariance of the stated uncertainties.",
        "All poses of an analysis share one measurement of the base, so their results are correlated.",
        "The uncertainty of the mean of repeated measurements (a posteriori) is taken as that of one "
        "measurement, as in the paper: the systematic part does not average out.",
        "Angles are undefined in gimbal lock; the set-up then warns. Rotation vector and quaternion are free "
        "of "
        "it."};
}

}  // namespace

ModelDescriptor pose_from_points_model() {
    ModelDescriptor d;
    d.id = "pose-from-points";
    d.title = "Pose from points";
    d.summary =
        "Position and orientation of a moving frame in a base frame, both defined by measured points: the "
        "platform of a robot measured with a total station or laser tracker.";
    d.references = {
        {"M. C. Porath, C. F. D. Gross, J. S. Eger: Experimental-numerical approach to the estimation of "
         "uncertainty in robot pose measurement"},
        {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = pose_equations();
    d.notes = pose_notes();
    d.help_page = "pose-from-points.md";
    d.example = "stewart-platform.covaria";
    d.schema = pose::pose_fields().schema();
    d.create = create_pose_model;
    return d;
}

}  // namespace covaria
