#include "core/evidence/seen.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>

#include "core/adjustment/adjustment.h"
#include "core/math/special_quantiles.h"

namespace covaria::evidence {

namespace {

using adjustment::Adjustment;
using adjustment::SparseRows;

constexpr double least_seen = 1e-4;    ///< redundancy of a figure that has an estimate at all
constexpr double least_apart = 1e-6;   ///< eigenvalue of N, of unit diagonal, along which nothing is told
constexpr double least_square = 1e-8;  ///< a component that is smaller is held there, and is zero
constexpr double at_rest = 1e-10;      ///< relative change of a component
constexpr int most_rounds = 400;
constexpr int undamped_rounds = 40;  ///< components that go to and fro come to rest in half steps
constexpr std::size_t none = RedundantReadings::no_figure;

/// Sums over M = Q⁻¹R with the components as they are now, by figures.
struct Sums {
    Eigen::MatrixXd squares;     ///< tr(M Q_k M Q_l)
    Eigen::VectorXd redundancy;  ///< tr(M Q_k)
    Eigen::VectorXd residuals;   ///< vᵀ Q⁻¹ Q_k Q⁻¹ v
};

/// The readings with the variance of each figure times a factor.
class Weighing {
public:
    virtual ~Weighing() = default;
    virtual std::optional<Sums> sums(const Eigen::VectorXd& square) const = 0;
    /// Root mean square of the u of the measurands.
    virtual std::optional<double> mean_u(const Eigen::VectorXd& square) const = 0;
    virtual double sum_of_squares() const = 0;
    virtual int degrees_of_freedom() const = 0;
};

/// Weighing of readings with one figure each: in readings of standard uncertainty one, M is the residual
/// projector P = I - H, and a figure's part of it is some of its rows.
class WeighingApart : public Weighing {
public:
    explicit WeighingApart(const RedundantReadings& readings)
        : readings_(readings), stated_(readings.design, readings.whitening, readings.datum) {}

    std::optional<Sums> sums(const Eigen::VectorXd& square) const override {
        const SparseRows W = whitening(square);
        const Adjustment adjusted(readings_.design, W, readings_.datum);
        if (!adjusted.is_solved()) return std::nullopt;
        const SparseRows& A = adjusted.whitened();
        const Eigen::VectorXd before = W * readings_.residuals;
        const Eigen::VectorXd v = before - A * adjusted.step(A.transpose() * before);
        const Eigen::Index n = square.size();
        Sums sums{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
        for (Eigen::Index i = 0; i < v.size(); ++i) {
            const std::size_t of = figure_of(i);
            if (of == none) continue;
            const auto k = static_cast<Eigen::Index>(of);
            Eigen::VectorXd row = -(A * adjusted.step(Eigen::VectorXd(A.row(i).transpose())));
            row[i] += 1.0;
            sums.redundancy[k] += row[i];
            sums.residuals[k] += v[i] * v[i];
            for (Eigen::Index j = 0; j < row.size(); ++j)
                if (const std::size_t to = figure_of(j); to != none)
                    sums.squares(k, static_cast<Eigen::Index>(to)) += row[j] * row[j];
        }
        return sums;
    }

    std::optional<double> mean_u(const Eigen::VectorXd& square) const override {
        const Adjustment adjusted(readings_.design, whitening(square), readings_.datum);
        if (!adjusted.is_solved()) return std::nullopt;
        double sum = 0.0;
        for (const std::size_t i : readings_.measurands) sum += adjusted.cofactor(i, i);
        return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, readings_.measurands.size())));
    }

    double sum_of_squares() const override {
        return (readings_.whitening * readings_.residuals).squaredNorm();
    }
    int degrees_of_freedom() const override { return stated_.is_solved() ? stated_.degrees_of_freedom() : 0; }

private:
    std::size_t figure_of(Eigen::Index reading) const {
        return readings_.figure_of[static_cast<std::size_t>(reading)];
    }
    SparseRows whitening(const Eigen::VectorXd& square) const {
        Eigen::VectorXd by = Eigen::VectorXd::Ones(readings_.residuals.size());
        for (Eigen::Index i = 0; i < by.size(); ++i)
            if (const std::size_t k = figure_of(i); k != none)
                by[i] = 1.0 / std::sqrt(square[static_cast<Eigen::Index>(k)]);
        return by.asDiagonal() * readings_.whitening;
    }

    const RedundantReadings& readings_;
    const Adjustment stated_;
};

/// Readings share components of uncertainty: the matrices are what they are. All unknowns are determined.
class WeighingTogether : public Weighing {
public:
    explicit WeighingTogether(const RedundantReadings& readings)
        : readings_(readings), design_(readings.design) {}

    std::optional<Sums> sums(const Eigen::VectorXd& square) const override {
        const auto weights = weights_of(square);
        if (!weights) return std::nullopt;
        const Eigen::MatrixXd& M = weights->residual;
        const Eigen::VectorXd Mv = M * readings_.residuals;
        const Eigen::Index n = square.size();
        Sums sums{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
        for (Eigen::Index k = 0; k < n; ++k) {
            const Eigen::MatrixXd& B = readings_.shares[static_cast<std::size_t>(k)];
            const Eigen::MatrixXd BtM = B.transpose() * M;
            sums.redundancy[k] = square[k] * BtM.cwiseProduct(B.transpose()).sum();
            sums.residuals[k] = square[k] * (B.transpose() * Mv).squaredNorm();
            for (Eigen::Index l = 0; l < n; ++l)
                sums.squares(k, l) = square[k] * square[l] *
                                     (BtM * readings_.shares[static_cast<std::size_t>(l)]).squaredNorm();
        }
        return sums;
    }

    std::optional<double> mean_u(const Eigen::VectorXd& square) const override {
        const auto weights = weights_of(square);
        if (!weights) return std::nullopt;
        double sum = 0.0;
        for (const std::size_t i : readings_.measurands)
            sum += weights->cofactors(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
        return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, readings_.measurands.size())));
    }

    double sum_of_squares() const override {
        const auto weights =
            weights_of(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(readings_.shares.size())));
        return weights ? readings_.residuals.dot(weights->residual * readings_.residuals) : 0.0;
    }
    int degrees_of_freedom() const override { return static_cast<int>(design_.rows() - design_.cols()); }

private:
    struct Weights {
        Eigen::MatrixXd residual;   ///< M
        Eigen::MatrixXd cofactors;  ///< cofactors of the unknowns
    };

    std::optional<Weights> weights_of(const Eigen::VectorXd& square) const {
        Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(design_.rows(), design_.rows());
        if (readings_.others.size() > 0) Q = readings_.others * readings_.others.transpose();
        for (std::size_t k = 0; k < readings_.shares.size(); ++k)
            Q += square[static_cast<Eigen::Index>(k)] * readings_.shares[k] * readings_.shares[k].transpose();
        // Lengths and angles stand in one matrix: in units of their own standard uncertainties.
        const Eigen::VectorXd by = Q.diagonal().cwiseSqrt().cwiseInverse();
        if (!by.allFinite()) return std::nullopt;
        const Eigen::LLT<Eigen::MatrixXd> factors(by.asDiagonal() * Q * by.asDiagonal());
        if (factors.info() != Eigen::Success) return std::nullopt;
        const Eigen::MatrixXd L_A = factors.matrixL().solve(by.asDiagonal() * design_);
        const Eigen::VectorXd scale = L_A.colwise().norm().cwiseInverse();
        if (!scale.allFinite()) return std::nullopt;
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(L_A * scale.asDiagonal());
        const Eigen::Index n = design_.cols();
        const Eigen::MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
        const Eigen::MatrixXd thin = qr.householderQ() * Eigen::MatrixXd::Identity(design_.rows(), n);
        const Eigen::MatrixXd projector =
            Eigen::MatrixXd::Identity(design_.rows(), design_.rows()) - thin * thin.transpose();
        const Eigen::MatrixXd inverse = factors.matrixL().solve(Eigen::MatrixXd(by.asDiagonal()));
        const Eigen::MatrixXd by_R = R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(n, n));
        const Eigen::MatrixXd root = scale.asDiagonal() * by_R;
        return Weights{inverse.transpose() * projector * inverse, root * root.transpose()};
    }

    const RedundantReadings& readings_;
    const Eigen::MatrixXd design_;
};

std::unique_ptr<Weighing> weighing_of(const RedundantReadings& readings) {
    if (readings.shares.empty()) return std::make_unique<WeighingApart>(readings);
    return std::make_unique<WeighingTogether>(readings);
}

/// The variance components as they come to rest; figures that cannot be told apart are one class.
class Components {
public:
    Components(const Weighing& weighing, std::size_t figures) : weighing_(weighing), of_figure_(figures) {
        std::iota(of_figure_.begin(), of_figure_.end(), std::size_t{0});
        count_ = figures;
    }

    bool find() {
        while (true) {
            start();
            bool joined = false;
            for (int round = 0; round < most_rounds && !joined; ++round) {
                if (!sum() || !solve(round < undamped_rounds ? 1.0 : 0.5, joined)) return false;
                if (!joined && change_ < at_rest) return true;
            }
            if (!joined) return false;
        }
    }

    Eigen::VectorXd square_of_figures() const {
        Eigen::VectorXd square(static_cast<Eigen::Index>(of_figure_.size()));
        for (std::size_t k = 0; k < of_figure_.size(); ++k)
            square[static_cast<Eigen::Index>(k)] = square_[static_cast<Eigen::Index>(of_figure_[k])];
        return square;
    }

    SeenFigure figure(std::size_t number) const {
        SeenFigure figure;
        const std::size_t of = of_figure_[number];
        const auto k = static_cast<Eigen::Index>(of);
        for (std::size_t other = 0; other < of_figure_.size(); ++other)
            if (other != number && of_figure_[other] == of) figure.not_apart.push_back(other);
        figure.redundancy = sums_.redundancy[k];
        if (state_[of] == State::unseen) return figure;
        figure.clamped = state_[of] == State::clamped;
        figure.square = figure.clamped ? 0.0 : square_[k];
        figure.factor = std::sqrt(figure.square);
        figure.u_square = u_square_[k];
        if (figure.square > 0.0 && figure.u_square > 0.0)
            figure.degrees_of_freedom = 2.0 * std::pow(figure.square / figure.u_square, 2);
        return figure;
    }

private:
    enum class State { estimated, clamped, unseen };

    void start() {
        const auto n = static_cast<Eigen::Index>(count_);
        square_ = Eigen::VectorXd::Ones(n);
        u_square_ = Eigen::VectorXd::Zero(n);
        state_.assign(count_, State::estimated);
    }

    /// Sums of the figures of each class.
    bool sum() {
        const auto by_figure = weighing_.sums(square_of_figures());
        if (!by_figure) return false;
        const auto n = static_cast<Eigen::Index>(count_);
        sums_ = {Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
        for (std::size_t a = 0; a < of_figure_.size(); ++a) {
            const auto i = static_cast<Eigen::Index>(a), k = static_cast<Eigen::Index>(of_figure_[a]);
            sums_.redundancy[k] += by_figure->redundancy[i];
            sums_.residuals[k] += by_figure->residuals[i];
            for (std::size_t b = 0; b < of_figure_.size(); ++b)
                sums_.squares(k, static_cast<Eigen::Index>(of_figure_[b])) +=
                    by_figure->squares(i, static_cast<Eigen::Index>(b));
        }
        return true;
    }

    /// Factors of the components by one solution of N s = l; false: nothing has redundancy. `joined`: classes
    /// that N cannot tell apart have become one. `step`: the part of the way that is gone.
    bool solve(double step, bool& joined) {
        std::vector<Eigen::Index> asked;
        for (std::size_t k = 0; k < count_; ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            if (state_[k] == State::estimated && sums_.redundancy[at] < least_seen) state_[k] = State::unseen;
            if (state_[k] == State::estimated) asked.push_back(at);
        }
        change_ = 0.0;
        if (asked.empty()) return std::ranges::count(state_, State::clamped) > 0;
        const Eigen::MatrixXd N = 0.5 * sums_.squares(asked, asked);
        joined = join(N, asked);
        if (joined) return true;
        // Components that are held count with the variance that they have.
        Eigen::VectorXd l = 0.5 * sums_.residuals(asked);
        for (std::size_t a = 0; a < asked.size(); ++a)
            l[static_cast<Eigen::Index>(a)] -= 0.5 * held_share(asked[a]);
        const Eigen::LDLT<Eigen::MatrixXd> factors(N);
        const Eigen::VectorXd s = factors.solve(l);
        const Eigen::MatrixXd covariance = factors.solve(Eigen::MatrixXd::Identity(N.rows(), N.cols()));
        if (!s.allFinite()) return false;
        for (std::size_t a = 0; a < asked.size(); ++a) {
            const auto at = static_cast<Eigen::Index>(a);
            const Eigen::Index k = asked[a];
            change_ = std::max(change_, std::abs(s[at] - 1.0));
            u_square_[k] = square_[k] * std::sqrt(std::max(0.0, covariance(at, at)));
            square_[k] *= std::max(1.0 + step * (s[at] - 1.0), 0.05);
            if (square_[k] > least_square) continue;
            square_[k] = least_square;
            state_[static_cast<std::size_t>(k)] = State::clamped;
        }
        return true;
    }

    /// tr(M Q_k M Q_held) of all that is not estimated: tr(M Q_k) is that of the whole, as M Q M = M.
    double held_share(Eigen::Index k) const {
        double share = sums_.redundancy[k];
        for (std::size_t other = 0; other < count_; ++other)
            if (state_[other] == State::estimated)
                share -= sums_.squares(k, static_cast<Eigen::Index>(other));
        return std::max(0.0, share);
    }

    bool join(const Eigen::MatrixXd& N, const std::vector<Eigen::Index>& asked) {
        if (asked.size() < 2) return false;
        const Eigen::VectorXd by = N.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(by.asDiagonal() * N * by.asDiagonal());
        if (eigen.eigenvalues()[0] > least_apart) return false;
        const Eigen::VectorXd along = eigen.eigenvectors().col(0);
        std::vector<std::size_t> same;
        for (std::size_t a = 0; a < asked.size(); ++a)
            if (std::abs(along[static_cast<Eigen::Index>(a)]) > 0.1)
                same.push_back(static_cast<std::size_t>(asked[a]));
        if (same.size() < 2) return false;
        const auto joins = [&](std::size_t one) { return std::ranges::find(same, one) != same.end(); };
        for (std::size_t& of : of_figure_) {
            if (joins(of)) of = same.front();
            of -= static_cast<std::size_t>(
                std::count_if(same.begin() + 1, same.end(), [&](std::size_t one) { return one < of; }));
        }
        count_ -= same.size() - 1;
        return true;
    }

    const Weighing& weighing_;
    std::vector<std::size_t> of_figure_;  ///< class of each figure
    std::size_t count_ = 0;               ///< number of classes
    std::vector<State> state_;
    Eigen::VectorXd square_, u_square_;
    Sums sums_;
    double change_ = 0.0;
};

Verdict verdict_of(const SeenFigure& figure) {
    if (figure.redundancy < least_redundancy) return Verdict::too_little;
    if (figure.clamped) return Verdict::smaller;
    if (figure.low > 1.0) return Verdict::larger;
    return figure.high < 1.0 ? Verdict::smaller : Verdict::agrees;
}

void add_interval(SeenFigure& figure, double level) {
    const double nu = figure.degrees_of_freedom;
    if (!(nu > 0.0)) {
        figure.high = std::numeric_limits<double>::infinity();
        return;
    }
    figure.low = figure.factor * std::sqrt(nu / chi_squared_quantile(1.0 - level / 2, nu));
    figure.high = figure.factor * std::sqrt(nu / chi_squared_quantile(level / 2, nu));
}

void describe(const Components& components, const Weighing& weighing, double level, Seen& seen) {
    const Eigen::VectorXd square = components.square_of_figures();
    const auto mean_u = weighing.mean_u(square);
    if (!mean_u) return;
    seen.found = true;
    seen.mean_u_seen = *mean_u;
    for (std::size_t k = 0; k < static_cast<std::size_t>(square.size()); ++k) {
        SeenFigure figure = components.figure(k);
        add_interval(figure, level);
        figure.verdict = verdict_of(figure);
        seen.figures.push_back(std::move(figure));
    }
}

/// The global test of the residuals, without a look at figures.
Seen test_of(const Weighing& stated, double level) {
    Seen seen;
    seen.degrees_of_freedom = stated.degrees_of_freedom();
    if (seen.degrees_of_freedom <= 0) return seen;
    seen.sum_of_squares = stated.sum_of_squares();
    const double f = seen.degrees_of_freedom;
    seen.s0 = std::sqrt(seen.sum_of_squares / f);
    seen.s0_low = std::sqrt(chi_squared_quantile(level / 2, f) / f);
    seen.s0_high = std::sqrt(chi_squared_quantile(1.0 - level / 2, f) / f);
    return seen;
}

}  // namespace

struct ComputedOnce::Place {
    std::once_flag asked;
    Seen seen;
};

ComputedOnce::ComputedOnce() : place_(std::make_shared<Place>()) {}

ComputedOnce& ComputedOnce::operator=(const ComputedOnce& other) {
    if (this != &other) place_ = std::make_shared<Place>();
    return *this;
}

const Seen& seen_of(const RedundantReadings& readings) {
    ComputedOnce::Place& place = readings.computed.place();
    std::call_once(place.asked, [&] { place.seen = see(readings); });
    return place.seen;
}

std::size_t most_readings_of(const RedundantReadings& readings) {
    return readings.shares.empty() ? most_readings : most_sharing_readings;
}

Seen global_test(const RedundantReadings& readings, double level) {
    return test_of(*weighing_of(readings), level);
}

Seen see(const RedundantReadings& readings, double level) {
    const std::unique_ptr<Weighing> weighing = weighing_of(readings);
    Seen seen = test_of(*weighing, level);
    if (seen.degrees_of_freedom <= 0) return seen;
    const auto figures = static_cast<Eigen::Index>(readings.figures.size());
    const auto mean_u = weighing->mean_u(Eigen::VectorXd::Ones(figures));
    if (!mean_u) return seen;
    seen.mean_u_stated = seen.mean_u_seen = *mean_u;
    if (static_cast<std::size_t>(readings.residuals.size()) > most_readings_of(readings)) return seen;
    Components components(*weighing, readings.figures.size());
    if (components.find()) describe(components, *weighing, level, seen);
    return seen;
}

}  // namespace covaria::evidence
