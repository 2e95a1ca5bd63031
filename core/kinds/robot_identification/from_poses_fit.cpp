#include "core/kinds/robot_identification/from_poses_fit.h"

#include <algorithm>
#include <cmath>

#include "core/kinds/robot_identification/input_sensitivity.h"
#include "core/math/nearest_rotation.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria::pose_calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct PoseRange {
    std::size_t first, last;
    std::size_t count() const { return last - first; }
};
PoseRange fitted(const Calibration& c) {
    return {0, c.fitted_poses};
}
PoseRange checks(const Calibration& c) {
    return {c.fitted_poses, c.poses.size()};
}

/// Residuals of a range of poses: `set(row, value)`.
template <class Real, class Values, class In, class Set>
void all_residuals(const Calibration& c, PoseRange range, const Values& v, const In& x, const Set& set) {
    const std::size_t m = c.rows_per_pose();
    const CalibratedArm<Real> arm = arm_of<Real>(c, v);
    std::array<Real, 6> r;
    for (std::size_t k = range.first; k < range.last; ++k) {
        residuals<Real>(c, c.poses[k], arm, x, r.data());
        for (std::size_t row = 0; row < m; ++row) set((k - range.first) * m + row, r[row]);
    }
}

VectorXd residuals_of(const Calibration& c, const std::vector<double>& v, PoseRange range) {
    VectorXd r(static_cast<Index>(range.count() * c.rows_per_pose()));
    all_residuals<double>(c, range, v, identification::estimates_of(c.inputs),
                          [&](std::size_t row, double value) { r[static_cast<Index>(row)] = value; });
    return r;
}

MatrixXd jacobian_of(const Calibration& c, const std::vector<double>& v, PoseRange range) {
    const std::vector<double> x = identification::estimates_of(c.inputs);
    return identification::jacobian_of(
        v, range.count() * c.rows_per_pose(),
        [&](const auto& at, const auto& set) { all_residuals<Dual>(c, range, at, x, set); });
}

std::vector<double> start_of(const Calibration& c) {
    std::vector<double> v;
    for (const Unknown& u : c.unknowns) {
        const Eigen::Isometry3d& X = u.kind == UnknownKind::base ? c.X_MB : c.X_FT;
        if (u.kind == UnknownKind::parameter)
            v.push_back(c.robot().joints()[u.parameter.joint].values[u.parameter.parameter]);
        else
            v.push_back(u.coordinate < 3 ? X.translation()[static_cast<Index>(u.coordinate)] : 0.0);
    }
    return v;
}

/// Rotations of base and tool go over into X_MB and X_FT, so that the unknowns are small again.
void absorb_rotations(Calibration& c, std::vector<double>& v) {
    Eigen::Vector3d base = Eigen::Vector3d::Zero(), tool = base;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Unknown& u = c.unknowns[i];
        if (u.kind == UnknownKind::parameter) continue;
        const bool is_base = u.kind == UnknownKind::base;
        Eigen::Isometry3d& X = is_base ? c.X_MB : c.X_FT;
        const auto k = static_cast<Index>(u.coordinate);
        if (k < 3) {
            X.translation()[k] = v[i];
        } else {
            (is_base ? base : tool)[k - 3] = v[i];
            v[i] = 0.0;
        }
    }
    c.X_MB.linear() = (c.X_MB.linear() * rotation_from_zyx<double>(base)).eval();
    c.X_FT.linear() = (c.X_FT.linear() * rotation_from_zyx<double>(tool)).eval();
}

identification::FitFunctions functions_of(const Calibration& c) {
    return {[&c](const std::vector<double>& v) { return residuals_of(c, v, fitted(c)); },
            [&c](const std::vector<double>& v) { return jacobian_of(c, v, fitted(c)); }};
}

Message rows_in_words(const Calibration& c, const std::vector<std::size_t>& rows) {
    constexpr std::size_t most_named = 3;
    Message words;
    for (std::size_t k = 0; k < rows.size() && k < most_named; ++k) {
        const std::size_t m = c.rows_per_pose();
        const Message row = tell<"the %1 of %2">(coordinate_words(rows[k] % m), c.poses[rows[k] / m].name);
        words = words.empty() ? row : tell<"%1, %2">(words, row);
    }
    if (rows.size() > most_named) words = tell<"%1 and %2 more">(words, rows.size() - most_named);
    return words;
}

void warn_of_outlier(const Calibration& c, Index row, double size, Problems& problems) {
    const auto m = static_cast<Index>(c.rows_per_pose());
    const MeasuredPose& pose = c.poses[static_cast<std::size_t>(row / m)];
    Message words = tell<
        "pose %1: the residual of its %2 is %3 times its standard uncertainty (limit %4). "
        "Look at this pose first; hold it back by use = check">(
        pose.name, coordinate_words(static_cast<std::size_t>(row % m)), Message::number(format_short(size)),
        Message::number(format_short(c.statistics.limit)));
    if (!c.statistics.alike.empty())
        words = tell<"%1. An error of it cannot be told apart from one of %2">(
            words, rows_in_words(c, c.statistics.alike));
    problems.add({.severity = Severity::warning,
                  .path = pose.source,
                  .message = std::move(words),
                  .remedies = {{tell<"hold it back">(), {{pose.source + "/use", "check"}}}}});
}

/// Warns of residuals that the uncertainties do not explain.
void warn_of_residuals(const Calibration& c, Problems& problems) {
    const PoseStatistics& s = c.statistics;
    if (s.has_outlier()) warn_of_outlier(c, s.worst_row(), s.worst_size(), problems);
    if (!s.scatters_too_much()) return;
    Problem problem{
        .severity = Severity::warning,
        .path = fields().place(&Calibration::measured),
        .message =
            tell<"the residuals are %1 times as large as the uncertainties of points and readings explain: "
                 "there is more than these (a joint's elasticity, temperature, an outlier), and the "
                 "uncertainty of the parameters is stated too small">(
                Message::number(format_short(s.scatter)))};
    if (c.uncertainties == evidence::UncertaintiesFrom::stated && s.evidence.readings)
        problem.remedies = {remedy_as_seen(fields().place(&Calibration::uncertainties))};
    problems.add(std::move(problem));
}

void warn_of_weakness(const Calibration& c, const std::string& place, Problems& problems) {
    const double condition = condition_of(c.statistics);
    if (condition < identification::most_condition) return;
    problems.warning(
        place,
        tell<
            "these poses hardly tell %1 apart (condition %2): turn more joints further, or hold one of them">(
            least_told(c.statistics, c.names()), Message::number(format_short(condition, 2))));
}

class Fit {
public:
    Fit(Calibration& c, Problems& problems)
        : c_(c),
          problems_(problems),
          place_(c.simulated ? fields().place(&Calibration::ball) : fields().place(&Calibration::measured)) {}

    bool run() {
        if (!c_.simulated) approach();
        find_weights();
        select();
        if (c_.first_parameter() == c_.unknowns.size())
            return refuse(tell<"no parameter of the arm can be told from these poses: every one of them is "
                               "coupled with others or held">());
        if (c_.rows() <= c_.unknowns.size())
            return refuse(tell<"the poses of the fit give %1 coordinates, no more than there are unknowns to "
                               "find: measure more poses, or hold parameters">(c_.rows()));
        Calibration nominal = without_parameters();
        std::vector<double> v = start_of(c_);
        if (!minimise(functions_of(c_), w_, v))
            return refuse(tell<"the fit does not converge: look for exchanged poses, readings of the wrong "
                               "sign or in another unit, and for a nominal robot that is another arm">());
        absorb_rotations(c_, v);
        c_.solution = v;
        const MatrixXd design = jacobian_of(c_, c_.solution, fitted(c_));
        const auto gain = identification::gain_of(w_.asDiagonal() * design, w_);
        if (!gain)
            return refuse(tell<"at the solution the unknowns cannot be told apart; hold one of those that "
                               "the table of observability names">());
        c_.gain = gain->gain;
        find_statistics(*gain, design, nominal);
        if (!c_.simulated) warn_of_residuals(c_, problems_);
        warn_of_weakness(c_, place_, problems_);
        return true;
    }

private:
    bool refuse(const Message& message) {
        problems_.error(place_, message);
        return false;
    }

    /// Base and ball or tool by turns, each where it fits the measured poses best with the nominal arm: the
    /// fit then begins where the place that was stated of the ball does not matter, and what the poses can
    /// tell is judged where they are. The sum of squares falls with each turn.
    void approach() {
        constexpr int most_turns = 200;
        std::vector<Eigen::Isometry3d> flanges;
        for (std::size_t k = 0; k < c_.fitted_poses; ++k)
            flanges.push_back(link_frames(c_.robot(), c_.poses[k].q)[c_.poses[k].q.size()]);
        for (int turn = 0; turn < most_turns; ++turn) {
            if (c_.base_fitted) register_base(flanges);
            if (!c_.tool_fitted) return;
            const Eigen::Vector3d before = c_.X_FT.translation();
            register_tool(flanges);
            if ((c_.X_FT.translation() - before).norm() < 1e-6 && turn > 0) return;
        }
    }

    /// The places of the ball or tool by the nominal arm onto the measured ones.
    void register_base(const std::vector<Eigen::Isometry3d>& flanges) {
        const auto n = static_cast<Index>(flanges.size());
        Eigen::Matrix3Xd from(3, n), to(3, n);
        for (Index k = 0; k < n; ++k) {
            from.col(k) = flanges[static_cast<std::size_t>(k)] * c_.X_FT.translation();
            to.col(k) = c_.poses[static_cast<std::size_t>(k)].p;
        }
        c_.X_MB = Eigen::Isometry3d(Eigen::umeyama(from, to, false));
    }

    /// The mean of where each pose puts it in the frame of the last link.
    void register_tool(const std::vector<Eigen::Isometry3d>& flanges) {
        Eigen::Vector3d p = Eigen::Vector3d::Zero();
        Eigen::Matrix3d R = Eigen::Matrix3d::Zero();
        for (std::size_t k = 0; k < flanges.size(); ++k) {
            const Eigen::Isometry3d X_FM = (c_.X_MB * flanges[k]).inverse();
            p += X_FM * c_.poses[k].p / static_cast<double>(flanges.size());
            R += X_FM.linear() * c_.poses[k].R;
        }
        c_.X_FT.translation() = p;
        if (!c_.with_orientation) return;
        c_.X_FT.linear() = nearest_rotation(R);
    }

    void find_weights() {
        double reach = 1e-3;
        bool all = true;
        for (std::size_t k = 0; k < c_.fitted_poses; ++k)
            for (std::size_t row = 0; row < c_.rows_per_pose(); ++row) {
                const double u = standard_uncertainty_of(c_.inputs, c_.poses[k].first_input + row);
                c_.weights.push_back(u > 0.0 ? 1.0 / u : 0.0);
                all = all && u > 0.0;
                reach = std::max(reach, (c_.poses[k].p - c_.X_MB.translation()).norm());
            }
        if (!all)  // exact coordinates: lengths alike, angles as lengths at the reach of the arm
            for (std::size_t i = 0; i < c_.weights.size(); ++i)
                c_.weights[i] = i % c_.rows_per_pose() < 3 ? 1.0 : reach;
        w_ = Eigen::Map<const VectorXd>(c_.weights.data(), static_cast<Index>(c_.weights.size()));
    }

    void select() {
        const MatrixXd A = w_.asDiagonal() * jacobian_of(c_, start_of(c_), fitted(c_));
        auto [told, held] = identification::told_apart(
            A, c_.names(), tell<"does not move the measured points in any pose">());
        std::vector<Unknown> unknowns;
        for (const std::size_t i : told) unknowns.push_back(c_.unknowns[i]);
        c_.unknowns = std::move(unknowns);
        c_.held.insert(c_.held.end(), held.begin(), held.end());
    }

    Calibration without_parameters() const {
        Calibration other = c_;
        other.unknowns.resize(c_.first_parameter());
        std::vector<double> v = start_of(other);
        if (!minimise(functions_of(other), w_, v)) v = start_of(other);
        other.solution = v;
        return other;
    }

    /// Residuals of a range of poses by components, the unknowns as they are.
    MatrixXd residual_sensitivity(PoseRange range) const {
        return scaled_sensitivity(c_.inputs, range.count() * c_.rows_per_pose(),
                                  [&](const EstimatedInputs& x, const auto& set) {
                                      all_residuals<Dual>(c_, range, c_.solution, x, set);
                                  });
    }

    void find_statistics(const identification::Gain& gain, const MatrixXd& design,
                         const Calibration& nominal) {
        PoseStatistics& s = c_.statistics;
        const MatrixXd from_inputs = residual_sensitivity(fitted(c_));
        take_statistics(s, gain, residuals_of(c_, c_.solution, fitted(c_)), design, from_inputs, w_,
                        identification::TestBy::scatter);
        c_.inverse_u = identification::inverse_uncertainties(s.covariance);
        if (!c_.simulated) find_evidence(c_, design, from_inputs);
        if (checks(c_).count() == 0) return;
        const MatrixXd D = jacobian_of(c_, c_.solution, checks(c_)) * (c_.gain * from_inputs) -
                           residual_sensitivity(checks(c_));
        s.deviations = positions_of(-residuals_of(c_, c_.solution, checks(c_)));
        s.before = positions_of(-residuals_of(nominal, nominal.solution, checks(c_)));
        s.u_deviations = positions_of(D.rowwise().norm());
    }

    VectorXd positions_of(const VectorXd& rows) const {
        const auto m = static_cast<Index>(c_.rows_per_pose());
        VectorXd positions(3 * rows.size() / m);
        for (Index k = 0; k < rows.size() / m; ++k) positions.segment<3>(3 * k) = rows.segment<3>(m * k);
        return positions;
    }

    Calibration& c_;
    Problems& problems_;
    std::string place_;
    VectorXd w_;
};

}  // namespace

bool fit(Calibration& c, Problems& problems) {
    return Fit(c, problems).run();
}

}  // namespace covaria::pose_calibration
