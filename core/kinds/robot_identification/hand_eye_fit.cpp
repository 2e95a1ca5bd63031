// Start, fit and evidence of a hand-eye calibration.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/kinds/robot_identification/hand_eye.h"
#include "core/kinds/robot_identification/input_sensitivity.h"
#include "core/kinds/robot_identification/reading_figures.h"
#include "core/math/decompositions.h"
#include "core/math/nearest_rotation.h"
#include "core/text/numbers.h"

namespace covaria::hand_eye {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct PairRange {
    std::size_t first, last;
    std::size_t count() const { return last - first; }
};
PairRange fitted(const Calibration& c) {
    return {0, c.fitted_pairs};
}
PairRange checks(const Calibration& c) {
    return {c.fitted_pairs, c.pairs.size()};
}

/// Residuals of a range of pairs: `set(row, value)`.
template <class Real, class In, class Set>
void all_residuals(const Calibration& c, PairRange range, const Places<Real>& places, const In& x, Set set) {
    const std::size_t m = c.rows_per_pair();
    std::array<Real, 6> r;
    for (std::size_t k = range.first; k < range.last; ++k) {
        residuals<Real>(c, c.pairs[k], places, x, r.data());
        for (std::size_t row = 0; row < m; ++row) set((k - range.first) * m + row, r[row]);
    }
}

VectorXd residuals_of(const Calibration& c, const std::vector<double>& v, PairRange range) {
    VectorXd r(static_cast<Index>(range.count() * c.rows_per_pair()));
    all_residuals<double>(c, range, places_of<double>(c, v), identification::estimates_of(c.inputs),
                          [&](std::size_t row, double value) { r[static_cast<Index>(row)] = value; });
    return r;
}

MatrixXd jacobian_of(const Calibration& c, const std::vector<double>& v, PairRange range) {
    const std::vector<double> x = identification::estimates_of(c.inputs);
    return identification::jacobian_of(v, range.count() * c.rows_per_pair(),
                                       [&](const auto& at, const auto& set) {
                                           all_residuals<Dual>(c, range, places_of<Dual>(c, at), x, set);
                                       });
}

/// Residuals of a range of pairs by components, the unknowns as they are.
MatrixXd residual_sensitivity(const Calibration& c, PairRange range) {
    const auto places = places_of<Dual>(c, c.solution);
    return scaled_sensitivity(
        c.inputs, range.count() * c.rows_per_pair(),
        [&](const EstimatedInputs& x, const auto& set) { all_residuals<Dual>(c, range, places, x, set); });
}

/// vec(M X) = (I x M) vec(X); vec(X N) = (N^T x I) vec(X).
Eigen::Matrix<double, 9, 9> before(const Matrix3d& M) {
    Eigen::Matrix<double, 9, 9> K = Eigen::Matrix<double, 9, 9>::Zero();
    for (int b = 0; b < 3; ++b) K.block<3, 3>(3 * b, 3 * b) = M;
    return K;
}
Eigen::Matrix<double, 9, 9> behind(const Matrix3d& N) {
    Eigen::Matrix<double, 9, 9> K = Eigen::Matrix<double, 9, 9>::Zero();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            K.block<3, 3>(3 * row, 3 * column) = N(column, row) * Matrix3d::Identity();
    return K;
}

/// B in A X = Z B: the target in the frame of what stands still.
Eigen::Isometry3d right_hand_side(const Calibration& c, const Pair& pair) {
    Eigen::Isometry3d B = Eigen::Isometry3d::Identity();
    B.linear() = pair.R_measured;
    B.translation() = pair.p_measured;
    return c.mount == Mount::target ? B : B.inverse();
}

/// Rotations first: R_A R_X - R_Z R_B = 0 is linear in both; positions then follow linearly.
void start_with_orientation(Calibration& c) {
    const auto n = static_cast<Index>(c.fitted_pairs);
    MatrixXd M(9 * n, 18);
    for (Index k = 0; k < n; ++k) {
        const Pair& pair = c.pairs[static_cast<std::size_t>(k)];
        M.block<9, 9>(9 * k, 0) = before(pair.R_BF);
        M.block<9, 9>(9 * k, 9) = -behind(right_hand_side(c, pair).linear());
    }
    const auto svd = singular_values(M, Eigen::ComputeThinV);
    const VectorXd null = svd.matrixV().rightCols<1>();
    Matrix3d X = Eigen::Map<const Matrix3d>(null.data()), Z = Eigen::Map<const Matrix3d>(null.data() + 9);
    if (X.determinant() < 0.0) {
        X = -X;
        Z = -Z;
    }
    c.X.linear() = nearest_rotation(X);
    c.Z.linear() = nearest_rotation(Z);
    MatrixXd A(3 * n, 6);
    VectorXd b(3 * n);
    for (Index k = 0; k < n; ++k) {
        const Pair& pair = c.pairs[static_cast<std::size_t>(k)];
        A.block<3, 3>(3 * k, 0) = pair.R_BF;
        A.block<3, 3>(3 * k, 3) = -Matrix3d::Identity();
        b.segment<3>(3 * k) = c.Z.linear() * right_hand_side(c, pair).translation() - pair.p_BF;
    }
    const VectorXd found = A.completeOrthogonalDecomposition().solve(b);
    c.X.translation() = found.head<3>();
    c.Z.translation() = found.tail<3>();
}

/// Of points alone: R_A p_X + p_A = R_Z p + p_Z where the target moves, R_A (R_X p + p_X) + p_A = p_Z where
/// the instrument does; linear in the rotation's nine numbers and both places.
void start_with_points(Calibration& c) {
    const auto n = static_cast<Index>(c.fitted_pairs);
    const bool target = c.mount == Mount::target;
    MatrixXd A(3 * n, 15);
    VectorXd b(3 * n);
    for (Index k = 0; k < n; ++k) {
        const Pair& pair = c.pairs[static_cast<std::size_t>(k)];
        const Matrix3d turned = target ? Matrix3d(-Matrix3d::Identity()) : pair.R_BF;
        for (int i = 0; i < 3; ++i) A.block<3, 3>(3 * k, 3 * i) = pair.p_measured[i] * turned;
        A.block<3, 3>(3 * k, 9) = pair.R_BF;
        A.block<3, 3>(3 * k, 12) = -Matrix3d::Identity();
        b.segment<3>(3 * k) = -pair.p_BF;
    }
    const VectorXd found = A.completeOrthogonalDecomposition().solve(b);
    (target ? c.Z : c.X).linear() = nearest_rotation(Eigen::Map<const Matrix3d>(found.data()));
    c.X.translation() = found.segment<3>(9);
    c.Z.translation() = found.segment<3>(12);
}

std::vector<double> values_of(const Calibration& c) {
    std::vector<double> v;
    for (const Unknown& u : c.unknowns)
        v.push_back(u.coordinate < 3 ? (u.of_X ? c.X : c.Z).translation()[static_cast<Index>(u.coordinate)]
                                     : 0.0);
    return v;
}

void absorb(Calibration& c, std::vector<double>& v) {
    const auto places = places_of<double>(c, v);
    c.X.linear() = places.R_X;
    c.Z.linear() = places.R_Z;
    c.X.translation() = places.p_X;
    c.Z.translation() = places.p_Z;
    for (std::size_t i = 0; i < v.size(); ++i)
        if (c.unknowns[i].coordinate >= 3) v[i] = 0.0;
}

FigureOfComponent figure_of(const UncertaintyComponent& component, bool turn, bool robot) {
    const auto& f = fields();
    if (robot)
        return turn ? FigureOfComponent{"4", tell<"orientations of the flange">(), component.unit,
                                        f.place(&Calibration::u_robot_angle)}
                    : FigureOfComponent{"3", tell<"positions of the flange">(), component.unit,
                                        f.place(&Calibration::u_robot_position)};
    return turn ? FigureOfComponent{"2", tell<"measured orientations">(), component.unit,
                                    f.place(&Calibration::u_angle)}
                : FigureOfComponent{"1", tell<"measured places">(), component.unit,
                                    f.place(&Calibration::u_position)};
}

void find_evidence(Calibration& c, const MatrixXd& design, const MatrixXd& shares) {
    auto readings = std::make_shared<evidence::RedundantReadings>();
    readings->design = design.sparseView();
    readings->residuals = c.statistics.residuals;
    FiguresOfReadings figures(c.inputs);
    for (std::size_t k = 0; k < c.fitted_pairs; ++k)
        for (const bool robot : {false, true}) {
            const std::size_t first = robot ? c.pairs[k].robot_input : c.pairs[k].measured_input;
            if (first == nothing) continue;
            for (std::size_t i = 0; i < (robot ? 6 : c.rows_per_pair()); ++i)
                figures.take(first + i, k, [&](const UncertaintyComponent& component, const InputQuantity&) {
                    return figure_of(component, i >= 3, robot);
                });
        }
    ComponentsOfFigures of_figures = add_figures(c.inputs, figures.of_one_owner(), shares, *readings);
    if (of_figures.empty()) return;
    readings->take_over = take_over_of_uncertainties();
    static const char* const rows[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < c.fitted_pairs; ++k)
        for (std::size_t row = 0; row < c.rows_per_pair(); ++row)
            readings->names.push_back(
                row < 3 ? tell<"%1, %2">(c.pairs[k].name, rows[row])
                        : tell<"%1, %2">(c.pairs[k].name, tell<"rotation about %1">(rows[row - 3])));
    name_standardised(c.statistics, *readings);
    c.statistics.evidence = {std::move(readings), std::move(of_figures)};
}

/// Inverse standard uncertainties; of exact readings lengths alike, angles as lengths at the reach of the
/// arm.
VectorXd weights_of(const Calibration& c) {
    const std::size_t m = c.rows_per_pair();
    VectorXd w(static_cast<Index>(c.rows()));
    double reach = 1e-3;
    for (std::size_t k = 0; k < c.fitted_pairs; ++k) reach = std::max(reach, c.pairs[k].p_BF.norm());
    const bool exact = !(c.u_position > 0.0) || (c.with_orientation && !(c.u_angle > 0.0));
    for (std::size_t row = 0; row < c.rows(); ++row) {
        const bool turn = row % m >= 3;
        const double u =
            std::hypot(turn ? c.u_angle : c.u_position, turn ? c.u_robot_angle : c.u_robot_position);
        w[static_cast<Index>(row)] = exact ? (turn ? reach : 1.0) : 1.0 / u;
    }
    return w;
}

void warn(const Calibration& c, Problems& problems) {
    const auto& s = c.statistics;
    if (const double condition = condition_of(s); condition >= identification::most_condition)
        problems.warning(
            fields().place(&Calibration::stated),
            tell<"these poses hardly tell %1 apart (condition %2): turn the flange further, about "
                 "other axes">(least_told(s, c.names()), Message::number(format_short(condition, 2))));
    const std::size_t m = c.rows_per_pair();
    if (s.has_outlier()) {
        const Pair& pair = c.pairs[static_cast<std::size_t>(s.worst_row()) / m];
        problems.add(
            {.severity = Severity::warning,
             .path = pair.source,
             .message =
                 tell<"pose %1: a residual is %2 times its standard uncertainty (limit %3). Look at this "
                      "pose first; hold it back by use = check">(
                     pair.name, Message::number(format_short(s.worst_size())),
                     Message::number(format_short(s.limit))),
             .remedies = {{tell<"hold it back">(), {{pair.source + "/use", "check"}}}}});
    }
    if (!s.scatters_too_much()) return;
    Problem problem{
        .severity = Severity::warning,
        .path = fields().place(&Calibration::stated),
        .message = tell<"the residuals are %1 times as large as the stated uncertainties explain: "
                        "errors of the arm, of the instrument, an outlier; X and Z are then less "
                        "certain than stated">(Message::number(format_short(s.scatter)))};
    if (c.uncertainties == evidence::UncertaintiesFrom::stated && s.evidence.readings)
        problem.remedies = {remedy_as_seen(fields().place(&Calibration::uncertainties))};
    problems.add(std::move(problem));
}

}  // namespace

bool fit(Calibration& c, Problems& problems) {
    const auto refuse = [&](const Message& message) {
        problems.error(fields().place(&Calibration::stated), message);
        return false;
    };
    c.with_orientation ? start_with_orientation(c) : start_with_points(c);
    for (const bool of_X : {true, false})
        for (std::size_t k = 0; k < unknowns_of_a_pose; ++k) c.unknowns.push_back({of_X, k});
    const VectorXd w = weights_of(c);
    auto [told, held] = identification::told_apart(w.asDiagonal() * jacobian_of(c, values_of(c), fitted(c)),
                                                   c.names(), tell<"changes no reading">());
    std::vector<Unknown> unknowns;
    for (const std::size_t i : told) unknowns.push_back(c.unknowns[i]);
    c.unknowns = std::move(unknowns);
    c.held = std::move(held);
    std::vector<double> v = values_of(c);
    const identification::FitFunctions functions{
        [&](const std::vector<double>& at) { return residuals_of(c, at, fitted(c)); },
        [&](const std::vector<double>& at) { return jacobian_of(c, at, fitted(c)); }};
    if (c.unknowns.empty() || !minimise(functions, w, v))
        return refuse(
            tell<"the fit does not converge: look for exchanged poses, angles in another order or unit, "
                 "and for what the flange carries">());
    absorb(c, v);
    c.solution = v;
    const MatrixXd design = jacobian_of(c, v, fitted(c));
    const auto gain = identification::gain_of(w.asDiagonal() * design, w);
    if (!gain) return refuse(tell<"at the solution X and Z cannot be told apart">());
    c.gain = gain->gain;
    const MatrixXd from_inputs = residual_sensitivity(c, fitted(c));
    take_statistics(c.statistics, *gain, residuals_of(c, v, fitted(c)), design, from_inputs, w,
                    identification::TestBy::covariance);
    c.inverse_u = identification::inverse_uncertainties(c.statistics.covariance);
    find_evidence(c, design, from_inputs);
    if (checks(c).count() > 0) {
        const MatrixXd D =
            jacobian_of(c, v, checks(c)) * (c.gain * from_inputs) - residual_sensitivity(c, checks(c));
        c.deviations = -residuals_of(c, v, checks(c));
        c.u_deviations = D.rowwise().norm();
    }
    warn(c, problems);
    return true;
}

}  // namespace covaria::hand_eye
