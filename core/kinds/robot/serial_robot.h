// Capability of serial robots: an arm of joints in a row, by parameters in a Denavit-Hartenberg convention.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/math/joint_transform.h"
#include "core/model/capability.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// "theta", "d", "a", "alpha", "beta".
const char* symbol_of(JointParameter parameter);
/// "joint angle", "offset", "link length", "twist", "second twist".
Message words_of(JointParameter parameter);
inline bool is_length(JointParameter p) {
    return p == JointParameter::d || p == JointParameter::a;
}

struct RobotJoint {
    JointValues<double> values;  ///< SI
    /// The next axis is (nearly) parallel: beta is a parameter and d is 0 by definition.
    bool parallel = false;
    bool slides = false;  ///< its reading, a length, adds to d; else an angle that adds to theta
    double zero = 0.0;    ///< reading at which theta and d hold
    double direction = 1.0;
    double low = -std::numeric_limits<double>::infinity();  ///< limits of the reading q
    double high = std::numeric_limits<double>::infinity();
    /// Another joint whose travel moves this one along, by that share: of many arms joint 3 turns by what
    /// joints 2 and 3 read, since its motor stands on the foot.
    std::size_t moved_by = alone;
    double share = 1.0;
    static constexpr std::size_t alone = static_cast<std::size_t>(-1);

    bool has(JointParameter p) const {
        return p == JointParameter::beta ? parallel : !(p == JointParameter::d && parallel);
    }
    Unit reading_unit() const { return Unit::of(slides ? "mm" : "deg"); }
};

/// Travel of a joint: what the readings add to its theta or d. `q(k)`: reading of joint k.
template <class Real, class Readings>
Real travel_of(const std::vector<RobotJoint>& joints, std::size_t joint, const Readings& q) {
    const auto own = [&](std::size_t k) {
        return Real(Real(joints[k].direction) * (Real(q(k)) - Real(joints[k].zero)));
    };
    const RobotJoint& of = joints[joint];
    return of.moved_by == RobotJoint::alone ? own(joint)
                                            : Real(own(joint) + Real(of.share) * own(of.moved_by));
}
inline double travel_of(const std::vector<RobotJoint>& joints, std::size_t joint,
                        const std::vector<double>& q) {
    return travel_of<double>(joints, joint, [&](std::size_t k) { return q[k]; });
}

/// Whether a reading that moves the joint is an input quantity; `inputs`: by joint, npos where it is exact.
template <class Inputs>
bool is_uncertain(const std::vector<RobotJoint>& joints, const Inputs& inputs, std::size_t joint) {
    const std::size_t other = joints[joint].moved_by;
    return inputs[joint] != InputSet::npos || (other != RobotJoint::alone && inputs[other] != InputSet::npos);
}

/// A component of the uncertainty of one parameter.
struct ParameterDeviation {
    std::size_t joint = 0;
    JointParameter parameter = JointParameter::theta;
    UncertaintyComponent component;  ///< its id is completed by the model
};

/// Between two of the deviations, by index.
struct DeviationCorrelation {
    std::size_t first = 0, second = 0;
    double coefficient = 0.0;
};

class SerialRobotSource : public Capability {
public:
    static constexpr const char* capability = "serial-robot";
    static constexpr const char* lacking = "is no serial robot";
    virtual DhConvention convention() const = 0;
    virtual const std::vector<RobotJoint>& joints() const = 0;
    virtual const Eigen::Isometry3d& X_WB() const = 0;  ///< base frame in the world
    virtual const Eigen::Isometry3d& X_FT() const = 0;  ///< tool in the frame of the last link
    virtual const std::vector<ParameterDeviation>& deviations() const = 0;
    virtual const std::vector<DeviationCorrelation>& correlations() const = 0;
    /// Output of the analysis that found the parameter; empty: none did.
    virtual std::optional<OutputReference> taken_from(std::size_t /*joint*/, JointParameter) const {
        return {};
    }
    /// Deviations of the reading of a joint, drawn anew at each pose: encoder, repeatability.
    virtual std::vector<UncertaintyComponent> reading(std::size_t joint) const = 0;
    /// Deviations of x, y, z and of the rotations about x, y, z of the tool in its own frame.
    virtual std::vector<UncertaintyComponent> tool() const = 0;
};

/// "q_2", or "s_2" of a joint that slides: symbol and column of a reading.
std::string reading_symbol(const SerialRobotSource& robot, std::size_t joint);

/// Number from 1 of the first joint that slides; 0: all turn.
std::size_t first_sliding_joint(const SerialRobotSource& robot);
/// Number from 1 of the first joint that another moves along; 0: none.
std::size_t first_coupled_joint(const SerialRobotSource& robot);

/// Frames 0 ... n of the arm in the base frame at the readings q, then the tool.
std::vector<Eigen::Isometry3d> link_frames(const SerialRobotSource& robot, const std::vector<double>& q);

/// Standard uncertainty of a parameter: root sum of squares of its components.
double standard_uncertainty_of(const SerialRobotSource& robot, std::size_t joint, JointParameter parameter);

/// Table of a robot's parameters: value, components by source, u, U = 2 u.
struct Table;
Table parameter_table(const SerialRobotSource& robot);

}  // namespace covaria
