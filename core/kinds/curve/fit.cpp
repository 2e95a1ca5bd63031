#include "core/kinds/curve/fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/kinds/curve/covariance.h"

namespace covaria::curve {

namespace {

using Wide = long double;

class Fitter {
public:
    explicit Fitter(const CurveSetup& setup) : setup_(setup), n_(setup.points.size()) {
        double mean = 0.0;
        for (const Point& p : setup.points)
            weights_.push_back(setup.from_residuals ? 1.0 : 1.0 / (p.u_y * p.u_y));
        for (const double w : weights_) mean += w / double(n_);
        for (double& w : weights_) w /= mean;
    }

    std::optional<Fit> run() {
        std::vector<double> x;
        for (const Point& p : setup_.points) x.push_back(p.x);
        const auto zero = setup_.through_origin ? std::optional<double>(setup_.origin) : std::nullopt;
        const auto made = orthonormal_polynomials(x, weights_, setup_.coefficients(), zero);
        if (!made) return std::nullopt;
        fit_.polynomials = *made;
        tabulate();
        solve();
        if (setup_.has_covariance()) {
            if (!(setup_.has_u_x() ? solve_with_covariance() : solve_generalised())) return std::nullopt;
        } else if (setup_.has_u_x() && !solve_with_both()) {
            return std::nullopt;
        }
        judge();
        make_gain();
        make_powers();
        make_predictions();
        const auto finite = [](double v) { return std::isfinite(v); };
        if (!std::all_of(fit_.coefficients.begin(), fit_.coefficients.end(), finite) ||
            !std::isfinite(fit_.chi_squared + fit_.sum_of_squares))
            return std::nullopt;
        return std::move(fit_);
    }

private:
    Values<Wide> phi_at(double x) const {
        Values<Wide> phi, slope;
        const Polynomials& p = fit_.polynomials;
        p.at<Wide>((Wide(x) - p.centre) / p.half_width, phi, slope);
        return phi;
    }

    void tabulate() {
        for (const Point& p : setup_.points) phi_.push_back(phi_at(p.x));
    }

    Wide residual(std::size_t i) const {
        return setup_.points[i].y - sum_of(q_, phi_[i], fit_.polynomials.count);
    }

    /// Finds q by projection on the polynomials; repeated, since their coefficients are rounded.
    void solve() {
        q_.fill(0.0L);
        for (int pass = 0; pass < 4; ++pass) {
            Values<Wide> change;
            change.fill(0.0L);
            for (std::size_t i = 0; i < n_; ++i) {
                const Wide r = Wide(weights_[i]) * residual(i) / Wide(n_);
                for (std::size_t j = 0; j < fit_.polynomials.count; ++j) change[j] += r * phi_[i][j];
            }
            for (std::size_t j = 0; j < fit_.polynomials.count; ++j) q_[j] += change[j];
        }
    }

    bool solve_with_both() {
        Values<double> q{};
        for (std::size_t j = 0; j < fit_.polynomials.count; ++j) q[j] = double(q_[j]);
        const bool settled = fit_with_both<double>(
            setup_, fit_.polynomials, [&](std::size_t i) { return setup_.points[i].x; },
            [&](std::size_t i) { return setup_.points[i].y; }, q);
        for (std::size_t j = 0; j < fit_.polynomials.count; ++j) q_[j] = q[j];
        return settled;
    }

    Values<double> weights_of_terms() const {
        Values<double> q{};
        for (std::size_t j = 0; j < fit_.polynomials.count; ++j) q[j] = double(q_[j]);
        return q;
    }

    bool solve_with_covariance() {
        Values<double> q = weights_of_terms();
        const PointCovariance covariance(setup_, fit_.polynomials);
        const bool settled = fit_with_covariance<double>(
            covariance, fit_.polynomials, n_, [&](std::size_t i) { return setup_.points[i].x; },
            [&](std::size_t i) { return setup_.points[i].y; }, q, fit_.chi_squared);
        for (std::size_t j = 0; j < fit_.polynomials.count; ++j) q_[j] = q[j];
        return settled;
    }

    /// x are exact: q = (Phi^T V^-1 Phi)^-1 Phi^T V^-1 y (ISO/TS 28037:2010, 9), from residuals on, which
    /// keeps the digits.
    bool solve_generalised() {
        const auto n = Eigen::Index(n_), count = Eigen::Index(fit_.polynomials.count);
        const Eigen::LLT<Eigen::MatrixXd> factor(setup_.covariance.bottomRightCorner(n, n));
        if (factor.info() != Eigen::Success) return false;
        Eigen::MatrixXd phi(n, count);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < count; ++j) phi(i, j) = double(phi_[std::size_t(i)][std::size_t(j)]);
        const Eigen::MatrixXd weighted = factor.solve(phi);
        fit_.gain = (phi.transpose() * weighted).llt().solve(weighted.transpose());
        Eigen::VectorXd r(n);
        for (int pass = 0; pass < 3; ++pass) {
            for (Eigen::Index i = 0; i < n; ++i) r[i] = double(residual(std::size_t(i)));
            const Eigen::VectorXd change = fit_.gain * r;
            for (Eigen::Index j = 0; j < count; ++j) q_[std::size_t(j)] += Wide(change[j]);
        }
        for (Eigen::Index i = 0; i < n; ++i) r[i] = double(residual(std::size_t(i)));
        fit_.chi_squared = r.dot(factor.solve(r));
        return true;
    }

    void judge() {
        Wide squares = 0.0L, chi = 0.0L;
        Values<double> q{};
        for (std::size_t j = 0; j < fit_.polynomials.count; ++j) q[j] = double(q_[j]);
        const double width = fit_.polynomials.half_width;
        for (std::size_t i = 0; i < n_; ++i) {
            const Wide r = residual(i);
            fit_.residuals.push_back(double(r));
            squares += r * r;
            if (setup_.from_residuals || setup_.has_covariance()) continue;
            const Point& p = setup_.points[i];
            const auto foot = foot_of<double>(fit_.polynomials, q, fit_.polynomials.t_of(p.x), p.y,
                                              p.u_y * p.u_y, p.u_x * p.u_x / (width * width));
            chi += Wide(foot.residual) * foot.residual * foot.weight;
        }
        fit_.sum_of_squares = double(squares);
        if (!setup_.has_covariance()) fit_.chi_squared = double(chi);
        const double nu = setup_.degrees_of_freedom();
        if (nu > 0.0) fit_.standard_deviation = std::sqrt(double(squares / nu));
        fit_.u_of_q = fit_.standard_deviation / std::sqrt(double(n_));
        Wide explained = 0.0L;
        for (std::size_t j = setup_.through_origin ? 0 : 1; j < fit_.polynomials.count; ++j)
            explained += q_[j] * q_[j] * Wide(n_);
        fit_.sum_of_squares_regression = double(explained);
        for (std::size_t j = 0; j < fit_.polynomials.count; ++j) fit_.q.push_back(double(q_[j]));
    }

    void make_gain() {
        if (setup_.from_residuals || setup_.has_u_x() || setup_.has_covariance()) return;
        fit_.gain.resize(Eigen::Index(fit_.polynomials.count), Eigen::Index(n_));
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t j = 0; j < fit_.polynomials.count; ++j)
                fit_.gain(Eigen::Index(j), Eigen::Index(i)) = double(phi_[i][j] * weights_[i] / Wide(n_));
    }

    /// The polynomials in powers of (x - x_0)/half_width, by their recurrence.
    std::vector<Values<Wide>> in_powers() const {
        const Polynomials& p = fit_.polynomials;
        const Wide shift = (Wide(setup_.origin) - p.centre) / p.half_width;
        Values<Wide> none;
        none.fill(0.0L);
        std::vector<Values<Wide>> rows{none};
        rows[0][setup_.first_power()] = p.first;
        for (std::size_t k = 0; k + 1 < p.count; ++k) {
            Values<Wide> next = none;
            for (std::size_t m = 0; m <= setup_.degree; ++m) {
                next[m] = shift * rows[k][m] + (m > 0 ? rows[k][m - 1] : 0.0L);
                for (std::size_t j = 0; j <= k; ++j) next[m] -= Wide(p.recurrence[k][j]) * rows[j][m];
                next[m] *= p.factor[k];
            }
            rows.push_back(next);
        }
        return rows;
    }

    void make_powers() {
        const auto rows = in_powers();
        const std::size_t count = fit_.polynomials.count;
        fit_.powers.resize(Eigen::Index(count), Eigen::Index(count));
        for (std::size_t c = 0; c < count; ++c) {
            const std::size_t power = c + setup_.first_power();
            const Wide scale = std::pow(Wide(fit_.polynomials.half_width), -Wide(power));
            Wide sum = 0.0L;
            for (std::size_t j = 0; j < count; ++j) {
                fit_.powers(Eigen::Index(c), Eigen::Index(j)) = double(rows[j][power] * scale);
                sum += rows[j][power] * q_[j];
            }
            fit_.coefficients.push_back(double(sum * scale));
        }
    }

    void make_predictions() {
        const std::size_t count = fit_.polynomials.count;
        fit_.at_predictions.resize(Eigen::Index(setup_.predictions.size()), Eigen::Index(count));
        for (std::size_t i = 0; i < setup_.predictions.size(); ++i) {
            const Values<Wide> phi = phi_at(setup_.predictions[i].x);
            for (std::size_t j = 0; j < count; ++j)
                fit_.at_predictions(Eigen::Index(i), Eigen::Index(j)) = double(phi[j]);
            fit_.predicted.push_back(double(sum_of(q_, phi, count)));
        }
    }

    const CurveSetup& setup_;
    std::size_t n_;
    std::vector<double> weights_;
    std::vector<Values<Wide>> phi_;
    Values<Wide> q_;
    Fit fit_;
};

}  // namespace

std::optional<Fit> fit_of(const CurveSetup& setup) {
    return Fitter(setup).run();
}

}  // namespace covaria::curve
