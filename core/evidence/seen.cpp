#include "core/evidence/seen.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>

#include "core/evidence/weighing.h"
#include "core/math/special_quantiles.h"

namespace covaria::evidence {

namespace {

/// Redundancy, as stated, of a figure that has an estimate at all. Below it factor² would be uncertain by
/// more than four times itself; it runs away, and takes from others what they are seen by.
constexpr double least_seen = 0.1;
constexpr double least_apart = 1e-6;   ///< eigenvalue of N, of unit diagonal, along which nothing is told
constexpr double least_square = 1e-8;  ///< a component that is smaller is held there, and is zero
constexpr double at_rest = 1e-10;      ///< relative change of a component
constexpr int most_rounds = 400;
constexpr int undamped_rounds = 40;   ///< components that go to and fro come to rest in shorter steps
constexpr double longest_step = 0.3;  ///< relative change that is taken by the observed curvature
constexpr double uphill = 1e-6;       ///< relative slope of the likelihood at zero that lets a component go
constexpr double released_square = 0.01;  ///< where it begins anew, each time nearer to zero
constexpr int most_releases = 2;          ///< of each component

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
                if (!sum() || !solve(round, joined)) return false;
                if (!joined && change_ < at_rest && !release()) return true;
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
        releases_.assign(count_, 0);
        last_ = Eigen::VectorXd::Zero(n);
        damping_ = 1.0;
    }

    /// Sums of the figures of each class.
    bool sum() {
        const auto by_figure = weighing_.sums(square_of_figures());
        if (!by_figure) return false;
        sums_ = Sums(static_cast<Eigen::Index>(count_));
        for (std::size_t a = 0; a < of_figure_.size(); ++a) {
            const auto i = static_cast<Eigen::Index>(a), k = static_cast<Eigen::Index>(of_figure_[a]);
            sums_.redundancy[k] += by_figure->redundancy[i];
            sums_.residuals[k] += by_figure->residuals[i];
            for (std::size_t b = 0; b < of_figure_.size(); ++b) {
                const auto j = static_cast<Eigen::Index>(b), l = static_cast<Eigen::Index>(of_figure_[b]);
                sums_.squares(k, l) += by_figure->squares(i, j);
                sums_.observed(k, l) += by_figure->observed(i, j);
            }
        }
        return true;
    }

    /// One step of the components towards the likeliest; false: nothing has redundancy. `joined`: classes
    /// that N cannot tell apart have become one.
    bool solve(int round, bool& joined) {
        std::vector<Eigen::Index> asked;
        for (std::size_t k = 0; k < count_; ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            // A component that becomes small beside others loses its redundancy, and is not unseen for that.
            if (state_[k] == State::estimated && sums_.redundancy[at] < least_seen && square_[at] >= 1.0) {
                state_[k] = State::unseen;
                square_[at] = 1.0;
            }
            if (state_[k] == State::estimated) asked.push_back(at);
        }
        change_ = 0.0;
        if (asked.empty()) return std::ranges::count(state_, State::clamped) > 0;
        const Eigen::MatrixXd N = 0.5 * sums_.squares(asked, asked);
        joined = join(N, asked);
        if (joined) return true;
        const Eigen::LDLT<Eigen::MatrixXd> factors(N);
        const Eigen::MatrixXd covariance = factors.solve(Eigen::MatrixXd::Identity(N.rows(), N.cols()));
        const Eigen::VectorXd step = step_of(asked, factors, round);
        if (!step.allFinite()) return false;
        for (std::size_t a = 0; a < asked.size(); ++a) {
            const auto at = static_cast<Eigen::Index>(a);
            const Eigen::Index k = asked[a];
            u_square_[k] = square_[k] * std::sqrt(std::max(0.0, covariance(at, at)));
            square_[k] *= std::max(1.0 + step[at], 0.05);
            if (square_[k] <= least_square) clamp(static_cast<std::size_t>(k));
        }
        return true;
    }

    void clamp(std::size_t k) {
        square_[static_cast<Eigen::Index>(k)] = least_square;
        state_[k] = State::clamped;
    }

    /// Relative changes of components. N s = l is solved by 1 + N⁻¹ g, g: slopes of the likelihood; all that
    /// is not asked counts with the variance that it has. Where the likelihood bends down and is nearly at
    /// its top, its observed curvature takes the place of N: with little redundancy the two differ, and steps
    /// by N creep, or go to and fro for ever.
    Eigen::VectorXd step_of(const std::vector<Eigen::Index>& asked, const Eigen::LDLT<Eigen::MatrixXd>& by_N,
                            int round) {
        const Eigen::VectorXd slopes = 0.5 * (sums_.residuals - sums_.redundancy)(asked);
        Eigen::VectorXd step = by_N.solve(slopes);
        const Eigen::LLT<Eigen::MatrixXd> curvature((sums_.observed - 0.5 * sums_.squares)(asked, asked));
        bool is_short = false;
        if (curvature.info() == Eigen::Success) {
            const Eigen::VectorXd by_curvature = curvature.solve(slopes);
            is_short = by_curvature.cwiseAbs().maxCoeff() < longest_step;
            if (is_short) step = by_curvature;
        }
        change_ = step.cwiseAbs().maxCoeff();
        Eigen::VectorXd now = Eigen::VectorXd::Zero(last_.size());
        now(asked) = step;
        if (round >= undamped_rounds)
            damping_ = now.dot(last_) < 0.0 ? 0.5 * damping_ : std::min(0.5, 1.1 * damping_);
        last_ = now;
        return is_short ? step : Eigen::VectorXd(damping_ * step);
    }

    /// Lets components go that were taken to zero before the others had come to rest, and that the likelihood
    /// draws up again.
    bool release() {
        bool any = false;
        for (std::size_t k = 0; k < count_; ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            if (state_[k] != State::clamped || releases_[k] == most_releases) continue;
            if (sums_.residuals[at] <= (1.0 + uphill) * sums_.redundancy[at]) continue;
            state_[k] = State::estimated;
            square_[at] = std::pow(released_square, ++releases_[k]);
            any = true;
        }
        return any;
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
    std::vector<int> releases_;  ///< how often each component was let go from zero
    Eigen::VectorXd last_;       ///< relative changes of the round before
    double damping_ = 1.0;       ///< part of the way that is gone
    Sums sums_{0};
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
    if (!readings.shares.empty()) return most_sharing_readings;
    // Fewer solutions than that, one for each unknown and figure, will do for any number of readings.
    const auto unknowns = static_cast<std::size_t>(readings.design.cols());
    return unknowns * readings.figures.size() <= most_readings ? std::numeric_limits<std::size_t>::max()
                                                               : most_readings;
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
