#include "core/design/cheapest_reductions.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace covaria::detail {

namespace {

constexpr int most_steps = 200;
constexpr double gap = 1e-13;  ///< relative to the sum of the prices
constexpr double log2e = 1.4426950408889634;

/// Cost as a function of v = f², for a price of one, with its derivatives.
struct Cost {
    double value, slope, curvature;
};
Cost cost_at(PriceLaw law, double v) {
    switch (law) {
        case PriceLaw::repeats:
            return {(1.0 / v - 1.0) / 3.0, -1.0 / (3.0 * v * v), 2.0 / (3.0 * v * v * v)};
        case PriceLaw::logarithmic:
            return {-0.5 * log2e * std::log(v), -0.5 * log2e / v, 0.5 * log2e / (v * v)};
        case PriceLaw::inverse:
            break;
    }
    const double root = std::sqrt(v);
    return {1.0 / root - 1.0, -0.5 / (v * root), 0.75 / (v * v * root)};
}

/// Interior-point method. All conditions are G v <= h: the limits, then v >= least, then v <= 1.
class InteriorPoint {
public:
    explicit InteriorPoint(const ReductionTask& task)
        : task_(task),
          n_(static_cast<Eigen::Index>(task.reductions.size())),
          k_(task.part.rows()),
          least_(n_),
          G_(Eigen::MatrixXd::Zero(k_ + 2 * n_, n_)),
          h_(k_ + 2 * n_) {
        for (Eigen::Index j = 0; j < n_; ++j) {
            const DesignReduction& reduction = task.reductions[static_cast<std::size_t>(j)];
            least_(j) = reduction.number.from * reduction.number.from;
            unit_ += reduction.price;
        }
        if (!(unit_ > 0.0)) unit_ = 1.0;
        G_.topRows(k_) = task.part;
        G_.middleRows(k_, n_).diagonal().setConstant(-1.0);
        G_.bottomRows(n_).diagonal().setConstant(1.0);
        h_ << Eigen::VectorXd::Ones(k_) - task.rest, -least_, Eigen::VectorXd::Ones(n_);
    }

    /// Strictly within all conditions, or false.
    bool begin() {
        const Eigen::VectorXd room = h_.head(k_) - task_.part * least_;
        if (k_ > 0 && !(room.minCoeff() > 0.0)) return false;
        const Eigen::VectorXd rise = task_.part * (Eigen::VectorXd::Ones(n_) - least_);
        double part = 0.5;
        for (Eigen::Index k = 0; k < k_; ++k)
            if (rise(k) > 0.0) part = std::min(part, 0.5 * room(k) / rise(k));
        v_ = least_ + part * (Eigen::VectorXd::Ones(n_) - least_);
        lambda_ = slack(v_).cwiseInverse() / static_cast<double>(h_.size());
        return true;
    }

    void solve() {
        for (int i = 0; i < most_steps; ++i) {
            const double mu = slack(v_).dot(lambda_);
            if (mu < gap && dual_residual(v_, lambda_).norm() < gap) return;
            if (!step(0.1 * mu / static_cast<double>(h_.size()))) return;
        }
    }

    const Eigen::VectorXd& v() const { return v_; }
    /// A limit binds where there is less room than price.
    Eigen::VectorXd multipliers() const {
        const Eigen::VectorXd room = slack(v_).head(k_), price = lambda_.head(k_);
        return unit_ * (price.array() > room.array()).select(price, 0.0);
    }

private:
    Eigen::VectorXd slack(const Eigen::VectorXd& v) const { return h_ - G_ * v; }

    double price(Eigen::Index j) const { return task_.reductions[static_cast<std::size_t>(j)].price / unit_; }
    Cost cost(Eigen::Index j, double v) const {
        return cost_at(task_.reductions[static_cast<std::size_t>(j)].law, v);
    }

    Eigen::VectorXd dual_residual(const Eigen::VectorXd& v, const Eigen::VectorXd& lambda) const {
        Eigen::VectorXd residual = G_.transpose() * lambda;
        for (Eigen::Index j = 0; j < n_; ++j) residual(j) += price(j) * cost(j, v(j)).slope;
        return residual;
    }

    double norm(const Eigen::VectorXd& v, const Eigen::VectorXd& lambda, double centre) const {
        return std::hypot(dual_residual(v, lambda).norm(),
                          (lambda.cwiseProduct(slack(v)).array() - centre).matrix().norm());
    }

    /// Newton's method on the conditions of optimality with lambda_i slack_i = centre. False: rounding is in
    /// the way.
    bool step(double centre) {
        const Eigen::VectorXd s = slack(v_);
        Eigen::MatrixXd H = G_.transpose() * lambda_.cwiseQuotient(s).asDiagonal() * G_;
        for (Eigen::Index j = 0; j < n_; ++j) H(j, j) += price(j) * cost(j, v_(j)).curvature;
        const Eigen::VectorXd target = centre * s.cwiseInverse();
        const Eigen::VectorXd dv = H.ldlt().solve(-dual_residual(v_, target));
        const Eigen::VectorXd dlambda = target - lambda_ + lambda_.cwiseQuotient(s).cwiseProduct(G_ * dv);
        if (!dv.allFinite() || !dlambda.allFinite()) return false;
        double length = 1.0;
        for (Eigen::Index i = 0; i < h_.size(); ++i)
            if (dlambda(i) < 0.0) length = std::min(length, -0.99 * lambda_(i) / dlambda(i));
        const double before = norm(v_, lambda_, centre);
        for (int halving = 0; halving < 60; ++halving, length *= 0.5) {
            const Eigen::VectorXd v = v_ + length * dv, lambda = lambda_ + length * dlambda;
            if (!(slack(v).minCoeff() > 0.0)) continue;
            if (norm(v, lambda, centre) > (1.0 - 0.01 * length) * before) continue;
            v_ = v;
            lambda_ = lambda;
            return true;
        }
        return false;
    }

    const ReductionTask& task_;
    Eigen::Index n_, k_;
    double unit_ = 0.0;  ///< unit of cost
    Eigen::VectorXd least_;
    Eigen::MatrixXd G_;
    Eigen::VectorXd h_, v_, lambda_;
};

}  // namespace

double cost_of(const DesignReduction& reduction, double factor) {
    return reduction.price * cost_at(reduction.law, factor * factor).value;
}

CheapestReductions cheapest_reductions(const ReductionTask& task) {
    CheapestReductions found;
    const std::size_t n = task.reductions.size();
    found.multipliers = Eigen::VectorXd::Zero(task.part.rows());
    const Eigen::VectorXd unchanged = task.rest + task.part.rowwise().sum();
    if (task.part.rows() == 0 || unchanged.maxCoeff() <= 1.0) {
        found.possible = true;
        found.factors.assign(n, 1.0);
        return found;
    }
    InteriorPoint search(task);
    found.possible = search.begin();
    if (found.possible) {
        search.solve();
        found.multipliers = search.multipliers();
    }
    for (std::size_t j = 0; j < n; ++j) {
        const DesignReduction& reduction = task.reductions[j];
        found.factors.push_back(found.possible ? std::sqrt(search.v()(static_cast<Eigen::Index>(j)))
                                               : reduction.number.from);
        found.cost += cost_of(reduction, found.factors.back());
    }
    return found;
}

}  // namespace covaria::detail
