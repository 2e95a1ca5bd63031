#include "core/kinds/robot_identification/least_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"
#include "core/text/numbers.h"

namespace covaria::identification {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// A candidate moves the rows by less than this part of the most that one does: it moves nothing.
constexpr double least_length = 1e-9;
/// Part of a column of length one that those before it leave over: it is a combination of them.
constexpr double least_rest = 1e-7;

Message coupling(const MatrixXd& kept, const std::vector<std::size_t>& unknowns,
                 const std::vector<Message>& names, const VectorXd& column) {
    const VectorXd shares = kept.colPivHouseholderQr().solve(column);
    Message partners;
    for (Index i = 0; i < shares.size(); ++i)
        if (std::abs(shares[i]) > 1e-4)
            partners += Message(partners.empty() ? "" : ", ") + names[unknowns[static_cast<std::size_t>(i)]];
    return tell<"moves the measured points as %1 can: coupled with it, held at its nominal value">(partners);
}

/// Rows whose tests hang together with that of `row` so that a test of one is a test of the others.
/// `deviations`: what is tested by its independent causes.
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

/// Part of its uncertainty that a residual keeps: below it, rounding is all that is left.
constexpr double least_control = 1e-5;

/// What residuals scatter by themselves.
void test_by_scatter(FitStatistics& s, const VectorXd& weights) {
    s.w = VectorXd::Zero(s.residuals.size());
    for (Index i = 0; i < s.w.size(); ++i)
        if (s.u_residuals[i] > 0.0) s.w[i] = std::abs(s.residuals[i]) / s.u_residuals[i];
    const double expected = weights.cwiseProduct(s.u_residuals).squaredNorm();
    s.scatter = expected > 0.0 ? weights.cwiseProduct(s.residuals).norm() / std::sqrt(expected) : 0.0;
}

/// Tests by the covariance of all rows, so that what rows share, a known point or a scale, hides no error of
/// one of them. False where there are too many rows, or the covariance is singular.
bool test_whitened(FitStatistics& s, const MatrixXd& design, const MatrixXd& from_inputs) {
    constexpr Index most_rows = 600;
    const Index n = s.residuals.size();
    if (n > most_rows || n <= design.cols()) return false;
    const VectorXd own = from_inputs.rowwise().norm();
    if (!(own.minCoeff() > 0.0)) return false;
    const MatrixXd scaled = own.cwiseInverse().asDiagonal() * from_inputs;
    const Eigen::LLT<MatrixXd> covariance(scaled * scaled.transpose());
    if (covariance.info() != Eigen::Success) return false;
    const auto L = covariance.matrixL();
    if (!(MatrixXd(L).diagonal().minCoeff() > least_control)) return false;
    MatrixXd A = L.solve(own.cwiseInverse().asDiagonal() * design);
    const VectorXd sizes = A.colwise().norm();  // by themselves: A is overwritten while it is scaled
    A *= sizes.cwiseInverse().asDiagonal();
    const MatrixXd Q = Eigen::HouseholderQR<MatrixXd>(A).householderQ() * MatrixXd::Identity(n, A.cols());
    const VectorXd r = L.solve(s.residuals.cwiseQuotient(own));
    const VectorXd rest = r - Q * (Q.transpose() * r);
    MatrixXd P = L.solve(MatrixXd::Identity(n, n));
    const VectorXd lengths = P.colwise().norm();
    const VectorXd tested = P.transpose() * rest;
    P -= Q * (Q.transpose() * P);
    s.w = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i)
        if (const double u = P.col(i).norm(); u > least_control * lengths[i])
            s.w[i] = std::abs(tested[i]) / u;
    s.scatter = rest.norm() / std::sqrt(static_cast<double>(n - design.cols()));
    s.alike = rows_alike(P.transpose(), s.worst_row());
    return true;
}

/// The unknown with which unknown i is correlated most.
std::pair<std::size_t, double> partner_of(const MatrixXd& C, std::size_t i) {
    std::pair<std::size_t, double> most{i, 0.0};
    for (Index k = 0; k < C.cols(); ++k) {
        const auto row = static_cast<Index>(i);
        const double scale = std::sqrt(C(row, row) * C(k, k));
        if (k == row || !(scale > 0.0)) continue;
        if (const double r = C(row, k) / scale; std::abs(r) > std::abs(most.second))
            most = {static_cast<std::size_t>(k), r};
    }
    return most;
}

/// A short step is no sign of a minimum where damping makes it short: an undamped one would lower the
/// squares.
bool is_at_rest(MatrixXd N, const VectorXd& scale, const VectorXd& gradient, const VectorXd& r) {
    N.diagonal() += 1e-9 * scale.cwiseAbs2();
    const auto step = damped_step(N, gradient);
    return !step || step->dot(gradient) < 1e-3 * std::max(1e-6, r.squaredNorm());
}

Table coupling_table(const MatrixXd& covariance, const std::vector<Message>& names) {
    Table table{"coupling", "Strongest correlation of each unknown"};
    table.add("unknown");
    table.add("coupled with");
    table.add("r").symbol().figure(3);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto [other, r] = partner_of(covariance, i);
        if (other != i) table.row({names[i], names[other], r});
    }
    return table;
}

}  // namespace

std::vector<double> estimates_of(const InputSet& inputs) {
    std::vector<double> x;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x.push_back(estimate_of(inputs, i));
    return x;
}

bool minimise(const FitFunctions& fit, const VectorXd& w, std::vector<double>& v) {
    constexpr int most_steps = 200, most_trials = 1000;
    constexpr double most_damping = 1e12;
    double damping = 1e-6;
    VectorXd r = w.cwiseProduct(fit.residuals(v));
    MatrixXd A, N;
    VectorXd scale;
    for (int step = 0, trial = 0; step < most_steps && trial < most_trials; ++trial) {
        if (A.size() == 0) {
            A = w.asDiagonal() * fit.jacobian(v);
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
        const VectorXd r_next = w.cwiseProduct(fit.residuals(next));
        if (dv.cwiseProduct(scale).norm() < 1e-9 * std::max(1e-3, r.norm()) || dv.norm() < 1e-13) {
            v = next;
            return v.empty() || (r_next.allFinite() && is_at_rest(N, scale, A.transpose() * r, r));
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

Told told_apart(const MatrixXd& A, const std::vector<Message>& names, const Message& unmoved) {
    Told told;
    const double largest = A.cols() > 0 ? A.colwise().norm().maxCoeff() : 0.0;
    MatrixXd Q(A.rows(), 0), kept(A.rows(), 0);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double length = A.col(static_cast<Index>(i)).norm();
        if (!(length > least_length * largest)) {
            told.held.push_back({names[i], unmoved});
            continue;
        }
        const VectorXd column = A.col(static_cast<Index>(i)) / length;
        VectorXd rest = column - Q * (Q.transpose() * column);
        rest -= Q * (Q.transpose() * rest);
        if (rest.norm() < least_rest) {
            told.held.push_back({names[i], coupling(kept, told.unknowns, names, column)});
            continue;
        }
        Q.conservativeResize(Eigen::NoChange, Q.cols() + 1);
        Q.rightCols<1>() = rest.normalized();
        kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
        kept.rightCols<1>() = column;
        told.unknowns.push_back(i);
    }
    return told;
}

std::optional<Gain> gain_of(const MatrixXd& A, const VectorXd& w) {
    const VectorXd length = A.colwise().norm();
    const MatrixXd scaled = A * length.cwiseInverse().asDiagonal();
    const auto svd = singular_values(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const VectorXd& s = svd.singularValues();
    if (!(s[s.size() - 1] > 1e-9 * s[0])) return {};
    return Gain{length.cwiseInverse().asDiagonal() * svd.matrixV() * s.cwiseInverse().asDiagonal() *
                    svd.matrixU().transpose() * w.asDiagonal(),
                s, svd.matrixV().rightCols<1>()};
}

Index FitStatistics::worst_row() const {
    Index worst = 0;
    w.maxCoeff(&worst);
    return worst;
}

double FitStatistics::worst_size() const {
    return w.maxCoeff();
}

bool FitStatistics::has_outlier() const {
    return residuals.size() > covariance.rows() && worst_size() > limit;
}

bool FitStatistics::scatters_too_much() const {
    const auto freedom = static_cast<double>(residuals.size() - covariance.rows());
    return freedom >= 1.0 && scatter > std::sqrt(chi_squared_quantile(0.99, freedom) / freedom);
}

void take_statistics(FitStatistics& s, const Gain& gain, const VectorXd& residuals, const MatrixXd& design,
                     const MatrixXd& from_inputs, const VectorXd& weights, TestBy test) {
    const MatrixXd unknowns = gain.gain * from_inputs;
    s.singular_values = gain.singular_values;
    s.weakest = gain.weakest;
    s.covariance = unknowns * unknowns.transpose();
    s.residuals = residuals;
    const MatrixXd deviations = from_inputs - design * unknowns;
    s.u_residuals = deviations.rowwise().norm();
    const VectorXd own = from_inputs.rowwise().norm();
    for (Index i = 0; i < own.size(); ++i)
        if (!(s.u_residuals[i] > least_control * own[i])) s.u_residuals[i] = 0.0;
    s.limit = t_quantile(1.0 - 0.025 / static_cast<double>(residuals.size()), infinity);
    if (test == TestBy::covariance && test_whitened(s, design, from_inputs)) return;
    test_by_scatter(s, weights);
    s.alike = rows_alike(deviations, s.worst_row());
}

std::vector<double> inverse_uncertainties(const MatrixXd& covariance) {
    std::vector<double> inverse;
    for (const double variance : covariance.diagonal())
        inverse.push_back(1.0 / (variance > 0.0 ? std::sqrt(variance) : 1e-6));
    return inverse;
}

double condition_of(const FitStatistics& s) {
    return s.singular_values[0] / s.singular_values[s.singular_values.size() - 1];
}

Message least_told(const FitStatistics& s, const std::vector<Message>& names) {
    Message words;
    for (Index i = 0; i < s.weakest.size(); ++i)
        if (std::abs(s.weakest[i]) > 0.3)
            words += Message(words.empty() ? "" : ", ") + names[static_cast<std::size_t>(i)];
    return words;
}

std::vector<Table> observability_tables(const FitStatistics& s, const std::vector<Message>& names,
                                        const Message& what_the_rows_are) {
    Table table{"observability", "Observability"};
    table.add("quantity");
    table.add("value").figure(3);
    const auto add = [&](Message name, Cell value) { table.row({std::move(name), std::move(value)}); };
    const auto rows = static_cast<std::size_t>(s.residuals.size());
    add(what_the_rows_are, std::to_string(rows));
    add(tell<"unknowns (rank)">(), std::to_string(names.size()));
    add(tell<"degrees of freedom">(), std::to_string(rows - names.size()));
    add(tell<"condition of the fit">(), condition_of(s));
    add(tell<"smallest singular value">(), s.singular_values[s.singular_values.size() - 1]);
    add(tell<"residuals over what uncertainties explain">(), s.scatter);
    table.notes = {tell<"Singular values are those of the weighted Jacobian with columns of length one.">(),
                   tell<"Least well told apart: %1.">(least_told(s, names))};
    return {std::move(table), coupling_table(s.covariance, names)};
}

Table residual_table(const FitStatistics& s, const std::vector<std::string>& poses) {
    Table table{"residuals", "Residuals of the fit, measured less calculated"};
    table.add("pose");
    for (const char* axis : {"x", "y", "z"}) table.add(axis).in(Unit::of("um")).symbol().figure(3);
    table.add("largest over its u").figure(2);
    table.add("outlier test");
    const Index m = s.residuals.size() / static_cast<Index>(poses.size());
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const Index row = static_cast<Index>(k) * m;
        const double largest = s.w.segment(row, m).maxCoeff();
        table.row({poses[k], s.residuals[row], s.residuals[row + 1], s.residuals[row + 2], largest,
                   largest > s.limit ? tell<"outlier">() : Message()});
    }
    table.notes = {
        tell<"A residual beyond %1 times its own standard uncertainty is an outlier: 5 % for all residuals "
             "together (Bonferroni).">(Message::number(format_decimals(s.limit, 2)))};
    return table;
}

}  // namespace covaria::identification
