// Measurement model "robot pose": the model class, its equations and its descriptor.
#include "core/kinds/robot/model.h"

#include "core/kinds/robot/layout.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot/setup.h"
#include "core/math/rotation.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

using robot::no_input;

class RobotPose : public EquationModel<RobotPose> {
public:
    RobotPose(robot::PoseSetup setup, InputSet inputs)
        : setup_(std::move(setup)), inputs_(std::move(inputs)) {
        for (const robot::Pose& pose : setup_.poses) {
            for (const std::string axis : {"x", "y", "z"})
                outputs_.push_back({.symbol = axis,
                                    .name = tell<"position of the tool, %1">(axis),
                                    .unit = Unit::of("mm"),
                                    .group = pose.name});
            if (setup_.orientation) add_orientation(pose.name);
            prepare_turns(pose);
        }
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return robot::pose_evaluation(setup_); }

    Layout layout(std::span<const double> x) const override {
        Layout layout;
        std::vector<double> y(outputs_.size());
        evaluate(x, y);
        const Eigen::Isometry3d& X_WB = setup_.robot().X_WB();
        for (std::size_t k = 0; k < setup_.poses.size(); ++k) {
            const robot::Pose& pose = setup_.poses[k];
            add_arm(setup_.robot(), pose.q, pose.name, layout);
            const std::size_t out = k * setup_.outputs_per_pose();
            const Eigen::Vector3d p(y[out], y[out + 1], y[out + 2]);
            LayoutPoint tool{
                .name = pose.name, .kind = PointKind::tool, .p_W = setup_.in_world ? p : X_WB * p};
            tool.group = pose.name;
            tool.source.path = pose.source;
            tool.outputs = {{out, out + 1, out + 2}};
            if (!setup_.in_world) tool.R_WQ = X_WB.linear();
            layout.points.push_back(std::move(tool));
        }
        if (!setup_.in_world && !X_WB.isApprox(Eigen::Isometry3d::Identity()))
            layout.notes.push_back(tell<"results: in the base frame of the robot">());
        return layout;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const std::size_t n = setup_.robot().joints().size();
        std::array<JointTransform<Real>, most_joints> T;
        for (std::size_t i = 0; i < n; ++i) T[i] = transform_of<Real>(x, i);
        const ToolPlace<Real> tool = tool_of<Real>(x);
        for (std::size_t k = 0; k < setup_.poses.size(); ++k) pose<Real>(k, x, T, tool, y);
        return mask_of<Real>(true);
    }

private:
    template <class Real>
    struct ToolPlace {
        Matrix3<Real> R;
        Vector3<Real> p;
    };

    void add_orientation(const std::string& group) {
        for (const RotationCoordinate& c : rotation_convention(*setup_.orientation).coordinates)
            outputs_.push_back({.symbol = std::string(c.symbol),
                                .name = tell<"orientation of the tool, %1">(Message::declared(c.name)),
                                .unit = Unit::of(c.unit),
                                .group = group,
                                .periodic = c.periodic});
    }

    void prepare_turns(const robot::Pose& pose) {
        const auto& joints = setup_.robot().joints();
        for (std::size_t i = 0; i < joints.size(); ++i)
            turns_.push_back(joints[i].slides ? Turn<double>()
                                              : Turn<double>(covaria::travel_of(joints, i, pose.q)));
    }

    template <class Real>
    Real parameter(const Inputs<Real>& x, std::size_t joint, JointParameter p) const {
        const std::size_t input = setup_.parameter[joint][static_cast<std::size_t>(p)];
        return input == no_input ? Real(0.0) : Real(x[input]);
    }

    /// Eq 5 at the zero reading.
    template <class Real>
    JointTransform<Real> transform_of(const Inputs<Real>& x, std::size_t i) const {
        JointValues<Real> v;
        for (JointParameter p : joint_parameters) v[p] = parameter<Real>(x, i, p);
        return joint_transform(v, setup_.robot().joints()[i].parallel);
    }

    template <class Real>
    ToolPlace<Real> tool_of(const Inputs<Real>& x) const {
        const Eigen::Isometry3d& X = setup_.robot().X_FT();
        ToolPlace<Real> tool{X.linear().cast<Real>(), X.translation().cast<Real>()};
        if (setup_.tool == no_input) return tool;
        const std::size_t t = setup_.tool;
        tool.p += tool.R * Vector3<Real>(Real(x[t]), Real(x[t + 1]), Real(x[t + 2]));
        tool.R = (tool.R * rotation_from_zyx<Real>({Real(x[t + 3]), Real(x[t + 4]), Real(x[t + 5])})).eval();
        return tool;
    }

    /// Eqs 6 and 7: from the tool back to the base, transform by transform.
    template <class Real>
    void pose(std::size_t k, const Inputs<Real>& x, const std::array<JointTransform<Real>, most_joints>& T,
              const ToolPlace<Real>& tool, Outputs<Real>& y) const {
        const SerialRobotSource& source = setup_.robot();
        const std::size_t n = source.joints().size();
        Vector3<Real> p = tool.p;
        Matrix3<Real> R = tool.R;
        for (std::size_t i = n; i-- > 0;) {
            JointTransform<Real> joint = T[i];
            if (source.joints()[i].slides)
                joint.d = joint.d + travel_of<Real>(k, i, x);
            else
                joint.theta = joint.theta * turn_of<Real>(k, i, x);
            apply(source.convention(), joint, p);
            if (setup_.orientation) apply_to_axes(source.convention(), joint, R);
        }
        if (setup_.in_world) {
            const Eigen::Isometry3d& X = source.X_WB();
            const Matrix3<Real> R_W = X.linear().cast<Real>();
            const Vector3<Real> p_WB = X.translation().cast<Real>();
            p = (R_W * p + p_WB).eval();
            if (setup_.orientation) R = (R_W * R).eval();
        }
        const std::size_t out = k * setup_.outputs_per_pose();
        for (std::size_t c = 0; c < 3; ++c) y.set(out + c, p[static_cast<Eigen::Index>(c)]);
        if (!setup_.orientation) return;
        const std::array<Real, 4> angles = rotation_coordinates(*setup_.orientation, R);
        for (std::size_t c = 0; c + 3 < setup_.outputs_per_pose(); ++c) y.set(out + 3 + c, angles[c]);
    }

    /// Travel of a joint from the zero reading to the reading of the pose.
    template <class Real>
    Real travel_of(std::size_t k, std::size_t i, const Inputs<Real>& x) const {
        const robot::Pose& pose = setup_.poses[k];
        return covaria::travel_of<Real>(setup_.robot().joints(), i, [&](std::size_t joint) {
            const std::size_t input = pose.input[joint];
            return input == no_input ? Real(pose.q[joint]) : Real(x[input]);
        });
    }

    template <class Real>
    Turn<Real> turn_of(std::size_t k, std::size_t i, const Inputs<Real>& x) const {
        if (is_uncertain(setup_.robot().joints(), setup_.poses[k].input, i))
            return Turn<Real>(travel_of<Real>(k, i, x));
        const Turn<double>& turn = turns_[k * setup_.robot().joints().size() + i];
        return {Real(turn.c), Real(turn.s)};
    }

    robot::PoseSetup setup_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    std::vector<Turn<double>> turns_;  ///< [pose][joint]
};

std::unique_ptr<MeasurementModel> create_robot_pose(const SetupReader& reader, const AssetLibrary& assets,
                                                    Problems& problems) {
    std::optional<robot::PoseSetup> setup = robot::read_pose_setup(reader, assets, problems);
    if (!setup) return nullptr;
    InputSet inputs = robot::pose_inputs(*setup);
    return std::make_unique<RobotPose>(std::move(*setup), std::move(inputs));
}

std::vector<ModelEquation> robot_pose_equations() {
    const std::string paper = "Wen et al., ";
    return {{"T_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i) Ry(beta_i)", paper + "Eq 5"},
            {"T_i = Rx(alpha_i) Tx(a_i) Rz(theta_i) Tz(d_i)", "J. J. Craig, as a convention to choose"},
            {"theta_i(q) = theta_i + (q_i − q_0i),  d_i(s) = d_i + (s_i − s_0i)",
             "joint angle at a reading; offset of a sliding joint"},
            {"T = T_1 T_2 … T_n X_tool", paper + "Eq 6"},
            {"P = f(a, alpha, d, beta, theta)", paper + "Eq 7: position, and here also orientation"}};
}

std::vector<std::string> robot_pose_notes() {
    return {
        "The paper calls the model highly non-linear. At the uncertainties of its Table 1 it is not: the law "
        "of "
        "propagation and Monte Carlo agree to 4e-5 mm in u, and the laws are normal.",
        "The tolerance 0.0001 of the paper has no unit. In millimetres it would need 5e9 trials; in metres "
        "it "
        "is 0.1 mm, and 20 000 trials do.",
        "The paper takes the parameters as uncorrelated. Parameters identified together are strongly "
        "correlated; an "
        "identified robot carries their full covariance into this analysis, which lowers u by up to a factor "
        "of 12.",
        "Of two readings of section 4.1 (0.01 rad for theta alone, or for all angles) both are reproduced; "
        "that "
        "theta matters more than alpha holds only where its standard deviation is ten times larger.",
        "Readings of the joints deviate anew at each pose; parameters and tool are the same for all poses of "
        "an analysis."};
}

}  // namespace

ModelDescriptor robot_pose_model() {
    ModelDescriptor d;
    d.id = "robot-pose";
    d.title = "Robot pose";
    d.summary =
        "Position and orientation of the tool of a serial robot from its geometric parameters and joint "
        "readings.";
    d.references = {{"X. Wen, S. He, G. Qiao, D. Wang, A. Song, C. Kang, Z. Lv: Uncertainty estimation of "
                     "robot geometric "
                     "parameters and end-effector position based on new generation GPS"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = robot_pose_equations();
    d.notes = robot_pose_notes();
    d.help_page = "robot-pose.md";
    d.example = "er10l-c10.covaria";
    d.schema = robot::pose_fields().schema();
    d.create = create_robot_pose;
    return d;
}

}  // namespace covaria
