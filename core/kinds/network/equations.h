// The equations of "points from sensors", once for every number type (Galetto et al., Eqs 1-4).
#pragma once

#include <type_traits>

#include "core/kinds/network/search.h"
#include "core/math/frames.h"

namespace covaria::network {

/// Rows a·X = b of a least-squares problem in three unknowns, X counted from a reference point.
template <class Real>
class Rows {
public:
    void clear() { size_ = 0; }
    void add(const Vector3<Real>& a, const Real& b) {
        for (int c = 0; c < 3; ++c) values_[4 * size_ + static_cast<std::size_t>(c)] = a[c];
        values_[4 * size_ + 3] = b;
        ++size_;
    }
    std::size_t size() const { return size_; }
    void scale(std::size_t row, const Real& factor) {
        for (std::size_t c = 0; c < 4; ++c) values_[4 * row + c] *= factor;
    }
    /// Least-squares solution by the normal equations; not finite where they are singular.
    Vector3<Real> solve() const {
        Matrix3<Real> N = Matrix3<Real>::Zero();
        Vector3<Real> g = Vector3<Real>::Zero();
        for (std::size_t i = 0; i < size_; ++i) {
            const Real* v = &values_[4 * i];
            for (int r = 0; r < 3; ++r) {
                for (int c = r; c < 3; ++c) N(r, c) += v[r] * v[c];
                g[r] += v[r] * v[3];
            }
        }
        return solved(N, g);
    }

private:
    /// Cholesky decomposition of the upper triangle.
    static Vector3<Real> solved(const Matrix3<Real>& N, const Vector3<Real>& g) {
        using namespace real_functions;
        const Real l00 = sqrt(N(0, 0)), l01 = N(0, 1) / l00, l02 = N(0, 2) / l00;
        const Real l11 = sqrt(Real(N(1, 1) - l01 * l01)), l12 = (N(1, 2) - l01 * l02) / l11;
        const Real l22 = sqrt(Real(N(2, 2) - l02 * l02 - l12 * l12));
        const Real y0 = g[0] / l00, y1 = (g[1] - l01 * y0) / l11, y2 = (g[2] - l02 * y0 - l12 * y1) / l22;
        const Real z = y2 / l22, y = (y1 - l12 * z) / l11, x = (y0 - l01 * y - l02 * z) / l00;
        return {x, y, z};
    }

    std::array<Real, 4 * most_rows> values_;
    std::size_t size_ = 0;
};

/// M X = B (Eq 1) for X counted from P: an equation for every reading that has a linear one.
template <class Real, class In>
void linear_rows(const Target& target, const Place<Real>* places, const In& x, const Vector3<Real>& P,
                 Rows<Real>& rows) {
    rows.clear();
    for (const Sight& sight : target.sights) {
        if (!sight.has[1]) continue;  // no direction, no linear equation
        const Place<Real>& place = places[sight.sensor];
        const Vector3<Real> from = place.o - P;
        const Real elevation = sight.has[2] ? Real(x[sight.input[2]]) : Real(0.0);
        const ReadDirections<Real> e(azimuth_of<Real>(sight, x), elevation);
        if (sight.has[0] && sight.has[2]) {
            const Vector3<Real> a = place.R * e.r;
            rows.add(a, Real(a.dot(from) + Real(x[sight.input[0]])));
        }
        const Vector3<Real> a = place.R * e.azimuth;
        rows.add(a, Real(a.dot(from) + across_of<Real>(sight, x)));
        if (sight.has[2]) {
            const Vector3<Real> b = place.R * e.elevation;
            rows.add(b, b.dot(from));
        }
    }
}

/// Weights of the linear equations at the point X, from the readings alone (Eq 2).
template <class Real>
void weigh_linear(const Target& target, const Place<Real>* places, const Vector3<Real>& X, Rows<Real>& rows) {
    using namespace real_functions;
    std::size_t row = 0;
    for (const Sight& sight : target.sights) {
        if (!sight.has[1]) continue;
        const Place<Real>& place = places[sight.sensor];
        const Vector3<Real> v = place.R.transpose() * (X - place.o);
        const Real rho = sqrt(Real(v[0] * v[0] + v[1] * v[1])), distance = sqrt(Real(v.dot(v)));
        if (sight.has[0] && sight.has[2]) rows.scale(row++, Real(1.0 / sight.u[0]));
        rows.scale(row++, sight.overhead ? Real(1.0 / sight.u[1]) : Real(Real(1.0 / sight.u[1]) / rho));
        if (sight.has[2]) rows.scale(row++, Real(Real(1.0 / sight.u[2]) / distance));
    }
}

/// Eqs 3 and 4: ordinary, then generalised least squares.
template <class Real, class In>
Vector3<Real> linear_estimate(const Target& target, const Place<Real>* places, const In& x, bool generalised,
                              Rows<Real>& rows) {
    const Vector3<Real> P = target.nominal.cast<Real>();
    linear_rows(target, places, x, P, rows);
    const Vector3<Real> ordinary = P + rows.solve();
    if (!generalised) return ordinary;
    weigh_linear(target, places, ordinary, rows);
    return P + rows.solve();
}

/// Residuals of the readings at X and their derivatives by X, weighted; one row each.
template <class Real, class In>
void reading_rows(const Target& target, const Place<Real>* places, const In& x, const ReadAngles<Real>* read,
                  const Vector3<Real>& X, Rows<Real>& rows) {
    rows.clear();
    for (const Sight& sight : target.sights) {
        const Place<Real>& place = places[sight.sensor];
        const View<Real> view(place, X);
        for (std::size_t i = 0; i < 3; ++i) {
            if (!sight.has[i]) continue;
            rows.add(gradient<Real>(sight, i, place, view, *read), residual<Real>(sight, i, view, x, *read));
            rows.scale(rows.size() - 1, Real(1.0 / sight.u[i]));
        }
        ++read;
    }
}

inline constexpr int most_steps = 20;

/// Gauss-Newton method from X on; a lane that has converged stays as it is, whatever the others do.
/// Derivatives (Dual) follow in some more steps.
template <class Real, class In>
mask_of<Real> refine(const Target& target, const Place<Real>* places, const In& x, Vector3<Real>& X,
                     Rows<Real>& rows) {
    using namespace real_functions;
    constexpr bool with_derivatives = std::is_same_v<Real, Dual>;
    std::array<ReadAngles<Real>, most_rows> read;
    for (std::size_t i = 0; i < target.sights.size(); ++i) read[i] = ReadAngles<Real>(target.sights[i], x);
    mask_of<Real> done(false);
    for (int k = 0; k < most_steps; ++k) {
        reading_rows(target, places, x, read.data(), X, rows);
        const Vector3<Real> step = rows.solve();
        for (int c = 0; c < 3; ++c)
            X[c] = with_derivatives ? Real(X[c] + step[c]) : Real(select(done, X[c], Real(X[c] + step[c])));
        done = done || (step.dot(step) < Real(last_step * last_step));
        if (all(done) && (!with_derivatives || k >= 7)) break;
    }
    return done;
}

template <class Real, class In>
Vector3<Real> start_of(const Target& target, const Place<Real>* places, const In& x, Rows<Real>& rows) {
    if (!target.has_linear_start) return target.nominal.template cast<Real>();
    return linear_estimate(target, places, x, true, rows);
}

/// Estimates one target by itself; false where the search does not settle.
template <class Real, class In>
mask_of<Real> estimate(const NetworkSetup& setup, const Target& target, const Place<Real>* places,
                       const In& x, Vector3<Real>& X) {
    Rows<Real> rows;
    if (setup.estimator != Estimator::nonlinear) {
        X = linear_estimate(target, places, x, setup.estimator == Estimator::linear, rows);
        return mask_of<Real>(true);
    }
    const Vector3<Real> start = start_of(target, places, x, rows);
    X = start;
    const mask_of<Real> done = refine(target, places, x, X, rows);
    const Part part{&setup, &target, 1, {}, target.inverse_normal.data(), nullptr, 0};
    return search_rest<Real>(part, places, x, &start, done, &X);
}

inline Part part_of(const NetworkSetup& setup, const JointSetUp& joint) {
    return {&setup,     &setup.targets[joint.first], joint.targets,
            joint.bars, joint.inverse_normal.data(), &joint,
            joint.first};
}

/// Steps X += (J₀ᵀWJ₀)⁻¹ JᵀW r with J₀ at the estimates, until X stays, which is where the weighted sum of
/// squares is least; at most so many. A lane that has converged stays as it is, whatever the others do.
template <class Real, class In>
mask_of<Real> settle(Linearised<Real>& at, const Part& part, const Place<Real>* places, const In& x, int most,
                     mask_of<Real> done, Vector3<Real>* X) {
    using namespace real_functions;
    constexpr bool with_derivatives = std::is_same_v<Real, Dual>;
    std::array<Real, 3 * most_joint_targets> descent;
    for (int k = 0; k < most; ++k) {
        at.take(part, places, x, X);
        at.weigh(part);
        at.transpose(part, at.weighted.data(), descent.data());
        const double* inverse = part.inverse_normal;
        Real step2(0.0);
        for (std::size_t t = 0; t < part.count; ++t)
            for (int c = 0; c < 3; ++c) {
                Real step(0.0);
                for (std::size_t i = 0; i < part.unknowns(); ++i) step += Real(*inverse++) * descent[i];
                step2 += step * step;
                const Real moved = X[t][c] + step;
                X[t][c] = with_derivatives ? moved : Real(select(done, X[t][c], moved));
            }
        done = done || (step2 < Real(last_step * last_step));
        if (all(done) && (!with_derivatives || k >= 7)) break;
    }
    return done;
}

/// Targets and stations of one trial together, from where they are at the estimates on: steps with the
/// linearisation found there, which end where the sum of squares of readings and of what is stated of the
/// stations is least.
template <class Real, class In>
class Finding {
public:
    Finding(const NetworkSetup& setup, const JointSetUp& joint, const In& x)
        : setup_(setup), joint_(joint), part_(part_of(setup, joint)), x_(x) {
        at_.read(part_, x);
        for (std::size_t s = 0; s < setup.sensors.size(); ++s)
            for (std::size_t i = 0; i < 6; ++i) {
                const double found =
                    setup.found.empty() ? 0.0 : setup.found[joint.index * setup.sensors.size() + s].moved[i];
                moved_[s][i] = Real(setup.sensors[s]->station().coordinates[i] + found) -
                               Real(x[setup.station_input(joint.index, s) + i]);
            }
    }

    mask_of<Real> run(Vector3<Real>* X) {
        using namespace real_functions;
        constexpr bool with_derivatives = std::is_same_v<Real, Dual>;
        constexpr int most = 60;
        mask_of<Real> done(false);
        for (std::size_t t = 0; t < part_.count; ++t) X[t] = part_.targets[t].nominal.template cast<Real>();
        for (int k = 0; k < most; ++k) {
            linearise(X);
            const Real change2 = move_targets(done, X) + move_stations(done);
            done = done || (change2 < Real(last_step * last_step));
            if (all(done) && (!with_derivatives || k >= 7)) break;
        }
        return done;
    }

private:
    void linearise(const Vector3<Real>* X) {
        for (std::size_t s = 0; s < setup_.sensors.size(); ++s)
            places_[s] = place_of<Real>(setup_, x_, joint_.index, s, moved_[s].data());
        std::size_t row = 0;
        for (std::size_t t = 0; t < part_.count; ++t)
            for (const Sight& sight : part_.targets[t].sights)
                for (const bool has : sight.has)
                    if (has) {
                        const std::array<double, 6>& by = joint_.by_station[row];
                        Real sum(0.0);
                        for (std::size_t i = 0; i < 6; ++i) sum += Real(by[i]) * moved_[sight.sensor][i];
                        raised_[row++] = sum;
                    }
        at_.take(part_, places_.data(), x_, X, raised_.data());
        at_.weigh_together(part_, at_.residuals.data(), at_.weighted.data(), shared_.data());
    }

    template <class Value>
    static Value taken(const mask_of<Real>& done, const Value& before, const Value& after) {
        using namespace real_functions;
        if constexpr (std::is_same_v<Real, Dual>) return after;
        return Value(select(done, before, after));
    }

    /// Moves the targets by one step; returns the square of its length.
    Real move_targets(const mask_of<Real>& done, Vector3<Real>* X) {
        std::array<Real, 3 * most_joint_targets> descent;
        at_.transpose(part_, at_.weighted.data(), descent.data());
        const double* inverse = part_.inverse_normal;
        Real square(0.0);
        for (std::size_t t = 0; t < part_.count; ++t)
            for (int c = 0; c < 3; ++c) {
                Real step(0.0);
                for (std::size_t i = 0; i < part_.unknowns(); ++i) step += Real(*inverse++) * descent[i];
                square += step * step;
                X[t][c] = taken<Real>(done, X[t][c], Real(X[t][c] + step));
            }
        return square;
    }

    Real move_stations(const mask_of<Real>& done) {
        std::array<std::array<Real, 6>, most_sensors> moved;
        for (std::size_t s = 0; s < setup_.sensors.size(); ++s) moved[s].fill(Real(0.0));
        for (std::size_t k = 0; k < joint_.moves.size(); ++k)
            for (std::size_t i = 0; i < 6; ++i)
                moved[joint_.moves[k].sensor][i] += Real(joint_.moves[k].by[i]) * shared_[k];
        Real square(0.0);
        for (std::size_t s = 0; s < setup_.sensors.size(); ++s)
            for (std::size_t i = 0; i < 6; ++i) {
                const Real change = moved[s][i] - moved_[s][i];
                square += change * change;
                moved_[s][i] = taken<Real>(done, moved_[s][i], moved[s][i]);
            }
        return square;
    }

    const NetworkSetup& setup_;
    const JointSetUp& joint_;
    const Part part_;
    const In& x_;
    Linearised<Real> at_;
    std::array<Place<Real>, most_sensors> places_;
    std::array<std::array<Real, 6>, most_sensors> moved_;  ///< their change since they were drawn
    std::array<Real, most_joint_rows> raised_;
    std::array<Real, most_shared> shared_;
};

/// Estimates all targets of a set-up together, X[t] for target first + t: from the estimates on, which are
/// near; where that does not settle soon, from the linear estimates.
template <class Real, class In>
mask_of<Real> estimate_jointly(const NetworkSetup& setup, const JointSetUp& joint, const Place<Real>* places,
                               const In& x, Vector3<Real>* X) {
    using namespace real_functions;
    if (joint.finds_stations()) return Finding<Real, In>(setup, joint, x).run(X);
    constexpr int soon = std::is_same_v<Real, Dual> ? most_steps : 6;
    const Part part = part_of(setup, joint);
    Linearised<Real> at;
    at.read(part, x);
    for (std::size_t t = 0; t < part.count; ++t) X[t] = part.targets[t].nominal.template cast<Real>();
    const mask_of<Real> near = settle(at, part, places, x, soon, mask_of<Real>(false), X);
    if (std::is_same_v<Real, Dual> || all(near)) return near;
    std::array<Vector3<Real>, most_joint_targets> start;
    Rows<Real> rows;
    for (std::size_t t = 0; t < part.count; ++t) {
        start[t] = start_of(part.targets[t], places, x, rows);
        for (int c = 0; c < 3; ++c) X[t][c] = select(near, X[t][c], start[t][c]);
    }
    const mask_of<Real> done = settle(at, part, places, x, most_steps, near, X);
    return search_rest<Real>(part, places, x, start.data(), done, X);
}

/// Distances, angles and frames of targets, and differences of distances from calibrated lengths, from output
/// `out` on. `target(t)` gives a position.
template <class Real, class In, class Out, class Target>
class Derived {
public:
    Derived(const NetworkSetup& setup, const In& x, const Target& target, Out& y)
        : setup_(setup), x_(x), target_(target), y_(y) {}

    void put_all(std::size_t out) {
        for (const Distance& distance : setup_.distances) put(distance, out++);
        for (const Angle& angle : setup_.angles) put(angle, out++);
        for (const TargetFrame& frame : setup_.frames) {
            put(frame, out);
            out += 6;
        }
        for (const ScaleBar& bar : setup_.bars) put(bar, out++);
    }

    void put(const Distance& distance, std::size_t out) { y_.set(out, length(distance.from, distance.to)); }

    void put(const Angle& angle, std::size_t out) {
        using namespace real_functions;
        const Vector3<Real> at = target_(angle.at);
        const Vector3<Real> a = target_(angle.from) - at, b = target_(angle.to) - at;
        const Vector3<Real> n = a.cross(b);
        y_.set(out, atan2(sqrt(Real(n.dot(n))), Real(a.dot(b))));
    }

    void put(const TargetFrame& frame, std::size_t out) {
        const Vector3<Real> origin = target_(frame.targets[0]);
        const Matrix3<Real> R = axes_3_2_1<Real>(origin, target_(frame.targets[1]), target_(frame.targets[2]),
                                                 ThirdPoint::positive_y);
        const Vector3<Real> angles = zyx_from_rotation(R);
        for (int c = 0; c < 3; ++c) y_.set(out++, origin[c]);
        for (int c = 0; c < 3; ++c) y_.set(out++, angles[c]);
    }

    void put(const ScaleBar& bar, std::size_t out) {
        y_.set(out, length(bar.from, bar.to) - Real(x_[bar.input]));
    }

private:
    Real length(std::size_t from, std::size_t to) const {
        using namespace real_functions;
        const Vector3<Real> d = target_(to) - target_(from);
        return sqrt(Real(d.dot(d)));
    }

    const NetworkSetup& setup_;
    const In& x_;
    const Target& target_;
    Out& y_;
};

template <class Real, class In>
void locate_stations(const NetworkSetup& setup, const In& x, std::size_t set_up, Place<Real>* places) {
    for (std::size_t s = 0; s < setup.sensors.size(); ++s) places[s] = place_of<Real>(setup, x, set_up, s);
}

/// Targets first ... first + count - 1 of a set-up, all of those estimated together; sets their coordinates.
template <class Real, class In, class Out>
mask_of<Real> some_targets(const NetworkSetup& setup, const JointSetUp& joint, std::size_t first,
                           std::size_t count, const Place<Real>* places, const In& x, Out& y) {
    std::array<Vector3<Real>, most_joint_targets> X;
    mask_of<Real> valid(true);
    const bool together = joint.together();
    if (together) valid = estimate_jointly(setup, joint, places, x, X.data());
    for (std::size_t t = 0; t < count; ++t) {
        if (!together) valid = valid && estimate(setup, setup.targets[first + t], places, x, X[0]);
        const Vector3<Real>& found = together ? X[t] : X[0];
        for (int c = 0; c < 3; ++c) y.set(3 * (first + t) + static_cast<std::size_t>(c), found[c]);
    }
    return valid;
}

/// Computes all targets of a trial, then what derives from them. Inputs: six coordinates of every station for
/// each set-up, readings target by target, calibrated lengths. Outputs: x, y, z of every target, distances,
/// angles, frames, differences from the calibrated lengths.
template <class Real, class In, class Out>
mask_of<Real> all_targets(const NetworkSetup& setup, const In& x, Out& y) {
    std::array<Place<Real>, most_sensors> places;
    mask_of<Real> valid(true);
    std::size_t located = setup.stations;
    for (const JointSetUp& joint : setup.set_ups) {
        if (located != joint.index) locate_stations(setup, x, joint.index, places.data());
        located = joint.index;
        valid = valid && some_targets(setup, joint, joint.first, joint.targets, places.data(), x, y);
    }
    const auto target = [&](std::size_t t) {
        Vector3<Real> p;
        for (int c = 0; c < 3; ++c) p[c] = y.get(3 * t + static_cast<std::size_t>(c));
        return p;
    };
    Derived<Real, In, Out, decltype(target)>(setup, x, target, y).put_all(3 * setup.targets.size());
    return valid;
}

}  // namespace covaria::network
