// Targets estimated together at some places: residuals, derivatives, weights; and the least squares of one
// trial where the quick iteration does not settle.
#pragma once

#include <cmath>
#include <type_traits>

#include "core/kinds/network/readings.h"
#include "core/model/equation_model.h"

namespace covaria::network {

inline constexpr double last_step = 1e-11;  // m; what is left then is below 1e-6 of any u that is stated

/// Targets estimated together: those of a set-up, or one by itself.
struct Part {
    const NetworkSetup* setup = nullptr;
    const Target* targets = nullptr;
    std::size_t count = 1;
    std::span<const std::size_t> bars = {};
    const double* inverse_normal = nullptr;  ///< (J₀ᵀWJ₀)⁻¹ at the estimates, by rows
    const JointSetUp* joint = nullptr;       ///< holds its weights; null: those of the readings alone
    std::size_t first = 0;                   ///< number of the first target, where there are bars

    std::size_t unknowns() const { return 3 * count; }
};

/// Readings and calibrated lengths at places X of the targets. No allocation: kept on the stack.
template <class Real>
struct Linearised {
    std::array<Vector3<Real>, most_joint_rows> gradients;  ///< by its target; of a bar by its end `to`
    std::array<Real, most_joint_rows> residuals, weighted;
    std::array<ReadAngles<Real>, most_joint_rows> angles;  ///< one for each sight
    std::size_t rows = 0;

    /// Reads what `take` needs of the readings, which is the same at all places.
    template <class In>
    void read(const Part& part, const In& x) {
        std::size_t number = 0;
        for (std::size_t t = 0; t < part.count; ++t)
            for (const Sight& sight : part.targets[t].sights) angles[number++] = ReadAngles<Real>(sight, x);
    }

    /// `raised`: of every reading what its residual is raised by, in place of what its sight says.
    template <class In>
    void take(const Part& part, const Place<Real>* places, const In& x, const Vector3<Real>* X,
              const Real* raised = nullptr) {
        using namespace real_functions;
        rows = 0;
        const ReadAngles<Real>* read = angles.data();
        for (std::size_t t = 0; t < part.count; ++t)
            for (const Sight& sight : part.targets[t].sights) {
                const Place<Real>& place = places[sight.sensor];
                const View<Real> view(place, X[t]);
                for (std::size_t i = 0; i < 3; ++i) {
                    if (!sight.has[i]) continue;
                    gradients[rows] = gradient<Real>(sight, i, place, view, *read);
                    residuals[rows] =
                        raised ? Real(plain_residual<Real>(sight, i, view, x, *read) + raised[rows])
                               : residual<Real>(sight, i, view, x, *read);
                    ++rows;
                }
                ++read;
            }
        for (const std::size_t b : part.bars) {
            const ScaleBar& bar = part.setup->bars[b];
            const Vector3<Real> d = X[bar.to - part.first] - X[bar.from - part.first];
            const Real length = sqrt(Real(d.dot(d)));
            gradients[rows] = d * Real(Real(1.0) / length);
            residuals[rows++] = Real(x[bar.input]) - length;
        }
    }

    /// weighted = W residuals.
    void weigh(const Part& part) { weigh(part, residuals.data(), weighted.data()); }
    void weigh(const Part& part, const Real* from, Real* to) const {
        if (!part.joint) return weigh_alone(part, from, to);
        if (part.joint->by_itself()) return weigh_blocks(part.joint->blocks, from, to);
        std::array<Real, most_shared> shared;
        weigh_together(part, from, to, shared.data());
    }
    /// Weighs targets that have weights of their own; sets the estimates of the deviations that they share.
    void weigh_together(const Part& part, const Real* from, Real* to, Real* shared) const {
        const std::vector<double>& by_u = part.joint->by_u;
        for (std::size_t i = 0; i < rows; ++i) to[i] = Real(by_u[i]) * from[i];
        const SharedWeight* weight = part.joint->shared.data();
        const std::size_t count = part.joint->ends_of_shared.size();
        for (std::size_t k = 0; k < count; ++k) {
            Real sum(0.0);
            for (const SharedWeight* end = part.joint->end_of_shared(k); weight != end; ++weight)
                sum += Real(weight->estimate) * to[weight->row];
            shared[k] = sum;
        }
        weight = part.joint->shared.data();
        for (std::size_t k = 0; k < count; ++k)
            for (const SharedWeight* end = part.joint->end_of_shared(k); weight != end; ++weight)
                to[weight->row] -= Real(weight->effect) * shared[k];
        for (std::size_t i = 0; i < rows; ++i) to[i] *= Real(by_u[i]);
    }

    /// g = Jᵀ w.
    void transpose(const Part& part, const Real* w, Real* g) const {
        for (std::size_t i = 0; i < part.unknowns(); ++i) g[i] = Real(0.0);
        visit(part, [&](std::size_t row, std::size_t at, double sign) {
            for (int c = 0; c < 3; ++c)
                g[at + static_cast<std::size_t>(c)] += Real(sign) * gradients[row][c] * w[row];
        });
    }

    /// J d.
    void multiply(const Part& part, const Real* d, Real* Jd) const {
        for (std::size_t i = 0; i < rows; ++i) Jd[i] = Real(0.0);
        visit(part, [&](std::size_t row, std::size_t at, double sign) {
            for (int c = 0; c < 3; ++c)
                Jd[row] += Real(sign) * gradients[row][c] * d[at + static_cast<std::size_t>(c)];
        });
    }

private:
    static void weigh_blocks(const std::vector<WeightBlock>& blocks, const Real* from, Real* to) {
        for (const WeightBlock& block : blocks) {
            const double* w = block.weights.data();
            for (const std::size_t i : block.rows) {
                Real sum(0.0);
                for (const std::size_t k : block.rows) sum += Real(*w++) * from[k];
                to[i] = sum;
            }
        }
    }

    void weigh_alone(const Part& part, const Real* from, Real* to) const {
        std::size_t row = 0;
        for (std::size_t t = 0; t < part.count; ++t)
            for (const Sight& sight : part.targets[t].sights)
                for (std::size_t i = 0; i < 3; ++i)
                    if (sight.has[i]) {
                        to[row] = from[row] * Real(1.0 / (sight.u[i] * sight.u[i]));
                        ++row;
                    }
    }

    /// f(row, first unknown, sign) for every target that a row depends on.
    template <class F>
    void visit(const Part& part, const F& f) const {
        std::size_t row = 0;
        for (std::size_t t = 0; t < part.count; ++t)
            for (const Sight& sight : part.targets[t].sights)
                for (std::size_t i = 0; i < 3; ++i)
                    if (sight.has[i]) f(row++, 3 * t, 1.0);
        for (const std::size_t b : part.bars) {
            const ScaleBar& bar = part.setup->bars[b];
            f(row, 3 * (bar.to - part.first), 1.0);
            f(row++, 3 * (bar.from - part.first), -1.0);
        }
    }
};

/// min rᵀ W r of one trial by Gauss-Newton steps, each found by conjugate gradients and halved until the sum
/// falls. Any of their iterates descends, so that the sum falls until it is least: no trial is lost, unless
/// it has no least sum (rays that run apart).
template <class In>
class Descent {
public:
    Descent(const Part& part, const Place<double>* places, const In& x)
        : part_(part), places_(places), x_(x), n_(part.unknowns()) {
        at_.read(part, x);
    }

    /// Searches from X on; false: no end was found.
    bool run(Vector3<double>* X) {
        constexpr int most_descents = 200;
        double sum = sum_at(X);
        for (int k = 0; k < most_descents && std::isfinite(sum); ++k) {
            at_.transpose(part_, at_.weighted.data(), gradient_.data());
            find_step();
            if (dot(step_, step_) < last_step * last_step) return true;
            if (!shorten(X, sum)) return true;  // the sum cannot fall any more: rounding
        }
        return false;
    }

private:
    using Vector = std::array<double, 3 * most_joint_targets>;

    double dot(const Vector& a, const Vector& b) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < n_; ++i) sum += a[i] * b[i];
        return sum;
    }

    double sum_at(const Vector3<double>* X) {
        at_.take(part_, places_, x_, X);
        at_.weigh(part_);
        double sum = 0.0;
        for (std::size_t i = 0; i < at_.rows; ++i) sum += at_.residuals[i] * at_.weighted[i];
        return sum;
    }

    void precondition(const Vector& from, Vector& to) const {
        const double* inverse = part_.inverse_normal;
        for (std::size_t i = 0; i < n_; ++i) {
            to[i] = 0.0;
            for (std::size_t k = 0; k < n_; ++k) to[i] += *inverse++ * from[k];
        }
    }

    /// JᵀWJ step = gradient, by preconditioned conjugate gradients.
    void find_step() {
        step_.fill(0.0);
        left_ = gradient_;
        precondition(left_, way_);
        double square = dot(left_, way_);
        const double enough = 1e-20 * square;
        for (std::size_t k = 0; k < 2 * n_ + 10 && square > enough; ++k) {
            at_.multiply(part_, way_.data(), forward_.data());
            at_.weigh(part_, forward_.data(), weighted_.data());
            at_.transpose(part_, weighted_.data(), product_.data());
            const double curvature = dot(way_, product_);
            if (!(curvature > 0.0)) return;
            const double along = square / curvature;
            for (std::size_t i = 0; i < n_; ++i) {
                step_[i] += along * way_[i];
                left_[i] -= along * product_[i];
            }
            precondition(left_, product_);
            const double next = dot(left_, product_);
            for (std::size_t i = 0; i < n_; ++i) way_[i] = product_[i] + next / square * way_[i];
            square = next;
        }
    }

    /// Moves X by the step, or by the half of it that lets the sum fall.
    bool shorten(Vector3<double>* X, double& sum) {
        const double slope = 2.0 * dot(gradient_, step_);
        for (double part = 1.0; part > 1e-10; part *= 0.5) {
            for (std::size_t i = 0; i < n_; ++i)
                moved_[i / 3][static_cast<int>(i % 3)] = X[i / 3][static_cast<int>(i % 3)] + part * step_[i];
            const double moved_sum = sum_at(moved_.data());
            if (!(moved_sum < sum - 1e-4 * part * slope)) continue;
            for (std::size_t t = 0; t < part_.count; ++t) X[t] = moved_[t];
            sum = moved_sum;
            return true;
        }
        return false;
    }

    const Part& part_;
    const Place<double>* places_;
    const In& x_;
    std::size_t n_;
    Linearised<double> at_;
    Vector gradient_, step_, left_, way_, product_;
    std::array<double, most_joint_rows> forward_, weighted_;
    std::array<Vector3<double>, most_joint_targets> moved_;
};

/// Descends from `start`, else from the estimates.
template <class In>
bool descend(const Part& part, const Place<double>* places, const In& x, const Vector3<double>* start,
             Vector3<double>* X) {
    Descent<In> descent(part, places, x);
    std::copy_n(start, part.count, X);
    if (descent.run(X)) return true;
    for (std::size_t t = 0; t < part.count; ++t) X[t] = part.targets[t].nominal;
    return descent.run(X);
}

/// The inputs of one trial of several that are computed at once.
struct LaneInputs {
    const Inputs<Batch>& x;
    std::size_t lane;
    double operator[](std::size_t i) const { return x[i].get(lane); }
};

inline Vector3<double> lane_of(const Vector3<Batch>& v, std::size_t lane) {
    return {v[0].get(lane), v[1].get(lane), v[2].get(lane)};
}

inline bool search_lane(const Part& part, const Place<Batch>* places, const LaneInputs& x,
                        const Vector3<Batch>* start, Vector3<Batch>* X) {
    std::array<Place<double>, most_sensors> drawn;
    for (std::size_t s = 0; s < part.setup->sensors.size(); ++s) {
        drawn[s].o = lane_of(places[s].o, x.lane);
        for (int c = 0; c < 3; ++c) drawn[s].R.col(c) = lane_of(places[s].R.col(c), x.lane);
    }
    std::array<Vector3<double>, most_joint_targets> from, found;
    for (std::size_t t = 0; t < part.count; ++t) from[t] = lane_of(start[t], x.lane);
    if (!descend(part, drawn.data(), x, from.data(), found.data())) return false;
    for (std::size_t t = 0; t < part.count; ++t)
        for (int c = 0; c < 3; ++c) {
            double values[Batch::size];
            X[t][c].store_unaligned(values);
            values[x.lane] = found[t][c];
            X[t][c] = Batch::load_unaligned(values);
        }
    return true;
}

/// X of the trials of which `done` is false, each by itself; which of all have an estimate. Not for
/// derivatives.
template <class Real, class In>
mask_of<Real> search_rest(const Part& part, const Place<Real>* places, const In& x,
                          const Vector3<Real>* start, const mask_of<Real>& done, Vector3<Real>* X) {
    if constexpr (std::is_same_v<Real, double>) {
        return done || descend(part, places, x, start, X);
    } else if constexpr (std::is_same_v<Real, Batch>) {
        if (xsimd::all(done)) return done;
        bool found[Batch::size];
        done.store_unaligned(found);
        for (std::size_t lane = 0; lane < Batch::size; ++lane)
            if (!found[lane]) found[lane] = search_lane(part, places, LaneInputs{x, lane}, start, X);
        return mask_of<Batch>::load_unaligned(found);
    } else {
        return done;
    }
}

}  // namespace covaria::network
