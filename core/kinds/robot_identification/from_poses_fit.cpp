#include "core/kinds/robot_identification/from_poses_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/kinds/robot_identification/input_sensitivity.h"
#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria::pose_calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Estimates of all inputs; their deviations are what a trial changes.
std::vector<double> estimates(const InputSet& inputs) {
    std::vector<double> x;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x.push_back(estimate_of(inputs, i));
    return x;
}

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

VectorXd residuals_of(const Calibration& c, const std::vector<double>& v, PoseRange range) {
    const std::vector<double> x = estimates(c.inputs);
    const CalibratedArm<double> arm = arm_of<double>(c, v);
    const auto m = static_cast<Index>(c.rows_per_pose());
    VectorXd r(static_cast<Index>(range.count()) * m);
    for (std::size_t k = range.first; k < range.last; ++k)
        residuals<double>(c, c.poses[k], arm, x, r.data() + static_cast<Index>(k - range.first) * m);
    return r;
}

/// d(calculated)/d(unknown) = −d(residual)/d(unknown).
MatrixXd jacobian_of(const Calibration& c, const std::vector<double>& v, PoseRange range) {
    const std::vector<double> x = estimates(c.inputs);
    const std::size_t m = c.rows_per_pose(), n = v.size();
    MatrixXd A(static_cast<Index>(range.count() * m), static_cast<Index>(n));
    std::vector<Dual> variables(v.begin(), v.end());
    std::array<Dual, 6> r;
    for (std::size_t first = 0; first < n; first += Dual::size) {
        const std::size_t last = std::min(first + Dual::size, n);
        for (std::size_t i = first; i < last; ++i) variables[i] = Dual::variable(v[i], i - first);
        const CalibratedArm<Dual> arm = arm_of<Dual>(c, variables);
        for (std::size_t k = range.first; k < range.last; ++k) {
            residuals<Dual>(c, c.poses[k], arm, x, r.data());
            for (std::size_t row = 0; row < m; ++row)
                for (std::size_t i = first; i < last; ++i)
                    A(static_cast<Index>((k - range.first) * m + row), static_cast<Index>(i)) =
                        -r[row].partials()[i - first];
        }
        for (std::size_t i = first; i < last; ++i) variables[i] = Dual(v[i]);
    }
    return A;
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

/// Levenberg-Marquardt on the weighted residuals: a step that does not lower them is damped more and tried
/// again from where it began. False: no convergence.
bool minimise(const Calibration& c, const VectorXd& w, std::vector<double>& v) {
    constexpr int most_steps = 200, most_trials = 1000;
    constexpr double most_damping = 1e12;
    double damping = 1e-6;
    VectorXd r = w.cwiseProduct(residuals_of(c, v, fitted(c)));
    MatrixXd A, N;
    VectorXd scale;
    for (int step = 0, trial = 0; step < most_steps && trial < most_trials; ++trial) {
        if (A.size() == 0) {
            A = w.asDiagonal() * jacobian_of(c, v, fitted(c));
            scale = A.colwise().norm();
            N = A.transpose() * A;
        }
        MatrixXd damped = N;
        damped.diagonal() += damping * scale.cwiseAbs2();
        const auto solved = damped_step(damped, A.transpose() * r);
        if (!solved) {
            if ((damping *= 10.0) > most_damping) return false;
            continue;
        }
        const VectorXd& dv = *solved;
        std::vector<double> next = v;
        for (std::size_t i = 0; i < v.size(); ++i) next[i] += dv[static_cast<Index>(i)];
        const VectorXd r_next = w.cwiseProduct(residuals_of(c, next, fitted(c)));
        if (dv.cwiseProduct(scale).norm() < 1e-9 * std::max(1e-3, r.norm()) || dv.norm() < 1e-13) {
            v = next;
            return v.empty() || r_next.allFinite();
        }
        if (r_next.norm() < r.norm()) {
            v = std::move(next);
            r = r_next;
            A.resize(0, 0);
            ++step;
            damping = std::max(1e-15, damping / 10.0);
        } else if ((damping *= 10.0) > most_damping) {
            return false;
        }
    }
    return false;
}

Index worst_row(const FitStatistics& s) {
    Index worst = 0;
    s.residuals.cwiseAbs().cwiseQuotient(s.u_residuals.cwiseMax(1e-300)).maxCoeff(&worst);
    return worst;
}

/// Rows whose residuals hang together with that of `row` so that a test of one is a test of the others.
/// `deviations`: residuals by components.
std::vector<std::size_t> rows_alike(const MatrixXd& deviations, Index row) {
    constexpr double alike = 0.98;
    const VectorXd products = deviations * deviations.row(row).transpose();
    const VectorXd lengths = deviations.rowwise().norm();
    const double least = 1e-6 * lengths.maxCoeff();
    std::vector<std::size_t> rows;
    for (Index i = 0; i < products.size(); ++i)
        if (i != row && lengths[i] > least && std::abs(products[i]) > alike * lengths[i] * lengths[row])
            rows.push_back(static_cast<std::size_t>(i));
    return rows;
}

void take_deviations(FitStatistics& s, const MatrixXd& deviations) {
    s.u_residuals = deviations.rowwise().norm();
    s.alike = rows_alike(deviations, worst_row(s));
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
        pose.name, coordinate_words(static_cast<std::size_t>(row % m)), format_short(size),
        format_short(c.statistics.limit));
    if (!c.statistics.alike.empty())
        words = tell<"%1. An error of it cannot be told apart from one of %2">(
            words, rows_in_words(c, c.statistics.alike));
    problems.warning(pose.source, std::move(words));
}

/// Warns of residuals that the uncertainties do not explain.
void warn_of_residuals(const Calibration& c, Problems& problems) {
    const FitStatistics& s = c.statistics;
    const auto freedom = static_cast<double>(c.rows() - c.unknowns.size());
    if (freedom < 1.0) return;
    const Index worst = worst_row(s);
    const double size = std::abs(s.residuals[worst]) / std::max(s.u_residuals[worst], 1e-300);
    if (size > s.limit && s.u_residuals[worst] > 0.0) warn_of_outlier(c, worst, size, problems);
    if (!(s.scatter > std::sqrt(chi_squared_quantile(0.99, freedom) / freedom))) return;
    Problem problem{
        .severity = Severity::warning,
        .path = fields().place(&Calibration::measured),
        .message =
            tell<"the residuals are %1 times as large as the uncertainties of points and readings explain: "
                 "there is more than these (a joint's elasticity, temperature, an outlier), and the "
                 "uncertainty of the parameters is stated too small">(format_short(s.scatter))};
    if (c.uncertainties == evidence::UncertaintiesFrom::stated && s.evidence.readings)
        problem.remedies = {remedy_as_seen(fields().place(&Calibration::uncertainties))};
    problems.add(std::move(problem));
}

void warn_of_weakness(const Calibration& c, const std::string& place, Problems& problems) {
    const FitStatistics& s = c.statistics;
    const double condition = s.singular_values[0] / s.singular_values[s.singular_values.size() - 1];
    if (condition < 1e4) return;
    Message names;
    for (Index i = 0; i < s.weakest.size(); ++i) {
        if (!(std::abs(s.weakest[i]) > 0.3)) continue;
        if (!names.empty()) names += ", ";
        names += c.unknowns[static_cast<std::size_t>(i)].name();
    }
    problems.warning(
        place,
        tell<
            "these poses hardly tell %1 apart (condition %2): turn more joints further, or hold one of them">(
            names, format_short(condition, 2)));
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
        if (!minimise(c_, w_, v))
            return refuse(tell<"the fit does not converge: look for exchanged poses, readings of the wrong "
                               "sign or in another unit, and for a nominal robot that is another arm">());
        absorb_rotations(c_, v);
        c_.solution = v;
        if (!find_gain()) return false;
        find_statistics(nominal);
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
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Eigen::Vector3d signs(1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant());
        c_.X_FT.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
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

    /// Goes through the candidates in their order and keeps those that move the points in a way that those
    /// kept before do not (Gram-Schmidt on columns of length one).
    void select() {
        const MatrixXd A = w_.asDiagonal() * jacobian_of(c_, start_of(c_), fitted(c_));
        const double largest = A.colwise().norm().maxCoeff();
        MatrixXd Q(A.rows(), 0), kept(A.rows(), 0);
        std::vector<Unknown> unknowns;
        for (std::size_t i = 0; i < c_.unknowns.size(); ++i) {
            const double length = A.col(static_cast<Index>(i)).norm();
            if (length < 1e-9 * largest) {
                c_.held.push_back(
                    {c_.unknowns[i].name(), tell<"does not move the measured points in any pose">()});
                continue;
            }
            const VectorXd column = A.col(static_cast<Index>(i)) / length;
            VectorXd rest = column - Q * (Q.transpose() * column);
            rest -= Q * (Q.transpose() * rest);
            if (rest.norm() < 1e-7) {
                c_.held.push_back({c_.unknowns[i].name(), coupling(kept, unknowns, column)});
                continue;
            }
            Q.conservativeResize(Eigen::NoChange, Q.cols() + 1);
            Q.rightCols<1>() = rest.normalized();
            kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
            kept.rightCols<1>() = column;
            unknowns.push_back(c_.unknowns[i]);
        }
        c_.unknowns = std::move(unknowns);
    }

    Message coupling(const MatrixXd& kept, const std::vector<Unknown>& unknowns, const VectorXd& column) {
        const VectorXd shares = kept.colPivHouseholderQr().solve(column);
        Message names;
        for (Index i = 0; i < shares.size(); ++i)
            if (std::abs(shares[i]) > 1e-4)
                names += Message(names.empty() ? "" : ", ") + unknowns[static_cast<std::size_t>(i)].name();
        return tell<"moves the measured points as %1 can: coupled with it, held at its nominal value">(names);
    }

    Calibration without_parameters() const {
        Calibration other = c_;
        other.unknowns.resize(c_.first_parameter());
        std::vector<double> v = start_of(other);
        if (!minimise(other, w_, v)) v = start_of(other);
        other.solution = v;
        return other;
    }

    bool find_gain() {
        const MatrixXd A = w_.asDiagonal() * jacobian_of(c_, c_.solution, fitted(c_));
        const VectorXd length = A.colwise().norm();
        const MatrixXd scaled = A * length.cwiseInverse().asDiagonal();
        const auto svd = singular_values(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
        const VectorXd& s = svd.singularValues();
        if (!(s[s.size() - 1] > 1e-9 * s[0]))
            return refuse(tell<"at the solution the unknowns cannot be told apart; hold one of those that "
                               "the table of observability names">());
        c_.statistics.singular_values = s;
        c_.statistics.weakest = svd.matrixV().rightCols<1>();
        c_.gain = length.cwiseInverse().asDiagonal() * svd.matrixV() * s.cwiseInverse().asDiagonal() *
                  svd.matrixU().transpose() * w_.asDiagonal();
        return true;
    }

    /// Residuals of a range of poses by components, the unknowns as they are.
    MatrixXd residual_sensitivity(PoseRange range) const {
        const std::size_t m = c_.rows_per_pose();
        return scaled_sensitivity(c_.inputs, range.count() * m,
                                  [&](const EstimatedInputs& x, const auto& set) {
                                      const CalibratedArm<Dual> arm = arm_of<Dual>(c_, c_.solution);
                                      std::array<Dual, 6> r;
                                      for (std::size_t k = range.first; k < range.last; ++k) {
                                          residuals<Dual>(c_, c_.poses[k], arm, x, r.data());
                                          for (std::size_t row = 0; row < m; ++row)
                                              set((k - range.first) * m + row, r[row]);
                                      }
                                  });
    }

    void find_statistics(const Calibration& nominal) {
        FitStatistics& s = c_.statistics;
        const MatrixXd from_inputs = residual_sensitivity(fitted(c_)), unknowns = c_.gain * from_inputs;
        s.covariance = unknowns * unknowns.transpose();
        s.residuals = residuals_of(c_, c_.solution, fitted(c_));
        const MatrixXd design = jacobian_of(c_, c_.solution, fitted(c_));
        take_deviations(s, from_inputs - design * unknowns);
        const double expected = w_.cwiseProduct(s.u_residuals).squaredNorm();
        s.scatter = expected > 0.0 ? w_.cwiseProduct(s.residuals).norm() / std::sqrt(expected) : 0.0;
        const auto rows = static_cast<double>(s.residuals.size());
        s.limit = t_quantile(1.0 - 0.025 / rows, infinity);
        if (!c_.simulated) find_evidence(c_, design, from_inputs);
        if (checks(c_).count() == 0) return;
        const MatrixXd D =
            jacobian_of(c_, c_.solution, checks(c_)) * unknowns - residual_sensitivity(checks(c_));
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
